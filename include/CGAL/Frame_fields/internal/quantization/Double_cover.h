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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_DOUBLE_COVER_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_DOUBLE_COVER_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// No edge gets more than this, so that sums of all values fit into 64 bits.
constexpr int largest_value = 1 << 30;

// What the value n of an edge costs.
inline double deviation_cost(const Bidirected_edge& edge, const double n)
{
  return edge.weight * (n - edge.target) * (n - edge.target);
}

// What a step from n to n + step costs, per unit of the step.
inline double deviation_slope(const Bidirected_edge& edge, const double n, const double step)
{
  return edge.weight * (2 * (n - edge.target) + step);
}

// The integer in [lower, upper] that is nearest to a number, the lower one of two. It is `lower` for NaN.
inline int nearest_integer(const double number, const int lower, const int upper)
{
  if(!(number > lower))
    return lower;
  if(number > upper)
    return upper;
  // The number is at most `upper` here, so that the integer below fits into an int, but the next one may not.
  const int below = static_cast<int>(std::floor(number));
  return (below < upper && number - below > .5) ? below + 1 : below;
}

// The directed graph that has each node n of a bidirected network twice, as (n, +) and (n, -), and each edge as two
// mirrored arcs: one from the node of the edge's first end, with its sign there, to the node of the second end, with
// the opposite sign; the other from the second end to the first. If both arcs carry the value of the edge, a sum of 0
// at n means that the flow is conserved at both copies of n. All free ends are at one more node, its own mirror image.
//
// So the directed cycles are the closed strips of the network and the strips between free ends. The mean of a flow over
// the two arcs of each edge is a solution of the network in halves.
struct Double_cover
{
  // Per arc. Edge e has the arcs 2 e + i; such an arc runs from end i to end 1 - i of the edge.
  std::vector<int> tail, head;
  std::vector<int> first_place; // per node, and one more
  std::vector<int> incident;    // by places: 2 * arc, or 2 * arc + 1 at the head of the arc

  explicit Double_cover(const Bidirected_network& network);

  int number_of_nodes() const { return static_cast<int>(first_place.size()) - 1; }
  int number_of_arcs() const { return static_cast<int>(tail.size()); }
};

inline Double_cover::Double_cover(const Bidirected_network& network)
  : tail(2 * network.edges.size()), head(2 * network.edges.size())
  , first_place(2 * static_cast<std::size_t>(network.number_of_nodes) + 2, 0), incident(4 * network.edges.size())
{
  const int free_node = 2 * network.number_of_nodes;
  const auto copy = [free_node](const int node, const int sign)
  {
    return node < 0 ? free_node : 2 * node + (sign < 0 ? 1 : 0);
  };
  for(std::size_t e = 0; e < network.edges.size(); ++e)
    for(int end = 0; end < 2; ++end)
    {
      const Bidirected_edge& edge = network.edges[e];
      tail[2 * e + end] = copy(edge.node[end], edge.sign[end]);
      head[2 * e + end] = copy(edge.node[1 - end], -edge.sign[1 - end]);
    }

  std::vector<int> place(first_place.size() + 1, 0);
  for(int arc = 0; arc < number_of_arcs(); ++arc)
  {
    ++place[tail[arc] + 2];
    ++place[head[arc] + 2];
  }
  for(std::size_t node = 2; node < place.size(); ++node)
    place[node] += place[node - 1];
  for(int arc = 0; arc < number_of_arcs(); ++arc)
  {
    incident[place[tail[arc] + 1]++] = 2 * arc;
    incident[place[head[arc] + 1]++] = 2 * arc + 1;
  }
  std::copy(place.begin(), place.end() - 1, first_place.begin());
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_DOUBLE_COVER_H
