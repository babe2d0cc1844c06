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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_TARGET_SIZES_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_TARGET_SIZES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/read_guidance.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The size of the quads among the named parameters, given by one of two numbers or by neither.
struct Quad_size
{
  double target_edge_length; // 0 if it is not given
  double number_of_quads;    // 0 if it is not given
};

// The size as it is given, in the unit of the mesh; `check_quad_size()` tells whether it is in range.
template <typename NamedParameters>
Quad_size quad_size_from(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return { static_cast<double>(choose_parameter(get_parameter(np, internal::target_edge_length), 0.)),
           static_cast<double>(choose_parameter(get_parameter(np, internal::number_of_quads), 0.)) };
}

// Fails with `ERROR_WRONG_PARAMETER` if a number that is given is out of range.
template <typename NamedParameters>
Result check_quad_size(const NamedParameters&, const Quad_size& size)
{
  constexpr bool has_length = is_given<NamedParameters, internal::target_edge_length_t>;
  constexpr bool has_number = is_given<NamedParameters, internal::number_of_quads_t>;
  if(has_length && !(std::isfinite(size.target_edge_length) && size.target_edge_length > 0))
    return wrong_parameter("target_edge_length", size.target_edge_length, "a positive finite number");
  if(has_number && !(std::isfinite(size.number_of_quads) && size.number_of_quads >= 1))
    return wrong_parameter("number_of_quads", size.number_of_quads, "a finite number, at least 1");
  return {};
}

// The target edge length in the unit of `Cut_surface::length`, which must be there. If the number of quads is given, it
// follows from that; the default is the mean length of the halfedges, in which edges that are not on the border count
// twice.
inline double target_edge_length_of(const Quad_size& size, const Cut_surface& surface)
{
  if(size.number_of_quads > 0)
    return std::sqrt(surface_area(surface) / size.number_of_quads);
  if(size.target_edge_length > 0)
    return size.target_edge_length / surface.length_unit;
  double sum = 0;
  for(const double length : surface.length)
    sum += length;
  return sum / static_cast<double>(surface.length.size());
}

// The lengths that edges should have: one length for all, divided by a density for each vertex.
struct Target_sizes
{
  double edge_length = 0;      // in the unit of `Cut_surface::length`
  std::vector<double> density; // per vertex: `edge_length` over the length wanted there; empty if it is 1
};

// The density at the target of a halfedge.
inline double density_at(const Surface_embedding& embedding, const std::vector<double>& density, const int halfedge)
{
  return density.empty() ? 1 : density[embedding.vertex[halfedge]];
}

// The lengths wanted at the vertices.
inline std::vector<double> lengths_at_vertices(const Surface_embedding& embedding, const Target_sizes& sizes)
{
  std::vector<double> result(embedding.point.size(), sizes.edge_length);
  for(std::size_t v = 0; v < sizes.density.size(); ++v)
    result[v] /= sizes.density[v];
  return result;
}

// The mean over a face of the density, which is linear between its vertices.
inline double mean_density(const Surface_embedding& embedding, const std::vector<double>& density, const int face)
{
  double sum = 0;
  for(int h = 3 * face; h < 3 * face + 3; ++h)
    sum += density_at(embedding, density, h);
  return sum / 3;
}

// The length that edges should have per face, in the unit of `Cut_surface::length`. The embedding is used only if there
// are densities.
inline std::vector<double> edge_length_of_faces(const Cut_surface& surface, const Surface_embedding& embedding,
                                                const Target_sizes& sizes)
{
  std::vector<double> result(surface.number_of_faces(), sizes.edge_length);
  if(!sizes.density.empty())
    for(int f = 0; f < surface.number_of_faces(); ++f)
      result[f] /= mean_density(embedding, sizes.density, f);
  return result;
}

// The mean of the squared density over some faces, weighted by area: the number of quads of the wanted size that cover
// them, divided by the number at the density 1. Without area it is that of the first face; `faces` must not be empty.
inline double mean_squared_density(const Cut_surface& surface, const Surface_embedding& embedding,
                                   const std::vector<double>& density, const Index_range& faces)
{
  double sum = 0, weighted_sum = 0;
  for(int f = faces.begin_index; f < faces.end_index; ++f)
  {
    const double face_density = mean_density(embedding, density, f), face_area = area(surface, f);
    sum += face_area;
    weighted_sum += face_area * face_density * face_density;
  }
  if(sum > 0 && weighted_sum > 0)
    return weighted_sum / sum;
  const double first_density = mean_density(embedding, density, faces.begin_index);
  return first_density * first_density;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_TARGET_SIZES_H
