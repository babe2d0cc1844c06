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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_CELLS_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_CELLS_H

#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh_graph.h>
#include <CGAL/Frame_fields/internal/layout/Trace.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The cells of a T-mesh, as the loops of its pieces that have the cell to their left.
//
// A cell has no singular sector inside and turns to the left or not at all at each of its nodes. By the theorem of
// Gauss and Bonnet the number of its corners is four times its Euler characteristic: it is a disk with four corners, or
// an annulus both loops of which have none.
class T_mesh_cells
{
public:
  T_mesh_cells(const Seamless_charts& charts, T_mesh_graph& graph) : m_charts(charts), m_graph(graph) {}

  // Adds the cells that are disks to the T-mesh. Returns false if a loop has another number of corners than 0 or 4, or
  // opposite sides of different lengths.
  bool build()
  {
    const int number_of_directed_pieces = 2 * static_cast<int>(m_graph.mesh().pieces.size());
    std::vector<char> is_visited(number_of_directed_pieces, 0);
    for(int first = 0; first < number_of_directed_pieces; ++first)
    {
      if(is_visited[first] || is_outside(first))
        continue;
      m_loop.clear();
      m_starts_side.clear();
      int piece = first;
      do
      {
        int turn = 0;
        is_visited[piece] = 1;
        m_loop.push_back(piece);
        piece = next(piece, turn);
        if(piece < 0 || (is_visited[piece] && piece != first))
          return false;
        m_starts_side.push_back(turn == 1); // of the next piece
      } while(piece != first);
      if(!add_cell())
        return false;
    }
    return true;
  }

  // The first piece of a loop without corner, in the coding of `T_mesh_graph::directed_piece()`; -1 if there is none.
  int loop_without_corner() const { return m_loop_without_corner; }

private:
  // A piece of the border has a cell on one side only.
  bool is_outside(const int directed_piece) const
  {
    return directed_piece % 2 == 1 && m_graph.mesh().pieces[directed_piece / 2].halfedge >= 0;
  }

  // The piece that follows with the same cell to the left, and by how many quarter turns that cell is wide between
  // them: 1 at a corner, 2 where they are straight. Returns -1 if there is none such.
  int next(const int directed_piece, int& turn) const
  {
    const int reversed = directed_piece ^ 1, node = m_graph.source(reversed);
    const int slots = m_graph.number_of_slots(node);
    int slot = m_graph.slot(reversed);
    for(turn = 1; turn <= 2; ++turn)
    {
      --slot;
      if(slot < 0 && m_graph.is_on_border(node))
        return -1;
      slot = (slot + slots) % slots;
      if(m_graph.directed_piece(node, slot) >= 0)
        return m_graph.directed_piece(node, slot);
    }
    return -1;
  }

  bool add_cell()
  {
    const std::size_t size = m_loop.size();
    std::vector<std::size_t> corners; // the places of the first pieces of the sides
    for(std::size_t i = 0; i < size; ++i)
      if(m_starts_side[(i + size - 1) % size])
        corners.push_back(i);
    if(corners.empty() && m_loop_without_corner < 0)
      m_loop_without_corner = m_loop[0];
    if(corners.size() != 4)
      return corners.empty();

    T_mesh_cell cell;
    std::array<std::int64_t, 4> length = {};
    for(int side = 0; side < 4; ++side)
      for(std::size_t i = corners[side]; i % size != corners[(side + 1) % 4]; ++i)
      {
        const int piece = m_loop[i % size];
        cell.sides[side].push_back({ piece / 2, piece % 2 == 1 });
        length[side] += m_graph.mesh().pieces[piece / 2].parametric_length;
      }
    if(length[0] != length[2] || length[1] != length[3])
      return false;
    const bool is_found = find_start(m_loop[corners[0]], cell);
    m_graph.mesh().cells.push_back(cell);
    return is_found;
  }

  bool find_start(const int directed_piece, T_mesh_cell& cell) const
  {
    const T_mesh_location& location = m_graph.location(m_graph.source(directed_piece));
    const int slot = m_graph.slot(directed_piece);
    const int border_halfedge = m_graph.mesh().pieces[directed_piece / 2].halfedge;
    if(border_halfedge >= 0 || location.halfedge >= 0)
    {
      const int halfedge = border_halfedge >= 0 ? border_halfedge : location.halfedge;
      cell.face = face_of(halfedge);
      cell.quarter_turns = (m_charts.direction_of(halfedge) + slot) & 3;
      return true;
    }
    if(location.sector < 0)
    {
      const Departure departure = m_charts.depart(location.face, { slot, location.point });
      cell.face = departure.face;
      cell.quarter_turns = departure.ray.direction;
      return departure.face >= 0;
    }
    for(const Port& port : m_charts.ports(location.sector))
      if(port.slot == slot)
      {
        cell.face = face_of(port.corner);
        cell.quarter_turns = port.direction;
        return true;
      }
    return false;
  }

  const Seamless_charts& m_charts;
  T_mesh_graph& m_graph;
  std::vector<int> m_loop;           // the directed pieces of a loop
  std::vector<char> m_starts_side;   // whether the piece after this one starts a side
  int m_loop_without_corner = -1;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_CELLS_H
