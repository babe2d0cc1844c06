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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_OUTPUT_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_OUTPUT_H

#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/quad_connectivity.h>
#include <CGAL/Frame_fields/internal/quads/write_quad_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The point of a vertex in the caller's unit; at a vertex of the triangle mesh exactly the one of that vertex.
inline Coordinates point_of(const Cut_surface& surface, const Surface_embedding& embedding, const Quad_vertex& vertex)
{
  Coordinates point{ 0, 0, 0 };
  if(vertex.vertex >= 0)
    point = embedding.point[vertex.vertex];
  else
    for(int k = 0; k < 3; ++k)
      for(int c = 0; c < 3; ++c)
        point[c] += vertex.location.barycentric[k]
                  * embedding.point[embedding.vertex[3 * vertex.location.face + k]][c];
  for(double& coordinate : point)
    coordinate *= surface.length_unit;
  return point;
}

// Whether the sides of quads run along feature arcs, as a flag per side, in O(n log n).
inline std::vector<char> sides_on_arcs(const Quad_complex& complex)
{
  std::vector<std::pair<int, int> > pairs;
  for(std::size_t a = 0; a < complex.arcs.size(); ++a)
  {
    const std::vector<int>& vertices = complex.arcs[a];
    for(std::size_t i = 0; i + 1 < vertices.size(); ++i)
      pairs.emplace_back(std::minmax(vertices[i], vertices[i + 1]));
    if(complex.is_loop[a])
      pairs.emplace_back(std::minmax(vertices.back(), vertices.front()));
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<char> result(4 * complex.quads.size());
  for(std::size_t side = 0; side < result.size(); ++side)
  {
    const int s = static_cast<int>(side);
    const std::pair<int, int> pair = std::minmax(side_source(complex, s), side_target(complex, s));
    result[side] = std::binary_search(pairs.begin(), pairs.end(), pair);
  }
  return result;
}

// Moves the statistics to the caller, as a copy might throw after the quads have been written.
inline void put_statistics(const std::reference_wrapper<Quad_statistics> map, Quad_statistics& statistics)
{
  map.get() = std::move(statistics);
}
inline void put_statistics(const CGAL::internal_np::Param_not_found, Quad_statistics&) {}

template <typename Map, typename Key, typename Value>
void put_if_given(const Map map, const Key& key, const Value& value) { put(map, key, value); }
template <typename Key, typename Value>
void put_if_given(const CGAL::internal_np::Param_not_found, const Key&, const Value&) {}

// Puts a face of the caller's mesh and the weights of the source of its halfedge, of its target and of the third
// vertex, as the locations in CGAL's package Polygon Mesh Processing have them.
template <typename Map, typename Key, typename Locate>
void put_location(const Map map, const Key& key, const Locate& locate, const Surface_location& location)
{
  typedef typename boost::property_traits<Map>::value_type Value;
  const auto located = locate(location);
  Value value;
  value.first = located.first;
  for(int k = 0; k < 3; ++k)
    value.second[k] = located.second[(k + 2) % 3];
  put(map, key, value);
}
template <typename Key, typename Locate>
void put_location(const CGAL::internal_np::Param_not_found, const Key&, const Locate&, const Surface_location&) {}

// Writes the numbers of the patches that were filled.
template <typename OutputIterator>
void write_filled_patches(const Quad_statistics& statistics, OutputIterator out)
{
  for(std::size_t p = 0; p < statistics.patches.size(); ++p)
    if(statistics.patches[p].way == Patch_way::FILLING)
      *out++ = static_cast<int>(p);
}
inline void write_filled_patches(const Quad_statistics&, const CGAL::internal_np::Param_not_found) {}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_OUTPUT_H
