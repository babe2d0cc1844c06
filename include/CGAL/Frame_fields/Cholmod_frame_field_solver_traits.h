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

#include <CGAL/Frame_fields/internal/linear/Eigen_factorization.h>

#include <Eigen/CholmodSupport>

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
#ifndef DOXYGEN_RUNNING
  : public internal::Eigen_factorization<Scalar_, Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<Scalar_>,
                                                                              Eigen::Lower> >
#endif
{
public:
  /// constructs a solver that holds no factorization.
  Cholmod_positive_definite_solver()
  {
    this->factorization().cholmod().nmethods = 1;
    this->factorization().cholmod().method[0].ordering = CHOLMOD_NATURAL;
    this->factorization().cholmod().print = 0; // failures are returned
  }
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
#ifndef DOXYGEN_RUNNING
  : internal::Eigen_solver_traits_base<Cholmod_positive_definite_solver>
#endif
{};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_CHOLMOD_FRAME_FIELD_SOLVER_TRAITS_H
