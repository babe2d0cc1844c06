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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_IMPROVE_WORST_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_IMPROVE_WORST_QUADS_H

#include <CGAL/Frame_fields/internal/quads/Sliding_quads.h>
#include <CGAL/Frame_fields/internal/quads/sliding_step.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The mean length of the sides of the quads that leave a vertex.
inline double mean_length_of_sides(const Sliding_quads& quads, const int vertex)
{
  double sum = 0;
  int count = 0;
  for(const int* c = quads.corners_begin(vertex); c != quads.corners_end(vertex); ++c, ++count)
    sum += distance(quads.point(vertex), quads.point(quads.quad(*c / 4)[(*c + 1) % 4]));
  return count > 0 ? sum / count : 0;
}

// Calls `try_slide` for slides of about the given length into eight directions of a patch or the two of an arc, until
// it returns true.
template <typename TrySlide>
bool try_slides_around(const Sliding_quads& quads, const int vertex, const double step, const TrySlide& try_slide)
{
  Slide slide;
  if(quads.freedom(vertex) == Sliding_quads::ON_ARC)
  {
    const double here = quads.arc_order().length(vertex);
    for(const double length : { here + step, here - step })
      if(quads.slide_on_arc(vertex, length, slide) && try_slide(slide))
        return true;
    return false;
  }
  const double diagonal = std::sqrt(0.5);
  const std::array<Plane_vector, 8> directions{ { { 1, 0 }, { diagonal, diagonal }, { 0, 1 }, { -diagonal, diagonal },
                                                  { -1, 0 }, { -diagonal, -diagonal }, { 0, -1 },
                                                  { diagonal, -diagonal } } };
  const Vertex_plane plane(quads, vertex);
  for(const Plane_vector& direction : directions)
    if(quads.slide_inside(vertex, plane.in_space(step * direction), slide) && try_slide(slide))
      return true;
  return false;
}

// The length of the shortest side of the quads of a vertex that is at `point`.
inline double shortest_side(const Sliding_quads& quads, const int vertex, const Coordinates& point)
{
  double result = std::numeric_limits<double>::infinity();
  for(const int* c = quads.corners_begin(vertex); c != quads.corners_end(vertex); ++c)
    for(const int k : { 1, 3 })
      result = (std::min)(result, distance(point, quads.point(quads.quad(*c / 4)[(*c + k) % 4])));
  return result;
}

// Searches slides of a vertex that raise the least scaled Jacobian of its quads. The scaled Jacobian does not depend on
// lengths, so a lower bound keeps sides from vanishing. Returns whether there was such a slide.
inline bool raise_worst_quad_of_vertex(Sliding_quads& quads, const int vertex)
{
  const int maximum_number_of_slides = 32, number_of_halvings = 6;
  const double least_gain = 1e-4;
  const double mean_length = mean_length_of_sides(quads, vertex), least_length = 0.2 * mean_length;
  double step = 0.25 * mean_length;
  int number_of_slides = 0;
  for(int i = 0; i <= number_of_halvings;)
  {
    const double old_value = quads.shape_around(vertex).scaled_jacobian;
    const bool has_moved = try_slides_around(quads, vertex, step, [&](const Slide& slide)
    {
      if(!(quads.shape_around(vertex, slide, old_value + least_gain).scaled_jacobian > old_value + least_gain)
         || shortest_side(quads, vertex, slide.point)
              < (std::min)(least_length, shortest_side(quads, vertex, quads.point(vertex)))
         || (old_value <= 0 && quads.inverts_quad(vertex, slide)))
        return false;
      quads.move(vertex, slide);
      return true;
    });
    number_of_slides += has_moved;
    if(number_of_slides >= maximum_number_of_slides)
      break;
    if(!has_moved)
    {
      step /= 2;
      ++i;
    }
  }
  return number_of_slides > 0;
}

// Moves the vertices of the list that have a quad with a scaled Jacobian below `bound`, one by one, to raise it.
// Returns whether any moved. After the first sweep, only vertices are tried again whose quads have changed. `tried` has
// an entry per vertex of all quads, at first -1: the changes of its quads when it was last tried in vain. It is not
// tried again before they change.
inline bool improve_worst_quads(Sliding_quads& quads, const std::vector<int>& vertices, const double bound,
                                std::vector<std::int64_t>& tried)
{
  const int number_of_sweeps = 5;
  std::vector<int> last_change(quads.number_of_quads(), 0); // per quad: the sweep
  bool has_any_improved = false;
  for(int sweep = 1; sweep <= number_of_sweeps; ++sweep)
  {
    bool has_improved = false;
    for(const int v : vertices)
    {
      const bool has_changed = std::any_of(quads.corners_begin(v), quads.corners_end(v), [&](const int c)
                                           { return last_change[c / 4] + 1 >= sweep; });
      if(!has_changed || quads.freedom(v) == Sliding_quads::FIXED || quads.shape_around(v).scaled_jacobian >= bound
         || tried[v] == quads.number_of_changes(v))
        continue;
      if(!raise_worst_quad_of_vertex(quads, v))
      {
        tried[v] = quads.number_of_changes(v);
        continue;
      }
      has_improved = true;
      for(const int* c = quads.corners_begin(v); c != quads.corners_end(v); ++c)
        last_change[*c / 4] = sweep;
    }
    if(!has_improved)
      break;
    has_any_improved = true;
  }
  return has_any_improved;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_IMPROVE_WORST_QUADS_H
