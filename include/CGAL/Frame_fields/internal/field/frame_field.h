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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_FRAME_FIELD_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_FRAME_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Statistics.h>
#include <CGAL/Frame_fields/internal/field/branch_pairs.h>
#include <CGAL/Frame_fields/internal/field/energies.h>
#include <CGAL/Frame_fields/internal/field/prescribed_rotation.h>
#include <CGAL/Frame_fields/internal/field/relaxation.h>
#include <CGAL/Frame_fields/internal/field/rotation_demand.h>
#include <CGAL/Frame_fields/internal/field/stages.h>
#include <CGAL/Frame_fields/internal/matching/meshable_matching.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// What the pipeline computes; `alpha` is the orthogonal field, which `gamma` relaxes.
struct Frame_field
{
  std::vector<double> omega;            // per dual edge
  std::vector<double> alpha;            // per face
  std::vector<int> matching;            // per dual edge
  std::vector<int> index;               // per sector
  std::vector<Branch_rotations> gamma;  // per face
  std::vector<Repaired_sector> repaired_sectors;
  int number_of_clamped_faces = 0;
};

// Runs all stages; stops at the first one that fails.
template <typename ConcurrencyTag, typename SolverTraits, typename StageClock>
Patch_result compute_frame_field(const Cut_surface& surface, const Options& options, const SolverTraits& solver_traits,
                                 StageClock& clock, Frame_field& field)
{
  clock.start(Stage::PRESCRIBED_ROTATION);
  Patch_result result = prescribe_rotation<ConcurrencyTag>(surface, options, solver_traits, field.omega);
  if(result.error_code != OK)
    return result;

  clock.start(Stage::ORTHOGONAL_FIELD);
  // The orthogonal field and the relaxation share one order: to find it takes as long as a factorization.
  const std::vector<int> face_order = order_faces<ConcurrencyTag>(surface, solver_traits);
  result = compute_orthogonal_field<ConcurrencyTag>(surface, field.omega, face_order, solver_traits, field.alpha);
  if(result.error_code != OK)
    return result;

  clock.start(Stage::MATCHING_AND_INDICES);
  result = compute_matching_and_indices<ConcurrencyTag>(surface, field.omega, field.alpha, options, field.matching,
                                                        field.index, field.repaired_sectors);
  if(result.error_code != OK)
    return result;

  if(!options.relax_orthogonality)
  {
    field.gamma.assign(surface.number_of_faces(), Branch_rotations{ 0, 0 });
    return {};
  }
  clock.start(Stage::RELAXATION);
  return relax<ConcurrencyTag>(surface, field.alpha, field.matching, options, face_order, solver_traits, field.gamma,
                               field.number_of_clamped_faces);
}

// The sharp corners of all patches, one patch after the other; `bound` is in radians.
inline std::vector<int> sharp_corners_of_surface(const Cut_surface& surface, const double bound)
{
  std::vector<int> result;
  for(const Patch& patch : surface.patches)
  {
    const std::vector<int> corners = sharp_corners_of_patch(surface, patch, bound);
    result.insert(result.end(), corners.begin(), corners.end());
  }
  return result;
}

inline std::vector<int> repaired_sectors_of(const Frame_field& field)
{
  std::vector<int> result;
  for(const Repaired_sector& repaired : field.repaired_sectors)
    result.push_back(repaired.sector);
  return result;
}

// The sectors with `predicate(s)`, in increasing order.
template <typename Predicate>
std::vector<int> sectors_that(const Cut_surface& surface, const Predicate& predicate)
{
  std::vector<int> result;
  for(int s = 0; s < surface.number_of_sectors(); ++s)
    if(predicate(s))
      result.push_back(s);
  return result;
}

inline std::vector<int> unmeshable_sectors_of(const Cut_surface& surface, const Frame_field& field)
{
  return sectors_that(surface, [&](const int s) { return is_unmeshable(surface, field.index, s); });
}

inline std::vector<int> unnatural_sectors_of(const Cut_surface& surface, const Frame_field& field)
{
  return sectors_that(surface, [&](const int s) { return is_unnatural(surface, field.index, s); });
}

template <typename StageClock>
void write_statistics(const Cut_surface& surface, const Options& options, const Frame_field& field,
                      const StageClock& clock, Statistics& statistics)
{
  statistics.number_of_patches = surface.patches.size();
  statistics.number_of_unmeshable_sectors = unmeshable_sectors_of(surface, field).size();
  statistics.number_of_sharp_corners = statistics.number_of_unmeshable_inner_sectors = 0;
  statistics.number_of_unnatural_sectors = statistics.number_of_unnatural_corners = 0;
  for(int sector = 0; sector < surface.number_of_sectors(); ++sector)
  {
    const bool is_sharp = is_sharp_corner(surface, sector, options.sharp_corner_bound);
    statistics.number_of_sharp_corners += is_sharp;
    if(!is_unnatural(surface, field.index, sector))
      continue;
    ++(surface.is_constrained_sector(sector) ? statistics.number_of_unnatural_sectors
                                             : statistics.number_of_unmeshable_inner_sectors);
    statistics.number_of_unnatural_corners += is_sharp;
  }
  statistics.number_of_repaired_sectors = std::count_if(
    field.repaired_sectors.begin(), field.repaired_sectors.end(),
    [&](const Repaired_sector& repaired) { return surface.is_constrained_sector(repaired.sector); });
  statistics.number_of_clamped_faces = field.number_of_clamped_faces;
  statistics.energy_orthogonal = orthogonal_energy(surface, { 0, surface.number_of_dual_edges() }, field.omega,
                                                   field.alpha, field.matching);
  statistics.energy_relaxed = relaxed_energy(surface, field.alpha, field.matching, field.gamma);
  statistics.seconds = clock.seconds();
}

// What the caller did not ask for is not computed.
template <typename StageClock>
void write_statistics(const Cut_surface&, const Options&, const Frame_field&, const StageClock&,
                      const CGAL::internal_np::Param_not_found) {}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_FRAME_FIELD_H
