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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_PATCH_TRIANGULATION_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_PATCH_TRIANGULATION_H

#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A vertex of the triangulation of a patch. Its location is in a face of the patch.
struct Patch_vertex
{
  Surface_location location;
  Coordinates point;
  int id = -1;           // of the vertex of the quads that it becomes; -1 if there is none yet
  int mesh_vertex = -1;  // inside the patch: the vertex of the surface that it must stay at, -1 if there is none
};

// A triangulation of a patch that can be changed. Two vertices may have several edges between them, but no edge may
// join two vertices that become the same vertex of the quads. Halfedges are numbered as those of `Cut_surface`.
class Patch_triangulation
{
public:
  std::vector<Patch_vertex> vertices;
  std::vector<int> target, opposite;  // per halfedge; -1 at the border
  std::vector<int> segment;           // per halfedge: the number of its part of the border, -1 inside
  std::vector<char> is_alive;         // per face
  std::vector<int> corner;            // per vertex: a halfedge to it, -1 if it is removed

  int number_of_halfedges() const { return static_cast<int>(target.size()); }
  int number_of_faces() const { return static_cast<int>(is_alive.size()); }
  bool has(const int halfedge) const { return is_alive[face_of(halfedge)] != 0; }
  int source(const int halfedge) const { return target[previous_of(halfedge)]; }
  int apex(const int halfedge) const { return target[next_of(halfedge)]; }
  const Coordinates& point(const int vertex) const { return vertices[vertex].point; }

  double edge_length(const int halfedge) const
  {
    return distance(point(source(halfedge)), point(target[halfedge]));
  }

  // Calls `visit(c)` for the corners of a vertex in counter-clockwise order, from the border if it is there.
  template <typename Visit>
  void for_each_corner_of(const int vertex, const Visit& visit) const
  {
    for_each_corner(opposite, clockwise_most_corner(opposite, corner[vertex]), visit);
  }

  // Calls `visit(h)` for one halfedge of each edge of a vertex, either to it or from it.
  template <typename Visit>
  void for_each_edge_of(const int vertex, const Visit& visit) const
  {
    const int first = clockwise_most_corner(opposite, corner[vertex]);
    if(opposite[next_of(first)] < 0)
      visit(next_of(first));
    for_each_corner(opposite, first, visit); // a corner is a halfedge to the vertex
  }

  int other_end(const int halfedge, const int vertex) const
  {
    return target[halfedge] == vertex ? source(halfedge) : target[halfedge];
  }

  bool is_on_border(const int vertex) const
  {
    return opposite[next_of(clockwise_most_corner(opposite, corner[vertex]))] < 0;
  }

  // Whether an edge between two vertices would have both ends at one vertex of the quads.
  bool would_be_loop(const int v, const int w) const
  {
    return v == w || (vertices[v].id >= 0 && vertices[v].id == vertices[w].id);
  }

  int number_of_edges_between(const int v, const int w) const
  {
    int count = 0;
    for_each_edge_of(v, [&](const int h) { count += other_end(h, v) == w; });
    return count;
  }

  int add_vertex(const Surface_location& location, const Coordinates& point)
  {
    Patch_vertex v;
    v.location = location;
    v.point = point;
    vertices.push_back(v);
    corner.push_back(-1);
    return static_cast<int>(vertices.size()) - 1;
  }

  // Puts a vertex on an edge. The halfedge then ends there; returns the one that continues it.
  int split_edge(const int halfedge, const int vertex)
  {
    const int other = opposite[halfedge];
    const int rest = split_side(halfedge, vertex);
    if(other >= 0)
    {
      const int rest_of_other = split_side(other, vertex);
      link(halfedge, rest_of_other);
      link(rest, other);
    }
    corner[vertex] = halfedge;
    return rest;
  }

  // Puts a vertex into the face of a halfedge, which keeps its ends.
  void split_face(const int h, const int vertex)
  {
    const int n = next_of(h), p = previous_of(h);
    const int a = target[p], b = target[h], c = target[n];
    const int first = add_face({ b, c, vertex }), second = add_face({ c, a, vertex });
    move_side(n, first + 1); // b c in the face of (b, c, vertex): its halfedges run to b, c and the vertex
    move_side(p, second + 1);
    target[n] = vertex;
    target[p] = a;
    link(n, first);          // b vertex, vertex b
    link(first + 2, second); // c vertex, vertex c
    link(second + 2, p);     // a vertex, vertex a
    corner[a] = p;
    corner[b] = h;
    corner[c] = first + 1;
    corner[vertex] = n;
  }

