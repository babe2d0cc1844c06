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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_GRID_WALKER_H
#define CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_GRID_WALKER_H

#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/parameterization/sign_of_determinant.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point in the chart of a face that contains it.
struct Point_in_face
{
  int face;
  Grid_vector point;
};

// Walks straight from face to face in the charts of a certified map. All comparisons are exact.
class Grid_walker
{
public:
  explicit Grid_walker(const Seamless_charts& charts) : m_charts(charts), m_surface(charts.surface()) {}

  // Walks from a point of a face to another point, given in the same chart. No singular vertex may be on the way before
  // its end. Returns a face that contains the point, and the point in its chart; the face is -1 if the way leaves the
  // patch or takes too long.
  Point_in_face walk(int face, Grid_vector from, Grid_vector to) const
  {
    const int maximum_number_of_steps = 1000000;
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      const int exit = exit_of(face, from, to);
      if(exit < 0)
        return { face, to };
      if(m_surface.is_constrained(exit))
        return { -1, to };
      from = m_charts.point_across(exit, from);
      to = m_charts.point_across(exit, to);
      face = face_of(m_surface.opposite[exit]);
    }
    return { -1, to };
  }

private:
  // The halfedge over which the way leaves a face, -1 if its end is in the face. Where it passes two halfedges, it
  // leaves over the one on whose side of their common corner it runs.
  int exit_of(const int face, const Grid_vector& from, const Grid_vector& to) const
  {
    int exit = -1;
    for(int h = 3 * face; h < 3 * face + 3; ++h)
    {
      if(m_charts.side(h, to) >= 0)
        continue;
      if(exit < 0)
        exit = h;
      else
      {
        const int before = next_of(exit) == h ? exit : h; // ends at the common corner
        const Grid_vector way = to - from, corner = m_charts.point(before) - from;
        exit = sign_of_determinant(way.u, way.v, corner.u, corner.v) < 0 ? next_of(before) : before;
      }
    }
    return exit;
  }

  const Seamless_charts& m_charts;
  const Cut_surface& m_surface;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_GRID_WALKER_H
