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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MOVE_TO_BREAKPOINTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MOVE_TO_BREAKPOINTS_H

#include <CGAL/Frame_fields/internal/quads/Arc_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The nondecreasing numbers with the least sum of squared differences from the given ones (pool adjacent violators).
inline std::vector<double> nearest_nondecreasing(const std::vector<double>& numbers)
{
  std::vector<std::pair<double, int> > pools; // their means and sizes
  for(const double number : numbers)
  {
    pools.emplace_back(number, 1);
    while(pools.size() > 1 && !(pools[pools.size() - 2].first < pools.back().first))
    {
      const std::pair<double, int> last = pools.back();
      pools.pop_back();
      std::pair<double, int>& pool = pools.back();
      pool.first = (pool.first * pool.second + last.first * last.second) / (pool.second + last.second);
      pool.second += last.second;
    }
  }
  std::vector<double> result;
  for(const std::pair<double, int>& pool : pools)
    result.insert(result.end(), pool.second, pool.first);
  return result;
}

// The place of each goal among the points of an arc, all in increasing order: 1.5 in the middle between points 1 and 2.
// The ends of the arc count as points -1 and n, or the last point and the first one on a loop. `whole` is its length.
inline std::vector<double> places_among_points(const std::vector<double>& points, const std::vector<double>& goals,
                                               const bool is_loop, const double whole)
{
  std::vector<double> result;
  for(const double goal : goals)
  {
    const std::ptrdiff_t above = std::lower_bound(points.begin(), points.end(), goal) - points.begin();
    const double from = above > 0 ? points[above - 1] : is_loop ? points.back() - whole : 0;
    const double to = above < static_cast<std::ptrdiff_t>(points.size()) ? points[above]
                                                                         : is_loop ? points.front() + whole : whole;
    const double behind = to > from ? (std::min)(1., (std::max)(0., (to - goal) / (to - from))) : 0;
    result.push_back(static_cast<double>(above) - behind);
  }
  return result;
}

// A different one of n points for each goal, near its place among them. There must be at least as many points as goals.
// Where several goals are nearest to one point, they get it and its neighbors on both sides.
inline std::vector<int> points_near_places(const std::vector<double>& places, const int n)
{
  const int m = static_cast<int>(places.size());
  std::vector<double> excess(places); // over the least place that each may have
  for(int g = 0; g < m; ++g)
    excess[g] -= g;
  std::vector<int> result;
  const std::vector<double> nondecreasing = nearest_nondecreasing(excess);
  for(int g = 0; g < m; ++g)
    result.push_back(g + (std::min)(n - m, (std::max)(0, static_cast<int>(std::lround(nondecreasing[g])))));
  return result;
}

// The lengths of breakpoints from the beginning of their arc, in increasing order. On a loop, where the points may have
// been unrolled over its end, they lie in the same turn as the points.
inline std::vector<double> lengths_of_breakpoints(const Arc_points& arc_points, const int arc, const bool is_loop,
                                                  const std::vector<int>& breakpoints,
                                                  const std::vector<double>& points)
{
  const double whole = arc_points.length(arc), begin = is_loop ? std::floor(points[0] / whole) * whole : 0;
  std::vector<double> goals;
  for(const int place : breakpoints)
    goals.push_back(begin + arc_points.length_at(arc, place, 0));
  if(is_loop)
  {
    for(double& goal : goals)
      if(goal < points[0] - whole / (2 * static_cast<double>(points.size())))
        goal += whole;
    std::sort(goals.begin(), goals.end());
  }
  return goals;
}

// Moves the chosen points to the goals, and stretches the other points between them.
inline void move_to_goals(const std::vector<int>& chosen, const std::vector<double>& goals, const bool is_loop,
                          const double whole, std::vector<double>& points)
{
  const int n = static_cast<int>(points.size()), m = static_cast<int>(goals.size());
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

// For each goal the nearest point that is behind that of the goal before and leaves enough points for the other goals.
inline std::vector<int> nearest_points_in_turn(const std::vector<double>& points, const std::vector<double>& goals)
{
  const int n = static_cast<int>(points.size()), m = static_cast<int>(goals.size());
  std::vector<int> result;
  for(int g = 0; g < m; ++g)
  {
    int nearest = static_cast<int>(std::lower_bound(points.begin(), points.end(), goals[g]) - points.begin());
    if(nearest > 0 && (nearest == n || goals[g] - points[nearest - 1] < points[nearest] - goals[g]))
      --nearest;
    result.push_back((std::min)((std::max)(nearest, result.empty() ? 0 : result.back() + 1), n - m + g));
  }
  return result;
}

// Moves to each breakpoint of an arc a different point near it, and stretches the other points between them. Does
// nothing if there are fewer points than breakpoints. Points are lengths from the beginning of the arc, in increasing
// order.
inline void move_to_breakpoints(const Arc_points& arc_points, const int arc, const bool is_loop,
                                const std::vector<int>& breakpoints, std::vector<double>& points)
{
  const int n = static_cast<int>(points.size()), m = static_cast<int>(breakpoints.size());
  if(m == 0 || n < m)
    return;
  const double whole = arc_points.length(arc);
  const std::vector<double> goals = lengths_of_breakpoints(arc_points, arc, is_loop, breakpoints, points);
  move_to_goals(nearest_points_in_turn(points, goals), goals, is_loop, whole, points);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MOVE_TO_BREAKPOINTS_H
