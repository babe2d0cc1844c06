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
#include <CGAL/Frame_fields/internal/layout/Trace.h>
#include <CGAL/Frame_fields/internal/parameterization/quarter_turns_of_sector.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The nodes and pieces of a T-mesh, and the pieces around each node. The pieces leave a node by its slots, one for each
// quarter turn: counter-clockwise, on the border from its halfedge that leaves the node, the slot 0, to the one that
// comes to it.
class T_mesh_graph
{
public:
  // A sector with `is_node` is a node in any case.
  T_mesh_graph(const Seamless_charts& charts, const Patch& patch, const std::vector<int>& index,
               const Motorcycle_graph& motorcycles)
    : m_charts(charts), m_surface(charts.surface()), m_patch(patch), m_index(index), m_motorcycles(motorcycles)
    , m_node_of_sector(patch.sectors.size(), -1) {}

  // Returns whether no two pieces overlap.
  bool build(const std::vector<char>& is_node)
  {
    for(int sector = m_patch.sectors.begin_index; sector < m_patch.sectors.end_index; ++sector)
      if(is_node[sector - m_patch.sectors.begin_index])
        node_of_sector(sector);
    collect_stops();
    collect_border_loops();
    number_slots();
    add_pieces_of_traces();
    add_pieces_of_border();
    return m_is_valid;
  }

  T_mesh& mesh() { return m_mesh; }
  const T_mesh_location& location(const int node) const { return m_locations[node]; }
  int number_of_slots(const int node) const { return m_first_slot[node + 1] - m_first_slot[node]; }
  bool is_on_border(const int node) const
  {
    const T_mesh_location& l = m_locations[node];
    return l.sector >= 0 ? m_surface.is_constrained_sector(l.sector) : l.halfedge >= 0;
  }

  // Twice the number of the piece that leaves by a slot, plus 1 if it is passed in reverse; -1 if there is none.
  int directed_piece(const int node, const int slot) const { return m_directed_piece[m_first_slot[node] + slot]; }

  // The slot by which a piece leaves its source, or its target in reverse.
  int slot(const int directed_piece) const { return m_slot[directed_piece]; }

  int source(const int directed_piece) const
  {
    const T_mesh_piece& piece = m_mesh.pieces[directed_piece / 2];
    return directed_piece % 2 == 0 ? piece.source : piece.target;
  }

private:
  // A node that a trace passes.
  struct Stop
  {
    int trace;
    std::int64_t double_time;
    int node;
    int slot;           // of the piece ahead
    int slot_of_return;
  };

  // What is left of a trace behind its last node, up to where it meets another one.
  struct Rest
  {
    int node, slot;
    std::int64_t double_time;
    double length;
  };

  int add_node(const T_mesh_location& location)
  {
    m_locations.push_back(location);
    m_mesh.nodes.push_back({ location.face, location.point.u, location.point.v, location.sector, location.halfedge });
    return static_cast<int>(m_locations.size()) - 1;
  }

  int node_of_sector(const int sector)
  {
    int& node = m_node_of_sector[sector - m_patch.sectors.begin_index];
    const int corner = m_surface.first_corner[sector];
    if(node < 0)
      node = add_node({ sector, -1, face_of(corner), m_charts.point(corner) });
    return node;
  }

  void collect_stops()
  {
    const std::vector<Trace>& traces = m_motorcycles.traces();
    std::vector<T_mesh_location> locations;
    const auto add = [&](const T_mesh_location& location, const Stop& stop)
    {
      locations.push_back(location);
      m_stops.push_back(stop);
    };
    for(std::size_t t = 0; t < traces.size(); ++t)
    {
      const Trace& trace = traces[t];
      add(trace.start, { static_cast<int>(t), 0, -1, trace.start_slot, -1 });
      if(trace.end == Trace::ON_BORDER)
        add(trace.end_on_border, { static_cast<int>(t), trace.double_time_of_end, -1, -1, 1 });
      else if(trace.end == Trace::OPEN)
        m_is_valid = false;
    }
    for(const Trace_passing& passing : m_motorcycles.passings())
      add(passing.location, { passing.trace, 2 * passing.time, -1, passing.slot, (passing.slot + 2) & 3 });
    find_nodes_of_stops(locations);

    const auto key = [](const Stop& s) { return std::make_tuple(s.trace, s.double_time, s.node); };
    std::sort(m_stops.begin(), m_stops.end(), [&](const Stop& a, const Stop& b) { return key(a) < key(b); });
    m_stops.erase(std::unique(m_stops.begin(), m_stops.end(),
                              [&](const Stop& a, const Stop& b) { return key(a) == key(b); }), m_stops.end());
  }

