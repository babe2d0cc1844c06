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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CORNER_ANGLES_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CORNER_ANGLES_H

#include <CGAL/Frame_fields/internal/surface/strict_floating_point.h>

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

// The two smaller angles of a triangle leave this for the largest one, so that the three have the sum pi as far as
// rounding allows, and sums of turning angles close up around every vertex.
inline double largest_angle(const double angle, const double other_angle)
{
  return (std::max)(0., CGAL_PI - (angle + other_angle));
}

// The angles at the points of a triangle from its edges, where edge[k] runs from point k to the next point and none is
// so long or short that a product of four lengths overflows or underflows.
inline std::array<double, 3> corner_angles_of_edges(const std::array<Coordinates, 3>& edge)
{
  const std::array<double, 3> squared_length{ dot(edge[0], edge[0]), dot(edge[1], edge[1]), dot(edge[2], edge[2]) };
  const int longest =
    static_cast<int>(std::max_element(squared_length.begin(), squared_length.end()) - squared_length.begin());
  const int second = (longest + 1) % 3, third = (longest + 2) % 3;
  const Coordinates normal = cross(edge[second], edge[third]); // of the shorter edges: needles are accurate
  const double squared_normal = dot(normal, normal), smallest = 0x1p-900;
  const double twice_area = squared_normal > smallest ? std::sqrt(squared_normal) : length(normal);
  std::array<double, 3> angle;
  angle[longest] = std::atan2(twice_area, -dot(edge[longest], edge[third]));
  angle[second] = std::atan2(twice_area, -dot(edge[second], edge[longest]));
  angle[third] = largest_angle(angle[longest], angle[second]);
  return angle;
}

// The same for edges that must be scaled.
inline std::array<double, 3> corner_angles_with_scaling(const std::array<Coordinates, 3>& points)
{
  std::array<Coordinates, 3> edge;
  for(int k = 0; k < 3; ++k)
    edge[k] = scaled_direction(points[k], points[(k + 1) % 3]);

  std::array<double, 3> angle;
  for(int k = 0; k < 3; ++k)
  {
    const Coordinates& incoming = edge[(k + 2) % 3];
    angle[k] = angle_between(edge[k], { -incoming[0], -incoming[1], -incoming[2] });
  }
  double& largest = *std::max_element(angle.begin(), angle.end());
  largest += CGAL_PI - (angle[0] + angle[1] + angle[2]);
  return angle;
}

// Returns the angles at `points` of a triangle without zero-length edge. They are those of an exact triangle: the
// rounding error of their sum goes to the largest one.
inline std::array<double, 3> corner_angles(const std::array<Coordinates, 3>& points)
{
  const double smallest = 0x1p-200, largest = 0x1p200;
  std::array<Coordinates, 3> edge;
  for(int k = 0; k < 3; ++k)
  {
    const Coordinates& p = points[k];
    const Coordinates& q = points[(k + 1) % 3];
    edge[k] = { q[0] - p[0], q[1] - p[1], q[2] - p[2] };
    const double norm = maximum_norm(edge[k]);
    if(!(norm >= smallest && norm <= largest))
      return corner_angles_with_scaling(points);
  }
  return corner_angles_of_edges(edge);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CORNER_ANGLES_H
