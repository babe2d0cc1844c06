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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_ONE_PAIR_ON_TORUS_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_ONE_PAIR_ON_TORUS_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The sectors of index 1/4 and -1/4, in this order, if a patch is a torus whose other sectors are all regular;
// otherwise -1. There is no quadrangulation of a torus with exactly these irregular vertices, and no seamless map.
// (Izmestiev et al., There is no triangulation of the torus with vertex degrees 5, 6, ..., 6, 7 and related results.)
inline std::array<int, 2> one_pair_on_torus(const Cut_surface& surface, const Patch& patch,
                                            const std::vector<int>& index)
{
  const std::array<int, 2> none{ { -1, -1 } };
  std::array<int, 2> pair = none;
  if(2 * patch.dual_edges.size() != 3 * patch.faces.size() || euler_characteristic(patch) != 0)
    return none;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
  {
    if(index[s] == 0)
      continue;
    int& sector = pair[index[s] > 0 ? 0 : 1];
    if(sector >= 0 || index[s] > 1 || index[s] < -1 || surface.is_constrained_sector(s))
      return none;
    sector = s;
  }
  return pair[0] >= 0 && pair[1] >= 0 ? pair : none;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_ONE_PAIR_ON_TORUS_H
