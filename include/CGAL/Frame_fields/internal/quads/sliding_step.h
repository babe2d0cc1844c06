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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_SLIDING_STEP_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_SLIDING_STEP_H

#include <CGAL/Frame_fields/internal/quads/Sliding_quads.h>
#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/internal/surface/face_basis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A plane through a vertex in which its quads look nearly undistorted: along the sum of their normals at the vertex, or
// that of the surface where these are more than 60 degrees apart.
class Vertex_plane
{
public:
  Vertex_plane(const Sliding_quads& quads, const int vertex)
    : m_origin(quads.point(vertex))
  {
    const Coordinates& face_normal = quads.walker().normal(quads.vertex(vertex).location.face);
    Coordinates normal{ 0, 0, 0 };
    for(const int* c = quads.corners_begin(vertex); c != quads.corners_end(vertex); ++c)
    {
      const std::array<int, 4>& q = quads.quad(*c / 4);
      normal = normal + cross(quads.point(q[(*c + 1) % 4]) - m_origin, quads.point(q[(*c + 3) % 4]) - m_origin);
    }
    double norm = std::sqrt(dot(normal, normal));
    if(!(dot(normal, face_normal) > 0.5 * norm)) // they are twisted, or lie on their faces
    {
      normal = face_normal;
      norm = std::sqrt(dot(normal, normal));
    }
    if(norm > 0)
    {
      m_x = perpendicular(1 / norm * normal);
      m_y = 1 / norm * cross(normal, m_x);
    }
  }

  Plane_vector coordinates(const Coordinates& point) const { return tangential(point - m_origin); }
  Plane_vector tangential(const Coordinates& v) const { return { dot(v, m_x), dot(v, m_y) }; }

  Coordinates in_space(const Plane_vector& v) const { return v.x * m_x + v.y * m_y; }

private:
  Coordinates m_origin, m_x{ 0, 0, 0 }, m_y{ 0, 0, 0 };
};

// The sum of (w (|a|^2 + |b|^2) / 2 + (1 - w) |a| |b|) / a x b over the corners with sides a and b that move with a
// vertex. In it, |a| |b| is replaced by (|a|^2 |b'| / |a'| + |b|^2 |a'| / |b'|) / 2 for the sides a' and b' before the
// move, which is nowhere less and has the same gradient there. So each term is convex where a x b is positive, as a x b
// is linear in the place of the vertex.
class Distortion_expansion
{
public:
  struct Side
  {
    Plane_vector vector; // from the vertex if it moves
    bool moves;
  };

  // Adds the corner between two sides, with their a x b and its gradient. Returns whether that is positive.
  bool add(const Side& s, const Side& t, const double area, const Plane_vector& area_gradient)
  {
    const double ss = dot(s.vector, s.vector), tt = dot(t.vector, t.vector);
    if(!(area > 1e-9 * (ss + tt)))
      return false;
    const double length_ratio = std::sqrt(tt / ss);
    const double weight_s = weight_of_side_ratio + (1 - weight_of_side_ratio) * length_ratio;
    const double weight_t = weight_of_side_ratio + (1 - weight_of_side_ratio) / length_ratio;
    const double moving_s = s.moves ? weight_s : 0, moving_t = t.moves ? weight_t : 0;
    const double squares = weight_s * ss + weight_t * tt, second_derivative = 2 * (moving_s + moving_t);
    const Plane_vector gradient = -2. * (moving_s * s.vector + moving_t * t.vector);
    const double inverse = 1 / (2 * area), ratio = squares / area;
    // With w = s' - s t' / t and u = t' / t the derivatives of s / t are w / t and (s'' - w u - u w) / t.
    const Plane_vector w = gradient - ratio * area_gradient, u = 1 / area * area_gradient;
    m_gradient = m_gradient + inverse * w;
    m_xx += inverse * (second_derivative - 2 * w.x * u.x);
    m_yy += inverse * (second_derivative - 2 * w.y * u.y);
    m_xy -= inverse * (w.x * u.y + w.y * u.x);
    return true;
  }

