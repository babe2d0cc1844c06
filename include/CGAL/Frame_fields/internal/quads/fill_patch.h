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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_FILL_PATCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_FILL_PATCH_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Patch_remesher.h>
#include <CGAL/Frame_fields/internal/quads/Patch_triangulation.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/quads/triangulate_patch.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A patch without certified map is filled with quads as long as each of its arcs has an even number of edges: its
// triangles are joined to quads where that goes well, and each polygon is cut into quads from its middle to the middles
// of its sides.

// The least number of edges of an arc at a filling: 4 on a closed arc, 2 on another one. With fewer, an edge of the
// triangulation, which stands for two edges of quads, would join a vertex to itself.
inline int smallest_even_count(const Surface_embedding& embedding, const Feature_arc& arc)
{
  const bool is_closed = arc.is_loop || embedding.vertex[previous_of(arc.halfedges.front())]
                                          == embedding.vertex[arc.halfedges.back()];
  return is_closed ? 4 : 2;
}

// Flags, per halfedge, the edges between two triangles that become one quad. The best quads are taken first, in
// O(n log n).
inline std::vector<char> joined_sides(const Patch_triangulation& t)
{
  const double least_jacobian = 0.3;
  std::vector<std::pair<double, int> > candidates;
  for(int h = 0; h < t.number_of_halfedges(); ++h)
    if(t.has(h) && t.opposite[h] > h && !t.would_be_loop(t.apex(h), t.apex(t.opposite[h])))
    {
      const double jacobian = quad_shape({ t.point(t.source(h)), t.point(t.apex(t.opposite[h])), t.point(t.target[h]),
                                           t.point(t.apex(h)) }).scaled_jacobian;
      if(jacobian > least_jacobian)
        candidates.emplace_back( -jacobian, h );
    }
  std::sort(candidates.begin(), candidates.end());
  std::vector<char> is_joined(t.target.size(), false), is_taken(t.is_alive.size(), false);
  for(const auto& candidate : candidates)
  {
    const int h = candidate.second, other = t.opposite[h];
    if(is_taken[face_of(h)] || is_taken[face_of(other)])
      continue;
    is_taken[face_of(h)] = is_taken[face_of(other)] = true;
    is_joined[h] = is_joined[other] = true;
  }
  return is_joined;
}

// Cuts the triangles of a patch, some of them joined to quads, from their middles to the middles of their sides.
class Midpoint_subdivision
{
public:
  Midpoint_subdivision(const Surface_walker& walker, const Patch_triangulation& triangulation,
                       const std::vector<char>& is_joined, const int patch, Quad_complex& complex)
    : m_walker(walker), m_triangulation(triangulation), m_is_joined(is_joined), m_patch(patch), m_complex(complex)
    , m_id(triangulation.vertices.size(), -1), m_middle(triangulation.target.size(), -1)
  {}

  // `middle_of_segment(s)` is the vertex of the quads in the middle of segment s of the border.
  template <typename MiddleOfSegment>
  void run(const MiddleOfSegment& middle_of_segment)
  {
    const Patch_triangulation& t = m_triangulation;
    for(std::size_t v = 0; v < t.vertices.size(); ++v)
      if(t.corner[v] >= 0)
        m_id[v] = t.vertices[v].id >= 0 ? t.vertices[v].id : add(t.vertices[v].location, t.vertices[v].mesh_vertex);
    for(int h = 0; h < t.number_of_halfedges(); ++h)
      if(t.has(h) && !m_is_joined[h] && t.opposite[h] < h)
      {
        m_middle[h] = t.opposite[h] < 0 ? middle_of_segment(t.segment[h]) : add_near({ t.source(h), t.target[h] });
        if(t.opposite[h] >= 0)
          m_middle[t.opposite[h]] = m_middle[h];
      }
    for(int f = 0; f < t.number_of_faces(); ++f)
      if(t.is_alive[f])
        add_polygon(f);
  }

private:
  int add(const Surface_location& location, const int mesh_vertex)
  {
    Quad_vertex v;
    v.location = location;
    v.vertex = mesh_vertex;
    v.patch = m_patch;
    m_complex.vertices.push_back(v);
    return static_cast<int>(m_complex.vertices.size()) - 1;
  }

  int add_near(const std::vector<int>& vertices)
  {
    return add(location_amid(m_walker, m_triangulation, vertices), -1);
  }

  void add_polygon(const int face)
  {
    const Patch_triangulation& t = m_triangulation;
    std::vector<int> sides; // counter-clockwise
    for(int h = 3 * face; h < 3 * face + 3; ++h)
    {
      const int other = t.opposite[h];
      if(!m_is_joined[h])
        sides.push_back(h);
      else if(other < h)
        return; // the other face adds both
      else
        sides.insert(sides.end(), { next_of(other), previous_of(other) });
    }
    std::vector<int> vertices;
    for(const int h : sides)
      vertices.push_back(t.source(h));
    const int middle = add_near(vertices);
    for(std::size_t k = 0; k < sides.size(); ++k)
    {
      const int previous = sides[(k + sides.size() - 1) % sides.size()];
      m_complex.quads.push_back({ m_id[vertices[k]], m_middle[sides[k]], middle, m_middle[previous] });
      m_complex.patch.push_back(m_patch);
    }
  }

  const Surface_walker& m_walker;
  const Patch_triangulation& m_triangulation;
  const std::vector<char>& m_is_joined; // per halfedge
  int m_patch;
  Quad_complex& m_complex;
  std::vector<int> m_id;     // per vertex of the triangulation: its vertex of the quads
  std::vector<int> m_middle; // per halfedge: the vertex of the quads in its middle
};

// Whether all arcs of a patch have even numbers of edges of at least `smallest_even_count()`.
inline bool can_fill_patch(const Cut_surface& surface, const Surface_embedding& embedding,
                           const Feature_network& network, const Patch& patch, const Arc_vertices& arc_vertices)
{
  for(int h = 3 * patch.faces.begin_index; h < 3 * patch.faces.end_index; ++h)
    if(surface.is_constrained(h))
    {
      const int arc = network.arc[h], count = number_of_edges(arc_vertices, network, arc);
      if(count % 2 != 0 || count < smallest_even_count(embedding, network.arcs[arc]))
        return false;
    }
  return true;
}

// Fills a patch with quads of about the given edge length. The vertices on its arcs are in the complex already; those
// inside are added. Nothing is added, and false returned, if an arc has an odd number of edges or fewer than
// `smallest_even_count()`, or if the triangulation cannot be made to have one edge for each two of an arc.
inline bool fill_patch(const Surface_walker& walker, const Cut_surface& surface, const Surface_embedding& embedding,
                       const Feature_network& network, const int patch, const Arc_vertices& arc_vertices,
                       const double edge_length, Quad_complex& complex)
{
  if(!can_fill_patch(surface, embedding, network, surface.patches[patch], arc_vertices))
    return false;
  Border_cutter cutter(walker, surface, embedding, network, surface.patches[patch], arc_vertices, complex);
  Patch_triangulation triangulation = cutter.run();
  const double length_of_triangles = 2 * std::sqrt(2 / std::sqrt(3.)); // two equilateral ones have the area of 4 quads
  if(!Patch_remesher(walker, length_of_triangles * edge_length, triangulation).run())
    return false;
  Midpoint_subdivision(walker, triangulation, joined_sides(triangulation), patch, complex)
    .run([&](const int segment) { return cutter.middle_of_segment(segment); });
  return true;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_FILL_PATCH_H
