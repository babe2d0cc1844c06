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

// The segments of all traces, by faces, and their arrivals at regular vertices. What is new is compared with what is
// there, and where two traces meet or cross, the event is put into the queue.
class Trace_encounters
{
public:
  Trace_encounters(const Seamless_charts& charts, const Patch& patch, const std::vector<Trace>& traces,
                   Trace_event_queue& queue)
    : m_charts(charts), m_surface(charts.surface()), m_patch(patch), m_traces(traces), m_queue(queue)
    , m_first_in_face(patch.faces.size(), -1), m_first_at_vertex(patch.sectors.size(), -1) {}

  const std::vector<Trace_segment>& segments() const { return m_segments; }
  std::vector<Trace_segment>& segments() { return m_segments; }
  std::size_t number_of_comparisons() const { return m_number_of_comparisons; }

  void add_segment(const int trace, const int face, const Grid_ray& ray)
  {
    int& first = m_first_in_face[face - m_patch.faces.begin_index];
    for(int other = first; other >= 0; other = m_segments[other].next_in_face)
      compare(face, trace, ray, m_segments[other].trace, m_segments[other].ray);
    m_segments.push_back({ trace, face, ray, 0, first, -1 });
    first = static_cast<int>(m_segments.size()) - 1;
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
    m_arrivals.push_back({ passing, first });
    first = static_cast<int>(m_arrivals.size()) - 1;
  }

private:
  void compare(const int face, const int a, const Grid_ray& ray_a, const int b, const Grid_ray& ray_b)
  {
    ++m_number_of_comparisons;
    if((ray_a.direction - ray_b.direction) % 2 != 0)
      cross_in_face(face, a, ray_a, b, ray_b);
    else if(ray_a.direction != ray_b.direction && ray_a.offset(ray_b.origin) == 0)
      push_meeting(a, b, ray_a.time(ray_b.origin));
  }

  // Vertices have their own lists. A point on an edge gets the chart of the smaller one of its halfedges.
  void cross_in_face(const int face, const int a, const Grid_ray& ray_a, const int b, const Grid_ray& ray_b)
  {
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
    push_crossing({ a, ray_a.time(point), (ray_a.direction + turns) & 3 },
                  { b, ray_b.time(point), (ray_b.direction + turns) & 3 }, location);
  }

  // Two traces on one line, against each other; `distance` is that of their starts, negative if they run apart.
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
  std::vector<int> m_first_in_face;                       // per face of the patch: the last segment added
  std::vector<std::pair<Trace_passing, int> > m_arrivals; // and the one before at the same vertex
  std::vector<int> m_first_at_vertex;                     // per sector of the patch: the last arrival
  std::size_t m_number_of_comparisons = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_TRACE_ENCOUNTERS_H
