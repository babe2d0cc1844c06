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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_NODES_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_NODES_H

#include <CGAL/Frame_fields/internal/layout/Motorcycle_graph.h>
#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/Trace.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A node on a trace. `slot` is the direction at the node of the piece of the trace ahead, `slot_of_return` that of the
// piece behind, seen from the node.
struct Trace_stop
{
  int trace;
  std::int64_t double_time;
  int node;
  int slot, slot_of_return; // -1 if there is no such piece
};

// A node inside a constrained halfedge.
struct Border_stop
{
  int halfedge;
  std::int64_t distance; // from the source of the halfedge
  int node;
};

// The nodes of a T-mesh: the given sectors and all points where traces end or cross, each of them once.
class T_mesh_nodes
{
public:
  T_mesh_nodes(const Seamless_charts& charts, const Patch& patch, const std::vector<char>& is_node,
               const Motorcycle_graph& motorcycles)
    : m_charts(charts), m_surface(charts.surface()), m_patch(patch), m_node_of_sector(patch.sectors.size(), -1)
  {
    for(int sector = patch.sectors.begin_index; sector < patch.sectors.end_index; ++sector)
      if(is_node[sector - patch.sectors.begin_index])
        add_sector(sector);
    collect_stops(motorcycles);
    collect_border_stops();
  }

  const std::vector<T_mesh_node>& nodes() const { return m_nodes; }
  const std::vector<Trace_stop>& trace_stops() const { return m_trace_stops; } // sorted by traces and times

  // -1 if the vertex of the sector is no node.
  int node_of_sector(const int sector) const { return m_node_of_sector[sector - m_patch.sectors.begin_index]; }

  bool is_on_border(const int node) const
  {
    const T_mesh_node& n = m_nodes[node];
    return n.sector >= 0 ? m_surface.is_constrained_sector(n.sector) : n.halfedge >= 0;
  }

  // Calls `visit(stop)` for the nodes inside a constrained halfedge, from its source to its target.
  template <typename Visit>
  void for_each_border_stop(const int halfedge, const Visit& visit) const
  {
    const int place = halfedge - 3 * m_patch.faces.begin_index;
    for(int i = m_first_border_stop[place]; i < m_first_border_stop[place + 1]; ++i)
      visit(m_border_stops[i]);
  }

private:
  int add_node(const T_mesh_location& l)
  {
    m_nodes.push_back({ l.face, l.point.u, l.point.v, l.sector, l.halfedge });
    return static_cast<int>(m_nodes.size()) - 1;
  }

  int add_sector(const int sector)
  {
    int& node = m_node_of_sector[sector - m_patch.sectors.begin_index];
    const int corner = m_surface.first_corner[sector];
    if(node < 0)
      node = add_node({ sector, -1, face_of(corner), m_charts.point(corner) });
    return node;
  }

  void collect_stops(const Motorcycle_graph& motorcycles)
  {
    for(int t = 0; t < static_cast<int>(motorcycles.traces().size()); ++t)
    {
      const Trace& trace = motorcycles.traces()[t];
      add_stop({ t, 0, -1, trace.start_slot, -1 }, { trace.start_sector, -1, -1, {} });
      if(trace.end == Trace::ON_BORDER)
        add_stop({ t, trace.double_time_of_end, -1, -1, 1 }, trace.end_on_border);
    }
    for(const Motorcycle_graph::Crossing& crossing : motorcycles.crossings())
    {
      const Trace_passing& passing = crossing.first;
      add_stop({ passing.trace, 2 * passing.time, -1, passing.slot, (passing.slot + 2) & 3 }, crossing.second);
    }
    add_nodes_of_stops();
  }

  void add_stop(const Trace_stop& stop, const T_mesh_location& location)
  {
    m_trace_stops.push_back(stop);
    m_locations.push_back(location);
  }

  static std::tuple<int, int, int, std::int64_t, std::int64_t> key_of(const T_mesh_location& l)
  {
    return std::make_tuple(l.sector, l.halfedge, l.sector < 0 ? l.face : -1, l.sector < 0 ? l.point.u : 0,
                           l.sector < 0 ? l.point.v : 0);
  }

  // Gives each location one node. The nodes are numbered along the traces, so that the numbers do not depend on the
  // charts.
  void add_nodes_of_stops()
  {
    const auto key_of_stop = [this](const int i)
    {
      return std::make_pair(m_trace_stops[i].trace, m_trace_stops[i].double_time);
    };
    std::vector<int> by_trace(m_trace_stops.size());
    std::iota(by_trace.begin(), by_trace.end(), 0);
    std::sort(by_trace.begin(), by_trace.end(),
              [&](const int i, const int j) { return key_of_stop(i) < key_of_stop(j); });
    std::vector<int> by_location = by_trace;
    std::stable_sort(by_location.begin(), by_location.end(),
                     [&](const int i, const int j) { return key_of(m_locations[i]) < key_of(m_locations[j]); });
    std::vector<int> first_at_location(m_trace_stops.size());
    for(std::size_t k = 0; k < by_location.size(); ++k)
    {
      const bool is_new = k == 0 || key_of(m_locations[by_location[k - 1]]) != key_of(m_locations[by_location[k]]);
      first_at_location[by_location[k]] = is_new ? by_location[k] : first_at_location[by_location[k - 1]];
    }

    std::vector<Trace_stop> sorted;
    for(const int i : by_trace)
    {
      Trace_stop& stop = m_trace_stops[i];
      const int first = first_at_location[i];
      const T_mesh_location& location = m_locations[i];
      stop.node = first != i ? m_trace_stops[first].node
                : location.sector >= 0 ? add_sector(location.sector) : add_node(location);
      if(sorted.empty() || sorted.back().trace != stop.trace || sorted.back().node != stop.node
         || sorted.back().double_time != stop.double_time) // a crossing may be found in several faces
        sorted.push_back(stop);
    }
    m_trace_stops.swap(sorted);
  }

  void collect_border_stops()
  {
    const int begin = 3 * m_patch.faces.begin_index;
    for(int node = 0; node < static_cast<int>(m_nodes.size()); ++node)
    {
      const int halfedge = m_nodes[node].halfedge;
      if(halfedge < 0)
        continue;
      const Grid_ray ray = { m_charts.direction_of(halfedge), m_charts.point(previous_of(halfedge)) };
      m_border_stops.push_back({ halfedge, ray.time({ m_nodes[node].u, m_nodes[node].v }), node });
    }
    std::sort(m_border_stops.begin(), m_border_stops.end(), [](const Border_stop& a, const Border_stop& b)
    {
      return std::make_tuple(a.halfedge, a.distance) < std::make_tuple(b.halfedge, b.distance);
    });
    m_first_border_stop.assign(3 * static_cast<std::size_t>(m_patch.faces.size()) + 1, 0);
    for(const Border_stop& stop : m_border_stops)
      ++m_first_border_stop[stop.halfedge - begin + 1];
    for(std::size_t i = 1; i < m_first_border_stop.size(); ++i)
      m_first_border_stop[i] += m_first_border_stop[i - 1];
  }

  const Seamless_charts& m_charts;
  const Cut_surface& m_surface;
  const Patch& m_patch;
  std::vector<T_mesh_node> m_nodes;
  std::vector<int> m_node_of_sector;     // per sector of the patch
  std::vector<Trace_stop> m_trace_stops;
  std::vector<T_mesh_location> m_locations; // per stop, in the order in which they were found
  std::vector<Border_stop> m_border_stops;
  std::vector<int> m_first_border_stop;  // per halfedge of the patch, and behind the last one
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_NODES_H
