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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_RELAXATION_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_RELAXATION_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/Orthogonality.h>
#include <CGAL/Frame_fields/internal/field/Relaxation_system.h>
#include <CGAL/Frame_fields/internal/field/branch_pairs.h>
#include <CGAL/Frame_fields/internal/linear/accurate_solve.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Brings gamma0 and gamma1 to a distance of at most `maximum_skewness`; all are in radians. Returns whether they were
// farther apart. `fixed_branch` is the branch pair that must stay, -1 if both may move.
inline bool clamp(Branch_rotations& gamma, const int fixed_branch, const double maximum_skewness)
{
  const double skewness = gamma[1] - gamma[0];
  if(std::abs(skewness) <= maximum_skewness)
    return false;
  const double clamped = std::copysign(maximum_skewness, skewness);
  if(fixed_branch == 0)
    gamma[1] = gamma[0] + clamped;
  else if(fixed_branch == 1)
    gamma[0] = gamma[1] - clamped;
  else
  {
    const double mean = (gamma[0] + gamma[1]) / 2;
    gamma = { mean - clamped / 2, mean + clamped / 2 };
  }
  return true;
}

// Writes gamma on the faces of the patch and counts the faces that were clamped.
template <typename SolverTraits>
Patch_result relax_patch(const Cut_surface& surface, const Patch& patch, const std::vector<double>& alpha,
                         const std::vector<int>& matching, const Options& options,
                         const std::vector<int>& face_order, const SolverTraits& solver_traits,
                         std::vector<Branch_rotations>& gamma, int& number_of_clamped_faces)
{
  const Orthogonality orthogonality(surface, patch, options);
  const Relaxation_system system(surface, patch, alpha, matching, orthogonality, face_order);
  auto solver = solver_traits.real_solver_object();
  std::vector<double> solution;
  if(!factor_and_solve(solver, system.matrix(), system.right_hand_side(), solution))
    return { ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, patch.sectors.begin_index };

  number_of_clamped_faces = 0;
  for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
  {
    gamma[f] = system.branch_rotations(solution, f);
    const int fixed_branch = surface.is_aligned(f) ? aligned_branch(surface, f, alpha[f]) : -1;
    if(clamp(gamma[f], fixed_branch, options.maximum_skewness))
      ++number_of_clamped_faces;
    CGAL_postcondition(fixed_branch < 0 || gamma[f][fixed_branch] == 0); // it stays aligned, exactly
  }
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_RELAXATION_H
