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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SIGN_OF_DETERMINANT_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SIGN_OF_DETERMINANT_H

#include <cstdint>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The sign of a d - b c, exactly, for numbers of less than 2^60. Not every compiler has the 128 bits
// that the products need.
inline int sign_of_determinant(const std::int64_t a, const std::int64_t b, const std::int64_t c, const std::int64_t d)
{
  const int bits = 30;
  const std::int64_t mask = (std::int64_t(1) << bits) - 1;
  const auto high = [](const std::int64_t x) { return x >> bits; }; // rounded down
  const auto low = [](const std::int64_t x) { return x & mask; };
  std::int64_t lowest = low(a) * low(d) - low(b) * low(c);
  std::int64_t middle = high(a) * low(d) + low(a) * high(d) - high(b) * low(c) - low(b) * high(c);
  std::int64_t highest = high(a) * high(d) - high(b) * high(c);
  middle += lowest >> bits;
  lowest &= mask;
  highest += middle >> bits;
  middle &= mask;
  if(highest != 0)
    return highest > 0 ? 1 : -1;
  return middle != 0 || lowest != 0 ? 1 : 0;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SIGN_OF_DETERMINANT_H
