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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_EMBEDDING_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_EMBEDDING_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where a cut surface lies in space, and how its patches meet at vertices and constrained edges.
struct Surface_embedding
{
  std::vector<int> vertex;         // per halfedge: the vertex at its target
  std::vector<int> twin;           // per halfedge: its opposite, also across a feature edge; -1 at the border
  std::vector<Coordinates> point;  // per vertex, in the unit of `Cut_surface::length`
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_EMBEDDING_H
