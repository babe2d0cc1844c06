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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_SEAMLESS_CHARTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_SEAMLESS_CHARTS_H

#include <CGAL/Frame_fields/internal/parameterization/sign_of_determinant.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point or a vector in the chart of a face.
struct Grid_vector
{
  std::int64_t u, v;
};

inline Grid_vector operator+(const Grid_vector& a, const Grid_vector& b) { return { a.u + b.u, a.v + b.v }; }
inline Grid_vector operator-(const Grid_vector& a, const Grid_vector& b) { return { a.u - b.u, a.v - b.v }; }
inline bool operator==(const Grid_vector& a, const Grid_vector& b) { return a.u == b.u && a.v == b.v; }

// Directions are numbered counter-clockwise: 0 is (1, 0), 1 is (0, 1), 2 is (-1, 0), 3 is (0, -1).

// The component of a vector in a direction.
inline std::int64_t along(const int direction, const Grid_vector& a)
{
  switch(direction & 3)
  {
    case 0: return a.u;
    case 1: return a.v;
    case 2: return -a.u;
    default: return -a.v;
  }
}

// The component of a vector to the left of a direction.
inline std::int64_t left_of(const int direction, const Grid_vector& a) { return along(direction + 1, a); }

inline Grid_vector rotate(const Grid_vector& a, const int quarter_turns)
{
  return { along(4 - quarter_turns, a), along(5 - quarter_turns, a) };
}

// A straight line that starts at `origin` and runs into a direction, in the chart of a face. The origin may be far from
// the face.
struct Grid_ray
{
  int direction;
  Grid_vector origin;

  // The signed length from the origin to the foot of a point.
  std::int64_t time(const Grid_vector& point) const { return along(direction, point - origin); }

  // Positive for points to the left.
  std::int64_t offset(const Grid_vector& point) const { return left_of(direction, point - origin); }
};

// A direction in which a vertex can be left: the corner that holds it, and the direction in the chart of its face.
// `slot` numbers the directions around the vertex counter-clockwise.
struct Port
{
  int corner, direction, slot;
};

// The charts of a certified map and what changes from one to the next.
class Seamless_charts
{
public:
  Seamless_charts(const Cut_surface& surface, const Seamless_map& map) : m_surface(surface), m_map(map) {}

  const Cut_surface& surface() const { return m_surface; }

  Grid_vector point(const int corner) const { return { m_map.u[corner], m_map.v[corner] }; }
  Grid_vector edge(const int halfedge) const { return point(halfedge) - point(previous_of(halfedge)); }

  // Take a direction, a point or a ray from the chart of the face of an unconstrained halfedge to the chart on its
  // other side.
  int direction_across(const int halfedge, const int direction) const
  {
    return (direction + m_map.quarter_turns[halfedge]) & 3;
  }

  Grid_vector point_across(const int halfedge, const Grid_vector& p) const
  {
    return rotate(p - point(halfedge), m_map.quarter_turns[halfedge])
         + point(previous_of(m_surface.opposite[halfedge]));
  }

  Grid_ray ray_across(const int halfedge, const Grid_ray& ray) const
  {
    return { direction_across(halfedge, ray.direction), point_across(halfedge, ray.origin) };
  }

  // The direction of a halfedge that runs along an axis, -1 otherwise.
  int direction_of(const int halfedge) const
  {
    const Grid_vector vector = edge(halfedge);
    for(int direction = 0; direction < 4; ++direction)
      if(left_of(direction, vector) == 0 && along(direction, vector) > 0)
        return direction;
    return -1;
  }

  // Whether a direction leaves the vertex of a corner into its face, or along its clockwise edge.
  bool holds(const int corner, const int direction) const
  {
    const Grid_vector clockwise_edge = edge(next_of(corner)), other_edge = edge(corner);
    const std::int64_t side = left_of(direction, clockwise_edge);
    return (side < 0 || (side == 0 && along(direction, clockwise_edge) > 0)) && left_of(direction, other_edge) < 0;
  }

  // Turns counter-clockwise around the vertex of `corner`, starting there, to the corner that holds the direction of
  // the ray, and changes the ray to its chart. Returns -1 if there is none.
  int turn_to_direction(const int corner, Grid_ray& ray) const
  {
    return turn_to(corner, ray, [&](const int c) { return holds(c, ray.direction); });
  }

  // The same to the first corner of the sector.
  int turn_to_first_corner(const int corner, Grid_ray& ray) const
  {
    const int first_corner = m_surface.first_corner[m_surface.sector[corner]];
    return turn_to(corner, ray, [&](const int c) { return c == first_corner; });
  }

