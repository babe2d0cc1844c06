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

#ifndef CGAL_FRAME_FIELDS_REFINEMENT_STATISTICS_H
#define CGAL_FRAME_FIELDS_REFINEMENT_STATISTICS_H

#include <cstddef>

/// \file Refinement_statistics.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsRef
///
/// holds the figures of one call of `refine_triangles()`, `prepare_for_frame_field()`, `split_chords()` or
/// `split_overconstrained_faces()`; see their named parameter `statistics`. What a function does not do counts 0.
struct Refinement_statistics
{
  std::size_t number_of_splits = 0;      ///< edges split at their midpoints
  std::size_t number_of_split_faces = 0; ///< faces split at a point inside
  std::size_t number_of_flips = 0;       ///< edges flipped
  double flip_tolerance = 0;             ///< a length of the mesh: how far a flip was allowed to move the surface
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_REFINEMENT_STATISTICS_H
