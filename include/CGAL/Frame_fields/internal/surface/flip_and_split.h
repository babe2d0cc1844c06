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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FLIP_AND_SPLIT_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FLIP_AND_SPLIT_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Refinement_statistics.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Appends the points in the order of vertices(tm), and checks what the refinement takes for granted: all coordinates
// are finite and all faces are triangles. An error names the first vertex or face that is not.
template <typename TriangleMesh, typename Mesh>
Result read_for_refinement(const TriangleMesh& tm, const Mesh& mesh, std::vector<Coordinates>& points)
{
  for(const auto v : vertices(tm))
  {
    points.push_back(mesh.coordinates(v));
    if(!is_finite(points.back()))
      return failure(ERROR_NON_FINITE_COORDINATE,
                     "vertex " + std::to_string(points.size() - 1) + " of vertices(tm)");
  }
  return mesh.check_triangles();
}

// An estimate from below of the number of faces of the refined mesh: a triangle with edges up to `length` has at most
// the area of the equilateral one, and an edge is divided into pieces up to `length`. The latter counts the edges
// before any flip, so that it is too large where flips shorten many edges.
template <typename TriangleMesh, typename Mesh>
double least_number_of_faces(const TriangleMesh& tm, const Mesh& mesh, const double length)
{
  double number_by_area = 0, number_of_edges = 0;
  for(const auto f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    const Coordinates p = mesh.coordinates(source(h, tm)), q = mesh.coordinates(target(h, tm));
    const Coordinates r = mesh.coordinates(target(next(h, tm), tm));
    const Coordinates pq = (q - p) / length, pr = (r - p) / length;
    number_by_area += internal::length(cross(pq, pr)) * 2 / std::sqrt(3.);
    number_of_edges += internal::length(pq) + internal::length(pr) + distance(pq, pr);
  }
  return (std::max)(number_by_area, number_of_edges / 3);
}

// Flips those of the given edges that are not Delaunay. Then splits edges in rounds down to `maximum_edge_length`: each
// round splits those longer than a bound, which falls by `ratio` from round to round, and flips around the splits. Adds
// the numbers of flips and splits to the statistics.
template <typename TriangleMesh, typename Flips, typename Splits>
void flip_and_split(TriangleMesh& tm,
                    const std::deque<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>& flipped_first,
                    const Flips& flips, Splits& splits, const double maximum_edge_length,
                    Refinement_statistics& statistics)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  const double ratio = 1.2; // of the lengths
  const auto add = [&](const halfedge_descriptor h) { splits.add(h); };
  statistics.number_of_flips +=
    flips(flipped_first, (std::numeric_limits<double>::infinity)(), [](halfedge_descriptor) {});
  for(const auto e : edges(tm))
    splits.add(halfedge(e, tm));
  std::deque<halfedge_descriptor> changed;
  while(splits.longest() > 0)
  {
    changed.clear();
    const double length = (std::max)(splits.longest() / ratio, maximum_edge_length);
    statistics.number_of_splits += splits.split_down_to(length, changed);
    statistics.number_of_flips += flips(changed, length, add);
  }
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FLIP_AND_SPLIT_H
