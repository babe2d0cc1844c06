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

#ifndef CGAL_FRAME_FIELDS_AMGCL_FRAME_FIELD_SOLVER_TRAITS_H
#define CGAL_FRAME_FIELDS_AMGCL_FRAME_FIELD_SOLVER_TRAITS_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/conjugate.h>

#include <CGAL/tags.h>

#include <amgcl/backend/builtin.hpp>
#include <amgcl/value_type/complex.hpp>

#include <amgcl/adapter/crs_tuple.hpp>
#include <amgcl/amg.hpp>
#include <amgcl/coarsening/smoothed_aggregation.hpp>
#include <amgcl/make_solver.hpp>
#include <amgcl/relaxation/ilu0.hpp>
#include <amgcl/solver/cg.hpp>

#include <cmath>
#include <complex>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>
#include <tuple>
#include <vector>

/// \file Amgcl_frame_field_solver_traits.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsSolver
///
/// solves hermitian positive definite systems by conjugate gradients, preconditioned with an algebraic multigrid of
/// AMGCL (smoothed aggregation, incomplete factorization without fill as smoother), until the residual is `tolerance`
/// times the right-hand side.
///
/// \cgalModels{PositiveDefiniteSolver}
///
/// \tparam Scalar_ `double` or `std::complex<double>`
template <typename Scalar_>
class Amgcl_positive_definite_solver
{
public:
  /// the type of the entries
  typedef Scalar_ Scalar;

  /// constructs a solver that holds no matrix. `tolerance`, positive, bounds the norm of the residual divided by that
  /// of the right-hand side; `maximum_number_of_iterations` is at least 1.
  Amgcl_positive_definite_solver(const double tolerance, const int maximum_number_of_iterations)
    : m_tolerance(tolerance), m_maximum_number_of_iterations(maximum_number_of_iterations)
  {}

  /// builds the multigrid of `matrix`; returns `false` if AMGCL cannot.
  bool factor(const Hermitian_matrix<Scalar>& matrix)
  {
    typename Solver::params parameters;
    parameters.solver.tol = m_tolerance;
    parameters.solver.maxiter = m_maximum_number_of_iterations;
    Rows rows = full_rows(matrix);
    m_turn = turns_along_spanning_trees(rows);
    turn(rows);
    try
    {
      m_solver = std::make_unique<Solver>(
        std::make_tuple(static_cast<std::ptrdiff_t>(matrix.size()), rows.begin, rows.column, rows.value), parameters);
    }
    catch(const std::bad_alloc&)
    {
      throw;
    }
    catch(const std::exception&) // such as a vanishing pivot
    {
      return false;
    }
    return true;
  }

  /// sets `solution` such that the matrix times `solution` is `right_hand_side`; returns `false` if the residual is too
  /// large after the maximum number of iterations.
  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution) const
  {
    std::vector<Scalar> turned(right_hand_side);
    for(std::size_t i = 0; i < turned.size(); ++i)
      turned[i] *= internal::conjugate(m_turn[i]);
    solution.assign(right_hand_side.size(), Scalar(0));
    const auto [number_of_iterations, residual] = (*m_solver)(turned, solution);
    for(std::size_t i = 0; i < solution.size(); ++i)
      solution[i] *= m_turn[i];
    return residual <= m_tolerance;
  }

