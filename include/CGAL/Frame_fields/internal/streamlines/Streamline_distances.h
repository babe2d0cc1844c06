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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_DISTANCES_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_DISTANCES_H

#include <CGAL/Frame_fields/internal/streamlines/Branch_directions.h>
#include <CGAL/Frame_fields/internal/streamlines/Face_neighborhood.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_tracer.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A place on a streamline: the number of the line, and the length traced from the seed to there. The length is negative
// where the line was traced against the branch of its seed.
struct Streamline_place
{
  int line;
  double arc;
};

// A part of a piece of a streamline in the chart of its face: from `begin` to `end` along the axis of branch 0 or 1, at
// `offset` to the left of this axis.
struct Streamline_part
{
  double offset, begin, end, arc_at_begin, arc_at_end;
  int line;
};

// The streamlines of a patch, for questions of what is near. Pieces of one branch pair in one face are parallel, so
// they are sorted by their offsets. To add a piece takes time linear in the number of parts of its face and branch
// pair.
class Streamline_distances
{
public:
  Streamline_distances(const Face_charts& charts, const Branch_directions& directions, const Patch& patch,
                       Face_neighborhood& neighborhood)
    : m_charts(charts), m_directions(directions), m_neighborhood(neighborhood), m_first_face(patch.faces.begin_index)
    , m_parts(2 * static_cast<std::size_t>(patch.faces.size()))
  {}

  // The arc is that of `place` at the start of the piece and grows along it, or falls if `sign` is -1. Where a piece
  // slides along an edge it is cut into parts that deviate from the branch by less than `tolerance`.
  void add(const Streamline_piece& piece, const Streamline_place& place, const double sign, const double tolerance)
  {
    const Plane_vector axis = m_directions.direction(piece.face, piece.branch % 2);
    const Plane_vector from = m_charts.place(piece.face, piece.from);
    const Plane_vector way = m_charts.place(piece.face, piece.to) - from;
    const int number_of_parts = 1 + static_cast<int>(std::abs(cross(axis, way)) / tolerance);
    std::vector<Part>& parts = parts_of(piece.face, piece.branch);
    const auto part = [&](const int i)
    {
      const double s = static_cast<double>(i) / number_of_parts, t = static_cast<double>(i + 1) / number_of_parts;
      const Plane_vector a = from + s * way, b = from + t * way;
      Part result{ cross(axis, 0.5 * (a + b)), dot(axis, a), dot(axis, b), place.arc + sign * s * piece.length,
                   place.arc + sign * t * piece.length, place.line };
      if(result.begin > result.end)
      {
        std::swap(result.begin, result.end);
        std::swap(result.arc_at_begin, result.arc_at_end);
      }
      return result;
    };
    if(number_of_parts == 1)
    {
      const Part whole = part(0);
      parts.insert(std::upper_bound(parts.begin(), parts.end(), whole.offset, Is_left_of()), whole);
      return;
    }
    const auto number_of_others = static_cast<std::ptrdiff_t>(parts.size());
    for(int i = 0; i < number_of_parts; ++i)
      parts.push_back(part(i));
    std::stable_sort(parts.begin() + number_of_others, parts.end(), Is_left_of());
    std::inplace_merge(parts.begin(), parts.begin() + number_of_others, parts.end(), Is_left_of());
  }

  // Whether a line of the branch pair at a point is nearer to it than `distance`. Of the line of `place` itself, only
  // those parts count that the point lies beside and that were not traced just before.
  bool is_line_near(const Chart_point& point, const double distance, const Streamline_place& place)
  {
    bool is_near = false;
    m_neighborhood.walk(point, distance, [&](const Chart_point& p)
    {
      is_near = is_part_near(p, distance, place);
      return !is_near;
    });
    return is_near;
  }

  // Calls `visit(part, reach)` for the parts in a face, of a branch pair, that are nearer than `distance` to a line at
  // `offset` along it: each is so from `reach` before its begin to `reach` beyond its end.
  template <typename Visit>
  void for_each_near_part(const int face, const int branch, const double offset, const double distance,
                          const Visit& visit) const
  {
    const std::vector<Streamline_part>& parts = m_parts[number_of_list(face, branch)];
    for(auto part = std::upper_bound(parts.begin(), parts.end(), offset - distance, Is_left_of());
        part != parts.end() && part->offset < offset + distance; ++part)
      visit(*part, std::sqrt((std::max)(0., distance * distance - (part->offset - offset) * (part->offset - offset))));
  }

private:
  typedef Streamline_part Part;

  struct Is_left_of
  {
    bool operator()(const Part& part, const double offset) const { return part.offset < offset; }
    bool operator()(const double offset, const Part& part) const { return offset < part.offset; }
    bool operator()(const Part& a, const Part& b) const { return a.offset < b.offset; }
  };

  std::size_t number_of_list(const int face, const int branch) const
  {
    return 2 * static_cast<std::size_t>(face - m_first_face) + branch % 2;
  }

  std::vector<Part>& parts_of(const int face, const int branch) { return m_parts[number_of_list(face, branch)]; }

  bool is_part_near(const Chart_point& point, const double distance, const Streamline_place& place)
  {
    const Plane_vector axis = m_directions.direction(point.face, point.branch % 2);
    const double offset = cross(axis, point.place), along = dot(axis, point.place);
    const std::vector<Part>& parts = parts_of(point.face, point.branch);
    for(auto part = std::upper_bound(parts.begin(), parts.end(), offset - distance, Is_left_of());
        part != parts.end() && part->offset < offset + distance; ++part)
    {
      const double nearest = (std::min)(part->end, (std::max)(part->begin, along));
      if(std::hypot(nearest - along, part->offset - offset) < distance
         && (part->line != place.line || is_beside_earlier_part(*part, along, distance, place.arc)))
        return true;
    }
    return false;
  }

  // Whether a point lies beside a part of its own line and the lengths traced up to both differ by more than three
  // distances. If the ends of parts counted, a line that comes back to its start would stop before it closes.
  static bool is_beside_earlier_part(const Part& part, const double along, const double distance, const double arc)
  {
    if(!(part.begin < along && along < part.end))
      return false;
    const double t = (along - part.begin) / (part.end - part.begin);
    return std::abs((1 - t) * part.arc_at_begin + t * part.arc_at_end - arc) > 3 * distance;
  }

  const Face_charts& m_charts;
  const Branch_directions& m_directions;
  Face_neighborhood& m_neighborhood;
  int m_first_face;
  std::vector<std::vector<Part> > m_parts; // per face of the patch and branch pair
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_DISTANCES_H
