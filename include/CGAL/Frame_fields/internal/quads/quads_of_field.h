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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUADS_OF_FIELD_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUADS_OF_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/quads/Mapped_field.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_output.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/Quad_stage_clock.h>
#include <CGAL/Frame_fields/internal/quads/arcs_of_request.h>
#include <CGAL/Frame_fields/internal/quads/make_quads.h>
#include <CGAL/Frame_fields/internal/quads/quad_parameters.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The quads made of a field, and their statistics.
struct Made_quads
{
  Quad_complex complex;
  Quad_statistics statistics;
};

// From a field with its maps to quads. A field that the caller gave has no statistics. `unit` is the length by which
// the caller's lengths were divided before the surface was made. Fails only if wanted numbers of edges contradict one
// another.
template <typename ConcurrencyTag, typename SolverTraits>
Result make_quads_of_field(const Cut_surface& surface, const Surface_embedding& embedding, const double unit,
                           const Quad_request& request, const Options& options, const SolverTraits& solver_traits,
                           const Mapped_field& mapped, const bool is_field_given, Quad_stage_timer& clock,
                           Made_quads& made)
{
  const Frame_field& field = mapped.field;
  Feature_network features;
  std::vector<int> number_of_edges;
  if(const Result result = arcs_of_request(surface, embedding, unit, field.index, request, features, number_of_edges);
     !result)
    return result;

  if(!is_field_given)
    write_statistics(surface, options, field, No_stage_clock(), made.statistics.field);
  made.complex = make_quads<ConcurrencyTag>(surface, embedding, field.index, mapped.map, features, request,
                                            number_of_edges, solver_traits, clock, made.statistics);
  clock.stop();
  note_cancelled_pairs(mapped.number_of_cancelled_pairs, made.statistics);
  made.statistics.quality = quality_of(surface, embedding, made.complex, unit);
  return {};
}

// The lengths that were asked for, in the caller's unit, which is `unit` of those of the request.
inline void write_sizes(const Surface_embedding& embedding, const Quad_request& request, const double unit,
                        Quad_statistics& statistics)
{
  const std::vector<double> lengths = lengths_at_vertices(embedding, request);
  const auto [smallest, largest] = std::minmax_element(lengths.begin(), lengths.end());
  statistics.target_edge_length = request.edge_length * unit;
  statistics.minimum_target_edge_length = *smallest * unit;
  statistics.maximum_target_edge_length = *largest * unit;
}

// From a field with its maps, which may be overwritten, to quads in the caller's mesh; `locate` is as for
// `output_quads()`.
template <typename ConcurrencyTag, typename SolverTraits, typename Locate, typename QuadMesh,
          typename NamedParameters>
Result quads_of_field(const Cut_surface& surface, const Surface_embedding& embedding, const double unit,
                      const Quad_request& request, const Options& options, const SolverTraits& solver_traits,
                      Mapped_field& mapped, const bool is_field_given, const Locate& locate, Quad_stage_timer& clock,
                      QuadMesh& quad_mesh, const NamedParameters& np)
{
  const auto make = [&](Made_quads& made)
  {
    return make_quads_of_field<ConcurrencyTag>(surface, embedding, unit, request, options, solver_traits, mapped,
                                               is_field_given, clock, made);
  };
  Made_quads made;
  if(const Result result = make(made); !result)
    return result;
  if(!request.density.empty() && made.statistics.quality.number_of_inverted_quads > 0)
  {
    // Maps of one size have rounder cells. The sizes still tell how many edges these get.
    clock.start(Quad_stage::SEAMLESS_MAP);
    Target_sizes one_size = request;
    one_size.density.clear();
    map_field<ConcurrencyTag>(surface, embedding, one_size, options, solver_traits, mapped);
    Made_quads other;
    const Result result = make(other);
    if(result && other.statistics.quality.number_of_inverted_quads < made.statistics.quality.number_of_inverted_quads)
      made = std::move(other);
  }

  write_sizes(embedding, request, surface.length_unit * unit, made.statistics); // may throw, so it comes before
  clock.start(Quad_stage::ASSEMBLY);
  output_quads(surface, embedding, made.complex, unit, locate, quad_mesh, np);
  clock.stop();
  made.statistics.seconds = clock.seconds();
  write_filled_patches(made.statistics,
                       CGAL::parameters::get_parameter(np, internal::fallback_patch_output_iterator));
  put_statistics(CGAL::parameters::get_parameter(np, internal::statistics), made.statistics);
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUADS_OF_FIELD_H
