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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PROPOSE_INDEX_TARGETS_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PROPOSE_INDEX_TARGETS_H

#include <CGAL/Frame_fields/internal/parameterization/Combed_field.h>
#include <CGAL/Frame_fields/internal/parameterization/Combing.h>
#include <CGAL/Frame_fields/internal/parameterization/Cut_graph.h>
#include <CGAL/Frame_fields/internal/parameterization/Map_basis.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Proposes other indices for a patch that forces a side to length zero between two corners that turn against one
// another, as a step on a ring does: 1/4 moves from one end to the other, so that the step becomes a slope. Writes the
// targets of all sectors of the patch, and returns whether there is a proposal. The new field may force another side to
// zero.
inline bool propose_index_targets(const Cut_surface& surface, const Patch& patch, const std::vector<double>& alpha,
                                  const std::vector<double>& rho, const std::vector<int>& matching,
                                  const std::vector<int>& index, std::vector<int>& index_target)
{
  const Combing combing = comb(surface, patch, matching, patch.faces.begin_index);
  const Cut_graph graph = Patch_cutter(surface, patch, index, combing).cut();
  const Combed_field field(surface, patch, alpha, rho, combing);
  const Map_basis basis(surface, patch, index, graph, field);
  if(!basis.has_forced_zero_side())
    return false;
  std::array<int, 2> ends = basis.forced_zero_side();
  if(index[ends[0]] < index[ends[1]])
    std::swap(ends[0], ends[1]);
  if(!(index[ends[0]] > 0 && index[ends[1]] < 0))
    return false;
  std::copy(index.begin() + patch.sectors.begin_index, index.begin() + patch.sectors.end_index,
            index_target.begin() + patch.sectors.begin_index);
  --index_target[ends[0]];
  ++index_target[ends[1]];
  return true;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PROPOSE_INDEX_TARGETS_H
