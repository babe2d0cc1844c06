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

#ifndef CGAL_FRAME_FIELDS_QUAD_BLOCK_H
#define CGAL_FRAME_FIELDS_QUAD_BLOCK_H

/// \file Quad_block.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsRef
///
/// is a rectangular grid of quads, as `quad_mesh_blocks()` finds them.
///
/// The quads along the side that starts with `halfedge` are a row. From a halfedge `h` of a quad of a row, the same one
/// of the next quad is `next(opposite(next(h, qm), qm), qm)`, and of the quad above it `opposite(next(next(h, qm),
/// qm), qm)`.
///
/// \tparam Halfedge a halfedge descriptor
template <typename Halfedge>
struct Quad_block
{
  /// a halfedge of the border of the block, with its face in it, that starts at a corner of the block
  Halfedge halfedge;

  /// the number of quads along the side of the block that starts with `halfedge`
  int number_of_columns = 0;

  /// the number of quads along the next side
  int number_of_rows = 0;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_QUAD_BLOCK_H
