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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_PLANE_VECTOR_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_PLANE_VECTOR_H

#include <CGAL/Frame_fields/internal/surface/strict_floating_point.h>

#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point or a vector in a plane.
struct Plane_vector
{
  double x, y;
};

inline Plane_vector operator+(const Plane_vector& u, const Plane_vector& v) { return { u.x + v.x, u.y + v.y }; }
inline Plane_vector operator-(const Plane_vector& u, const Plane_vector& v) { return { u.x - v.x, u.y - v.y }; }
inline Plane_vector operator-(const Plane_vector& u) { return { -u.x, -u.y }; }
inline Plane_vector operator*(const double s, const Plane_vector& u) { return { s * u.x, s * u.y }; }
inline double dot(const Plane_vector& u, const Plane_vector& v) { return u.x * v.x + u.y * v.y; }
inline double cross(const Plane_vector& u, const Plane_vector& v) { return u.x * v.y - u.y * v.x; }
inline Plane_vector quarter_turn(const Plane_vector& u) { return { -u.y, u.x }; }

// The angle from u counter-clockwise to v in radians, from -pi to pi; 0 if one of them is zero.
inline double angle_from_to(const Plane_vector& u, const Plane_vector& v) { return std::atan2(cross(u, v), dot(u, v)); }

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_PLANE_VECTOR_H
