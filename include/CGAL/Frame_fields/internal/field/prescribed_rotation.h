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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_PRESCRIBED_ROTATION_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_PRESCRIBED_ROTATION_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Support_strategy.h>
#include <CGAL/Frame_fields/internal/field/rotation_demand.h>
#include <CGAL/Frame_fields/internal/linear/accurate_solve.h>
#include <CGAL/Frame_fields/internal/linear/assemble.h>
#include <CGAL/Frame_fields/internal/linear/elimination_order.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The sharp corners of the patch in increasing order; `bound` is in radians.
inline std::vector<int> sharp_corners_of_patch(const Cut_surface& surface, const Patch& patch, const double bound)
{
  std::vector<int> result;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(is_sharp_corner(surface, s, bound))
      result.push_back(s);
  return result;
}

inline std::vector<int> prescribed_corners_of_patch(const Cut_surface& surface, const Patch& patch,
                                                    const Corner_bounds& bounds)
{
  std::vector<int> result;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(is_prescribed_corner(surface, s, bounds))
      result.push_back(s);
  return result;
}

// The given bounds or, if all sectors of the patch are prescribed corners by them, those by which only the sharp ones
// are. Blunt corners can do without a prescribed rotation, so they must not leave a patch without any receiver.
inline Corner_bounds bounds_that_leave_a_receiver(const Cut_surface& surface, const Patch& patch,
                                                  const Corner_bounds& bounds)
{
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(!is_prescribed_corner(surface, s, bounds))
      return bounds;
  return { bounds.sharp, std::numeric_limits<double>::infinity() };
}

// The naive fix of Section 3.2 of the paper: each prescribed corner shares its demand equally among its dual edges.
inline void prescribe_rotation_locally(const Cut_surface& surface, const Patch& patch, const Corner_bounds& bounds,
                                       std::vector<double>& omega)
{
  std::vector<double> share(patch.sectors.size(), 0);
  for(const int corner : prescribed_corners_of_patch(surface, patch, bounds))
  {
    int number_of_dual_edges = -1; // an open fan has one dual edge less than corners
    for_each_corner(surface.opposite, surface.first_corner[corner], [&](int) { ++number_of_dual_edges; });
    share[corner - patch.sectors.begin_index] =
      rotation_demand_of_corner(surface, corner) / number_of_dual_edges;
  }
  for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    omega[e] = share[surface.sector[surface.dual_edges[e].halfedge] - patch.sectors.begin_index]
             - share[surface.sector[surface.dual_edges[e].opposite] - patch.sectors.begin_index];
}

// Whether the demand of the patch sums to zero up to rounding errors: what some sectors ask for is taken from others.
inline bool sums_to_zero(const Patch& patch, const std::vector<double>& demand)
{
  double sum = 0, absolute_sum = 1;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
  {
    sum += demand[s];
    absolute_sum += std::abs(demand[s]);
  }
  return std::abs(sum) <= 1e-9 * absolute_sum;
}

