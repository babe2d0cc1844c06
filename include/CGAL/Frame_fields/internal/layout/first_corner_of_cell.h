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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_FIRST_CORNER_OF_CELL_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_FIRST_CORNER_OF_CELL_H

#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The first corner of a cell in the chart of `cell.face`. A node at a vertex has its coordinates in one of the faces
// there; the others see it at their own corner.
inline Grid_vector first_corner_of_cell(const Seamless_charts& charts, const T_mesh& t_mesh, const T_mesh_cell& cell)
{
  const Directed_piece& first = cell.sides[0].front();
  const T_mesh_piece& piece = t_mesh.pieces[first.piece];
  const T_mesh_node& node = t_mesh.nodes[first.is_reversed ? piece.target : piece.source];
  if(node.face != cell.face && node.sector >= 0)
    for(int h = 3 * cell.face; h < 3 * cell.face + 3; ++h)
      if(charts.surface().sector[h] == node.sector)
        return charts.point(h);
  return { node.u, node.v };
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_FIRST_CORNER_OF_CELL_H
