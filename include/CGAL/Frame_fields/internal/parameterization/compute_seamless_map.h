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

#include <CGAL/Frame_fields/internal/linear/solve.h>
#include <CGAL/Frame_fields/internal/parameterization/Combed_field.h>
#include <CGAL/Frame_fields/internal/parameterization/Combing.h>
#include <CGAL/Frame_fields/internal/parameterization/Cut_graph.h>
#include <CGAL/Frame_fields/internal/parameterization/Frame_energy.h>
#include <CGAL/Frame_fields/internal/parameterization/Map_basis.h>
#include <CGAL/Frame_fields/internal/parameterization/Map_certificate.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/Untangler.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Whether each sector has room for a quad.
inline bool has_room_for_quads(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index)
{
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(quarter_turns_of_sector(surface, index, s) < 1)
      return false;
  return true;
}

// How many bits after the point leave room for the values of a map and its unknowns; negative if they are too large.
inline int fraction_bits_for(const std::vector<double>& z, const std::vector<double>& x)
{
  double largest = 1e-3;
  for(const double value : z)
    largest = (std::max)(largest, std::abs(value));
  for(const double value : x)
    largest = (std::max)(largest, std::abs(value));
  const int bits_of_values = 49; // less than 2^50 after the rounding
  return std::isfinite(largest) ? bits_of_values - 1 - std::ilogb(largest) : -1;
}

// Writes x = B z, computed in integers from z rounded to the grid.
inline bool write_map(const Patch& patch, const Cut_graph& graph, const Map_basis& basis, const std::vector<double>& z,
                      const int fraction_bits, Seamless_map& map)
{
  std::vector<std::int64_t> integer_z(z.size()), integer_x;
  for(std::size_t i = 0; i < z.size(); ++i)
    integer_z[i] = std::llround(std::ldexp(z[i], fraction_bits));
  basis.multiply(integer_z, integer_x);
  const std::int64_t limit = std::int64_t(1) << 50;
  if(std::any_of(integer_x.begin(), integer_x.end(), [&](const std::int64_t x) { return x <= -limit || x >= limit; }))
    return false;
  const int first = 3 * patch.faces.begin_index;
  for(int h = first; h < 3 * patch.faces.end_index; ++h)
  {
    map.u[h] = integer_x[2 * graph.vertex[h - first]];
    map.v[h] = integer_x[2 * graph.vertex[h - first] + 1];
  }
  return true;
}

// Computes the map of one patch: `alpha` and `rho` are the relaxed field, `target_length` is per face, in the unit of
// `Cut_surface::length`. Writes only to the entries of the patch.
template <typename SolverTraits>
Map_status compute_seamless_map_of_patch(const Cut_surface& surface, const Patch& patch,
                                         const std::vector<double>& alpha, const std::vector<double>& rho,
                                         const std::vector<int>& matching, const std::vector<int>& index,
                                         const std::vector<double>& target_length, const SolverTraits& solver_traits,
                                         Seamless_map& map, int& fraction_bits)
{
  if(!has_room_for_quads(surface, patch, index))
    return Map_status::WRONG_CONE;
  const Combing combing = comb(surface, patch, matching, patch.faces.begin_index);
  std::copy(combing.quarter_turns.begin(), combing.quarter_turns.end(),
            map.quarter_turns.begin() + 3 * patch.faces.begin_index);
  const Cut_graph graph = Patch_cutter(surface, patch, index, combing).cut();
  const Combed_field field(surface, patch, alpha, rho, combing);
  Map_basis basis(surface, patch, graph, field);
  if(basis.has_overflow())
    return Map_status::SOLVER_FAILED;
  if(basis.has_forced_zero_side())
    return Map_status::FORCED_ZERO_SIDE;

  const Map_elements elements(surface, patch, field, graph, target_length, basis.side_edges());
  const Frame_energy energy(elements, basis);
  basis.reorder(energy.unknowns_in_elimination_order(solver_traits));
  auto solver = solver_traits.real_solver_object();
  std::vector<double> z, x;
  if(!factor_and_solve(solver, energy.matrix(), energy.right_hand_side(), z))
    return Map_status::SOLVER_FAILED;

  Untangler<decltype(solver)> untangler(elements, basis, solver, z);
  untangler.untangle(400);

  basis.multiply(z, x);
  fraction_bits = fraction_bits_for(z, x);
  if(fraction_bits < 0 || !write_map(patch, graph, basis, z, fraction_bits, map))
    return Map_status::SOLVER_FAILED;
  return Map_certificate(surface, patch, index, [&](const int h) { return field.branch_along(h); }, map).status();
}

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
  for_each_patch<ConcurrencyTag>(surface, [&](const int number)
  {
    map.status[number] = compute_seamless_map_of_patch(surface, surface.patches[number], alpha, rho, matching, index,
                                                       target_length, solver_traits, map, map.fraction_bits[number]);
    return Patch_result();
  });
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMPUTE_SEAMLESS_MAP_H
