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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_CHART_LINE_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_CHART_LINE_H

#include <CGAL/Frame_fields/internal/streamlines/Branch_directions.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_distances.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_tracer.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// An interval of lengths along a line; empty if it ends before it begins.
struct Length_interval
{
  double begin, end;

  bool contains(const double s) const { return begin <= s && s <= end; }
};

// A piece of a streamline, or a line parallel to it, in the chart of its face. In a face that is large compared to the
// distances of streamlines, it answers for all points of the line at once what otherwise each of many points would ask.
class Chart_line
{
public:
  // The line at `shift` to the left of the piece.
  Chart_line(const Face_charts& charts, const Branch_directions& directions, const Streamline_piece& piece,
             const double shift)
    : m_charts(charts), m_face(piece.face), m_branch(piece.branch), m_length(piece.length)
    , m_axis(directions.direction(piece.face, piece.branch % 2))
    , m_direction(directions.direction(piece.face, piece.branch))
    , m_from(charts.place(piece.face, piece.from) + shift * quarter_turn(m_direction))
    , m_end(charts.place(piece.face, piece.to) + shift * quarter_turn(m_direction))
  {}

  // Whether the piece runs along its branch; those that slide along an edge do not.
  bool is_along_branch(const double tolerance) const
  {
    return std::abs(cross(m_axis, m_end - m_from)) <= tolerance && dot(m_direction, m_end - m_from) > 0;
  }

  // The part of the line that is on the inner side of each side h of its face, at least at a distance of `margin(h)`. A
  // negative margin lets it be outside by as much.
  template <typename Margin>
  Length_interval inside(const Margin& margin) const
  {
    Length_interval result{ 0, m_length };
    for(int h = 3 * m_face; h < 3 * m_face + 3; ++h)
    {
      const double excess = cross(m_charts.direction(h), m_from - m_charts.source(h)) - margin(h);
      const double slope = cross(m_charts.direction(h), m_direction);
      if(slope > 0)
        result.begin = (std::max)(result.begin, -excess / slope);
      else if(slope < 0)
        result.end = (std::min)(result.end, excess / -slope);
      else if(excess < 0)
        return { 1, 0 };
    }
    return result;
  }

  // The intervals of the line that may be nearer than `distance` to the parts of interest in the same face, one for
  // each such part. They are not sorted, may overlap, and may reach beyond the ends of the line.
  template <typename IsOfInterest>
  std::vector<Length_interval> near_parts(const Streamline_distances& distances, const double distance,
                                          const IsOfInterest& is_of_interest) const
  {
    const double along = dot(m_axis, m_from);
    const bool is_forward = m_branch < 2; // the axis is branch 0 or 1
    std::vector<Length_interval> result;
    distances.for_each_near_part(m_face, m_branch, cross(m_axis, m_from), distance,
                                 [&](const Streamline_part& part, const double reach)
    {
      if(!is_of_interest(part))
        return;
      const double first = part.begin - reach - along, last = part.end + reach - along;
      result.push_back(is_forward ? Length_interval{ first, last } : Length_interval{ -last, -first });
    });
    return result;
  }

private:
  const Face_charts& m_charts;
  int m_face, m_branch;
  double m_length;
  Plane_vector m_axis, m_direction, m_from, m_end;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_CHART_LINE_H
