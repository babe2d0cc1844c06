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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_FRAME_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_FRAME_H

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A frame: the angle of its branch 0, and the skewness by which the angle to its branch 1 differs from a right one,
// both in radians. `from_angles()` takes the second angle modulo pi: the skewness is in [-pi / 2, pi / 2].
struct Frame
{
  double alpha, rho;

  static Frame from_angles(const double first, const double second)
  {
    const double between = std::remainder(second - first, 2 * CGAL_PI);
    return { first, (between < 0 ? between + CGAL_PI : between) - CGAL_PI / 2 };
  }
};

// Turns the branch that is nearest to a line, at the angle `line` in radians, onto it and keeps the other branch.
// Returns the absolute value of the turn, at most pi / 2.
inline double align(Frame& frame, const double line)
{
  const double turn_of_first = std::remainder(line - frame.alpha, CGAL_PI);
  const double turn_of_second = std::remainder(line - frame.alpha - CGAL_PI / 2 - frame.rho, CGAL_PI);
  if(std::abs(turn_of_first) <= std::abs(turn_of_second))
  {
    frame.alpha += turn_of_first;
    frame.rho -= turn_of_first;
    return std::abs(turn_of_first);
  }
  frame.rho += turn_of_second;
  return std::abs(turn_of_second);
}

// The integer p_ij for which r0^2 + r1^2 (eq. (4) of the paper) is least. The cost is half of that sum.
inline int nearest_matching(const double unmatched_rotation, const double rho_i, const double rho_j)
{
  const auto cost = [&](const int p)
  {
    const double mean = unmatched_rotation + p * CGAL_PI / 2 + (rho_j - rho_i) / 2;
    const double half_difference = (p % 2 == 0 ? rho_j - rho_i : rho_j + rho_i) / 2;
    return mean * mean + half_difference * half_difference;
  };
  const int nearest_mean =
    static_cast<int>(std::lround(-(unmatched_rotation + (rho_j - rho_i) / 2) / (CGAL_PI / 2)));
  const int candidates[] = { nearest_mean, nearest_mean - 1, nearest_mean + 1 };
  return *std::min_element(std::begin(candidates), std::end(candidates),
                           [&](const int p, const int q) { return cost(p) < cost(q); });
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_FRAME_H
