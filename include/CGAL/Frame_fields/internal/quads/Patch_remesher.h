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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_PATCH_REMESHER_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_PATCH_REMESHER_H

#include <CGAL/Frame_fields/internal/quads/Patch_triangulation.h>
#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The location on the surface that is nearest to the mean of some vertices, of those where walks from each of them end.
// A walk may end too early, at a constrained edge.
inline Surface_location location_amid(const Surface_walker& walker, const Patch_triangulation& triangulation,
                                      const std::vector<int>& vertices)
{
  Coordinates sum{ 0, 0, 0 };
  for(const int v : vertices)
    sum = sum + triangulation.point(v);
  const Coordinates middle = 1. / static_cast<double>(vertices.size()) * sum;
  Surface_location best;
  double least_distance = std::numeric_limits<double>::infinity();
  for(const int v : vertices)
  {
    Surface_location location = triangulation.vertices[v].location;
    walker.walk_towards(location, middle);
    const double distance_to_middle = distance(walker.point(location), middle);
    if(distance_to_middle < least_distance || best.face < 0)
    {
      best = location;
      least_distance = distance_to_middle;
    }
  }
  return best;
}

// Changes the triangulation of a patch until each segment of its border has one halfedge, and edges inside have about
// the given length.
class Patch_remesher
{
public:
  Patch_remesher(const Surface_walker& walker, const double length, Patch_triangulation& triangulation)
    : m_walker(walker), m_length(length), m_triangulation(triangulation), m_mark(triangulation.vertices.size(), 0)
  {}

  // Returns whether each segment has one halfedge; only a segment that joins a vertex with itself cannot.
  bool run()
  {
    const int number_of_levels = 5, number_of_rounds = 4;
    for(int level = 1; level <= number_of_levels; ++level)
    {
      coarsen(std::scalbn(m_length, level - number_of_levels));
      flip_edges();
    }
    if(!finish_border())
      return false;
    for(int round = 0; round < number_of_rounds; ++round)
    {
      split_long_edges();
      coarsen(m_length);
      flip_edges();
      relocate();
    }
    split_flat_ears();
    relocate();
    relocate();
    return true;
  }

private:
  static constexpr double longest = 4. / 3, shortest = 4. / 5; // edges, over the length

  bool is_kept(const int vertex) const
  {
    const Patch_vertex& v = m_triangulation.vertices[vertex];
    return v.id >= 0 || v.mesh_vertex >= 0;
  }

  // The sum of the surface's normals at three vertices.
  Coordinates surface_normal(const int a, const int b, const int c) const
  {
    Coordinates sum{ 0, 0, 0 };
    for(const int v : { a, b, c })
      sum = sum + m_walker.normal(m_triangulation.vertices[v].location.face);
    return sum;
  }

  // Twice the area over the square of the longest side; negative if the normal of the triangle is more than about 73
  // degrees off that of the surface.
  double shape(const int a, const int b, const int c) const
  {
    const double least_cosine = 0.3;
    const Patch_triangulation& t = m_triangulation;
    const Coordinates n = t.normal(a, b, c), up = surface_normal(a, b, c);
    double largest = 0;
    for(const auto& side : { t.point(b) - t.point(a), t.point(c) - t.point(b), t.point(a) - t.point(c) })
      largest = (std::max)(largest, dot(side, side));
    const double norm = length(n);
    if(!(largest > 0))
      return 0;
    return dot(n, up) >= least_cosine * norm * length(up) ? norm / largest : -norm / largest;
  }

  // The worst shape of the triangles at a vertex if `replacement` were in its place, without the triangles at the edge
  // of `halfedge` unless it is -1.
  double worst_shape(const int vertex, const int replacement, const int halfedge) const
  {
    const Patch_triangulation& t = m_triangulation;
    double worst = 1;
    t.for_each_corner_of(vertex, [&](const int c)
    {
      const bool vanishes = halfedge >= 0 && (face_of(c) == face_of(halfedge)
                                              || (t.opposite[halfedge] >= 0
                                                  && face_of(c) == face_of(t.opposite[halfedge])));
      if(!vanishes)
        worst = (std::min)(worst, shape(replacement, t.target[next_of(c)], t.source(c)));
    });
    return worst;
  }

