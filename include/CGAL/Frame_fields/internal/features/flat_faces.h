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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FLAT_FACES_H
#define CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FLAT_FACES_H

#include <CGAL/Frame_fields/internal/features/feature_graph.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The faces of a mesh whose features are looked for, as numbers of their vertices and edges. Edge k of a face runs from
// its vertex k to the next one.
struct Feature_faces
{
  std::vector<std::array<int, 3> > vertices, edges;

  int size() const { return static_cast<int>(vertices.size()); }
};

// How far off the coordinates of a face may be, in units of the mesh.
class Coordinate_error
{
public:
  // If no error is given, it is at least the largest extent of the mesh over 2^24, as in files that hold `float`. If
  // all coordinates are such numbers, it is also at least the rounding error of a `float` of their size, otherwise that
  // of a `double`.
  Coordinate_error(const Feature_graph& graph, const Feature_faces& faces, const std::optional<double>& given)
    : m_least(given.value_or(0))
  {
    if(given)
      return;
    const double float_rounding = 0x1p-24;
    double half_size = 0;
    bool are_floats = true;
    for(int i = 0; i < 3; ++i)
    {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for(const std::array<int, 3>& vertices : faces.vertices)
        for(const int v : vertices)
        {
          const double x = graph.points[v][i];
          low = (std::min)(low, x);
          high = (std::max)(high, x);
          are_floats = are_floats && is_float(x);
        }
      half_size = (std::max)(half_size, high / 2 - low / 2);
    }
    m_least = 2 * float_rounding * half_size;
    if(are_floats)
      m_relative = float_rounding;
  }

  // The error of the coordinates of a face with these vertices.
  double operator()(const Coordinates& p, const Coordinates& q, const Coordinates& r) const
  {
    const double largest = (std::max)({ maximum_norm(p), maximum_norm(q), maximum_norm(r) });
    return largest > 0 ? (std::max)(m_least, std::scalbn(m_relative, std::ilogb(largest))) : m_least;
  }

private:
  static bool is_float(const double x)
  {
    return std::abs(x) <= (std::numeric_limits<float>::max)() && static_cast<double>(static_cast<float>(x)) == x;
  }

  double m_least, m_relative = 0x1p-53; // m_relative of a power of two is half of the distance to the next number
};

// The height of a triangle over its longest side; 0 if it has no area.
inline double smallest_height(const Coordinates& p, const Coordinates& q, const Coordinates& r)
{
  const double pq = distance(p, q), qr = distance(q, r), rp = distance(r, p);
  // The ends of the longest side first, the apex last.
  const std::array<const Coordinates*, 3> order =
    pq >= qr && pq >= rp ? std::array<const Coordinates*, 3>{ &p, &q, &r }
    : qr >= rp           ? std::array<const Coordinates*, 3>{ &q, &r, &p }
                         : std::array<const Coordinates*, 3>{ &r, &p, &q };
  const Coordinates base = scaled_direction(*order[0], *order[1]), side = scaled_direction(*order[0], *order[2]);
  if(maximum_norm(base) == 0 || maximum_norm(side) == 0)
    return 0;
  return distance(*order[0], *order[2]) * (length(cross(base, side)) / (length(base) * length(side)));
}

// The height up to which a face has no normal of its own, in units of the error of a coordinate. If the errors are
// evenly distributed, the apex of a face is off its plane by a standard deviation of 0.7 of them, which turns the
// normal of a face of this height by 9 degrees. With a larger height, faces of real models that have a normal lose it;
// with a smaller one, needles beside a fine hole become features.
constexpr double flat_height_in_errors = 4.5;

// A vector along the normal of a triangle, zero if it has no area.
inline Coordinates normal(const Coordinates& p, const Coordinates& q, const Coordinates& r)
{
  return cross(scaled_direction(p, q), scaled_direction(q, r));
}

// Finds the faces that are too flat to have a normal of their own, and gives each the normal of a face that it lies
// along. The graph, the faces and the error must outlive it.
class Flat_faces
{
public:
  Flat_faces(const Feature_graph& graph, const Feature_faces& faces, const Coordinate_error& coordinate_error)
    : m_graph(graph), m_faces(faces), m_error(coordinate_error), m_normal_face(faces.size(), -1)
    , m_faces_at(graph.ends.size(), { -1, -1 })
  {}

  // For each face, the face whose normal it takes. Normals spread from the other faces to the flat ones, always across
  // the longest edge to which they have come, and only across edges that the flat face lies along. A face that is not
  // reached keeps its own normal. Must be called only once. Takes O(n log n) time.
  std::vector<int> faces_with_normals()
  {
    for(int f = 0; f < m_faces.size(); ++f)
      if(height(f) > flat_height(f))
        m_normal_face[f] = f;
    if(std::find(m_normal_face.begin(), m_normal_face.end(), -1) == m_normal_face.end())
      return m_normal_face;

    for(int f = 0; f < m_faces.size(); ++f)
      for(const int e : m_faces.edges[f])
        m_faces_at[e][m_faces_at[e][0] >= 0] = f;
    for(int f = 0; f < m_faces.size(); ++f)
      if(m_normal_face[f] == f)
        advance(f);
    while(!m_front.empty())
    {
      const auto [length, edge, from] = m_front.top();
      m_front.pop();
      for(const int f : m_faces_at[edge])
        if(f >= 0 && m_normal_face[f] < 0)
        {
          m_normal_face[f] = m_normal_face[from];
          advance(f);
        }
    }
    for(int f = 0; f < m_faces.size(); ++f)
      if(m_normal_face[f] < 0)
        m_normal_face[f] = f;
    return m_normal_face;
  }

private:
  const Coordinates& point(const int face, const int k) const { return m_graph.points[m_faces.vertices[face][k]]; }

  double height(const int f) const { return smallest_height(point(f, 0), point(f, 1), point(f, 2)); }

  double flat_height(const int f) const
  {
    return flat_height_in_errors * m_error(point(f, 0), point(f, 1), point(f, 2));
  }

  // Whether the height of a face over one of its edges is at most the flat height.
  bool lies_along(const int f, const int edge) const
  {
    const std::array<int, 3>& e = m_faces.edges[f];
    const double longest = (std::max)({ m_graph.length[e[0]], m_graph.length[e[1]], m_graph.length[e[2]] });
    return height(f) * longest <= flat_height(f) * m_graph.length[edge];
  }

  // Enters the edges of a face with a normal across which a flat face can take it.
  void advance(const int from)
  {
    for(const int e : m_faces.edges[from])
      for(const int f : m_faces_at[e])
        if(f >= 0 && m_normal_face[f] < 0 && lies_along(f, e))
          m_front.push({ m_graph.length[e], e, from });
  }

  const Feature_graph& m_graph;
  const Feature_faces& m_faces;
  const Coordinate_error& m_error;
  std::vector<int> m_normal_face;
  std::vector<std::array<int, 2> > m_faces_at; // per edge, -1 for none
  std::priority_queue<std::tuple<double, int, int> > m_front; // length, edge, the face that it was reached from
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FLAT_FACES_H
