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

// The halfedges of the copy that the halfedges of a surface become. They get numbers in pairs, those of the border a
// partner without face.
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

// A copy of a cut mesh, in the length unit of the surface, that may be refined. Face f of the copy is face f of the
// surface, vertex v is vertex v of the embedding.
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
    // The border goes on with the partner of the border halfedge that ends where this partner does.
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
