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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_WALKER_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_WALKER_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Moves points on a surface straight on from face to face, never across a constrained edge. Coordinates are in the unit
// of the embedding. The surface and the embedding must outlive it.
class Surface_walker
{
public:
  Surface_walker(const Cut_surface& surface, const Surface_embedding& embedding)
    : m_surface(surface), m_embedding(embedding), m_chart(surface.number_of_halfedges())
    , m_normal(surface.number_of_faces())
  {
    for(int f = 0; f < surface.number_of_faces(); ++f)
      measure(f);
  }

  const Cut_surface& surface() const { return m_surface; }

  // The unit normal of a face, zero if it has no area.
  const Coordinates& normal(const int face) const { return m_normal[face]; }

  const Coordinates& target(const int halfedge) const { return m_embedding.point[m_embedding.vertex[halfedge]]; }

  Coordinates point(const Surface_location& location) const
  {
    const Coordinates& p = target(3 * location.face);
    const Coordinates& q = target(3 * location.face + 1);
    const Coordinates& r = target(3 * location.face + 2);
    const std::array<double, 3>& w = location.barycentric;
    return w[0] * p + w[1] * q + w[2] * r;
  }

  // Walks along the part of `displacement` that is tangential to the face. Faces are unfolded into its plane one after
  // the other. Returns whether the end was reached; otherwise `location` is where a constrained edge, a face without
  // height, or the bound on the number of steps stopped the walk. From a face without area the walk does not move, and
  // the result is `true`. Each step takes constant time; a start at a corner takes that of the corners of its sector.
  bool walk(Surface_location& location, const Coordinates& displacement, const int maximum_number_of_steps = 1000) const
  {
    turn_at_corner(location, displacement);
    std::array<double, 3> change = change_of_weights(location.face, displacement);
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      std::array<double, 3>& weight = location.barycentric;
      double part = 1;
      int exit = -1;
      for(int k = 0; k < 3; ++k)
        if(weight[k] + change[k] < 0 && weight[k] < -part * change[k])
        {
          part = weight[k] / -change[k];
          exit = k;
        }
      for(int k = 0; k < 3; ++k)
        weight[k] = (std::max)(0., weight[k] + part * change[k]);
      if(exit >= 0)
        weight[exit] = 0;
      make_sum_one(weight);
      if(exit < 0)
        return true;
      const int halfedge = previous_of(3 * location.face + exit);
      if(!cross_edge(halfedge, 1 - part, location, change))
        return false;
    }
    return false;
  }

  // Walks towards `goal` again and again until that leads no nearer, but for `number_of_rounds` walks at most.
  void walk_towards(Surface_location& location, const Coordinates& goal, const int number_of_rounds = 8) const
  {
    double best = distance(point(location), goal);
    for(int round = 0; round < number_of_rounds; ++round)
    {
      const Coordinates p = point(location);
      Surface_location next = location;
      walk(next, goal - p);
      const double distance_of_next = distance(point(next), goal);
      if(!(distance_of_next < best))
        return;
      location = next;
      best = distance_of_next;
    }
  }

private:
  // If the location is a corner: goes to the face of its sector into which the displacement points, if there is one.
  // From another face the walk would have to go around the vertex first, perhaps on the side that a constrained edge
  // blocks.
  void turn_at_corner(Surface_location& location, const Coordinates& displacement) const
  {
    const auto at = std::find(location.barycentric.begin(), location.barycentric.end(), 1.);
    if(at == location.barycentric.end())
      return;
    const int corner = 3 * location.face + static_cast<int>(at - location.barycentric.begin());
    bool is_found = false;
    for_each_corner(m_surface.opposite, clockwise_most_corner(m_surface.opposite, corner), [&](const int c)
    {
      if(is_found)
        return;
      const std::array<double, 3> change = change_of_weights(face_of(c), displacement);
      is_found = change[next_of(c) % 3] >= 0 && change[previous_of(c) % 3] >= 0 && change[c % 3] < 0;
      if(is_found)
        location = location_on_halfedge(c, 1);
    });
  }

  // The length of a halfedge, and the apex of its face: how far along the halfedge and how far to its left.
  struct Edge_chart
  {
    double length, along, height;
  };

  void measure(const int face)
  {
    for(int h = 3 * face; h < 3 * face + 3; ++h)
    {
      const Coordinates& source = target(previous_of(h));
      const Coordinates e = target(h) - source, f = target(next_of(h)) - source;
      const double length_of_edge = std::sqrt(dot(e, e));
      const Coordinates normal = cross(e, f);
      const double twice_area = std::sqrt(dot(normal, normal));
      m_chart[h] = { length_of_edge, length_of_edge > 0 ? dot(e, f) / length_of_edge : 0,
                     length_of_edge > 0 ? twice_area / length_of_edge : 0 };
      if(twice_area > 0)
        m_normal[face] = normal / twice_area;
    }
  }

  // What a displacement by `along` in the direction of a halfedge and by `left` to its left adds to the weights of the
  // corners of its face; zero in a face without height.
  std::array<double, 3> change_of_weights(const int halfedge, const double along, const double left) const
  {
    const Edge_chart& chart = m_chart[halfedge];
    if(!(chart.length > 0 && chart.height > 0))
      return { 0, 0, 0 };
    const double of_apex = left / chart.height, of_target = (along - chart.along * of_apex) / chart.length;
    std::array<double, 3> change;
    change[next_of(halfedge) % 3] = of_apex;
    change[halfedge % 3] = of_target;
    change[previous_of(halfedge) % 3] = -of_apex - of_target;
    return change;
  }

  std::array<double, 3> change_of_weights(const int face, const Coordinates& displacement) const
  {
    const int h = 3 * face;
    const Coordinates edge = target(h) - target(previous_of(h));
    const double l = m_chart[h].length;
    if(!(l > 0))
      return { 0, 0, 0 };
    return change_of_weights(h, dot(edge, displacement) / l, dot(cross(m_normal[face], edge), displacement) / l);
  }

  // Goes to the face on the other side of a halfedge with the fraction `rest` of the walk that is left. Returns false
  // if the halfedge is constrained or that face has no height.
  bool cross_edge(const int halfedge, const double rest, Surface_location& location,
                  std::array<double, 3>& change) const
  {
    const int opposite = m_surface.opposite[halfedge];
    if(opposite < 0 || !(m_chart[opposite].height > 0))
      return false;
    const Edge_chart& chart = m_chart[halfedge];
    const double of_apex = change[next_of(halfedge) % 3], of_target = change[halfedge % 3];
    const double along = of_target * chart.length + of_apex * chart.along, left = of_apex * chart.height;
    change = change_of_weights(opposite, -rest * along, (std::max)(0., -rest * left));

    const std::array<double, 3> old = location.barycentric;
    location.face = face_of(opposite);
    location.barycentric[opposite % 3] = old[previous_of(halfedge) % 3];
    location.barycentric[previous_of(opposite) % 3] = old[halfedge % 3];
    location.barycentric[next_of(opposite) % 3] = 0;
    return true;
  }

  static void make_sum_one(std::array<double, 3>& weight)
  {
    const double sum = weight[0] + weight[1] + weight[2];
    for(double& w : weight)
      w /= sum;
  }

  const Cut_surface& m_surface;
  const Surface_embedding& m_embedding;
  std::vector<Edge_chart> m_chart;   // per halfedge
  std::vector<Coordinates> m_normal; // per face
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SURFACE_WALKER_H
