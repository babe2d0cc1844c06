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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_PLACE_ARC_POINTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_PLACE_ARC_POINTS_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// How far a constrained halfedge runs in the map.
inline std::int64_t parametric_length(const Seamless_map& map, const int halfedge)
{
  const int source = previous_of(halfedge);
  return std::llabs(map.u[halfedge] - map.u[source]) + std::llabs(map.v[halfedge] - map.v[source]);
}

// How far a node on the border is behind the source of a constrained halfedge.
inline std::int64_t parametric_offset(const Seamless_map& map, const T_mesh_node& node, const int halfedge)
{
  if(node.halfedge < 0)
    return 0;
  const int source = previous_of(halfedge);
  return std::llabs(node.u - map.u[source]) + std::llabs(node.v - map.v[source]);
}

// A feature arc as a polyline, with positions by place and fraction and by length from its beginning.
class Arc_polyline
{
public:
  Arc_polyline(const Cut_surface& surface, const Feature_arc& arc)
    : m_length_before(1, 0)
  {
    for(const int h : arc.halfedges)
      m_length_before.push_back(m_length_before.back() + surface.length[h]);
  }

  double length() const { return m_length_before.back(); }

  double length_at(const int place, const double fraction) const
  {
    return m_length_before[place] + fraction * (m_length_before[place + 1] - m_length_before[place]);
  }

  // The place plus the fraction of the point at a length from the beginning.
  double position_at(const double length) const
  {
    const auto after = std::upper_bound(m_length_before.begin() + 1, m_length_before.end() - 1, length);
    const int place = static_cast<int>(after - m_length_before.begin()) - 1;
    const double fraction =
      (length - m_length_before[place]) / (m_length_before[place + 1] - m_length_before[place]);
    return place + (std::min)(1., (std::max)(0., fraction));
  }

private:
  std::vector<double> m_length_before;
};

// Where the map of one side puts the points of an arc, by their lengths from the beginning of the arc, one for each
// edge of the side, in the order of the side, from the source of its first piece on.
inline std::vector<double> arc_points_of_side(const Cut_surface& surface, const Seamless_map& map,
                                              const Feature_network& network, const Arc_polyline& polyline,
                                              const T_mesh& t_mesh, const Arc_side& side,
                                              const std::vector<int>& number_of_edges)
{
  std::vector<double> result;
  for(const int p : side.pieces)
  {
    const T_mesh_piece& piece = t_mesh.pieces[p];
    int halfedge = piece.halfedge;
    // From the source of the present halfedge to the beginning of the piece, and to the point that comes next.
    double begin = static_cast<double>(parametric_offset(map, t_mesh.nodes[piece.source], halfedge));
    for(int i = 0; i < number_of_edges[p]; ++i)
    {
      const double wanted = static_cast<double>(piece.parametric_length) * i / number_of_edges[p];
      double length = static_cast<double>(parametric_length(map, halfedge));
      while(begin + wanted > length)
      {
        int next = next_of(halfedge);
        while(!surface.is_constrained(next))
          next = next_of(surface.opposite[next]);
        if(network.arc[next] != network.arc[halfedge])
          break; // rounding at the end of the arc
        halfedge = next;
        begin -= length;
        length = static_cast<double>(parametric_length(map, halfedge));
      }
      const double fraction = (std::min)(1., (begin + wanted) / length);
      const bool is_first_side = is_of_first_side(network, halfedge);
      result.push_back(polyline.length_at(network.place[halfedge], is_first_side ? fraction : 1 - fraction));
    }
  }
  return result;
}

// The same for an arc that is no loop, in the direction of the arc, without the two ends.
inline std::vector<double> inner_points(std::vector<double> points, const bool is_first_side)
{
  points.erase(points.begin());
  if(!is_first_side)
    std::reverse(points.begin(), points.end());
  return points;
}

// Turns the points of a loop, increasing but for one jump, such that they increase from a first point on.
inline std::vector<double> unrolled_loop(std::vector<double> points, const bool is_first_side, const double length)
{
  if(!is_first_side)
    std::reverse(points.begin(), points.end());
  for(std::size_t i = 1; i < points.size(); ++i)
    while(points[i] < points[i - 1] && points[i] < points[0] + length)
      points[i] += length;
  return points;
}

// The points of an arc, by their lengths from its beginning.
struct Placed_arc
{
  std::vector<double> length;                      // increasing; inner points only, but all of a loop
  std::array<int, 2> first_of_side = { { 0, 0 } }; // for a loop: the point that each side's list begins with
};

