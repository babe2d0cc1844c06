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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_EVENLY_SPACED_STREAMLINES_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_EVENLY_SPACED_STREAMLINES_H

#include <CGAL/Frame_fields/internal/streamlines/Branch_directions.h>
#include <CGAL/Frame_fields/internal/streamlines/Chart_line.h>
#include <CGAL/Frame_fields/internal/streamlines/Face_neighborhood.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_distances.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_options.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_tracer.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A streamline from its first point to its last.
struct Traced_streamline
{
  std::vector<Streamline_piece> pieces;
  bool is_closed = false;
};

// A point of a face and a branch there.
struct Streamline_seed
{
  int face, branch;
  Corner_weights weights;
};

inline Streamline_piece reversed(const Streamline_piece& piece)
{
  return { piece.face, (piece.branch + 2) % 4, piece.to, piece.from, piece.length };
}

inline Streamline_piece first_part(const Streamline_piece& piece, const double length)
{
  const double t = (std::min)(1., length / piece.length);
  return { piece.face, piece.branch, piece.from, between(piece.from, piece.to, t), t * piece.length };
}

// A streamline while it is traced from its seed in one direction.
struct Growing_streamline
{
  std::vector<Streamline_piece> pieces;
  double length = 0;
  std::size_t number_of_settled_pieces = 0; // those that are not cut off any more
  double settled_length = 0;

  void append(const Streamline_piece& piece)
  {
    pieces.push_back(piece);
    length += piece.length;
  }

  void cut(const double new_length)
  {
    while(!pieces.empty() && length - pieces.back().length >= new_length)
    {
      length -= pieces.back().length;
      pieces.pop_back();
    }
    if(!pieces.empty() && length > new_length)
      pieces.back() = first_part(pieces.back(), pieces.back().length - (length - new_length));
    length = (std::min)(length, new_length);
  }
};

// Fills a patch with streamlines at a given spacing. The field is aligned with the constrained edges, so these are its
// first lines. New lines begin beside those that there are, as in Jobard and Lefer, Creating evenly-spaced streamlines
// of arbitrary density, 1997, and at last in the faces that no line is near to.
class Evenly_spaced_streamlines
{
public:
  Evenly_spaced_streamlines(const Face_charts& charts, const Branch_directions& directions, const Patch& patch,
                            const Streamline_options& options)
    : m_charts(charts), m_surface(charts.surface()), m_directions(directions), m_patch(patch), m_options(options)
    , m_tracer(charts, directions), m_neighborhood(charts, directions, patch)
    , m_distances(charts, directions, patch, m_neighborhood), m_maximum_number_of_pieces(piece_bound())
  {}

  std::vector<Traced_streamline> trace()
  {
    begin_lines_beside_constrained_edges();
    begin_lines_in_faces();
    return std::move(m_lines);
  }

private:
  // The line number that all constrained edges share.
  static constexpr int constrained_edge = -1;

  // Far more than rounding errors, far less than what is seen.
  static constexpr double relative_tolerance = 1e-6;

  // Marks per face of the patch and branch pair.
  typedef std::vector<bool> Marks;

  Marks no_marks() const { return Marks(2 * static_cast<std::size_t>(m_patch.faces.size()), false); }

  std::size_t place_of_mark(const Chart_point& point) const
  {
    return 2 * static_cast<std::size_t>(point.face - m_patch.faces.begin_index) + point.branch % 2;
  }

  // Whether nothing near to the point was marked before; marks what is near.
  bool mark(const Chart_point& point, Marks& marks)
  {
    if(marks[place_of_mark(point)])
      return false;
    m_neighborhood.walk(point, m_options.spacing / 4, [&](const Chart_point& p)
    {
      marks[place_of_mark(p)] = true;
      return true;
    });
    return true;
  }

  Chart_point chart_point(const Streamline_seed& seed) const
  {
    return { seed.face, seed.branch, m_charts.place(seed.face, seed.weights) };
  }

  // No more pieces are in a line whose passages through a face are apart from one another.
  std::size_t piece_bound() const
  {
    const double apart = m_options.least_distance > 0 ? m_options.least_distance : m_options.spacing;
    double bound = 1000;
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      bound += 4 + 2 * (std::max)({ m_charts.length(3 * f), m_charts.length(3 * f + 1), m_charts.length(3 * f + 2) })
                     / apart;
    return static_cast<std::size_t>((std::min)(bound, 1e15));
  }

