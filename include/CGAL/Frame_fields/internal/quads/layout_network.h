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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_LAYOUT_NETWORK_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_LAYOUT_NETWORK_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The numbers of quad edges of all pieces and arcs as the unknowns of one network: opposite sides of a cell are equal,
// and so are an arc and the pieces on each of its sides.
struct Layout_network
{
  Bidirected_network network;
  std::vector<int> first_piece;  // per patch: the unknown of its first piece; piece p is that plus p
  int first_arc = 0;             // arc a is this plus a
};

// An unknown that costs the square of its deviation from `edges`, in proportion to them.
inline Bidirected_edge layout_unknown(const double edges, const double importance)
{
  return { { { -1, -1 } }, { { 1, 1 } }, edges, importance / (std::max)(1., edges), 1 };
}

// Adds an unknown to the sum of a node; it is in at most two.
inline void add_to_node(Bidirected_edge& unknown, const int node, const int sign)
{
  const int end = unknown.node[0] < 0 ? 0 : 1;
  unknown.node[end] = node;
  unknown.sign[end] = sign;
}

inline double arc_length(const Cut_surface& surface, const Feature_arc& arc)
{
  double length = 0;
  for(const int h : arc.halfedges)
    length += surface.length[h];
  return length;
}

// `target_edge_length` is in the unit of `Cut_surface::length`.
inline Layout_network make_layout_network(const Cut_surface& surface, const Feature_network& features,
                                          const std::vector<T_mesh>& t_meshes, const Arc_sides& sides,
                                          const double target_edge_length)
{
  Layout_network result;
  std::vector<Bidirected_edge>& unknowns = result.network.edges;
  int& number_of_nodes = result.network.number_of_nodes;
  for(const T_mesh& t_mesh : t_meshes)
  {
    const int first = static_cast<int>(unknowns.size());
    result.first_piece.push_back(first);
    for(const T_mesh_piece& piece : t_mesh.pieces)
      unknowns.push_back(layout_unknown(piece.length / target_edge_length, 1));
    for(const T_mesh_cell& cell : t_mesh.cells)
      for(int s = 0; s < 2; ++s)
      {
        const int node = number_of_nodes++;
        for(const int side : { s, s + 2 })
          for(const Directed_piece& directed : cell.sides[side])
            add_to_node(unknowns[first + directed.piece], node, side == s ? 1 : -1);
      }
  }
  result.first_arc = static_cast<int>(unknowns.size());
  for(std::size_t a = 0; a < features.arcs.size(); ++a)
  {
    Bidirected_edge arc = layout_unknown(arc_length(surface, features.arcs[a]) / target_edge_length, 2);
    arc.lower_bound = features.arcs[a].is_loop ? 3 : 1;
    for(const Arc_side& side : sides[a])
    {
      if(side.pieces.empty())
        continue;
      const int node = number_of_nodes++;
      add_to_node(arc, node, -1);
      for(const int p : side.pieces)
        add_to_node(unknowns[result.first_piece[side.patch] + p], node, 1);
    }
    unknowns.push_back(arc);
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_LAYOUT_NETWORK_H
