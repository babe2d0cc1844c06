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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_BOUND_LAYOUT_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_BOUND_LAYOUT_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/Arc_bends.h>
#include <CGAL/Frame_fields/internal/quads/Layout_demands.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/quads/fill_patch.h>
#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/t_mesh_network.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The bounds of the numbers of edges that all solutions must keep.

// The least number of edges of a piece or arc. The quadratic costs rate half of the wanted number no worse than one and
// a half times it. So no edge may be longer than about twice the wanted length, unless the caller fixes numbers.
inline int least_count(const double target)
{
  const double largest_count = 1e8;
  return static_cast<int>((std::min)(largest_count, target / 2));
}

// Whether a piece would join two vertices that must not coincide if it got no edge. Of chains of pieces, only the
// rounds can tell. `index` is 4 I per sector.
inline bool separates_critical_vertices(const Cut_surface& surface, const std::vector<int>& index, const T_mesh& t_mesh,
                                        const T_mesh_piece& piece)
{
  const auto is_critical_node = [&](const int n)
  {
    const T_mesh_node& node = t_mesh.nodes[n];
    return node.halfedge >= 0
        || (node.sector >= 0 && (surface.is_constrained_sector(node.sector) || index[node.sector] != 0));
  };
  return piece.halfedge < 0 && is_critical_node(piece.source) && is_critical_node(piece.target);
}

inline void bound_pieces(const Cut_surface& surface, const std::vector<int>& index,
                         const std::vector<T_mesh>& t_meshes, const Layout_demands& demands, T_mesh_network& layout)
{
  const bool has_fixed_arcs = demands.has_fixed_arcs();
  for(std::size_t patch = 0; patch < t_meshes.size(); ++patch)
  {
    std::size_t unknown = layout.first_piece[patch];
    for(const T_mesh_piece& piece : t_meshes[patch].pieces)
    {
      Bidirected_edge& edge = layout.network.edges[unknown++];
      const bool needs_edge = demands.forbids_empty_pieces
                           || separates_critical_vertices(surface, index, t_meshes[patch], piece);
      edge.lower_bound = (std::max)(needs_edge ? 1 : 0, has_fixed_arcs ? 0 : least_count(edge.target));
    }
  }
}

// Arcs have edges between all bends, unless their number is wanted or the bends are given up.
inline void bound_arcs(const Arc_bends& bends, const Layout_demands& demands, T_mesh_network& layout)
{
  const bool has_fixed_arcs = demands.has_fixed_arcs();
  for(std::size_t a = 0; a < demands.ignores_bends.size(); ++a)
  {
    if(demands.is_fixed(a) || demands.ignores_bends[a])
      continue;
    Bidirected_edge& edge = layout.network.edges[a];
    edge.lower_bound = (std::max)({ edge.lower_bound, bends.least_number_of_edges(a),
                                    has_fixed_arcs ? 0 : least_count(edge.target) });
  }
}

// The fillings need a few edges on each of their arcs; split triangles have two for each edge of the mesh.
inline void bound_arcs_of_fillings(const Surface_embedding& embedding, const Feature_network& features,
                                   const Arc_sides& sides, const std::vector<Patch_source>& sources,
                                   T_mesh_network& layout)
{
  for(std::size_t a = 0; a < features.arcs.size(); ++a)
  {
    Bidirected_edge& edge = layout.network.edges[a];
    for(const Arc_side& side : sides[a])
      if(side.patch >= 0 && sources[side.patch] == Patch_source::FILLING)
        edge.lower_bound = (std::max)(edge.lower_bound, smallest_even_count(embedding, features.arcs[a]));
    if(is_beside_split_patch(sides, sources, static_cast<int>(a)))
      edge.lower_bound = edge.upper_bound = 2 * static_cast<int>(features.arcs[a].halfedges.size());
  }
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_BOUND_LAYOUT_H
