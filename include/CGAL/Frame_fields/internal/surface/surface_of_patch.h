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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_OF_PATCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_OF_PATCH_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The values of consecutive elements; empty if `values` is.
template <typename T>
std::vector<T> part_of(const std::vector<T>& values, const Index_range& range)
{
  return values.empty() ? values
                        : std::vector<T>(values.begin() + range.begin_index, values.begin() + range.end_index);
}

inline Index_range halfedges_of_patch(const Patch& patch)
{
  return { 3 * patch.faces.begin_index, 3 * patch.faces.end_index };
}

// One patch as a surface of its own, without index targets. Its elements keep their order and are numbered from 0.
// Takes time linear in the patch.
inline Cut_surface surface_of_patch(const Cut_surface& surface, const Patch& patch)
{
  const Index_range halfedges = halfedges_of_patch(patch);
  Cut_surface result;
  result.patches = { { { 0, patch.faces.size() }, { 0, patch.dual_edges.size() }, { 0, patch.sectors.size() } } };
  result.angle = part_of(surface.angle, halfedges);
  result.opposite = part_of(surface.opposite, halfedges);
  result.sector = part_of(surface.sector, halfedges);
  result.first_corner = part_of(surface.first_corner, patch.sectors);
  result.total_angle = part_of(surface.total_angle, patch.sectors);
  result.angle_in_space = part_of(surface.angle_in_space, patch.sectors);
  result.dual_edges = part_of(surface.dual_edges, patch.dual_edges);
  result.transport = part_of(surface.transport, patch.dual_edges);
  result.edge_weighting = surface.edge_weighting;
  result.weight = part_of(surface.weight, patch.dual_edges);
  result.length_unit = surface.length_unit;
  result.length = part_of(surface.length, halfedges);
  result.alignment = part_of(surface.alignment, patch.faces);
  result.guide_angle = part_of(surface.guide_angle, patch.faces);
  result.guide_weight = part_of(surface.guide_weight, patch.faces);
  for(int& opposite : result.opposite)
    if(opposite >= 0)
      opposite -= halfedges.begin_index;
  for(int& sector : result.sector)
    sector -= patch.sectors.begin_index;
  for(int& corner : result.first_corner)
    corner -= halfedges.begin_index;
  for(Dual_edge& e : result.dual_edges)
  {
    e.halfedge -= halfedges.begin_index;
    e.opposite -= halfedges.begin_index;
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_OF_PATCH_H
