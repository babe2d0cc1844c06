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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_SEEDS_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_SEEDS_H

#include <CGAL/Frame_fields/internal/streamlines/Branch_directions.h>
#include <CGAL/Frame_fields/internal/streamlines/Chart_line.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_distances.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_options.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_tracer.h>
#include <CGAL/Frame_fields/internal/streamlines/Traced_streamline.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Finds where new lines can begin: beside lines at the spacing.
class Streamline_seeds
{
public:
  Streamline_seeds(const Face_charts& charts, const Branch_directions& directions, const Patch& patch,
                   const Streamline_options& options, const Streamline_tracer& tracer,
                   const Streamline_distances& distances)
    : m_charts(charts), m_surface(charts.surface()), m_directions(directions), m_patch(patch), m_options(options)
    , m_tracer(tracer), m_distances(distances)
  {}

  // Lines begin at least at this distance from others.
  double nearest_seed() const { return 0.9 * m_options.spacing; }

  // Moves a seed by `distance` along a straight line over the faces; where this line would meet a vertex, it passes
  // beside it. `direction` is a unit vector in the chart of the seed's face. Returns false, with the seed somewhere on
  // the way, if the line meets a constrained edge or crosses too many faces.
  bool go_straight(Streamline_seed& seed, Plane_vector direction, double distance) const
  {
    const double margin = 1e-6;
    Ray_exit exit = exit_from_inside(m_charts, seed.face, m_charts.place(seed.face, seed.weights), direction);
    for(int i = 0; i <= m_patch.faces.size(); ++i)
    {
      exit.t = (std::min)(1 - margin, (std::max)(margin, exit.t));
      const Corner_weights to = weights_on_halfedge(exit.halfedge, exit.t);
      const double length = m_charts.distance(seed.face, seed.weights, to);
      if(length >= distance)
      {
        seed.weights = between(seed.weights, to, distance / length);
        return true;
      }
      if(m_surface.is_constrained(exit.halfedge))
        return false;
      distance -= length;
      direction = m_charts.direction_across(exit.halfedge, direction);
      const int entry = m_surface.opposite[exit.halfedge];
      seed = { face_of(entry), m_directions.branch_across(exit.halfedge, seed.branch),
               weights_on_halfedge(entry, 1 - exit.t) };
      exit = exit_from_halfedge(m_charts, m_charts.place(seed.face, seed.weights), direction, entry);
    }
    return false;
  }

  // The seed itself, or if it is on an edge or a vertex, a point inside a face farther along its line. A line that
  // closes passes through such a point, but may miss one on an edge.
  Streamline_seed moved_off_edges(const Streamline_seed& seed) const
  {
    const double tolerance = 1e-6;
    if(*std::min_element(seed.weights.begin(), seed.weights.end()) > tolerance)
      return seed;
    Streamline_head head = head_at(seed);
    Streamline_piece piece{ seed.face, seed.branch, seed.weights, seed.weights, 0 };
    for(int i = 0; i < 2 && head.kind != Streamline_head::END; ++i)
      m_tracer.advance(head, piece);
    return { piece.face, piece.branch, between(piece.from, piece.to, 0.5) };
  }

  // The length along a piece up to which no line can begin beside it on the given side (1 left, -1 right), since a line
  // in the same face is too near; `from` if a line might begin beside `from`. In a large face this saves a try at every
  // spacing.
  double taken_until(const Streamline_piece& piece, const double from, const double side) const
  {
    if(piece.length - from < 2 * m_options.spacing)
      return from;
    const Chart_line line(m_charts, m_directions, piece, side * m_options.spacing);
    if(!line.is_along_branch(relative_streamline_tolerance * m_options.spacing))
      return from;
    // A seed that is nearer to a side counts as one on an edge in moved_off_edges().
    const auto margin = [&](const int h) { return 4e-6 * m_charts.area(piece.face) / m_charts.length(h); };
    const Length_interval inside = line.inside(margin);
    double result = from;
    if(!inside.contains(from))
      return result;
    const double tolerance = relative_streamline_tolerance;
    for(const Length_interval& near : line.near_parts(m_distances, (1 - tolerance) * nearest_seed(),
                                                      [](const Streamline_part&) { return true; }))
      if(near.contains(from))
        result = (std::max)(result, (std::min)(near.end, inside.end) - tolerance * m_options.spacing);
    return result;
  }

private:
  const Face_charts& m_charts;
  const Cut_surface& m_surface;
  const Branch_directions& m_directions;
  const Patch& m_patch;
  Streamline_options m_options;
  const Streamline_tracer& m_tracer;
  const Streamline_distances& m_distances;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_SEEDS_H
