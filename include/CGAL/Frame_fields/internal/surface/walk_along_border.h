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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WALK_ALONG_BORDER_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WALK_ALONG_BORDER_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The constrained halfedge that follows the constrained `halfedge` on the border of its patch, at a dangling end the
// other halfedge of its edge. The cost is the number of corners between them.
inline int next_on_border(const Cut_surface& surface, const int halfedge)
{
  return next_of(clockwise_most_corner(surface.opposite, halfedge));
}

// The constrained halfedge that precedes the constrained `halfedge` on the border of its patch, at the same cost.
inline int previous_on_border(const Cut_surface& surface, const int halfedge)
{
  int corner = previous_of(halfedge);
  while(!surface.is_constrained(corner))
    corner = previous_of(surface.opposite[corner]);
  return corner;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WALK_ALONG_BORDER_H
