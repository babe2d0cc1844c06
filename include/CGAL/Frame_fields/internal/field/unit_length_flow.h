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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_UNIT_LENGTH_FLOW_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_UNIT_LENGTH_FLOW_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/accurate_solve.h>
#include <CGAL/Frame_fields/internal/linear/smallest_eigenvector.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Divides each value by its norm; values that are 0 stay.
inline void bring_to_unit_length(std::vector<std::complex<double> >& z)
{
  for(std::complex<double>& z_i : z)
    if(const double length = std::abs(z_i); length > 0)
      z_i /= length;
}

// Turns an eigenvector into a field that is smooth when all its values are brought to unit length. Where the |z| of an
// eigenvector is small, its differences cost next to nothing, and there are singularities that a smooth field of unit
// length does not have. The values are brought to unit length before each step of the flow (matrix + shift) z' = z, as
// Merriman, Bence and Osher do for the motion by curvature. The first shift is the eigenvalue, so that a step reaches
// through the whole patch; the larger ones that follow settle details. `z` must have norm 1, and is left as it is if
// its eigenvalue vanishes. The values that the last step gives are not of unit length. Returns false if the solver
// fails.
template <typename Solver>
bool flow_to_unit_length(Solver& solver, Hermitian_matrix<std::complex<double> > matrix,
                         std::vector<std::complex<double> >& z)
{
  typedef std::complex<double> Complex;
  const double smallest_shift = 1e-9;
  const int number_of_scales = 4, number_of_steps = 10;
  const std::vector<Complex> a_z = product(matrix, z);
  double shift = 0, old_shift = 0;
  for(std::size_t i = 0; i < z.size(); ++i)
    shift += (std::conj(z[i]) * a_z[i]).real();
  if(!(shift > smallest_shift))
    return true;
  for(int scale = 0; scale < number_of_scales; ++scale, shift *= 4)
  {
    for(int j = 0; j < matrix.size(); ++j)
      matrix.value[matrix.column_begin[j]] += shift - old_shift;
    old_shift = shift;
    if(!solver.factor(matrix))
      return false;
    for(int step = 0; step < number_of_steps; ++step)
    {
      bring_to_unit_length(z);
      std::vector<Complex> next;
      if(!accurate_solve(solver, matrix, z, next))
        return false;
      z.swap(next);
    }
  }
  return true;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_UNIT_LENGTH_FLOW_H
