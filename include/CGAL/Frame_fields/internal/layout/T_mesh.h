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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_H

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point where pieces of a T-mesh end. It has integer coordinates in the chart of a face that contains it.
struct T_mesh_node
{
  int face;
  std::int64_t u, v;
  int sector;    // the sector of the vertex it is at, -1 elsewhere
  int halfedge;  // the constrained halfedge whose inside it is on, -1 elsewhere
};

// A straight part of a trace, or of the border of the patch, between two nodes that follow each other.
struct T_mesh_piece
{
  int source, target;             // nodes
  std::int64_t parametric_length; // positive
  double length;                  // in space, in the unit of `Cut_surface::length`
  int halfedge;                   // the constrained halfedge on which a piece of the border begins; it runs the way of
                                  // the halfedge. -1 inside the patch
};

// A piece as it is passed along the boundary of a cell.
struct Directed_piece
{
  int piece;
  bool is_reversed;
};

// A rectangle in the plane of (u, v). Its four sides run counter-clockwise, side 0 from the first corner.
struct T_mesh_cell
{
  std::array<std::vector<Directed_piece>, 4> sides;
  int face;           // a face at the first corner, in which side 0 begins and which is to the left of it there
  int quarter_turns;  // side 0 runs into the direction (1, 0), turned as often, in the chart of that face
};

// The cells of one patch. Their interiors are disjoint and cover it; opposite sides have the same parametric length.
struct T_mesh
{
  std::vector<T_mesh_node> nodes;
  std::vector<T_mesh_piece> pieces;
  std::vector<T_mesh_cell> cells;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_H
