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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_PATCH_ASSEMBLY_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_PATCH_ASSEMBLY_H

#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/Cell_chart.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/quads/Vertex_classes.h>
#include <CGAL/Frame_fields/internal/quads/make_arc_vertices.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Makes the vertices and quads of one patch from the cells of its T-mesh.
class Patch_assembly
{
public:
  // `arcs` are those along the patch. The unknown of piece p is `first_unknown` plus p. Where pieces have no edges,
  // vertices are joined in `classes`.
  Patch_assembly(const Quad_layout& layout, const Placed_arcs& placed_arcs, const int patch,
                 const std::vector<int>& arcs, const int first_unknown, Quad_complex& complex, Vertex_classes& classes)
    : m_layout(layout), m_t_mesh(layout.t_meshes[patch]), m_edges(layout.edges_of_piece[patch]), m_patch(patch)
    , m_first_unknown(first_unknown), m_complex(complex), m_classes(classes)
    , m_vertex_of_node(m_t_mesh.nodes.size(), -1), m_vertices_of_piece(m_t_mesh.pieces.size())
  {
    for(const int a : arcs)
      for(int s = 0; s < 2; ++s)
        if(layout.sides[a][s].patch == patch)
          give_vertices(layout.sides[a][s], placed_arcs, a, s);
    for(std::size_t n = 0; n < m_t_mesh.nodes.size(); ++n)
      if(m_vertex_of_node[n] < 0)
        m_vertex_of_node[n] = add_vertex(location_of_node(m_t_mesh.nodes[n]));
  }

  // Makes a grid of quads in a cell. If two opposite sides have no edges, joins the vertices of the other two instead.
  void fill_cell(const T_mesh_cell& cell)
  {
    const Cell_chart chart(m_layout.surface, m_layout.map, m_t_mesh, cell);
    std::array<double, 2> size{ { 0, 0 } };
    for(int s = 0; s < 2; ++s)
      for(const Directed_piece& directed : cell.sides[s])
        size[s] += static_cast<double>(m_t_mesh.pieces[directed.piece].parametric_length);
    const double width = size[0], height = size[1];
    place_pieces(cell.sides[0], { { 0, 0 } }, { { 1, 0 } }, chart);
    place_pieces(cell.sides[1], { { width, 0 } }, { { 0, 1 } }, chart);
    place_pieces(cell.sides[2], { { width, height } }, { { -1, 0 } }, chart);
    place_pieces(cell.sides[3], { { 0, height } }, { { 0, -1 } }, chart);

    const Side bottom = collect_side(cell.sides[0]), right = collect_side(cell.sides[1]);
    Side top = collect_side(cell.sides[2]), left = collect_side(cell.sides[3]);
    for(Side* const side : { &top, &left })
    {
      std::reverse(side->vertices.begin(), side->vertices.end());
      std::reverse(side->offset.begin(), side->offset.end());
      const double whole = side->offset.front();
      for(double& offset : side->offset)
        offset = whole - offset;
    }
    if(bottom.vertices.size() == 1)
      join(left, right, widest_piece(cell.sides[0]));
    else if(left.vertices.size() == 1)
      join(bottom, top, widest_piece(cell.sides[1]));
    else
      make_grid(bottom, right, top, left, chart);
  }

  // The vertex at a node of the T-mesh.
  int vertex_of_node(const int node) const { return m_vertex_of_node[node]; }

private:
  // A side of a cell: its vertices from corner to corner, and how far each is from the first in the map.
  struct Side
  {
    std::vector<int> vertices;
    std::vector<double> offset;
  };

  int add_vertex(const Surface_location& location)
  {
    Quad_vertex vertex;
    vertex.location = location;
    vertex.patch = m_patch;
    m_complex.vertices.push_back(vertex);
    return static_cast<int>(m_complex.vertices.size()) - 1;
  }

