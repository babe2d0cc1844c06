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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_LOCATION_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_LOCATION_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <array>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point of the surface: a face and the weights of the targets of its three halfedges, not negative, of sum 1.
struct Surface_location
{
  int face = -1;
  std::array<double, 3> barycentric = { 1, 0, 0 };
};

// The location on a halfedge at a fraction of the way from its source (0) to its target (1).
inline Surface_location location_on_halfedge(const int halfedge, const double fraction)
{
  Surface_location location;
  location.face = face_of(halfedge);
  location.barycentric = { 0, 0, 0 };
  location.barycentric[halfedge % 3] = fraction;
  location.barycentric[previous_of(halfedge) % 3] = 1 - fraction;
  return location;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_LOCATION_H
