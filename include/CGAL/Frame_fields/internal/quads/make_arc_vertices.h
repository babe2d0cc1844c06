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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_ARC_VERTICES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_ARC_VERTICES_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/arc_breakpoints.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/Arc_points.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/quads/arc_points_of_side.h>
#include <CGAL/Frame_fields/internal/quads/join_arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/move_to_breakpoints.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The vertices that patches share, made once.
struct Placed_arcs
{
  std::vector<int> of_node;               // per vertex of the triangle mesh, -1 if it is no node
  std::vector<Placed_arc> points;         // per arc
};

// Two points per edge of the triangle mesh: those of a patch whose triangles are split.
inline std::vector<double> points_of_triangles(const Arc_points& arc_points, const int arc, const bool is_loop)
{
  std::vector<double> result;
  for(int place = 0; place < arc_points.number_of_edges(arc); ++place)
    for(const double fraction : { 0., 0.5 })
      if(is_loop || place > 0 || fraction > 0)
        result.push_back(arc_points.length_at(arc, place, fraction));
  return result;
}

inline std::vector<double> evenly_spaced_points(const double length, const int number_of_edges, const bool is_loop)
{
  std::vector<double> points;
  for(int i = is_loop ? 0 : 1; i < number_of_edges; ++i)
    points.push_back(length * i / number_of_edges);
  return points;
}

// Whether a point has moved past the place where a neighbor of it was. On a loop the last point is beside the first.
inline bool has_passed_neighbor(const std::vector<double>& before, const std::vector<double>& after, const bool is_loop,
                                const double length)
{
  const std::size_t n = before.size();
  for(std::size_t i = 0; i < n; ++i)
  {
    const double previous = i > 0 ? before[i - 1] : is_loop ? before[n - 1] - length : 0;
    const double next = i + 1 < n ? before[i + 1] : is_loop ? before[0] + length : length;
    if(after[i] < previous || after[i] > next)
      return true;
  }
  return false;
}

// How far an arc is from the straight lines between successive points on it.
inline double deviation_of_points(const Arc_points& arc_points, const int arc, const bool is_loop,
                                  const std::vector<double>& points)
{
  const double length = arc_points.length(arc);
  const auto point_at = [&](const double l)
  {
    return arc_points.point(arc, arc_points.position_at(arc, is_loop ? l - std::floor(l / length) * length : l));
  };
  double result = 0;
  for(std::size_t i = is_loop ? 1 : 0; i <= points.size(); ++i)
  {
    const double begin = i > 0 ? points[i - 1] : 0;
    const double end = i < points.size() ? points[i] : is_loop ? points[0] + length : length;
    result = (std::max)(result, arc_points.deviation(arc, begin, end, point_at(begin), point_at(end)));
  }
  return result;
}

// Moves the points to the breakpoints of an arc. On a smooth curve that is divided unevenly, these may be dense where
// the points are not. Then points would go far along the arc, and the quads beside it would be slanted. So there are
// fewer breakpoints then, those of a larger tolerance, if the points stay as near to the arc with these.
inline void follow_bends(const Quad_layout& layout, const Arc_points& arc_points, const int arc, Placed_arc& placed)
{
  const bool is_loop = layout.network.arcs[arc].is_loop;
  const double length = arc_points.length(arc);
  const std::vector<double> old_points(placed.length);
  move_to_breakpoints(arc_points, arc, is_loop, layout.breakpoints[arc], placed.length);
  if(!has_passed_neighbor(old_points, placed.length, is_loop, length))
    return;
  const Feature_arc& feature_arc = layout.network.arcs[arc];
  std::vector<int> source_vertices;
  for(const int h : feature_arc.halfedges)
    source_vertices.push_back(layout.embedding.vertex[previous_of(h)]);
  for(double tolerance = 2 * layout.arc_tolerance[arc]; tolerance > 0 && tolerance < length; tolerance *= 2)
  {
    std::vector<double> moved = old_points;
    move_to_breakpoints(arc_points, arc, is_loop,
                        arc_breakpoints(layout.embedding, feature_arc, source_vertices, tolerance), moved);
    if(!has_passed_neighbor(old_points, moved, is_loop, length)
       && deviation_of_points(arc_points, arc, is_loop, moved) <= layout.arc_tolerance[arc])
    {
      placed.length.swap(moved);
      placed.has_free_bends = true;
      return;
    }
  }
}

