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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_CELL_WALKER_H
#define CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_CELL_WALKER_H

#include <CGAL/Frame_fields/internal/integer_grid/Quantized_cells.h>
#include <CGAL/Frame_fields/internal/integer_grid/Rigid_motion.h>
#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/first_corner_of_cell.h>
#include <CGAL/Frame_fields/internal/parameterization/sign_of_determinant.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cstdint>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point of a patch, seen from a face and from a cell of the T-mesh that contain it.
struct Cell_place
{
  int face, cell;
  Rigid_motion to_cell; // from the chart of the face to the plane of the cell
  Rigid_motion counts;  // from the plane of counts of the cell where the walk began to that of this cell
};

// Walks straight inside faces from cell to cell. All comparisons are of integers: points are given in sixths of a step
// of the grid, so that midpoints of edges and centroids of faces are exact.
class Cell_walker
{
public:
  Cell_walker(const Cut_surface& surface, const Seamless_charts& charts, const T_mesh& t_mesh,
              const Quantized_cells& cells)
    : m_surface(surface), m_charts(charts), m_t_mesh(t_mesh), m_cells(cells)
  {}

  static Grid_vector sixfold(const Grid_vector& p) { return { 6 * p.u, 6 * p.v }; }

  Grid_vector centroid(const int face) const
  {
    const Grid_vector sum = m_charts.point(3 * face) + m_charts.point(3 * face + 1) + m_charts.point(3 * face + 2);
    return { 2 * sum.u, 2 * sum.v };
  }

  Grid_vector midpoint(const int halfedge) const
  {
    const Grid_vector sum = m_charts.point(halfedge) + m_charts.point(previous_of(halfedge));
    return { 3 * sum.u, 3 * sum.v };
  }

  // Where a point of the face of a place is in the plane of its cell.
  Grid_vector in_cell(const Cell_place& place, const Grid_vector& point) const
  {
    return rotate(point, place.to_cell.quarter_turns) + sixfold(place.to_cell.shift);
  }

  // The place at the first corner of a cell; `corner` is set to where it is in the chart of the face.
  Cell_place at_first_corner(const int cell, Grid_vector& corner) const
  {
    const T_mesh_cell& c = m_t_mesh.cells[cell];
    const Grid_vector origin = first_corner_of_cell(m_charts, m_t_mesh, c);
    corner = sixfold(origin);
    const int back = (4 - c.quarter_turns) & 3;
    return { c.face, cell, { back, rotate(Grid_vector{ 0, 0 } - origin, back) }, Rigid_motion() };
  }

  // Walks from a point of the face of a place to another one. Returns false if it leaves the patch or takes too long.
  bool walk(Cell_place& place, const Grid_vector& from, const Grid_vector& to) const
  {
    const int maximum_number_of_steps = 100000;
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      const Grid_vector a = in_cell(place, from), b = in_cell(place, to);
      const Exit exit = exit_of(place.cell, a, b);
      if(exit.side < 0)
        return true;
      if(!cross_piece(place, crossed_piece(place.cell, exit, a, b)))
        return false;
    }
    return false;
  }

  // Goes on into the face across an unconstrained halfedge, at the same point.
  void cross_halfedge(Cell_place& place, const int halfedge) const
  {
    place.to_cell = place.to_cell * inverse(internal::motion_across(m_charts, halfedge));
    place.face = face_of(m_surface.opposite[halfedge]);
  }

  // Changes to the cell of another place, without moving from `point`, which must be in it. This is needed where the
  // point is on the sides of several cells, at most four.
  bool change_cell(Cell_place& place, const Cell_place& other, const Grid_vector& point, const int depth = 3) const
  {
    const Grid_vector p = in_cell(place, point);
    if(place.cell == other.cell && p == in_cell(other, point))
      return true;
    if(depth == 0)
      return false;
    for(int side = 0; side < 4; ++side)
    {
      if(distance_to_side(place.cell, side, p) != 0)
        continue;
      std::int64_t begin = 0;
      for(int i = 0; i < m_cells.number_of_pieces(place.cell, side); ++i)
      {
        const std::int64_t offset = along_side(place.cell, side, p);
        const std::int64_t end = 6 * m_cells.end_of_piece(place.cell, side, i);
        Cell_place next = place;
        if(begin <= offset && offset <= end && cross_piece(next, m_cells.directed_piece(place.cell, side, i))
           && change_cell(next, other, point, depth - 1))
        {
          place = next;
          return true;
        }
        begin = end;
      }
    }
    return false;
  }

private:
  // A side over which a line leaves a cell. The distances of its ends from the side are `before`, and `behind` on the
  // other side.
  struct Exit
  {
    int side;
    std::int64_t before, behind;
  };

  // The distance inside the cell from a side.
  std::int64_t distance_to_side(const int cell, const int side, const Grid_vector& p) const
  {
    const Grid_vector size = m_cells.size(cell, Quantized_cells::LENGTH);
    switch(side)
    {
      case 0: return p.v;
      case 1: return 6 * size.u - p.u;
      case 2: return 6 * size.v - p.v;
      default: return p.u;
    }
  }

  std::int64_t along_side(const int cell, const int side, const Grid_vector& p) const
  {
    return distance_to_side(cell, (side + 3) & 3, p);
  }

  // The first side over which the way from a to b leaves the cell. At a corner this is the one that comes first
  // counter-clockwise. No side if b is in the cell.
  Exit exit_of(const int cell, const Grid_vector& a, const Grid_vector& b) const
  {
    Exit exit = { -1, 0, 0 };
    for(int side = 0; side < 4; ++side)
    {
      const std::int64_t behind = -distance_to_side(cell, side, b), before = distance_to_side(cell, side, a);
      if(behind > 0
         && (exit.side < 0
             || sign_of_determinant(before, exit.before, before + behind, exit.before + exit.behind) < 0))
        exit = { side, before, behind };
    }
    return exit;
  }

  int crossed_piece(const int cell, const Exit& exit, const Grid_vector& a, const Grid_vector& b) const
  {
    const std::int64_t at_a = along_side(cell, exit.side, a), at_b = along_side(cell, exit.side, b);
    int first = 0, last = m_cells.number_of_pieces(cell, exit.side) - 1;
    while(first < last)
    {
      const int middle = (first + last) / 2;
      const std::int64_t end = 6 * m_cells.end_of_piece(cell, exit.side, middle);
      if(sign_of_determinant(exit.before, end - at_a, exit.before + exit.behind, at_b - at_a) < 0)
        last = middle;
      else
        first = middle + 1;
    }
    return m_cells.directed_piece(cell, exit.side, first);
  }

  bool cross_piece(Cell_place& place, const int directed_piece) const
  {
    const int next_cell = m_cells.cell_left_of(directed_piece ^ 1);
    if(next_cell < 0)
      return false;
    place.to_cell = m_cells.motion_across(directed_piece, Quantized_cells::LENGTH) * place.to_cell;
    place.counts = m_cells.motion_across(directed_piece, Quantized_cells::COUNT) * place.counts;
    place.cell = next_cell;
    return true;
  }

  const Cut_surface& m_surface;
  const Seamless_charts& m_charts;
  const T_mesh& m_t_mesh;
  const Quantized_cells& m_cells;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_CELL_WALKER_H