// By how many places the points of a loop are shifted against as many others, so that they are nearest to them.
inline int shift_of_loop(const std::vector<double>& from, const std::vector<double>& to, const double length)
{
  const int n = static_cast<int>(from.size());
  const auto unrolled = [&](const int i) // any integer
  {
    const int turns = static_cast<int>(std::floor(static_cast<double>(i) / n));
    return to[i - turns * n] + turns * length;
  };
  const auto distance = [&](const int shift)
  {
    double sum = 0;
    for(int i = 0; i < n; ++i)
      sum += std::abs(unrolled(i + shift) - from[i]);
    return sum;
  };
  // Both increase, so the differences do with the shift: bisection finds where their sum is least.
  int low = -2 * n, high = 2 * n;
  while(low < high)
  {
    const int middle = low + (high - low) / 2;
    if(distance(middle) <= distance(middle + 1))
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

// Point i of a loop and point i + shift, turned by whole loops, in the middle between both.
inline std::vector<double> mean_of_loops(const std::vector<double>& first, const std::vector<double>& second,
                                         const int shift, const double length)
{
  const int n = static_cast<int>(first.size());
  std::vector<double> mean(first);
  for(int i = 0; i < n; ++i)
  {
    const int turns = static_cast<int>(std::floor(static_cast<double>(i + shift) / n));
    mean[i] = (first[i] + second[i + shift - turns * n] + turns * length) / 2;
  }
  return mean;
}

// Two points per edge of the triangle mesh: those of a patch that is filled.
inline std::vector<double> points_of_triangles(const Arc_polyline& polyline, const Feature_arc& arc)
{
  std::vector<double> result;
  for(std::size_t place = 0; place < arc.halfedges.size(); ++place)
    for(const double fraction : { 0., 0.5 })
      if(arc.is_loop || place > 0 || fraction > 0)
        result.push_back(polyline.length_at(static_cast<int>(place), fraction));
  return result;
}

// Moves points of an arc to its breakpoints, each to another one near it, and stretches the others between them.
// There are at least as many points as breakpoints.
inline void move_to_breakpoints(const Arc_polyline& polyline, const std::vector<int>& breakpoints, const bool is_loop,
                                std::vector<double>& points)
{
  const int n = static_cast<int>(points.size()), m = static_cast<int>(breakpoints.size());
  if(m == 0 || n < m)
    return;
  const double whole = polyline.length();
  // The points of a loop as they were unrolled may begin before or behind the first breakpoint.
  const double begin = is_loop ? std::floor(points[0] / whole) * whole : 0;
  std::vector<double> goals;
  for(const int place : breakpoints)
    goals.push_back(begin + polyline.length_at(place, 0));
  if(is_loop)
  {
    for(double& goal : goals)
      if(goal < points[0] - whole / (2 * n))
        goal += whole;
    std::sort(goals.begin(), goals.end());
  }

  std::vector<int> chosen(m); // the nearest point, as far as points before and behind suffice for the other goals
  int next = 0;
  for(int g = 0; g < m; ++g)
  {
    int nearest = static_cast<int>(std::lower_bound(points.begin(), points.end(), goals[g]) - points.begin());
    if(nearest > 0 && (nearest == n || goals[g] - points[nearest - 1] < points[nearest] - goals[g]))
      --nearest;
    chosen[g] = (std::min)((std::max)(nearest, next), n - m + g);
    next = chosen[g] + 1;
  }

  const std::vector<double> old_points(points);
  const auto stretch = [&](const int first, const int last, const double old_begin, const double old_end,
                           const double new_begin, const double new_end)
  {
    for(int i = first; i < last; ++i)
    {
      const double t = old_end > old_begin ? (old_points[i] - old_begin) / (old_end - old_begin) : 0.5;
      points[i] = new_begin + (std::min)(1., (std::max)(0., t)) * (new_end - new_begin);
    }
  };
  for(int g = 0; g < m; ++g)
    points[chosen[g]] = goals[g];
  for(int g = 0; g + 1 < m; ++g)
    stretch(chosen[g] + 1, chosen[g + 1], old_points[chosen[g]], old_points[chosen[g + 1]], goals[g], goals[g + 1]);
  const int first = chosen.front(), last = chosen.back();
  if(is_loop)
  {
    // Between the last goal and the first one of the next round.
    const double old_gap = old_points[first] + whole - old_points[last], gap = goals.front() + whole - goals.back();
    for(int i = last + 1; i < n + first; ++i)
    {
      const double turns = i < n ? 0 : whole;
      points[i % n] = goals.back() + (old_points[i % n] + turns - old_points[last]) / old_gap * gap - turns;
    }
  }
  else
  {
    stretch(0, first, 0, old_points[first], 0, goals.front());
    stretch(last + 1, n, old_points[last], whole, goals.back(), whole);
  }
}

inline std::vector<double> evenly_spaced_points(const double length, const int number_of_edges, const bool is_loop)
{
  std::vector<double> points;
  for(int i = is_loop ? 0 : 1; i < number_of_edges; ++i)
    points.push_back(length * i / number_of_edges);
  return points;
}

// Joins the points of the two sides. A side without points has no opinion; `fixed`, unless empty, has the only one.
inline Placed_arc join_sides(const std::array<std::vector<double>, 2>& sides, const std::vector<double>& fixed,
                             const bool is_loop, const double length)
{
  const std::vector<double>& reference = !fixed.empty() ? fixed : !sides[0].empty() ? sides[0] : sides[1];
  Placed_arc result{ reference, {} };
  std::array<int, 2> shift{ { 0, 0 } };
  for(int s = 0; s < 2 && is_loop; ++s)
    if(!sides[s].empty())
    {
      const int n = static_cast<int>(reference.size());
      shift[s] = shift_of_loop(reference, sides[s], length);
      result.first_of_side[s] = ((-shift[s]) % n + n) % n;
    }
  if(fixed.empty() && !sides[0].empty() && !sides[1].empty())
    result.length = mean_of_loops(sides[0], sides[1], shift[1], length);
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_PLACE_ARC_POINTS_H
