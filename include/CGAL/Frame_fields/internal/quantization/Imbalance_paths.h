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


#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_IMBALANCE_PATHS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_IMBALANCE_PATHS_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Double_cover.h>
#include <CGAL/Frame_fields/internal/quantization/Search_front.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Makes the sums 0 at the few nodes where they are 1 or -1. Each such node is joined to the nearest other one, or to a
// free end, by a path along which the values change by 1. The length of a path is its cost, reduced by the potentials
// of the half-integral flow.
class Imbalance_paths
{
public:
  Imbalance_paths(const Bidirected_network& network, const Double_cover& graph, const std::vector<double>& potential,
                  std::vector<int>& value)
    : m_network(network), m_graph(graph), m_potential(potential), m_value(value), m_sum(network.number_of_nodes, 0)
    , m_front(graph.number_of_nodes()), m_change(network.edges.size(), 0), m_is_banned(graph.number_of_arcs(), 0)
  {
    for(std::size_t e = 0; e < network.edges.size(); ++e)
      add_to_sums(static_cast<int>(e), value[e]);
  }

  // Returns whether all sums are 0 afterward. A shortest path may pass an edge twice that may change only once; then
  // one arc of this edge is banned and the search is repeated.
  bool join()
  {
    const int maximum_number_of_trials = 4;
    for(int node = 0; node < m_network.number_of_nodes; ++node)
    {
      for(int trial = 0; trial < maximum_number_of_trials && (m_sum[node] == 1 || m_sum[node] == -1); ++trial)
        join(node);
      for(const int arc : m_banned_arcs)
        m_is_banned[arc] = 0;
      m_banned_arcs.clear();
    }
    return std::all_of(m_sum.begin(), m_sum.end(), [](const long long sum) { return sum == 0; });
  }

private:
  void add_to_sums(const int e, const int amount)
  {
    for(int end = 0; end < 2; ++end)
      if(m_network.edges[e].node[end] >= 0)
        m_sum[m_network.edges[e].node[end]] += static_cast<long long>(m_network.edges[e].sign[end]) * amount;
  }

  // A path that ends at the copy 2 n + 1 of a node n adds 1 to the sum of n; one that ends at 2 n subtracts 1.
  bool ends_at(const int copy) const
  {
    if(copy / 2 >= m_network.number_of_nodes)
      return true;
    return m_sum[copy / 2] == (copy % 2 == 0 ? 1 : -1);
  }

  void join(const int node)
  {
    const int start = 2 * node + (m_sum[node] > 0 ? 1 : 0);
    m_front.start(start);
    int end = -1;
    while(!m_front.is_empty() && end < 0)
    {
      const Search_front::Entry nearest = m_front.pop();
      if(nearest.node / 2 != node && ends_at(nearest.node))
        end = nearest.node;
      else if(!m_front.is_outdated(nearest))
        visit_neighbors(nearest.node, nearest.distance);
    }
    if(end >= 0)
      change_values(start, end);
  }

  bool is_within_bounds(const int e, const int value) const
  {
    const Bidirected_edge& edge = m_network.edges[e];
    return value >= (std::max)(edge.lower_bound, -largest_value)
        && value <= (std::min)(edge.upper_bound, largest_value);
  }

  void visit_neighbors(const int copy, const double distance)
  {
    for(int place = m_graph.first_place[copy]; place < m_graph.first_place[copy + 1]; ++place)
    {
      const int arc = m_graph.incident[place] / 2, direction = m_graph.incident[place] % 2 == 0 ? 1 : -1, e = arc / 2;
      if(m_is_banned[arc] || !is_within_bounds(e, m_value[e] + direction))
        continue;
      const int next = direction > 0 ? m_graph.head[arc] : m_graph.tail[arc];
      const double cost = direction * deviation_slope(m_network.edges[e], m_value[e], direction) + m_potential[copy]
                        - m_potential[next];
      m_front.reach(next, distance + (std::max)(0., cost), m_graph.incident[place]);
    }
  }

  void change_values(const int start, const int end)
  {
    std::vector<int> edges;
    int forbidden_arc = -1;
    for(int copy = end; copy != start; )
    {
      const int arc = m_front.arrival(copy) / 2, e = arc / 2;
      const bool is_forward = m_front.arrival(copy) % 2 == 0;
      edges.push_back(e);
      m_change[e] += is_forward ? 1 : -1;
      if(!is_within_bounds(e, m_value[e] + m_change[e]))
        forbidden_arc = arc;
      copy = is_forward ? m_graph.tail[arc] : m_graph.head[arc];
    }
    const bool is_allowed = forbidden_arc < 0;
    if(!is_allowed)
    {
      m_is_banned[forbidden_arc] = 1;
      m_banned_arcs.push_back(forbidden_arc);
    }
    for(const int e : edges)
    {
      if(is_allowed)
      {
        m_value[e] += m_change[e];
        add_to_sums(e, m_change[e]);
      }
      m_change[e] = 0;
    }
  }

  const Bidirected_network& m_network;
  const Double_cover& m_graph;
  const std::vector<double>& m_potential; // per node of the double cover
  std::vector<int>& m_value;              // per edge
  std::vector<long long> m_sum;           // per node
  Search_front m_front;                   // of nodes of the double cover, with steps as in Double_cover::incident
  std::vector<int> m_change;              // per edge
  std::vector<char> m_is_banned;          // per arc
  std::vector<int> m_banned_arcs;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_IMBALANCE_PATHS_H
