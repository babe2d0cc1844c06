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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_GRID_QUAD_MATCHING_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_GRID_QUAD_MATCHING_H

#include <CGAL/Frame_fields/internal/integer_grid/Grid_quad_extraction.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/quad_connectivity.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Looks for an isomorphism from the quads of the integer-grid map of a patch to those assembled from its T-mesh.
class Grid_quad_matching
{
public:
  // The quads of the patch are those from `first_quad` to `end_quad` of the complex.
  Grid_quad_matching(const Grid_quads& grid, const Quad_complex& complex, const Quad_connectivity& connectivity,
                     const int first_quad, const int end_quad)
    : m_grid(grid), m_complex(complex), m_connectivity(connectivity), m_first_quad(first_quad), m_end_quad(end_quad)
  {}

  // Tries to match a side of the grid with all sides of the complex that begin at `vertex`. `fits(g, v)` tells whether
  // a vertex g of the grid may be the vertex v of the complex.
  template <typename Fits>
  bool match(const int grid_side, const int vertex, const Fits& fits)
  {
    if(static_cast<int>(m_grid.quads.size()) != m_end_quad - m_first_quad)
      return false;
    for(int side = 4 * m_first_quad; side < 4 * m_end_quad; ++side)
      if(side_source(m_complex, side) == vertex && match_sides(grid_side, side, fits))
        return true;
    return false;
  }

  // Per vertex of the grid: the vertex of the complex.
  const std::vector<int>& vertex_image() const { return m_vertex_image; }

private:
  // Goes from quad to quad. Two quads match in all or none of their sides, so one side tells the others.
  template <typename Fits>
  bool match_sides(const int grid_side, const int side, const Fits& fits)
  {
    m_vertex_image.assign(m_grid.location.size(), -1);
    m_side_image.assign(4 * m_grid.quads.size(), -1);
    std::vector<char> is_image(m_grid.quads.size(), 0);
    std::vector<int> queue;
    const auto pair = [&](int g, int s)
    {
      if(m_side_image[g] >= 0 || is_image[s / 4 - m_first_quad])
        return m_side_image[g] == s;
      is_image[s / 4 - m_first_quad] = 1;
      queue.push_back(g / 4);
      for(int k = 0; k < 4; ++k, g = next_side(g), s = next_side(s))
      {
        m_side_image[g] = s;
        const int v = m_grid.quads[g / 4][g % 4];
        int& image = m_vertex_image[v];
        if((image >= 0 && image != side_source(m_complex, s)) || !fits(v, side_source(m_complex, s)))
          return false;
        image = side_source(m_complex, s);
      }
      return true;
    };
    if(!pair(grid_side, side))
      return false;
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(int g = 4 * queue[i]; g < 4 * queue[i] + 4; ++g)
      {
        const int s = m_side_image[g];
        if(m_grid.opposite[g] < 0 ? !is_on_arcs(s) : !is_inside(s) || !pair(m_grid.opposite[g], opposite(s)))
          return false;
      }
    return queue.size() == m_grid.quads.size();
  }

  int opposite(const int side) const { return m_connectivity.opposite[side]; }

  bool is_inside(const int side) const
  {
    return opposite(side) >= 4 * m_first_quad && opposite(side) < 4 * m_end_quad;
  }

  bool is_on_arcs(const int side) const
  {
    return m_complex.vertices[side_source(m_complex, side)].patch < 0
        && m_complex.vertices[side_target(m_complex, side)].patch < 0;
  }

  const Grid_quads& m_grid;
  const Quad_complex& m_complex;
  const Quad_connectivity& m_connectivity;
  int m_first_quad, m_end_quad;
  std::vector<int> m_vertex_image;
  std::vector<int> m_side_image; // per side of the grid
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_GRID_QUAD_MATCHING_H
