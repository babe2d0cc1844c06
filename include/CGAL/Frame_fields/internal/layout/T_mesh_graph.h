// Copyright (c) 2026 The Frame_fields authors.
// All rights reserved.
//
// This file is part of Frame_fields, a package in the form of CGAL's (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Frame_fields authors

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_GRAPH_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_GRAPH_H

#include <CGAL/Frame_fields/internal/layout/Motorcycle_graph.h>
#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh_nodes.h>
#include <CGAL/Frame_fields/internal/layout/Trace.h>
#include <CGAL/Frame_fields/internal/parameterization/quarter_turns_of_sector.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The pieces of a T-mesh, and the slots by which they leave its nodes. A node has a slot for each quarter turn,
// counter-clockwise. At a node on the border, slot 0 runs along the border halfedge that leaves the node, and the last
// slot along the border halfedge that comes to it.
class T_mesh_graph
{
public:
  T_mesh_graph(const Seamless_charts& charts, const Patch& patch, const std::vector<int>& index,
               const T_mesh_nodes& nodes)
    : m_charts(charts), m_surface(charts.surface()), m_patch(patch), m_nodes(nodes), m_first_slot(1, 0)
  {
    for(int node = 0; node < static_cast<int>(nodes.nodes().size()); ++node)
    {
      const T_mesh_node& n = nodes.nodes()[node];
      const int quads = n.sector >= 0 ? quarter_turns_of_sector(m_surface, index, n.sector) : n.halfedge >= 0 ? 2 : 4;
      m_first_slot.push_back(m_first_slot.back() + quads + (nodes.is_on_border(node) ? 1 : 0));
    }
    m_directed_piece.assign(m_first_slot.back(), -1);
  }

  // Returns false if two pieces overlap, or one has no length.
  bool build(const Motorcycle_graph& motorcycles)
  {
    add_pieces_of_traces(motorcycles);
    std::vector<char> is_visited(3 * static_cast<std::size_t>(m_patch.faces.size()), 0);
    for(int halfedge = 3 * m_patch.faces.begin_index; halfedge < 3 * m_patch.faces.end_index; ++halfedge)
      if(m_surface.is_constrained(halfedge) && !is_visited[halfedge - 3 * m_patch.faces.begin_index])
        add_pieces_of_loop(halfedge, is_visited);
    return m_is_valid;
  }

  const std::vector<T_mesh_piece>& pieces() const { return m_pieces; }
  const T_mesh_nodes& nodes() const { return m_nodes; }
  int number_of_slots(const int node) const { return m_first_slot[node + 1] - m_first_slot[node]; }

  // Twice the number of the piece that leaves by a slot, plus 1 if it is passed in reverse; -1 if there is none.
  int directed_piece(const int node, const int slot) const { return m_directed_piece[m_first_slot[node] + slot]; }

  // The slot by which a piece leaves its source, or its target in reverse.
  int slot(const int directed_piece) const { return m_slot[directed_piece]; }

  int source(const int directed_piece) const
  {
    const T_mesh_piece& piece = m_pieces[directed_piece / 2];
    return directed_piece % 2 == 0 ? piece.source : piece.target;
  }

private:
  // What is left of a trace behind its last node, up to where it meets another one.
  struct Rest
  {
    int node, slot;
    std::int64_t double_length_of_map;
    double length;
  };

  void add_piece(const T_mesh_piece& piece, const int slot_at_source, const int slot_at_target)
  {
    const int number = static_cast<int>(m_pieces.size());
    m_pieces.push_back(piece);
    m_slot.push_back(slot_at_source);
    m_slot.push_back(slot_at_target);
    occupy(piece.source, slot_at_source, 2 * number);
    occupy(piece.target, slot_at_target, 2 * number + 1);
    m_is_valid = m_is_valid && piece.parametric_length > 0;
  }

  void occupy(const int node, const int slot, const int directed_piece)
  {
    if(slot < 0 || slot >= number_of_slots(node) || m_directed_piece[m_first_slot[node] + slot] >= 0)
      m_is_valid = false;
    else
      m_directed_piece[m_first_slot[node] + slot] = directed_piece;
  }

  void add_pieces_of_traces(const Motorcycle_graph& motorcycles)
  {
    const std::vector<Trace_stop>& stops = m_nodes.trace_stops();
    std::vector<Rest> rests;
    std::size_t first = 0, last = 0;
    for(; last < stops.size(); ++last)
      if(last + 1 == stops.size() || stops[last + 1].trace != stops[first].trace)
      {
        rests.push_back(add_pieces_of_trace(motorcycles, first, last));
        first = last + 1;
      }
    for(int trace = 0; trace < static_cast<int>(rests.size()); ++trace)
    {
      const Trace& t = motorcycles.traces()[trace];
      if(t.end == Trace::MEETS_TRACE && t.partner > trace)
        join(rests[trace], rests[t.partner]);
    }
  }

