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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_FACES_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_FACES_H

#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point inside a triangle: its centroid, or some other point if the triangle has no area and its centroid is a
// vertex. Sets `weights` to those of the vertices.
template <typename Point, typename GeomTraits>
Point point_inside(const Point& p, const Point& q, const Point& r, const GeomTraits traits,
                   std::array<double, 3>& weights)
{
  const Point centroid = traits.construct_centroid_3_object()(p, q, r);
  weights = { 1. / 3, 1. / 3, 1. / 3 };
  if(centroid != p && centroid != q && centroid != r)
    return centroid;
  // That vertex is the midpoint of the two others, which no combination with three different weights gives.
  weights = { 1. / 2, 1. / 3, 1. / 6 };
  return traits.construct_barycenter_3_object()(p, 3, q, 2, r, 1);
}

// Splits each face that has more than one constrained edge in three, at a point inside. Returns the number of faces
// that were split. All faces must be triangles. Takes linear time.
template <typename TriangleMesh, typename NamedParameters>
std::size_t split_faces_of(TriangleMesh& tm, const Editable_mesh<TriangleMesh, NamedParameters>& mesh)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  // One halfedge of each face to split, collected first, since splits change the range of faces.
  std::vector<halfedge_descriptor> overconstrained;
  for(const auto f : faces(tm))
  {
    const halfedge_descriptor h = halfedge(f, tm);
    if(mesh.is_constrained(h) + mesh.is_constrained(next(h, tm)) + mesh.is_constrained(prev(h, tm)) > 1)
      overconstrained.push_back(h);
  }

  mesh.reserve_for(overconstrained.size(), 3 * overconstrained.size(), 2 * overconstrained.size());
  for(const halfedge_descriptor h : overconstrained)
  {
    const std::array<vertex_descriptor, 3> corners{ source(h, tm), target(h, tm), target(next(h, tm), tm) };
    const auto whole = face(h, tm);
    std::array<double, 3> weights;
    const auto center = point_inside(mesh.point(corners[0]), mesh.point(corners[1]), mesh.point(corners[2]),
                                     mesh.traits(), weights);
    const halfedge_descriptor to_center = CGAL::Euler::add_center_vertex(h, tm);
    mesh.set_point(target(to_center, tm), center);
    note_vertex(tm, target(to_center, tm), corners, weights);
    halfedge_descriptor spoke = to_center;
    do
    {
      mesh.mark_unconstrained(spoke);
      note_face(tm, face(spoke, tm), whole);
      spoke = opposite(next(spoke, tm), tm);
    } while(spoke != to_center);
  }
  return overconstrained.size();
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_FACES_H
