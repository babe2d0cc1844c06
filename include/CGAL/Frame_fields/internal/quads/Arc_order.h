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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_ORDER_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_ORDER_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Arc_points.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The vertices of a quad mesh along the feature arcs, and how far each may slide between its neighbours. Lengths are
// measured from the start of the arc, in the unit of the embedding's points.
class Arc_order
{
public:
  Arc_order(const Quad_complex& complex, const Feature_network& network, const Arc_points& arc_points)
    : m_network(network), m_arc_points(arc_points), m_previous(complex.vertices.size(), -1)
    , m_next(complex.vertices.size(), -1), m_length(complex.vertices.size(), 0)
  {
    std::vector<int> sorted;
    for(std::size_t v = 0; v < complex.vertices.size(); ++v)
      if(complex.vertices[v].arc >= 0)
      {
        sorted.push_back(static_cast<int>(v));
        m_length[v] = arc_points.length_at(complex.vertices[v].arc, complex.vertices[v].position);
      }
    const auto key = [&](const int v) { return std::make_pair(complex.vertices[v].arc, complex.vertices[v].position); };
    std::stable_sort(sorted.begin(), sorted.end(), [&](const int v, const int w) { return key(v) < key(w); });
    for(std::size_t begin = 0, end; begin < sorted.size(); begin = end)
    {
      const int arc = complex.vertices[sorted[begin]].arc;
      for(end = begin + 1; end < sorted.size() && complex.vertices[sorted[end]].arc == arc; ++end)
        link(sorted[end - 1], sorted[end]);
      if(network.arcs[arc].is_loop)
        link(sorted[end - 1], sorted[begin]);
    }
  }

  double length(const int vertex) const { return m_length[vertex]; }
  void set_length(const int vertex, const double length) { m_length[vertex] = length; }

  // The neighbours of a vertex on its arc, -1 beyond the ends of the arc.
  int previous(const int vertex) const { return m_previous[vertex]; }
  int next(const int vertex) const { return m_next[vertex]; }

  // The lengths at the neighbours of a vertex, the first not more and the second not less than its own.
  std::pair<double, double> range(const int vertex, const int arc) const
  {
    const double total = m_arc_points.length(arc), own = m_length[vertex];
    double lower = m_previous[vertex] >= 0 ? m_length[m_previous[vertex]] : 0;
    double upper = m_next[vertex] >= 0 ? m_length[m_next[vertex]] : total;
    if(m_network.arcs[arc].is_loop)
    {
      lower -= lower >= own ? total : 0;
      upper += upper <= own ? total : 0;
    }
    return { lower, upper };
  }

  // The position at a length, which may lie beyond the ends of a loop by less than a turn.
  double position(const int arc, double length) const
  {
    const double total = m_arc_points.length(arc);
    if(m_network.arcs[arc].is_loop)
      length += length < 0 ? total : length >= total ? -total : 0;
    return m_arc_points.position_at(arc, length);
  }

private:
  void link(const int vertex, const int next)
  {
    m_next[vertex] = next;
    m_previous[next] = vertex;
  }

  const Feature_network& m_network;
  const Arc_points& m_arc_points;
  std::vector<int> m_previous, m_next; // per vertex
  std::vector<double> m_length;        // per vertex
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_ORDER_H
