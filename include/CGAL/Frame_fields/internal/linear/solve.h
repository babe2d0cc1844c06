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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LINEAR_SOLVE_H
#define CGAL_FRAME_FIELDS_INTERNAL_LINEAR_SOLVE_H

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

inline bool is_finite(const double x) { return std::isfinite(x); }
inline bool is_finite(const std::complex<double>& x) { return std::isfinite(x.real()) && std::isfinite(x.imag()); }

// Solves and checks that the solution is finite, as a solver may report success although rounding errors made a pivot.
// Returns whether both succeeded.
template <typename Solver, typename Scalar>
bool checked_solve(Solver& solver, const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution)
{
  return solver.solve(right_hand_side, solution)
      && std::all_of(solution.begin(), solution.end(), [](const Scalar& x) { return is_finite(x); });
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LINEAR_SOLVE_H
