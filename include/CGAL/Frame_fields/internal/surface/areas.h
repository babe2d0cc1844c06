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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_AREAS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_AREAS_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The area of a triangle from the lengths of two of its sides and the angle between them.
inline double triangle_area(const double length, const double other_length, const double angle)
{
  return length * other_length * std::sin(angle) / 2;
}

// The area of a face in units of `length_unit` squared, as all areas here. The surface must have lengths.
inline double area(const Cut_surface& surface, const int face)
{
  const int h = 3 * face;
  return triangle_area(surface.length[h], surface.length[h + 1], surface.angle[h]);
}

// The sum of the areas of the faces of a patch.
inline double patch_area(const Cut_surface& surface, const Patch& patch)
{
  double sum = 0;
  for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
    sum += area(surface, f);
  return sum;
}

// The sum of the areas of all patches.
inline double surface_area(const Cut_surface& surface)
{
  double sum = 0;
  for(const Patch& patch : surface.patches)
    sum += patch_area(surface, patch);
  return sum;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_AREAS_H
