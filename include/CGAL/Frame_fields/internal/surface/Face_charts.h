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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FACE_CHARTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FACE_CHARTS_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Barycentric coordinates in a face: the weights of the targets of its three halfedges, of sum 1.
typedef std::array<double, 3> Corner_weights;

inline Corner_weights between(const Corner_weights& from, const Corner_weights& to, const double t)
{
  return { (1 - t) * from[0] + t * to[0], (1 - t) * from[1] + t * to[1], (1 - t) * from[2] + t * to[2] };
}

inline Corner_weights weights_of_corner(const int corner)
{
  Corner_weights result{ 0, 0, 0 };
  result[corner % 3] = 1;
  return result;
}

// The point on a halfedge at `t`, which runs from 0 at the source to 1 at the target.
inline Corner_weights weights_on_halfedge(const int halfedge, const double t)
{
  return between(weights_of_corner(previous_of(halfedge)), weights_of_corner(halfedge), t);
}

// Each face laid out in the plane: its first halfedge starts at the origin and runs along the x axis. Lengths are in
// units of the longest edge of the surface, so that products of them do not overflow at any scale. The surface must
// have faces and `length`, and must outlive the charts.
class Face_charts
{
public:
  explicit Face_charts(const Cut_surface& surface)
    : m_surface(surface), m_unit(*std::max_element(surface.length.begin(), surface.length.end()))
  {
    m_direction.reserve(surface.length.size());
    for(int h = 0; h < surface.number_of_halfedges(); ++h)
    {
      const double angle = halfedge_angle(surface, h);
      m_direction.push_back({ std::cos(angle), std::sin(angle) });
    }
  }

  const Cut_surface& surface() const { return m_surface; }
  // The length of the longest edge, in units of the mesh.
  double unit() const { return m_unit * m_surface.length_unit; }
  double length(const int halfedge) const { return m_surface.length[halfedge] / m_unit; }
  const Plane_vector& direction(const int halfedge) const { return m_direction[halfedge]; }

  // The place of the target of a halfedge in the chart of its face.
  Plane_vector corner(const int halfedge) const
  {
    switch(halfedge % 3)
    {
      case 0: return { length(halfedge), 0 };
      case 1: return Plane_vector{ length(halfedge - 1), 0 } + length(halfedge) * direction(halfedge);
      default: return { 0, 0 };
    }
  }

  Plane_vector source(const int halfedge) const { return corner(previous_of(halfedge)); }

  Plane_vector place(const int face, const Corner_weights& weights) const
  {
    return weights[0] * corner(3 * face) + weights[1] * corner(3 * face + 1);
  }

  double distance(const int face, const Corner_weights& a, const Corner_weights& b) const
  {
    const Plane_vector v = place(face, b) - place(face, a);
    return std::hypot(v.x, v.y);
  }

  // A direction in the chart of the face on the other side of an unconstrained halfedge, when both faces are unfolded
  // into one plane.
  Plane_vector direction_across(const int halfedge, const Plane_vector& v) const
  {
    const Plane_vector here = direction(halfedge), there = -direction(m_surface.opposite[halfedge]);
    return dot(here, v) * there + cross(here, v) * quarter_turn(there);
  }

  // The same for a place.
  Plane_vector place_across(const int halfedge, const Plane_vector& p) const
  {
    return corner(m_surface.opposite[halfedge]) + direction_across(halfedge, p - source(halfedge));
  }

  // The distance from a place to the segment of a halfedge of the same face.
  double distance_to(const int halfedge, const Plane_vector& p) const
  {
    const Plane_vector v = p - source(halfedge);
    const double along = dot(direction(halfedge), v);
    const double beyond = along - (std::min)(length(halfedge), (std::max)(0., along));
    return std::hypot(beyond, cross(direction(halfedge), v));
  }

  // In units of the longest edge squared, as is the total area.
  double area(const int face) const
  {
    const int h = 3 * face;
    return triangle_area(length(h), length(h + 1), m_surface.angle[h]);
  }

  double total_area() const
  {
    double sum = 0;
    for(int f = 0; f < m_surface.number_of_faces(); ++f)
      sum += area(f);
    return sum;
  }

private:
  const Cut_surface& m_surface;
  double m_unit;
  std::vector<Plane_vector> m_direction; // per halfedge
};

// Where a ray leaves a face: `t` from the source of `halfedge` (0) to its target (1).
struct Ray_exit
{
  int halfedge;
  double t;
};

// Where the ray from `p` meets a halfedge through which it leaves the face: the source is to its right and the target
// to its left.
inline Ray_exit meet(const Face_charts& charts, const Plane_vector& p, const Plane_vector& direction,
                     const int halfedge)
{
  const double right = -cross(direction, charts.source(halfedge) - p);
  const double left = cross(direction, charts.corner(halfedge) - p);
  if(right + left > 0)
    return { halfedge, (std::min)(1., (std::max)(0., right / (right + left))) };
  return { halfedge, dot(direction, charts.direction(halfedge)) > 0 ? 1. : 0. }; // it runs along the halfedge
}

// The ray starts at a corner and points into its face: it leaves through the opposite halfedge.
inline Ray_exit exit_from_corner(const Face_charts& charts, const Plane_vector& direction, const int corner)
{
  return meet(charts, charts.corner(corner), direction, previous_of(corner));
}

// The ray starts on the halfedge `entry` and points to its left: it leaves through one of the two others.
inline Ray_exit exit_from_halfedge(const Face_charts& charts, const Plane_vector& p, const Plane_vector& direction,
                                   const int entry)
{
  const bool is_apex_left = cross(direction, charts.corner(next_of(entry)) - p) > 0;
  return meet(charts, p, direction, is_apex_left ? next_of(entry) : previous_of(entry));
}

// The ray starts anywhere in the face.
inline Ray_exit exit_from_inside(const Face_charts& charts, const int face, const Plane_vector& p,
                                 const Plane_vector& direction)
{
  const double infinity = std::numeric_limits<double>::infinity(), parallel_tolerance = 1e-12;
  int best = 3 * face;
  double best_score = -infinity;
  for(int h = 3 * face; h < 3 * face + 3; ++h)
  {
    if(cross(direction, charts.direction(h)) < parallel_tolerance)
      continue;
    // Both are positive for one halfedge. If the point is on the rim, rounding errors can make one a little negative.
    const double right = -cross(direction, charts.source(h) - p), left = cross(direction, charts.corner(h) - p);
    if((std::min)(right, left) > best_score)
    {
      best = h;
      best_score = (std::min)(right, left);
    }
  }
  return meet(charts, p, direction, best);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FACE_CHARTS_H
