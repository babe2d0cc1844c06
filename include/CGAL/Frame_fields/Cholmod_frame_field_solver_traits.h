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

#ifndef CGAL_FRAME_FIELDS_CHOLMOD_FRAME_FIELD_SOLVER_TRAITS_H
#define CGAL_FRAME_FIELDS_CHOLMOD_FRAME_FIELD_SOLVER_TRAITS_H

#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/Hermitian_matrix.h>

#include <CGAL/tags.h>

#include <Eigen/CholmodSupport>

#include <complex>
#include <memory>
#include <vector>

/// \file Cholmod_frame_field_solver_traits.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsSolver
///
/// solves hermitian positive definite systems by the supernodal Cholesky factorization of CHOLMOD, which eliminates the
/// unknowns in the order of their numbers, up to a postorder.
///
/// \cgalModels{PositiveDefiniteSolver}
///
/// \tparam Scalar_ `double` or `std::complex<double>`
template <typename Scalar_>
class Cholmod_positive_definite_solver
{
public:
  /// the type of the entries
  typedef Scalar_ Scalar;

  /// constructs a solver that holds no factorization.
  Cholmod_positive_definite_solver() : m_factorization(std::make_unique<Factorization>())
  {
    m_factorization->cholmod().nmethods = 1;
    m_factorization->cholmod().method[0].ordering = CHOLMOD_NATURAL;
    m_factorization->cholmod().print = 0; // failures are returned
  }

  /// factors `matrix`; returns `false` if it is not positive definite or the memory does not suffice.
  bool factor(const Hermitian_matrix<Scalar>& matrix)
  {
    const Eigen::Map<const Matrix> view(matrix.size(), matrix.size(), static_cast<int>(matrix.row.size()),
                                        matrix.column_begin.data(), matrix.row.data(), matrix.value.data());
    m_factorization->compute(Matrix(view));
    return m_factorization->info() == Eigen::Success;
  }

  /// sets `solution` such that the factored matrix times `solution` is `right_hand_side`.
  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution) const
  {
    solution.resize(right_hand_side.size());
    const Eigen::Map<const Vector> b(right_hand_side.data(), right_hand_side.size());
    Eigen::Map<Vector>(solution.data(), solution.size()) = m_factorization->solve(b);
    return m_factorization->info() == Eigen::Success;
  }

private:
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;
  typedef Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower> Factorization;

  std::unique_ptr<Factorization> m_factorization; // Eigen's class cannot be moved
};

/// \ingroup PkgFrame_fieldsSolver
///
/// is a solver traits for large patches: supernodal Cholesky factorizations by CHOLMOD of SuiteSparse, through
/// \ref thirdpartyEigen "Eigen" and in the same order as `Eigen_frame_field_solver_traits`. Small patches are
/// faster with the latter; `Automatic_frame_field_solver_traits` chooses for each patch.
///
/// The header needs CHOLMOD's, and programs that use it must be linked with CHOLMOD, for example with the target
/// `CGAL::CHOLMOD_support` of `Frame_fields_CHOLMOD_support.cmake`.
///
/// \cgalModels{FrameFieldOrderingSolverTraits}
struct Cholmod_frame_field_solver_traits
{
  /// the solver of symmetric systems
  typedef Cholmod_positive_definite_solver<double> Real_solver;

  /// the solver of complex hermitian systems
  typedef Cholmod_positive_definite_solver<std::complex<double> > Complex_solver;

  /// Solvers share nothing.
  typedef CGAL::Tag_true Has_independent_solvers;

  /// returns a new solver.
  Real_solver real_solver_object() const { return Real_solver(); }

  /// returns a new solver.
  Complex_solver complex_solver_object() const { return Complex_solver(); }

  /// returns the approximate minimum degree order of the rows of `pattern`, whose values are not used.
  std::vector<int> elimination_order(const Hermitian_matrix<float>& pattern) const
  {
    return Eigen_frame_field_solver_traits().elimination_order(pattern);
  }
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_CHOLMOD_FRAME_FIELD_SOLVER_TRAITS_H
