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

#include <CGAL/Frame_fields/internal/linear/Eigen_factorization.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

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
#ifndef DOXYGEN_RUNNING
  : public internal::Eigen_factorization<
      Scalar_, Eigen::SimplicialLDLT<Eigen::Map<const Eigen::SparseMatrix<Scalar_> >, Eigen::Lower,
                                     Eigen::NaturalOrdering<int> > >
#endif
{};

/// \ingroup PkgFrame_fieldsSolver
///
/// is the default solver traits: sparse Cholesky factorizations by \ref thirdpartyEigen "Eigen" in an approximate
/// minimum degree order.
///
/// \cgalModels{FrameFieldOrderingSolverTraits}
struct Eigen_frame_field_solver_traits
#ifndef DOXYGEN_RUNNING
  : internal::Eigen_solver_traits_base<Eigen_positive_definite_solver>
#endif
{};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_EIGEN_FRAME_FIELD_SOLVER_TRAITS_H