  // The constrained edges that a branch is along, the longest ones first.
  std::vector<Streamline_piece> aligned_constrained_edges() const
  {
    const double tolerance = 1e-6;
    std::vector<Streamline_piece> result;
    for(int h = 3 * m_patch.faces.begin_index; h < 3 * m_patch.faces.end_index; ++h)
      for(const int branch : { 0, 1 })
        if(m_surface.is_constrained(h)
           && std::abs(cross(m_directions.direction(face_of(h), branch), m_charts.direction(h))) < tolerance)
          result.push_back({ face_of(h), branch, weights_on_halfedge(h, 0), weights_on_halfedge(h, 1),
                             m_charts.length(h) });
    std::stable_sort(result.begin(), result.end(), [](const Streamline_piece& a, const Streamline_piece& b)
                     { return a.length > b.length; });
    return result;
  }

  void begin_lines_beside_constrained_edges()
  {
    const std::vector<Streamline_piece> edges = aligned_constrained_edges();
    for(const Streamline_piece& edge : edges)
      m_distances.add(edge, { constrained_edge, 0 }, 1, m_options.spacing);
    Marks marks = no_marks();
    for(const Streamline_piece& edge : edges)
      if(mark(chart_point({ edge.face, edge.branch, between(edge.from, edge.to, 0.5) }), marks))
      {
        begin_lines_beside({ edge });
        begin_lines_beside_new_lines();
      }
  }

  std::vector<int> faces_by_area() const
  {
    std::vector<int> result(m_patch.faces.size());
    std::iota(result.begin(), result.end(), m_patch.faces.begin_index);
    std::stable_sort(result.begin(), result.end(), [&](const int a, const int b)
                     { return m_charts.area(a) > m_charts.area(b); });
    return result;
  }

  void begin_lines_in_faces()
  {
    Marks marks = no_marks();
    for(const int f : faces_by_area())
      for(const int branch : { 0, 1 })
      {
        const Streamline_seed seed{ f, branch, { 1. / 3, 1. / 3, 1. / 3 } };
        if(m_charts.area(f) > 0 && mark(chart_point(seed), marks))
        {
          begin_line(seed);
          begin_lines_beside_new_lines();
        }
      }
  }

  void begin_lines_beside_new_lines()
  {
    for(; m_number_of_done_lines < m_lines.size(); ++m_number_of_done_lines)
    {
      const std::vector<Streamline_piece> pieces = m_lines[m_number_of_done_lines].pieces; // m_lines grows meanwhile
      begin_lines_beside(pieces);
    }
  }

  // Tries to begin lines on both sides of a line, at points of it as far from one another as lines shall be.
  void begin_lines_beside(const std::vector<Streamline_piece>& pieces)
  {
    const double length = std::accumulate(pieces.begin(), pieces.end(), 0., [](const double sum, const auto& piece)
                                          { return sum + piece.length; });
    double next = (std::min)(length, m_options.spacing) / 2, arc = 0;
    for(const Streamline_piece& piece : pieces)
    {
      while(next < arc + piece.length)
      {
        const double taken = (std::min)(taken_until(piece, next - arc, 1), taken_until(piece, next - arc, -1));
        if(taken > next - arc)
        {
          next += m_options.spacing * (std::floor((taken - (next - arc)) / m_options.spacing) + 1);
          continue;
        }
        for(const double side : { 1, -1 })
          begin_line_beside({ piece.face, piece.branch, first_part(piece, next - arc).to }, side);
        next += m_options.spacing;
      }
      arc += piece.length;
    }
  }

  // The length along a piece up to which no line can begin beside it, since one in the same face is too near; `from` if
  // there it might. In a large face this saves a try at every spacing.
  double taken_until(const Streamline_piece& piece, const double from, const double side) const
  {
    if(piece.length - from < 2 * m_options.spacing)
      return from;
    const Chart_line line(m_charts, m_directions, piece, side * m_options.spacing);
    if(!line.is_along_branch(relative_tolerance * m_options.spacing))
      return from;
    // Nearer to a side, a seed is on an edge for moved_off_edges().
    const auto margin = [&](const int h) { return 4e-6 * m_charts.area(piece.face) / m_charts.length(h); };
    const Length_interval inside = line.inside(margin);
    double result = from;
    if(inside.contains(from))
      for(const Length_interval& near : line.near_parts(m_distances, (1 - relative_tolerance) * nearest_seed(),
                                                        [](const Streamline_part&) { return true; }))
        if(near.contains(from))
          result = (std::max)(result, (std::min)(near.end, inside.end) - relative_tolerance * m_options.spacing);
    return result;
  }

