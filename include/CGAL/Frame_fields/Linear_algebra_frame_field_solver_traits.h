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

#ifndef CGAL_FRAME_FIELDS_LINEAR_ALGEBRA_FRAME_FIELD_SOLVER_TRAITS_H
#define CGAL_FRAME_FIELDS_LINEAR_ALGEBRA_FRAME_FIELD_SOLVER_TRAITS_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>

#include <CGAL/tags.h>

#include <complex>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

/// \file Linear_algebra_frame_field_solver_traits.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsSolver
///
/// solves real symmetric positive definite systems by a solver of \cgal.
///
/// \cgalModels{PositiveDefiniteSolver}
///
/// \tparam LinearAlgebraTraits a model of `SparseLinearAlgebraWithFactorTraits_d` with `NT` = `double`
template <typename LinearAlgebraTraits>
class Linear_algebra_real_solver
{
public:
  /// the type of the entries
  typedef double Scalar;

  /// keeps a copy of `traits`.
  explicit Linear_algebra_real_solver(const LinearAlgebraTraits& traits = LinearAlgebraTraits()) : m_traits(traits) {}

  /// factors `matrix`, which may be deleted afterwards; returns what `LinearAlgebraTraits::factor()` returns.
  bool factor(const Hermitian_matrix<double>& matrix)
  {
    const int size = matrix.size();
    m_matrix = std::make_unique<Matrix>(size, size);
    for(int j = 0; j < size; ++j)
      for(int k = matrix.column_begin[j]; k < matrix.column_begin[j + 1]; ++k)
        add_both_triangles(matrix.row[k], j, matrix.value[k]);
    return m_traits.factor(*m_matrix, m_denominator);
  }

  /// sets `solution` such that the factored matrix times `solution` is `right_hand_side`; returns what
  /// `LinearAlgebraTraits::linear_solver()` returns.
  bool solve(const std::vector<double>& right_hand_side, std::vector<double>& solution)
  {
    const int size = static_cast<int>(right_hand_side.size());
    Vector b(size), x(size);
    for(int i = 0; i < size; ++i)
      b[i] = right_hand_side[i];
    if(!m_traits.linear_solver(b, x))
      return false;
    solution.resize(size);
    for(int i = 0; i < size; ++i)
      solution[i] = x[i] / m_denominator;
    return true;
  }

private:
  typedef typename LinearAlgebraTraits::Matrix Matrix;
  typedef typename LinearAlgebraTraits::Vector Vector;

  void add_both_triangles(const int i, const int j, const double value)
  {
    m_matrix->add_coef(i, j, value);
    if(i != j)
      m_matrix->add_coef(j, i, value);
  }

  LinearAlgebraTraits m_traits;
  std::unique_ptr<Matrix> m_matrix; // the traits keep a pointer to it between the two calls
  typename LinearAlgebraTraits::NT m_denominator = 1;
};

/// \ingroup PkgFrame_fieldsSolver
///
/// solves complex hermitian positive definite systems of size \f$ n \f$ as real ones of size \f$ 2 n \f$.
///
/// \cgalModels{PositiveDefiniteSolver}
///
/// \tparam RealSolver a model of `PositiveDefiniteSolver` whose `Scalar` is `double`
template <typename RealSolver>
class Doubled_real_solver
{
public:
  /// the type of the entries
  typedef std::complex<double> Scalar;

  /// takes over `solver`, which solves the real systems.
  explicit Doubled_real_solver(RealSolver&& solver) : m_solver(std::move(solver)) {}

  /// factors `matrix`; returns whether the real solver did.
  bool factor(const Hermitian_matrix<Scalar>& matrix) { return m_solver.factor(doubled(matrix)); }

  /// sets `solution` such that the factored matrix times `solution` is `right_hand_side`; returns whether the real
  /// solver did.
  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution)
  {
    std::vector<double> b(2 * right_hand_side.size()), x;
    for(std::size_t i = 0; i < right_hand_side.size(); ++i)
    {
      b[2 * i] = right_hand_side[i].real();
      b[2 * i + 1] = right_hand_side[i].imag();
    }
    if(!m_solver.solve(b, x))
      return false;
    solution.resize(right_hand_side.size());
    for(std::size_t i = 0; i < solution.size(); ++i)
      solution[i] = Scalar(x[2 * i], x[2 * i + 1]);
    return true;
  }

private:
  // Each entry a + i b becomes the block (a, -b; b, a); row and column 2 i hold the real part of unknown i.
  static Hermitian_matrix<double> doubled(const Hermitian_matrix<Scalar>& matrix)
  {
    Hermitian_matrix<double> result;
    result.column_begin.reserve(2 * matrix.column_begin.size());
    result.row.reserve(4 * matrix.row.size());
    result.value.reserve(4 * matrix.row.size());
    result.column_begin.push_back(0);
    const auto append = [&result](const int row, const double value)
    {
      result.row.push_back(row);
      result.value.push_back(value);
    };
    for(int j = 0; j < matrix.size(); ++j)
    {
      const int begin = matrix.column_begin[j], end = matrix.column_begin[j + 1];
      append(2 * j, matrix.value[begin].real()); // the diagonal is real
      for(int k = begin + 1; k < end; ++k)
      {
        append(2 * matrix.row[k], matrix.value[k].real());
        append(2 * matrix.row[k] + 1, matrix.value[k].imag());
      }
      result.column_begin.push_back(static_cast<int>(result.row.size()));
      append(2 * j + 1, matrix.value[begin].real());
      for(int k = begin + 1; k < end; ++k)
      {
        append(2 * matrix.row[k], -matrix.value[k].imag());
        append(2 * matrix.row[k] + 1, matrix.value[k].real());
      }
      result.column_begin.push_back(static_cast<int>(result.row.size()));
    }
    return result;
  }

  RealSolver m_solver;
};

/// \ingroup PkgFrame_fieldsSolver
///
/// makes a solver of \cgal usable here. The functions of this package wrap whatever is given as named parameter
/// `sparse_linear_solver` and has no member type `Real_solver`, so
/// `sparse_linear_solver(CGAL::Eigen_solver_traits<...>())` is all that a caller writes.
///
/// \cgalModels{FrameFieldSolverTraits}
///
/// \tparam LinearAlgebraTraits a model of `SparseLinearAlgebraWithFactorTraits_d` with `NT` = `double`; it must solve
///         symmetric positive definite systems of which both triangles are given
template <typename LinearAlgebraTraits>
class Linear_algebra_frame_field_solver_traits
{
public:
  /// the solver of symmetric systems
  typedef Linear_algebra_real_solver<LinearAlgebraTraits> Real_solver;

  /// the solver of complex hermitian systems, which doubles them
  typedef Doubled_real_solver<Real_solver> Complex_solver;

  /// Copies of `CGAL::Eigen_solver_traits` share one Eigen object, so patches are solved one after the other.
  typedef CGAL::Tag_false Has_independent_solvers;

  /// keeps a copy of `traits`, from which each solver is copied.
  explicit Linear_algebra_frame_field_solver_traits(const LinearAlgebraTraits& traits = LinearAlgebraTraits())
    : m_traits(traits)
  {}

  /// returns a solver with a copy of the traits.
  Real_solver real_solver_object() const { return Real_solver(m_traits); }

  /// returns a solver with a copy of the traits.
  Complex_solver complex_solver_object() const { return Complex_solver(real_solver_object()); }

private:
  LinearAlgebraTraits m_traits;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_LINEAR_ALGEBRA_FRAME_FIELD_SOLVER_TRAITS_H
