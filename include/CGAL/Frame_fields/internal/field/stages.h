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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_STAGES_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_STAGES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/Field_without_corners.h>
#include <CGAL/Frame_fields/internal/field/branch_pairs.h>
#include <CGAL/Frame_fields/internal/field/orthogonal_field.h>
#include <CGAL/Frame_fields/internal/field/prescribed_rotation.h>
#include <CGAL/Frame_fields/internal/field/relaxation.h>
#include <CGAL/Frame_fields/internal/linear/elimination_order.h>
#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/matching/meshable_matching.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The stages of the pipeline on all patches. Values on dual edges belong to their first halfedge.

// Sets omega, in radians per dual edge (Section 3.2 of the paper).
template <typename ConcurrencyTag, typename SolverTraits>
Patch_result prescribe_rotation(const Cut_surface& surface, const Options& options, const SolverTraits& solver_traits,
                                std::vector<double>& omega)
{
  omega.assign(surface.number_of_dual_edges(), 0);
  std::vector<double> demand(surface.number_of_sectors(), 0);
  const Corner_bounds bounds{ options.sharp_corner_bound, options.blunt_corner_bound };
  return for_each_patch<ConcurrencyTag>(surface, [&](const int patch)
  {
    return prescribe_rotation_in_patch(surface, surface.patches[patch], options.support_strategy, bounds, solver_traits,
                                       demand, omega);
  });
}

// The faces of the patches, one patch after the other, each in the order in which its systems should number them.
template <typename ConcurrencyTag, typename SolverTraits>
std::vector<int> order_faces(const Cut_surface& surface, const SolverTraits& solver_traits)
{
  std::vector<int> result(surface.number_of_faces());
  for_each_patch<ConcurrencyTag>(surface, [&](const int number)
  {
    const Patch& patch = surface.patches[number];
    const std::vector<int> faces = elimination_order_of_faces(surface, patch, solver_traits);
    std::copy(faces.begin(), faces.end(), result.begin() + patch.faces.begin_index);
    return Patch_result();
  });
  return result;
}

// Sets alpha, in radians per face (Section 3.3 of the paper), for omega per dual edge. `face_order` is that of
// `order_faces()`.
template <typename ConcurrencyTag, typename SolverTraits>
Patch_result compute_orthogonal_field(const Cut_surface& surface, const std::vector<double>& omega,
                                      const std::vector<int>& face_order, const SolverTraits& solver_traits,
                                      std::vector<double>& alpha)
{
  alpha.resize(surface.number_of_faces());
  Arrays_without_corners arrays;
  if(std::any_of(surface.patches.begin(), surface.patches.end(),
                 [&](const Patch& patch) { return is_patch_without_corners(surface, patch); }))
  {
    arrays.omega.resize(surface.number_of_dual_edges());
    arrays.demand.resize(surface.number_of_sectors());
    arrays.matching.resize(surface.number_of_dual_edges());
    arrays.index.resize(surface.number_of_sectors());
  }
  return for_each_patch<ConcurrencyTag>(surface, [&](const int number)
  {
    const Patch& patch = surface.patches[number];
    const Patch_result result = orthogonal_field_in_patch(surface, patch, omega, face_order, solver_traits, alpha);
    if(result.error_code != OK || !is_patch_without_corners(surface, patch))
      return result;
    return Field_without_corners<SolverTraits>(surface, patch, omega, face_order, solver_traits, arrays, alpha)
      .improve();
  });
}

// Sets 4 I per sector. Fails if `alpha` is not aligned with the constrained edges.
template <typename ConcurrencyTag>
Patch_result compute_indices(const Cut_surface& surface, const std::vector<double>& alpha,
                             const std::vector<int>& matching, std::vector<int>& index)
{
  index.resize(surface.number_of_sectors());
  return for_each_patch<ConcurrencyTag>(surface, [&](const int patch)
  {
    return indices_in_patch(surface, surface.patches[patch], alpha, matching, index);
  });
}

// Sets the matching nearest to omega and 4 I per sector. Patches with index targets then get these targets; the others
// are made natural if the options ask for it. The sectors whose index this changed are added to `repaired_sectors`.
template <typename ConcurrencyTag>
Patch_result compute_matching_and_indices(const Cut_surface& surface, const std::vector<double>& omega,
                                          const std::vector<double>& alpha, const Options& options,
                                          std::vector<int>& matching, std::vector<int>& index,
                                          std::vector<Repaired_sector>& repaired_sectors)
{
  matching.resize(surface.number_of_dual_edges());
  index.resize(surface.number_of_sectors());
  std::vector<std::vector<Repaired_sector> > repaired(surface.patches.size());
  const Patch_result result = for_each_patch<ConcurrencyTag>(surface, [&](const int number)
  {
    const Patch& patch = surface.patches[number];
    match_patch(surface, patch, omega, alpha, matching);
    CGAL_assertion(is_nearest_matching(surface, patch, omega, alpha, matching));
    Patch_result patch_result = indices_in_patch(surface, patch, alpha, matching, index);
    if(patch_result.error_code == OK && has_index_targets(surface, patch))
      patch_result = enforce_index_targets(surface, patch, omega, alpha, matching, index, repaired[number]);
    else if(patch_result.error_code == OK && options.repair_matching)
      repaired[number] = repair_patch(surface, patch, omega, alpha, matching, index);
    CGAL_postcondition(patch_result.error_code != OK || has_sum_of_indices(patch, index));
    return patch_result;
  });
  for(const std::vector<Repaired_sector>& sectors : repaired)
    repaired_sectors.insert(repaired_sectors.end(), sectors.begin(), sectors.end());
  return result;
}

// Sets gamma, in radians per face and branch (Section 4 of the paper), and counts the faces whose skewness was
// clamped.
template <typename ConcurrencyTag, typename SolverTraits>
Patch_result relax(const Cut_surface& surface, const std::vector<double>& alpha, const std::vector<int>& matching,
                   const Options& options, const std::vector<int>& face_order, const SolverTraits& solver_traits,
                   std::vector<Branch_rotations>& gamma, int& number_of_clamped_faces)
{
  gamma.assign(surface.number_of_faces(), Branch_rotations{ 0, 0 });
  std::vector<int> clamped(surface.patches.size(), 0);
  const Patch_result result = for_each_patch<ConcurrencyTag>(surface, [&](const int patch)
  {
    return relax_patch(surface, surface.patches[patch], alpha, matching, options, face_order, solver_traits, gamma,
                       clamped[patch]);
  });
  number_of_clamped_faces = std::accumulate(clamped.begin(), clamped.end(), 0);
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_STAGES_H
