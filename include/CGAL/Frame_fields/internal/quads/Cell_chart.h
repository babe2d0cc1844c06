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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_CELL_CHART_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_CELL_CHART_H

#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/first_corner_of_cell.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Frame_fields {
namespace internal {

typedef std::array<double, 2> Plane_point;

// Twice the signed area of a triangle.
inline double orientation(const Plane_point& p, const Plane_point& q, const Plane_point& r)
{
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// The plane of a cell of a T-mesh, with its first corner at the origin and its first side along the positive x-axis.
// The faces that a walk meets are laid out in this plane, at exact positions; only the points that are located are
// rounded.
class Cell_chart
{
public:
  Cell_chart(const Cut_surface& surface, const Seamless_map& map, const T_mesh& t_mesh, const T_mesh_cell& cell)
    : m_surface(surface), m_charts(surface, map), m_face(cell.face), m_turns(cell.quarter_turns)
  {
    m_origin = first_corner_of_cell(m_charts, t_mesh, cell);
  }

  // Walks straight from the point of the last call (from the origin at the first call) to `point` and returns its
  // location. The point must be in the cell.
  Surface_location locate(const Plane_point& point)
  {
    // More steps than this mean that rounding made the walk turn back and forth at a vertex.
    int steps_left = 3 * m_surface.number_of_faces() + 16;
    int exit = exit_towards(point);
    for(; exit >= 0 && m_surface.opposite[exit] >= 0 && steps_left > 0; --steps_left)
    {
      cross(exit);
      exit = exit_towards(point);
    }
    m_position = point;
    return location_in_face(point);
  }

  // Where the corner at the target of a halfedge of the present face is.
  Plane_point corner(const int halfedge) const
  {
    const Grid_vector d = m_charts.point(halfedge) - m_origin;
    return { static_cast<double>(along(m_turns, d)), static_cast<double>(left_of(m_turns, d)) };
  }

private:
  // The halfedge of the present face over which the straight way to `point` leaves it, -1 if the point is in the face.
  int exit_towards(const Plane_point& point) const
  {
    const int first = 3 * m_face;
    std::array<Plane_point, 3> corners{ corner(first), corner(first + 1), corner(first + 2) };
    int exit = -1;
    for(int k = 0; k < 3; ++k)
    {
      const int halfedge = first + k;
      if(orientation(corners[(k + 2) % 3], corners[k], point) >= 0)
        continue;
      // Two edges may have the point outside; the way passes their common corner on one side.
      if(exit < 0)
        exit = halfedge;
      else
      {
        const int common = next_of(exit) == halfedge ? exit : halfedge; // the corner at its target
        const bool passes_left = orientation(m_position, point, corners[common - first]) < 0;
        const int before = common, after = next_of(common);
        exit = passes_left ? after : before;
      }
    }
    return exit;
  }

  void cross(const int halfedge)
  {
    m_origin = m_charts.point_across(halfedge, m_origin);
    m_turns = m_charts.direction_across(halfedge, m_turns);
    m_face = face_of(m_surface.opposite[halfedge]);
  }

  Surface_location location_in_face(const Plane_point& point) const
  {
    const int first = 3 * m_face;
    std::array<Plane_point, 3> corners{ corner(first), corner(first + 1), corner(first + 2) };
    Surface_location location;
    location.face = m_face;
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      location.barycentric[k] = (std::max)(0., orientation(corners[(k + 1) % 3], corners[(k + 2) % 3], point));
      sum += location.barycentric[k];
    }
    for(double& weight : location.barycentric)
      weight = sum > 0 ? weight / sum : 1. / 3;
    return location;
  }

  const Cut_surface& m_surface;
  Seamless_charts m_charts;
  int m_face;                          // the present face
  int m_turns;                         // the x-axis is the direction (1, 0) of its chart, turned as often
  Grid_vector m_origin;                // in its chart
  Plane_point m_position = { { 0, 0 } };
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_CELL_CHART_H
