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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_ASSEMBLE_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_ASSEMBLE_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Cell_chart.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Vertex_classes.h>
#include <CGAL/Frame_fields/internal/quads/place_arc_points.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where the quads of a patch come from: its T-mesh, triangles of their size, or each triangle of the mesh.
enum class Patch_source { T_MESH, FILLING, SPLIT_TRIANGLES };

// What the stages before the assembly have found: one T-mesh per patch, without cells where the patch has no certified
// map, and the number of quad edges of each piece and arc.
struct Quad_layout
{
  const Cut_surface& surface;
  const Surface_embedding& embedding;
  const Feature_network& network;
  const Seamless_map& map;
  const std::vector<T_mesh>& t_meshes;
  const std::vector<Patch_source>& sources; // per patch
  const Arc_sides& sides;
  const std::vector<std::vector<int> >& edges_of_piece; // per patch
  const std::vector<int>& edges_of_arc;
  const std::vector<std::vector<int> >& breakpoints; // per arc: places where it must have a vertex
};

// The vertices that patches share, made once.
struct Placed_arcs
{
  std::vector<int> of_node;               // per vertex of the triangle mesh, -1 if it is no node
  std::vector<Placed_arc> points;         // per arc
};

inline Surface_location location_on_halfedge(const int halfedge, const double fraction)
{
  Surface_location location;
  location.face = face_of(halfedge);
  location.barycentric = { 0, 0, 0 };
  location.barycentric[halfedge % 3] = fraction;
  location.barycentric[previous_of(halfedge) % 3] = 1 - fraction;
  return location;
}

// Whether a patch beside an arc is made of split triangles.
inline bool is_beside_split_patch(const Arc_sides& sides, const std::vector<Patch_source>& sources, const int arc)
{
  return std::any_of(sides[arc].begin(), sides[arc].end(), [&](const Arc_side& side)
                     { return side.patch >= 0 && sources[side.patch] == Patch_source::SPLIT_TRIANGLES; });
}

inline Placed_arc place_points(const Quad_layout& layout, const int arc)
{
  const Feature_arc& feature_arc = layout.network.arcs[arc];
  const Arc_polyline polyline(layout.surface, feature_arc);
  std::array<std::vector<double>, 2> points;
  for(int s = 0; s < 2; ++s)
  {
    const Arc_side& side = layout.sides[arc][s];
    if(side.pieces.empty())
      continue;
    points[s] = arc_points_of_side(layout.surface, layout.map, layout.network, polyline, layout.t_meshes[side.patch],
                                   side, layout.edges_of_piece[side.patch]);
    points[s] = feature_arc.is_loop ? unrolled_loop(points[s], s == 0, polyline.length())
                                    : inner_points(points[s], s == 0);
  }
  const std::vector<double> fixed = is_beside_split_patch(layout.sides, layout.sources, arc)
                                  ? points_of_triangles(polyline, feature_arc) : std::vector<double>();
  if(points[0].empty() && points[1].empty() && fixed.empty())
    points[0] = evenly_spaced_points(polyline.length(), layout.edges_of_arc[arc], feature_arc.is_loop);
  Placed_arc placed = join_sides(points, fixed, feature_arc.is_loop, polyline.length());
  if(fixed.empty())
    move_to_breakpoints(polyline, layout.breakpoints[arc], feature_arc.is_loop, placed.length);
  return placed;
}

// A vertex at a breakpoint of its arc stays there.
inline void keep_at_breakpoint(const Quad_layout& layout, const int arc, Quad_vertex& vertex)
{
  const double rounding = 1e-9;
  const std::vector<int>& halfedges = layout.network.arcs[arc].halfedges;
  const double nearest = std::round(vertex.position);
  const int place = static_cast<int>(nearest) % static_cast<int>(halfedges.size());
  if(std::abs(vertex.position - nearest) > rounding
     || !std::binary_search(layout.breakpoints[arc].begin(), layout.breakpoints[arc].end(), place))
    return;
  vertex.position = place;
  vertex.location = location_on_halfedge(halfedges[place], 0);
  vertex.vertex = layout.embedding.vertex[previous_of(halfedges[place])];
}

inline Placed_arcs make_arc_vertices(const Quad_layout& layout, Quad_complex& complex)
{
  Placed_arcs result;
  result.of_node.assign(layout.embedding.point.size(), -1);
  for(int h = 0; h < layout.surface.number_of_halfedges(); ++h)
  {
    const int v = layout.embedding.vertex[h];
    if(!layout.network.is_node[v] || result.of_node[v] >= 0)
      continue;
    result.of_node[v] = static_cast<int>(complex.vertices.size());
    Quad_vertex vertex;
    vertex.location = location_on_halfedge(h, 1);
    vertex.vertex = v;
    complex.vertices.push_back(vertex);
  }

  for(std::size_t a = 0; a < layout.network.arcs.size(); ++a)
  {
    const Feature_arc& arc = layout.network.arcs[a];
    const Arc_polyline polyline(layout.surface, arc);
    result.points.push_back(place_points(layout, static_cast<int>(a)));
    complex.arcs.emplace_back();
    complex.is_loop.push_back(arc.is_loop);
    if(!arc.is_loop)
      complex.arcs.back().push_back(
        result.of_node[layout.embedding.vertex[previous_of(arc.halfedges.front())]]);
    for(const double length : result.points.back().length)
    {
      Quad_vertex vertex;
      vertex.arc = static_cast<int>(a);
      // The points of a loop may begin before its first place, and end behind its last one.
      const double whole = polyline.length();
      vertex.position = polyline.position_at(length - std::floor(length / whole) * whole);
      const int place = (std::min)(static_cast<int>(vertex.position), static_cast<int>(arc.halfedges.size()) - 1);
      vertex.location = location_on_halfedge(arc.halfedges[place], vertex.position - place);
      keep_at_breakpoint(layout, static_cast<int>(a), vertex);
      complex.arcs.back().push_back(static_cast<int>(complex.vertices.size()));
      complex.vertices.push_back(vertex);
    }
    if(!arc.is_loop)
      complex.arcs.back().push_back(result.of_node[layout.embedding.vertex[arc.halfedges.back()]]);
  }
  return result;
}

// Makes the vertices and quads of one patch from the cells of its T-mesh.
class Patch_assembly
{
public:
  // The unknown of piece p is `first_unknown` plus p. Where pieces have no edges, vertices are joined in `classes`.
  Patch_assembly(const Quad_layout& layout, const Placed_arcs& placed_arcs, const int patch, const int first_unknown,
                 Quad_complex& complex, Vertex_classes& classes)
    : m_layout(layout), m_t_mesh(layout.t_meshes[patch]), m_edges(layout.edges_of_piece[patch]), m_patch(patch)
    , m_first_unknown(first_unknown), m_complex(complex), m_classes(classes)
    , m_vertex_of_node(m_t_mesh.nodes.size(), -1), m_vertices_of_piece(m_t_mesh.pieces.size())
  {
    for(std::size_t a = 0; a < layout.network.arcs.size(); ++a)
      for(int s = 0; s < 2; ++s)
        if(layout.sides[a][s].patch == patch)
          give_vertices(layout.sides[a][s], placed_arcs, static_cast<int>(a), s);
    for(std::size_t n = 0; n < m_t_mesh.nodes.size(); ++n)
      if(m_vertex_of_node[n] < 0)
        m_vertex_of_node[n] = add_vertex(location_of_node(m_t_mesh.nodes[n]));
  }

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

  // The vertices of a side and their even distribution over each piece.
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

  // Of the line between the vertices i of bottom and top with that between the vertices j of left and right.
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

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_ASSEMBLE_H