  Surface_location location_of_node(const T_mesh_node& node) const
  {
    if(node.sector >= 0)
      return location_on_halfedge(m_layout.surface.first_corner[node.sector], 1);
    const int first = 3 * node.face;
    std::array<Plane_point, 3> corners;
    for(int k = 0; k < 3; ++k)
      corners[k] = { static_cast<double>(m_layout.map.u[first + k] - node.u),
                     static_cast<double>(m_layout.map.v[first + k] - node.v) };
    Surface_location location;
    location.face = node.face;
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      location.barycentric[k] =
        (std::max)(0., orientation(corners[(k + 1) % 3], corners[(k + 2) % 3], Plane_point{ { 0, 0 } }));
      sum += location.barycentric[k];
    }
    for(double& weight : location.barycentric)
      weight = sum > 0 ? weight / sum : 1. / 3;
    return location;
  }

  // Gives the pieces of a side of an arc the vertices of the arc.
  void give_vertices(const Arc_side& side, const Placed_arcs& placed_arcs, const int arc, const int number_of_side)
  {
    const std::vector<int>& vertices = m_complex.arcs[arc];
    const bool is_loop = m_layout.network.arcs[arc].is_loop;
    const int n = static_cast<int>(vertices.size());
    // The second side runs against the arc: it begins where its unrolled list ends.
    int place = number_of_side == 0 ? 0 : n - 1;
    if(is_loop)
      place += placed_arcs.points[arc].first_of_side[number_of_side];
    const int step = number_of_side == 0 ? 1 : -1;
    for(const int p : side.pieces)
    {
      std::vector<int>& of_piece = m_vertices_of_piece[p];
      for(int i = 0; i <= m_edges[p]; ++i)
        of_piece.push_back(vertices[((place + step * i) % n + n) % n]);
      place += step * m_edges[p];
      m_vertex_of_node[m_t_mesh.pieces[p].source] = of_piece.front();
      m_vertex_of_node[m_t_mesh.pieces[p].target] = of_piece.back();
    }
  }

  // Places the vertices of the inner pieces of a side that no cell has placed yet. `origin` and `direction` are those
  // of the side in the plane of the cell.
  void place_pieces(const std::vector<Directed_piece>& side, const Plane_point& origin, const Plane_point& direction,
                    Cell_chart chart)
  {
    double begin = 0;
    for(const Directed_piece& directed : side)
    {
      const T_mesh_piece& piece = m_t_mesh.pieces[directed.piece];
      std::vector<int>& vertices = m_vertices_of_piece[directed.piece];
      const double length = static_cast<double>(piece.parametric_length);
      if(vertices.empty())
      {
        const int n = m_edges[directed.piece];
        vertices.push_back(m_vertex_of_node[piece.source]);
        std::vector<int> inner;
        for(int i = 1; i < n; ++i)
        {
          const double t = begin + length * i / n;
          inner.push_back(
            add_vertex(chart.locate({ origin[0] + t * direction[0], origin[1] + t * direction[1] })));
        }
        if(directed.is_reversed)
          std::reverse(inner.begin(), inner.end());
        vertices.insert(vertices.end(), inner.begin(), inner.end());
        if(n > 0)
          vertices.push_back(m_vertex_of_node[piece.target]);
        else
          m_classes.unite(vertices.front(), m_vertex_of_node[piece.target], m_first_unknown + directed.piece);
      }
      begin += length;
    }
  }

  // The vertices of a side, which are spread evenly over each of its pieces.
  Side collect_side(const std::vector<Directed_piece>& side) const
  {
    Side result;
    double begin = 0;
    for(const Directed_piece& directed : side)
    {
      std::vector<int> vertices = m_vertices_of_piece[directed.piece];
      if(directed.is_reversed)
        std::reverse(vertices.begin(), vertices.end());
      const double length = static_cast<double>(m_t_mesh.pieces[directed.piece].parametric_length);
      const int n = static_cast<int>(vertices.size()) - 1;
      for(int i = 0; i < n; ++i)
      {
        result.vertices.push_back(vertices[i]);
        result.offset.push_back(begin + length * i / n);
      }
      begin += length;
      if(&directed == &side.back())
      {
        result.vertices.push_back(vertices[n]);
        result.offset.push_back(begin);
      }
    }
    return result;
  }

  // The unknown of the piece of a side that is longest in space.
  int widest_piece(const std::vector<Directed_piece>& side) const
  {
    int widest = side.front().piece;
    for(const Directed_piece& directed : side)
      if(m_t_mesh.pieces[directed.piece].length > m_t_mesh.pieces[widest].length)
        widest = directed.piece;
    return m_first_unknown + widest;
  }

  // Joins the opposite sides of a cell that has no edges between them.
  void join(const Side& first, const Side& second, const int unknown)
  {
    for(std::size_t i = 0; i < first.vertices.size(); ++i)
      m_classes.unite(first.vertices[i], second.vertices[i], unknown);
  }

  // The inner vertices are where the straight lines between opposite vertices of the sides cross, so that the quads are
  // convex in the map.
  void make_grid(const Side& bottom, const Side& right, const Side& top, const Side& left, Cell_chart chart)
  {
    const int columns = static_cast<int>(bottom.vertices.size()) - 1, rows = static_cast<int>(left.vertices.size()) - 1;
    std::vector<int> below = bottom.vertices;
    for(int j = 1; j <= rows; ++j)
    {
      std::vector<int> above;
      if(j == rows)
        above = top.vertices;
      else
      {
        above.push_back(left.vertices[j]);
        for(int i = 1; i < columns; ++i)
          above.push_back(add_vertex(chart.locate(crossing(bottom, right, top, left, i, j))));
        above.push_back(right.vertices[j]);
      }
      for(int i = 0; i < columns; ++i)
      {
        m_complex.quads.push_back({ below[i], below[i + 1], above[i + 1], above[i] });
        m_complex.patch.push_back(m_patch);
      }
      below.swap(above);
    }
  }

  // Where the line between the vertices i of bottom and top crosses the line between the vertices j of left and right.
  static Plane_point crossing(const Side& bottom, const Side& right, const Side& top, const Side& left, const int i,
                              const int j)
  {
    const double width = bottom.offset.back(), height = left.offset.back();
    const double x = bottom.offset[i], dx = (top.offset[i] - x) / height;
    const double y = left.offset[j], dy = (right.offset[j] - y) / width;
    // px = x + dx py, py = y + dy px
    const double px = (x + dx * y) / (1 - dx * dy);
    return { px, y + dy * px };
  }

  const Quad_layout& m_layout;
  const T_mesh& m_t_mesh;
  const std::vector<int>& m_edges; // per piece
  int m_patch, m_first_unknown;
  Quad_complex& m_complex;
  Vertex_classes& m_classes;
  std::vector<int> m_vertex_of_node;
  std::vector<std::vector<int> > m_vertices_of_piece; // from source to target
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_PATCH_ASSEMBLY_H