  Rest add_pieces_of_trace(const Motorcycle_graph& motorcycles, const std::size_t first, const std::size_t last)
  {
    const std::vector<Trace_stop>& stops = m_nodes.trace_stops();
    const Trace& trace = motorcycles.traces()[stops[first].trace];
    int segment = trace.first_segment;
    double time = 0;
    const auto length_until = [&](const std::int64_t double_time)
    {
      return length_of_part(motorcycles.segments(), static_cast<double>(double_time) / 2, time, segment);
    };
    for(std::size_t i = first; i < last; ++i)
    {
      const Trace_stop &from = stops[i], &to = stops[i + 1];
      add_piece({ from.node, to.node, (to.double_time - from.double_time) / 2, length_until(to.double_time), -1 },
                from.slot, to.slot_of_return);
    }
    return { stops[last].node, stops[last].slot, trace.double_time_of_end - stops[last].double_time,
             length_until(trace.double_time_of_end) };
  }

  // The length in space of a trace between two times. `time` is the first time and becomes `end`; `segment` is the
  // segment of the trace at the first time and becomes the segment at `end`.
  double length_of_part(const std::vector<Trace_segment>& segments, const double end, double& time,
                        int& segment) const
  {
    double length = 0;
    while(segment >= 0 && time < end)
    {
      const Trace_segment& s = segments[segment];
      const double next_time = (std::min)(end, s.time_of_exit);
      if(next_time > time)
      {
        length += (next_time - time) * m_charts.length_of_unit(s.face, s.ray.direction);
        time = next_time;
      }
      if(s.time_of_exit <= end)
        segment = s.next_in_trace;
    }
    return length;
  }

  // Two traces that meet are one line. Nothing is left of them if there is a node where they meet.
  void join(const Rest& a, const Rest& b)
  {
    const std::int64_t double_length = a.double_length_of_map + b.double_length_of_map;
    if(double_length > 0)
      add_piece({ a.node, b.node, double_length / 2, a.length + b.length, -1 }, a.slot, b.slot);
  }

  // Goes around a border loop: first to a node, and from there once around, back to this node.
  void add_pieces_of_loop(const int first_halfedge, std::vector<char>& is_visited)
  {
    T_mesh_piece piece = { -1, -1, 0, 0, -1 };
    int first_node = -1, halfedge = first_halfedge;
    bool is_done = false;
    const auto stop_at = [&](const int node, const int next_halfedge)
    {
      piece.target = node;
      if(first_node < 0)
        first_node = node;
      else if(!is_done)
      {
        add_piece(piece, 0, number_of_slots(node) - 1);
        is_done = node == first_node;
      }
      piece = { node, -1, 0, 0, next_halfedge };
    };
    for(int round = 0; round < 2; ++round)
      do
      {
        is_visited[halfedge - 3 * m_patch.faces.begin_index] = 1;
        const int next_halfedge = next_of(m_surface.first_corner[m_surface.sector[halfedge]]);
        const std::int64_t length = along(m_charts.direction_of(halfedge), m_charts.edge(halfedge));
        std::int64_t passed = 0;
        const auto pass = [&](const std::int64_t distance)
        {
          const double share = static_cast<double>(distance - passed) / static_cast<double>(length);
          piece.parametric_length += distance - passed;
          piece.length += share * m_surface.length[halfedge];
          passed = distance;
        };
        m_nodes.for_each_border_stop(halfedge, [&](const Border_stop& stop)
        {
          pass(stop.distance);
          stop_at(stop.node, halfedge);
        });
        pass(length);
        const int node = m_nodes.node_of_sector(m_surface.sector[halfedge]);
        if(node >= 0)
          stop_at(node, next_halfedge);
        halfedge = next_halfedge;
      } while(halfedge != first_halfedge && !is_done);
    m_is_valid = m_is_valid && is_done;
  }

  const Seamless_charts& m_charts;
  const Cut_surface& m_surface;
  const Patch& m_patch;
  const T_mesh_nodes& m_nodes;
  std::vector<T_mesh_piece> m_pieces;
  std::vector<int> m_first_slot;     // per node, and behind the last one
  std::vector<int> m_directed_piece; // per slot
  std::vector<int> m_slot;           // per directed piece
  bool m_is_valid = true;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_GRAPH_H