inline Placed_arc place_arc_points(const Quad_layout& layout, const Arc_points& arc_points, const int arc)
{
  const bool is_loop = layout.network.arcs[arc].is_loop;
  const double whole = arc_points.length(arc);
  std::array<std::vector<double>, 2> points;
  for(int s = 0; s < 2; ++s)
  {
    const Arc_side& side = layout.sides[arc][s];
    if(side.pieces.empty())
      continue;
    points[s] = arc_points_of_side(layout.surface, layout.map, layout.network, arc_points, layout.t_meshes[side.patch],
                                   side, layout.edges_of_piece[side.patch]);
    points[s] = is_loop ? unrolled_loop(points[s], s == 0, whole) : inner_points(points[s], s == 0);
  }
  const std::vector<double> fixed = is_beside_split_patch(layout.sides, layout.sources, arc)
                                  ? points_of_triangles(arc_points, arc, is_loop) : std::vector<double>();
  if(points[0].empty() && points[1].empty() && fixed.empty())
    points[0] = evenly_spaced_points(whole, layout.edges_of_arc[arc], is_loop);
  Placed_arc placed = join_sides(points, fixed, is_loop, whole);
  if(fixed.empty())
    follow_bends(layout, arc_points, arc, placed);
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

// Makes a vertex for each node of the feature network.
inline std::vector<int> make_node_vertices(const Quad_layout& layout, Quad_complex& complex)
{
  std::vector<int> result(layout.embedding.point.size(), -1);
  for(int h = 0; h < layout.surface.number_of_halfedges(); ++h)
  {
    const int v = layout.embedding.vertex[h];
    if(!layout.network.is_node[v] || result[v] >= 0)
      continue;
    result[v] = static_cast<int>(complex.vertices.size());
    Quad_vertex vertex;
    vertex.location = location_on_halfedge(h, 1);
    vertex.vertex = v;
    complex.vertices.push_back(vertex);
  }
  return result;
}

// The vertex of an arc at a length from its beginning. On a loop the length may lie beyond its ends by whole turns.
inline Quad_vertex arc_vertex(const Quad_layout& layout, const Arc_points& arc_points, const int arc,
                              const double length)
{
  const double whole = arc_points.length(arc);
  Quad_vertex vertex;
  vertex.arc = arc;
  vertex.position = arc_points.position_at(arc, length - std::floor(length / whole) * whole);
  vertex.location = arc_points.location(arc, vertex.position);
  keep_at_breakpoint(layout, arc, vertex);
  return vertex;
}

// Makes the vertices at nodes and on arcs; `complex` must be empty.
inline Placed_arcs make_arc_vertices(const Quad_layout& layout, Quad_complex& complex)
{
  const Arc_points arc_points(layout.embedding, layout.network);
  Placed_arcs result;
  result.of_node = make_node_vertices(layout, complex);
  for(int a = 0; a < static_cast<int>(layout.network.arcs.size()); ++a)
  {
    const Feature_arc& arc = layout.network.arcs[a];
    result.points.push_back(place_arc_points(layout, arc_points, a));
    complex.arcs.emplace_back();
    std::vector<int>& vertices = complex.arcs.back();
    complex.is_loop.push_back(arc.is_loop);
    complex.has_free_bends.push_back(result.points.back().has_free_bends);
    if(!arc.is_loop)
      vertices.push_back(result.of_node[layout.embedding.vertex[previous_of(arc.halfedges.front())]]);
    for(const double length : result.points.back().length)
    {
      vertices.push_back(static_cast<int>(complex.vertices.size()));
      complex.vertices.push_back(arc_vertex(layout, arc_points, a, length));
    }
    if(!arc.is_loop)
      vertices.push_back(result.of_node[layout.embedding.vertex[arc.halfedges.back()]]);
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_ARC_VERTICES_H
