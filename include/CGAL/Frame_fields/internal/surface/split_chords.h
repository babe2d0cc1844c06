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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_CHORDS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_CHORDS_H

#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Splits the chords at their midpoints: the unconstrained edges with both ends on constrained edges. Those that are too
// short for a point between their ends stay. Returns the number of edges that were split. All faces must be triangles.
template <typename TriangleMesh, typename NamedParameters>
std::size_t split_chords_of(TriangleMesh& tm, const Editable_mesh<TriangleMesh, NamedParameters>& mesh)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  // To look around the ends of each edge would take quadratic time where thousands of edges meet.
  std::vector<vertex_descriptor> on_constrained_edges;
  for(const auto e : edges(tm))
  {
    const halfedge_descriptor h = halfedge(e, tm);
    if(!mesh.is_constrained(h))
      continue;
    on_constrained_edges.push_back(source(h, tm));
    on_constrained_edges.push_back(target(h, tm));
  }
  std::sort(on_constrained_edges.begin(), on_constrained_edges.end());
  const auto is_on_constrained_edge = [&](const vertex_descriptor v)
  {
    return std::binary_search(on_constrained_edges.begin(), on_constrained_edges.end(), v);
  };
  std::vector<halfedge_descriptor> chords;
  for(const auto e : edges(tm))
  {
    const halfedge_descriptor h = halfedge(e, tm);
    if(!mesh.is_constrained(h) && is_on_constrained_edge(source(h, tm)) && is_on_constrained_edge(target(h, tm)))
      chords.push_back(h);
  }

  mesh.reserve_for(chords.size(), 3 * chords.size(), 2 * chords.size());

  std::size_t number_of_splits = 0;
  for(const halfedge_descriptor h : chords)
    number_of_splits += mesh.split_edge_with_faces(h) != boost::graph_traits<TriangleMesh>::null_halfedge();
  return number_of_splits;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_CHORDS_H
