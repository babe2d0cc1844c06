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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_TRACER_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_TRACER_H

#include <CGAL/Frame_fields/internal/streamlines/Branch_directions.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The part of a streamline that lies in one face: from one point of it to another, along a branch of its frame.
struct Streamline_piece
{
  int face, branch;
  Corner_weights from, to;
  double length;
};

// Where a streamline is in a face, on which branch, and how it got there, which decides how it goes on.
struct Streamline_head
{
  enum Kind { END, INSIDE, ON_HALFEDGE, AT_CORNER, TOWARDS_CORNER };

  Kind kind = END;
  int element = -1; // the halfedge it crossed, the corner it is at, or the one it slides to along a side of the face
  int face = -1, branch = -1;
  Corner_weights weights{};
};

// Follows streamlines from face to face. In a face a line is straight. Where the field on both sides of an edge points
// to that edge, the line slides along it, as solutions of differential equations with a discontinuous right side do.
// Through a vertex it goes on as straight as the field allows.
class Streamline_tracer
{
public:
  Streamline_tracer(const Face_charts& charts, const Branch_directions& directions)
    : m_charts(charts), m_surface(charts.surface()), m_directions(directions)
  {}

  // Sets the piece that follows and moves the head to its end. The head must not be of kind END. The length of a piece,
  // in units of the charts, may be 0.
  void advance(Streamline_head& head, Streamline_piece& piece) const
  {
    piece.face = head.face;
    piece.branch = head.branch;
    piece.from = head.weights;
    if(head.kind == Streamline_head::TOWARDS_CORNER)
    {
      piece.to = weights_of_corner(head.element);
      head = go_on_from_vertex(head.element, head.branch, back_angle_of_slide(head));
    }
    else
    {
      const Ray_exit exit = exit_of(head);
      piece.to = weights_on_halfedge(exit.halfedge, exit.t);
      head = go_on_from_halfedge(exit, head.branch);
    }
    piece.length = m_charts.distance(piece.face, piece.from, piece.to);
  }

private:
  // Nearer to an end of an edge than this part of its length, a line goes through the vertex.
  static constexpr double vertex_tolerance = 1e-9;

  Ray_exit exit_of(const Streamline_head& head) const
  {
    const Plane_vector direction = m_directions.direction(head.face, head.branch);
    if(head.kind == Streamline_head::AT_CORNER)
      return exit_from_corner(m_charts, direction, head.element);
    const Plane_vector p = m_charts.place(head.face, head.weights);
    return head.kind == Streamline_head::ON_HALFEDGE ? exit_from_halfedge(m_charts, p, direction, head.element)
                                                     : exit_from_inside(m_charts, head.face, p, direction);
  }

  Streamline_head go_on_from_halfedge(const Ray_exit& exit, const int branch) const
  {
    const int h = exit.halfedge;
    const Plane_vector direction = m_directions.direction(face_of(h), branch);
    if(exit.t < vertex_tolerance)
      return go_on_from_vertex(previous_of(h), branch, back_angle(previous_of(h), direction));
    if(exit.t > 1 - vertex_tolerance)
      return go_on_from_vertex(h, branch, back_angle(h, direction));
    if(m_surface.is_constrained(h))
      return {};

    const int o = m_surface.opposite[h], branch_there = m_directions.branch_across(h, branch);
    const Plane_vector direction_there = m_directions.direction(face_of(o), branch_there);
    if(cross(m_charts.direction(o), direction_there) > 0)
      return { Streamline_head::ON_HALFEDGE, o, face_of(o), branch_there, weights_on_halfedge(o, 1 - exit.t) };
    return slide_along(exit, branch, direction, direction_there);
  }

  // The field on the other side points back to the halfedge. The line slides along the halfedge, in the direction of
  // the one convex combination of both branches that is parallel to it. It ends if this combination is 0.
  Streamline_head slide_along(const Ray_exit& exit, const int branch, const Plane_vector& direction,
                              const Plane_vector& direction_there) const
  {
    const Plane_vector here = m_charts.direction(exit.halfedge);
    const Plane_vector there = -m_charts.direction(m_surface.opposite[exit.halfedge]);
    const double outward = -cross(here, direction), inward = cross(there, direction_there);
    const double along = dot(here, direction), along_there = dot(there, direction_there);
    const double speed = outward + inward > 0 ? inward * along + outward * along_there : along + along_there;
    if(speed == 0)
      return {};
    const int corner = speed > 0 ? exit.halfedge : previous_of(exit.halfedge);
    return { Streamline_head::TOWARDS_CORNER, corner, face_of(corner), branch,
             weights_on_halfedge(exit.halfedge, exit.t) };
  }

  // At the corner of a sliding head: the angle from the corner's clockwise side to the side that the head comes along.
  double back_angle_of_slide(const Streamline_head& head) const
  {
    const bool came_along_incoming_side = head.weights[next_of(head.element) % 3] == 0;
    return came_along_incoming_side ? m_surface.angle[head.element] : 0;
  }

  // The angle from the clockwise side of a corner to the way back of a line that arrives there.
  double back_angle(const int corner, const Plane_vector& direction) const
  {
    const double angle = angle_from_to(m_charts.direction(next_of(corner)), -direction);
    return (std::min)(m_surface.angle[corner], (std::max)(0., angle));
  }

  // Turns once around the vertex and takes the way on that comes nearest to halving the total angle around it. A way on
  // is a branch that points into its face, or an edge to which the branches on both sides point. The line ends at a
  // sector where `is_end()`.
  Streamline_head go_on_from_vertex(const int first_corner, int branch, const double back_angle) const
  {
    const int sector = m_surface.sector[first_corner];
    if(m_directions.is_end(sector))
      return {};
    const double straight = m_surface.total_angle[sector] / 2;
    Streamline_head best;
    double least_turn = CGAL_PI, angle = -back_angle; // of the clockwise side of the corner, counted from the way back
    const auto offer = [&](const double turn, const Streamline_head& head)
    {
      if(!(std::abs(turn) < least_turn))
        return;
      least_turn = std::abs(turn);
      best = head;
    };
    for_each_corner(m_surface.opposite, first_corner, [&](const int corner)
    {
      const double to_branch = angle_to_branch(corner, branch), width = m_surface.angle[corner];
      if(to_branch >= 0 && to_branch <= width)
        offer(angle + to_branch - straight,
              { Streamline_head::AT_CORNER, corner, face_of(corner), branch, weights_of_corner(corner) });
      angle += width;
      const int next_corner = previous_of(m_surface.opposite[corner]);
      const int next_branch = m_directions.branch_across(corner, branch);
      if(to_branch > width && to_branch < width + CGAL_PI / 2)
      {
        const double beyond = angle_to_branch(next_corner, next_branch);
        if(beyond < 0 && beyond > -CGAL_PI / 2)
          offer(angle - straight, { Streamline_head::TOWARDS_CORNER, next_of(next_corner), face_of(next_corner),
                                    next_branch, weights_of_corner(next_corner) });
      }
      branch = next_branch;
    });
    return best;
  }

  // The angle from the clockwise side of a corner to a branch of its face.
  double angle_to_branch(const int corner, const int branch) const
  {
    return angle_from_to(m_charts.direction(next_of(corner)), m_directions.direction(face_of(corner), branch));
  }

  const Face_charts& m_charts;
  const Cut_surface& m_surface;
  const Branch_directions& m_directions;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_TRACER_H
