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
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The cells of a T-mesh. Each is found as the loop of the pieces that have the cell to their left.
//
// A cell has no singular sector inside, and at each of its nodes its boundary turns left or goes straight on. By the
// theorem of Gauss and Bonnet, the number of its corners is four times its Euler characteristic. So a cell with corners
// is a disk with four corners.
class T_mesh_cells
{
public:
  T_mesh_cells(const Seamless_charts& charts, const T_mesh_graph& graph) : m_charts(charts), m_graph(graph) {}

  // Returns false if a cell has not exactly four corners, or opposite sides of different lengths.
  bool build()
  {
    const int number_of_directed_pieces = 2 * static_cast<int>(m_graph.pieces().size());
    std::vector<char> is_visited(number_of_directed_pieces, 0);
    for(int first = 0; first < number_of_directed_pieces; ++first)
    {
      if(is_visited[first] || is_outside(first))
        continue;
      m_loop.clear();
      int piece = first;
      do
      {
        int quarter_turns = 0;
        is_visited[piece] = 1;
        const int next_piece = next(piece, quarter_turns);
        if(next_piece < 0 || (is_visited[next_piece] && next_piece != first))
          return false;
        m_loop.emplace_back( piece, quarter_turns == 1 );
        piece = next_piece;
      } while(piece != first);
      if(!add_cell())
        return false;
    }
    return true;
  }

  std::vector<T_mesh_cell>& cells() { return m_cells; }

private:
  // A piece of the border has a cell on one side only.
  bool is_outside(const int directed_piece) const
  {
    return directed_piece % 2 == 1 && m_graph.pieces()[directed_piece / 2].halfedge >= 0;
  }

  // The piece that follows with the same cell to the left, and how many quarter turns of the cell are between the two:
  // 1 at a corner, 2 where they are straight. Returns -1 if there is none such.
  int next(const int directed_piece, int& quarter_turns) const
  {
    const int reversed = directed_piece ^ 1, node = m_graph.source(reversed);
    const int slots = m_graph.number_of_slots(node);
    int slot = m_graph.slot(reversed);
    for(quarter_turns = 1; quarter_turns <= 2; ++quarter_turns)
    {
      --slot;
      if(slot < 0 && m_graph.nodes().is_on_border(node))
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
      if(m_loop[i].second)
        corners.push_back((i + 1) % size);
    if(corners.size() != 4)
      return false;

    T_mesh_cell cell;
    std::array<std::int64_t, 4> length = {};
    for(int side = 0; side < 4; ++side)
    {
      std::size_t i = corners[side];
      do
      {
        const int piece = m_loop[i].first;
        cell.sides[side].push_back({ piece / 2, piece % 2 == 1 });
        length[side] += m_graph.pieces()[piece / 2].parametric_length;
        i = (i + 1) % size;
      } while(i != corners[(side + 1) % 4]);
    }
    const bool is_found = find_start(m_loop[corners[0]].first, cell);
    m_cells.push_back(cell);
    return is_found && length[0] == length[2] && length[1] == length[3];
  }

  // The face into which, or along which, the first side starts.
  bool find_start(const int directed_piece, T_mesh_cell& cell) const
  {
    const T_mesh_node& node = m_graph.nodes().nodes()[m_graph.source(directed_piece)];
    const int slot = m_graph.slot(directed_piece), halfedge_of_piece = m_graph.pieces()[directed_piece / 2].halfedge;
    if(halfedge_of_piece >= 0 || node.halfedge >= 0)
    {
      const int halfedge = halfedge_of_piece >= 0 ? halfedge_of_piece : node.halfedge;
      cell.face = face_of(halfedge);
      cell.quarter_turns = (m_charts.direction_of(halfedge) + slot) & 3;
      return true;
    }
    if(node.sector < 0)
    {
      const Grid_ray ray = { slot, { node.u, node.v } };
      cell.face = m_charts.face_ahead(node.face, ray, cell.quarter_turns);
      return cell.face >= 0;
    }
    for(const Port& port : m_charts.ports(node.sector))
      if(port.slot == slot)
      {
        cell.face = face_of(port.corner);
        cell.quarter_turns = port.direction;
        return true;
      }
    return false;
  }

  const Seamless_charts& m_charts;
  const T_mesh_graph& m_graph;
  std::vector<T_mesh_cell> m_cells;
  std::vector<std::pair<int, bool> > m_loop; // directed pieces, and whether there is a corner at the end
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_T_MESH_CELLS_H
