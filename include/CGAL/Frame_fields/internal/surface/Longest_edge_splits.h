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
// longest one of its triangles, so that each triangle is bisected at its longest edge. However often this happens, what
// comes of a triangle has at least a half of its smallest angle (Rosenberg and Stenger 1975).
// Edges that cannot be flipped go before those inside planes: flips then give these the lengths that a narrow strip
// allows, and no vertex is put where there is no room for it.
template <typename TriangleMesh, typename NamedParameters, typename IsInPlane>
class Longest_edge_splits
{
public:
  typedef Editable_mesh<TriangleMesh, NamedParameters> Mesh;
  typedef typename Mesh::halfedge_descriptor halfedge_descriptor;

  Longest_edge_splits(TriangleMesh& tm, const Mesh& mesh, const double maximum_edge_length,
                      const IsInPlane& is_in_plane)
    : m_mesh(tm), m_editable(mesh), m_maximum_edge_length(maximum_edge_length), m_is_in_plane(is_in_plane)
  {}

  // Has to be called for all edges, and for those that others change.
  void add(const halfedge_descriptor h)
  {
    const double length = length_of(h);
    if(length > m_maximum_edge_length)
      m_queue.push({ m_is_in_plane(h) ? length : precedence * length, length, m_number_of_entries++, h });
  }

  // The length of the longest edge that is left, 0 if none is. Here and below, edges in no plane count as longer than
  // they are.
  double longest() const { return m_queue.empty() ? 0 : m_queue.top().priority; }

  // Splits the edges longer than a bound, and adds the edges of all triangles of a split to a list. Returns the number
  // of splits.
  std::size_t split_down_to(const double bound, std::deque<halfedge_descriptor>& changed)
  {
    std::size_t number = 0;
    while(!m_queue.empty() && m_queue.top().priority > bound)
    {
      const Entry entry = m_queue.top();
      m_queue.pop();
      const bool is_current = length_of(entry.halfedge) == entry.length; // a changed edge has another entry, if any
      number += is_current && split(entry.halfedge, changed);
    }
    return number;
  }

private:
  static constexpr double precedence = 1.4; // of edges in no plane: pieces of a strip end at squares

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

  double length_of(const halfedge_descriptor h) const
  {
    return distance(m_editable.coordinates(source(h, m_mesh)), m_editable.coordinates(target(h, m_mesh)));
  }

  // Fails if there is no number between those of the ends.
  bool split(const halfedge_descriptor h, std::deque<halfedge_descriptor>& changed)
  {
    const auto midpoint = m_editable.traits().construct_midpoint_3_object()(
      m_editable.point(source(h, m_mesh)), m_editable.point(target(h, m_mesh)));
    const Coordinates coordinates = coordinates_of(midpoint, m_editable.traits());
    if(coordinates == m_editable.coordinates(source(h, m_mesh))
       || coordinates == m_editable.coordinates(target(h, m_mesh)))
      return false;
    const halfedge_descriptor to_midpoint = CGAL::Euler::split_edge(h, m_mesh);
    m_editable.set_point(target(to_midpoint, m_mesh), midpoint);
    m_editable.copy_constraint(h, to_midpoint);
    for(const halfedge_descriptor half : { to_midpoint, opposite(h, m_mesh) })
      if(!is_border(half, m_mesh))
      {
        const halfedge_descriptor across = CGAL::Euler::split_face(half, next(next(half, m_mesh), m_mesh), m_mesh);
        m_editable.mark_unconstrained(across);
        for(const halfedge_descriptor side : { across, opposite(across, m_mesh) })
          for(const halfedge_descriptor around : { side, next(side, m_mesh), prev(side, m_mesh) })
            changed.push_back(around);
      }
    // All faces are triangles again.
    for(const halfedge_descriptor part : { to_midpoint, h })
      add(part);
    for(const halfedge_descriptor across : { next(to_midpoint, m_mesh), next(opposite(h, m_mesh), m_mesh) })
      if(!is_border(across, m_mesh))
        add(across);
    return true;
  }

  TriangleMesh& m_mesh;
  const Mesh& m_editable;
  double m_maximum_edge_length;
  IsInPlane m_is_in_plane;
  std::priority_queue<Entry> m_queue;
  std::size_t m_number_of_entries = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_LONGEST_EDGE_SPLITS_H