  // The step to the least value of the quadratic function that agrees in value and derivatives; false if there is none.
  bool step(Plane_vector& result) const
  {
    const double determinant = m_xx * m_yy - m_xy * m_xy;
    if(!(m_xx > 0 && determinant > 1e-12 * m_xx * m_yy))
      return false;
    result = { (m_xy * m_gradient.y - m_yy * m_gradient.x) / determinant,
               (m_xy * m_gradient.x - m_xx * m_gradient.y) / determinant };
    return true;
  }

private:
  Plane_vector m_gradient{ 0, 0 };
  double m_xx = 0, m_xy = 0, m_yy = 0;
};

// The step of Newton's method for the bound of the distortion in the plane, made longer as in successive
// overrelaxation, which takes fewer sweeps; where a quad is inverted there, the step to the middle of the neighbours.
inline Coordinates step_inside(const Sliding_quads& quads, const int vertex)
{
  // Near a square, the bound bends 1 / `weight_of_side_ratio` times as much as the distortion where sides get longer.
  const double overrelaxation = 2.2;
  const Vertex_plane plane(quads, vertex);
  Distortion_expansion expansion;
  Plane_vector sum{ 0, 0 };
  bool is_regular = true;
  for(const int* c = quads.corners_begin(vertex); c != quads.corners_end(vertex); ++c)
  {
    const std::array<int, 4>& q = quads.quad(*c / 4);
    const Plane_vector a = plane.coordinates(quads.point(q[(*c + 1) % 4]));
    const Plane_vector b = plane.coordinates(quads.point(q[(*c + 2) % 4]));
    const Plane_vector d = plane.coordinates(quads.point(q[(*c + 3) % 4]));
    sum = sum + a;
    if(!is_regular)
      continue;
    // At the vertex x = 0 itself (a - x) x (d - x); at the next one (b - a) x (x - a); at the previous one
    // (x - d) x (b - d).
    is_regular =
      expansion.add({ a, true }, { d, true }, cross(a, d), quarter_turn(d - a))
      && expansion.add({ b - a, false }, { a, true }, -cross(b - a, a), quarter_turn(b - a))
      && expansion.add({ b - d, false }, { d, true }, -cross(d, b - d), -quarter_turn(b - d));
  }
  Plane_vector step;
  if(is_regular && expansion.step(step))
    step = overrelaxation * step;
  else
  {
    const std::ptrdiff_t n = quads.corners_end(vertex) - quads.corners_begin(vertex);
    step = 1. / static_cast<double>((std::max)(n, std::ptrdiff_t(1))) * sum;
  }
  return plane.in_space(step);
}

// The length on its arc where the parabola through three values of the distortion is least, at most half of the room
// away that the closer neighbour leaves. If a value is infinite or not known, the middle between the neighbours.
inline double length_of_least_distortion(const Sliding_quads& quads, const int vertex)
{
  const double here = quads.arc_order().length(vertex);
  const std::pair<double, double> range = quads.arc_order().range(vertex, quads.vertex(vertex).arc);
  const double room = (std::min)(here - range.first, range.second - here), difference = 0.05 * room;
  Slide back, ahead;
  if(!quads.slide_on_arc(vertex, here - difference, back) || !quads.slide_on_arc(vertex, here + difference, ahead))
    return (range.first + range.second) / 2;
  const double value = quads.shape_around(vertex).distortion;
  const double value_back = quads.shape_around(vertex, back).distortion;
  const double value_ahead = quads.shape_around(vertex, ahead).distortion;
  const double slope = (value_ahead - value_back) / (2 * difference);
  const double curvature = (value_ahead + value_back - 2 * value) / (difference * difference);
  if(!std::isfinite(slope) || !std::isfinite(curvature))
    return (range.first + range.second) / 2;
  const double largest_step = room / 2;
  const double step = curvature > 0 ? -slope / curvature : slope > 0 ? -largest_step : largest_step;
  return here + (std::min)(largest_step, (std::max)(-largest_step, step));
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_SLIDING_STEP_H
