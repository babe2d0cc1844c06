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

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_LOCATION_H
