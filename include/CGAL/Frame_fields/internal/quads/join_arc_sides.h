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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_JOIN_ARC_SIDES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_JOIN_ARC_SIDES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The points from `arc_points_of_side()` of an arc that is no loop, in the direction of the arc and without its ends.
// There must be at least one point; the first one, at the start of the side, is dropped.
inline std::vector<double> inner_points(std::vector<double> points, const bool is_first_side)
{
  points.erase(points.begin());
  if(!is_first_side)
    std::reverse(points.begin(), points.end());
  return points;
}

// The points from `arc_points_of_side()` of a loop, in the direction of the arc. They increase but for one jump; behind
// the jump, the length of the loop is added so that all increase.
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
  bool has_free_bends = false;                     // there is no point at some of the bends
};

// The shift for which the points i + shift of the loop `to` are nearest to the points i of `from`, in O(n log n). Both
// must have the same number of points.
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
  // As the points increase, each difference grows with the shift, and the sum of their absolute values has one minimum:
  // bisection finds it.
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

// The mean of point i of a loop and point i + shift of another one, moved by whole turns. Without a shift, also that of
// the points of arcs.
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

// Joins the points of the two sides of an arc: the result is `fixed` unless that is empty, the mean if both sides have
// points, and the points of the only side that has some otherwise. All that are not empty must have equally many
// points.
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

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_JOIN_ARC_SIDES_H
