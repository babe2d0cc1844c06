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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_FIELD_FOR_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_FIELD_FOR_QUADS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/quads/Quad_stage_clock.h>
#include <CGAL/Frame_fields/internal/quads/metric_of_sizes.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Computes the field that quads follow. It is smooth in the metric in which all wanted lengths are the same, if their
// density per vertex is given and not empty.
template <typename ConcurrencyTag, typename SolverTraits>
Patch_result compute_field_for_quads(const Cut_surface& surface, const Surface_embedding& embedding,
                                     const std::vector<double>& density, const Options& options,
                                     const SolverTraits& solver_traits, Quad_stage_timer& clock, Frame_field& field)
{
  if(density.empty())
    return compute_frame_field<ConcurrencyTag>(surface, options, solver_traits, clock, field);
  const Cut_surface sized_surface = surface_in_metric_of_sizes(surface, embedding, density);
  const Patch_result result = compute_frame_field<ConcurrencyTag>(sized_surface, options, solver_traits, clock, field);
  if(result.error_code == OK)
    carry_angles(sized_surface, surface, field.alpha);
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_FIELD_FOR_QUADS_H
