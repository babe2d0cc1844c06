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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_QUANTIZED_CELLS_H
#define CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_QUANTIZED_CELLS_H

#include <CGAL/Frame_fields/internal/integer_grid/Rigid_motion.h>
#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The cells of a T-mesh, each in two planes: one with the lengths of the seamless map, in steps of its grid, and one
// with the numbers of quad edges. Both have the first corner at the origin and side 0 along the positive x-axis.
// A directed piece is numbered 2 p if it runs as piece p does, 2 p + 1 if it runs against it.
class Quantized_cells
{
public:
  Quantized_cells(const T_mesh& t_mesh, const std::vector<int>& edges_of_piece)
    : m_cell(2 * t_mesh.pieces.size(), -1), m_side(2 * t_mesh.pieces.size(), -1), m_stop(2 * t_mesh.pieces.size(), -1)
    , m_sides(t_mesh.cells.size())
  {
    for(std::size_t cell = 0; cell < t_mesh.cells.size(); ++cell)
      for(int side = 0; side < 4; ++side)
      {
        std::vector<Stop>& stops = m_sides[cell][side];
        stops.push_back({ { 0, 0 }, -1 });
        for(const Directed_piece& directed : t_mesh.cells[cell].sides[side])
        {
          const int d = 2 * directed.piece + (directed.is_reversed ? 1 : 0);
          m_cell[d] = static_cast<int>(cell);
          m_side[d] = side;
          m_stop[d] = static_cast<int>(stops.size()) - 1;
          stops.back().directed_piece = d;
          const Offsets last = stops.back().offset;
          stops.push_back({ { last[LENGTH] + t_mesh.pieces[directed.piece].parametric_length,
                              last[COUNT] + edges_of_piece[directed.piece] }, -1 });
        }
      }
  }

  // The two planes.
  enum Measure { LENGTH, COUNT };

  // The corner of a cell opposite to the origin.
  Grid_vector size(const int cell, const Measure measure) const
  {
    return { m_sides[cell][0].back().offset[measure], m_sides[cell][1].back().offset[measure] };
  }

  int number_of_pieces(const int cell, const int side) const
  {
    return static_cast<int>(m_sides[cell][side].size()) - 1;
  }

  // The directed piece number `i` of a side, and how far it ends from the beginning of the side.
  int directed_piece(const int cell, const int side, const int i) const
  {
    return m_sides[cell][side][i].directed_piece;
  }
  std::int64_t end_of_piece(const int cell, const int side, const int i) const
  {
    return m_sides[cell][side][i + 1].offset[LENGTH];
  }

  // The cell to the left of a directed piece, -1 if there is none.
  int cell_left_of(const int directed_piece) const { return m_cell[directed_piece]; }

  // From the plane of the cell to the left of a directed piece to that of the cell to the right.
  Rigid_motion motion_across(const int directed_piece, const Measure measure) const
  {
    const int d = directed_piece, other = d ^ 1;
    const Grid_vector begin = point(m_cell[d], m_side[d], m_sides[m_cell[d]][m_side[d]][m_stop[d]].offset[measure],
                                    measure);
    const Grid_vector image = point(m_cell[other], m_side[other],
                                    m_sides[m_cell[other]][m_side[other]][m_stop[other] + 1].offset[measure], measure);
    const int turns = (m_side[other] + 2 - m_side[d]) & 3;
    return { turns, image - rotate(begin, turns) };
  }

  // Takes a point of a cell to its plane of numbers of edges: linearly along each piece of the sides, and between
  // opposite sides. On a side the distance from it, and at a node both coordinates, are exact.
  std::array<double, 2> to_counts(const int cell, const std::array<double, 2>& p) const
  {
    const Grid_vector length = size(cell, LENGTH), count = size(cell, COUNT);
    const double width = static_cast<double>(length.u), height = static_cast<double>(length.v);
    const double x = p[0] / width, y = p[1] / height;
    const double bottom = count_at(m_sides[cell][0], p[0]), right = count_at(m_sides[cell][1], p[1]);
    const double top = static_cast<double>(count.u) - count_at(m_sides[cell][2], width - p[0]);
    const double left = static_cast<double>(count.v) - count_at(m_sides[cell][3], height - p[1]);
    return { bottom + y * (top - bottom), left + x * (right - left) };
  }

private:
  typedef std::array<std::int64_t, 2> Offsets; // by measure

  struct Stop
  {
    Offsets offset;     // from the beginning of the side
    int directed_piece; // that begins here, -1 at the end of the side
  };

  // The point of a side at a distance from its beginning.
  Grid_vector point(const int cell, const int side, const std::int64_t offset, const Measure measure) const
  {
    const Grid_vector s = size(cell, measure);
    switch(side)
    {
      case 0: return { offset, 0 };
      case 1: return { s.u, offset };
      case 2: return { s.u - offset, s.v };
      default: return { 0, s.v - offset };
    }
  }

  static double count_at(const std::vector<Stop>& stops, const double length)
  {
    const auto is_before = [](const double value, const Stop& s)
    {
      return value < static_cast<double>(s.offset[LENGTH]);
    };
    const auto after = std::upper_bound(stops.begin() + 1, stops.end() - 1, length, is_before);
    const Stop &end = *after, &begin = *(after - 1);
    const double share = (length - static_cast<double>(begin.offset[LENGTH]))
                       / static_cast<double>(end.offset[LENGTH] - begin.offset[LENGTH]);
    return (1 - share) * static_cast<double>(begin.offset[COUNT]) + share * static_cast<double>(end.offset[COUNT]);
  }

  std::vector<int> m_cell, m_side, m_stop;                 // per directed piece: where it is
  std::vector<std::array<std::vector<Stop>, 4> > m_sides;  // per cell and side: its stops from corner to corner
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_QUANTIZED_CELLS_H
