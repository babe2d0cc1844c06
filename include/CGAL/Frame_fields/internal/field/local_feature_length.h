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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_LOCAL_FEATURE_LENGTH_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_LOCAL_FEATURE_LENGTH_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/walk_along_border.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Whether a constrained curve has a corner in a sector: its angle is more than 45 degrees from a straight one.
inline bool is_far_from_straight(const Cut_surface& surface, const int sector)
{
  return std::abs(surface.total_angle[sector] - CGAL_PI) > CGAL_PI / 4;
}

// The length of the constrained curve that begins with a constrained halfedge and goes on forward or backward. It ends
// at the first sector that is far from straight, or where it comes back.
inline double length_to_next_corner(const Cut_surface& surface, const int first, const bool is_forward)
{
  double length = 0;
  int halfedge = first;
  do
  {
    length += surface.length[halfedge];
    const int neighbor = is_forward ? next_on_border(surface, halfedge) : previous_on_border(surface, halfedge);
    if(is_far_from_straight(surface, surface.sector[is_forward ? halfedge : neighbor]))
      break;
    halfedge = neighbor;
  } while(halfedge != first);
  return length;
}

// Half the length of the shorter one of the two constrained curves that leave a prescribed corner, in the unit of
// `Cut_surface::length`. Takes time in proportion to the edges of both curves.
inline double local_feature_length(const Cut_surface& surface, const int corner)
{
  const int outgoing = next_of(surface.first_corner[corner]), incoming = previous_on_border(surface, outgoing);
  return (std::min)(length_to_next_corner(surface, outgoing, true),
                    length_to_next_corner(surface, incoming, false)) / 2;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_LOCAL_FEATURE_LENGTH_H
