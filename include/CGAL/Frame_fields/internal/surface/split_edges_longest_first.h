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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_EDGES_LONGEST_FIRST_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_EDGES_LONGEST_FIRST_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Splits edges at their midpoints, the longest first and of two with the same length the first one, and with each its
// triangles. An edge that is listed twice is split once, and what rounding leaves no point for stays. A triangle whose
// three edges are listed becomes four, of which none has an angle below half its smallest one (Rivara 1984).
template <typename TriangleMesh, typename NamedParameters>
void split_edges_longest_first(
  TriangleMesh& tm, const Editable_mesh<TriangleMesh, NamedParameters>& mesh,
  const std::vector<typename Editable_mesh<TriangleMesh, NamedParameters>::halfedge_descriptor>& halfedges)
{
  typedef typename Editable_mesh<TriangleMesh, NamedParameters>::halfedge_descriptor halfedge_descriptor;

  std::vector<std::pair<halfedge_descriptor, std::size_t> > edges; // with their places in the list
  for(std::size_t i = 0; i < halfedges.size(); ++i)
    edges.emplace_back((std::min)(halfedges[i], opposite(halfedges[i], tm)), i);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
              edges.end());

  std::vector<std::pair<double, std::size_t> > by_length;
  for(const auto& [h, i] : edges)
    by_length.emplace_back(-distance(mesh.coordinates(source(h, tm)), mesh.coordinates(target(h, tm))), i);
  std::sort(by_length.begin(), by_length.end());
  for(const auto& entry : by_length)
    mesh.split_edge_with_faces(halfedges[entry.second]);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SPLIT_EDGES_LONGEST_FIRST_H
