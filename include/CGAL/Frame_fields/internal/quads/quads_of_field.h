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
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/repair_field.h>
#include <CGAL/Frame_fields/internal/quads/Quad_output.h>
#include <CGAL/Frame_fields/internal/quads/make_quads.h>
#include <CGAL/Frame_fields/internal/quads/quad_parameters.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// From a field to quads in the caller's mesh. `edge_length` is in the unit of `Cut_surface::length`; `unit` is what the
// caller's lengths are divided by before they get to the surface. Of a field that is given, there are no statistics.
template <typename ConcurrencyTag, typename SolverTraits, typename StageClock, typename QuadMesh,
          typename NamedParameters>
Result quads_of_field(const Cut_surface& surface, const Surface_embedding& embedding, const double unit,
                      const double edge_length, const Options& options, const SolverTraits& solver_traits,
                      Frame_field& field, const bool is_field_given, StageClock& clock, QuadMesh& quad_mesh,
                      const NamedParameters& np)
{
  clock.start(Quad_stage::SEAMLESS_MAP);
  const std::vector<double> target_length(surface.number_of_faces(), edge_length);
  Seamless_map map;
  const std::vector<int> cancelled_pairs = compute_seamless_map_and_repair_field<ConcurrencyTag>(
    surface, options, target_length, solver_traits, field, map);

  Quad_statistics statistics;
  if(!is_field_given)
    write_statistics(surface, options, field, No_stage_clock(), statistics.field);
  const Quad_complex complex =
    make_quads<ConcurrencyTag>(surface, embedding, field.index, map, {}, edge_length, clock, statistics);
  note_cancelled_pairs(cancelled_pairs, statistics);
  clock.start(Quad_stage::ASSEMBLY);
  output_quads(surface, embedding, complex, unit, quad_mesh, np);
  clock.stop();
  statistics.quality = quality_of(surface, embedding, complex, unit);
  statistics.target_edge_length = edge_length * surface.length_unit * unit;
  statistics.seconds = clock.seconds();
  put_statistics(CGAL::parameters::get_parameter(np, internal::statistics), statistics);
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUADS_OF_FIELD_H
