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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LINEAR_SMALLEST_EIGENVECTOR_H
#define CGAL_FRAME_FIELDS_INTERNAL_LINEAR_SMALLEST_EIGENVECTOR_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/accurate_solve.h>
#include <CGAL/Frame_fields/internal/linear/conjugate.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The matrix, of which the lower triangle is stored, times a vector.
template <typename Scalar>
std::vector<Scalar> product(const Hermitian_matrix<Scalar>& matrix, const std::vector<Scalar>& x)
{
  std::vector<Scalar> y(x.size(), Scalar(0));
  for(int j = 0; j < matrix.size(); ++j)
  {
    y[j] += matrix.value[matrix.column_begin[j]] * x[j];
    for(int k = matrix.column_begin[j] + 1; k < matrix.column_begin[j + 1]; ++k)
    {
      y[matrix.row[k]] += matrix.value[k] * x[j];
      y[j] += conjugate(matrix.value[k]) * x[matrix.row[k]];
    }
  }
  return y;
}

// The Euclidean norm.
template <typename Scalar>
double norm(const std::vector<Scalar>& x)
{
  double sum = 0;
  for(const Scalar& x_i : x)
    sum += std::norm(x_i);
  return std::sqrt(sum);
}

// Scales a vector, which must not be zero, to length 1.
inline void normalize(std::vector<std::complex<double> >& x)
{
  const double length = norm(x);
  for(std::complex<double>& x_i : x)
    x_i /= length;
}

// Sets x to a unit eigenvector of the smallest eigenvalue of a positive semi-definite matrix, by inverse iteration from
// `start`, which must not be zero. A shift that is small against the gaps between the small eigenvalues makes the
// matrix definite; entries should be of about 1. The iteration stops when the residual is small against the eigenvalue,
// or after 100 steps: what is left of other eigenvectors then belongs to eigenvalues nearly as small. Returns `false`
// if the matrix cannot be factored or a system cannot be solved.
template <typename Solver>
bool smallest_eigenvector(Solver& solver, Hermitian_matrix<std::complex<double> > matrix,
                          const std::vector<std::complex<double> >& start, std::vector<std::complex<double> >& x)
{
  const double shift = 1e-9;
  const double relative_residual = 1e-8;
  const int maximum_number_of_steps = 100;

  for(int j = 0; j < matrix.size(); ++j)
    matrix.value[matrix.column_begin[j]] += shift;
  if(!solver.factor(matrix))
    return false;

  x = start;
  normalize(x);
  for(int step = 0; step < maximum_number_of_steps; ++step)
  {
    std::vector<std::complex<double> > y;
    if(!accurate_solve(solver, matrix, x, y))
      return false;
    // Since matrix * y = x, the Rayleigh quotient of y and its residual need no product with the matrix.
    const double length = norm(y);
    if(!(length > 0))
      return false;
    std::complex<double> projection = 0;
    for(std::size_t i = 0; i < x.size(); ++i)
      projection += std::conj(y[i]) * x[i];
    const double eigenvalue = projection.real() / (length * length);
    double squared_residual = 0;
    for(std::size_t i = 0; i < x.size(); ++i)
      squared_residual += std::norm(x[i] / length - eigenvalue * y[i] / length);
    x.swap(y);
    normalize(x);
    if(std::sqrt(squared_residual) <= relative_residual * eigenvalue)
      break;
  }
  return true;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LINEAR_SMALLEST_EIGENVECTOR_H
