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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LINEAR_EIGEN_FACTORIZATION_H
#define CGAL_FRAME_FIELDS_INTERNAL_LINEAR_EIGEN_FACTORIZATION_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>

#include <CGAL/tags.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <complex>
#include <memory>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A solver by one of Eigen's factorizations, which must read the lower triangle and keep the order of the unknowns.
template <typename Scalar_, typename Factorization_>
class Eigen_factorization
{
public:
  typedef Scalar_ Scalar;

  Eigen_factorization() : m_factorization(std::make_unique<Factorization>()) {}

  // Returns whether the factorization succeeded.
  bool factor(const Hermitian_matrix<Scalar>& matrix)
  {
    typedef typename Factorization::MatrixType Matrix;
    m_factorization->compute(Matrix(View(matrix.size(), matrix.size(), static_cast<int>(matrix.row.size()),
                                         matrix.column_begin.data(), matrix.row.data(), matrix.value.data())));
    return m_factorization->info() == Eigen::Success;
  }

  // Solves for the matrix of the last successful `factor()`. Returns whether Eigen reports success.
  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution) const
  {
    solution.resize(right_hand_side.size());
    const Eigen::Map<const Vector> b(right_hand_side.data(), right_hand_side.size());
    Eigen::Map<Vector>(solution.data(), solution.size()) = m_factorization->solve(b);
    return m_factorization->info() == Eigen::Success;
  }

protected:
  typedef Factorization_ Factorization;

  Factorization& factorization() { return *m_factorization; }

private:
  typedef Eigen::Map<const Eigen::SparseMatrix<Scalar> > View;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;

  std::unique_ptr<Factorization> m_factorization; // Eigen's class cannot be moved
};

// A solver traits class of such solvers, which share no state. The elimination order is that of approximate minimum
// degree.
template <template <typename> class Solver>
struct Eigen_solver_traits_base
{
  typedef Solver<double> Real_solver;
  typedef Solver<std::complex<double> > Complex_solver;
  typedef CGAL::Tag_true Has_independent_solvers;

  Real_solver real_solver_object() const { return Real_solver(); }
  Complex_solver complex_solver_object() const { return Complex_solver(); }

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

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LINEAR_EIGEN_FACTORIZATION_H
