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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MEASURE_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MEASURE_QUADS_H

#include <CGAL/Frame_fields/Quad_quality.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Polygons in flat arrays. A corner stands for the side of its polygon that leaves it as well.
struct Polygon_mesh
{
  std::vector<Coordinates> point;    // per vertex
  std::vector<int> first_corner;     // per face, and the number of corners at the end
  std::vector<int> vertex;           // per corner
  std::vector<int> face;             // per corner
  std::vector<int> opposite;         // per corner: that of the same edge in the other face, -1 at the border
  std::vector<char> is_constrained;  // per corner: whether its side is
  double length_unit = 1;            // of the points

  int number_of_faces() const { return static_cast<int>(first_corner.size()) - 1; }
  int number_of_corners() const { return static_cast<int>(vertex.size()); }
  int size(const int f) const { return first_corner[f + 1] - first_corner[f]; }
  int next(const int c) const { return c + 1 == first_corner[face[c] + 1] ? first_corner[face[c]] : c + 1; }
  int previous(const int c) const { return c == first_corner[face[c]] ? first_corner[face[c] + 1] - 1 : c - 1; }
  bool is_inner(const int c) const { return opposite[c] >= 0 && !is_constrained[c]; }

  // The corner at the same vertex in the face counter-clockwise from it; only where the side between them is inner.
  int counter_clockwise(const int c) const { return opposite[previous(c)]; }
};

inline double corner_angle(const Polygon_mesh& mesh, const int corner)
{
  const Coordinates& p = mesh.point[mesh.vertex[corner]];
  return angle_between(scaled_direction(p, mesh.point[mesh.vertex[mesh.next(corner)]]),
                       scaled_direction(p, mesh.point[mesh.vertex[mesh.previous(corner)]]));
}

// How many quads a sector between constrained edges should hold.
inline int quads_of_angle(const double angle)
{
  return (std::max)(1, static_cast<int>(std::round(2 * angle / CGAL_PI)));
}

// Counts the sectors at constrained edges whose number of corners does not fit their angle, and the vertices inside
// that do not have four corners.
inline void count_irregular(const Polygon_mesh& mesh, Quad_quality& quality)
{
  std::vector<char> is_counted(mesh.vertex.size(), false);
  const auto count_from = [&](const int first, double& angle)
  {
    int count = 0;
    for(int c = first; !is_counted[c]; c = mesh.counter_clockwise(c))
    {
      is_counted[c] = true;
      angle += corner_angle(mesh, c);
      ++count;
      if(!mesh.is_inner(mesh.previous(c)))
        break;
    }
    return count;
  };
  for(int c = 0; c < mesh.number_of_corners(); ++c)
    if(!mesh.is_inner(c) && !is_counted[c])
    {
      double angle = 0;
      const int count = count_from(c, angle);
      quality.number_of_irregular_sectors += count != quads_of_angle(angle);
    }
  for(int c = 0; c < mesh.number_of_corners(); ++c)
    if(!is_counted[c])
    {
      double angle = 0;
      quality.number_of_irregular_vertices += count_from(c, angle) != 4;
    }
}

inline void measure_edges(const Polygon_mesh& mesh, Quad_quality& quality)
{
  double least = std::numeric_limits<double>::infinity(), sum = 0, largest = 0;
  int count = 0;
  for(int c = 0; c < mesh.number_of_corners(); ++c)
    if(mesh.opposite[c] < c) // once for each edge
    {
      const double length = distance(mesh.point[mesh.vertex[c]], mesh.point[mesh.vertex[mesh.next(c)]]);
      least = (std::min)(least, length);
      largest = (std::max)(largest, length);
      sum += length;
      ++count;
    }
  if(count == 0)
    return;
  quality.minimum_edge_length = mesh.length_unit * least;
  quality.mean_edge_length = mesh.length_unit * (sum / count);
  quality.maximum_edge_length = mesh.length_unit * largest;
}

