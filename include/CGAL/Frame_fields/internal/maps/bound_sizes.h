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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_BOUND_SIZES_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_BOUND_SIZES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/Gap_rays.h>
#include <CGAL/Frame_fields/internal/maps/read_guidance.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/curvature.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// What bounds the lengths of edges of quads, among the named parameters.
struct Size_bounds
{
  double chord_height = std::numeric_limits<double>::infinity(); // infinite for any
  int edges_across_gap = 0;                                      // 0 for any
  double gradation = 1.5;                                        // infinite for any
  double minimum_edge_length = 0;

  // Whether they can lower lengths: without curvatures and gaps, only different ones.
  bool lower_lengths(const bool has_one_length) const
  {
    return std::isfinite(chord_height) || edges_across_gap > 0 || (!has_one_length && std::isfinite(gradation));
  }
};

template <typename NamedParameters>
Size_bounds size_bounds_from(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Size_bounds bounds;
  return { static_cast<double>(choose_parameter(get_parameter(np, internal::chord_height), bounds.chord_height)),
           static_cast<int>(choose_parameter(get_parameter(np, internal::edges_across_gap), bounds.edges_across_gap)),
           static_cast<double>(choose_parameter(get_parameter(np, internal::gradation), bounds.gradation)),
           static_cast<double>(choose_parameter(get_parameter(np, internal::minimum_edge_length),
                                                bounds.minimum_edge_length)) };
}

// Fails with `ERROR_WRONG_PARAMETER` if a number is out of range.
inline Result check(const Size_bounds& bounds)
{
  if(!(bounds.chord_height > 0))
    return wrong_parameter("chord_height", bounds.chord_height, "positive");
  if(bounds.edges_across_gap < 0)
    return wrong_parameter("edges_across_gap", bounds.edges_across_gap, "at least 0");
  if(!(bounds.gradation > 1))
    return wrong_parameter("gradation", bounds.gradation, "above 1");
  if(!(bounds.minimum_edge_length >= 0 && std::isfinite(bounds.minimum_edge_length)))
    return wrong_parameter("minimum_edge_length", bounds.minimum_edge_length, "a finite number, at least 0");
  return {};
}

// The same with lengths in another unit.
inline Size_bounds in_unit(Size_bounds bounds, const double unit)
{
  bounds.chord_height /= unit;
  bounds.minimum_edge_length /= unit;
  return bounds;
}

// The longest chord of a circle that is not farther from it than `height`.
inline double chord_length(const double curvature, const double height)
{
  if(!(curvature > 0) || std::isinf(height))
    return std::numeric_limits<double>::infinity();
  const double radius = 1 / curvature, least_height = (std::min)(height, radius);
  return std::sqrt(8 * radius * least_height - 4 * least_height * least_height);
}

// The longest chords of a surface and its curves that are not farther from them than a height, in the unit of
// `Cut_surface::length`.
struct Chord_lengths
{
  std::vector<double> face;     // per face
  std::vector<double> halfedge; // per halfedge, infinite on unconstrained ones
};

inline Chord_lengths chord_lengths(const Cut_surface& surface, const Surface_embedding& embedding,
                                   const double height)
{
  Chord_lengths result;
  if(std::isinf(height))
    return { std::vector<double>(surface.number_of_faces(), height),
             std::vector<double>(surface.number_of_halfedges(), height) };
  const Face_curvatures curvatures(surface, embedding);
  for(int f = 0; f < surface.number_of_faces(); ++f)
    result.face.push_back(chord_length(curvatures.curvature(f), height));
  for(const double curvature : curvature_of_curves(surface, embedding))
    result.halfedge.push_back(chord_length(curvature, height));
  return result;
}

// Lowers the lengths at the vertices of each face, and at those of each constrained edge, to the chords there.
inline void bound_by_chords(const Cut_surface& surface, const Surface_embedding& embedding,
                            const Chord_lengths& chords, std::vector<double>& length)
{
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    double& at_target = length[embedding.vertex[h]];
    double& at_source = length[embedding.vertex[previous_of(h)]];
    at_target = (std::min)({ at_target, chords.face[face_of(h)], chords.halfedge[h] });
    at_source = (std::min)(at_source, chords.halfedge[h]);
  }
}

// Lowers the lengths beside gaps and in them to a part of the gaps.
inline void bound_by_gaps(const Cut_surface& surface, const Surface_embedding& embedding, const int edges_across_gap,
                          std::vector<double>& length)
{
  if(edges_across_gap == 0 || length.empty())
    return;
  const double longest = *std::max_element(length.begin(), length.end());
  Gap_rays(surface, embedding).for_each_gap(edges_across_gap * longest, longest, [&](const int v, const double gap)
  {
    length[v] = (std::min)(length[v], gap / edges_across_gap);
  });
}

// Lowers the lengths until they grow along every edge by no more than the logarithm of the gradation times its length.
// With as many edges on a line as the integral of one over the length, the ratio of consecutive ones is then not above
// the gradation. Takes O(n log n) time.
inline void bound_by_gradation(const Cut_surface& surface, const Surface_embedding& embedding, const double gradation,
                               std::vector<double>& length)
{
  if(std::isinf(gradation))
    return;
  const double slope = std::log(gradation);
  std::vector<int> first(length.size() + 1, 0), neighbor;
  std::vector<double> distance;
  const auto for_each_edge = [&](const auto& visit)
  {
    for(int h = 0; h < surface.number_of_halfedges(); ++h)
      if(embedding.twin[h] < 0 || h < embedding.twin[h])
      {
        visit(embedding.vertex[h], embedding.vertex[previous_of(h)], surface.length[h]);
        visit(embedding.vertex[previous_of(h)], embedding.vertex[h], surface.length[h]);
      }
  };
  for_each_edge([&](const int v, int, double) { ++first[v + 1]; });
  for(std::size_t v = 0; v < length.size(); ++v)
    first[v + 1] += first[v];
  neighbor.resize(first.back());
  distance.resize(first.back());
  std::vector<int> next = first;
  for_each_edge([&](const int v, const int w, const double d)
  {
    neighbor[next[v]] = w;
    distance[next[v]++] = d;
  });

  typedef std::pair<double, int> Entry; // length, vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
  for(std::size_t v = 0; v < length.size(); ++v)
    queue.push({ length[v], static_cast<int>(v) });
  while(!queue.empty())
  {
    const auto [least, v] = queue.top();
    queue.pop();
    if(least > length[v])
      continue;
    for(int i = first[v]; i < first[v + 1]; ++i)
      if(const double bound = least + slope * distance[i]; bound < length[neighbor[i]])
      {
        length[neighbor[i]] = bound;
        queue.push({ bound, neighbor[i] });
      }
  }
}

// Lowers the lengths wanted at the vertices as the bounds say. `bounds` and `chords` are in the unit of
// `Cut_surface::length`, as all lengths here.
inline void bound_sizes(const Cut_surface& surface, const Surface_embedding& embedding, const Size_bounds& bounds,
                        const Chord_lengths& chords, std::vector<double>& length)
{
  const std::vector<double> wanted = length;
  bound_by_chords(surface, embedding, chords, length);
  bound_by_gaps(surface, embedding, bounds.edges_across_gap, length);
  for(std::size_t v = 0; v < length.size(); ++v)
    length[v] = (std::min)(wanted[v], (std::max)(length[v], bounds.minimum_edge_length));
  bound_by_gradation(surface, embedding, bounds.gradation, length);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_BOUND_SIZES_H
