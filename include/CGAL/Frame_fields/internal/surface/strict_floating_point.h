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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_STRICT_FLOATING_POINT_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_STRICT_FLOATING_POINT_H

// Rejects compiler options that break the computations of this package. Some let the compiler assume that every number
// is finite, which removes the tests for infinity and NaN; others let it change the order of sums, on which exact
// predicates rely.
#if (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || defined(__FAST_MATH__) \
    || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error "Frame_fields needs infinity, NaN and the order of sums: compile without -ffast-math (or its parts), /fp:fast"
#endif

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_STRICT_FLOATING_POINT_H
