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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_ARC_SIDES_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_ARC_SIDES_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The pieces of the T-mesh of a patch that one side of an arc consists of, in the order in which the patch has them on
// its left. No pieces if the patch has no T-mesh, or if there is no patch on this side.
struct Arc_side
{
  int patch = -1;
  std::vector<int> pieces;
};

// Per arc, first the side of the halfedges that the arc lists, then that of their twins.
typedef std::vector<std::array<Arc_side, 2> > Arc_sides;

// The side of its arc on which a constrained halfedge is.
inline int side_of_arc(const Feature_network& network, const int halfedge)
{
  return network.arcs[network.arc[halfedge]].halfedges[network.place[halfedge]] == halfedge ? 0 : 1;
}

// Whether a node of a T-mesh is at a node of the feature network.
inline bool is_at_network_node(const Cut_surface& surface, const Surface_embedding& embedding,
                               const Feature_network& network, const T_mesh_node& node)
{
  return node.sector >= 0 && network.is_node[embedding.vertex[surface.first_corner[node.sector]]];
}

// Adds the pieces of the T-mesh of one patch to the sides of the arcs. On a loop they begin with any of its pieces.
inline void collect_sides_of_patch(const Cut_surface& surface, const Surface_embedding& embedding,
                                   const Feature_network& network, const T_mesh& t_mesh,
                                   Arc_sides& sides)
{
  // From each node of the border one piece of the border goes on.
  std::vector<int> piece_from(t_mesh.nodes.size(), -1);
  for(std::size_t p = 0; p < t_mesh.pieces.size(); ++p)
    if(t_mesh.pieces[p].halfedge >= 0)
      piece_from[t_mesh.pieces[p].source] = static_cast<int>(p);

  const auto ends = [&](const int node)
  {
    return is_at_network_node(surface, embedding, network, t_mesh.nodes[node]);
  };
  std::vector<char> is_collected(t_mesh.pieces.size(), 0);
  const auto collect_from = [&](const int first)
  {
    const int halfedge = t_mesh.pieces[first].halfedge;
    Arc_side& side = sides[network.arc[halfedge]][side_of_arc(network, halfedge)];
    for(int p = first; p >= 0 && !is_collected[p]; p = piece_from[t_mesh.pieces[p].target])
    {
      is_collected[p] = 1;
      side.pieces.push_back(p);
      if(ends(t_mesh.pieces[p].target))
        return;
    }
  };
  for(const bool is_loop : { false, true })
    for(std::size_t p = 0; p < t_mesh.pieces.size(); ++p)
      if(t_mesh.pieces[p].halfedge >= 0 && !is_collected[p] && (is_loop || ends(t_mesh.pieces[p].source)))
        collect_from(static_cast<int>(p));
}

// Collects the sides of all arcs, in linear time. `t_meshes` has one T-mesh per patch, an empty one if there is none.
inline Arc_sides collect_arc_sides(const Cut_surface& surface, const Surface_embedding& embedding,
                                   const Feature_network& network, const std::vector<T_mesh>& t_meshes)
{
  Arc_sides sides(network.arcs.size());
  for(std::size_t patch = 0; patch < surface.patches.size(); ++patch)
  {
    const Index_range faces = surface.patches[patch].faces;
    for(int h = 3 * faces.begin_index; h < 3 * faces.end_index; ++h)
      if(surface.is_constrained(h))
        sides[network.arc[h]][side_of_arc(network, h)].patch = static_cast<int>(patch);
    collect_sides_of_patch(surface, embedding, network, t_meshes[patch], sides);
  }
  return sides;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_ARC_SIDES_H
