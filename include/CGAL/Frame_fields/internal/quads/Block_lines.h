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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCK_LINES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCK_LINES_H

#include <CGAL/Frame_fields/T_junctions.h>
#include <CGAL/Frame_fields/internal/quads/measure_quads.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The lines that bound the blocks of a quad mesh: borders and constrained edges, and lines that start where the mesh is
// not regular and go straight on, one edge of each after the other, to borders and constrained edges. If T-junctions
// may be everywhere, they also end where another line has been before. If they may be nowhere, lines start in all other
// directions where one ends, so that blocks meet along whole sides. All corners between lines are convex.
class Block_lines
{
public:
  Block_lines(const Polygon_mesh& mesh, const T_junctions t_junctions)
    : m_mesh(mesh)
    , m_t_junctions(t_junctions)
    , m_is_line(mesh.vertex.size())
    , m_kind(mesh.point.size(), Kind::INNER)
  {
    for(int c = 0; c < mesh.number_of_corners(); ++c)
      m_is_line[c] = !mesh.is_inner(c);
    read_sectors();
    if(t_junctions == T_junctions::NONE)
      for(int c = 0; c < mesh.number_of_corners(); ++c)
        if(m_kind[mesh.vertex[c]] == Kind::NODE)
          start(c);
    advance();
  }

  // Whether the side that leaves a corner is on a line.
  bool is_line(const int c) const { return m_is_line[c]; }
  // Whether the corner is one of a block.
  bool is_corner(const int c) const { return m_is_line[c] && m_is_line[m_mesh.previous(c)]; }

  // Cuts a component between lines that has no corner. It is a torus, and is cut in all directions from the vertex of
  // `c`, or an annulus between constrained edges or borders, and is cut from the vertex of `c`, whose side is on one.
  // Other lines do not bound it: where one starts, the next one in the same sector is on the other side.
  void cut(const int c)
  {
    if(m_is_line[c] && m_t_junctions != T_junctions::NONE)
      start(m_mesh.opposite[m_mesh.previous(c)]);
    else
      start_around(c);
    advance();
  }

private:
  enum class Kind : char
  {
    INNER, // in four quads and on no constrained edge
    SIDE,  // on two edges that are constrained or at the border and have two quads on each side that is not outside; if
           // T-junctions may be everywhere, also where a line has been
    NODE   // all others
  };

  // Finds the kinds of vertices. Where there may be T-junctions, lines start in irregular sectors only.
  void read_sectors()
  {
    std::vector<char> is_visited(m_mesh.vertex.size(), false);
    std::vector<int> number_of_parts(m_mesh.point.size(), 0); // 2 around regular vertices
    for(const bool is_closed : { false, true })
      for(int c = 0; c < m_mesh.number_of_corners(); ++c)
      {
        if(is_visited[c] || (!is_closed && m_mesh.is_inner(c)))
          continue;
        const std::vector<int> sector = corners_of_sector(c, is_visited);
        const bool is_regular = sector.size() == (is_closed ? 4 : 2), is_beside_gap = m_mesh.opposite[c] < 0;
        Kind& kind = m_kind[m_mesh.vertex[c]];
        kind = !is_regular || kind == Kind::NODE ? Kind::NODE : is_closed ? Kind::INNER : Kind::SIDE;
        number_of_parts[m_mesh.vertex[c]] += is_closed || is_beside_gap ? 2 : 1;
        if(m_t_junctions != T_junctions::NONE && !is_regular)
          for(const int corner : sector)
            start(corner);
      }
    for(std::size_t v = 0; v < m_kind.size(); ++v)
      if(number_of_parts[v] != 2)
        m_kind[v] = Kind::NODE;
  }

  std::vector<int> corners_of_sector(const int first, std::vector<char>& is_visited) const
  {
    std::vector<int> corners;
    for(int c = first; !is_visited[c]; c = m_mesh.counter_clockwise(c))
    {
      is_visited[c] = true;
      corners.push_back(c);
      if(!m_mesh.is_inner(m_mesh.previous(c)))
        break;
    }
    return corners;
  }

  void start(const int c)
  {
    if(m_mesh.is_inner(c))
      m_next.push_back(c);
  }

  // In all directions from the vertex of a corner; at the border of the mesh, from the corner's face on.
  void start_around(const int first)
  {
    int c = first;
    do
    {
      start(c);
      c = m_mesh.counter_clockwise(c);
    }
    while(c >= 0 && c != first);
  }

  // Moves all lines on until they end.
  void advance()
  {
    for(std::size_t i = 0; i < m_next.size(); ++i)
    {
      const int c = m_next[i];
      if(m_is_line[c])
        continue;
      m_is_line[c] = m_is_line[m_mesh.opposite[c]] = true;
      const int end = m_mesh.next(c);
      Kind& kind = m_kind[m_mesh.vertex[end]];
      if(kind == Kind::INNER)
      {
        m_next.push_back(m_mesh.next(m_mesh.opposite[end]));
        if(m_t_junctions == T_junctions::EVERYWHERE)
          kind = Kind::SIDE;
      }
      else if(kind == Kind::SIDE && m_t_junctions == T_junctions::NONE)
      {
        kind = Kind::NODE;
        start_around(end);
      }
    }
    m_next.clear();
  }

  const Polygon_mesh& m_mesh;
  T_junctions m_t_junctions;
  std::vector<char> m_is_line;   // per corner
  std::vector<Kind> m_kind;      // per vertex
  std::vector<int> m_next;       // corners whose sides are the next ones of lines, in the order of their turns
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCK_LINES_H
