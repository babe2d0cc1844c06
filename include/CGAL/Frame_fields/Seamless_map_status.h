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

#ifndef CGAL_FRAME_FIELDS_SEAMLESS_MAP_STATUS_H
#define CGAL_FRAME_FIELDS_SEAMLESS_MAP_STATUS_H

/// \file Seamless_map_status.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsEnums
///
/// tells what is known of the map of a patch.
enum class Seamless_map_status
{
  CERTIFIED,         ///< The map is injective around every point, aligned, seamless, and has the field's indices
  FORCED_ZERO_SIDE,  ///< The indices of the field leave no length to a constrained edge
  SOLVER_FAILED,     ///< A linear system could not be solved, or the values are too large for the grid
  INVERTED_FACE,     ///< A face could not be brought to positive orientation
  REVERSED_EDGE,     ///< A constrained edge could not be brought to run along its branch
  WRONG_CONE,        ///< A sector turns by another angle than its index says, or its index leaves no room for a quad
  ONE_PAIR_ON_TORUS, ///< The only irregular vertices of a torus are one of three and one of five quads: it has no map
  NO_NUMBERS_OF_EDGES ///< No numbers of edges of quads fit to the seamless map; of integer-grid maps only
};

/// \ingroup PkgFrame_fieldsRef
///
/// is a patch without a certified map.
///
/// \tparam Face a face descriptor
template <typename Face>
struct Uncertified_patch
{
  /// the first face of the patch
  Face face;

  /// why there is no certified map
  Seamless_map_status status;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_SEAMLESS_MAP_STATUS_H