  // The axis directions of a sector in counter-clockwise order, without those of its constrained edges. In a sector on
  // constrained edges the clockwise edge is slot 0. In a closed one with four ports the slots are the directions in the
  // chart of the first corner.
  std::vector<Port> ports(const int sector) const
  {
    std::vector<Port> result;
    const int first_corner = m_surface.first_corner[sector];
    const bool is_constrained = m_surface.is_constrained_sector(sector);
    int direction = first_direction(first_corner) + (is_constrained ? 1 : 0);
    for_each_corner(m_surface.opposite, first_corner, [&](const int corner)
    {
      for(; holds(corner, direction); ++direction)
        result.push_back({ corner, direction & 3, static_cast<int>(result.size()) + (is_constrained ? 1 : 0) });
      if(!m_surface.is_constrained(corner))
        direction += m_map.quarter_turns[corner];
    });
    if(!is_constrained && result.size() == 4)
      for(Port& port : result)
        port.slot = (port.slot + first_direction(first_corner)) & 3;
    return result;
  }

  // On which side of a halfedge a point of the chart of its face is: 1 if it is on the side of the face.
  int side(const int halfedge, const Grid_vector& p) const
  {
    const Grid_vector vector = edge(halfedge), difference = p - point(halfedge);
    return sign_of_determinant(vector.u, vector.v, difference.u, difference.v);
  }

  // Bounds of the coordinate that grows or falls along the line of a ray, in a face through which it runs. The rounding
  // errors are below 8 steps of the grid, since coordinates are below 2^50.
  std::pair<std::int64_t, std::int64_t> range_in_face(const int face, const Grid_ray& ray) const
  {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for(int halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
    {
      const double at_source = static_cast<double>(ray.offset(point(previous_of(halfedge))));
      const double at_target = static_cast<double>(ray.offset(point(halfedge)));
      if((at_source < 0 && at_target < 0) || (at_source > 0 && at_target > 0))
        continue;
      const double share = at_target == at_source ? 0 : at_target / (at_target - at_source);
      const double progress = static_cast<double>(along(ray.direction & 1, edge(halfedge)));
      const double coordinate = static_cast<double>(along(ray.direction & 1, point(halfedge))) - share * progress;
      first = (std::min)(first, coordinate);
      last = (std::max)(last, coordinate);
    }
    if(first > last)
      return { 1, 0 };
    return { static_cast<std::int64_t>(std::floor(first)) - 8, static_cast<std::int64_t>(std::ceil(last)) + 8 };
  }

  // The face into which a ray goes from its origin. The origin must be inside `face` or inside one of its edges. If the
  // ray runs along this edge, the result is the face to the left of the ray. -1 if the ray leaves the patch.
  // `direction` is the direction of the ray in the chart of the result.
  int face_ahead(const int face, const Grid_ray& ray, int& direction) const
  {
    direction = ray.direction;
    for(int halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
    {
      if(side(halfedge, ray.origin) != 0)
        continue;
      const std::int64_t turn = left_of(ray.direction, edge(halfedge)); // negative if the ray points into the face
      if(turn < 0 || (turn == 0 && along(ray.direction, edge(halfedge)) > 0))
        return face;
      if(m_surface.is_constrained(halfedge))
        return -1;
      direction = direction_across(halfedge, ray.direction);
      return face_of(m_surface.opposite[halfedge]);
    }
    return face;
  }

  // The length in space of a vector of length 1 in a direction of the chart of a face, in the unit of
  // `Cut_surface::length`.
  double length_of_unit(const int face, const int direction) const
  {
    const int h = 3 * face;
    const Grid_vector a = edge(h), b = edge(h + 1);
    const double determinant = to_double(wide_determinant(a.u, a.v, b.u, b.v));
    const double share_of_b = -static_cast<double>(left_of(direction, a)) / determinant;
    const double share_of_a = static_cast<double>(left_of(direction, b)) / determinant;
    // In the plane of the face, whose first edge is along x. (The law of cosines would lose the height of a flat face.)
    const double length_of_b = share_of_b * m_surface.length[h + 1];
    const double x = share_of_a * m_surface.length[h] - length_of_b * std::cos(m_surface.angle[h]);
    const double y = length_of_b * std::sin(m_surface.angle[h]);
    return std::hypot(x, y);
  }

private:
  // The axis direction that comes first counter-clockwise from the clockwise edge of a corner, or runs along it.
  int first_direction(const int corner) const
  {
    const Grid_vector vector = edge(next_of(corner));
    int direction = 0;
    while(direction < 3 && !(along(direction, vector) > 0 && left_of(direction, vector) <= 0))
      ++direction;
    return direction;
  }

  template <typename Accepts>
  int turn_to(int corner, Grid_ray& ray, const Accepts& accepts) const
  {
    const int start = corner;
    do
    {
      if(accepts(corner))
        return corner;
      if(m_surface.is_constrained(corner))
        return -1;
      ray = ray_across(corner, ray);
      corner = previous_of(m_surface.opposite[corner]);
    } while(corner != start);
    return -1;
  }

  const Cut_surface& m_surface;
  const Seamless_map& m_map;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_SEAMLESS_CHARTS_H
