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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCK_PARTITION_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCK_PARTITION_H

#include <CGAL/Frame_fields/T_junctions.h>
#include <CGAL/Frame_fields/internal/quads/Block_lines.h>
#include <CGAL/Frame_fields/internal/quads/measure_quads.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The quads between the lines of a quad mesh, as rectangular grids.
class Block_partition
{
public:
  struct Block
  {
    int first_face = 0, number_of_faces = 0; // in `m_faces`
    int corner = -1;                         // the first one of a quad that is one of the block
    int number_of_corners = 0;
    int columns = 0, rows = 0;               // along the side that starts at the corner, and along the next one
  };

  // All faces must be quads. Takes linear time; a torus or an annulus without a corner takes it once more.
  Block_partition(const Polygon_mesh& mesh, const T_junctions t_junctions)
    : m_mesh(mesh)
    , m_lines(mesh, t_junctions)
  {
    do
      find_components();
    while(cut_components_without_corner());
    for(Block& block : m_blocks)
    {
      block.columns = length_of_side(block.corner);
      block.rows = length_of_side(m_end_of_side);
    }
  }

  const std::vector<Block>& blocks() const { return m_blocks; } // in the order of their first faces
  const std::vector<int>& block_of_faces() const { return m_block; }
  bool is_line(const int c) const { return m_lines.is_line(c); }

  // A face of a block that is no grid, or -1. There is none unless the halfedges of the mesh contradict one another.
  int wrong_face() const
  {
    for(const Block& block : m_blocks)
      if(block.number_of_corners != 4 || block.columns != block.number_of_faces / block.rows
         || block.number_of_faces % block.rows != 0)
        return m_faces[block.first_face];
    return -1;
  }

private:
  // Numbers the components between lines in the order of their first faces.
  void find_components()
  {
    m_block.assign(m_mesh.number_of_faces(), -1);
    m_faces.clear();
    m_blocks.clear();
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      if(m_block[f] < 0)
      {
        Block block;
        block.first_face = static_cast<int>(m_faces.size());
        visit(f);
        for(std::size_t i = block.first_face; i < m_faces.size(); ++i)
          visit_neighbors(m_faces[i], block);
        block.number_of_faces = static_cast<int>(m_faces.size()) - block.first_face;
        m_blocks.push_back(block);
      }
  }

  void visit(const int f)
  {
    m_block[f] = static_cast<int>(m_blocks.size());
    m_faces.push_back(f);
  }

  void visit_neighbors(const int f, Block& block)
  {
    for(int c = m_mesh.first_corner[f]; c < m_mesh.first_corner[f + 1]; ++c)
    {
      if(m_lines.is_corner(c))
      {
        ++block.number_of_corners;
        if(block.corner < 0)
          block.corner = c;
      }
      if(!m_lines.is_line(c) && m_block[m_mesh.face[m_mesh.opposite[c]]] < 0)
        visit(m_mesh.face[m_mesh.opposite[c]]);
    }
  }

  // Returns whether there was one.
  bool cut_components_without_corner()
  {
    bool has_cut = false;
    for(const Block& block : m_blocks)
      if(block.number_of_corners == 0)
      {
        has_cut = true;
        const std::pair<int, bool> place = place_to_cut(block);
        if(!place.second)
          m_lines.cut(place.first);
      }
    return has_cut;
  }

  // A corner on the border of a component, or any one if it has no border; and whether it has been cut meanwhile.
  std::pair<int, bool> place_to_cut(const Block& block) const
  {
    int place = -1;
    for(int i = block.first_face; i < block.first_face + block.number_of_faces; ++i)
      for(int c = m_mesh.first_corner[m_faces[i]]; c < m_mesh.first_corner[m_faces[i] + 1]; ++c)
      {
        if(m_lines.is_corner(c))
          return { c, true };
        if(place < 0 && m_lines.is_line(c))
          place = c;
      }
    return { place < 0 ? m_mesh.first_corner[m_faces[block.first_face]] : place, false };
  }

  // The number of quads along a side of a block, from its corner `c` on; sets the corner where it ends.
  int length_of_side(int c)
  {
    int length = 1;
    for(; !m_lines.is_line(m_mesh.next(c)); ++length)
      c = m_mesh.next(m_mesh.opposite[m_mesh.next(c)]);
    m_end_of_side = m_mesh.next(c);
    return length;
  }

  const Polygon_mesh& m_mesh;
  Block_lines m_lines;
  std::vector<int> m_block; // per face
  std::vector<int> m_faces; // by block
  std::vector<Block> m_blocks;
  int m_end_of_side = -1;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCK_PARTITION_H
