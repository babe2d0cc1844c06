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

#ifndef CGAL_FRAME_FIELDS_AUTOMATIC_FRAME_FIELD_SOLVER_TRAITS_H
#define CGAL_FRAME_FIELDS_AUTOMATIC_FRAME_FIELD_SOLVER_TRAITS_H

#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/elimination_order.h>

#include <CGAL/tags.h>

#include <utility>
#include <vector>

/// \file Automatic_frame_field_solver_traits.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsSolver
///
/// solves systems by one of two solvers, according to their number of rows.
///
/// \cgalModels{PositiveDefiniteSolver}
///
/// \tparam SmallSolver a model of `PositiveDefiniteSolver`
/// \tparam LargeSolver a model of `PositiveDefiniteSolver` with the same `Scalar`
template <typename SmallSolver, typename LargeSolver>
class Automatic_positive_definite_solver
{
public:
  /// the type of the entries
  typedef typename SmallSolver::Scalar Scalar;

  /// takes over both solvers; systems of `threshold` rows or more are `large_solver`'s.
  Automatic_positive_definite_solver(SmallSolver&& small_solver, LargeSolver&& large_solver, const int threshold)
    : m_small_solver(std::move(small_solver)), m_large_solver(std::move(large_solver)), m_threshold(threshold)
  {}

  /// factors `matrix`; returns whether the chosen solver did.
  bool factor(const Hermitian_matrix<Scalar>& matrix)
  {
    m_is_large = matrix.size() >= m_threshold;
    return m_is_large ? m_large_solver.factor(matrix) : m_small_solver.factor(matrix);
  }

  /// sets `solution` such that the factored matrix times `solution` is `right_hand_side`; returns whether the chosen
  /// solver did.
  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution)
  {
    return m_is_large ? m_large_solver.solve(right_hand_side, solution)
                      : m_small_solver.solve(right_hand_side, solution);
  }

private:
  SmallSolver m_small_solver;
  LargeSolver m_large_solver;
  int m_threshold;
  bool m_is_large = false;
};

/// \ingroup PkgFrame_fieldsSolver
///
/// is a solver traits that chooses for each system of each patch: small ones are solved by `SmallSolverTraits` and
/// large ones by `LargeSolverTraits`.
///
/// \cgalModels{FrameFieldOrderingSolverTraits}
///
/// \tparam LargeSolverTraits a model of `FrameFieldSolverTraits`, for example `Cholmod_frame_field_solver_traits`
/// \tparam SmallSolverTraits a model of `FrameFieldOrderingSolverTraits`
template <typename LargeSolverTraits, typename SmallSolverTraits = Eigen_frame_field_solver_traits>
class Automatic_frame_field_solver_traits
{
public:
  /// the solver of symmetric systems
  typedef Automatic_positive_definite_solver<typename SmallSolverTraits::Real_solver,
                                             typename LargeSolverTraits::Real_solver> Real_solver;

  /// the solver of complex hermitian systems
  typedef Automatic_positive_definite_solver<typename SmallSolverTraits::Complex_solver,
                                             typename LargeSolverTraits::Complex_solver> Complex_solver;

  /// `CGAL::Tag_true` if it is for both solver traits
  typedef CGAL::Boolean_tag<SmallSolverTraits::Has_independent_solvers::value
                            && LargeSolverTraits::Has_independent_solvers::value> Has_independent_solvers;

  /// keeps copies of both solver traits. Systems with `threshold` rows or more are large. The default is where
  /// `Cholmod_frame_field_solver_traits` overtakes `Eigen_frame_field_solver_traits` in the benchmarks of this package:
  /// at about 200,000 rows with OpenBLAS, and at about 400,000 with the reference implementation of BLAS.
  explicit Automatic_frame_field_solver_traits(const int threshold = 300000,
                                               const LargeSolverTraits& large_solver_traits = LargeSolverTraits(),
                                               const SmallSolverTraits& small_solver_traits = SmallSolverTraits())
    : m_threshold(threshold), m_large_solver_traits(large_solver_traits), m_small_solver_traits(small_solver_traits)
  {}

  /// returns a new solver.
  Real_solver real_solver_object() const
  {
    return Real_solver(m_small_solver_traits.real_solver_object(), m_large_solver_traits.real_solver_object(),
                       m_threshold);
  }

  /// returns a new solver.
  Complex_solver complex_solver_object() const
  {
    return Complex_solver(m_small_solver_traits.complex_solver_object(), m_large_solver_traits.complex_solver_object(),
                          m_threshold);
  }

  /// returns the order that the solver traits for `pattern.size()` rows gives; the natural one if this is
  /// `LargeSolverTraits` and leaves the order to its solvers.
  std::vector<int> elimination_order(const Hermitian_matrix<float>& pattern) const
  {
    if(pattern.size() < m_threshold)
      return m_small_solver_traits.elimination_order(pattern);
    if constexpr(internal::Chooses_elimination_order<LargeSolverTraits>::value)
      return m_large_solver_traits.elimination_order(pattern);
    return internal::natural_order(pattern.size());
  }

private:
  int m_threshold;
  LargeSolverTraits m_large_solver_traits;
  SmallSolverTraits m_small_solver_traits;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_AUTOMATIC_FRAME_FIELD_SOLVER_TRAITS_H
