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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_COMPUTE_INTEGER_GRID_MAPS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_COMPUTE_INTEGER_GRID_MAPS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/integer_grid/integer_grid_of_patch.h>
#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/compute_seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Quad_maker.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/arcs_of_request.h>
#include <CGAL/Frame_fields/internal/quads/make_T_meshes.h>
#include <CGAL/Frame_fields/internal/quads/make_smooth_quads.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Computes the integer-grid maps of a field, from seamless maps, their T-meshes, and numbers of edges that make valid
// quads. `skewness` is per face. Fails only if wanted numbers of edges contradict
// one another.
template <typename ConcurrencyTag, typename SolverTraits>
Result compute_integer_grid_maps(const Cut_surface& surface, const Surface_embedding& embedding,
                                 const Quad_request& request, const Frame_field& field,
                                 const std::vector<double>& skewness,
                                 const SolverTraits& solver_traits, Seamless_map& grid_map)
{
  Seamless_map map;
  compute_seamless_map<ConcurrencyTag>(surface, field.alpha, skewness, field.matching, field.index,
                                       edge_length_of_faces(surface, embedding, request), solver_traits, map);
  Feature_network features;
  std::vector<int> number_of_edges;
  const double unit = 1;
  if(const Result result = arcs_of_request(surface, embedding, unit, field.index, request, features, number_of_edges);
     !result)
    return result;
  Cut_surface surface_with_sizes;
  const Quad_targets targets = targets_of(surface, embedding, request, number_of_edges, surface_with_sizes);
  std::vector<T_mesh> t_meshes;
  make_T_meshes<ConcurrencyTag>(targets.sized_surface != nullptr ? surface_with_sizes : surface, embedding,
                                field.index, map, features, t_meshes);
  Quad_maker maker(surface, embedding, field.index, features, map, t_meshes, request.edge_length, targets);
  const bool is_refined = false;
  make_requested_quads(maker, request, is_refined);

  const std::vector<std::vector<int> > edges_of_piece = maker.layout().edges_of_piece();
  grid_map = map;
  for_each_patch<ConcurrencyTag>(surface, [&](const int p)
  {
    if(!t_meshes[p].cells.empty())
      grid_map.status[p] = integer_grid_map_of_patch(
        surface, p, field.index, map, t_meshes[p], edges_of_piece[p],
        fixed_sectors(surface, surface.patches[p], field.index, t_meshes[p]), solver_traits, grid_map);
    else if(map.status[p] == Map_status::CERTIFIED)
      grid_map.status[p] = Map_status::NO_NUMBERS_OF_EDGES;
    return Patch_result();
  });
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_COMPUTE_INTEGER_GRID_MAPS_H
