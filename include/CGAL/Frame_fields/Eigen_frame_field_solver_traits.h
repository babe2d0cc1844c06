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

#ifndef CGAL_FRAME_FIELDS_EIGEN_FRAME_FIELD_SOLVER_TRAITS_H
#define CGAL_FRAME_FIELDS_EIGEN_FRAME_FIELD_SOLVER_TRAITS_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>

#include <CGAL/tags.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include <complex>
#include <memory>
#include <vector>

/// \file Eigen_frame_field_solver_traits.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsSolver
///
/// solves hermitian positive definite systems by the sparse Cholesky factorization `Eigen::SimplicialLDLT`, which
/// eliminates the unknowns in the order of their numbers.
///
/// \cgalModels{PositiveDefiniteSolver}
///
/// \tparam Scalar_ `double` or `std::complex<double>`
template <typename Scalar_>
class Eigen_positive_definite_solver
{
public:
  /// the type of the entries
  typedef Scalar_ Scalar;

  /// constructs a solver that holds no factorization.
  Eigen_positive_definite_solver() : m_factorization(std::make_unique<Factorization>()) {}

  /// factors `matrix`; returns `false` if a pivot vanishes.
  bool factor(const Hermitian_matrix<Scalar>& matrix)
  {
    m_factorization->compute(View(matrix.size(), matrix.size(), static_cast<int>(matrix.row.size()),
                                  matrix.column_begin.data(), matrix.row.data(), matrix.value.data()));
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
  typedef Eigen::Map<const Eigen::SparseMatrix<Scalar> > View;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;
  typedef Eigen::SimplicialLDLT<View, Eigen::Lower, Eigen::NaturalOrdering<int> > Factorization;

  std::unique_ptr<Factorization> m_factorization; // Eigen's class cannot be moved
};

/// \ingroup PkgFrame_fieldsSolver
///
/// is the default solver traits: sparse Cholesky factorizations by \ref thirdpartyEigen "Eigen" in an approximate
/// minimum degree order.
///
/// \cgalModels{FrameFieldOrderingSolverTraits}
struct Eigen_frame_field_solver_traits
{
  /// the solver of symmetric systems
  typedef Eigen_positive_definite_solver<double> Real_solver;

  /// the solver of complex hermitian systems
  typedef Eigen_positive_definite_solver<std::complex<double> > Complex_solver;

  /// Solvers share nothing.
  typedef CGAL::Tag_true Has_independent_solvers;

  /// returns a new solver.
  Real_solver real_solver_object() const { return Real_solver(); }

  /// returns a new solver.
  Complex_solver complex_solver_object() const { return Complex_solver(); }

  /// returns the approximate minimum degree order of the rows of `pattern`, whose values are not used.
  std::vector<int> elimination_order(const Hermitian_matrix<float>& pattern) const
  {
    const Eigen::Map<const Eigen::SparseMatrix<float> > view(
      pattern.size(), pattern.size(), static_cast<int>(pattern.row.size()), pattern.column_begin.data(),
      pattern.row.data(), pattern.value.data());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> row_at_place;
    Eigen::AMDOrdering<int>()(view.selfadjointView<Eigen::Lower>(), row_at_place);
    return std::vector<int>(row_at_place.indices().data(), row_at_place.indices().data() + row_at_place.size());
  }
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_EIGEN_FRAME_FIELD_SOLVER_TRAITS_H
