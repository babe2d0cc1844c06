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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_LONGEST_EDGE_SPLITS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_LONGEST_EDGE_SPLITS_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <deque>
#include <queue>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Splits edges at their midpoints, the longest first, and with each its triangles. The longest edge of all is the
// longest one of its triangles, so that each triangle is bisected at its longest edge. However often this happens, the
// pieces of a triangle have angles of at least half its smallest one (Rosenberg and Stenger 1975). That holds as long
// as no flip, no length factor and no precedence comes between. Edges that cannot be flipped go before those inside
// planes. Flips then give the latter the lengths that a narrow strip allows, and no vertex is put where there is no
// room for it.
template <typename TriangleMesh, typename NamedParameters, typename IsInPlane>
class Longest_edge_splits
{
public:
  typedef Editable_mesh<TriangleMesh, NamedParameters> Mesh;
  typedef typename Mesh::Graph_traits Graph_traits;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;

  // Splits edges longer than `maximum_edge_length`, as `length_factor()` counts lengths. Nothing is split once there
  // are `maximum_number_of_faces`; the last split may add one face too many.
  Longest_edge_splits(TriangleMesh& tm, const Mesh& mesh, const double maximum_edge_length,
                      const double maximum_number_of_faces, const IsInPlane& is_in_plane)
    : m_mesh(tm), m_editable(mesh), m_maximum_edge_length(maximum_edge_length)
    , m_maximum_number_of_faces(maximum_number_of_faces), m_is_in_plane(is_in_plane)
    , m_number_of_faces(static_cast<double>(num_faces(tm)))
  {}

  // Enters an edge if it is too long. Must be called for all edges first, and later for each edge that is flipped.
  void add(const halfedge_descriptor h)
  {
    const double length = length_of(h);
    if(length > m_maximum_edge_length)
      m_queue.push({ m_is_in_plane(h) ? length : precedence * length, length, m_number_of_entries++, h });
  }

  // The length of the longest edge that is left, 0 if none is or no split is allowed any more; too large if that edge
  // has changed since. Here and below, edges that are not inside planes count as longer, by the factor `precedence`.
  double longest() const { return m_queue.empty() || is_exhausted() ? 0 : m_queue.top().priority; }

  // Splits the edges longer than a bound, the longest first. Appends the edges of all new triangles to `changed`.
  // Returns the number of splits.
  std::size_t split_down_to(const double bound, std::deque<halfedge_descriptor>& changed)
  {
    std::size_t number = 0;
    while(!m_queue.empty() && m_queue.top().priority > bound && !is_exhausted())
    {
      const Entry entry = m_queue.top();
      m_queue.pop();
      const bool is_current = length_of(entry.halfedge) == entry.length; // a changed edge has another entry, if any
      number += is_current && split(entry.halfedge, changed);
    }
    return number;
  }

private:
  static constexpr double precedence = 1.4; // of edges not inside planes: then a strip is cut into squares

  struct Entry
  {
    double priority, length;
    std::size_t number; // of edges of the same length, the one that came first is split first
    halfedge_descriptor halfedge;

    bool operator<(const Entry& other) const
    {
      return priority < other.priority || (priority == other.priority && number > other.number);
    }
  };

  bool is_exhausted() const { return m_number_of_faces >= m_maximum_number_of_faces; }

  double length_of(const halfedge_descriptor h) const
  {
    return length_factor(m_mesh, source(h, m_mesh), target(h, m_mesh))
         * distance(m_editable.coordinates(source(h, m_mesh)), m_editable.coordinates(target(h, m_mesh)));
  }

  // Returns false and changes nothing if rounding leaves no point to split at.
  bool split(const halfedge_descriptor h, std::deque<halfedge_descriptor>& changed)
  {
    const halfedge_descriptor to_point = m_editable.split_edge_with_faces(h);
    if(to_point == Graph_traits::null_halfedge())
      return false;
    for(const halfedge_descriptor half : { to_point, opposite(h, m_mesh) })
      if(!is_border(half, m_mesh))
      {
        const halfedge_descriptor across = next(half, m_mesh);
        ++m_number_of_faces;
        for(const halfedge_descriptor side : { across, opposite(across, m_mesh) })
          for(const halfedge_descriptor around : { side, next(side, m_mesh), prev(side, m_mesh) })
            changed.push_back(around);
      }
    // All faces are triangles again.
    for(const halfedge_descriptor part : { to_point, h })
      add(part);
    for(const halfedge_descriptor across : { next(to_point, m_mesh), next(opposite(h, m_mesh), m_mesh) })
      if(!is_border(across, m_mesh))
        add(across);
    return true;
  }

  TriangleMesh& m_mesh;
  const Mesh& m_editable;
  double m_maximum_edge_length, m_maximum_number_of_faces;
  IsInPlane m_is_in_plane;
  double m_number_of_faces;
  std::priority_queue<Entry> m_queue;
  std::size_t m_number_of_entries = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_LONGEST_EDGE_SPLITS_H
