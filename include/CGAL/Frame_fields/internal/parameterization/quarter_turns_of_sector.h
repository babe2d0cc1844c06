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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_QUARTER_TURNS_OF_SECTOR_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_QUARTER_TURNS_OF_SECTOR_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The number of quarter turns that an injective map makes around a sector: as many as quads meet there. `index` is 4 I.
inline int quarter_turns_of_sector(const Cut_surface& surface, const std::vector<int>& index, const int sector)
{
  return (surface.is_constrained_sector(sector) ? 2 : 4) - index[sector];
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_QUARTER_TURNS_OF_SECTOR_H
