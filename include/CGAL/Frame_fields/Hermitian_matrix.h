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

#ifndef CGAL_FRAME_FIELDS_HERMITIAN_MATRIX_H
#define CGAL_FRAME_FIELDS_HERMITIAN_MATRIX_H

#include <vector>

/// \file Hermitian_matrix.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsSolver
///
/// holds the lower triangle of a sparse hermitian matrix (symmetric, for real scalars) in compressed columns: the
/// entries of column `j` have the numbers `column_begin[j]` to `column_begin[j + 1] - 1`, in increasing order of their
/// rows, so that the diagonal entry is the first. Each column has a diagonal entry, and it is real.
///
/// \tparam Scalar_ `double` or `std::complex<double>`
template <typename Scalar_>
struct Hermitian_matrix
{
  /// the type of the entries
  typedef Scalar_ Scalar;

  std::vector<int> column_begin; ///< one more than there are columns
  std::vector<int> row;          ///< the row of each entry
  std::vector<Scalar> value;     ///< the value of each entry

  /// returns the number of columns.
  int size() const { return static_cast<int>(column_begin.size()) - 1; }
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_HERMITIAN_MATRIX_H