// Sets omega = W^-1 D^T lambda with (D W^-1 D^T) lambda = demand, the solution of d omega = demand with the least
// sum w omega^2. The demand must sum to zero over the patch. The first sector is pinned at lambda = 0; its own equation
// follows from the others. Returns false if the solver fails. `demand` is in radians per sector, `omega` per dual edge.
template <typename SolverTraits>
bool least_norm_rotation(const Cut_surface& surface, const Patch& patch, const std::vector<double>& demand,
                         const SolverTraits& solver_traits, std::vector<double>& omega)
{
  CGAL_precondition(sums_to_zero(patch, demand));
  const int pinned = patch.sectors.begin_index;
  const int size = patch.sectors.size() - 1;
  std::vector<int> unknown(size + 1); // per sector of the patch, -1 for the pinned one
  std::iota(unknown.begin(), unknown.end(), -1);
  const auto unknown_of = [&](const int halfedge) { return unknown[surface.sector[halfedge] - pinned]; };

  const auto emit = [&](const auto& add)
  {
    for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    {
      const int i = unknown_of(surface.dual_edges[e].halfedge);
      const int j = unknown_of(surface.dual_edges[e].opposite);
      if(i == j) // omega there enters d omega twice, with both signs
        continue;
      if(i >= 0)
        add(i, i, 1 / surface.weight[e]);
      if(j >= 0)
        add(j, j, 1 / surface.weight[e]);
      if(i >= 0 && j >= 0)
        add(i, j, -1 / surface.weight[e]);
    }
  };
  const std::vector<int> order = elimination_order(size, emit, solver_traits);
  std::vector<double> right_hand_side(size);
  for(int k = 0; k < size; ++k)
  {
    unknown[order[k] + 1] = k;
    right_hand_side[k] = demand[pinned + 1 + order[k]];
  }
  auto solver = solver_traits.real_solver_object();
  std::vector<double> lambda;
  if(!factor_and_solve(solver, assemble<double>(size, emit), right_hand_side, lambda))
    return false;

  const auto value = [&](const int halfedge) { return unknown_of(halfedge) < 0 ? 0. : lambda[unknown_of(halfedge)]; };
  for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    omega[e] = (value(surface.dual_edges[e].halfedge) - value(surface.dual_edges[e].opposite)) / surface.weight[e];
  return true;
}

// d omega that gives a sector the index I, where `index` is 4 I (eq. (3) of the paper).
inline double demand_of_index(const Cut_surface& surface, const int sector, const int index)
{
  const double turns = index / 4. - (surface.is_constrained_sector(sector) ? 0.5 : 1);
  return surface.total_angle[sector] + 2 * CGAL_PI * turns;
}

// Sets the demand of the patch, in radians per sector. Sets `is_needed` to false and leaves the demand as it is if no
// rotation is prescribed. Fails if index targets do not sum to what the Euler characteristic asks for, or if a corner
// has no receiver.
inline Patch_result set_demand(const Cut_surface& surface, const Patch& patch, const Support_strategy& strategy,
                               const Corner_bounds& given_bounds, std::vector<double>& demand, bool& is_needed)
{
  is_needed = true;
  if(has_index_targets(surface, patch))
  {
    const long long missing = missing_index(surface, patch);
    if(missing != 0)
      return { ERROR_POINCARE_HOPF, patch.sectors.begin_index, missing };
    for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
      demand[s] = demand_of_index(surface, s, target_of_sector(surface, s));
    return {};
  }
  const Corner_bounds bounds = bounds_that_leave_a_receiver(surface, patch, given_bounds);
  const std::vector<int> corners = prescribed_corners_of_patch(surface, patch, bounds);
  is_needed = strategy.kind() != Support_strategy::NONE && !corners.empty();
  if(!is_needed)
    return {};
  const int corner_without_receiver =
    spread_rotation_demand(surface, patch, corners, strategy, bounds, demand);
  if(corner_without_receiver >= 0)
    return { ERROR_NO_RECEIVING_SECTOR, corner_without_receiver };
  return {};
}

// Writes omega on the dual edges of the patch, which must be 0 before (Section 3.2 of the paper).
template <typename SolverTraits>
Patch_result prescribe_rotation_in_patch(const Cut_surface& surface, const Patch& patch,
                                         const Support_strategy& strategy, const Corner_bounds& bounds,
                                         const SolverTraits& solver_traits, std::vector<double>& demand,
                                         std::vector<double>& omega)
{
  if(strategy.kind() == Support_strategy::LOCAL && !has_index_targets(surface, patch))
  {
    prescribe_rotation_locally(surface, patch, bounds, omega);
    return {};
  }
  bool is_needed;
  const Patch_result result = set_demand(surface, patch, strategy, bounds, demand, is_needed);
  if(result.error_code != OK || !is_needed)
    return result;
  if(!least_norm_rotation(surface, patch, demand, solver_traits, omega))
    return { ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, patch.sectors.begin_index };
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_PRESCRIBED_ROTATION_H
