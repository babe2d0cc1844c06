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

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The largest angle of a triangle from the two others, in radians: the sum of the three is pi as far as rounding
// allows, so that sums of turning angles close up around every vertex.
inline double largest_angle(const double angle, const double other_angle)
{
  return (std::max)(0., CGAL_PI - (angle + other_angle));
}

// The angles at the points of a triangle from its edges, where edge[k] runs from point k to the next point. No edge may
// be so long or short that a product of four lengths overflows or underflows.
inline std::array<double, 3> corner_angles_of_edges(const std::array<Coordinates, 3>& edge)
{
  const std::array<double, 3> squared_length{ dot(edge[0], edge[0]), dot(edge[1], edge[1]), dot(edge[2], edge[2]) };
  const int longest =
    static_cast<int>(std::max_element(squared_length.begin(), squared_length.end()) - squared_length.begin());
  const int second = (longest + 1) % 3, third = (longest + 2) % 3;
  const Coordinates normal = cross(edge[second], edge[third]); // of the shorter edges, accurate for needles
  const double squared_normal = dot(normal, normal), smallest = 0x1p-900;
  const double twice_area = squared_normal > smallest ? std::sqrt(squared_normal) : length(normal);
  std::array<double, 3> angle;
  angle[longest] = std::atan2(twice_area, -dot(edge[longest], edge[third]));
  angle[second] = std::atan2(twice_area, -dot(edge[second], edge[longest]));
  angle[third] = largest_angle(angle[longest], angle[second]);
  return angle;
}

// The same for edges of any length: each one is scaled by a power of two.
inline std::array<double, 3> corner_angles_with_scaling(const std::array<Coordinates, 3>& points)
{
  std::array<Coordinates, 3> edge;
  for(int k = 0; k < 3; ++k)
    edge[k] = scaled_direction(points[k], points[(k + 1) % 3]);

  std::array<double, 3> angle;
  for(int k = 0; k < 3; ++k)
  {
    const Coordinates& incoming = edge[(k + 2) % 3];
    angle[k] = angle_between(edge[k], -1. * incoming);
  }
  double& largest = *std::max_element(angle.begin(), angle.end());
  largest += CGAL_PI - (angle[0] + angle[1] + angle[2]);
  return angle;
}

// The angles at `points` of a triangle, in radians. No edge may have length zero; the points must be finite. The
// largest angle takes the rounding error of the sum, so that the sum is pi as far as rounding allows.
inline std::array<double, 3> corner_angles(const std::array<Coordinates, 3>& points)
{
  const double smallest = 0x1p-200, largest = 0x1p200;
  std::array<Coordinates, 3> edge;
  for(int k = 0; k < 3; ++k)
  {
    edge[k] = points[(k + 1) % 3] - points[k];
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
