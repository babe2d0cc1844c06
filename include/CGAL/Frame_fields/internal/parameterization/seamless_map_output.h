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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SEAMLESS_MAP_OUTPUT_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SEAMLESS_MAP_OUTPUT_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Seamless_map_status.h>
#include <CGAL/Frame_fields/internal/field/stages.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/maps/read_field.h>
#include <CGAL/Frame_fields/internal/maps/read_guidance.h>
#include <CGAL/Frame_fields/internal/maps/read_target_sizes.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/embed.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Between seamless maps in flat arrays and the caller's property maps and named parameters.

// Reads the index of each sector, and checks that it is that of the matching.
template <typename CutMesh, typename AlphaMap, typename SkewnessMap, typename IndexMap>
Result read_indices(const CutMesh& cut_mesh, const AlphaMap alpha_map, const SkewnessMap skewness_map,
                    const std::vector<int>& matching, const IndexMap index_map, std::vector<int>& index)
{
  std::vector<double> unrelaxed_alpha;
  Result result = read_unrelaxed_field(cut_mesh, alpha_map, skewness_map, unrelaxed_alpha);
  if(result)
    result = to_result(cut_mesh, compute_indices<CGAL::Sequential_tag>(cut_mesh.surface(), unrelaxed_alpha, matching,
                                                                       index));
  if(!result)
    return result;
  const Cut_surface& surface = cut_mesh.surface();
  for(int s = 0; s < surface.number_of_sectors(); ++s)
    if(get(index_map, cut_mesh.halfedge_of(surface.first_corner[s])) != index[s])
      return failure(ERROR_WRONG_FIELD, "the index is not that of the field at " + cut_mesh.description_of_sector(s));
  return {};
}

template <typename CutMesh>
Result check_skewness(const CutMesh& cut_mesh, const std::vector<double>& rho)
{
  for(std::size_t f = 0; f < rho.size(); ++f)
    if(!(std::abs(rho[f]) < CGAL_PI / 2))
      return failure(ERROR_WRONG_FIELD, "the skewness is a right angle or more in "
                                        + cut_mesh.description_of_face(static_cast<int>(f)));
  return {};
}

// Reads the target length, in the unit of `Cut_surface::length`, for each face.
template <typename CutMesh, typename NamedParameters>
Result read_target_length(const CutMesh& cut_mesh, const NamedParameters& np, std::vector<double>& target_length)
{
  const Cut_surface& surface = cut_mesh.surface();
  const Quad_size size = quad_size_from(np);
  if(const Result result = check_quad_size(np, size); !result)
    return result;
  Surface_embedding embedding;
  Target_sizes sizes;
  sizes.edge_length = target_edge_length_of(size, surface);
  if constexpr(is_given<NamedParameters, internal::sizing_t>)
  {
    embedding = embed(cut_mesh);
    const auto sizing = CGAL::parameters::get_parameter(np, internal::sizing);
    if(const Result result = read_sizes(cut_mesh, embedding, sizing, size, sizes); !result)
      return result;
  }
  if(!(sizes.edge_length > 0 && std::isfinite(sizes.edge_length)))
    return wrong_parameter("the target edge length", sizes.edge_length * surface.length_unit, "positive and finite");
  target_length = edge_length_of_faces(surface, embedding, sizes);
  return {};
}

// Writes the points of the corners, and the origin where there is no certified map.
template <typename CutMesh, typename UvMap>
void write_seamless_map(const CutMesh& cut_mesh, const Seamless_map& map, const UvMap uv_map)
{
  typedef typename boost::property_traits<UvMap>::value_type Point_2;
  const Cut_surface& surface = cut_mesh.surface();
  cut_mesh.for_each_halfedge([&](const auto h, const int i)
  {
    if(i < 0)
      put(uv_map, h, Point_2(0., 0.));
  });
  for(std::size_t patch = 0; patch < surface.patches.size(); ++patch)
  {
    const bool is_certified = map.status[patch] == Map_status::CERTIFIED;
    const auto coordinate = [&](const std::int64_t value)
    {
      return is_certified ? std::ldexp(static_cast<double>(value), -map.fraction_bits[patch]) : 0.;
    };
    const Index_range& faces = surface.patches[patch].faces;
    for(int h = 3 * faces.begin_index; h < 3 * faces.end_index; ++h)
      put(uv_map, cut_mesh.halfedge_of(h), Point_2(coordinate(map.u[h]), coordinate(map.v[h])));
  }
}

template <typename CutMesh, typename OutputIterator>
void write_uncertified_patches(const CutMesh& cut_mesh, const Seamless_map& map, OutputIterator out)
{
  typedef typename CutMesh::face_descriptor Face;
  for(std::size_t patch = 0; patch < map.status.size(); ++patch)
    if(map.status[patch] != Map_status::CERTIFIED)
      *out++ = Uncertified_patch<Face>{
        cut_mesh.face_descriptors()[cut_mesh.surface().patches[patch].faces.begin_index], map.status[patch] };
}

template <typename CutMesh>
void write_uncertified_patches(const CutMesh&, const Seamless_map&, const CGAL::internal_np::Param_not_found) {}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_SEAMLESS_MAP_OUTPUT_H