  // Whether the two ends of an edge have no neighbours in common but the apexes of its faces, and whether no edge
  // becomes a loop.
  bool can_collapse(const int halfedge, const int removed)
  {
    const Patch_triangulation& t = m_triangulation;
    const int kept = t.other_end(halfedge, removed), number_of_faces = t.opposite[halfedge] < 0 ? 1 : 2;
    if(!t.can_vanish(halfedge) || t.would_be_loop(removed, kept))
      return false;
    m_mark.resize(t.vertices.size(), 0);
    ++m_round;
    t.for_each_edge_of(kept, [&](const int h) { m_mark[t.other_end(h, kept)] = m_round; });
    int number_in_common = 0, number_of_edges = 0;
    bool makes_loop = false;
    t.for_each_edge_of(removed, [&](const int h)
    {
      const int w = t.other_end(h, removed);
      number_in_common += w != kept && m_mark[w] == m_round;
      number_of_edges += w == kept;
      makes_loop |= w != kept && t.would_be_loop(kept, w);
    });
    return number_in_common == number_of_faces && number_of_edges == 1 && !makes_loop;
  }

  double longest_edge_after(const int halfedge, const int removed) const
  {
    const Patch_triangulation& t = m_triangulation;
    const int kept = t.other_end(halfedge, removed);
    double result = 0;
    t.for_each_edge_of(removed, [&](const int h)
                       { result = (std::max)(result, distance(t.point(kept), t.point(t.other_end(h, removed)))); });
    return result;
  }

  // Whether an edge may be collapsed into its other end: a vertex that is not kept may go along any edge if it is
  // inside, and along edges of the border if it is on the border.
  bool may_be_removed(const int halfedge, const int vertex) const
  {
    const Patch_triangulation& t = m_triangulation;
    return !is_kept(vertex) && (t.opposite[halfedge] < 0 || !t.is_on_border(vertex));
  }

  bool collapse_if_good(const int halfedge, const int removed)
  {
    const double good_shape = 0.3; // an equilateral triangle has 0.87
    const bool is_border = m_triangulation.opposite[halfedge] < 0;
    if(!may_be_removed(halfedge, removed) || !can_collapse(halfedge, removed)
       || (!is_border && longest_edge_after(halfedge, removed) > longest * m_length))
      return false;
    const int kept = m_triangulation.other_end(halfedge, removed);
    const double new_shape = worst_shape(removed, kept, halfedge);
    if(!(new_shape > 0 && (new_shape >= good_shape || new_shape >= worst_shape(removed, removed, -1))))
      return false;
    m_triangulation.collapse(halfedge, removed);
    return true;
  }

  // Collapses edges where that is good: of the border below the length `level`, inside below 4/5 of it.
  void coarsen(const double level)
  {
    Patch_triangulation& t = m_triangulation;
    for(int h = 0; h < t.number_of_halfedges(); ++h)
    {
      if(!t.has(h) || t.opposite[h] > h)
        continue;
      const double bound = t.opposite[h] < 0 ? level : shortest * level;
      if(t.edge_length(h) < bound && !collapse_if_good(h, t.target[h]))
        collapse_if_good(h, t.source(h));
    }
  }

  void flip_edges()
  {
    const int number_of_passes = 3;
    Patch_triangulation& t = m_triangulation;
    for(int pass = 0; pass < number_of_passes; ++pass)
      for(int h = 0; h < t.number_of_halfedges(); ++h)
        if(t.has(h) && t.opposite[h] > h && should_flip(h))
          t.flip(h);
  }

  bool should_flip(const int h) const
  {
    const Patch_triangulation& t = m_triangulation;
    const int a = t.source(h), b = t.target[h], c = t.apex(h), d = t.apex(t.opposite[h]);
    if(t.would_be_loop(c, d) || t.would_be_loop(a, b) || t.number_of_edges_between(c, d) > 0
       || t.number_of_edges_between(a, b) != 1)
      return false;
    const double old_shape = (std::min)(shape(a, b, c), shape(b, a, d));
    const double new_shape = (std::min)(shape(d, c, a), shape(c, d, b));
    return new_shape > 0 && new_shape > old_shape * (1 + 1e-9);
  }

