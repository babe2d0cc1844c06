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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_BOUND_SIZES_OF_COPY_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_BOUND_SIZES_OF_COPY_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/maps/bound_sizes.h>
#include <CGAL/Frame_fields/internal/maps/read_target_sizes.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/quad_parameters.h>
#include <CGAL/Frame_fields/internal/quads/refine_for_quads.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Working_mesh.h>
#include <CGAL/Frame_fields/internal/surface/embed.h>
#include <CGAL/Frame_fields/internal/surface/working_copy.h>
#include <CGAL/Frame_fields/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Whether any named parameter bounds sizes.
template <typename NamedParameters>
constexpr bool has_size_bounds =
  is_given<NamedParameters, internal::chord_height_t> || is_given<NamedParameters, internal::edges_across_gap_t>
  || is_given<NamedParameters, internal::gradation_t> || is_given<NamedParameters, internal::minimum_edge_length_t>;

// The chords of a refined copy: those of the triangles and constrained edges of the given mesh that its own are parts
// of. The vertices of the copy between them are on these and not on the smooth surface, so its own triangles show no
// curvature. In the unit of the given surface.
template <typename CutCopy>
Chord_lengths chords_of_copy(const Chord_lengths& chords, const Cut_surface& given_surface,
                             const Surface_embedding& given_embedding, const CutCopy& cut_copy)
{
  const Working_mesh& copy = cut_copy.mesh();
  const Cut_surface& surface = cut_copy.surface();
  const std::vector<int> halfedge_of_copy = halfedges_of_copy(given_surface, given_embedding);
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> of_edge(num_edges(copy), infinity); // of the edges of the copy before it was refined
  for(std::size_t h = 0; h < halfedge_of_copy.size(); ++h)
    of_edge[halfedge_of_copy[h] / 2] = chords.halfedge[h];
  Chord_lengths result;
  for(const auto f : cut_copy.face_descriptors())
    result.face.push_back(chords.face[copy.origin().face(f.value)]);
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    result.halfedge.push_back(
      surface.is_constrained(h) ? of_edge[copy.origin().edge(cut_copy.halfedge_of(h).value / 2)] : infinity);
  return result;
}

// Lowers the sizes at the vertices of a copy, whose lengths are in the unit of the given surface, and writes them to
// the request and to the densities of the copy.
template <typename CutCopy>
Result bound_sizes_at_vertices(Working_mesh& copy, const CutCopy& cut_copy, const Size_bounds& bounds,
                               Chord_lengths chords, const double edge_length, Quad_request& request)
{
  const Cut_surface& surface = cut_copy.surface();
  const Surface_embedding embedding = embed(cut_copy);
  for(std::vector<double>* const lengths : { &chords.face, &chords.halfedge })
    for(double& length : *lengths)
      length /= surface.length_unit;
  const auto vertex_of_copy = [&](const int h) { return target(cut_copy.halfedge_of(h), copy).value; };

  std::vector<double> length(embedding.point.size(), edge_length / surface.length_unit);
  const std::vector<int> halfedges = halfedges_of_vertices(embedding);
  if(!copy.density().empty())
    for(std::size_t v = 0; v < length.size(); ++v)
      length[v] /= copy.density()[vertex_of_copy(halfedges[v])];
  bound_sizes(surface, embedding, in_unit(bounds, surface.length_unit), chords, length);

  Quad_request bounded;
  for(const double l : length)
    bounded.density.push_back(1 / l);
  make_densities_relative(surface, embedding, { 0, 0 }, bounded);
  if(const Result result = check_number_of_quads(surface, embedding, bounded); !result)
    return result;
  request.edge_length = bounded.edge_length * surface.length_unit;
  copy.density().resize(bounded.density.empty() ? 0 : copy.number_of_vertices());
  for(std::size_t v = 0; v < bounded.density.size(); ++v)
    copy.density()[vertex_of_copy(halfedges[v])] = bounded.density[v];
  return {};
}

// Lowers the sizes of a request as the bounds say, and refines the copy where that makes quads shorter than its
// triangles, if it `refines` at all. If all sizes are the same at first, gaps are measured once more on the refined
// copy, where the lengths that they ask for stay nearer to them.
template <typename Prepared>
Result bound_sizes_of_copy(Working_mesh& copy, const Prepared& prepared, const Cut_surface& given_surface,
                           const Surface_embedding& given_embedding, const Options& options,
                           const Size_bounds& bounds, const bool refines, Quad_request& request)
{
  const double edge_length = request.edge_length;
  const bool has_one_size = request.density.empty();
  if(!bounds.lower_lengths(has_one_size))
    return {};
  const int number_of_rounds = refines && has_one_size && bounds.edges_across_gap > 0 ? 2 : 1;
  const Chord_lengths chords = chord_lengths(given_surface, given_embedding, bounds.chord_height);
  for(int round = 0; round < number_of_rounds; ++round)
  {
    if(has_one_size)
      copy.density().clear();
    Stage_mesh<Working_mesh, typename Prepared::Pack> stage_mesh(copy, prepared);
    const bool accepts_overconstrained_faces = true;
    Result result = stage_mesh.cut(options, accepts_overconstrained_faces);
    if(result)
    {
      const auto& cut_copy = stage_mesh.cut_mesh();
      result = bound_sizes_at_vertices(copy, cut_copy, bounds,
                                       chords_of_copy(chords, given_surface, given_embedding, cut_copy), edge_length,
                                       request);
    }
    if(!result)
      return result;
    if(refines)
      refine_for_quads(copy, prepared, given_surface, request);
  }
  const auto first = copy.density().begin();
  request.density.assign(first, copy.density().empty() ? first
                                  : first + static_cast<std::ptrdiff_t>(given_embedding.point.size()));
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_BOUND_SIZES_OF_COPY_H
