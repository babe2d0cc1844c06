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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_WRITE_QUAD_MESH_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_WRITE_QUAD_MESH_H

#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/quad_connectivity.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The elements that a quad complex became.
template <typename QuadMesh>
struct Written_quads
{
  std::vector<typename boost::graph_traits<QuadMesh>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<QuadMesh>::halfedge_descriptor> sides; // per side of a quad
  std::vector<typename boost::graph_traits<QuadMesh>::face_descriptor> faces;
};

// Makes room for elements, so that no later allocation fails, if the mesh has a function `reserve()`.
template <typename Mesh>
auto reserve_elements(Mesh& mesh, const std::size_t vertices, const std::size_t edges, const std::size_t faces, int)
  -> decltype(reserve(mesh, vertices, edges, faces))
{
  return reserve(mesh, num_vertices(mesh) + vertices, num_edges(mesh) + edges, num_faces(mesh) + faces);
}
template <typename Mesh>
void reserve_elements(Mesh&, std::size_t, std::size_t, std::size_t, long) {}

// The border sides of one fan of quads that begin and end at a vertex.
struct Border_passage
{
  int vertex, side, side_before;
  bool operator<(const Border_passage& other) const
  {
    return vertex != other.vertex ? vertex < other.vertex : side < other.side;
  }
};

// The passages at all border vertices, sorted by their vertices.
inline std::vector<Border_passage> border_passages(const Quad_complex& complex, const Quad_connectivity& connectivity)
{
  std::vector<Border_passage> passages;
  for(int side = 0; side < static_cast<int>(connectivity.opposite.size()); ++side)
  {
    if(connectivity.opposite[side] >= 0)
      continue;
    int before = previous_side(side);
    while(connectivity.opposite[before] >= 0)
      before = previous_side(connectivity.opposite[before]);
    passages.push_back({ side_source(complex, side), side, before });
  }
  std::sort(passages.begin(), passages.end());
  return passages;
}

// Links the halfedges outside. At a vertex where several fans of quads meet, the border goes on from each fan to the
// next one, so that the halfedges around the vertex are one cycle. The vertex has a border halfedge, as some meshes
// expect.
template <typename QuadMesh>
void link_borders(const std::vector<Border_passage>& passages, const Written_quads<QuadMesh>& written,
                  QuadMesh& quad_mesh)
{
  for(std::size_t begin = 0, end; begin < passages.size(); begin = end)
  {
    for(end = begin + 1; end < passages.size() && passages[end].vertex == passages[begin].vertex; ++end) {}
    for(std::size_t i = begin; i < end; ++i)
    {
      const auto outside = opposite(written.sides[passages[i].side], quad_mesh);
      const std::size_t next_fan = i + 1 < end ? i + 1 : begin;
      set_next(outside, opposite(written.sides[passages[next_fan].side_before], quad_mesh), quad_mesh);
      set_halfedge(written.vertices[passages[i].vertex], outside, quad_mesh);
    }
  }
}

// Adds the quads to a mesh in O(n log n); `connectivity` must be without conflicts. Points are not set.
template <typename QuadMesh>
Written_quads<QuadMesh> write_quads(const Quad_complex& complex, const Quad_connectivity& connectivity,
                                    QuadMesh& quad_mesh)
{
  typedef boost::graph_traits<QuadMesh> Traits;
  typedef typename Traits::halfedge_descriptor Halfedge;

  const int number_of_sides = static_cast<int>(connectivity.opposite.size());
  std::size_t number_of_edges = 0;
  for(int side = 0; side < number_of_sides; ++side)
    number_of_edges += connectivity.opposite[side] < side;
  const std::vector<Border_passage> passages = border_passages(complex, connectivity);
  Written_quads<QuadMesh> written;
  written.vertices.reserve(complex.vertices.size());
  written.faces.reserve(complex.quads.size());
  written.sides.resize(number_of_sides);
  reserve_elements(quad_mesh, complex.vertices.size(), number_of_edges, complex.quads.size(), 0);

  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    written.vertices.push_back(add_vertex(quad_mesh));
  for(std::size_t q = 0; q < complex.quads.size(); ++q)
    written.faces.push_back(add_face(quad_mesh));
  for(int side = 0; side < number_of_sides; ++side)
  {
    const int other = connectivity.opposite[side];
    if(other >= side)
      continue; // is made with its opposite
    const Halfedge h = halfedge(add_edge(quad_mesh), quad_mesh);
    written.sides[side] = h;
    if(other >= 0)
      written.sides[other] = opposite(h, quad_mesh);
    set_target(h, written.vertices[side_target(complex, side)], quad_mesh);
    set_target(opposite(h, quad_mesh), written.vertices[side_source(complex, side)], quad_mesh);
    if(other < 0)
      set_face(opposite(h, quad_mesh), Traits::null_face(), quad_mesh);
  }
  for(int side = 0; side < number_of_sides; ++side)
  {
    const Halfedge h = written.sides[side];
    set_face(h, written.faces[side / 4], quad_mesh);
    set_next(h, written.sides[next_side(side)], quad_mesh);
    set_halfedge(written.vertices[side_target(complex, side)], h, quad_mesh);
    if(side % 4 == 0)
      set_halfedge(written.faces[side / 4], h, quad_mesh);
  }
  link_borders(passages, written, quad_mesh);
  return written;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_WRITE_QUAD_MESH_H
