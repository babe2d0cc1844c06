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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_SPLIT_TRIANGLES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_SPLIT_TRIANGLES_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Makes the quads of a patch from its triangles: each becomes three quads, by the middles of its edges and its
// centroid. The arcs must have two quad edges for each of their halfedges, as `points_of_triangles()` places them. The
// time is linear.
inline void split_triangles_of_patch(const Quad_layout& layout, const int patch, Quad_complex& complex)
{
  const Cut_surface& surface = layout.surface;
  const Patch& range = surface.patches[patch];
  const int first_halfedge = 3 * range.faces.begin_index;
  std::vector<int> vertex_of_sector(range.sectors.size(), -1);
  std::vector<int> middle(3 * static_cast<std::size_t>(range.faces.size()), -1);
  const auto sector_vertex = [&](const int h) -> int&
  {
    return vertex_of_sector[surface.sector[h] - range.sectors.begin_index];
  };
  const auto add_vertex = [&](const Surface_location& location)
  {
    Quad_vertex vertex;
    vertex.location = location;
    vertex.patch = patch;
    complex.vertices.push_back(vertex);
    return static_cast<int>(complex.vertices.size()) - 1;
  };

  for(int h = first_halfedge; h < 3 * range.faces.end_index; ++h)
  {
    if(!surface.is_constrained(h))
      continue;
    const int arc = layout.network.arc[h], place = layout.network.place[h];
    const std::vector<int>& vertices = complex.arcs[arc];
    const int n = static_cast<int>(vertices.size());
    const bool is_first = side_of_arc(layout.network, h) == 0;
    middle[h - first_halfedge] = vertices[2 * place + 1];
    sector_vertex(h) = vertices[(2 * place + (is_first ? 2 : 0)) % n];
    sector_vertex(previous_of(h)) = vertices[(2 * place + (is_first ? 0 : 2)) % n];
  }
  for(int h = first_halfedge; h < 3 * range.faces.end_index; ++h)
  {
    if(sector_vertex(h) < 0)
      sector_vertex(h) = add_vertex(location_on_halfedge(h, 1));
    if(middle[h - first_halfedge] < 0)
    {
      middle[h - first_halfedge] = add_vertex(location_on_halfedge(h, 0.5));
      middle[surface.opposite[h] - first_halfedge] = middle[h - first_halfedge];
    }
  }
  for(int f = range.faces.begin_index; f < range.faces.end_index; ++f)
  {
    const int centroid = add_vertex({ f, { { 1. / 3, 1. / 3, 1. / 3 } } });
    for(int h = 3 * f; h < 3 * f + 3; ++h)
    {
      complex.quads.push_back({ centroid, middle[h - first_halfedge], sector_vertex(h),
                                middle[next_of(h) - first_halfedge] });
      complex.patch.push_back(patch);
    }
  }
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_SPLIT_TRIANGLES_H
