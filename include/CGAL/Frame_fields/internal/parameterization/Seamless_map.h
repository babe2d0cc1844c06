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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SEAMLESS_MAP_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SEAMLESS_MAP_H

#include <CGAL/Frame_fields/Seamless_map_status.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

typedef Frame_fields::Seamless_map_status Map_status;

// Boundary-aligned seamless maps of the patches, on a grid of integers, so that all that is said of them is exact.
//
// The chart of a face is the plane of (u, v). Across an unconstrained edge from face i to face j a vector changes its
// chart by `quarter_turns` of the halfedge in i, each of which takes (du, dv) to (-dv, du); the translation follows
// from the corners. A constrained edge keeps u or keeps v.
struct Seamless_map
{
  std::vector<std::int64_t> u, v;           // per halfedge: of the corner at its target, in the chart of its face
  std::vector<unsigned char> quarter_turns; // per halfedge: 0 to 3; 0 on constrained edges
  std::vector<Map_status> status;           // per patch; the other values of a patch count only if it is certified
  std::vector<int> fraction_bits;           // per patch: 2^fraction_bits steps of the grid are one target edge length
  std::vector<std::vector<int> > faulty_faces; // per patch: where attempts to find its map left few faults
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SEAMLESS_MAP_H
