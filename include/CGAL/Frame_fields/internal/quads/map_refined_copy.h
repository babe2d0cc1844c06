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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAP_REFINED_COPY_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAP_REFINED_COPY_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Mapped_field.h>
#include <CGAL/Frame_fields/internal/quads/Quad_stage_clock.h>
#include <CGAL/Frame_fields/internal/quads/field_for_quads.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/parameters.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The faces where attempts to find maps failed, and those within a few rings around them in their patches.
inline std::vector<int> faces_around_faults(const Cut_surface& surface, const Seamless_map& map)
{
  const int number_of_rings = 3;
  std::vector<char> is_found(surface.number_of_faces(), false);
  std::vector<int> result;
  const auto add = [&](const int face)
  {
    if(!is_found[face])
      result.push_back(face);
    is_found[face] = true;
  };
  for(const std::vector<int>& faces : map.faulty_faces)
    for(const int f : faces)
      add(f);
  for(int ring = 0; ring < number_of_rings; ++ring)
    for(std::size_t i = 0, end = result.size(); i < end; ++i)
      for(int h = 3 * result[i]; h < 3 * result[i] + 3; ++h)
        if(!surface.is_constrained(h))
          add(face_of(surface.opposite[h]));
  return result;
}

inline std::ptrdiff_t number_of_patches_without_map(const Seamless_map& map)
{
  return std::count_if(map.status.begin(), map.status.end(), [](const Map_status status)
                       { return status != Map_status::CERTIFIED; });
}

// Prepares and cuts a refined copy, and computes its field and the maps.
template <typename ConcurrencyTag, typename RefinedCopy, typename SolverTraits>
Result map_copy_as_it_is(RefinedCopy& copy, const bool follows_sizes, const Options& options,
                         const SolverTraits& solver_traits, Quad_stage_timer& clock, Mapped_field& mapped)
{
  clock.start(Quad_stage::PREPARATION);
  if(const Result result = copy.prepare_and_cut(); !result)
    return result;
  clock.start(Quad_stage::FIELD);
  const Patch_result result = compute_field_for_quads<ConcurrencyTag>(
    copy.surface(), copy.embedding(), follows_sizes ? copy.request().density : std::vector<double>(), options,
    solver_traits, clock, mapped.field);
  if(result.error_code != OK)
    return copy.given_result(result);
  clock.start(Quad_stage::SEAMLESS_MAP);
  map_field<ConcurrencyTag>(copy.surface(), copy.embedding(), copy.request(), options, solver_traits, mapped);
  return {};
}

// Prepares and cuts a refined copy, and computes its field and the maps. A patch without a map may have too few
// triangles somewhere, for example around ends of features. Those around the faults are split then, and it all begins
// again, twice at most, as long as fewer patches are left without a map.
template <typename ConcurrencyTag, typename RefinedCopy, typename SolverTraits>
Result map_refined_copy(RefinedCopy& copy, const bool follows_sizes, const Options& options,
                        const SolverTraits& solver_traits, Quad_stage_timer& clock, Mapped_field& mapped)
{
  const int maximum_number_of_splits = copy.may_split() ? 2 : 0;
  if(const Result result = map_copy_as_it_is<ConcurrencyTag>(copy, follows_sizes, options, solver_traits, clock,
                                                             mapped); !result)
    return result;
  for(int i = 0; i < maximum_number_of_splits; ++i)
  {
    const std::vector<int> faces = faces_around_faults(copy.surface(), mapped.map);
    if(faces.empty())
      break;
    auto old_state = copy.state();
    copy.split(faces);
    Mapped_field next;
    const Result result = map_copy_as_it_is<ConcurrencyTag>(copy, follows_sizes, options, solver_traits, clock, next);
    if(!result || number_of_patches_without_map(next.map) >= number_of_patches_without_map(mapped.map))
    {
      copy.restore(std::move(old_state));
      break;
    }
    mapped = std::move(next);
  }
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAP_REFINED_COPY_H
