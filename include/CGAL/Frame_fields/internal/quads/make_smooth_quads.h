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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_SMOOTH_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_SMOOTH_QUADS_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_maker.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/Quad_stage_clock.h>
#include <CGAL/Frame_fields/internal/quads/make_sized_quads.h>
#include <CGAL/Frame_fields/internal/quads/place_on_integer_grids.h>
#include <CGAL/Frame_fields/internal/quads/rechoose_bend_vertices.h>
#include <CGAL/Frame_fields/internal/quads/smooth_quads.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Makes the first quads as they were asked for, and those of each refinement as the bounds say.
inline Quad_complex make_requested_quads(Quad_maker& maker, const Quad_request& request, const bool is_refined)
{
  if(is_refined)
    return maker.make();
  return request.number_of_quads > 0 ? make_quads_of_number(maker, request.number_of_quads)
                                     : make_quads_along_arcs(maker);
}

// The patches without a T-mesh.
inline std::vector<char> filled_patches(const std::vector<T_mesh>& t_meshes)
{
  std::vector<char> result;
  for(const T_mesh& t_mesh : t_meshes)
    result.push_back(t_mesh.cells.empty());
  return result;
}

// Options of the smoothing that accept poor shapes in the first sweeps, as thin strips of quads pass through these
// while they widen.
inline Smoothing_options smoothing_through_poor_shapes()
{
  Smoothing_options options;
  options.passable = 0.05;
  return options;
}

// The quads with the fewest inverted ones among those of several refinements.
struct Refined_quads
{
  Quad_complex complex;
  std::vector<char> is_filled; // per patch
  double arc_tolerance = 0;    // how far their sides may be from the arcs
};

// Lets vertices around inverted quads of T-meshes leave the bends of arcs. Returns whether no quad of them stays
// inverted.
template <typename ConcurrencyTag>
bool is_valid_without_bends(Refined_quads& quads, const Cut_surface& surface, const Surface_embedding& embedding,
                            const Feature_network& features)
{
  Smoothing_options options = smoothing_through_poor_shapes();
  options.arc_tolerance = quads.arc_tolerance;
  return smooth_inverted_quads<ConcurrencyTag>(quads.complex, surface, embedding, features, quads.is_filled,
                                               options).quads.empty();
}

// Tries another start where quads stay inverted: moves the vertices of their patches to integer-grid maps and smooths
// there again. Keeps what has fewer inverted quads and returns these. On many faces this would take too long. With
// `stops_early`, the smoothing stops once it has fallen behind the first one.
template <typename ConcurrencyTag, typename SolverTraits>
Inverted_quads restart_on_integer_grids(const Cut_surface& surface, const Surface_embedding& embedding,
                                        const std::vector<int>& index, const Feature_network& features,
                                        const Seamless_map& map, const std::vector<T_mesh>& t_meshes,
                                        const Quad_maker& maker, const Smoothing_options& options,
                                        const SolverTraits& solver_traits, const Inverted_quads& inverted,
                                        const bool stops_early, Refined_quads& quads)
{
  const int maximum_number_of_faces = 100000;
  std::vector<char> is_restarted(t_meshes.size(), 0);
  for(const int q : inverted.quads)
  {
    const int patch = quads.complex.patch[q];
    is_restarted[patch] = surface.patches[patch].faces.size() <= maximum_number_of_faces;
  }
  Quad_complex complex = quads.complex;
  if(place_on_integer_grids<ConcurrencyTag>(surface, index, map, t_meshes, maker, is_restarted, solver_traits,
                                            complex) == 0)
    return inverted;
  const Inverted_quads still_inverted =
    smooth_inverted_quads<ConcurrencyTag>(complex, surface, embedding, features, quads.is_filled, options,
                                          stops_early ? inverted : Inverted_quads());
  if(still_inverted.quads.size() >= inverted.quads.size())
    return inverted;
  quads.complex = std::move(complex);
  return still_inverted;
}

