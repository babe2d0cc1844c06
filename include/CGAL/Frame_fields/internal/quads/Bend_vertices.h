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
    for(const std::vector<Bend>& bends : m_bends)
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

  // Chooses on the arcs that have a vertex near each bend.
  void choose_where_clear()
  {
    const double near = 0.3;
    choose([&](const Placement& placement) { return placement.distance < near ? Choice::NEW : Choice::OPEN; });
  }

  // Chooses on all arcs: the same vertices as before unless one of these is far from its bend. So opposite sides of a
  // row of quads that slid along together do not choose vertices of different rows.
  void choose_everywhere()
  {
    const double far = 0.7;
    choose([&](const Placement& placement) { return placement.old_distance < far ? Choice::OLD : Choice::NEW; });
  }

private:
  enum class Choice { OPEN, OLD, NEW };

  struct Bend
  {
    int place;      // in the arc
    int old_vertex; // among the inner vertices of the arc
  };

  // Where the vertices of an arc are, and where its bends are among them.
  struct Placement
  {
    std::vector<int> vertices;         // the inner ones
    std::vector<double> points, goals; // the lengths of vertices and bends
    std::vector<int> chosen;           // per goal: a vertex
    double distance = 0;               // the largest one of a bend from the vertex chosen for it, over the edges there
    double old_distance = 0;           // the same from the vertex that it had
  };

  // The vertices of an arc without the nodes at its ends, in order.
  std::vector<int> inner_vertices(const int arc) const
  {
    const std::vector<int>& vertices = m_complex.arcs[arc];
    if(m_complex.is_loop[arc])
      return vertices;
    return vertices.size() <= 2 ? std::vector<int>() : std::vector<int>(vertices.begin() + 1, vertices.end() - 1);
  }

  void release(const int arc)
  {
    const std::vector<int> vertices = inner_vertices(arc);
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      Quad_vertex& v = m_complex.vertices[vertices[i]];
      if(v.vertex < 0)
        continue;
      m_bends[arc].push_back({ static_cast<int>(std::lround(v.position)), static_cast<int>(i) });
      v.vertex = -1;
    }
    std::sort(m_bends[arc].begin(), m_bends[arc].end(),
              [](const Bend& a, const Bend& b) { return a.place < b.place; });
  }

  template <typename Choose>
  void choose(const Choose& choice_of)
  {
    for(std::size_t arc = 0; arc < m_bends.size(); ++arc)
    {
      if(m_bends[arc].empty())
        continue;
      const Placement placement = placement_on(static_cast<int>(arc));
      const Choice choice = choice_of(placement);
      if(choice == Choice::OLD)
        for(const int v : placement.vertices)
          m_complex.vertices[v] = m_old_vertices[v];
      else if(choice == Choice::NEW)
        move_to_bends(static_cast<int>(arc), placement);
      if(choice != Choice::OPEN)
        m_bends[arc].clear();
    }
  }

  Placement placement_on(const int arc) const
  {
    const std::vector<Bend>& bends = m_bends[arc];
    const bool is_loop = m_complex.is_loop[arc];
    const double whole = m_arc_points.length(arc);
    Placement result;
    result.vertices = inner_vertices(arc);
    for(const int v : result.vertices)
      result.points.push_back(m_arc_points.length_at(arc, m_complex.vertices[v].position));
    if(is_loop)
      result.points = unrolled_loop(result.points, true, whole);
    std::vector<int> places;
    for(const Bend& bend : bends)
      places.push_back(bend.place);
    int first = 0; // the bend that is the first goal
    result.goals = lengths_of_breakpoints(m_arc_points, arc, is_loop, places, result.points, first);
    const std::vector<double> wanted = places_among_points(result.points, result.goals, is_loop, whole);
    const int n = static_cast<int>(result.points.size()), m = static_cast<int>(bends.size());
    result.chosen = points_near_places(wanted, n);
    for(int g = 0; g < m; ++g)
    {
      const double old_distance = bends[(first + g) % m].old_vertex - wanted[g];
      const double turns = is_loop ? std::round(old_distance / n) : 0;
      result.distance = (std::max)(result.distance, std::abs(result.chosen[g] - wanted[g]));
      result.old_distance = (std::max)(result.old_distance, std::abs(old_distance - turns * n));
    }
    return result;
  }

  void move_to_bends(const int arc, const Placement& placement)
  {
    const double rounding = 1e-9, whole = m_arc_points.length(arc);
    std::vector<double> points(placement.points);
    move_to_goals(placement.chosen, placement.goals, m_complex.is_loop[arc], whole, points);
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      Quad_vertex& v = m_complex.vertices[placement.vertices[i]];
      v.position = m_arc_points.position_at(arc, points[i] - std::floor(points[i] / whole) * whole);
      v.location = m_arc_points.location(arc, v.position);
    }
    for(const int i : placement.chosen)
    {
      Quad_vertex& v = m_complex.vertices[placement.vertices[i]];
      if(std::abs(v.position - std::round(v.position)) > rounding)
        continue;
      const int place = static_cast<int>(std::lround(v.position)) % m_arc_points.number_of_edges(arc);
      v.position = place;
      v.location = m_arc_points.location(arc, place);
      v.vertex = m_embedding.vertex[previous_of(m_network.arcs[arc].halfedges[place])];
    }
  }

  Quad_complex& m_complex;
  const Surface_embedding& m_embedding;
  const Feature_network& m_network;
  Arc_points m_arc_points;
  std::vector<Quad_vertex> m_old_vertices;
  std::vector<std::vector<Bend> > m_bends; // per arc: those whose choice is open, by their places
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_BEND_VERTICES_H
