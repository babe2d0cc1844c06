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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WORKING_COPY_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WORKING_COPY_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Working_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The numbers in the copy of the halfedges of a surface. Opposite halfedges get the numbers 2e and 2e + 1; the opposite
// of a border halfedge is one without a face.
inline std::vector<int> halfedges_of_copy(const Cut_surface& surface, const Surface_embedding& embedding)
{
  std::vector<int> number(surface.number_of_halfedges(), -1);
  int number_of_edges = 0;
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    if(number[h] < 0)
    {
      number[h] = 2 * number_of_edges++;
      if(embedding.twin[h] >= 0)
        number[embedding.twin[h]] = number[h] + 1;
    }
  return number;
}

// A copy of a cut mesh for refinement, in units of `length_unit`. It is not cut: constrained edges are marked. Face f
// of the copy is face f of the surface, vertex v is vertex v of the embedding. Takes time linear in the mesh and in the
// degrees of border vertices.
inline Working_mesh working_copy(const Cut_surface& surface, const Surface_embedding& embedding)
{
  typedef Working_mesh::Vertex Vertex;
  typedef Working_mesh::Halfedge Halfedge;
  typedef Working_mesh::Face Face;

  const std::vector<int> number = halfedges_of_copy(surface, embedding);
  const int number_of_edges = number.empty() ? 0 : *std::max_element(number.begin(), number.end()) / 2 + 1;

  Working_mesh mesh;
  mesh.resize(static_cast<int>(embedding.point.size()), number_of_edges, surface.number_of_faces());
  mesh.origin().start(static_cast<int>(embedding.point.size()), number_of_edges, surface.number_of_faces());
  for(std::size_t v = 0; v < embedding.point.size(); ++v)
    mesh.points()[v] = Working_mesh::Point(embedding.point[v][0], embedding.point[v][1], embedding.point[v][2]);
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    const Halfedge halfedge(number[h]);
    const Vertex v(embedding.vertex[h]);
    mesh.target(halfedge) = v;
    mesh.face(halfedge) = Face(face_of(h));
    mesh.connect(halfedge, Halfedge(number[next_of(h)]));
    if(h % 3 == 0)
      mesh.halfedge_of(Face(face_of(h))) = halfedge;
    if(mesh.halfedge_of(v).value < 0)
      mesh.halfedge_of(v) = halfedge;
    mesh.constrained_edges()[number[h] / 2] = surface.is_constrained(h);
    if(embedding.twin[h] < 0)
      mesh.target(Halfedge(number[h] + 1)) = Vertex(embedding.vertex[previous_of(h)]);
  }
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    if(embedding.twin[h] >= 0)
      continue;
    // After the opposite of h, the border goes on with the opposite of the border halfedge that ends at the source of
    // h.
    int before = previous_of(h);
    while(embedding.twin[before] >= 0)
      before = previous_of(embedding.twin[before]);
    mesh.connect(Halfedge(number[h] + 1), Halfedge(number[before] + 1));
    mesh.halfedge_of(mesh.target(Halfedge(number[h] + 1))) = Halfedge(number[h] + 1); // as the concept asks
  }
  return mesh;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WORKING_COPY_H