  void begin_line_beside(Streamline_seed seed, const double side)
  {
    const Plane_vector direction = quarter_turn(m_directions.direction(seed.face, seed.branch));
    if(go_straight(seed, side * direction, m_options.spacing))
      begin_line(seed);
  }

  // Moves a seed straight on over the faces, but not across constrained edges, nor through vertices.
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

  // A seed on an edge or a vertex, moved on along its line to where the tracer will pass when the line comes back.
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

  static Streamline_head head_at(const Streamline_seed& seed)
  {
    return { Streamline_head::INSIDE, -1, seed.face, seed.branch, seed.weights };
  }

  // Lines begin at least at this distance from others.
  double nearest_seed() const { return 0.9 * m_options.spacing; }

  // Adds the line through the seed unless another one is too near to it. Lines bend, so a point at the spacing from one
  // point of a line can be a little nearer to another one.
  void begin_line(const Streamline_seed& given_seed)
  {
    const Streamline_seed seed = moved_off_edges(given_seed);
    const int line = static_cast<int>(m_lines.size());
    if(m_distances.is_line_near(chart_point(seed), nearest_seed(), { line, 0 }))
      return;
    Traced_streamline forward = trace_one_way(seed, line, 1);
    if(!forward.is_closed)
    {
      Traced_streamline backward =
        trace_one_way({ seed.face, (seed.branch + 2) % 4, seed.weights }, line, -1);
      std::transform(backward.pieces.begin(), backward.pieces.end(), backward.pieces.begin(), reversed);
      std::reverse(backward.pieces.begin(), backward.pieces.end());
      forward.pieces.insert(forward.pieces.begin(), backward.pieces.begin(), backward.pieces.end());
    }
    if(!forward.pieces.empty())
      m_lines.push_back(std::move(forward));
  }

  // Traces from the seed along its branch. Lengths count as negative in `m_distances` if `sign` is -1.
  Traced_streamline trace_one_way(const Streamline_seed& seed, const int line, const double sign)
  {
    const double longest = m_options.maximum_length / 2;
    Growing_streamline growing;
    Streamline_head head = head_at(seed);
    bool is_closed = false, is_free = true;
    for(std::size_t i = 0; i < m_maximum_number_of_pieces && head.kind != Streamline_head::END && !is_closed && is_free
                           && growing.length < longest; ++i)
    {
      Streamline_piece piece;
      m_tracer.advance(head, piece);
      if(piece.length == 0)
        continue;
      is_closed = !growing.pieces.empty() && ends_at(seed, piece);
      const double start = growing.length;
      growing.append(piece);
      is_free = keep_distance(growing, start, line, sign);
    }
    is_closed = is_closed && is_free && growing.length <= longest;
    growing.cut(longest);
    settle(growing, std::numeric_limits<double>::infinity(), line, sign);
    return { std::move(growing.pieces), is_closed };
  }

  // Whether the piece passes through the seed along its branch; then ends it there.
  bool ends_at(const Streamline_seed& seed, Streamline_piece& piece) const
  {
    if(piece.face != seed.face || piece.branch != seed.branch)
      return false;
    const double tolerance = 1e-6 * m_options.spacing;
    const Plane_vector from = m_charts.place(piece.face, piece.from);
    const Plane_vector direction = (1 / piece.length) * (m_charts.place(piece.face, piece.to) - from);
    const Plane_vector way = m_charts.place(seed.face, seed.weights) - from;
    const double along = dot(direction, way);
    if(std::abs(cross(direction, way)) > tolerance || along <= 0 || along > piece.length + tolerance)
      return false;
    piece.to = seed.weights;
    piece.length = along;
    return true;
  }

  // Where in a piece samples are needed: not in its free interval, but for the intervals in which a line is near.
  struct Piece_to_sample
  {
    Length_interval free{ 1, 0 };
    std::vector<Length_interval> near;

