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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMB_PATCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMB_PATCH_H

#include <CGAL/Frame_fields/internal/parameterization/Combing.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Numbers the branches of a patch anew, from its first face on: direction 0 of a face is the branch `first_branch`. The
// matching of the directions as they are numbered then, `quarter_turns`, is -1, 0, 1 or 2, and 0 but on seams.
inline void comb_patch(const Cut_surface& surface, const Patch& patch, const std::vector<int>& matching,
                       std::vector<int>& first_branch, std::vector<int>& quarter_turns)
{
  const Combing combing = comb(surface, patch, matching, patch.faces.begin_index);
  std::copy(combing.turn.begin(), combing.turn.end(), first_branch.begin() + patch.faces.begin_index);
  for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
  {
    const int turns = combing.quarter_turns[surface.dual_edges[e].halfedge - 3 * patch.faces.begin_index];
    quarter_turns[e] = turns == 3 ? -1 : turns;
  }
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMB_PATCH_H
