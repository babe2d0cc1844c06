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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_READ_QUAD_INPUT_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_READ_QUAD_INPUT_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/maps/read_field.h>
#include <CGAL/Frame_fields/internal/parameterization/seamless_map_output.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/read_quad_request.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/embed.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A field that the caller gives, and what is asked of the quads that are made of it.
struct Quad_input
{
  Surface_embedding embedding;
  Quad_request request;
  Frame_field field;
  std::vector<double> skewness; // per face
};

// Reads the request and the field of a cut mesh, and checks both.
template <typename CutMesh, typename AlphaMap, typename SkewnessMap, typename MatchingMap, typename IndexMap,
          typename NamedParameters>
Result read_quad_input(const CutMesh& cut_mesh, const AlphaMap alpha_map, const SkewnessMap skewness_map,
                       const MatchingMap matching_map, const IndexMap index_map, const NamedParameters& np,
                       const Quad_size& size, Quad_input& input)
{
  input.embedding = embed(cut_mesh);
  Result result = read_quad_request(cut_mesh, input.embedding, np, size, input.request);
  if(!result)
    return result;
  Frame_field& field = input.field;
  result = read_field(cut_mesh, alpha_map, skewness_map, matching_map, field.alpha, input.skewness, field.matching);
  if(result)
    result = check_skewness(cut_mesh, input.skewness);
  if(result)
    result = read_indices(cut_mesh, alpha_map, skewness_map, field.matching, index_map, field.index);
  if(!result)
    return result;
  field.omega.assign(cut_mesh.surface().number_of_dual_edges(), 0);
  field.gamma.reserve(input.skewness.size());
  for(const double skewness : input.skewness)
    field.gamma.push_back({ 0, skewness });
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_READ_QUAD_INPUT_H
