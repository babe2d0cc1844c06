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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAPPED_FIELD_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAPPED_FIELD_H

#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/repair_field.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A field and the maps that follow it.
struct Mapped_field
{
  Frame_field field;
  Seamless_map map;
  std::vector<int> number_of_cancelled_pairs; // of indices, which had no map, per patch
};

// The sizes for maps, which only have to be in proportion to those wanted. They are not above the length of all edges
// together, so that no square of a coordinate underflows.
inline Target_sizes sizes_for_maps(const Cut_surface& surface, const Target_sizes& wanted)
{
  Target_sizes result = wanted;
  result.edge_length =
    (std::min)(result.edge_length, std::accumulate(surface.length.begin(), surface.length.end(), 0.));
  return result;
}

// Computes the maps of a field, for quads of the wanted sizes. They may repair the field.
template <typename ConcurrencyTag, typename SolverTraits>
void map_field(const Cut_surface& surface, const Surface_embedding& embedding, const Target_sizes& wanted,
               const Options& options, const SolverTraits& solver_traits, Mapped_field& mapped)
{
  const std::vector<double> target_length =
    edge_length_of_faces(surface, embedding, sizes_for_maps(surface, wanted));
  const std::vector<int> number_of_pairs = compute_seamless_map_and_repair_field<ConcurrencyTag>(
    surface, options, target_length, solver_traits, mapped.field, mapped.map);
  mapped.number_of_cancelled_pairs.resize(number_of_pairs.size(), 0);
  std::transform(number_of_pairs.begin(), number_of_pairs.end(), mapped.number_of_cancelled_pairs.begin(),
                 mapped.number_of_cancelled_pairs.begin(), std::plus<int>());
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAPPED_FIELD_H
