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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCKING_PATCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCKING_PATCH_H

#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/quantization/group_to_free.h>
#include <CGAL/Frame_fields/internal/quantization/t_mesh_network.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Which patch is to give up its T-mesh or its filling where there are no integers.

// The patch without whose T-mesh the fewest unknowns are 0 in every solution, the smallest one of several. It need not
// be beside any of them: a strip around the whole model may be cut anywhere. -1 if none makes them fewer.
inline int patch_that_blocks(const Cut_surface& surface, const T_mesh_network& layout,
                             const std::vector<Patch_source>& sources)
{
  const std::int64_t maximum_number_of_steps = 20000000;
  std::vector<int> patches;
  for(std::size_t patch = 0; patch < sources.size(); ++patch)
    if(sources[patch] == Patch_source::T_MESH)
      patches.push_back(static_cast<int>(patch));
  std::stable_sort(patches.begin(), patches.end(), [&](const int p, const int q)
                   { return surface.patches[p].faces.size() < surface.patches[q].faces.size(); });
  std::vector<Index_range> groups;
  for(const int patch : patches)
    groups.push_back(layout.cell_nodes[patch]);
  const int group = group_to_free(layout.network, groups, maximum_number_of_steps);
  return group < 0 ? -1 : patches[group];
}

// Of the patches that have, or whose arcs have, unknowns without a solution: the smallest with a T-mesh, or else the
// smallest filling. -1 if there are none.
inline int smallest_blocked_patch(const Cut_surface& surface, const T_mesh_network& layout, const Arc_sides& sides,
                                  const std::vector<Patch_source>& sources, const std::vector<int>& blocked)
{
  int smallest = -1;
  const auto key = [&](const int patch) { return std::make_pair(sources[patch], surface.patches[patch].faces.size()); };
  const auto consider = [&](const int patch)
  {
    if(patch >= 0 && sources[patch] != Patch_source::SPLIT_TRIANGLES
       && (smallest < 0 || key(patch) < key(smallest)))
      smallest = patch;
  };
  for(const int e : blocked)
    if(layout.is_arc(e))
      for(const Arc_side& side : sides[e])
        consider(side.patch);
    else if(layout.is_piece(e))
      consider(layout.patch_of_piece(e));
  return smallest;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCKING_PATCH_H
