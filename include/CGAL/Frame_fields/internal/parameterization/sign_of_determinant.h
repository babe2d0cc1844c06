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

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A signed integer of 128 bits, high * 2^64 + low, since not all compilers have such a type.
struct Wide_integer
{
  std::int64_t high;
  std::uint64_t low;
};

inline Wide_integer operator-(const Wide_integer& a)
{
  const std::uint64_t low = ~a.low + 1;
  const std::uint64_t high = ~static_cast<std::uint64_t>(a.high) + (low == 0 ? 1 : 0);
  return { static_cast<std::int64_t>(high), low };
}

inline Wide_integer operator-(const Wide_integer& a, const Wide_integer& b)
{
  const std::uint64_t high =
    static_cast<std::uint64_t>(a.high) - static_cast<std::uint64_t>(b.high) - (a.low < b.low ? 1 : 0);
  return { static_cast<std::int64_t>(high), a.low - b.low };
}

// The product of two factors of absolute value below 2^63.
inline Wide_integer wide_product(const std::int64_t a, const std::int64_t b)
{
  const std::uint64_t x = static_cast<std::uint64_t>(a < 0 ? -a : a), y = static_cast<std::uint64_t>(b < 0 ? -b : b);
  const std::uint64_t mask = 0xffffffffu;
  const std::uint64_t low = (x & mask) * (y & mask);
  const std::uint64_t middle = (x >> 32) * (y & mask) + (low >> 32); // below 2^64
  const std::uint64_t other_middle = (x & mask) * (y >> 32) + (middle & mask);
  const std::uint64_t high = (x >> 32) * (y >> 32) + (middle >> 32) + (other_middle >> 32);
  const Wide_integer product = { static_cast<std::int64_t>(high), (other_middle << 32) | (low & mask) };
  return (a < 0) != (b < 0) ? -product : product;
}

// a d - b c of integers of absolute value below 2^62.
inline Wide_integer wide_determinant(const std::int64_t a, const std::int64_t b, const std::int64_t c,
                                     const std::int64_t d)
{
  return wide_product(a, d) - wide_product(b, c);
}

inline int sign_of_determinant(const std::int64_t a, const std::int64_t b, const std::int64_t c, const std::int64_t d)
{
  const Wide_integer determinant = wide_determinant(a, b, c, d);
  if(determinant.high < 0)
    return -1;
  return determinant.high > 0 || determinant.low > 0 ? 1 : 0;
}

// The value to within rounding; `a` must be above -2^127.
inline double to_double(const Wide_integer& a)
{
  if(a.high < 0)
    return -to_double(-a);
  return std::ldexp(static_cast<double>(a.high), 64) + static_cast<double>(a.low);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SIGN_OF_DETERMINANT_H
