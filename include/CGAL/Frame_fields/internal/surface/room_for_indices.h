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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_ROOM_FOR_INDICES_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_ROOM_FOR_INDICES_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// How many sectors inside a patch lacks. If the sectors on its constrained edges have their natural indices, those
// inside must sum to the rest of the Euler characteristic, and none shall have an index beyond 1/4 or -1/4.
inline long long missing_sectors_inside(const Cut_surface& surface, const Patch& patch)
{
  long long remaining_index = 4LL * euler_characteristic(patch), number_inside = 0;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(surface.is_constrained_sector(s))
      remaining_index -= natural_index(surface, s);
    else
      ++number_inside;
  return (std::max)(0LL, std::abs(remaining_index) - number_inside);
}

// The dual edges whose edges are to be split in two so that no patch lacks sectors inside: the longest ones of each
// patch. If a patch has too few edges, all of them are returned, and the function must be called again after the
// splits. `surface.length` must be given. Takes O(n log n) time for a patch of n edges that lacks sectors, linear time
// otherwise.
inline std::vector<int> edges_that_make_room(const Cut_surface& surface)
{
  std::vector<int> result; // dual edges
  for(const Patch& patch : surface.patches)
  {
    const long long missing = missing_sectors_inside(surface, patch);
    if(missing == 0)
      continue;
    std::vector<int> edges(patch.dual_edges.size());
    std::iota(edges.begin(), edges.end(), patch.dual_edges.begin_index);
    const auto length = [&](const int e) { return surface.length[surface.dual_edges[e].halfedge]; };
    std::stable_sort(edges.begin(), edges.end(), [&](const int a, const int b) { return length(a) > length(b); });
    edges.resize(static_cast<std::size_t>((std::min)(missing, static_cast<long long>(edges.size()))));
    result.insert(result.end(), edges.begin(), edges.end());
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_ROOM_FOR_INDICES_H