  void find_nodes_of_stops(const std::vector<T_mesh_location>& locations)
  {
    const auto key = [&](const int i)
    {
      const T_mesh_location& l = locations[i];
      return std::make_tuple(l.halfedge, l.face, l.point.u, l.point.v);
    };
    std::vector<int> order;
    for(int i = 0; i < static_cast<int>(locations.size()); ++i)
    {
      if(locations[i].sector >= 0)
        m_stops[i].node = node_of_sector(locations[i].sector);
      else
        order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](const int i, const int j) { return key(i) < key(j); });
    for(std::size_t k = 0; k < order.size(); ++k)
    {
      const int i = order[k];
      m_stops[i].node = k > 0 && key(order[k - 1]) == key(i) ? m_stops[order[k - 1]].node : add_node(locations[i]);
    }
  }

  // A loop without node gets one.
  void collect_border_loops()
  {
    const int begin = 3 * m_patch.faces.begin_index, end = 3 * m_patch.faces.end_index;
    for(int node = 0; node < static_cast<int>(m_locations.size()); ++node)
      if(m_locations[node].sector < 0 && m_locations[node].halfedge >= 0)
        m_nodes_on_border.push_back({ m_locations[node].halfedge, distance_from_source(node), node });
    std::sort(m_nodes_on_border.begin(), m_nodes_on_border.end());
    m_first_on_halfedge.assign(end - begin, static_cast<int>(m_nodes_on_border.size()));
    for(int i = static_cast<int>(m_nodes_on_border.size()) - 1; i >= 0; --i)
      m_first_on_halfedge[std::get<0>(m_nodes_on_border[i]) - begin] = i;

    std::vector<char> is_visited(end - begin, 0);
    for(int first = begin; first < end; ++first)
    {
      if(!m_surface.is_constrained(first) || is_visited[first - begin])
        continue;
      m_loop_begin.push_back(static_cast<int>(m_loops.size()));
      bool has_node = false;
      for(int halfedge = first; !is_visited[halfedge - begin]; halfedge = next_on_border(halfedge))
      {
        is_visited[halfedge - begin] = 1;
        m_loops.push_back(halfedge);
        has_node = has_node || m_node_of_sector[m_surface.sector[halfedge] - m_patch.sectors.begin_index] >= 0
                || has_node_inside(halfedge);
      }
      if(!has_node)
        node_of_sector(m_surface.sector[first]);
    }
    m_loop_begin.push_back(static_cast<int>(m_loops.size()));
  }

  int next_on_border(const int halfedge) const
  {
    return next_of(m_surface.first_corner[m_surface.sector[halfedge]]);
  }

  bool has_node_inside(const int halfedge) const
  {
    const int i = m_first_on_halfedge[halfedge - 3 * m_patch.faces.begin_index];
    return i < static_cast<int>(m_nodes_on_border.size()) && std::get<0>(m_nodes_on_border[i]) == halfedge;
  }

  std::int64_t distance_from_source(const int node) const
  {
    const int halfedge = m_locations[node].halfedge;
    return along(m_charts.direction_of(halfedge), m_locations[node].point - m_charts.point(previous_of(halfedge)));
  }

  void number_slots()
  {
    m_first_slot.assign(1, 0);
    for(int node = 0; node < static_cast<int>(m_locations.size()); ++node)
    {
      const T_mesh_location& l = m_locations[node];
      const int quads = l.sector >= 0 ? quarter_turns_of_sector(m_surface, m_index, l.sector) : l.halfedge >= 0 ? 2 : 4;
      m_first_slot.push_back(m_first_slot.back() + (std::max)(quads, 0) + (is_on_border(node) ? 1 : 0));
    }
    m_directed_piece.assign(m_first_slot.back(), -1);
  }

  void add_piece(const T_mesh_piece& piece, const int slot_at_source, const int slot_at_target)
  {
    const int number = static_cast<int>(m_mesh.pieces.size());
    m_mesh.pieces.push_back(piece);
    m_slot.push_back(slot_at_source);
    m_slot.push_back(slot_at_target);
    occupy(piece.source, slot_at_source, 2 * number);
    occupy(piece.target, slot_at_target, 2 * number + 1);
    if(piece.parametric_length <= 0)
      m_is_valid = false;
  }

  void occupy(const int node, const int slot, const int directed_piece)
  {
    if(slot < 0 || slot >= number_of_slots(node) || m_directed_piece[m_first_slot[node] + slot] >= 0)
      m_is_valid = false;
    else
      m_directed_piece[m_first_slot[node] + slot] = directed_piece;
  }

  void add_pieces_of_traces()
  {
    std::vector<Rest> rests;
    std::size_t stop = 0;
    for(int trace = 0; trace < static_cast<int>(m_motorcycles.traces().size()); ++trace)
    {
      const std::size_t begin = stop;
      while(stop < m_stops.size() && m_stops[stop].trace == trace)
        ++stop;
      rests.push_back(add_pieces_of_trace(begin, stop));
    }
    for(std::size_t trace = 0; trace < rests.size(); ++trace)
    {
      const int partner = m_motorcycles.traces()[trace].partner;
      if(m_motorcycles.traces()[trace].end == Trace::MEETS_TRACE && partner > static_cast<int>(trace))
        join(rests[trace], rests[partner]);
    }
  }

  Rest add_pieces_of_trace(const std::size_t begin, const std::size_t end)
  {
    const Trace& trace = m_motorcycles.traces()[m_stops[begin].trace];
    int segment = trace.first_segment;
    double time = 0;
    for(std::size_t i = begin; i + 1 < end; ++i)
    {
      const Stop &from = m_stops[i], &to = m_stops[i + 1];
      const double length = length_until(static_cast<double>(to.double_time) / 2, time, segment);
      const std::int64_t parametric_length = (to.double_time - from.double_time) / 2;
      add_piece({ from.node, to.node, parametric_length, length, -1 }, from.slot, to.slot_of_return);
    }
    const Stop& last = m_stops[end - 1];
    return { last.node, last.slot, trace.double_time_of_end - last.double_time,
             length_until(static_cast<double>(trace.double_time_of_end) / 2, time, segment) };
  }

  // The length in space of a trace from a time to another one; changes `time` to that, and `segment` to that of it.
  double length_until(const double end, double& time, int& segment) const
  {
    double length = 0;
    while(segment >= 0 && time < end)
    {
      const Trace_segment& s = m_motorcycles.segments()[segment];
      const double time_of_exit = (std::min)(end, s.time_of_exit);
      if(time_of_exit > time)
      {
        length += (time_of_exit - time) * m_charts.length_of_unit(s.face, s.ray.direction);
        time = time_of_exit;
      }
      if(s.time_of_exit <= end)
        segment = s.next_in_trace;
    }
    return length;
  }

  // Two traces that meet are one line. They have nothing to add if there is a node where they meet.
  void join(const Rest& a, const Rest& b)
  {
    if(a.double_time > 0 || b.double_time > 0)
      add_piece({ a.node, b.node, (a.double_time + b.double_time) / 2, a.length + b.length, -1 }, a.slot, b.slot);
  }

  void add_pieces_of_border()
  {
    for(std::size_t loop = 0; loop + 1 < m_loop_begin.size(); ++loop)
      add_pieces_of_loop(m_loop_begin[loop], m_loop_begin[loop + 1]);
  }

  // Goes round the loop to its first node, and once more back to it.
  void add_pieces_of_loop(const int begin, const int end)
  {
    T_mesh_piece piece = { -1, -1, 0, 0, -1 };
    int first_node = -1;
    bool is_done = false;
    const auto stop_at = [&](const int node, const int halfedge)
    {
      piece.target = node;
      if(piece.source >= 0)
        add_piece(piece, 0, number_of_slots(node) - 1);
      is_done = node == first_node;
      first_node = first_node < 0 ? node : first_node;
      piece = { node, -1, 0, 0, halfedge };
    };
    for(int k = 0; k < 2 * (end - begin) && !is_done; ++k)
    {
      const int halfedge = m_loops[begin + k % (end - begin)];
      const int direction = m_charts.direction_of(halfedge);
      if(direction < 0)
      {
        m_is_valid = false;
        return;
      }
      const std::int64_t length = along(direction, m_charts.edge(halfedge));
      std::int64_t passed = 0;
      const auto pass = [&](const std::int64_t distance)
      {
        piece.parametric_length += distance - passed;
        const double share = static_cast<double>(distance - passed) / static_cast<double>(length);
        piece.length += share * m_surface.length[halfedge];
        passed = distance;
      };
      if(has_node_inside(halfedge))
        for(std::size_t i = m_first_on_halfedge[halfedge - 3 * m_patch.faces.begin_index];
            i < m_nodes_on_border.size() && std::get<0>(m_nodes_on_border[i]) == halfedge && !is_done; ++i)
        {
          pass(std::get<1>(m_nodes_on_border[i]));
          stop_at(std::get<2>(m_nodes_on_border[i]), halfedge);
        }
      if(is_done)
        return;
      pass(length);
      const int node = m_node_of_sector[m_surface.sector[halfedge] - m_patch.sectors.begin_index];
      if(node >= 0)
        stop_at(node, next_on_border(halfedge));
    }
  }

  const Seamless_charts& m_charts;
  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<int>& m_index;
  const Motorcycle_graph& m_motorcycles;
  T_mesh m_mesh;
  std::vector<T_mesh_location> m_locations; // per node
  std::vector<int> m_node_of_sector;        // per sector of the patch
  std::vector<Stop> m_stops;                // sorted by traces and times
  std::vector<std::tuple<int, std::int64_t, int> > m_nodes_on_border; // halfedge, distance from its source, node
  std::vector<int> m_first_on_halfedge;     // per halfedge of the patch: its first entry in `m_nodes_on_border`
  std::vector<int> m_loops, m_loop_begin;   // the halfedges of the border loops, one loop after the other
  std::vector<int> m_first_slot;            // per node, and behind the last one
  std::vector<int> m_directed_piece;        // per slot
  std::vector<int> m_slot;                  // per directed piece
  bool m_is_valid = true;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_GRAPH_H