private:
  typedef amgcl::backend::builtin<Scalar> Backend;
  typedef amgcl::make_solver<amgcl::amg<Backend, amgcl::coarsening::smoothed_aggregation, amgcl::relaxation::ilu0>,
                             amgcl::solver::cg<Backend> > Solver;

  // Both triangles of a matrix in compressed rows.
  struct Rows
  {
    std::vector<std::ptrdiff_t> begin, column;
    std::vector<Scalar> value;
  };

  static Rows full_rows(const Hermitian_matrix<Scalar>& matrix)
  {
    const int size = matrix.size();
    Rows rows;
    rows.begin.assign(static_cast<std::size_t>(size) + 1, 0);
    for(int j = 0; j < size; ++j)
      for(int k = matrix.column_begin[j]; k < matrix.column_begin[j + 1]; ++k)
      {
        ++rows.begin[matrix.row[k] + 1];
        rows.begin[j + 1] += matrix.row[k] != j;
      }
    for(int i = 0; i < size; ++i)
      rows.begin[i + 1] += rows.begin[i];
    rows.column.resize(rows.begin[size]);
    rows.value.resize(rows.begin[size]);

    std::vector<std::ptrdiff_t> next_place(rows.begin.begin(), rows.begin.end() - 1);
    const auto append = [&](const int i, const int j, const Scalar& value)
    {
      rows.column[next_place[i]] = j;
      rows.value[next_place[i]++] = value;
    };
    for(int j = 0; j < size; ++j) // what is left of the diagonal of row j was appended by the columns before
      for(int k = matrix.column_begin[j]; k < matrix.column_begin[j + 1]; ++k)
      {
        append(matrix.row[k], j, matrix.value[k]);
        if(matrix.row[k] != j)
          append(j, matrix.row[k], internal::conjugate(matrix.value[k]));
      }
    return rows;
  }

  // Aggregation takes neighbors to be alike, but each face has a basis of its own. The unknowns are factors (signs or
  // unit complex numbers) times new ones such that entries along spanning trees of the matrix become negative.
  static std::vector<Scalar> turns_along_spanning_trees(const Rows& rows)
  {
    const std::size_t size = rows.begin.size() - 1;
    std::vector<Scalar> turn(size, Scalar(0));
    std::vector<std::size_t> visited; // in breadth-first order
    visited.reserve(size);
    for(std::size_t root = 0; root < size; ++root)
    {
      if(turn[root] != Scalar(0))
        continue;
      turn[root] = 1;
      visited.push_back(root);
      for(std::size_t next = visited.size() - 1; next < visited.size(); ++next)
      {
        const std::size_t i = visited[next];
        for(std::ptrdiff_t k = rows.begin[i]; k < rows.begin[i + 1]; ++k)
        {
          const std::ptrdiff_t j = rows.column[k];
          if(turn[j] != Scalar(0) || rows.value[k] == Scalar(0))
            continue;
          turn[j] = -turn[i] * internal::conjugate(rows.value[k]) / std::abs(rows.value[k]);
          visited.push_back(j);
        }
      }
    }
    return turn;
  }

  void turn(Rows& rows) const
  {
    for(std::size_t i = 0; i < m_turn.size(); ++i)
      for(std::ptrdiff_t k = rows.begin[i]; k < rows.begin[i + 1]; ++k)
        rows.value[k] *= internal::conjugate(m_turn[i]) * m_turn[rows.column[k]];
  }

  double m_tolerance;
  int m_maximum_number_of_iterations;
  std::vector<Scalar> m_turn;       // the factor of each unknown
  std::unique_ptr<Solver> m_solver; // made by factor()
};

/// \ingroup PkgFrame_fieldsSolver
///
/// is a solver traits for very large patches: conjugate gradients with an algebraic multigrid by AMGCL, whose time and
/// memory grow in proportion to the size of a patch. The header needs AMGCL's, and nothing to link with.
///
/// Each solution is accurate to a residual of `tolerance` times the right-hand side. The functions of this package
/// refine it by further solutions until it is as accurate in every face as that of a direct solver, so a smaller
/// `tolerance` gives no better field. A patch without constrained edges, whose matrix is nearly singular, may take more
/// than the maximum number of iterations; then the result is `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`.
///
/// \cgalModels{FrameFieldSolverTraits}
class Amgcl_frame_field_solver_traits
{
public:
  /// the solver of symmetric systems
  typedef Amgcl_positive_definite_solver<double> Real_solver;

  /// the solver of complex hermitian systems
  typedef Amgcl_positive_definite_solver<std::complex<double> > Complex_solver;

  /// Solvers share nothing.
  typedef CGAL::Tag_true Has_independent_solvers;

  /// sets the relative residual that solutions must reach, positive, and the number of iterations that each may take,
  /// at least 1.
  explicit Amgcl_frame_field_solver_traits(const double tolerance = 1e-10,
                                           const int maximum_number_of_iterations = 1000)
    : m_tolerance(tolerance), m_maximum_number_of_iterations(maximum_number_of_iterations)
  {}

  /// returns a new solver.
  Real_solver real_solver_object() const { return Real_solver(m_tolerance, m_maximum_number_of_iterations); }

  /// returns a new solver.
  Complex_solver complex_solver_object() const { return Complex_solver(m_tolerance, m_maximum_number_of_iterations); }

private:
  double m_tolerance;
  int m_maximum_number_of_iterations;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_AMGCL_FRAME_FIELD_SOLVER_TRAITS_H
