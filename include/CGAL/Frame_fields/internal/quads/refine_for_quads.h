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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_REFINE_FOR_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_REFINE_FOR_QUADS_H

#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Working_mesh.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>
#include <CGAL/Frame_fields/internal/surface/refine_working_copy.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Splits the triangles of a copy of a mesh that are longer than two quads. Fields and maps are linear in triangles, so
// quads follow them well only where the triangles are not much larger. `surface` and `request` are those of the mesh.
template <typename NamedParameters>
void refine_for_quads(Working_mesh& copy, const NamedParameters& np, const Cut_surface& surface,
                      const Quad_request& request)
{
  const double maximum_number_of_edges_per_triangle = 2;
  const double faces_per_face = 8, faces_per_quad = 4; // bounds of the number of faces
  const double number_of_quads = surface_area(surface) / request.edge_length / request.edge_length;
  const bool may_flip = surface.index_target.empty(); // sectors with targets keep their faces
  refine_working_copy(copy, np, 1 / surface.length_unit, maximum_number_of_edges_per_triangle * request.edge_length,
                      faces_per_face * surface.number_of_faces() + faces_per_quad * number_of_quads, may_flip);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_REFINE_FOR_QUADS_H
