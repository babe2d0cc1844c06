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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_QUADS_H

#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/make_T_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/Quad_stage_clock.h>
#include <CGAL/Frame_fields/internal/quads/make_T_meshes.h>
#include <CGAL/Frame_fields/internal/quads/make_smooth_quads.h>
#include <CGAL/Frame_fields/internal/quads/reason_of.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The number of arcs whose wanted number of edges was given up.
inline std::size_t number_of_unmet_edge_numbers(const Quad_complex& complex, const std::vector<int>& number_of_edges)
{
  std::size_t result = 0;
  for(std::size_t a = 0; a < number_of_edges.size(); ++a)
    result += number_of_edges[a] > 0
           && static_cast<int>(complex.arcs[a].size()) - (complex.is_loop[a] ? 0 : 1) != number_of_edges[a];
  return result;
}

// Writes into the statistics what became of each patch.
inline void count_patches(const Cut_surface& surface, const Seamless_map& map,
                          const std::vector<T_mesh_status>& t_mesh_status, const Refined_quads& quads,
                          Quad_statistics& statistics)
{
  statistics.number_of_patches = surface.patches.size();
  statistics.number_of_quads = quads.complex.quads.size();
  statistics.patches.resize(surface.patches.size());
  for(std::size_t p = 0; p < surface.patches.size(); ++p)
  {
    Patch_quad_statistics& patch = statistics.patches[p];
    patch.number_of_faces = surface.patches[p].faces.size();
    patch.way = quads.is_filled[p] ? Patch_way::FILLING : Patch_way::CERTIFIED_MAP;
    if(patch.way == Patch_way::FILLING)
      patch.reason = map.status[p] == Map_status::CERTIFIED ? reason_of(t_mesh_status[p]) : reason_of(map.status[p]);
    ++(patch.way == Patch_way::FILLING ? statistics.number_of_filled_patches
                                       : statistics.number_of_certified_patches);
  }
  for(const int patch : quads.complex.patch)
    ++statistics.patches[patch].number_of_quads;
}

// All stages after the map, with lengths in the unit of `Cut_surface::length`. `index` is 4 I per sector.
// `number_of_edges` is the number wanted on each arc, 0 where it is free, or empty.
template <typename ConcurrencyTag, typename SolverTraits>
Quad_complex make_quads(const Cut_surface& surface, const Surface_embedding& embedding, const std::vector<int>& index,
                        const Seamless_map& map, const Feature_network& features, const Quad_request& request,
                        const std::vector<int>& number_of_edges, const SolverTraits& solver_traits,
                        Quad_stage_timer& clock, Quad_statistics& statistics)
{
  clock.start(Quad_stage::T_MESH);
  Cut_surface surface_with_sizes;
  const Quad_targets targets = targets_of(surface, embedding, request, number_of_edges, surface_with_sizes);
  std::vector<T_mesh> t_meshes;
  const std::vector<T_mesh_status> t_mesh_status =
    make_T_meshes<ConcurrencyTag>(targets.sized_surface != nullptr ? surface_with_sizes : surface, embedding, index,
                                  map, features, t_meshes);
  Refined_quads quads =
    make_smooth_quads<ConcurrencyTag>(surface, embedding, index, features, map, t_meshes, request, targets,
                                      solver_traits, clock);

  statistics.number_of_nodes =
    static_cast<std::size_t>(std::count(features.is_node.begin(), features.is_node.end(), char(1)));
  statistics.number_of_arcs = features.arcs.size();
  statistics.number_of_unmet_edge_numbers = number_of_unmet_edge_numbers(quads.complex, number_of_edges);
  count_patches(surface, map, t_mesh_status, quads, statistics);
  return std::move(quads.complex);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_QUADS_H
