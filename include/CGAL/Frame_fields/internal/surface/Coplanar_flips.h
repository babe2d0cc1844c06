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

// Flips edges inside planes until the triangles there are Delaunay, or until a bound on the number of flips is reached.
// A flip replaces the common edge of two triangles by the other diagonal of their quadrangle. It moves the surface by
// no more than the distance between the two diagonals.
template <typename TriangleMesh, typename NamedParameters>
class Coplanar_flips
{
public:
  typedef Editable_mesh<TriangleMesh, NamedParameters> Mesh;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;
  typedef typename Mesh::vertex_descriptor vertex_descriptor;

  // All vectors are divided by `unit`, a power of two near the largest coordinate, so that products of them do not
  // overflow. `tolerance` is the largest distance between the diagonals of a flip, in units of the mesh; no edge is
  // flipped if it is negative.
  Coplanar_flips(TriangleMesh& tm, const Mesh& mesh, const double unit, const double tolerance)
    : m_mesh(tm), m_editable(mesh), m_unit(unit), m_tolerance(tolerance / unit)
  {}

  // Flips the edges in `waiting` that are not Delaunay, and then those around them that a flip makes so. `waiting` must
  // hold every edge that may need a flip. No flip makes an edge longer than `maximum_edge_length`, as `length_factor()`
  // counts lengths. Calls `changed(h)` for each flipped edge and returns their number. Each flip makes the sorted
  // angles lexicographically larger, so exact flips would end. Rounding could keep them from ending, and a plane may
  // need as many flips as the square of its edges; hence there are at most 8 for each entry of `waiting`.
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

  // Tells whether an edge is unconstrained and its two triangles lie in one plane.
  bool is_in_plane(const halfedge_descriptor h) const
  {
    return !m_editable.is_constrained(h) && are_coplanar(vectors_of(h));
  }

private:
  // The vectors between the source p and the target q of a halfedge, the apex r to its left and the apex s to its
  // right.
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

  // The sum of the angles at r and s exceeds pi where its sine is negative. The margin keeps rounding from flipping the
  // diagonal of a rectangle.
  static bool is_angle_sum_above_pi(const Vectors& v)
  {
    const double margin = 1e-10;
    const double scale = length(v.rp) * length(v.rq) * length(v.sq) * length(v.sp);
    return length(cross(v.rp, v.rq)) * dot(v.sq, v.sp) + length(cross(v.sq, v.sp)) * dot(v.rp, v.rq) < -margin * scale;
  }

  // The quadrangle is convex if both new triangles have the same orientation.
  static bool is_convex(const Vectors& v)
  {
    const Coordinates normal = cross(v.rs, v.pq);
    return dot(normal, cross(v.rp, v.rs)) > 0 && dot(normal, cross(v.rs, v.rq)) > 0;
  }

  // The distance between the lines of the diagonals is within the tolerance. Any vector from one diagonal to the other
  // measures it; the shortest one is the least sensitive to the rounding error of the normal, which is large for narrow
  // triangles.
  bool are_coplanar(const Vectors& v) const
  {
    const Coordinates normal = cross(v.rs, v.pq);
    Coordinates shortest = v.rp;
    for(const Coordinates& other : { v.rq, v.sp, v.sq })
      if(dot(other, other) < dot(shortest, shortest))
        shortest = other;
    return std::abs(dot(normal, shortest)) <= m_tolerance * length(normal);
  }

  // Tells whether an edge joins the targets of two halfedges. It turns around both vertices at the same time, so that
  // the cost is that of the smaller degree.
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
