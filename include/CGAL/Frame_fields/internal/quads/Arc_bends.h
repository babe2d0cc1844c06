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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_BENDS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_BENDS_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/arc_breakpoints.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where arcs bend: the places at which they need vertices so that sides of quads stay near them.
class Arc_bends
{
public:
  // Tolerances are given in the unit of the lengths of `measured_surface`, which is the surface or has other lengths.
  Arc_bends(const Cut_surface& surface, const Cut_surface& measured_surface, const Surface_embedding& embedding,
            const Feature_network& features)
    : m_surface(surface), m_measured_surface(measured_surface), m_embedding(embedding), m_features(features)
  {}

  // Finds the bends. The tolerance of an arc is also bounded by a small part of its length, as no side is longer than
  // its arc.
  void follow_within(const double tolerance)
  {
    m_tolerance = tolerance;
    m_tolerance_of_arc.clear();
    m_breakpoints.clear();
    for(const Feature_arc& arc : m_features.arcs)
    {
      double arc_length = 0, measured_length = 0;
      for(const int h : arc.halfedges)
      {
        arc_length += m_surface.length[h];
        measured_length += m_measured_surface.length[h];
      }
      m_tolerance_of_arc.push_back((std::min)(tolerance * (arc_length / measured_length),
                                              part_of_edge_length * arc_length));
      m_breakpoints.push_back(breakpoints_of(arc, m_tolerance_of_arc.back()));
    }
  }

  double tolerance() const { return m_tolerance; }
  const std::vector<double>& tolerance_of_arc() const { return m_tolerance_of_arc; } // in the unit of the surface

  int least_number_of_edges(const std::size_t arc) const
  {
    return static_cast<int>(m_breakpoints[arc].size()) + (m_features.arcs[arc].is_loop ? 0 : 1);
  }

  // The breakpoints of each arc, or fewer, of a tolerance that is a multiple of the given one, where the arc has fewer
  // vertices than breakpoints.
  std::vector<std::vector<int> > attainable_breakpoints(const std::vector<int>& edges_of_arc,
                                                        const double first_tolerance) const
  {
    std::vector<std::vector<int> > result = m_breakpoints;
    for(std::size_t a = 0; a < result.size(); ++a)
    {
      const std::size_t number = edges_of_arc[a] - (m_features.arcs[a].is_loop ? 0 : 1);
      for(double tolerance = 2 * first_tolerance; result[a].size() > number; tolerance *= 2)
        result[a] = breakpoints_of(m_features.arcs[a], tolerance);
    }
    return result;
  }

  // A tolerance that is hardly seen, over the length of edges.
  static constexpr double part_of_edge_length = 0.02;

private:
  std::vector<int> breakpoints_of(const Feature_arc& arc, const double tolerance) const
  {
    std::vector<int> source_vertices;
    for(const int h : arc.halfedges)
      source_vertices.push_back(m_embedding.vertex[previous_of(h)]);
    return arc_breakpoints(m_embedding, arc, source_vertices, tolerance);
  }

  const Cut_surface& m_surface;
  const Cut_surface& m_measured_surface;
  const Surface_embedding& m_embedding;
  const Feature_network& m_features;
  double m_tolerance = 0;
  std::vector<double> m_tolerance_of_arc;
  std::vector<std::vector<int> > m_breakpoints; // per arc: the places where it must have a vertex
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_BENDS_H
