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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_BEND_VERTICES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_BEND_VERTICES_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Arc_points.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Sliding_quads.h>
#include <CGAL/Frame_fields/internal/quads/join_arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/move_to_breakpoints.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Lets the vertices that are kept at bends of arcs slide past these, and chooses vertices for the bends anew by where
// they have come to be.
class Bend_vertices
{
public:
  // `complex` must outlive the object and changes with it.
  Bend_vertices(Quad_complex& complex, const Surface_embedding& embedding, const Feature_network& network)
    : m_complex(complex), m_embedding(embedding), m_network(network), m_arc_points(embedding, network)
    , m_old_vertices(complex.vertices), m_bends(complex.arcs.size())
  {
    for(std::size_t arc = 0; arc < complex.arcs.size(); ++arc)
      if(!complex.has_free_bends[arc])
        release(static_cast<int>(arc));
  }

  std::size_t number_of_bends() const
  {
    std::size_t result = 0;
    for(const std::vector<int>& bends : m_bends)
      result += bends.size();
    return result;
  }

  // The arcs where the choice is open.
  std::vector<int> open_arcs() const
  {
    std::vector<int> result;
    for(std::size_t arc = 0; arc < m_bends.size(); ++arc)
      if(!m_bends[arc].empty())
        result.push_back(static_cast<int>(arc));
    return result;
  }

  // Chooses on the arcs that have a vertex near each bend. `quads` must be of the complex.
  void choose_where_clear(Sliding_quads& quads)
  {
    const double near = 0.3;
    for(const int arc : open_arcs())
    {
      const Placement placement = placement_on(arc);
      if(placement.distance < near)
      {
        move(quads, placement.vertices, positions_at_bends(arc, placement));
        keep_at_bends(arc, placement);
      }
    }
  }

  // Chooses on all arcs: the same vertices as before, or the nearest ones if the quads at the arc are less distorted
  // then. As these show what has been chosen on the other side of a row of quads, both sides choose alike.
  void choose_everywhere(Sliding_quads& quads)
  {
    for(const int arc : open_arcs())
    {
      const Placement placement = placement_on(arc);
      std::vector<double> old_positions;
      for(const int v : placement.vertices)
        old_positions.push_back(m_old_vertices[v].position);
      const double old_distortion = move(quads, placement.vertices, old_positions);
      if(move(quads, placement.vertices, positions_at_bends(arc, placement)) < old_distortion)
      {
        keep_at_bends(arc, placement);
        continue;
      }
      move(quads, placement.vertices, old_positions);
      for(const int v : placement.vertices)
        m_complex.vertices[v] = m_old_vertices[v];
      m_bends[arc].clear();
    }
  }

private:
  // Where the vertices of an arc are, and where its bends are among them.
  struct Placement
  {
    std::vector<int> vertices;         // the inner ones
    std::vector<double> points, goals; // the lengths of vertices and bends
    std::vector<int> chosen;           // per goal: a vertex
    double distance = 0;               // the largest one of a bend from the vertex chosen for it, over the edges there
  };

  // The vertices of an arc without the nodes at its ends, in order.
  std::vector<int> inner_vertices(const int arc) const
  {
    std::vector<int> result;
    for(const int v : m_complex.arcs[arc])
      if(m_complex.vertices[v].arc == arc)
        result.push_back(v);
    return result;
  }

  void release(const int arc)
  {
    for(const int vertex : inner_vertices(arc))
    {
      Quad_vertex& v = m_complex.vertices[vertex];
      if(v.vertex < 0)
        continue;
      m_bends[arc].push_back(static_cast<int>(std::lround(v.position)));
      v.vertex = -1;
    }
    std::sort(m_bends[arc].begin(), m_bends[arc].end());
  }

  Placement placement_on(const int arc) const
  {
    const bool is_loop = m_complex.is_loop[arc];
    const double whole = m_arc_points.length(arc);
    Placement result;
    result.vertices = inner_vertices(arc);
    for(const int v : result.vertices)
      result.points.push_back(m_arc_points.length_at(arc, m_complex.vertices[v].position));
    if(is_loop)
      result.points = unrolled_loop(result.points, true, whole);
    result.goals = lengths_of_breakpoints(m_arc_points, arc, is_loop, m_bends[arc], result.points);
    const std::vector<double> wanted = places_among_points(result.points, result.goals, is_loop, whole);
    result.chosen = points_near_places(wanted, static_cast<int>(result.points.size()));
    for(std::size_t g = 0; g < wanted.size(); ++g)
      result.distance = (std::max)(result.distance, std::abs(result.chosen[g] - wanted[g]));
    return result;
  }

  // The positions of the vertices when those that are chosen are at the bends.
  std::vector<double> positions_at_bends(const int arc, const Placement& placement) const
  {
    const double rounding = 1e-9, whole = m_arc_points.length(arc);
    std::vector<double> result(placement.points);
    move_to_goals(placement.chosen, placement.goals, m_complex.is_loop[arc], whole, result);
    for(double& position : result)
      position = m_arc_points.position_at(arc, position - std::floor(position / whole) * whole);
    for(const int i : placement.chosen)
      if(std::abs(result[i] - std::round(result[i])) < rounding)
        result[i] = std::fmod(std::round(result[i]), m_arc_points.number_of_edges(arc));
    return result;
  }

  // Moves vertices of an arc to the positions. Returns the distortion of their quads.
  double move(Sliding_quads& quads, const std::vector<int>& vertices, const std::vector<double>& positions) const
  {
    const double largest_distortion = 1e4; // of a quad
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      const int arc = m_complex.vertices[vertices[i]].arc;
      Slide slide;
      slide.location = m_arc_points.location(arc, positions[i]);
      slide.length = m_arc_points.length_at(arc, positions[i]);
      slide.point = quads.walker().point(slide.location);
      quads.move(vertices[i], slide);
    }
    double result = 0;
    for(const int v : vertices)
      for(const int* c = quads.corners_begin(v); c != quads.corners_end(v); ++c)
        result += (std::min)(largest_distortion, quads.shape(*c / 4).distortion);
    return result;
  }

  void keep_at_bends(const int arc, const Placement& placement)
  {
    const std::vector<int>& halfedges = m_network.arcs[arc].halfedges;
    for(const int i : placement.chosen)
    {
      Quad_vertex& v = m_complex.vertices[placement.vertices[i]];
      const double place = std::fmod(std::round(v.position), static_cast<double>(halfedges.size()));
      v.position = place;
      v.location = m_arc_points.location(arc, place);
      v.vertex = m_embedding.vertex[previous_of(halfedges[static_cast<std::size_t>(place)])];
    }
    m_bends[arc].clear();
  }

  Quad_complex& m_complex;
  const Surface_embedding& m_embedding;
  const Feature_network& m_network;
  Arc_points m_arc_points;
  std::vector<Quad_vertex> m_old_vertices;
  std::vector<std::vector<int> > m_bends; // per arc: the places of those whose choice is open, in order
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_BEND_VERTICES_H
