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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_READ_FIELD_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_READ_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/stages.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/matching/meshable_matching.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Reads the fields that a caller gives.

// Reads omega, in radians per dual edge; it is 0 if it is not given. `omega` must be empty before.
template <typename CutMesh, typename NamedParameters>
Result read_prescribed_rotation(const CutMesh& cut_mesh, const NamedParameters& np, std::vector<double>& omega)
{
  const Result result = read_from_dual_edges(
    cut_mesh, "the prescribed rotation", CGAL::parameters::get_parameter(np, internal::prescribed_rotation), omega);
  if(!result)
    return result;
  for(std::size_t e = 0; e < omega.size(); ++e)
    if(!is_angle(omega[e]))
      return failure(ERROR_WRONG_FIELD, "the prescribed rotation" + beyond_largest_angle()
                     + cut_mesh.description_of_face(face_of(cut_mesh.surface().dual_edges[e].halfedge)));
  omega.resize(cut_mesh.surface().number_of_dual_edges(), 0);
  return {};
}

// Reads the matching if the caller gives one. Otherwise computes it for `alpha` as the pipeline does, with the
// prescribed rotation that the caller gives, the index targets of the surface and the repair that the options ask for.
template <typename ConcurrencyTag, typename CutMesh, typename NamedParameters>
Result read_or_compute_matching(const CutMesh& cut_mesh, const NamedParameters& np, const Options& options,
                                const std::vector<double>& alpha, std::vector<int>& matching)
{
  if(!CGAL::parameters::is_default_parameter<NamedParameters, internal::matching_t>::value)
    return read_from_dual_edges(cut_mesh, "the matching", CGAL::parameters::get_parameter(np, internal::matching),
                                matching);
  std::vector<double> omega;
  const Result result = read_prescribed_rotation(cut_mesh, np, omega);
  if(!result)
    return result;
  std::vector<int> index;
  std::vector<Repaired_sector> repaired_sectors;
  return to_result(cut_mesh, compute_matching_and_indices<ConcurrencyTag>(
    cut_mesh.surface(), omega, alpha, options, matching, index, repaired_sectors));
}

// Reads rho, in radians per face; it is 0 if it is not given.
template <typename CutMesh, typename FaceMap>
Result read_skewness(const CutMesh& cut_mesh, const FaceMap skewness_map, std::vector<double>& rho)
{
  return read_from_faces(cut_mesh, "the skewness", skewness_map, rho);
}

template <typename CutMesh>
Result read_skewness(const CutMesh& cut_mesh, const CGAL::internal_np::Param_not_found, std::vector<double>& rho)
{
  rho.assign(cut_mesh.face_descriptors().size(), 0);
  return {};
}

// Reads a field without changes. `alpha`, `rho` and `matching` must be empty before.
template <typename CutMesh, typename AlphaMap, typename SkewnessMap, typename MatchingMap>
Result read_field(const CutMesh& cut_mesh, const AlphaMap alpha_map, const SkewnessMap skewness_map,
                  const MatchingMap matching_map, std::vector<double>& alpha, std::vector<double>& rho,
                  std::vector<int>& matching)
{
  Result result = read_from_faces(cut_mesh, "alpha", alpha_map, alpha);
  if(result)
    result = read_skewness(cut_mesh, skewness_map, rho);
  if(result)
    result = read_from_dual_edges(cut_mesh, "the matching", matching_map, matching);
  return result;
}

// Reads alpha and undoes the relaxation in aligned faces; in other faces it does not matter for the indices. Some
// branch of an aligned face must be along its direction up to 1e-7 radians; otherwise fails with `ERROR_WRONG_FIELD`.
template <typename CutMesh, typename AlphaMap, typename SkewnessMap>
Result read_unrelaxed_field(const CutMesh& cut_mesh, const AlphaMap alpha_map, const SkewnessMap skewness_map,
                            std::vector<double>& alpha)
{
  const double tolerance = 1e-7;
  const auto is_along = [&](const double difference)
  {
    return std::abs(std::remainder(difference, CGAL_PI)) <= tolerance;
  };

  std::vector<double> rho;
  Result result = read_from_faces(cut_mesh, "alpha", alpha_map, alpha);
  if(result)
    result = read_skewness(cut_mesh, skewness_map, rho);
  if(!result)
    return result;

  const Cut_surface& surface = cut_mesh.surface();
  for(int f = 0; f < surface.number_of_faces(); ++f)
  {
    if(!surface.is_aligned(f) || is_along(surface.alignment[f] - alpha[f]))
      continue;
    if(!is_along(surface.alignment[f] - alpha[f] - CGAL_PI / 2 - rho[f]))
      return failure(ERROR_WRONG_FIELD, "no branch is along the constrained edge or the fixed direction of "
                                        + cut_mesh.description_of_face(f));
    alpha[f] += rho[f];
  }
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_READ_FIELD_H