// Quantizes and assembles. Where quads of a T-mesh stay inverted after their surroundings have been smoothed, all quads
// are made anew with more room there, at most six times. It stops earlier when no quad is inverted, when no bound can
// be raised, when refinements in vain have made too many quads, or when one has left more than four times the least
// number of inverted quads so far. It also stops at the beginning, or after the first refinement in vain, if the quads
// become valid when they leave the bends of arcs, as this keeps more of their shapes; to try this on many quads would
// take too long.
//
// A refinement is in vain if it leaves more than 3/4 of the least number of inverted quads so far and these are less
// than a tenth of all quads. Some of these may have to come before one that helps: quads between fixed vertices are
// valid only once they are divided, which happens when their empty pieces have got edges. Returns the quads with the
// fewest inverted ones.
template <typename ConcurrencyTag, typename SolverTraits>
Refined_quads make_refined_quads(const Cut_surface& surface, const Surface_embedding& embedding,
                                 const std::vector<int>& index, const Feature_network& features,
                                 const Seamless_map& map, const std::vector<T_mesh>& t_meshes,
                                 const Quad_request& request, const Quad_targets& targets,
                                 const SolverTraits& solver_traits, Quad_maker& maker, Quad_stage_timer& clock)
{
  const int maximum_number_of_refinements = 6;
  const std::size_t maximum_number_of_quads_in_vain = 50000;
  double least_edge_length = request.edge_length;
  for(const double edge_length : targets.edge_length)
    least_edge_length = (std::min)(least_edge_length, edge_length);
  Smoothing_options options = smoothing_through_poor_shapes();
  options.may_release_bends = false;
  Refined_quads best;
  Inverted_quads least; // of `best`
  std::size_t number_of_quads_in_vain = 0;
  for(int refinement = 0; ; ++refinement)
  {
    clock.start(Quad_stage::QUANTIZATION);
    Refined_quads next;
    next.complex = make_requested_quads(maker, request, refinement > 0);
    next.is_filled = filled_patches(t_meshes);
    next.arc_tolerance = maker.layout().arc_tolerance() * (least_edge_length / request.edge_length);
    clock.start(Quad_stage::SMOOTHING);
    options.arc_tolerance = next.arc_tolerance;
    const std::size_t number_of_quads = next.complex.quads.size();
    const bool may_be_last = number_of_quads > maximum_number_of_quads_in_vain; // so a vain one need not be finished
    const Inverted_quads rival = may_be_last ? least : Inverted_quads();
    Inverted_quads remaining =
      smooth_inverted_quads<ConcurrencyTag>(next.complex, surface, embedding, features, next.is_filled, options, rival);
    if(!remaining.quads.empty() && !remaining.is_beaten)
      remaining = restart_on_integer_grids<ConcurrencyTag>(surface, embedding, index, features, map, t_meshes, maker,
                                                           options, solver_traits, remaining, may_be_last, next);
    const std::vector<int>& inverted = remaining.quads;
    const bool is_better = refinement == 0 || inverted.size() < least.quads.size();
    const bool are_few_quads = number_of_quads <= 10 * inverted.size();
    const bool has_diverged = refinement > 0 && inverted.size() > 4 * least.quads.size();
    const bool is_in_vain = refinement > 0 && !are_few_quads && 4 * inverted.size() > 3 * least.quads.size();
    const Quad_complex& refined = is_better ? (best = std::move(next)).complex : next.complex;
    if(is_better)
      least = remaining;
    const bool is_first_in_vain = is_in_vain && number_of_quads_in_vain == 0;
    if(!inverted.empty() && (refinement == 0 || is_first_in_vain)
       && number_of_quads <= maximum_number_of_quads_in_vain)
    {
      Refined_quads released = best;
      if(is_valid_without_bends<ConcurrencyTag>(released, surface, embedding, features))
        return released;
    }
    number_of_quads_in_vain += is_in_vain ? number_of_quads : 0;
    if(inverted.empty() || has_diverged || refinement == maximum_number_of_refinements
       || number_of_quads_in_vain > maximum_number_of_quads_in_vain || !maker.refine(refined, inverted))
      return best;
  }
}

// Makes quads and smooths them as a whole. `t_meshes` of patches that are filled become empty.
template <typename ConcurrencyTag, typename SolverTraits>
Refined_quads make_smooth_quads(const Cut_surface& surface, const Surface_embedding& embedding,
                                const std::vector<int>& index, const Feature_network& features,
                                const Seamless_map& map, std::vector<T_mesh>& t_meshes, const Quad_request& request,
                                const Quad_targets& targets, const SolverTraits& solver_traits, Quad_stage_timer& clock)
{
  Quad_maker maker(surface, embedding, index, features, map, t_meshes, request.edge_length, targets);
  Refined_quads quads =
    make_refined_quads<ConcurrencyTag>(surface, embedding, index, features, map, t_meshes, request, targets,
                                       solver_traits, maker, clock);
  Smoothing_options options = smoothing_through_poor_shapes();
  options.arc_tolerance = quads.arc_tolerance;

  // Valid quads matter more than that vertices stay at the bends of arcs.
  options.may_release_bends = true;
  const std::vector<char> no_patch(surface.patches.size(), 0);
  const bool is_valid = smooth_inverted_quads<ConcurrencyTag>(quads.complex, surface, embedding, features, no_patch,
                                                              options).quads.empty();
  if(is_valid)
    rechoose_bend_vertices<ConcurrencyTag>(quads.complex, surface, embedding, features, options);
  options.untangles = options.may_release_bends = false;
  smooth<ConcurrencyTag>(quads.complex, surface, embedding, features, options);
  return quads;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_SMOOTH_QUADS_H
