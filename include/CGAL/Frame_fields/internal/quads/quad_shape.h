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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_SHAPE_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_SHAPE_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Frame_fields {
namespace internal {

typedef std::array<Coordinates, 4> Quad_points;

// How good a quad is.
struct Quad_shape
{
  double scaled_jacobian; // the least of the four corners
  double distortion;      // sum over the corners of (1 - w + w (a / b + b / a) / 2) / J for sides a, b, scaled
                          // Jacobian J and w = `weight_of_side_ratio`; at least 4, which a square has, and infinite if
                          // a J is not positive
};

// Angles count more than the ratio of the sides, as the elements of a solver stand stretched quads better than skew
// ones. With less weight still, rows of quads become several times as long as their neighbours.
constexpr double weight_of_side_ratio = 0.4;

// The scaled Jacobian of a corner is that of Verdict: the sine of its angle, seen along the normal of the quad's
// principal axes. That normal is the quad's own, so a flat quad that lies on its face seems good. It counts as negative
// if it points against `surface_normal`, unless that is zero.
inline Quad_shape quad_shape(const Quad_points& points, const Coordinates& surface_normal = { 0, 0, 0 })
{
  std::array<Coordinates, 4> side;
  std::array<double, 4> squared_length, length;
  for(int k = 0; k < 4; ++k)
  {
    side[k] = points[(k + 1) % 4] - points[k];
    squared_length[k] = dot(side[k], side[k]);
    length[k] = std::sqrt(squared_length[k]);
  }
  const Coordinates normal = cross(side[0] - side[2], side[1] - side[3]);
  const double norm = std::sqrt(dot(normal, normal));
  const double sign = dot(normal, surface_normal) < 0 ? -1 : 1;

  Quad_shape shape{ std::numeric_limits<double>::infinity(), 0 };
  for(int k = 0; k < 4; ++k)
  {
    const int previous = (k + 3) % 4;
    const double lengths = length[k] * length[previous], denominator = lengths * norm;
    const double product = sign * dot(cross(side[previous], side[k]), normal);
    const double jacobian = denominator > 0 ? product / denominator : 0;
    shape.scaled_jacobian = (std::min)(shape.scaled_jacobian, jacobian);
    const double mean_square = (squared_length[k] + squared_length[previous]) / 2;
    shape.distortion += jacobian > 0
      ? (lengths + weight_of_side_ratio * (mean_square - lengths)) / (lengths * jacobian)
      : std::numeric_limits<double>::infinity();
  }
  return shape;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_SHAPE_H
