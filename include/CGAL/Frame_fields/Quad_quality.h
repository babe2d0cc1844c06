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

#ifndef CGAL_FRAME_FIELDS_QUAD_QUALITY_H
#define CGAL_FRAME_FIELDS_QUAD_QUALITY_H

#include <cstddef>

/// \file Quad_quality.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsRef
///
/// holds the measures that `quad_mesh_quality()` computes.
///
/// The scaled Jacobian of a quad is that of the Verdict library: the least over its corners of the sine of the angle
/// there, seen along the normal of the quad's principal axes. It is 1 for rectangles and not positive for quads that
/// are not convex.
struct Quad_quality
{
  /// the number of quads
  std::size_t number_of_quads = 0;

  /// the number of faces that are not quads
  std::size_t number_of_other_faces = 0;

  /// the least scaled Jacobian of a quad; 1 if there is none
  double minimum_scaled_jacobian = 1;

  /// the mean of the scaled Jacobians of the quads; 1 if there is none
  double mean_scaled_jacobian = 1;

  /// the number of quads whose scaled Jacobian is not positive
  std::size_t number_of_inverted_quads = 0;

  /// the number of quads whose scaled Jacobian is below 0.2, also those where it is not positive
  std::size_t number_of_bad_quads = 0;

  /// the number of vertices on no constrained or border edge that do not have four faces
  std::size_t number_of_irregular_vertices = 0;

  /// the number of sectors between two constrained or border edges that follow each other around a vertex, in which the
  /// number of faces is not that of their angle: a quarter of a turn for each, rounded, and at least one
  std::size_t number_of_irregular_sectors = 0;

  /// the least length of an edge; 0 if there is none
  double minimum_edge_length = 0;

  /// the mean length of the edges
  double mean_edge_length = 0;

  /// the largest length of an edge
  double maximum_edge_length = 0;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_QUAD_QUALITY_H
