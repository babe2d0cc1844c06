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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WEIGHTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WEIGHTS_H

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The height of a triangle over the edge of a halfedge, divided by the length of that edge. Only angles are needed.
inline double height_over_length(const Cut_surface& surface, const int halfedge)
{
  const double at_target = surface.angle[halfedge], at_source = surface.angle[previous_of(halfedge)];
  const double length_over_height =
    std::sin(at_target + at_source) / (std::sin(at_target) * std::sin(at_source));
  return std::isnan(length_over_height) ? 0 : 1 / length_over_height; // 0 / 0 in a triangle without area
}

// w_ij: 1 if uniform; otherwise the length of the edge over the sum of the heights of its two faces, times sqrt(3),
// which is 1 between equilateral triangles, within bounds.
inline double edge_weight(const Cut_surface& surface, const Dual_edge& e, const Edge_weighting weighting)
{
  if(weighting == Edge_weighting::UNIFORM)
    return 1;
  // In needles and caps one of the two ratios may be infinite; the bounds keep the systems solvable.
  const double smallest = 1e-6, largest = 1e6;
  const double dual_over_primal = height_over_length(surface, e.halfedge) + height_over_length(surface, e.opposite);
  return (std::min)(largest, (std::max)(smallest, std::sqrt(3.) / dual_over_primal));
}

// The weight of |z - z_guide|^2 in a face. With uniform edge weights it is the given one. Otherwise it is multiplied by
// the area of the face over sqrt(3), in units of the mesh, so that the sum over the faces is an integral, as it is for
// the relaxation; then the surface must have lengths.
inline double guide_weight(const Cut_surface& surface, const int face)
{
  if(surface.guide_weight.empty() || surface.guide_weight[face] == 0)
    return 0;
  double weight = surface.guide_weight[face];
  if(surface.edge_weighting != Edge_weighting::UNIFORM)
    weight *= surface.length_unit * area(surface, face) / std::sqrt(3.) * surface.length_unit;
  // The edges have weights of about 1, which would be lost in the rounding of a much larger weight. The largest one
  // holds the frame in its place already.
  const double largest = 1e8;
  return (std::min)(largest, weight);
}

// A weight up to this is lost in the rounding errors of the edge weights.
constexpr double smallest_effective_weight = 1e-12;

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WEIGHTS_H
