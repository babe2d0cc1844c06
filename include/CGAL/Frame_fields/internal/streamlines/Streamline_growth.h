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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_GROWTH_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_GROWTH_H

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
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Traces lines from seeds until they come too near to another one.
class Streamline_growth
{
public:
  Streamline_growth(const Face_charts& charts, const Branch_directions& directions, const Patch& patch,
                    const Streamline_options& options, const Streamline_tracer& tracer,
                    Streamline_distances& distances)
    : m_charts(charts), m_surface(charts.surface()), m_directions(directions), m_options(options), m_tracer(tracer)
    , m_distances(distances), m_maximum_number_of_pieces(piece_bound(patch))
  {}

  // The line through a seed, both ways.
  Traced_streamline line_through(const Streamline_seed& seed, const int line)
  {
    Traced_streamline forward = trace_one_way(seed, line, 1);
    if(forward.is_closed)
      return forward;
    Traced_streamline backward = trace_one_way({ seed.face, (seed.branch + 2) % 4, seed.weights }, line, -1);
    std::transform(backward.pieces.begin(), backward.pieces.end(), backward.pieces.begin(), reversed);
    std::reverse(backward.pieces.begin(), backward.pieces.end());
    forward.pieces.insert(forward.pieces.begin(), backward.pieces.begin(), backward.pieces.end());
    return forward;
  }

private:
  // A bound on the number of pieces of a line. A line whose passages through a face keep their distance has no more. If
  // lines do not stop, the spacing takes the place of this distance, and the bound is a budget.
  std::size_t piece_bound(const Patch& patch) const
  {
    const double apart = m_options.least_distance > 0 ? m_options.least_distance : m_options.spacing;
    double bound = 1000;
    for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
      bound += 4 + 2 * (std::max)({ m_charts.length(3 * f), m_charts.length(3 * f + 1), m_charts.length(3 * f + 2) })
                     / apart;
    return static_cast<std::size_t>((std::min)(bound, 1e15));
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

  // Where in a piece samples are needed: outside its free interval, and within it in the intervals in which a line may
  // be near.
  struct Piece_to_sample
  {
    Length_interval free{ 1, 0 };
    std::vector<Length_interval> near;

    // The length up to which no sample can be too near to a line; `from` if a sample at `from` might be.
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
    const double distance = m_options.least_distance * (1 + relative_streamline_tolerance);
    Piece_to_sample result;
    if(piece.length < 2 * m_options.least_distance) // a few samples are faster
      return result;
    const Chart_line chart_line(m_charts, m_directions, piece, 0);
    const double tolerance = relative_streamline_tolerance * distance;
    if(!chart_line.is_along_branch(tolerance))
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
      interval = { interval.begin - tolerance, interval.end + tolerance };
    return result;
  }

  // Samples the last piece, which begins at the length `start`, four times per least distance. If a sample is too near
  // to a line, cuts the growing line at the sample before it and returns false.
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
      if(m_distances.is_line_near(chart_point(m_charts, point), m_options.least_distance, { line, sign * sample }))
      {
        growing.cut(sample - step);
        return false;
      }
    }
    settle(growing, start - step, line, sign);
    return true;
  }

  // Adds the pieces that end at `length` or before to `m_distances`. They must not be cut off later.
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
  Streamline_options m_options;
  const Streamline_tracer& m_tracer;
  Streamline_distances& m_distances;
  std::size_t m_maximum_number_of_pieces;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_GROWTH_H
