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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COORDINATES_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COORDINATES_H

#include <CGAL/Frame_fields/internal/surface/strict_floating_point.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point or a vector in space. The coordinates of the caller's points become these once, whatever their kernel.
typedef std::array<double, 3> Coordinates;

template <typename Point, typename GeomTraits>
Coordinates coordinates_of(const Point& point, const GeomTraits& traits)
{
  return { CGAL::to_double(traits.compute_x_3_object()(point)), CGAL::to_double(traits.compute_y_3_object()(point)),
           CGAL::to_double(traits.compute_z_3_object()(point)) };
}

inline Coordinates operator+(const Coordinates& u, const Coordinates& v)
{
  return { u[0] + v[0], u[1] + v[1], u[2] + v[2] };
}

inline Coordinates operator-(const Coordinates& u, const Coordinates& v)
{
  return { u[0] - v[0], u[1] - v[1], u[2] - v[2] };
}

inline Coordinates operator*(const double s, const Coordinates& u) { return { s * u[0], s * u[1], s * u[2] }; }
inline Coordinates operator/(const Coordinates& u, const double s) { return { u[0] / s, u[1] / s, u[2] / s }; }

inline bool is_finite(const Coordinates& u)
{
  return std::isfinite(u[0]) && std::isfinite(u[1]) && std::isfinite(u[2]);
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
  return length(q - p);
}

inline double maximum_norm(const Coordinates& u)
{
  return (std::max)({ std::abs(u[0]), std::abs(u[1]), std::abs(u[2]) });
}

// Returns a vector along q - p whose largest coordinate has an absolute value in [1, 2), so that products of such
// vectors neither overflow nor lose their leading terms; zero if p and q are equal. The coordinates must be finite.
inline Coordinates scaled_direction(const Coordinates& p, const Coordinates& q)
{
  Coordinates d = q - p;
  if(!std::isfinite(maximum_norm(d)))
    d = q / 2 - p / 2;
  const double norm = maximum_norm(d);
  if(norm == 0)
    return d;
  const int exponent = std::ilogb(norm);
  return { std::scalbn(d[0], -exponent), std::scalbn(d[1], -exponent), std::scalbn(d[2], -exponent) };
}

// The angle between two vectors in radians, from 0 to pi; 0 if one of them is zero.
inline double angle_between(const Coordinates& u, const Coordinates& v)
{
  return std::atan2(length(cross(u, v)), dot(u, v)); // accurate near 0 and pi, where acos is not
}

// The text of a point in messages: 17 digits restore each `double`.
inline std::string to_text(const Coordinates& point)
{
  std::ostringstream text;
  text.precision(17);
  text << "(" << point[0] << ", " << point[1] << ", " << point[2] << ")";
  return text.str();
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COORDINATES_H
