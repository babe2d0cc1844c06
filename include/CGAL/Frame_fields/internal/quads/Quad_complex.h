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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_COMPLEX_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_COMPLEX_H

#include <CGAL/Frame_fields/internal/surface/Surface_location.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// What a vertex of a quad mesh may do on the surface.
struct Quad_vertex
{
  Surface_location location;
  int vertex = -1;      // the vertex of the triangle mesh that it is at and stays at, -1 if there is none
  int arc = -1;         // the feature arc on which it slides, -1 if there is none
  double position = 0;  // on an arc: the place of a halfedge in the arc plus the fraction of it that lies behind
  int patch = -1;       // the patch in which it slides, if it is neither at a vertex nor on an arc
};

// A quad mesh on a surface. The quads run counter-clockwise as the faces of the surface do.
struct Quad_complex
{
  std::vector<Quad_vertex> vertices;
  std::vector<std::array<int, 4> > quads;
  std::vector<int> patch;                  // per quad
  std::vector<std::vector<int> > arcs;     // per feature arc: its vertices in order; those of a loop only once
  std::vector<char> is_loop;               // per feature arc
  std::vector<char> has_free_bends;        // per feature arc: whether not every bend has a vertex that stays there
};

// Puts `number[v]` in the place of each vertex v of quads and arcs.
inline void renumber_vertices(const std::vector<int>& number, Quad_complex& complex)
{
  for(std::array<int, 4>& quad : complex.quads)
    for(int& v : quad)
      v = number[v];
  for(std::vector<int>& arc : complex.arcs)
    for(int& v : arc)
      v = number[v];
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_COMPLEX_H
