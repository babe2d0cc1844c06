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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_GROUP_TO_FREE_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_GROUP_TO_FREE_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/unattainable_edges.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Makes free all ends at the nodes of a range.
inline Bidirected_network network_without(Bidirected_network network, const Index_range& nodes)
{
  for(Bidirected_edge& edge : network.edges)
    for(int& node : edge.node)
      if(node >= nodes.begin_index && node < nodes.end_index)
        node = -1;
  return network;
}

// Of several groups of nodes, the first without which the fewest edges are unattainable. The search ends when there are
// none, or after about `maximum_number_of_steps`, one per edge and group. Returns -1 if no group makes them fewer.
inline int group_to_free(const Bidirected_network& network, const std::vector<Index_range>& groups,
                         const std::int64_t maximum_number_of_steps)
{
  std::size_t least_number = unattainable_edges(network).size();
  std::int64_t number_of_steps = 0;
  int result = -1;
  for(std::size_t i = 0; i < groups.size() && least_number > 0 && number_of_steps < maximum_number_of_steps; ++i)
  {
    const std::size_t number = unattainable_edges(network_without(network, groups[i])).size();
    if(number < least_number)
    {
      least_number = number;
      result = static_cast<int>(i);
    }
    number_of_steps += static_cast<std::int64_t>(network.edges.size());
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_GROUP_TO_FREE_H