// The quality of the quads, in linear time. Lengths are in the caller's unit. A quad is bad below a scaled Jacobian of
// 0.2; faces that are no quads are counted, but not measured.
inline Quad_quality measure_quads(const Polygon_mesh& mesh)
{
  const double bad = 0.2;
  Quad_quality quality;
  double sum = 0;
  for(int f = 0; f < mesh.number_of_faces(); ++f)
  {
    if(mesh.size(f) != 4)
    {
      ++quality.number_of_other_faces;
      continue;
    }
    const int* const v = &mesh.vertex[mesh.first_corner[f]];
    const double jacobian =
      quad_shape({ mesh.point[v[0]], mesh.point[v[1]], mesh.point[v[2]], mesh.point[v[3]] }).scaled_jacobian;
    ++quality.number_of_quads;
    sum += jacobian;
    quality.minimum_scaled_jacobian = (std::min)(quality.minimum_scaled_jacobian, jacobian);
    quality.number_of_inverted_quads += jacobian <= 0;
    quality.number_of_bad_quads += jacobian < bad;
  }
  if(quality.number_of_quads > 0)
    quality.mean_scaled_jacobian = sum / static_cast<double>(quality.number_of_quads);
  count_irregular(mesh, quality);
  measure_edges(mesh, quality);
  return quality;
}

// Sets `opposite` from `vertex`, in O(n log n). The sides of an edge have no opposite if it has more than two faces, or
// two that run the same way.
inline void connect_sides(Polygon_mesh& mesh)
{
  const std::size_t number_of_corners = mesh.vertex.size();
  std::vector<int> first(mesh.point.size() + 1, 0), side(number_of_corners);
  const auto smaller_end = [&](const int c) { return (std::min)(mesh.vertex[c], mesh.vertex[mesh.next(c)]); };
  const auto larger_end = [&](const int c) { return (std::max)(mesh.vertex[c], mesh.vertex[mesh.next(c)]); };
  for(int c = 0; c < mesh.number_of_corners(); ++c)
    ++first[smaller_end(c) + 1];
  for(std::size_t v = 0; v < mesh.point.size(); ++v)
    first[v + 1] += first[v];
  std::vector<int> next = first;
  for(int c = 0; c < mesh.number_of_corners(); ++c)
    side[next[smaller_end(c)]++] = c;

  mesh.opposite.assign(number_of_corners, -1);
  for(std::size_t v = 0; v < mesh.point.size(); ++v)
  {
    const auto begin = side.begin() + first[v], end = side.begin() + first[v + 1];
    std::sort(begin, end, [&](const int c, const int d)
              { return larger_end(c) < larger_end(d) || (larger_end(c) == larger_end(d) && c < d); });
    for(auto i = begin, j = begin; i != end; i = j)
    {
      while(j != end && larger_end(*j) == larger_end(*i))
        ++j;
      if(j - i == 2 && mesh.vertex[i[0]] != mesh.vertex[i[1]])
      {
        mesh.opposite[i[0]] = i[1];
        mesh.opposite[i[1]] = i[0];
      }
    }
  }
}

// The quads in space. Sides between patches count as constrained, and those that `is_on_arc` names (four per quad; it
// may be empty), as both quads of a side on an arc can be of one patch.
inline Polygon_mesh polygon_mesh(const Quad_complex& complex, const std::vector<Coordinates>& points,
                                 const std::vector<char>& is_on_arc = {})
{
  Polygon_mesh mesh;
  mesh.point = points;
  for(std::size_t q = 0; q < complex.quads.size(); ++q)
  {
    mesh.first_corner.push_back(static_cast<int>(4 * q));
    mesh.vertex.insert(mesh.vertex.end(), complex.quads[q].begin(), complex.quads[q].end());
    mesh.face.insert(mesh.face.end(), 4, static_cast<int>(q));
  }
  mesh.first_corner.push_back(static_cast<int>(mesh.vertex.size()));
  connect_sides(mesh);
  mesh.is_constrained = is_on_arc;
  mesh.is_constrained.resize(mesh.vertex.size(), false);
  for(int c = 0; c < mesh.number_of_corners(); ++c)
    if(mesh.opposite[c] >= 0 && complex.patch[c / 4] != complex.patch[mesh.opposite[c] / 4])
      mesh.is_constrained[c] = true;
  return mesh;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MEASURE_QUADS_H
