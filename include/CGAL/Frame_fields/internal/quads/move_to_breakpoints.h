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
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

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
  // The points of a loop as they were unrolled may begin before or behind the first breakpoint.
  const double begin = is_loop ? std::floor(points[0] / whole) * whole : 0;
  std::vector<double> goals;
  for(const int place : breakpoints)
    goals.push_back(begin + arc_points.length_at(arc, place, 0));
  if(is_loop)
  {
    for(double& goal : goals)
      if(goal < points[0] - whole / (2 * n))
        goal += whole;
    std::sort(goals.begin(), goals.end());
  }

  std::vector<int> chosen(m); // per goal: the nearest point that leaves enough points for the other goals
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

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MOVE_TO_BREAKPOINTS_H
