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
#include <CGAL/Frame_fields/internal/layout/make_feature_network.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_maker.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/make_sized_quads.h>
#include <CGAL/Frame_fields/internal/quads/smooth_quads.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

inline const char* reason_of(const Map_status status)
{
  switch(status)
  {
    case Map_status::CERTIFIED:         return "";
    case Map_status::FORCED_ZERO_SIDE:  return "the field forces a feature edge to length zero";
    case Map_status::SOLVER_FAILED:     return "the linear system of the map could not be solved";
    case Map_status::INVERTED_FACE:     return "a face of the map is inverted";
    case Map_status::REVERSED_EDGE:     return "a feature edge of the map runs backward";
    case Map_status::WRONG_CONE:        return "a sector of the map does not have the angle of its index";
    case Map_status::ONE_PAIR_ON_TORUS: return "a torus with one pair of irregular vertices has no map";
  }
  return "";
}

inline const char* reason_of(const T_mesh_status status)
{
  switch(status)
  {
    case T_mesh_status::COMPLETE:           return "no numbers of edges fit its arcs and those of its neighbors";
    case T_mesh_status::NOT_CERTIFIED:      return "the map has no certificate";
    case T_mesh_status::WRONG_SECTOR:       return "a sector of the map does not have the directions of its index";
    case T_mesh_status::TOO_LONG:           return "the lines from the singularities are too long";
    case T_mesh_status::OVERLAPPING_PIECES: return "lines from the singularities overlap";
    case T_mesh_status::NO_RECTANGLES:      return "the lines from the singularities do not bound rectangles";
  }
  return "";
}

// The number of quads asked for as an edge length, or the other way round.
inline double surface_area(const Cut_surface& surface)
{
  double sum = 0;
  for(const Patch& patch : surface.patches)
    sum += patch_area(surface, patch);
  return sum;
}

// Quantizes, assembles and smooths. Where quads of a T-mesh stay inverted, they are made anew with more room; the
// result with the fewest of them is smoothed as a whole.
template <typename StageClock>
Quad_complex make_smooth_quads(const Cut_surface& surface, const Surface_embedding& embedding,
                               const std::vector<int>& index, const Feature_network& features,
                               const Seamless_map& map, std::vector<T_mesh>& t_meshes,
                               const Quad_request& request, const Quad_targets& targets, StageClock& clock,
                               std::vector<char>& is_filled)
{
  const int maximum_number_of_refinements = 6;
  Smoothing_options options;
  double least_edge_length = request.edge_length;
  for(const double edge_length : targets.edge_length)
    least_edge_length = (std::min)(least_edge_length, edge_length);
  options.may_release_bends = false;
  Quad_maker maker(surface, embedding, index, features, map, t_meshes, request.edge_length, targets);
  Quad_complex complex;
  std::size_t least_number_of_inverted = 0;
  for(int refinement = 0; ; ++refinement)
  {
    clock.start(Quad_stage::QUANTIZATION);
    Quad_complex next = refinement > 0                ? maker.make()
                        : request.number_of_quads > 0 ? make_quads_of_number(maker, request.number_of_quads)
                                                      : make_quads_along_arcs(maker);
    options.arc_tolerance = maker.arc_tolerance() * (least_edge_length / request.edge_length);
    std::vector<char> is_next_filled;
    for(const T_mesh& t_mesh : t_meshes)
      is_next_filled.push_back(t_mesh.cells.empty());
    clock.start(Quad_stage::SMOOTHING);
    const std::vector<int> inverted =
      smooth_inverted_quads(next, surface, embedding, features, is_next_filled, options);
    const bool is_better = refinement == 0 || inverted.size() < least_number_of_inverted;
    const bool is_worth_more = refinement == 0 || 4 * inverted.size() <= 3 * least_number_of_inverted;
    const bool has_more_room = is_worth_more && !inverted.empty() && refinement < maximum_number_of_refinements
                               && maker.refine(next, inverted);
    if(is_better)
    {
      complex = std::move(next);
      is_filled = std::move(is_next_filled);
      least_number_of_inverted = inverted.size();
    }
    if(!has_more_room)
      break;
  }

  // Valid quads matter more than that vertices stay at the bends of arcs.
  options.may_release_bends = true;
  smooth_inverted_quads(complex, surface, embedding, features, std::vector<char>(surface.patches.size(), 0), options);
  options.untangles = options.may_release_bends = false;
  smooth(complex, surface, embedding, features, options);
  return complex;
}

