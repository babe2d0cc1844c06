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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LINEAR_ACCURATE_SOLVE_H
#define CGAL_FRAME_FIELDS_INTERNAL_LINEAR_ACCURATE_SOLVE_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/conjugate.h>
#include <CGAL/Frame_fields/internal/linear/solve.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The residual of a row of a solved system is at most this fraction of the terms in the row. Direct solvers leave about
// 1e-15.
constexpr double largest_row_error = 1e-12;

// Terms below this in systems of complex values may have lost digits, as they are near the smallest normal `double`.
constexpr double smallest_complex_term = 1e-290;

// The absolute value, or for complex numbers an upper bound within a factor of sqrt(2) that needs no root.
inline double magnitude(const double x) { return std::abs(x); }
inline double magnitude(const std::complex<double>& x) { return std::abs(x.real()) + std::abs(x.imag()); }

// What is added to the magnitude of an unknown in the diagonal term of its row: its size where an error relative to it
// does not matter. Real unknowns are taken for values of about 1, as angles in radians are; complex ones may have any
// size.
inline double negligible_term(const double) { return 1; }
inline double negligible_term(const std::complex<double>&) { return smallest_complex_term; }

// The residuals of the rows that exceed `largest_row_error`, 0 for the others, and the largest magnitude of them.
template <typename Scalar>
struct Row_errors
{
  Row_errors(const Hermitian_matrix<Scalar>& matrix, const std::vector<Scalar>& right_hand_side,
             const std::vector<Scalar>& x)
    : residual(right_hand_side)
  {
    std::vector<double> terms(x.size());
    for(std::size_t i = 0; i < x.size(); ++i)
      terms[i] = magnitude(right_hand_side[i]);
    for(int j = 0; j < matrix.size(); ++j)
    {
      const int diagonal = matrix.column_begin[j];
      residual[j] -= matrix.value[diagonal] * x[j];
      terms[j] += magnitude(matrix.value[diagonal]) * (magnitude(x[j]) + negligible_term(Scalar()));
      for(int k = diagonal + 1; k < matrix.column_begin[j + 1]; ++k)
      {
        const int i = matrix.row[k];
        const double size = magnitude(matrix.value[k]);
        residual[i] -= matrix.value[k] * x[j];
        residual[j] -= conjugate(matrix.value[k]) * x[i];
        terms[i] += size * magnitude(x[j]);
        terms[j] += size * magnitude(x[i]);
      }
    }
    for(std::size_t i = 0; i < x.size(); ++i)
    {
      if(magnitude(residual[i]) <= largest_row_error * terms[i])
        residual[i] = 0;
      else
        largest = (std::max)(largest, magnitude(residual[i]));
    }
  }

  std::vector<Scalar> residual;
  double largest = 0;
};

// Solves a system, with a solver that has factored its matrix, such that every row holds to `largest_row_error`. The
// solution of a connected system may fall by many powers of ten from one place to the next; its small values are then
// as accurate as the large ones. A direct solver does that in one step. The errors of an iterative one are small
// against the largest values only; it must solve again for the residuals of the rows that do not hold. Rows that hold
// are left out, as their rounding errors would drown the others. Returns `false` if the solver fails, a solution is not
// finite, or 100 steps are not enough.
template <typename Solver, typename Scalar>
bool accurate_solve(Solver& solver, const Hermitian_matrix<Scalar>& matrix, const std::vector<Scalar>& right_hand_side,
                    std::vector<Scalar>& solution)
{
  const int maximum_number_of_steps = 100; // 50 steps of 6 digits go through the range of `double`
  if(!checked_solve(solver, right_hand_side, solution))
    return false;
  for(int step = 0; step < maximum_number_of_steps; ++step)
  {
    Row_errors<Scalar> errors(matrix, right_hand_side, solution);
    if(!(errors.largest > 0))
      return true;
    for(Scalar& r : errors.residual)
      r /= errors.largest; // whose square may be out of range
    std::vector<Scalar> correction;
    if(!checked_solve(solver, errors.residual, correction))
      return false;
    for(std::size_t i = 0; i < solution.size(); ++i)
      solution[i] += errors.largest * correction[i];
  }
  return false;
}

// Factors the matrix and solves as `accurate_solve()` does; a system without unknowns has the empty solution. Returns
// `false` if one of the two fails.
template <typename Solver, typename Scalar>
bool factor_and_solve(Solver& solver, const Hermitian_matrix<Scalar>& matrix,
                      const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution)
{
  if(matrix.size() == 0)
  {
    solution.clear();
    return true;
  }
  return solver.factor(matrix) && accurate_solve(solver, matrix, right_hand_side, solution);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LINEAR_ACCURATE_SOLVE_H
