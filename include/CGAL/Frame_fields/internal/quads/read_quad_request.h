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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_READ_QUAD_REQUEST_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_READ_QUAD_REQUEST_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/maps/read_target_sizes.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/quad_parameters.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Reads the named parameters about single elements that the functions that make quads have.

// Reads the numbers wanted on the edges, per halfedge and 0 on unconstrained ones. Fails with `ERROR_WRONG_PARAMETER`
// if a number is negative or asks for too many quads.
template <typename CutMesh, typename NumberMap>
Result read_numbers_of_edges(const CutMesh& cut_mesh, const Surface_embedding& embedding, const NumberMap numbers,
                             Quad_request& request)
{
  const Cut_surface& surface = cut_mesh.surface();
  const double largest = largest_number_of_quads();
  // A wanted number also divides the strip of quads across its edge. This is the number of quads along such a strip, if
  // the surface were a square.
  const double other_side = std::sqrt(surface_area(surface)) / request.edge_length;
  request.number_of_edges.assign(surface.number_of_halfedges(), 0);
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    if(!surface.is_constrained(h))
      continue;
    const int number = get(numbers, edge(cut_mesh.halfedge_of(h), cut_mesh.mesh()));
    if(number < 0 || number * (number + other_side) > largest)
      return failure(ERROR_WRONG_PARAMETER, "number_of_edges_map is " + std::to_string(number) + " on "
                                            + text_of_edge(embedding, h, surface.length_unit));
    request.number_of_edges[h] = number;
  }
  return {};
}

// Reads the whole request, with lengths in the unit of `Cut_surface::length`, and checks the number of quads.
// `request.is_node` must be empty.
template <typename CutMesh, typename NamedParameters>
Result read_quad_request(const CutMesh& cut_mesh, const Surface_embedding& embedding, const NamedParameters& np,
                         const Quad_size& size, Quad_request& request)
{
  using CGAL::parameters::get_parameter;
  const Cut_surface& surface = cut_mesh.surface();
  request.edge_length = target_edge_length_of(size, surface);
  request.number_of_quads = size.number_of_quads;
  Result result;
  if constexpr(is_given<NamedParameters, internal::sizing_t>)
    result = read_sizes(cut_mesh, embedding, get_parameter(np, internal::sizing), size, request);
  if(result)
    result = check_number_of_quads(surface, embedding, request);
  if constexpr(is_given<NamedParameters, internal::fixed_number_of_edges_t>)
    if(result)
      result = read_numbers_of_edges(cut_mesh, embedding, get_parameter(np, internal::fixed_number_of_edges), request);
  if constexpr(is_given<NamedParameters, CGAL::internal_np::vertex_is_constrained_t>)
  {
    const std::vector<int> halfedges = halfedges_of_vertices(embedding);
    for(const int h : halfedges)
      request.is_node.push_back(get(get_parameter(np, CGAL::internal_np::vertex_is_constrained),
                                    target(cut_mesh.halfedge_of(h), cut_mesh.mesh())) ? 1 : 0);
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_READ_QUAD_REQUEST_H