// The arcs whose wanted number of edges was given up.
inline std::size_t number_of_unmet_edge_numbers(const Quad_complex& complex, const std::vector<int>& number_of_edges)
{
  std::size_t result = 0;
  for(std::size_t a = 0; a < number_of_edges.size(); ++a)
    result += number_of_edges[a] > 0
           && static_cast<int>(complex.arcs[a].size()) - (complex.is_loop[a] ? 0 : 1) != number_of_edges[a];
  return result;
}

// All stages behind the map, with lengths in the unit of `Cut_surface::length`. `number_of_edges` is what is wanted of
// the arcs, or empty.
template <typename ConcurrencyTag, typename StageClock>
Quad_complex make_quads(const Cut_surface& surface, const Surface_embedding& embedding, const std::vector<int>& index,
                        const Seamless_map& map, const Feature_network& features, const Quad_request& request,
                        const std::vector<int>& number_of_edges, StageClock& clock, Quad_statistics& statistics)
{
  clock.start(Quad_stage::T_MESH);
  const std::vector<char>& is_node = features.is_node;
  Cut_surface surface_with_sizes;
  Quad_targets targets;
  targets.number_of_edges = number_of_edges;
  if(!request.density.empty())
  {
    surface_with_sizes = sized_surface(surface, embedding, request.density);
    targets.sized_surface = &surface_with_sizes;
    targets.edge_length = edge_length_of_patches(surface, embedding, request);
  }
  const Cut_surface& measured_surface = request.density.empty() ? surface : surface_with_sizes;
  std::vector<char> is_arc_node(surface.number_of_sectors(), 0);
  for(int s = 0; s < surface.number_of_sectors(); ++s)
    is_arc_node[s] = surface.is_constrained_sector(s) && is_node[embedding.vertex[surface.first_corner[s]]];
  std::vector<T_mesh> t_meshes(surface.patches.size());
  std::vector<T_mesh_status> t_mesh_status(surface.patches.size());
  for_each_patch<ConcurrencyTag>(surface, [&](const int patch)
  {
    T_mesh_result result = make_T_mesh(measured_surface, measured_surface.patches[patch], index, map, is_arc_node);
    t_meshes[patch] = std::move(result.mesh);
    t_mesh_status[patch] = result.status;
    return Patch_result();
  });

  std::vector<char> is_filled;
  const Quad_complex complex = make_smooth_quads(surface, embedding, index, features, map, t_meshes,
                                                 request, targets, clock, is_filled);

  statistics.number_of_patches = surface.patches.size();
  statistics.number_of_arcs = features.arcs.size();
  statistics.number_of_nodes = static_cast<std::size_t>(std::count(is_node.begin(), is_node.end(), char(1)));
  statistics.number_of_unmet_edge_numbers = number_of_unmet_edge_numbers(complex, number_of_edges);
  statistics.number_of_quads = complex.quads.size();
  statistics.patches.resize(surface.patches.size());
  for(std::size_t p = 0; p < surface.patches.size(); ++p)
  {
    Patch_quad_statistics& patch = statistics.patches[p];
    patch.number_of_faces = surface.patches[p].faces.size();
    patch.way = is_filled[p] ? Patch_way::FILLING : Patch_way::CERTIFIED_MAP;
    if(patch.way == Patch_way::FILLING)
      patch.reason = map.status[p] == Map_status::CERTIFIED ? reason_of(t_mesh_status[p]) : reason_of(map.status[p]);
    ++(patch.way == Patch_way::FILLING ? statistics.number_of_filled_patches
                                       : statistics.number_of_certified_patches);
  }
  for(const int patch : complex.patch)
    ++statistics.patches[patch].number_of_quads;
  return complex;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_QUADS_H
