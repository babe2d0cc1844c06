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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_INDEX_TARGET_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_INDEX_TARGET_H

#include <CGAL/Frame_fields/No_index_target.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The largest 4 I for which there is a quadrangle mesh: one quadrangle at a sector on constrained edges, three at a
// sector inside.
constexpr int maximum_meshable_index = 1;

// The largest |4 I| that a caller may ask for. The repair moves indices by 1/4 at a time, so the bound limits its
// steps.
constexpr int largest_index_target = 1000;

// Angles that differ by less count as equal where a number of quadrangles depends on them, in radians: coordinates of 7
// digits give the directions of edges of a thousandth of the model within this. Octagons and chamfers of 45 degrees are
// common, and all their corners must be rounded the same way.
constexpr double angle_tolerance = 1e-3;

// Whether a sector on constrained edges has an angle below `bound`, in radians.
inline bool is_sharp_corner(const Cut_surface& surface, const int sector, const double bound)
{
  return surface.angle_of_sector(sector) < bound - angle_tolerance && surface.is_constrained_sector(sector);
}

// The number of quadrangles at a sector on constrained edges whose angles are nearest to right ones, at least one. An
// angle halfway between two numbers gets the larger one: 135 degrees are twice 67.5, which is nearer to 90 than 135 is.
inline int natural_number_of_quads(const double total_angle)
{
  return (std::max)(1, static_cast<int>(std::floor(2 * (total_angle + angle_tolerance) / CGAL_PI + 0.5)));
}

// 4 I of a sector with the natural number of quadrangles if it is on constrained edges; 0 inside.
inline int natural_index(const Cut_surface& surface, const int sector)
{
  return surface.is_constrained_sector(sector) ? 2 - natural_number_of_quads(surface.angle_of_sector(sector)) : 0;
}

// Which sectors on constrained edges get their natural index prescribed, and not only by the repair: sharp corners, and
// blunt ones, that is, those of two quadrangles or more whose angle differs from a straight one by more than a
// bound. Both bounds are in radians.
struct Corner_bounds
{
  double sharp, blunt;
};

inline bool is_prescribed_corner(const Cut_surface& surface, const int sector, const Corner_bounds& bounds)
{
  const double angle = surface.angle_of_sector(sector);
  return is_sharp_corner(surface, sector, bounds.sharp)
      || (std::abs(angle - CGAL_PI) > bounds.blunt + angle_tolerance && natural_number_of_quads(angle) > 1
          && surface.is_constrained_sector(sector));
}

// Whether a sector on constrained edges does not have its natural index, or one inside has less than three quadrangles.
// `index` is 4 I per sector.
inline bool is_unnatural(const Cut_surface& surface, const std::vector<int>& index, const int sector)
{
  return surface.is_constrained_sector(sector) ? index[sector] != natural_index(surface, sector)
                                               : index[sector] > maximum_meshable_index;
}

// 4 I that the caller gave for a sector, or else the natural one.
inline int target_of_sector(const Cut_surface& surface, const int sector)
{
  const bool is_given = !surface.index_target.empty() && surface.index_target[sector] != NO_INDEX_TARGET;
  return is_given ? surface.index_target[sector] : natural_index(surface, sector);
}

// Whether the caller gave a target in the patch. Then every sector of the patch has one, its natural index by default.
inline bool has_index_targets(const Cut_surface& surface, const Patch& patch)
{
  return !surface.index_target.empty()
      && std::any_of(surface.index_target.begin() + patch.sectors.begin_index,
                     surface.index_target.begin() + patch.sectors.end_index,
                     [](const int target) { return target != NO_INDEX_TARGET; });
}

// 4 times the Euler characteristic of a patch less the sum of its targets.
inline long long missing_index(const Cut_surface& surface, const Patch& patch)
{
  long long missing = 4LL * euler_characteristic(patch);
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    missing -= target_of_sector(surface, s);
  return missing;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_INDEX_TARGET_H
