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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_POINTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_POINTS_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/arc_breakpoints.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Points of feature arcs, by their position (the place of a halfedge plus the fraction of it that lies behind) or by
// their length from the start of the arc, in the unit of the embedding's points. Positions and lengths beyond the ends
// of an arc give its first or last halfedge.
class Arc_points
{
public:
  Arc_points(const Surface_embedding& embedding, const Feature_network& network)
    : m_embedding(embedding), m_network(network)
  {
    for(const Feature_arc& arc : network.arcs)
    {
      m_first.push_back(m_length.size());
      m_length.push_back(0);
      for(const int h : arc.halfedges)
        m_length.push_back(m_length.back() + distance(embedding.point[embedding.vertex[previous_of(h)]],
                                                      embedding.point[embedding.vertex[h]]));
    }
  }

  int number_of_edges(const int arc) const { return static_cast<int>(m_network.arcs[arc].halfedges.size()); }
  double length(const int arc) const { return m_length[m_first[arc] + number_of_edges(arc)]; }

  int place(const int arc, const double position) const
  {
    return (std::max)(0, (std::min)(number_of_edges(arc) - 1, static_cast<int>(std::floor(position))));
  }

  int halfedge(const int arc, const double position) const
  {
    return m_network.arcs[arc].halfedges[place(arc, position)];
  }

  double length_at(const int arc, const double position) const
  {
    const int p = place(arc, position);
    return length_at(arc, p, position - p);
  }

  double length_at(const int arc, const int place, const double fraction) const
  {
    const double* const length = &m_length[m_first[arc] + place];
    return length[0] + fraction * (length[1] - length[0]);
  }

  double position_at(const int arc, const double length) const
  {
    const auto begin = m_length.begin() + static_cast<std::ptrdiff_t>(m_first[arc]);
    const auto end = begin + number_of_edges(arc);
    const auto above = (std::max)(begin + 1, std::upper_bound(begin, end, length)); // in [begin + 1, end]
    const double from = *(above - 1), to = *above;
    const double fraction = to > from ? (std::min)(1., (std::max)(0., (length - from) / (to - from))) : 0;
    return static_cast<double>(above - 1 - begin) + fraction;
  }

  Surface_location location(const int arc, const double position) const
  {
    const int p = place(arc, position);
    return location_on_halfedge(m_network.arcs[arc].halfedges[p], (std::min)(1., (std::max)(0., position - p)));
  }

  Coordinates point(const int arc, const double position) const
  {
    const int p = place(arc, position), h = m_network.arcs[arc].halfedges[p];
    const Coordinates& a = m_embedding.point[m_embedding.vertex[previous_of(h)]];
    const Coordinates& b = m_embedding.point[m_embedding.vertex[h]];
    const double t = position - p;
    return { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) };
  }

  // How far the arc is, between two lengths, from the segment that joins its points there. The lengths may run beyond
  // the ends of a loop by less than a turn.
  double deviation(const int arc, const double begin, const double end, const Coordinates& from,
                   const Coordinates& to) const
  {
    const double whole = length(arc);
    const int n = number_of_edges(arc);
    double result = 0;
    for(const double turn : { -whole, 0., whole })
    {
      const auto first = m_length.begin() + static_cast<std::ptrdiff_t>(m_first[arc]);
      const auto last = first + n + (m_network.arcs[arc].is_loop ? 0 : 1);
      for(auto l = std::upper_bound(first, last, begin - turn); l != last && *l + turn < end; ++l)
        result = (std::max)(result, distance_from_segment(vertex_point(arc, static_cast<int>(l - first)), from, to));
    }
    return result;
  }

private:
  const Coordinates& vertex_point(const int arc, const int place) const
  {
    const std::vector<int>& halfedges = m_network.arcs[arc].halfedges;
    const bool is_end = place == static_cast<int>(halfedges.size());
    return m_embedding.point[m_embedding.vertex[is_end ? halfedges.back() : previous_of(halfedges[place])]];
  }

  const Surface_embedding& m_embedding;
  const Feature_network& m_network;
  std::vector<std::size_t> m_first; // per arc: its first entry in `m_length`
  std::vector<double> m_length;     // per arc and end of a halfedge: the length up to there
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_POINTS_H