    // The length up to which no sample can be too near to a line; `from` if there it might.
    double free_until(const double from) const
    {
      if(!free.contains(from))
        return from;
      double result = free.end;
      for(const Length_interval& interval : near)
        if(interval.contains(from))
          return from;
        else if(interval.begin > from)
          result = (std::min)(result, interval.begin);
      return result;
    }
  };

  // A point that is far from all sides of its face that can be crossed is near to lines in this face only.
  Piece_to_sample piece_to_sample(const Streamline_piece& piece, const double start, const int line,
                                  const double sign) const
  {
    const double distance = m_options.least_distance * (1 + relative_tolerance);
    Piece_to_sample result;
    if(piece.length < 2 * m_options.least_distance) // a few samples are faster
      return result;
    const Chart_line chart_line(m_charts, m_directions, piece, 0);
    if(!chart_line.is_along_branch(relative_tolerance * distance))
      return result;
    result.free = chart_line.inside([&](const int h) { return m_surface.is_constrained(h) ? -distance : distance; });
    const double arc_at_begin = sign * start, arc_at_end = sign * (start + piece.length);
    result.near = chart_line.near_parts(m_distances, distance, [&](const Streamline_part& part)
    {
      // Of the line itself, what was traced just before does not count.
      const double farthest = (std::max)({ std::abs(part.arc_at_begin - arc_at_begin),
                                           std::abs(part.arc_at_begin - arc_at_end),
                                           std::abs(part.arc_at_end - arc_at_begin),
                                           std::abs(part.arc_at_end - arc_at_end) });
      return part.line != line || farthest > 3 * m_options.least_distance;
    });
    for(Length_interval& interval : result.near)
      interval = { interval.begin - relative_tolerance * distance, interval.end + relative_tolerance * distance };
    return result;
  }

  // Samples the last piece, which begins at the length `start`. Cuts the line at the last sample that was good and
  // returns false if a sample is too near to a line.
  bool keep_distance(Growing_streamline& growing, const double start, const int line, const double sign)
  {
    if(m_options.least_distance == 0)
      return true;
    const double step = m_options.least_distance / 4;
    const Streamline_piece piece = growing.pieces.back();
    const Piece_to_sample to_sample = piece_to_sample(piece, start, line, sign);
    double number = std::floor(start / step) + 1;
    for(double sample = step * number; sample <= growing.length; sample = step * ++number)
    {
      if(const double free_until = to_sample.free_until(sample - start); free_until > sample - start)
      {
        number = (std::max)(number, std::ceil((start + free_until) / step) - 1);
        continue;
      }
      const Streamline_seed point{ piece.face, piece.branch, first_part(piece, sample - start).to };
      if(m_distances.is_line_near(chart_point(point), m_options.least_distance, { line, sign * sample }))
      {
        growing.cut(sample - step);
        return false;
      }
    }
    settle(growing, start - step, line, sign);
    return true;
  }

  // Makes the pieces that end before a length known to `m_distances`.
  void settle(Growing_streamline& growing, const double length, const int line, const double sign)
  {
    for(std::size_t& i = growing.number_of_settled_pieces;
        i < growing.pieces.size() && growing.settled_length + growing.pieces[i].length <= length; ++i)
    {
      m_distances.add(growing.pieces[i], { line, sign * growing.settled_length }, sign, m_options.spacing / 16);
      growing.settled_length += growing.pieces[i].length;
    }
  }

  const Face_charts& m_charts;
  const Cut_surface& m_surface;
  const Branch_directions& m_directions;
  const Patch& m_patch;
  Streamline_options m_options;
  Streamline_tracer m_tracer;
  Face_neighborhood m_neighborhood;
  Streamline_distances m_distances;
  std::size_t m_maximum_number_of_pieces;
  std::vector<Traced_streamline> m_lines;
  std::size_t m_number_of_done_lines = 0;
};

// The streamlines of each patch.
template <typename ConcurrencyTag>
std::vector<std::vector<Traced_streamline> > trace_in_patches(const Face_charts& charts,
                                                              const Branch_directions& directions,
                                                              const Streamline_options& options)
{
  const Cut_surface& surface = charts.surface();
  std::vector<std::vector<Traced_streamline> > result(surface.patches.size());
  for_each_patch<ConcurrencyTag>(surface, [&](const int patch)
  {
    result[patch] = Evenly_spaced_streamlines(charts, directions, surface.patches[patch], options).trace();
    return Patch_result();
  });
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_EVENLY_SPACED_STREAMLINES_H
