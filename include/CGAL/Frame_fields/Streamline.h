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

#ifndef CGAL_FRAME_FIELDS_STREAMLINE_H
#define CGAL_FRAME_FIELDS_STREAMLINE_H

#include <vector>

/// \file Streamline.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsRef
///
/// is a polyline on a surface that follows one branch of a frame field from face to face.
///
/// \tparam Point a point type
/// \tparam Face a face descriptor
///
/// \sa `trace_streamlines()`
template <typename Point, typename Face>
struct Streamline
{
  /// the points, two or more; the first one is repeated at the end if the line is closed
  std::vector<Point> points;

  /// for each segment, from `points[k]` to `points[k + 1]`, the face that it lies in
  std::vector<Face> faces;

  /// for each segment the branch of its face that it follows, 0 to 3; a segment along an edge between two faces whose
  /// branches both point to this edge has that of the face in `faces`
  std::vector<int> branches;

  /// 0 or 1: the number of the branch pair that most of the line follows. Branch pairs of neighboring faces that the
  /// matching joins have the same number, except across the seams that singularities make necessary.
  int branch_pair;

  /// whether the line ends where it begins
  bool is_closed;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_STREAMLINE_H
