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

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The leaning frames of a field: branch 0 is at `alpha`, branch 1 at a right angle and `rho` from there.
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

  // Per patch: how many pairs of indices it lost. One whose indices the caller wants keeps them.
  std::vector<int> run()
  {
    std::vector<int> result(m_surface.patches.size(), 0);
    std::optional<Cut_surface> part; // a copy, with one patch at a time
    for(std::size_t p = 0; p < result.size(); ++p)
      if((m_map.status[p] == Map_status::FORCED_ZERO_SIDE || m_map.status[p] == Map_status::ONE_PAIR_ON_TORUS)
         && !has_index_targets(m_surface, m_surface.patches[p]))
      {
        if(!part)
          part = m_surface;
        result[p] = repair(static_cast<int>(p), *part);
      }
    return result;
  }

private:
  static constexpr int maximum_number_of_pairs = 3;

  struct Silent_clock
  {
    void start(Stage) const {}
  };

  int repair(const int number, Cut_surface& part)
  {
    part.patches.assign(1, m_surface.patches[number]);
    part.index_target.assign(m_surface.number_of_sectors(), NO_INDEX_TARGET);
    Frame_field field = m_field;
    Leaning_frames frames = leaning_frames(field);
    for(int pairs = 1; pairs <= maximum_number_of_pairs; ++pairs)
    {
      if(!propose_index_targets(part, part.patches[0], frames.alpha, frames.rho, field.matching, field.index,
                                part.index_target))
        return 0;
      Silent_clock clock;
      field = Frame_field();
      if(compute_frame_field<CGAL::Sequential_tag>(part, m_options, m_solver_traits, clock, field).error_code != OK)
        return 0;
      frames = leaning_frames(field);
      int fraction_bits = 0;
      const Map_status status =
        compute_seamless_map_of_patch(part, part.patches[0], frames.alpha, frames.rho, field.matching, field.index,
                                      m_target_length, m_solver_traits, m_map, fraction_bits);
      if(status == Map_status::CERTIFIED)
      {
        m_map.status[number] = status;
        m_map.fraction_bits[number] = fraction_bits;
        take(part.patches[0], field);
        return pairs;
      }
    }
    return 0;
  }

  void take(const Patch& patch, const Frame_field& field)
  {
    const auto copy = [](const Index_range& range, const auto& from, auto& to)
    {
      std::copy(from.begin() + range.begin_index, from.begin() + range.end_index, to.begin() + range.begin_index);
    };
    copy(patch.faces, field.alpha, m_field.alpha);
    copy(patch.faces, field.gamma, m_field.gamma);
    copy(patch.dual_edges, field.omega, m_field.omega);
    copy(patch.dual_edges, field.matching, m_field.matching);
    copy(patch.sectors, field.index, m_field.index);
  }

  const Cut_surface& m_surface;
  const Options& m_options;
  const std::vector<double>& m_target_length; // per face
  const SolverTraits& m_solver_traits;
  Frame_field& m_field;
  Seamless_map& m_map;
};

// The maps of all patches, and how many pairs of indices each patch lost for them.
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
