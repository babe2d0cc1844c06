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

#ifndef CGAL_FRAME_FIELDS_T_JUNCTIONS_H
#define CGAL_FRAME_FIELDS_T_JUNCTIONS_H

/// \file T_junctions.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsEnums
///
/// lists where a corner of a block of `quad_mesh_blocks()` may lie inside a side of another one.
enum class T_junctions
{
  NONE,                 ///< Nowhere: blocks meet along whole sides
  ON_CONSTRAINED_EDGES, ///< On constrained edges: between these, blocks meet along whole sides
  EVERYWHERE            ///< Everywhere: the fewest blocks
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_T_JUNCTIONS_H
