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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_RECHOOSE_BEND_VERTICES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_RECHOOSE_BEND_VERTICES_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Bend_vertices.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Sliding_quads.h>
#include <CGAL/Frame_fields/internal/quads/smooth_quads.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The vertices of the patches at the given arcs.
inline std::vector<int> vertices_of_patches_at(const Quad_complex& complex, const Sliding_quads& quads,
                                               const std::vector<int>& arcs)
{
  std::vector<char> is_patch_at_arc(quads.surface().patches.size(), 0), is_found(complex.vertices.size(), 0);
  for(const int arc : arcs)
    for(const int v : complex.arcs[arc])
      for(const int* c = quads.corners_begin(v); c != quads.corners_end(v); ++c)
        is_patch_at_arc[quads.patch(*c / 4)] = 1;
  std::vector<int> result;
  for(std::size_t q = 0; q < complex.quads.size(); ++q)
    if(is_patch_at_arc[complex.patch[q]])
      for(const int v : complex.quads[q])
        if(!is_found[v])
        {
          is_found[v] = 1;
          result.push_back(v);
        }
  return result;
}

// Chooses the vertices at bends of arcs anew, first on the arcs where the choice is clear. Those that were chosen by
// the maps of the two sides of an arc, which do not agree, make slanted quads. All vertices of the patches there slide,
// but in the end, vertices have moved to bends, and quads may be inverted. Returns false where bends are so few that
// few quads could be slanted.
template <typename ConcurrencyTag>
bool move_other_vertices_to_bends(Quad_complex& complex, const Cut_surface& surface,
                                  const Surface_embedding& embedding, const Feature_network& network,
                                  const Smoothing_options& options)
{
  const std::size_t largest_ratio = 200; // of vertices to bends
  Bend_vertices bend_vertices(complex, embedding, network);
  if(complex.vertices.size() > largest_ratio * bend_vertices.number_of_bends())
    return false;
  for(const bool is_last : { false, true })
  {
    const std::vector<int> open_arcs = bend_vertices.open_arcs();
    if(open_arcs.empty())
      break;
    Sliding_quads quads(complex, surface, embedding, network, options.arc_tolerance);
    const std::vector<int> vertices = vertices_of_patches_at(complex, quads, open_arcs);
    Distortion_sweeps<ConcurrencyTag>(quads, vertices).run(options.number_of_sweeps / 2, options.passable);
    if(is_last)
      bend_vertices.choose_everywhere(quads);
    else
      bend_vertices.choose_where_clear(quads);
  }
  return true;
}

// The same for a complex without inverted quads, unless there would be inverted ones then.
template <typename ConcurrencyTag>
void rechoose_bend_vertices(Quad_complex& complex, const Cut_surface& surface, const Surface_embedding& embedding,
                            const Feature_network& network, Smoothing_options options)
{
  Quad_complex next = complex;
  if(!move_other_vertices_to_bends<ConcurrencyTag>(next, surface, embedding, network, options))
    return;
  const std::vector<char> no_patch(surface.patches.size(), 0);
  options.may_release_bends = false;
  if(smooth_inverted_quads<ConcurrencyTag>(next, surface, embedding, network, no_patch, options).quads.empty())
    complex = std::move(next);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_RECHOOSE_BEND_VERTICES_H