  // Whether the sides of the faces at an edge can be joined when the edge vanishes.
  bool can_vanish(const int halfedge) const
  {
    const int other = opposite[halfedge];
    for(const int h : { halfedge, other })
    {
      if(h < 0)
        continue;
      const int a = opposite[next_of(h)], b = opposite[previous_of(h)];
      if((a < 0 && b < 0) || (a >= 0 && b >= 0 && face_of(a) == face_of(b)))
        return false;
      for(const int side : { a, b })
        if(side >= 0 && (face_of(side) == face_of(halfedge) || (other >= 0 && face_of(side) == face_of(other))))
          return false;
    }
    return true;
  }

  // Moves `removed`, an end of the edge of a halfedge, to the other end. The edge and its faces vanish.
  void collapse(const int halfedge, const int removed)
  {
    const int kept = other_end(halfedge, removed), other = opposite[halfedge];
    for_each_corner_of(removed, [&](const int c) { target[c] = kept; });
    for(const int h : { halfedge, other })
      if(h >= 0)
        join_sides(h, kept);
    corner[removed] = -1;
  }

  // Turns an inner edge in the quad of its two faces.
  void flip(const int halfedge)
  {
    const int other = opposite[halfedge];
    const int n = next_of(halfedge), p = previous_of(halfedge), on = next_of(other), op = previous_of(other);
    const int a = target[other], b = target[halfedge], c = target[n], d = target[on]; // of a b c and b a d
    const Side bc = side(n), ca = side(p), ad = side(on), db = side(op);
    target[halfedge] = c; // d c
    target[n] = a;        // c a
    target[p] = d;        // a d
    target[other] = d;    // c d
    target[on] = b;       // d b
    target[op] = c;       // b c
    set_side(n, ca);
    set_side(p, ad);
    set_side(on, db);
    set_side(op, bc);
    corner[a] = n;
    corner[b] = on;
    corner[c] = halfedge;
    corner[d] = other;
  }

  Coordinates normal(const int a, const int b, const int c) const
  {
    return cross(point(b) - point(a), point(c) - point(a));
  }

private:
  // What is on the other side of a halfedge.
  struct Side
  {
    int opposite, segment;
  };

  Side side(const int halfedge) const { return { opposite[halfedge], segment[halfedge] }; }

  void set_side(const int halfedge, const Side& side)
  {
    opposite[halfedge] = side.opposite;
    segment[halfedge] = side.segment;
    if(side.opposite >= 0)
      opposite[side.opposite] = halfedge;
  }

  void link(const int halfedge, const int other)
  {
    opposite[halfedge] = other;
    opposite[other] = halfedge;
    segment[halfedge] = segment[other] = -1;
  }

  void move_side(const int from, const int to) { set_side(to, side(from)); }

  // A face whose halfedges run to the given vertices. Returns its first halfedge.
  int add_face(const std::array<int, 3>& targets)
  {
    const int first = number_of_halfedges();
    target.insert(target.end(), targets.begin(), targets.end());
    opposite.insert(opposite.end(), 3, -1);
    segment.insert(segment.end(), 3, -1);
    is_alive.push_back(true);
    return first;
  }

  // Splits the face of a halfedge a b with the apex c into a v c and v b c.
  int split_side(const int halfedge, const int vertex)
  {
    const int n = next_of(halfedge), b = target[halfedge], c = target[n];
    const int first = add_face({ b, c, vertex }); // v b, b c, c v
    segment[first] = segment[halfedge];
    move_side(n, first + 1);
    target[halfedge] = vertex;
    link(n, first + 2);
    corner[b] = first;
    corner[c] = n;
    return first;
  }

  void join_sides(const int halfedge, const int kept)
  {
    const int n = next_of(halfedge), p = previous_of(halfedge), apex = target[n];
    const Side after = side(n), before = side(p);
    is_alive[face_of(halfedge)] = false;
    if(after.opposite >= 0)
    {
      set_side(after.opposite, before);
      // `after.opposite` runs from the apex to the end that stays.
      corner[kept] = after.opposite;
      corner[apex] = previous_of(after.opposite);
    }
    else
    {
      set_side(before.opposite, after);
      corner[apex] = before.opposite;
      corner[kept] = previous_of(before.opposite);
    }
  }
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_PATCH_TRIANGULATION_H
