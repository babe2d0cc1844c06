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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MATCHING_MATCHING_AND_INDICES_H
#define CGAL_FRAME_FIELDS_INTERNAL_MATCHING_MATCHING_AND_INDICES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The rotation from face i to face j when branch 0 goes to branch 0: r_ij of eq. (1) of the paper without p_ij.
inline double unmatched_rotation(const Cut_surface& surface, const std::vector<double>& alpha, const int dual_edge)
{
  const Dual_edge& e = surface.dual_edges[dual_edge];
  return -alpha[face_of(e.halfedge)] + alpha[face_of(e.opposite)] + surface.transport[dual_edge];
}

// r_ij of an orthogonal field.
inline double rotation(const Cut_surface& surface, const std::vector<double>& alpha, const std::vector<int>& matching,
                       const int dual_edge)
{
  return unmatched_rotation(surface, alpha, dual_edge) + matching[dual_edge] * CGAL_PI / 2;
}

// Writes p_ij on the dual edges of the patch: the integers that bring r_ij nearest to omega_ij. Angles are in radians;
// the quotients by a quarter turn must fit into an `int`.
inline void match_patch(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                        const std::vector<double>& alpha, std::vector<int>& matching)
{
  for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    matching[e] = static_cast<int>(std::lround((omega[e] - unmatched_rotation(surface, alpha, e)) / (CGAL_PI / 2)));
}

// Whether each r_ij differs from omega_ij by at most an eighth of a turn, up to rounding errors.
inline bool is_nearest_matching(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                                const std::vector<double>& alpha, const std::vector<int>& matching)
{
  for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    if(!(std::abs(rotation(surface, alpha, matching, e) - omega[e]) <= CGAL_PI / 4 + 1e-6))
      return false;
  return true;
}

// Poincare and Hopf: the indices of a patch sum to its Euler characteristic, whatever the field is.
inline bool has_sum_of_indices(const Patch& patch, const std::vector<int>& index)
{
  return std::accumulate(index.begin() + patch.sectors.begin_index, index.begin() + patch.sectors.end_index, 0LL)
         == 4LL * euler_characteristic(patch);
}

// Writes 4 I on the sectors of the patch (eq. (3) of the paper). `alpha` must be an orthogonal field aligned with the
// constrained edges; then 4 I is an integer up to rounding errors. Otherwise returns `ERROR_WRONG_FIELD` with the first
// sector where 4 I is farther than 1e-6 from an integer, or beyond +-1e9.
inline Patch_result indices_in_patch(const Cut_surface& surface, const Patch& patch, const std::vector<double>& alpha,
                                     const std::vector<int>& matching, std::vector<int>& index)
{
  const double tolerance = 1e-6;
  const double largest_index = 1e9; // what is larger has no digits left for the tolerance, or is no int

  std::vector<double> sum_of_rotations(patch.sectors.size(), 0);
  for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
  {
    const double r = rotation(surface, alpha, matching, e);
    sum_of_rotations[surface.sector[surface.dual_edges[e].halfedge] - patch.sectors.begin_index] += r;
    sum_of_rotations[surface.sector[surface.dual_edges[e].opposite] - patch.sectors.begin_index] -= r;
  }
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
  {
    const double turns = (sum_of_rotations[s - patch.sectors.begin_index] - surface.total_angle[s]) / (2 * CGAL_PI);
    const double four_times_index = 4 * (turns + (surface.is_constrained_sector(s) ? 0.5 : 1));
    if(!(std::abs(four_times_index - std::round(four_times_index)) <= tolerance
         && std::abs(four_times_index) <= largest_index))
      return { ERROR_WRONG_FIELD, s };
    index[s] = static_cast<int>(std::lround(four_times_index));
  }
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MATCHING_MATCHING_AND_INDICES_H
