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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_TRACE_ENCOUNTERS_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_TRACE_ENCOUNTERS_H

#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/Trace.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The segments of all traces, by faces, and the arrivals of traces at regular vertices. Each new segment or arrival is
// compared with the earlier ones; where two traces meet or cross, the event is put into the queue.
class Trace_encounters
{
public:
  Trace_encounters(const Seamless_charts& charts, const Patch& patch, const std::vector<Trace>& traces,
                   Trace_event_queue& queue)
    : m_charts(charts), m_surface(charts.surface()), m_patch(patch), m_traces(traces), m_queue(queue)
    , m_lines(2 * static_cast<std::size_t>(patch.faces.size())), m_first_at_vertex(patch.sectors.size(), -1) {}

  const std::vector<Trace_segment>& segments() const { return m_segments; }
  std::vector<Trace_segment>& segments() { return m_segments; }
  std::size_t number_of_comparisons() const { return m_number_of_comparisons; }

  void add_segment(const int trace, const int face, const Grid_ray& ray)
  {
    const int segment = static_cast<int>(m_segments.size());
    m_segments.push_back({ trace, face, ray });
    std::vector<Line>& parallels = lines(face, ray.direction);
    const Line line = { constant(ray), segment };
    for(auto other = first_from(parallels, line.constant);
        other != parallels.end() && other->constant == line.constant; ++other)
      compare_on_line(segment, other->segment);
    parallels.insert(std::upper_bound(parallels.begin(), parallels.end(), line), line);

    const std::pair<std::int64_t, std::int64_t> range = m_charts.range_in_face(face, ray);
    const std::vector<Line>& perpendiculars = lines(face, ray.direction + 1);
    for(auto other = first_from(perpendiculars, range.first);
        other != perpendiculars.end() && other->constant <= range.second; ++other)
      cross_in_face(segment, other->segment);
  }

  // A trace comes to the vertex of a sector in a direction of the chart of the first corner.
  void add_arrival(const int sector, const T_mesh_location& vertex, const Trace_passing& passing)
  {
    int& first = m_first_at_vertex[sector - m_patch.sectors.begin_index];
    for(int other = first; other >= 0; other = m_arrivals[other].second)
    {
      const Trace_passing& arrival = m_arrivals[other].first;
      ++m_number_of_comparisons;
      if((passing.slot - arrival.slot) % 2 != 0) // traces on one line have segments in the same faces
        push_crossing(passing, arrival, vertex);
    }
    m_arrivals.emplace_back( passing, first );
    first = static_cast<int>(m_arrivals.size()) - 1;
  }

private:
  // A segment by the coordinate that is constant on it.
  struct Line
  {
    std::int64_t constant;
    int segment;

    bool operator<(const Line& other) const
    {
      return std::make_pair(constant, segment) < std::make_pair(other.constant, other.segment);
    }
  };

  static std::int64_t constant(const Grid_ray& ray)
  {
    return ray.direction % 2 == 0 ? ray.origin.v : ray.origin.u;
  }

  static std::vector<Line>::const_iterator first_from(const std::vector<Line>& lines, const std::int64_t constant)
  {
    return std::lower_bound(lines.begin(), lines.end(), Line{ constant, -1 });
  }

  std::vector<Line>& lines(const int face, const int direction)
  {
    return m_lines[2 * static_cast<std::size_t>(face - m_patch.faces.begin_index) + direction % 2];
  }

  void compare_on_line(const int a, const int b)
  {
    ++m_number_of_comparisons;
    const Trace_segment &first = m_segments[a], &second = m_segments[b];
    if(first.ray.direction != second.ray.direction)
      push_meeting(first.trace, second.trace, first.ray.time(second.ray.origin));
  }

  // Crossings at vertices are left to `add_arrival()`. A point on an edge gets the chart of the smaller halfedge.
  void cross_in_face(const int a, const int b)
  {
    ++m_number_of_comparisons;
    const int face = m_segments[a].face;
    const Grid_ray &ray_a = m_segments[a].ray, &ray_b = m_segments[b].ray;
    const Grid_vector point = ray_a.direction % 2 == 0 ? Grid_vector{ ray_b.origin.u, ray_a.origin.v }
                                                       : Grid_vector{ ray_a.origin.u, ray_b.origin.v };
    T_mesh_location location = { -1, -1, face, point };
    int edge = -1, number_of_edges = 0;
    for(int halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
    {
      const int side = m_charts.side(halfedge, point);
      if(side < 0)
        return;
      if(side == 0)
      {
        edge = halfedge;
        ++number_of_edges;
      }
    }
    if(number_of_edges > 1 || (edge >= 0 && m_surface.is_constrained(edge)))
      return;
    int turns = 0;
    if(edge >= 0 && m_surface.opposite[edge] < edge)
    {
      location = { -1, -1, face_of(m_surface.opposite[edge]), m_charts.point_across(edge, point) };
      turns = m_charts.direction_across(edge, 0);
    }
    push_crossing({ m_segments[a].trace, ray_a.time(point), (ray_a.direction + turns) & 3 },
                  { m_segments[b].trace, ray_b.time(point), (ray_b.direction + turns) & 3 }, location);
  }

  // Two traces on one line in opposite directions. `distance` is the distance of their starts, which is twice the time
  // at which they meet; it is negative if they run apart.
  void push_meeting(const int a, const int b, const std::int64_t distance)
  {
    if(a != b && distance > 0 && m_traces[a].reaches(distance) && m_traces[b].reaches(distance))
      m_queue.push({ distance, Trace_event::MEET, { (std::min)(a, b), 0, 0 }, { (std::max)(a, b), 0, 0 }, {} });
  }

  // Of two traces that come at the same time, the one that was added later counts as the later one.
  void push_crossing(const Trace_passing& a, const Trace_passing& b, const T_mesh_location& location)
  {
    if(!m_traces[a.trace].reaches(2 * a.time) || !m_traces[b.trace].reaches(2 * b.time))
      return;
    const bool is_a_later = std::make_pair(a.time, a.trace) > std::make_pair(b.time, b.trace);
    const Trace_passing &later = is_a_later ? a : b, &earlier = is_a_later ? b : a;
    m_queue.push({ 2 * later.time, Trace_event::CROSS, later, earlier, location });
  }

  const Seamless_charts& m_charts;
  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<Trace>& m_traces;
  Trace_event_queue& m_queue;
  std::vector<Trace_segment> m_segments;
  std::vector<std::vector<Line> > m_lines;                // per face of the patch: along u and along v, sorted
  std::vector<std::pair<Trace_passing, int> > m_arrivals; // with the arrival before at the same vertex, -1 if none
  std::vector<int> m_first_at_vertex;                     // per sector of the patch: the last arrival
  std::size_t m_number_of_comparisons = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_TRACE_ENCOUNTERS_H
