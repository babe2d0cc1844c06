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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COPLANAR_FLIPS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COPLANAR_FLIPS_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <deque>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Flips edges inside planes until the triangles there are Delaunay. A flip puts the other diagonal of two triangles in
// the place of their common edge. It moves the surface by no more than the distance of the two diagonals.
template <typename TriangleMesh, typename NamedParameters>
class Coplanar_flips
{
public:
  typedef Editable_mesh<TriangleMesh, NamedParameters> Mesh;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;

  // `unit` is a power of two with which no coordinate of a vector is large or tiny; `tolerance` is a length.
  Coplanar_flips(TriangleMesh& tm, const Mesh& mesh, const double unit, const double tolerance)
    : m_mesh(tm), m_editable(mesh), m_unit(unit), m_tolerance(tolerance / unit)
  {}

  // Flips edges among the given ones, and others that come to want it; all that may want it are given. No flip makes an
  // edge longer than `maximum_edge_length`. Calls `changed(h)` for each flipped edge and returns their number. Flips
  // make the angles lexicographically larger, but rounding could keep that from ending, and in a plane it may take the
  // square of the number of edges, so that there is a bound.
  template <typename Changed>
  std::size_t operator()(std::deque<halfedge_descriptor> waiting, const double maximum_edge_length,
                         const Changed& changed) const
  {
    const std::size_t flips_per_edge = 8, maximum_number = flips_per_edge * waiting.size();
    std::size_t number = 0;
    while(!waiting.empty() && number < maximum_number)
    {
      const halfedge_descriptor h = waiting.front();
      waiting.pop_front();
      if(!is_flip_wanted(h, maximum_edge_length / m_unit))
        continue;
      CGAL::Euler::flip_edge(h, m_mesh);
      note_flip(m_mesh, h);
      ++number;
      changed(h);
      for(const halfedge_descriptor side : { h, opposite(h, m_mesh) })
        for(const halfedge_descriptor around : { next(side, m_mesh), prev(side, m_mesh) })
          waiting.push_back(around);
    }
    return number;
  }

  // Tells whether the triangles of an edge lie in a plane, and it is not constrained.
  bool is_in_plane(const halfedge_descriptor h) const
  {
    return !m_editable.is_constrained(h) && are_coplanar(vectors_of(h));
  }

private:
  // Between the ends p and q of an edge, and r on the left and s on the right of it.
  struct Vectors
  {
    Coordinates pq, rs, rp, rq, sp, sq;
  };

  Coordinates vector(const Coordinates& from, const Coordinates& to) const
  {
    return to / m_unit - from / m_unit;
  }

  Vectors vectors_of(const halfedge_descriptor h) const
  {
    const Coordinates p = m_editable.coordinates(source(h, m_mesh)), q = m_editable.coordinates(target(h, m_mesh));
    const Coordinates r = m_editable.coordinates(target(next(h, m_mesh), m_mesh));
    const Coordinates s = m_editable.coordinates(target(next(opposite(h, m_mesh), m_mesh), m_mesh));
    return { vector(p, q), vector(r, s), vector(r, p), vector(r, q), vector(s, p), vector(s, q) };
  }

  bool is_flip_wanted(const halfedge_descriptor h, const double maximum_length) const
  {
    if(m_editable.is_constrained(h))
      return false;
    const Vectors v = vectors_of(h);
    const halfedge_descriptor to_r = next(h, m_mesh), to_s = next(opposite(h, m_mesh), m_mesh);
    return is_angle_sum_above_pi(v)
        && length_factor(m_mesh, target(to_r, m_mesh), target(to_s, m_mesh)) * length(v.rs) <= maximum_length
        && is_convex(v) && are_coplanar(v) && !are_neighbors(to_r, to_s);
  }

  // The angles are those at r and s; their sum is known by its sine. The margin keeps the diagonals of a rectangle as
  // they are.
  static bool is_angle_sum_above_pi(const Vectors& v)
  {
    const double margin = 1e-10;
    const double scale = length(v.rp) * length(v.rq) * length(v.sq) * length(v.sp);
    return length(cross(v.rp, v.rq)) * dot(v.sq, v.sp) + length(cross(v.sq, v.sp)) * dot(v.rp, v.rq) < -margin * scale;
  }

  // Both new triangles lie on the side of the old ones.
  static bool is_convex(const Vectors& v)
  {
    const Coordinates normal = cross(v.rs, v.pq);
    return dot(normal, cross(v.rp, v.rs)) > 0 && dot(normal, cross(v.rs, v.rq)) > 0;
  }

  // The lines of the diagonals come within the tolerance. Of the vectors between them, the shortest one is the least
  // sensitive to the rounding of the normal, which is large for narrow triangles.
  bool are_coplanar(const Vectors& v) const
  {
    const Coordinates normal = cross(v.rs, v.pq);
    Coordinates shortest = v.rp;
    for(const Coordinates& other : { v.rq, v.sp, v.sq })
      if(dot(other, other) < dot(shortest, shortest))
        shortest = other;
    return std::abs(dot(normal, shortest)) <= m_tolerance * length(normal);
  }

  // Tells whether an edge joins the targets of two halfedges. It turns around both at the same time, so that a vertex
  // with many edges costs no more than the other one.
  bool are_neighbors(const halfedge_descriptor to_r, const halfedge_descriptor to_s) const
  {
    halfedge_descriptor around_r = to_r, around_s = to_s;
    do
    {
      if(source(around_r, m_mesh) == target(to_s, m_mesh) || source(around_s, m_mesh) == target(to_r, m_mesh))
        return true;
      around_r = opposite(next(around_r, m_mesh), m_mesh);
      around_s = opposite(next(around_s, m_mesh), m_mesh);
    } while(around_r != to_r && around_s != to_s);
    return false;
  }

  TriangleMesh& m_mesh;
  const Mesh& m_editable;
  double m_unit, m_tolerance;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COPLANAR_FLIPS_H
