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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_PATCH_RESULT_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_PATCH_RESULT_H

#include <CGAL/Frame_fields/Error_code.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The result of a stage for one patch. After a failure, `sector` is the sector at fault, or any sector of the patch if
// the whole patch is at fault.
struct Patch_result
{
  Error_code error_code{}; // no error
  int sector = 0;
  long long missing_index = 0; // with ERROR_POINCARE_HOPF: what the sum of 4 I lacks in the patch
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_PATCH_RESULT_H
