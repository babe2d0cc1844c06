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

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Splits the chords at their midpoints: the unconstrained edges with both ends on constrained edges. Returns the number
// of edges that were split. All faces must be triangles.
template <typename TriangleMesh, typename NamedParameters>
std::size_t split_chords_of(TriangleMesh& tm, const Editable_mesh<TriangleMesh, NamedParameters>& mesh)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;

  // Marks cost linear time, also where thousands of edges meet; to look around the ends of each edge does not.
  const auto is_on_constrained_edge = get(CGAL::dynamic_vertex_property_t<int>(), tm);
  for(const auto v : vertices(tm))
    put(is_on_constrained_edge, v, 0);
  for(const auto e : edges(tm))
  {
    const halfedge_descriptor h = halfedge(e, tm);
    if(!mesh.is_constrained(h))
      continue;
    put(is_on_constrained_edge, source(h, tm), 1);
    put(is_on_constrained_edge, target(h, tm), 1);
  }
  std::vector<halfedge_descriptor> chords;
  for(const auto e : edges(tm))
  {
    const halfedge_descriptor h = halfedge(e, tm);
    if(get(is_on_constrained_edge, source(h, tm)) && get(is_on_constrained_edge, target(h, tm))
       && !mesh.is_constrained(h))
      chords.push_back(h);
  }

  mesh.reserve_for(chords.size(), 3 * chords.size(), 2 * chords.size());

  for(const halfedge_descriptor h : chords)
    mesh.split_edge_with_faces(h);
  return chords.size();
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_CHORDS_H
