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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COORDINATE_ROUNDING_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COORDINATE_ROUNDING_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Tells whether a number is the `double` nearest to a decimal number with this many significant digits.
inline bool has_decimal_digits(const double number, const int number_of_digits)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.*e", number_of_digits - 1, number);
  return std::strtod(text, nullptr) == number;
}

// How far rounding may have moved a coordinate before it was stored, in units of the points, which must be finite; 0 if
// all coordinates are zero. Many files hold numbers of type `float`, or decimal numbers of 6 to 15 digits: what was a
// plane is one within that rounding only. The numbers themselves tell which; numbers of full precision are recognized
// after the first few of them. Takes linear time.
inline double coordinate_rounding(const std::vector<Coordinates>& points)
{
  const int fewest_digits = 6, most_digits = 15;
  bool are_floats = true;
  int number_of_digits = fewest_digits;
  double largest = 0;
  for(const Coordinates& point : points)
    for(const double coordinate : point)
    {
      largest = (std::max)(largest, std::abs(coordinate));
      are_floats = are_floats && static_cast<double>(static_cast<float>(coordinate)) == coordinate;
      while(number_of_digits <= most_digits && !has_decimal_digits(coordinate, number_of_digits))
        ++number_of_digits;
    }
  if(largest == 0)
    return 0;
  if(are_floats)
    return std::ldexp(largest, -24);
  if(number_of_digits > most_digits)
    return std::ldexp(largest, -53);
  return std::pow(10., std::floor(std::log10(largest)) + 1 - number_of_digits) / 2;
}

// How far from a common plane the points of coplanar faces may be, unless the caller says so.
inline double default_flip_tolerance(const std::vector<Coordinates>& points)
{
  const double roundings = 8;
  return roundings * coordinate_rounding(points);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COORDINATE_ROUNDING_H
