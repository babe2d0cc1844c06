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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FACE_BASIS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FACE_BASIS_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The unit vector along a vector, which must not be zero.
inline Coordinates normalized(const Coordinates& u)
{
  return u / length(u);
}

// Some unit vector perpendicular to a unit vector.
inline Coordinates perpendicular(const Coordinates& u)
{
  const bool is_x_smallest = std::abs(u[0]) <= std::abs(u[1]) && std::abs(u[0]) <= std::abs(u[2]);
  const bool is_y_smallest = !is_x_smallest && std::abs(u[1]) <= std::abs(u[2]);
  const Coordinates axis = is_x_smallest ? Coordinates{ 1, 0, 0 }
                         : is_y_smallest ? Coordinates{ 0, 1, 0 } : Coordinates{ 0, 0, 1 };
  return normalized(cross(u, axis));
}

// The unit vector a quarter turn counter-clockwise from the unit vector `b` along the first edge of a triangle, whose
// next edge runs along `next_edge`. In a triangle without area, some unit vector perpendicular to `b`.
inline Coordinates quarter_turn(const Coordinates& b, const Coordinates& next_edge)
{
  const Coordinates normal = cross(b, next_edge);
  if(length(normal) == 0)
    return perpendicular(b);
  return normalized(cross(normalized(normal), b));
}

// The unit vector along the first edge of a triangle and the unit vector a quarter turn counter-clockwise from it.
typedef std::array<Coordinates, 2> Face_basis;

// The basis of the triangle p, q, r, whose first edge pq must not have length zero.
inline Face_basis face_basis(const Coordinates& p, const Coordinates& q, const Coordinates& r)
{
  const Coordinates b = normalized(scaled_direction(p, q));
  return { b, quarter_turn(b, scaled_direction(q, r)) };
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FACE_BASIS_H
