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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_QUALITY_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_QUALITY_H

#include <CGAL/Frame_fields/Field_quality.h>
#include <CGAL/Frame_fields/internal/field/branch_pairs.h>
#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// r0 or r1 of eq. (4) of the paper, in radians; `b` is 0 or 1.
inline double branch_rotation(const Cut_surface& surface, const std::vector<double>& alpha,
                              const std::vector<double>& rho, const std::vector<int>& matching, const int dual_edge,
                              const int b)
{
  const int i = face_of(surface.dual_edges[dual_edge].halfedge), j = face_of(surface.dual_edges[dual_edge].opposite);
  const double skewness_i = b == 1 ? rho[i] : 0;
  const double skewness_j = matched_branch(b, matching[dual_edge]) == 1 ? rho[j] : 0;
  return rotation(surface, alpha, matching, dual_edge) - skewness_i + skewness_j;
}

// r0 and r1 of all dual edges.
inline std::vector<std::array<double, 2> > rotations_of_branches(const Cut_surface& surface,
                                                                 const std::vector<double>& alpha,
                                                                 const std::vector<double>& rho,
                                                                 const std::vector<int>& matching)
{
  std::vector<std::array<double, 2> > result;
  result.reserve(surface.number_of_dual_edges());
  for(int e = 0; e < surface.number_of_dual_edges(); ++e)
    result.push_back({ branch_rotation(surface, alpha, rho, matching, e, 0),
                       branch_rotation(surface, alpha, rho, matching, e, 1) });
  return result;
}

// The difference between the components of two matched branches along the edge between their faces. `rotation` is that
// of branch `b` across the edge, in radians.
inline double curl_of_branch(const Cut_surface& surface, const std::vector<double>& alpha,
                             const std::vector<double>& rho, const int dual_edge, const int b, const double rotation)
{
  const Dual_edge& e = surface.dual_edges[dual_edge];
  const double angle_i =
    branch_angle(alpha, rho, face_of(e.halfedge), b) - halfedge_angle(surface, e.halfedge);
  return std::cos(angle_i) - std::cos(angle_i + rotation);
}

// The angle in [0, pi / 2], in radians, between the direction that an aligned face must keep and the nearer branch
// pair.
inline double misalignment(const Cut_surface& surface, const std::vector<double>& alpha, const std::vector<double>& rho,
                           const int face)
{
  const auto distance_of_branch = [&](const int b)
  {
    return std::abs(std::remainder(surface.alignment[face] - branch_angle(alpha, rho, face, b), CGAL_PI));
  };
  return (std::min)(distance_of_branch(0), distance_of_branch(1));
}

// Measures a field; `rotations` are r0 and r1 of its dual edges. Takes time linear in the size of the surface.
inline Field_quality measure_quality(const Cut_surface& surface, const std::vector<double>& alpha,
                                     const std::vector<double>& rho,
                                     const std::vector<std::array<double, 2> >& rotations)
{
  Field_quality quality;
  double sum_of_rotations = 0, sum_of_squared_curls = 0, sum_of_squared_lengths = 0;
  for(int e = 0; e < surface.number_of_dual_edges(); ++e)
  {
    const double length = surface.length[surface.dual_edges[e].halfedge];
    for(int b = 0; b < 2; ++b)
    {
      const double r = rotations[e][b];
      const double curl = curl_of_branch(surface, alpha, rho, e, b, r);
      quality.energy += surface.weight[e] * r * r;
      sum_of_rotations += std::abs(r);
      quality.maximum_rotation = (std::max)(quality.maximum_rotation, std::abs(r));
      sum_of_squared_curls += curl * curl * length * length;
      sum_of_squared_lengths += length * length;
    }
  }
  if(surface.number_of_dual_edges() > 0)
    quality.mean_rotation = sum_of_rotations / (2. * surface.number_of_dual_edges());
  if(sum_of_squared_lengths > 0)
    quality.curl = std::sqrt(sum_of_squared_curls / sum_of_squared_lengths);

  double integral_of_skewness = 0, total_area = 0;
  for(int f = 0; f < surface.number_of_faces(); ++f)
  {
    quality.maximum_skewness = (std::max)(quality.maximum_skewness, std::abs(rho[f]));
    integral_of_skewness += std::abs(rho[f]) * area(surface, f);
    total_area += area(surface, f);
    if(surface.is_aligned(f))
      quality.maximum_misalignment = (std::max)(quality.maximum_misalignment, misalignment(surface, alpha, rho, f));
  }
  if(total_area > 0)
    quality.mean_skewness = integral_of_skewness / total_area;
  return quality;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_QUALITY_H
