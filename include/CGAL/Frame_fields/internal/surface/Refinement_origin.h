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

#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where the faces and vertices of a mesh come from that is refined by splitting edges and faces: each face is part of a
// face of the mesh as it was, each vertex is between at most three vertices of one of these.
class Refinement_origin
{
public:
  typedef std::array<double, 3> Weights;

  struct Vertex_origin
  {
    std::array<int, 3> vertex = { -1, -1, -1 }; // -1 without weight
    Weights weight = { 0, 0, 0 };
  };

  // Until it starts, nothing is noted.
  void start(const int number_of_vertices, const int number_of_faces)
  {
    m_vertices.resize(number_of_vertices);
    for(int v = 0; v < number_of_vertices; ++v)
      m_vertices[v] = { { v, -1, -1 }, { 1, 0, 0 } };
    for(int f = 0; f < number_of_faces; ++f)
      m_faces.push_back(f);
  }

  // Notes a new vertex between up to three of the same face, -1 for none.
  void add_vertex(const int vertex, const std::array<int, 3>& ends, const Weights& weights)
  {
    if(m_vertices.empty())
      return;
    Vertex_origin origin;
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 3 && ends[i] >= 0; ++k)
        add(m_vertices[ends[i]].vertex[k], weights[i] * m_vertices[ends[i]].weight[k], origin);
    if(static_cast<std::size_t>(vertex) >= m_vertices.size())
      m_vertices.resize(vertex + 1);
    m_vertices[vertex] = origin;
  }

  // Notes a face that is split off another one; nothing if it is the same.
  void add_face(const int face, const int other)
  {
    if(m_faces.empty() || face == other)
      return;
    if(static_cast<std::size_t>(face) >= m_faces.size())
      m_faces.resize(face + 1, -1);
    m_faces[face] = m_faces[other];
  }

  int face(const int f) const { return m_faces[f]; }
  const Vertex_origin& vertex(const int v) const { return m_vertices[v]; }

  // The value at a vertex of what is linear between the vertices of the mesh as it was.
  double interpolated(const std::vector<double>& values, const int v) const
  {
    double sum = 0;
    for(int k = 0; k < 3; ++k)
      if(m_vertices[v].vertex[k] >= 0)
        sum += m_vertices[v].weight[k] * values[m_vertices[v].vertex[k]];
    return sum;
  }

  // The location in the mesh as it was of a point of face f with the given vertices and weights.
  Surface_location location(const Surface_embedding& embedding, const int f, const std::array<int, 3>& vertices,
                            const Weights& weights) const
  {
    Surface_location result;
    result.face = m_faces[f];
    result.barycentric = { 0, 0, 0 };
    for(int i = 0; i < 3; ++i)
      for(int k = 0; k < 3; ++k)
        for(int corner = 0; corner < 3; ++corner)
          if(embedding.vertex[3 * result.face + corner] == m_vertices[vertices[i]].vertex[k])
            result.barycentric[corner] += weights[i] * m_vertices[vertices[i]].weight[k];
    return result;
  }

private:
  static void add(const int vertex, const double weight, Vertex_origin& origin)
  {
    for(int k = 0; k < 3 && vertex >= 0; ++k)
      if(origin.vertex[k] < 0 || origin.vertex[k] == vertex)
      {
        origin.vertex[k] = vertex;
        origin.weight[k] += weight;
        return;
      }
  }

  std::vector<Vertex_origin> m_vertices; // per vertex
  std::vector<int> m_faces;              // per face
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_REFINEMENT_ORIGIN_H
