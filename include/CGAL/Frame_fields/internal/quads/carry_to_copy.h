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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_CARRY_TO_COPY_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_CARRY_TO_COPY_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/Working_mesh.h>
#include <CGAL/Frame_fields/internal/surface/working_copy.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Between a mesh and its refined copy.

// Carries what is asked for on the elements of a mesh to its refined copy, whose embedding is `embedding`. Lengths go
// from the unit of the given surface to that of the copy.
template <typename CutCopy>
Quad_request carry_to_copy(const Quad_request& request, const Cut_surface& given_surface,
                           const Surface_embedding& given_embedding, const CutCopy& cut_copy,
                           const Surface_embedding& embedding)
{
  const Cut_surface& surface = cut_copy.surface();
  const Working_mesh& copy = cut_copy.mesh();
  Quad_request result;
  result.edge_length = request.edge_length / surface.length_unit;
  result.number_of_quads = request.number_of_quads;
  result.density.resize(request.density.empty() ? 0 : embedding.point.size());
  result.is_node.resize(request.is_node.empty() ? 0 : embedding.point.size());
  result.number_of_edges.resize(request.number_of_edges.empty() ? 0 : surface.number_of_halfedges());
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    const int v = target(cut_copy.halfedge_of(h), copy).value;
    if(!request.density.empty())
      result.density[embedding.vertex[h]] = copy.density()[v];
    if(static_cast<std::size_t>(v) < request.is_node.size())
      result.is_node[embedding.vertex[h]] = request.is_node[v];
  }
  if(request.number_of_edges.empty())
    return result;
  const std::vector<int> halfedge_of_copy = halfedges_of_copy(given_surface, given_embedding);
  std::vector<int> number_of_edges(num_edges(copy), 0); // of the edges of the copy before it was refined
  for(std::size_t h = 0; h < halfedge_of_copy.size(); ++h)
    number_of_edges[halfedge_of_copy[h] / 2] = request.number_of_edges[h];
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    if(surface.is_constrained(h))
      result.number_of_edges[h] = number_of_edges[copy.origin().edge(cut_copy.halfedge_of(h).value / 2)];
  return result;
}

// The location in the given mesh of one in its copy.
template <typename CutCopy>
Surface_location location_in_given_mesh(const Surface_embedding& given_embedding, const CutCopy& cut_copy,
                                        const Surface_location& location)
{
  const Working_mesh& copy = cut_copy.mesh();
  std::array<int, 3> vertices;
  Coordinates point{ 0, 0, 0 };
  for(int k = 0; k < 3; ++k)
  {
    vertices[k] = target(cut_copy.halfedge_of(3 * location.face + k), copy).value;
    const Working_mesh::Point& p = copy.points()[vertices[k]];
    point = point + location.barycentric[k] * Coordinates{ p.x(), p.y(), p.z() };
  }
  return copy.origin().location(given_embedding, cut_copy.face_descriptors()[location.face].value, vertices,
                                location.barycentric, point);
}

// The result of a stage on the copy with a sector of the given mesh, near the one of the copy, for its message.
template <typename CutMesh, typename CutCopy>
Patch_result result_in_given_mesh(const CutMesh& given_mesh, const Surface_embedding& given_embedding,
                                  const CutCopy& cut_copy, Patch_result result)
{
  if(result.error_code == OK)
    return result;
  const int corner = cut_copy.surface().first_corner[result.sector];
  const Surface_location given = location_in_given_mesh(given_embedding, cut_copy, location_on_halfedge(corner, 1));
  const auto nearest = std::max_element(given.barycentric.begin(), given.barycentric.end());
  const int given_corner = 3 * given.face + static_cast<int>(nearest - given.barycentric.begin());
  result.sector = given_mesh.surface().sector[given_corner];
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_CARRY_TO_COPY_H
