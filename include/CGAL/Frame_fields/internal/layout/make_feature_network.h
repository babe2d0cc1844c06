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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MAKE_FEATURE_NETWORK_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MAKE_FEATURE_NETWORK_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/walk_along_border.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The vertices where feature arcs end, as a flag per vertex of the embedding; vertices without constrained edges are
// none. `index` is 4 I per sector. `is_marked` tells per vertex whether the caller wants it to be a node; it is empty
// if there is no such vertex.
inline std::vector<char> feature_nodes(const Cut_surface& surface, const Surface_embedding& embedding,
                                       const std::vector<int>& index, const std::vector<char>& is_marked)
{
  // Each constrained edge counts once: by the larger one of its two halfedges, or by its only one on the border.
  std::vector<int> number_of_edges(embedding.point.size(), 0);
  std::vector<char> is_node(embedding.point.size(), 0);
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    if(!surface.is_constrained(h) || embedding.twin[h] > h)
      continue;
    ++number_of_edges[embedding.vertex[h]];
    ++number_of_edges[embedding.vertex[previous_of(h)]];
  }
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    const int v = embedding.vertex[h], s = surface.sector[h];
    if(number_of_edges[v] == 0)
      continue;
    if(number_of_edges[v] != 2 || index[s] != 0 || (!is_marked.empty() && is_marked[v]))
      is_node[v] = 1;
  }
  return is_node;
}

// The arc, or the loop, whose first halfedge is `first`.
inline Feature_arc collect_arc(const Cut_surface& surface, const Surface_embedding& embedding,
                               const std::vector<char>& is_node, const int first)
{
  Feature_arc arc{ {}, false };
  int h = first;
  do
  {
    arc.halfedges.push_back(h);
    if(is_node[embedding.vertex[h]])
      return arc;
    h = next_on_border(surface, h);
  } while(h != first);
  arc.is_loop = true;
  return arc;
}

// Collects the arcs between the given nodes (a flag per vertex of the embedding), and the loops without node, in linear
// time.
inline Feature_network make_feature_network(const Cut_surface& surface, const Surface_embedding& embedding,
                                            const std::vector<char>& is_node)
{
  Feature_network network;
  network.is_node = is_node;
  network.arc.assign(surface.number_of_halfedges(), -1);
  network.place.assign(surface.number_of_halfedges(), -1);
  const auto add_arc = [&](const int first)
  {
    if(!surface.is_constrained(first) || network.arc[first] >= 0)
      return;
    network.arcs.push_back(collect_arc(surface, embedding, is_node, first));
    const std::vector<int>& halfedges = network.arcs.back().halfedges;
    for(std::size_t i = 0; i < halfedges.size(); ++i)
      for(const int h : { halfedges[i], embedding.twin[halfedges[i]] })
        if(h >= 0)
        {
          network.arc[h] = static_cast<int>(network.arcs.size()) - 1;
          network.place[h] = static_cast<int>(i);
        }
  };
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    if(is_node[embedding.vertex[previous_of(h)]])
      add_arc(h);
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    add_arc(h);
  return network;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MAKE_FEATURE_NETWORK_H
