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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMPUTE_SEAMLESS_MAP_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMPUTE_SEAMLESS_MAP_H

#include <CGAL/Frame_fields/internal/parameterization/Patch_parameterization.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/one_pair_on_torus.h>
#include <CGAL/Frame_fields/internal/parameterization/quarter_turns_of_sector.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Whether each sector has room for a quad, that is, turns by at least a quarter turn.
inline bool has_room_for_quads(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index)
{
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(quarter_turns_of_sector(surface, index, s) < 1)
      return false;
  return true;
}

// Computes the map of the patch with this number. Writes only to the entries of the patch.
template <typename SolverTraits>
Map_status compute_seamless_map_of_patch(const Cut_surface& surface, const int number,
                                         const std::vector<double>& alpha, const std::vector<double>& rho,
                                         const std::vector<int>& matching, const std::vector<int>& index,
                                         const std::vector<double>& target_length, const SolverTraits& solver_traits,
                                         Seamless_map& map)
{
  const Patch& patch = surface.patches[number];
  if(!has_room_for_quads(surface, patch, index))
    return Map_status::WRONG_CONE;
  if(one_pair_on_torus(surface, patch, index)[0] >= 0)
    return Map_status::ONE_PAIR_ON_TORUS;
  Patch_parameterization parameterization(surface, patch, alpha, rho, matching, index, target_length,
                                          patch.faces.begin_index);
  return parameterization.compute(solver_traits, map, map.fraction_bits[number], map.faulty_faces[number]);
}

// Computes the maps of all patches; `target_length` is per face, in the unit of `Cut_surface::length`.
template <typename ConcurrencyTag, typename SolverTraits>
void compute_seamless_map(const Cut_surface& surface, const std::vector<double>& alpha, const std::vector<double>& rho,
                          const std::vector<int>& matching, const std::vector<int>& index,
                          const std::vector<double>& target_length, const SolverTraits& solver_traits,
                          Seamless_map& map)
{
  map.u.assign(surface.number_of_halfedges(), 0);
  map.v.assign(surface.number_of_halfedges(), 0);
  map.quarter_turns.assign(surface.number_of_halfedges(), 0);
  map.status.assign(surface.patches.size(), Map_status::SOLVER_FAILED);
  map.fraction_bits.assign(surface.patches.size(), 0);
  map.faulty_faces.assign(surface.patches.size(), {});
  for_each_patch<ConcurrencyTag>(surface, [&](const int number)
  {
    map.status[number] = compute_seamless_map_of_patch(surface, number, alpha, rho, matching, index, target_length,
                                                       solver_traits, map);
    return Patch_result();
  });
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMPUTE_SEAMLESS_MAP_H
