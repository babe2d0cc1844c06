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

#ifndef CGAL_FRAME_FIELDS_NO_INDEX_TARGET_H
#define CGAL_FRAME_FIELDS_NO_INDEX_TARGET_H

#include <climits>

/// \file No_index_target.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsEnums
///
/// is the value of the named parameter `index_target_map` for a sector that is given no target.
constexpr int NO_INDEX_TARGET = INT_MIN;

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_NO_INDEX_TARGET_H
