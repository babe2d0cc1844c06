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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_NETWORK_COMPONENTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_NETWORK_COMPONENTS_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/surface/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A part of a network that shares no node with the others.
struct Network_component
{
  Bidirected_network network;
  std::vector<int> edges; // those of the whole network, in its order
};

// Whether an edge can have any value: both ends are free, or cancel each other at one node.
inline bool is_unconstrained(const Bidirected_edge& edge)
{
  return edge.node[0] == edge.node[1] && (edge.node[0] < 0 || edge.sign[0] != edge.sign[1]);
}

// The edge with its target clamped to [-1e9, 1e9] and its weight to [1e-9, 1e9]. NaN becomes the lower bound or 1e-9.
inline Bidirected_edge finite_edge(Bidirected_edge edge)
{
  const double largest_target = 1e9, smallest_weight = 1e-9, largest_weight = 1e9;
  if(std::isnan(edge.target))
    edge.target = edge.lower_bound;
  edge.target = (std::max)(-largest_target, (std::min)(largest_target, edge.target));
  if(!(edge.weight > smallest_weight))
    edge.weight = smallest_weight;
  edge.weight = (std::min)(largest_weight, edge.weight);
  return edge;
}

// The connected components, in the order of their first edges; edges that are unconstrained belong to none.
inline std::vector<Network_component> network_components(const Bidirected_network& network)
{
  Disjoint_sets sets(network.number_of_nodes);
  for(const Bidirected_edge& edge : network.edges)
    if(edge.node[0] >= 0 && edge.node[1] >= 0)
      sets.unite(edge.node[0], edge.node[1]);

  std::vector<Network_component> result;
  std::vector<int> component(network.number_of_nodes, -1), new_node(network.number_of_nodes, -1);
  for(std::size_t e = 0; e < network.edges.size(); ++e)
  {
    if(is_unconstrained(network.edges[e]))
      continue;
    Bidirected_edge edge = network.edges[e];
    int& c = component[sets.find((std::max)(edge.node[0], edge.node[1]))];
    if(c < 0)
    {
      c = static_cast<int>(result.size());
      result.emplace_back();
    }
    for(int& node : edge.node)
      if(node >= 0)
      {
        if(new_node[node] < 0)
          new_node[node] = result[c].network.number_of_nodes++;
        node = new_node[node];
      }
    result[c].network.edges.push_back(edge);
    result[c].edges.push_back(static_cast<int>(e));
  }
  return result;
}

// Whether all sums can be even. An edge that is not fixed changes the parity of both its nodes. So in each set of nodes
// that such edges connect, the fixed edges must make an even number of sums odd, unless an edge of the set that is not
// fixed has a free end.
inline bool has_consistent_parity(const Bidirected_network& network)
{
  Disjoint_sets sets(network.number_of_nodes);
  for(const Bidirected_edge& edge : network.edges)
    if(edge.lower_bound < edge.upper_bound && edge.node[0] >= 0 && edge.node[1] >= 0)
      sets.unite(edge.node[0], edge.node[1]);

  std::vector<char> is_odd(network.number_of_nodes, 0), has_free_end(network.number_of_nodes, 0);
  for(const Bidirected_edge& edge : network.edges)
    for(int end = 0; end < 2; ++end)
      if(edge.node[end] >= 0)
      {
        const int set = sets.find(edge.node[end]);
        if(edge.lower_bound == edge.upper_bound)
          is_odd[set] ^= (edge.lower_bound % 2 != 0);
        else if(edge.node[1 - end] < 0)
          has_free_end[set] = 1;
      }
  for(int node = 0; node < network.number_of_nodes; ++node)
    if(is_odd[node] && !has_free_end[node])
      return false;
  return true;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_NETWORK_COMPONENTS_H
