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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARCS_OF_REQUEST_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARCS_OF_REQUEST_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/make_feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/quad_parameters.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Finds the arcs of a field, and the number of edges wanted on each, 0 where it is free, or none if all are free.
// Fails if wanted numbers contradict one another. `unit` is the length by which the caller's lengths were divided
// before the surface was made.
inline Result arcs_of_request(const Cut_surface& surface, const Surface_embedding& embedding, const double unit,
                              const std::vector<int>& index, const Quad_request& request, Feature_network& features,
                              std::vector<int>& number_of_edges)
{
  features = make_feature_network(surface, embedding, feature_nodes(surface, embedding, index, request.is_node));
  if(const int h = read_numbers_of_arcs(request, features, number_of_edges); h >= 0)
    return failure(ERROR_WRONG_PARAMETER,
                   "number_of_edges_map is " + std::to_string(request.number_of_edges[h]) + " on "
                   + text_of_edge(embedding, h, surface.length_unit * unit)
                   + ", but another number on the same curve, or less than 3 on a closed one without node");
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARCS_OF_REQUEST_H
