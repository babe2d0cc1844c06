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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LINEAR_CONJUGATE_H
#define CGAL_FRAME_FIELDS_INTERNAL_LINEAR_CONJUGATE_H

#include <complex>

namespace CGAL {
namespace Frame_fields {
namespace internal {

inline double conjugate(const double x) { return x; }
inline std::complex<double> conjugate(const std::complex<double>& x) { return std::conj(x); }

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LINEAR_CONJUGATE_H
