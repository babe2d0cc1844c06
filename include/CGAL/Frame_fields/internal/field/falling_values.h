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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_FALLING_VALUES_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_FALLING_VALUES_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/accurate_solve.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A value of level k stands for the value times the k-th power of this unit.
constexpr double level_unit = 1e-250;

// A falling field does not fall more than by this factor from one face to the next. If the norms of two neighbors
// differ by more, then the smaller value vanishes.
constexpr double largest_fall = 1e20;

// Continues the solution of `matrix` * z = `right_hand_side` below the range of `double`.
//
// On a rough surface |z| falls exponentially with the distance from the faces that ask for a direction, and underflows
// to 0 in long patches. Let U be the unknowns below `level_unit`. Divided by this unit, and set to 0 outside U, they
// solve matrix * x = h. Here h is 0 except in the rows of the entries between U and the other unknowns, where it
// follows from the values known so far. So each level costs one more solution with the same factorization, and the
// result is that of an arithmetic with unbounded exponents. Nothing is solved if no value falls so far.
template <typename Solver>
class Falling_values
{
public:
  typedef std::complex<double> Complex;

  Falling_values(Solver& solver, const Hermitian_matrix<Complex>& matrix, const std::vector<Complex>& right_hand_side,
                 std::vector<Complex>& z)
    : m_solver(solver), m_matrix(matrix), m_z(z), m_level(z.size(), 0)
  {
    m_is_below.resize(z.size());
    for(std::size_t i = 0; i < z.size(); ++i)
      m_is_below[i] = is_small(z[i]) && magnitude(right_hand_side[i]) <= largest_fall * level_unit;
  }

  // Sets the level of each unknown, and replaces the values of those whose level is not 0. `level` is empty if all
  // levels are 0. The solver must hold the factors of the matrix. Returns `false` if it fails.
  bool find(std::vector<int>& level)
  {
    level.clear();
    int number_below = leave_out_vanishing_values(std::vector<char>(m_z.size(), true));
    while(number_below > 0)
    {
      const std::vector<Complex> h = right_hand_side_below();
      if(std::all_of(h.begin(), h.end(), [](const Complex& h_i) { return h_i == Complex(0); }))
        break; // values that are 0, not small
      std::vector<Complex> x;
      if(!accurate_solve(m_solver, m_matrix, h, x))
        return false;
      const std::vector<char> was_below = m_is_below;
      for(std::size_t i = 0; i < m_z.size(); ++i)
        if(was_below[i])
        {
          m_z[i] = x[i];
          ++m_level[i];
          m_is_below[i] = is_small(x[i]);
        }
      level = m_level;
      const int number_before = number_below;
      number_below = leave_out_vanishing_values(was_below);
      if(number_below == number_before)
        break;
    }
    return true;
  }

private:
  static bool is_small(const Complex& value) { return magnitude(value) < level_unit; }

  template <typename Visit>
  void for_each_entry(const Visit& visit) const
  {
    for(int j = 0; j < m_matrix.size(); ++j)
      for(int k = m_matrix.column_begin[j] + 1; k < m_matrix.column_begin[j + 1]; ++k)
        visit(m_matrix.row[k], j, m_matrix.value[k]);
  }

  // Takes out of U the values that have a neighbor which is much larger or of another level: they vanish. Returns how
  // many unknowns are left in U.
  int leave_out_vanishing_values(const std::vector<char>& is_of_this_level)
  {
    if(std::find(m_is_below.begin(), m_is_below.end(), true) == m_is_below.end())
      return 0;
    const auto is_far = [&](const int i)
    { return !is_of_this_level[i] || magnitude(m_z[i]) > largest_fall * level_unit; };
    for_each_entry([&](const int i, const int j, const Complex&)
    {
      if(m_is_below[i] && is_far(j))
        m_is_below[i] = false;
      if(m_is_below[j] && is_far(i))
        m_is_below[j] = false;
    });
    return static_cast<int>(std::count(m_is_below.begin(), m_is_below.end(), true));
  }

  std::vector<Complex> right_hand_side_below() const
  {
    std::vector<Complex> h(m_z.size(), Complex(0));
    for_each_entry([&](const int i, const int j, const Complex& a_ij)
    {
      if(m_is_below[i] == m_is_below[j])
        return;
      const double sign = m_is_below[i] ? 1 : -1;
      h[i] -= sign * a_ij * (m_z[j] / level_unit);
      h[j] += sign * std::conj(a_ij) * (m_z[i] / level_unit);
    });
    return h;
  }

  Solver& m_solver;
  const Hermitian_matrix<Complex>& m_matrix;
  std::vector<Complex>& m_z;
  std::vector<int> m_level;     // per unknown
  std::vector<char> m_is_below; // per unknown: whether it is to be found again with the next level
};

// The norm of a value of level `level` in terms of another level.
inline double norm_at_level(const std::complex<double>& value, const int level, const int other_level)
{
  if(level == other_level || value == std::complex<double>(0))
    return std::abs(value);
  return std::abs(value) * std::pow(level_unit, level - other_level);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_FALLING_VALUES_H
