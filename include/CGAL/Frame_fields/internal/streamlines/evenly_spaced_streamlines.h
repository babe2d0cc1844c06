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
#include <CGAL/Frame_fields/internal/streamlines/Face_neighborhood.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_distances.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_growth.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_options.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_seeds.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_tracer.h>
#include <CGAL/Frame_fields/internal/streamlines/Traced_streamline.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Fills a patch with streamlines at a given spacing. The field is aligned with the constrained edges, so these are the
// first lines. New lines begin beside existing ones, as in Jobard and Lefer, Creating evenly-spaced streamlines of
// arbitrary density, 1997, and finally in the faces that have no line near.
class Evenly_spaced_streamlines
{
public:
  Evenly_spaced_streamlines(const Face_charts& charts, const Branch_directions& directions, const Patch& patch,
                            const Streamline_options& options)
    : m_charts(charts), m_surface(charts.surface()), m_directions(directions), m_patch(patch), m_options(options)
    , m_tracer(charts, directions), m_neighborhood(charts, directions, patch)
    , m_distances(charts, directions, patch, m_neighborhood)
    , m_seeds(charts, directions, patch, options, m_tracer, m_distances)
    , m_growth(charts, directions, patch, options, m_tracer, m_distances)
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

  // The constrained edges with a branch along them, the longest ones first.
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
      if(mark(chart_point(m_charts, { edge.face, edge.branch, between(edge.from, edge.to, 0.5) }), marks))
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
        if(m_charts.area(f) > 0 && mark(chart_point(m_charts, seed), marks))
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

  // Tries to begin lines on both sides of a line, at points of it that are one spacing apart.
  void begin_lines_beside(const std::vector<Streamline_piece>& pieces)
  {
    const double length = std::accumulate(pieces.begin(), pieces.end(), 0., [](const double sum, const auto& piece)
                                          { return sum + piece.length; });
    double next = (std::min)(length, m_options.spacing) / 2, arc = 0;
    for(const Streamline_piece& piece : pieces)
    {
      while(next < arc + piece.length)
      {
        const double taken = (std::min)(m_seeds.taken_until(piece, next - arc, 1),
                                        m_seeds.taken_until(piece, next - arc, -1));
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

  void begin_line_beside(Streamline_seed seed, const double side)
  {
    const Plane_vector direction = quarter_turn(m_directions.direction(seed.face, seed.branch));
    if(m_seeds.go_straight(seed, side * direction, m_options.spacing))
      begin_line(seed);
  }

  // Adds the line through the seed unless another one is too near to it. Lines bend, so a point at the spacing from one
  // point of a line can be a little nearer to another one.
  void begin_line(const Streamline_seed& given_seed)
  {
    const Streamline_seed seed = m_seeds.moved_off_edges(given_seed);
    const int line = static_cast<int>(m_lines.size());
    if(m_distances.is_line_near(chart_point(m_charts, seed), m_seeds.nearest_seed(), { line, 0 }))
      return;
    Traced_streamline traced = m_growth.line_through(seed, line);
    if(!traced.pieces.empty())
      m_lines.push_back(std::move(traced));
  }

  const Face_charts& m_charts;
  const Cut_surface& m_surface;
  const Branch_directions& m_directions;
  const Patch& m_patch;
  Streamline_options m_options;
  Streamline_tracer m_tracer;
  Face_neighborhood m_neighborhood;
  Streamline_distances m_distances;
  Streamline_seeds m_seeds;
  Streamline_growth m_growth;
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
