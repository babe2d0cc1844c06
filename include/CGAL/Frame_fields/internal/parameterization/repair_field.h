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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_REPAIR_FIELD_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_REPAIR_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/No_index_target.h>
#include <CGAL/Frame_fields/Statistics.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/compute_seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/propose_index_targets.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>
#include <CGAL/Frame_fields/internal/surface/surface_of_patch.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The frames of a relaxed field: branch 0 is at the angle `alpha`, branch 1 at `alpha` + pi/2 + `rho`, in radians.
struct Leaning_frames
{
  std::vector<double> alpha, rho; // per face
};

inline Leaning_frames leaning_frames(const Frame_field& field)
{
  Leaning_frames result{ field.alpha, std::vector<double>(field.alpha.size()) };
  for(std::size_t f = 0; f < field.alpha.size(); ++f)
  {
    result.alpha[f] += field.gamma[f][0];
    result.rho[f] = field.gamma[f][1] - field.gamma[f][0];
  }
  return result;
}

// Gives patches whose indices exclude every map other indices, and a field and a map with them. A field that leads to
// no map with certificate stays as it was.
template <typename SolverTraits>
class Field_repair
{
public:
  Field_repair(const Cut_surface& surface, const Options& options, const std::vector<double>& target_length,
               const SolverTraits& solver_traits, Frame_field& field, Seamless_map& map)
    : m_surface(surface), m_options(options), m_target_length(target_length), m_solver_traits(solver_traits)
    , m_field(field), m_map(map)
  {}

  // Returns per patch how many pairs of indices it lost. A patch with index targets of the caller keeps its indices.
  std::vector<int> run()
  {
    std::vector<int> result(m_surface.patches.size(), 0);
    for(std::size_t p = 0; p < result.size(); ++p)
      if((m_map.status[p] == Map_status::FORCED_ZERO_SIDE || m_map.status[p] == Map_status::ONE_PAIR_ON_TORUS)
         && !has_index_targets(m_surface, m_surface.patches[p]))
        result[p] = repair(static_cast<int>(p));
    return result;
  }

private:
  static constexpr int maximum_number_of_pairs = 3;

  struct Silent_clock
  {
    void start(Stage) const {}
  };

  // Works on the patch as a surface of its own, so that the time does not depend on the others.
  int repair(const int number)
  {
    const Patch& patch = m_surface.patches[number];
    const std::vector<double> target_length = part_of(m_target_length, patch.faces);
    Cut_surface surface = surface_of_patch(m_surface, patch);
    surface.index_target.assign(surface.number_of_sectors(), NO_INDEX_TARGET);
    Frame_field field = field_of_patch(patch);
    Leaning_frames frames = leaning_frames(field);
    for(int pairs = 1; pairs <= maximum_number_of_pairs; ++pairs)
    {
      if(!propose_index_targets(surface, surface.patches[0], frames.alpha, frames.rho, field.matching, field.index,
                                surface.index_target))
        return 0;
      Silent_clock clock;
      field = Frame_field();
      if(compute_frame_field<CGAL::Sequential_tag>(surface, m_options, m_solver_traits, clock, field).error_code != OK)
        return 0;
      frames = leaning_frames(field);
      Seamless_map map;
      compute_seamless_map<CGAL::Sequential_tag>(surface, frames.alpha, frames.rho, field.matching, field.index,
                                                 target_length, m_solver_traits, map);
      if(map.status[0] == Map_status::CERTIFIED)
      {
        take(patch, field);
        take(number, map);
        return pairs;
      }
    }
    return 0;
  }

  Frame_field field_of_patch(const Patch& patch) const
  {
    Frame_field result;
    result.alpha = part_of(m_field.alpha, patch.faces);
    result.gamma = part_of(m_field.gamma, patch.faces);
    result.matching = part_of(m_field.matching, patch.dual_edges);
    result.index = part_of(m_field.index, patch.sectors);
    return result;
  }

  // Puts the values of one patch into those of all.
  template <typename T>
  static void put_part(const std::vector<T>& part, const Index_range& range, std::vector<T>& values)
  {
    std::copy(part.begin(), part.end(), values.begin() + range.begin_index);
  }

  void take(const Patch& patch, const Frame_field& field)
  {
    put_part(field.alpha, patch.faces, m_field.alpha);
    put_part(field.gamma, patch.faces, m_field.gamma);
    put_part(field.omega, patch.dual_edges, m_field.omega);
    put_part(field.matching, patch.dual_edges, m_field.matching);
    put_part(field.index, patch.sectors, m_field.index);
  }

  void take(const int number, const Seamless_map& map)
  {
    const Index_range halfedges = halfedges_of_patch(m_surface.patches[number]);
    put_part(map.u, halfedges, m_map.u);
    put_part(map.v, halfedges, m_map.v);
    put_part(map.quarter_turns, halfedges, m_map.quarter_turns);
    m_map.status[number] = map.status[0];
    m_map.fraction_bits[number] = map.fraction_bits[0];
  }

  const Cut_surface& m_surface;
  const Options& m_options;
  const std::vector<double>& m_target_length; // per face
  const SolverTraits& m_solver_traits;
  Frame_field& m_field;
  Seamless_map& m_map;
};

// Computes the maps of all patches, and repairs the field where `options.repair_matching` is set. Returns per patch how
// many pairs of indices it lost.
template <typename ConcurrencyTag, typename SolverTraits>
std::vector<int> compute_seamless_map_and_repair_field(const Cut_surface& surface, const Options& options,
                                                       const std::vector<double>& target_length,
                                                       const SolverTraits& solver_traits, Frame_field& field,
                                                       Seamless_map& map)
{
  const Leaning_frames frames = leaning_frames(field);
  compute_seamless_map<ConcurrencyTag>(surface, frames.alpha, frames.rho, field.matching, field.index, target_length,
                                       solver_traits, map);
  if(!options.repair_matching)
    return std::vector<int>(surface.patches.size(), 0);
  return Field_repair<SolverTraits>(surface, options, target_length, solver_traits, field, map).run();
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_REPAIR_FIELD_H
