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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_CORNER_ANGLES_H
#define CGAL_FRAME_FIELDS_INTERNAL_CORNER_ANGLES_H

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

typedef std::array<double, 3> Coordinates;

template <typename Point, typename GeomTraits>
Coordinates coordinates_of(const Point& point, const GeomTraits& traits)
{
  return { CGAL::to_double(traits.compute_x_3_object()(point)), CGAL::to_double(traits.compute_y_3_object()(point)),
           CGAL::to_double(traits.compute_z_3_object()(point)) };
}

inline double dot(const Coordinates& u, const Coordinates& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

inline Coordinates cross(const Coordinates& u, const Coordinates& v)
{
  return { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
}

inline double length(const Coordinates& u) { return std::hypot(u[0], u[1], u[2]); }

inline double distance(const Coordinates& p, const Coordinates& q)
{
  return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

inline double maximum_norm(const Coordinates& u)
{
  return (std::max)({ std::abs(u[0]), std::abs(u[1]), std::abs(u[2]) });
}

// Returns a vector along q - p whose largest coordinate lies in [1, 2), so that no later product overflows or
// underflows, or zero if p and q are equal.
inline Coordinates scaled_direction(const Coordinates& p, const Coordinates& q)
{
  Coordinates d{ q[0] - p[0], q[1] - p[1], q[2] - p[2] };
  if(!std::isfinite(maximum_norm(d)))
    d = { q[0] / 2 - p[0] / 2, q[1] / 2 - p[1] / 2, q[2] / 2 - p[2] / 2 };
  const double norm = maximum_norm(d);
  if(norm == 0)
    return d;
  const int exponent = std::ilogb(norm);
  return { std::scalbn(d[0], -exponent), std::scalbn(d[1], -exponent), std::scalbn(d[2], -exponent) };
}

inline double angle_between(const Coordinates& u, const Coordinates& v)
{
  return std::atan2(length(cross(u, v)), dot(u, v)); // accurate near 0 and pi, where acos is not
}

// Returns the angles at `points` of a triangle without zero-length edge. They are those of an exact triangle: the
// rounding error of their sum goes to the largest one, so that sums of turning angles close up around every vertex.
inline std::array<double, 3> corner_angles(const std::array<Coordinates, 3>& points)
{
  std::array<Coordinates, 3> edge; // edge[k] runs from points[k] to the next point
  for(int k = 0; k < 3; ++k)
    edge[k] = scaled_direction(points[k], points[(k + 1) % 3]);

  std::array<double, 3> angle;
  for(int k = 0; k < 3; ++k)
  {
    const Coordinates& incoming = edge[(k + 2) % 3];
    angle[k] = angle_between(edge[k], { -incoming[0], -incoming[1], -incoming[2] });
  }
  *std::max_element(angle.begin(), angle.end()) += CGAL_PI - (angle[0] + angle[1] + angle[2]);
  return angle;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_CORNER_ANGLES_H
