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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_REFINE_WORKING_COPY_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_REFINE_WORKING_COPY_H

#include <CGAL/Frame_fields/Refinement_statistics.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Coplanar_flips.h>
#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Longest_edge_splits.h>
#include <CGAL/Frame_fields/internal/surface/Working_mesh.h>
#include <CGAL/Frame_fields/internal/surface/coordinate_rounding.h>
#include <CGAL/Frame_fields/internal/surface/flip_and_split.h>

#include <algorithm>
#include <deque>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Refines the triangles of a copy that have an edge longer than `maximum_edge_length`. If `may_flip`, their edges
// inside planes are flipped until they are Delaunay, with edges around them where a flip makes it necessary. Then all
// edges that are too long are split, the longest first, until there are `maximum_number_of_faces` or one more. Lengths
// are in units of the copy, multiplied by its densities. `unit` is the length in the copy of what has length 1 in the
// caller's mesh, whose coordinates were rounded.
template <typename NamedParameters>
Refinement_statistics refine_working_copy(Working_mesh& copy, const NamedParameters& np, const double unit,
                                          const double maximum_edge_length, const double maximum_number_of_faces,
                                          const bool may_flip)
{
  typedef Working_mesh::Halfedge Halfedge;
  const Editable_mesh<Working_mesh, NamedParameters> mesh(copy, np);
  const auto is_long = [&](const Halfedge h)
  {
    return length_factor(copy, source(h, copy), target(h, copy))
           * distance(mesh.coordinates(source(h, copy)), mesh.coordinates(target(h, copy))) > maximum_edge_length;
  };
  std::deque<Halfedge> edges_of_long_faces;
  std::vector<Coordinates> points;
  for(const Working_mesh::Face f : faces(copy))
  {
    const Halfedge h = halfedge(f, copy);
    if(!is_long(h) && !is_long(next(h, copy)) && !is_long(prev(h, copy)))
      continue;
    for(const Halfedge side : { h, next(h, copy), prev(h, copy) })
    {
      edges_of_long_faces.push_back(side);
      points.push_back(mesh.coordinates(target(side, copy)) / unit);
    }
  }

  Refinement_statistics statistics;
  if(edges_of_long_faces.empty())
    return statistics;
  if(may_flip)
    statistics.flip_tolerance = unit * default_flip_tolerance(points);
  else
    edges_of_long_faces.clear();
  const Coplanar_flips<Working_mesh, NamedParameters> flips(copy, mesh, 1, may_flip ? statistics.flip_tolerance : -1);
  const auto is_in_plane = [&](const Halfedge h) { return flips.is_in_plane(h); };
  Longest_edge_splits<Working_mesh, NamedParameters, decltype(is_in_plane)> splits(
    copy, mesh, maximum_edge_length, maximum_number_of_faces, is_in_plane);
  flip_and_split(copy, edges_of_long_faces, flips, splits, maximum_edge_length, statistics);
  return statistics;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_REFINE_WORKING_COPY_H
