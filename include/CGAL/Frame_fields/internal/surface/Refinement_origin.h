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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_REFINEMENT_ORIGIN_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_REFINEMENT_ORIGIN_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where the elements of a mesh come from that is refined by splitting edges and faces and by flipping edges in planes.
// The unrefined mesh is called the original here. Each face has a seed, a location in the original. From there a
// straight walk leads to every point of the face: the seed is in the face, or in a face of which it is a part, and such
// a face is in one plane. A vertex also stores up to three vertices of the original between which it lies, with their
// weights, so that locations are exact where nothing is flipped.
class Refinement_origin
{
public:
  typedef std::array<double, 3> Weights;

  // Starts with the numbers of elements of the original. Before this call nothing is noted.
  void start(const int number_of_vertices, const int number_of_edges, const int number_of_faces)
  {
    m_vertices.resize(number_of_vertices);
    for(int v = 0; v < number_of_vertices; ++v)
      m_vertices[v] = { { v, -1, -1 }, { 1, 0, 0 } };
    m_edges.resize(number_of_edges);
    std::iota(m_edges.begin(), m_edges.end(), 0);
    for(int f = 0; f < number_of_faces; ++f)
      m_seeds.push_back({ f, { 1. / 3, 1. / 3, 1. / 3 } });
  }

  // Must be called before the first flip. The walker is one on the original; it must outlive this object.
  void walk_by(const Surface_walker& walker) { m_walker = &walker; }

  // Notes a new vertex between up to three vertices of the same face, -1 for none, with their weights, of sum 1.
  void add_vertex(const int vertex, const std::array<int, 3>& ends, const Weights& weights)
  {
    if(m_vertices.empty())
      return;
    Vertex_origin origin;
    bool is_known = true;
    for(int i = 0; i < 3; ++i)
      if(ends[i] >= 0)
      {
        is_known = is_known && m_vertices[ends[i]].vertex[0] >= 0;
        for(int k = 0; k < 3; ++k)
          is_known = is_known && add(m_vertices[ends[i]].vertex[k], weights[i] * m_vertices[ends[i]].weight[k], origin);
      }
    if(static_cast<std::size_t>(vertex) >= m_vertices.size())
      m_vertices.resize(vertex + 1);
    m_vertices[vertex] = is_known ? origin : Vertex_origin();
  }

  // Notes an edge that is a part of another one; does nothing if it is the same.
  void add_edge(const int edge, const int other)
  {
    if(m_edges.empty() || edge == other)
      return;
    if(static_cast<std::size_t>(edge) >= m_edges.size())
      m_edges.resize(edge + 1, -1);
    m_edges[edge] = m_edges[other];
  }

  // Notes a face that is split off another one; does nothing if it is the same.
  void add_face(const int face, const int other)
  {
    if(m_seeds.empty() || face == other)
      return;
    if(static_cast<std::size_t>(face) >= m_seeds.size())
      m_seeds.resize(face + 1);
    m_seeds[face] = m_seeds[other];
  }

  // Notes that the common edge of two faces was flipped. `middle_of_edge` is its midpoint before the flip, the others
  // are centroids of the new faces, all in the unit of the walker. The seeds walk there by way of the old midpoint,
  // which keeps them in the plane of the faces.
  void flip(const int face, const int other, const Coordinates& middle_of_edge, const Coordinates& middle_of_face,
            const Coordinates& middle_of_other)
  {
    if(m_seeds.empty())
      return;
    std::array<Surface_location, 2> starts{ m_seeds[face], m_seeds[other] };
    for(Surface_location& start : starts)
      start = walked(start, middle_of_edge);
    m_seeds[face] = nearest_walk(starts, middle_of_face);
    m_seeds[other] = nearest_walk(starts, middle_of_other);
  }

  // The face of the original that holds the seed of a face.
  int face(const int f) const { return m_seeds[f].face; }

  // The edge of the original that an edge is a part of, -1 for an edge inside a face. Of no use for unconstrained
  // edges, since flips and splits of these are not noted here.
  int edge(const int e) const { return static_cast<std::size_t>(e) < m_edges.size() ? m_edges[e] : -1; }

  // The location in the original of a point of face f, given by the weights of the vertices of the face and by its
  // coordinates. `embedding` is that of the original. Takes constant time unless it must walk.
  Surface_location location(const Surface_embedding& embedding, const int f, const std::array<int, 3>& vertices,
                            const Weights& weights, const Coordinates& point) const
  {
    Surface_location result;
    result.face = m_seeds[f].face;
    result.barycentric = { 0, 0, 0 };
    for(int i = 0; i < 3; ++i)
      if(weights[i] != 0 && !add_weights(embedding, m_vertices[vertices[i]], weights[i], result))
        return walked(m_seeds[f], point);
    return result;
  }

private:
  // The vertices of the original between which a vertex lies; all are -1 if these would be more than three.
  struct Vertex_origin
  {
    std::array<int, 3> vertex = { -1, -1, -1 }; // -1 for none
    Weights weight = { 0, 0, 0 };
  };

  // Adds a weight of a vertex, if it is not -1. Returns false if the origin has three other vertices already.
  static bool add(const int vertex, const double weight, Vertex_origin& origin)
  {
    for(int k = 0; k < 3 && vertex >= 0; ++k)
      if(origin.vertex[k] < 0 || origin.vertex[k] == vertex)
      {
        origin.vertex[k] = vertex;
        origin.weight[k] += weight;
        return true;
      }
    return vertex < 0;
  }

  // Adds the weights of an origin to a location. Returns false if one of its vertices is not in the face of the
  // location.
  static bool add_weights(const Surface_embedding& embedding, const Vertex_origin& origin, const double weight,
                          Surface_location& location)
  {
    bool is_in_face = origin.vertex[0] >= 0;
    for(int k = 0; k < 3 && origin.vertex[k] >= 0; ++k)
    {
      const auto corners = embedding.vertex.begin() + 3 * static_cast<std::ptrdiff_t>(location.face);
      const auto corner = std::find(corners, corners + 3, origin.vertex[k]);
      if(corner == corners + 3)
        is_in_face = false;
      else
        location.barycentric[corner - corners] += weight * origin.weight[k];
    }
    return is_in_face;
  }

  Surface_location walked(Surface_location location, const Coordinates& goal) const
  {
    if(m_walker != nullptr)
      m_walker->walk(location, goal - m_walker->point(location));
    return location;
  }

  // The end nearest to the goal of two walks, since one of the faces may be too narrow to start in.
  Surface_location nearest_walk(const std::array<Surface_location, 2>& starts, const Coordinates& goal) const
  {
    const Surface_location first = walked(starts[0], goal), second = walked(starts[1], goal);
    return m_walker == nullptr || distance(m_walker->point(first), goal) <= distance(m_walker->point(second), goal)
             ? first : second;
  }

  std::vector<Vertex_origin> m_vertices; // per vertex
  std::vector<int> m_edges;              // per edge: the edge of the original, -1 for none
  std::vector<Surface_location> m_seeds; // per face
  const Surface_walker* m_walker = nullptr;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_REFINEMENT_ORIGIN_H
