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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_LAYOUT_DEMANDS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_LAYOUT_DEMANDS_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/quads/fill_patch.h>
#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// What is asked of the numbers of edges beside their lengths, and is given up where no integers fulfil it.
struct Layout_demands
{
  std::vector<Patch_source> sources; // per patch
  std::vector<int> number_of_edges;  // per arc: what is wanted and not given up, 0 if it is free; or empty
  std::vector<char> ignores_bends;   // per arc: whether it may have fewer vertices than bends
  bool forbids_empty_pieces = false;

  bool is_arc(const int unknown) const { return unknown < static_cast<int>(ignores_bends.size()); }
  bool is_fixed(const std::size_t arc) const { return !number_of_edges.empty() && number_of_edges[arc] > 0; }
  bool has_fixed_arcs() const
  {
    return std::any_of(number_of_edges.begin(), number_of_edges.end(), [](const int n) { return n > 0; });
  }
};

// Gives up wanted numbers that no filling takes, as they are odd or too small, and all beside split triangles.
inline void release_arcs_of_fillings(const Surface_embedding& embedding, const Feature_network& features,
                                     const Arc_sides& sides, Layout_demands& demands)
{
  for(std::size_t a = 0; a < features.arcs.size(); ++a)
    for(const Arc_side& side : sides[a])
      if(demands.is_fixed(a) && side.patch >= 0 && demands.sources[side.patch] != Patch_source::T_MESH
         && (demands.sources[side.patch] == Patch_source::SPLIT_TRIANGLES || demands.number_of_edges[a] % 2 != 0
             || demands.number_of_edges[a] < smallest_even_count(embedding, features.arcs[a])))
        demands.number_of_edges[a] = 0;
}

// Gives up the numbers that are wanted on the arcs of a patch. Returns whether there are any.
inline bool release_arcs_of_patch(const Arc_sides& sides, const int patch, Layout_demands& demands)
{
  bool is_any_released = false;
  for(std::size_t a = 0; a < sides.size(); ++a)
    for(const Arc_side& side : sides[a])
      if(demands.is_fixed(a) && side.patch == patch)
      {
        demands.number_of_edges[a] = 0;
        is_any_released = true;
      }
  return is_any_released;
}

// If any numbers are wanted, lets the other arcs among the unknowns without a solution have fewer edges than bends.
// Returns whether there are any.
inline bool ignore_bends(const std::vector<int>& blocked, Layout_demands& demands)
{
  bool is_any_ignored = false;
  if(demands.has_fixed_arcs())
    for(const int e : blocked)
      if(demands.is_arc(e) && !demands.is_fixed(e) && !demands.ignores_bends[e])
        demands.ignores_bends[e] = is_any_ignored = true;
  return is_any_ignored;
}

// Of the wanted numbers among the unknowns without a solution, gives up the one that is farthest from what the length
// of its arc asks for. Returns whether there is one.
inline bool release_blocked_arc(const Bidirected_network& network, const std::vector<int>& blocked,
                                Layout_demands& demands)
{
  int farthest = -1;
  const auto ratio = [&](const int arc)
  {
    const double number = demands.number_of_edges[arc], target = (std::max)(1e-3, network.edges[arc].target);
    return (std::max)(number / target, target / number);
  };
  for(const int e : blocked)
    if(demands.is_arc(e) && demands.is_fixed(e) && (farthest < 0 || ratio(e) > ratio(farthest)))
      farthest = e;
  if(farthest < 0)
    return false;
  demands.number_of_edges[farthest] = 0;
  return true;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_LAYOUT_DEMANDS_H