  // A new vertex of the surface near the middle of an edge.
  int middle(const int halfedge)
  {
    Patch_triangulation& t = m_triangulation;
    const Surface_location location = location_amid(m_walker, t, { t.source(halfedge), t.target[halfedge] });
    return t.add_vertex(location, m_walker.point(location));
  }

  void split_long_edges()
  {
    Patch_triangulation& t = m_triangulation;
    const int number_of_halfedges = t.number_of_halfedges();
    for(int h = 0; h < number_of_halfedges; ++h)
      if(t.has(h) && t.opposite[h] > h && t.edge_length(h) > longest * m_length)
        t.split_edge(h, middle(h));
  }

  // Moves inner vertices towards the mean of their neighbours, where their triangles stay good or get better.
  void relocate()
  {
    Patch_triangulation& t = m_triangulation;
    for(int v = 0; v < static_cast<int>(t.vertices.size()); ++v)
    {
      if(t.corner[v] < 0 || is_kept(v) || t.is_on_border(v))
        continue;
      Coordinates sum{ 0, 0, 0 };
      int count = 0;
      t.for_each_edge_of(v, [&](const int h)
      {
        sum = sum + t.point(t.other_end(h, v));
        ++count;
      });
      const Patch_vertex old = t.vertices[v];
      const double old_shape = worst_shape(v, v, -1);
      m_walker.walk_towards(t.vertices[v].location, 1. / count * sum);
      t.vertices[v].point = m_walker.point(t.vertices[v].location);
      const double good_shape = 0.4, new_shape = worst_shape(v, v, -1);
      if(!(new_shape > (std::min)(old_shape, good_shape)))
        t.vertices[v] = old;
    }
  }

  // A vertex of the border whose only triangle is flat would be the corner of only one quad, with an angle of 180
  // degrees wherever its other vertices go. Another vertex gives it a second one.
  void split_flat_ears()
  {
    const double flat = 0.2; // two equal sides at an angle of 136 degrees
    Patch_triangulation& t = m_triangulation;
    const int number_of_halfedges = t.number_of_halfedges();
    for(int h = 0; h < number_of_halfedges; ++h)
      if(t.has(h) && t.opposite[h] >= 0 && t.opposite[next_of(h)] < 0 && t.opposite[previous_of(h)] < 0
         && shape(t.source(h), t.target[h], t.apex(h)) < flat)
        t.split_edge(h, middle(h));
  }

  // Leaves only kept vertices on the border. Returns whether all others could be removed.
  bool finish_border()
  {
    Patch_triangulation& t = m_triangulation;
    for(int v = 0; v < static_cast<int>(t.vertices.size()); ++v)
      if(t.corner[v] >= 0 && t.is_on_border(v) && !is_kept(v) && !remove_from_border(v))
        return false;
    return true;
  }

  // Removes a vertex of the border in any case: where the triangulation is in the way, it is split.
  bool remove_from_border(const int vertex)
  {
    Patch_triangulation& t = m_triangulation;
    const int from = next_of(clockwise_most_corner(t.opposite, t.corner[vertex]));
    int to = from;
    t.for_each_corner_of(vertex, [&](const int c) { to = c; });
    for(const int h : { from, to })
      if(can_collapse(h, vertex) && worst_shape(vertex, t.other_end(h, vertex), h) > 0)
      {
        t.collapse(h, vertex);
        return true;
      }
    const int kept = t.target[from];
    std::vector<int> loops;
    t.for_each_edge_of(vertex, [&](const int h)
    {
      if(h != from && t.would_be_loop(kept, t.other_end(h, vertex)))
        loops.push_back(h);
    });
    for(const int h : loops)
    {
      if(t.opposite[h] < 0)
        return false;
      t.split_edge(h, middle(h));
    }
    if(!t.can_vanish(from))
    {
      const int middle_of_edge = middle(previous_of(from)); // a place in the face is enough; smoothing finds a good one
      t.split_face(from, middle_of_edge);
    }
    t.collapse(from, vertex);
    return true;
  }

  const Surface_walker& m_walker;
  double m_length;
  Patch_triangulation& m_triangulation;
  std::vector<int> m_mark; // per vertex
  int m_round = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_PATCH_REMESHER_H
