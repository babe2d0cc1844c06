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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_NODE_MULTIPLIERS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_NODE_MULTIPLIERS_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Approximate Lagrange multipliers of the sums at the nodes. If each edge alone takes the value of least cost for them,
// the sums are small. The flow starts from these multipliers: any others are correct as well, but slower.
//
// Each node in turn changes its multiplier such that its sum would be 0 if no edge changed between a bound and a value
// between its bounds. A sweep takes linear time.
class Node_multipliers
{
public:
  explicit Node_multipliers(const Bidirected_network& network)
    : m_network(network), m_multiplier(network.number_of_nodes, 0.)
    , m_first_place(static_cast<std::size_t>(network.number_of_nodes) + 1, 0)
  {
    const int number_of_edges = static_cast<int>(network.edges.size());
    for(const Bidirected_edge& edge : network.edges)
      for(const int node : edge.node)
        if(node >= 0)
          ++m_first_place[node + 1];
    for(int node = 0; node < network.number_of_nodes; ++node)
      m_first_place[node + 1] += m_first_place[node];
    m_incident.resize(m_first_place.back());
    std::vector<int> next(m_first_place.begin(), m_first_place.end() - 1);
    for(int e = 0; e < number_of_edges; ++e)
      for(int end = 0; end < 2; ++end)
        if(network.edges[e].node[end] >= 0)
          m_incident[next[network.edges[e].node[end]]++] = 2 * e + end;
  }

  const std::vector<double>& run(const int number_of_sweeps)
  {
    for(int sweep = 0; sweep < number_of_sweeps; ++sweep)
      for(int i = 0; i < m_network.number_of_nodes; ++i)
        improve(sweep % 2 == 0 ? i : m_network.number_of_nodes - 1 - i);
    return m_multiplier;
  }

private:
  // By how much a unit of the multiplier of a node changes the slope at one of its edges, times the sign of an end of
  // the edge there. Both ends may be at the node.
  static int change_of_slope(const Bidirected_edge& edge, const int end)
  {
    return edge.node[0] == edge.node[1] ? edge.sign[end] * (edge.sign[0] + edge.sign[1]) : 1;
  }

  // The slope that the multipliers at both ends add to the cost of an edge.
  double slope(const Bidirected_edge& edge) const
  {
    double result = 0;
    for(int end = 0; end < 2; ++end)
      if(edge.node[end] >= 0)
        result += edge.sign[end] * m_multiplier[edge.node[end]];
    return result;
  }

  void improve(const int node)
  {
    double sum = 0, free_change = 0, change = 0; // by how much a unit of the multiplier lowers the sum
    for(int place = m_first_place[node]; place < m_first_place[node + 1]; ++place)
    {
      const Bidirected_edge& edge = m_network.edges[m_incident[place] / 2];
      const double value = edge.target - slope(edge) / (2 * edge.weight);
      const double clamped_value = (std::max)(double(edge.lower_bound), (std::min)(double(edge.upper_bound), value));
      const int end = m_incident[place] % 2;
      sum += edge.sign[end] * clamped_value;
      const double change_of_sum = change_of_slope(edge, end) / (2 * edge.weight);
      change += change_of_sum;
      if(value == clamped_value)
        free_change += change_of_sum;
    }
    if(change > 0)
      m_multiplier[node] += sum / (free_change > 0 ? free_change : change);
  }

  const Bidirected_network& m_network;
  std::vector<double> m_multiplier; // per node
  std::vector<int> m_first_place;   // per node, and one more
  std::vector<int> m_incident;      // by places: 2 * edge + end
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_NODE_MULTIPLIERS_H
