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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_REQUEST_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_REQUEST_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// What the caller asks of the quads, on the surface that gets them.
struct Quad_request : Target_sizes
{
  double number_of_quads = 0;       // about how many there should be, 0 if the length alone counts
  std::vector<int> number_of_edges; // per halfedge: the number wanted on its arc, 0 if it is free; empty if all are
  std::vector<char> is_node;        // per vertex: whether arcs must end there; empty if none must
};

// What the numbers of edges are chosen by, besides the target edge length. Without sizes, the first two members are
// null and empty; without wanted numbers, the third one is empty.
struct Quad_targets
{
  const Cut_surface* sized_surface = nullptr; // with the lengths of `sized_surface()`
  std::vector<double> edge_length;            // per patch, in the unit of `Cut_surface::length`
  std::vector<int> number_of_edges;           // per arc: the number wanted, 0 if it is free
};

// The surface with the integral of the density along each edge in the place of its length.
inline Cut_surface sized_surface(const Cut_surface& surface, const Surface_embedding& embedding,
                                 const std::vector<double>& density)
{
  Cut_surface result = surface;
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    result.length[h] *= (density_at(embedding, density, h) + density_at(embedding, density, previous_of(h))) / 2;
  return result;
}

// Per patch: the edge length with which squares of the same size would be as many as the quads that the density asks
// for.
inline std::vector<double> edge_length_of_patches(const Cut_surface& surface, const Surface_embedding& embedding,
                                                  const Quad_request& request)
{
  std::vector<double> result;
  for(const Patch& patch : surface.patches)
    result.push_back(request.edge_length
                     / std::sqrt(mean_squared_density(surface, embedding, request.density, patch.faces)));
  return result;
}

// Reads the numbers of edges that are wanted on arcs. Returns -1, or the first halfedge at fault: one that wants
// another number than a halfedge before it on the same arc, or fewer than three edges on a closed arc without node.
inline int read_numbers_of_arcs(const Quad_request& request, const Feature_network& features,
                                std::vector<int>& number_of_edges)
{
  if(request.number_of_edges.empty())
    return -1;
  number_of_edges.assign(features.arcs.size(), 0);
  for(std::size_t h = 0; h < request.number_of_edges.size(); ++h)
  {
    const int wanted = request.number_of_edges[h], arc = features.arc[h];
    if(wanted == 0 || arc < 0)
      continue;
    if((number_of_edges[arc] != 0 && number_of_edges[arc] != wanted) || (features.arcs[arc].is_loop && wanted < 3))
      return static_cast<int>(h);
    number_of_edges[arc] = wanted;
  }
  return -1;
}

// The targets of a request. With sizes, they refer to `surface_with_sizes`, which is set then.
inline Quad_targets targets_of(const Cut_surface& surface, const Surface_embedding& embedding,
                               const Quad_request& request, const std::vector<int>& number_of_edges,
                               Cut_surface& surface_with_sizes)
{
  Quad_targets targets;
  targets.number_of_edges = number_of_edges;
  if(!request.density.empty())
  {
    surface_with_sizes = sized_surface(surface, embedding, request.density);
    targets.sized_surface = &surface_with_sizes;
    targets.edge_length = edge_length_of_patches(surface, embedding, request);
  }
  return targets;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_REQUEST_H
