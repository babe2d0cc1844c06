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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_ARC_BREAKPOINTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_ARC_BREAKPOINTS_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The distance of a point from a segment.
inline double distance_from_segment(const Coordinates& p, const Coordinates& a, const Coordinates& b)
{
  const Coordinates ab{ b[0] - a[0], b[1] - a[1], b[2] - a[2] }, ap{ p[0] - a[0], p[1] - a[1], p[2] - a[2] };
  const double squared_length = dot(ab, ab);
  const double t = squared_length > 0 ? (std::min)(1., (std::max)(0., dot(ap, ab) / squared_length)) : 0;
  return distance(p, { a[0] + t * ab[0], a[1] + t * ab[1], a[2] + t * ab[2] });
}

// The places on an arc such that the straight lines between successive ones stay within a distance `tolerance` of the
// arc (by the algorithm of Ramer, Douglas and Peucker). Place i is the source of halfedge i of the arc, the vertex
// `source_vertex[i]`. The result is sorted. It leaves out the ends of the arc; that of a loop begins with place 0. The
// time is O(n log n) for n halfedges on most arcs and O(n^2) at worst.
inline std::vector<int> arc_breakpoints(const Surface_embedding& embedding, const Feature_arc& arc,
                                        const std::vector<int>& source_vertex, const double tolerance)
{
  const int n = static_cast<int>(arc.halfedges.size());
  const auto point = [&](const int place) -> const Coordinates&
  {
    return embedding.point[place < n ? source_vertex[place] : embedding.vertex[arc.halfedges.back()]];
  };
  std::vector<int> result;
  if(arc.is_loop)
    result.push_back(0);
  std::vector<std::pair<int, int> > ranges(1, { 0, n });
  while(!ranges.empty())
  {
    const int begin = ranges.back().first, end = ranges.back().second;
    ranges.pop_back();
    int farthest = -1;
    double largest = tolerance;
    for(int place = begin + 1; place < end; ++place)
    {
      const double d = distance_from_segment(point(place), point(begin), point(end));
      if(d > largest)
      {
        largest = d;
        farthest = place;
      }
    }
    if(farthest < 0)
      continue;
    result.push_back(farthest);
    ranges.emplace_back( begin, farthest );
    ranges.emplace_back( farthest, end );
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_ARC_BREAKPOINTS_H
