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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COLLECT_SECTORS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COLLECT_SECTORS_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The sectors of one patch, as `Cut_surface` describes them.
struct Patch_sectors
{
  std::vector<int> first_corner;
  std::vector<double> total_angle;

  int size() const { return static_cast<int>(first_corner.size()); }
};

// Appends the sector of `corner`: gives its corners the next number and adds up their angles.
inline void add_sector(const int corner, Cut_surface& surface, Patch_sectors& sectors)
{
  const auto add_from = [&](const int first_corner)
  {
    double total_angle = 0;
    int last_corner = first_corner;
    for_each_corner(surface.opposite, first_corner, [&](const int c)
    {
      surface.sector[c] = sectors.size();
      total_angle += surface.angle[c];
      last_corner = c;
    });
    const bool is_closed = !surface.is_constrained(last_corner);
    return std::make_pair(is_closed, total_angle);
  };
  // Most sectors are closed: the clockwise-most corner is looked for in the others only.
  int first_corner = corner;
  auto [is_closed, total_angle] = add_from(corner);
  if(!is_closed)
  {
    first_corner = clockwise_most_corner(surface.opposite, corner);
    total_angle = add_from(first_corner).second;
  }
  sectors.first_corner.push_back(first_corner);
  sectors.total_angle.push_back(total_angle);
}

// Numbers the sectors of the corners of a patch from 0.
inline Patch_sectors collect_sectors_of_patch(Cut_surface& surface, const Patch& patch)
{
  Patch_sectors result;
  const std::size_t expected_size = patch.faces.size() / 2 + 2; // a closed surface has half as many vertices as faces
  result.first_corner.reserve(expected_size);
  result.total_angle.reserve(expected_size);
  for(int corner = 3 * patch.faces.begin_index; corner < 3 * patch.faces.end_index; ++corner)
    if(surface.sector[corner] < 0)
      add_sector(corner, surface, result);
  return result;
}

// Sets the sectors of a surface with patches, opposites and angles. The sectors of a patch are numbered in the order of
// their first corners. Takes linear time.
template <typename ConcurrencyTag>
void collect_sectors(Cut_surface& surface)
{
  CGAL_precondition(inconsistent_halfedge(surface.opposite) < 0);
  surface.sector.assign(surface.number_of_halfedges(), -1);
  std::vector<Patch_sectors> sectors(surface.patches.size());
  for_each_patch<ConcurrencyTag>(surface, [&](const int patch)
  {
    sectors[patch] = collect_sectors_of_patch(surface, surface.patches[patch]);
    return Patch_result();
  });

  int number_of_sectors = 0;
  for(std::size_t patch = 0; patch < sectors.size(); ++patch)
  {
    surface.patches[patch].sectors = { number_of_sectors, number_of_sectors + sectors[patch].size() };
    number_of_sectors += sectors[patch].size();
  }
  surface.first_corner.resize(number_of_sectors);
  surface.total_angle.resize(number_of_sectors);
  for_each_patch<ConcurrencyTag>(surface, [&](const int number)
  {
    const Patch& patch = surface.patches[number];
    const int begin = patch.sectors.begin_index;
    std::copy(sectors[number].first_corner.begin(), sectors[number].first_corner.end(),
              surface.first_corner.begin() + begin);
    std::copy(sectors[number].total_angle.begin(), sectors[number].total_angle.end(),
              surface.total_angle.begin() + begin);
    for(int corner = 3 * patch.faces.begin_index; corner < 3 * patch.faces.end_index; ++corner)
      surface.sector[corner] += begin;
    return Patch_result();
  });
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COLLECT_SECTORS_H
