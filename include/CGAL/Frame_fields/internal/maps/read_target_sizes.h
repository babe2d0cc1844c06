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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_READ_TARGET_SIZES_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_READ_TARGET_SIZES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// One halfedge that ends at each vertex of an embedding.
inline std::vector<int> halfedges_of_vertices(const Surface_embedding& embedding)
{
  std::vector<int> result(embedding.point.size(), -1);
  for(std::size_t h = 0; h < embedding.vertex.size(); ++h)
    if(int& first = result[embedding.vertex[h]]; first < 0)
      first = static_cast<int>(h);
  return result;
}

// Calls `visit(v, number)` for the vertices of an embedding, with their descriptors and their numbers in it, until a
// call fails. Returns the failure, or success.
template <typename CutMesh, typename Visit>
Result for_each_vertex(const CutMesh& cut_mesh, const Surface_embedding& embedding, const Visit& visit)
{
  for(const int h : halfedges_of_vertices(embedding))
    if(const Result result = visit(target(cut_mesh.halfedge_of(h), cut_mesh.mesh()), embedding.vertex[h]); !result)
      return result;
  return {};
}

// Divides densities that are one over the lengths wanted by a common one, which becomes the edge length: the one that
// as many quads would have if all were of the same size or, if the number of quads is given, the one that follows from
// it. Then only the ratios of the lengths count.
inline void make_densities_relative(const Cut_surface& surface, const Surface_embedding& embedding,
                                    const Quad_size& size, Target_sizes& sizes)
{
  const auto [smallest, largest] = std::minmax_element(sizes.density.begin(), sizes.density.end());
  const double largest_density = *largest;
  if(*smallest == *largest)
    sizes.density.clear();
  for(double& density : sizes.density)
    density /= largest_density;
  const double squared_density = mean_squared_density(surface, embedding, sizes.density,
                                                      { 0, surface.number_of_faces() });
  sizes.edge_length = 1 / (largest_density * std::sqrt(squared_density));
  for(double& density : sizes.density)
    density /= std::sqrt(squared_density);
  if(size.number_of_quads > 0)
    sizes.edge_length = std::sqrt(surface_area(surface) / size.number_of_quads);
}

// Reads the lengths wanted at the vertices, in the unit of the mesh; they must be positive and finite.
template <typename CutMesh, typename SizingMap>
Result read_sizes(const CutMesh& cut_mesh, const Surface_embedding& embedding, const SizingMap sizing,
                  const Quad_size& size, Target_sizes& sizes)
{
  const Cut_surface& surface = cut_mesh.surface();
  sizes.density.assign(embedding.point.size(), 1);
  const Result result = for_each_vertex(cut_mesh, embedding, [&](const auto v, const int number) -> Result
  {
    const double length = static_cast<double>(get(sizing, v)) / surface.length_unit;
    sizes.density[number] = 1 / length;
    if(length > 0 && std::isfinite(length) && std::isfinite(1 / length))
      return {};
    return failure(ERROR_WRONG_PARAMETER, "sizing_map is not a positive finite number at the vertex at "
                                          + to_text(cut_mesh.coordinates(v)));
  });
  if(result)
    make_densities_relative(surface, embedding, size, sizes);
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_READ_TARGET_SIZES_H
