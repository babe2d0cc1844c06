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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MOTORCYCLE_GRAPH_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MOTORCYCLE_GRAPH_H

#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/Trace.h>
#include <CGAL/Frame_fields/internal/layout/Trace_encounters.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Traces in one patch that start together and run at the same speed until they reach the border, or a point where a
// perpendicular trace was before. Two traces that run against each other meet halfway and become one line.
//
// The points where traces cross have integer coordinates, so that the times are integers; no other point is needed.
// The queue lets a trace into a face at the time of its entry or before. The trace is then compared with all traces
// that are in the face already. Thus all events of a time are in the queue before the first trace is ended at this
// time.
class Motorcycle_graph
{
public:
  // A crossing is stored twice, once for each of its two traces.
  typedef std::pair<Trace_passing, T_mesh_location> Crossing;

  Motorcycle_graph(const Seamless_charts& charts, const Patch& patch)
    : m_charts(charts), m_surface(charts.surface()), m_patch(patch), m_encounters(charts, patch, m_traces, m_queue)
    , m_has_ports(patch.sectors.size(), 0) {}

  Motorcycle_graph(const Motorcycle_graph&) = delete; // its parts refer to each other
  Motorcycle_graph& operator=(const Motorcycle_graph&) = delete;

  const std::vector<Trace>& traces() const { return m_traces; }
  const std::vector<Trace_segment>& segments() const { return m_encounters.segments(); }
  const std::vector<Crossing>& crossings() const { return m_crossings; }

  void add_trace(const int sector, const Port& port)
  {
    m_has_ports[sector - m_patch.sectors.begin_index] = 1;
    m_traces.push_back(Trace{ sector, port.slot });
    m_fronts.push_back({ -1, port.corner, { port.direction, m_charts.point(port.corner) } });
  }

  // Runs until all traces have ended. Returns false if the map cannot be a certified one, or if the traces need too
  // much room. With S = 100,000 + 256 times the number of faces, the bounds are S segments, 100 S comparisons and 10 S
  // events.
  bool run()
  {
    for(int trace = 0; trace < static_cast<int>(m_traces.size()); ++trace)
      leave_vertex(trace);
    while(!m_queue.empty() && m_is_valid && has_room())
    {
      const Trace_event event = m_queue.pop();
      if(event.kind == Trace_event::ADVANCE)
        advance(event.later.trace, event.double_time);
      else if(event.kind == Trace_event::MEET)
        meet(event);
      else
        cross(event);
    }
    return m_is_valid && m_queue.empty();
  }

private:
  // Where a trace goes next: into a face, or to the vertex of a corner.
  struct Front
  {
    int face, corner; // one of them is -1
    Grid_ray ray;     // in the chart of that face, or of that of the corner
  };

  bool has_room() const
  {
    const std::size_t segments = 100000 + 256 * static_cast<std::size_t>(m_patch.faces.size());
    return m_encounters.segments().size() <= segments && m_encounters.number_of_comparisons() <= 100 * segments
        && m_queue.number_of_events() <= 10 * segments;
  }

  void advance(const int trace, const std::int64_t double_time)
  {
    if(double_time >= m_traces[trace].double_time_of_end)
      return;
    if(m_fronts[trace].corner >= 0)
      arrive_at_vertex(trace);
    else
      cross_face(trace);
  }

  void arrive_at_vertex(const int trace)
  {
    const int corner = m_fronts[trace].corner, sector = m_surface.sector[corner];
    Grid_ray ray = m_fronts[trace].ray;
    const std::int64_t time = ray.time(m_charts.point(corner));
    const int first_corner = m_surface.first_corner[sector];
    const T_mesh_location vertex = { sector, -1, face_of(first_corner), m_charts.point(first_corner) };
    if(m_has_ports[sector - m_patch.sectors.begin_index])
      m_is_valid = false; // the trace that left by this port should have met it
    else if(m_surface.is_constrained_sector(sector))
      end_on_border(trace, time, vertex);
    else if(m_charts.turn_to_first_corner(corner, ray) < 0)
      m_is_valid = false;
    else
    {
      m_encounters.add_arrival(sector, vertex, { trace, time, ray.direction });
      leave_vertex(trace);
    }
  }

  // Starts or goes on from the vertex of a corner, in the direction of the front.
  void leave_vertex(const int trace)
  {
    Grid_ray ray = m_fronts[trace].ray;
    const int corner = m_charts.turn_to_direction(m_fronts[trace].corner, ray);
    if(corner < 0)
    {
      m_is_valid = false;
      return;
    }
    m_fronts[trace] = { face_of(corner), -1, ray };
    if(left_of(ray.direction, m_charts.edge(next_of(corner))) == 0)
      run_along(trace, next_of(corner), ray);
    else
      cross_face(trace);
  }

  void run_along(const int trace, const int halfedge, const Grid_ray& ray)
  {
    const int opposite = m_surface.opposite[halfedge];
    if(opposite < 0)
    {
      m_is_valid = false;
      return;
    }
    m_encounters.add_segment(trace, face_of(opposite), m_charts.ray_across(halfedge, ray));
    m_encounters.add_segment(trace, face_of(halfedge), ray);
    go_to_vertex(trace, halfedge, ray);
  }

  // Finds where the ray of the front leaves its face, through the inside of which it runs.
  void cross_face(const int trace)
  {
    const int face = m_fronts[trace].face;
    const Grid_ray ray = m_fronts[trace].ray;
    m_encounters.add_segment(trace, face, ray);
    for(int halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
    {
      const std::int64_t at_source = ray.offset(m_charts.point(previous_of(halfedge)));
      const std::int64_t at_target = ray.offset(m_charts.point(halfedge));
      if(at_source < 0 && at_target > 0)
      {
        go_through_edge(trace, halfedge, ray, at_source, at_target);
        return;
      }
      if(at_source < 0 && at_target == 0 && ray.offset(m_charts.point(next_of(halfedge))) > 0)
      {
        go_to_vertex(trace, halfedge, ray);
        return;
      }
    }
    m_is_valid = false;
  }

  void go_to_vertex(const int trace, const int corner, const Grid_ray& ray)
  {
    const std::int64_t time = ray.time(m_charts.point(corner));
    link_segment(trace, static_cast<double>(time));
    m_fronts[trace] = { -1, corner, ray };
    push_advance(trace, time);
  }

  void go_through_edge(const int trace, const int halfedge, const Grid_ray& ray, const std::int64_t at_source,
                       const std::int64_t at_target)
  {
    const Grid_vector target = m_charts.point(halfedge);
    const std::int64_t time_of_target = ray.time(target);
    const std::int64_t progress = along(ray.direction, m_charts.edge(halfedge));
    if(m_surface.is_constrained(halfedge))
    {
      const Grid_vector to_target = rotate({ at_target, 0 }, ray.direction + 1);
      link_segment(trace, static_cast<double>(time_of_target));
      end_on_border(trace, time_of_target, { -1, halfedge, face_of(halfedge), target - to_target });
      m_is_valid = m_is_valid && progress == 0;
      return;
    }
    const double share = static_cast<double>(at_target) / static_cast<double>(at_target - at_source);
    const double time = static_cast<double>(time_of_target) - share * static_cast<double>(progress);
    link_segment(trace, time);
    m_fronts[trace] = { face_of(m_surface.opposite[halfedge]), -1, m_charts.ray_across(halfedge, ray) };

    // The rounding errors are below 4 steps of the grid and 2^-50 of the time; an entry that is too early does no harm.
    const std::int64_t earliest = time_of_target - (std::max<std::int64_t>)(progress, 0);
    const std::int64_t error = 4 + static_cast<std::int64_t>(std::ldexp(std::abs(time), -50));
    push_advance(trace, (std::max)(earliest, static_cast<std::int64_t>(std::floor(time)) - error));
  }

  void push_advance(const int trace, const std::int64_t time)
  {
    const std::int64_t longest = std::int64_t(1) << 58;
    if(std::abs(time) > longest)
      m_is_valid = false;
    else
      m_queue.push({ 2 * time, Trace_event::ADVANCE, { trace, 0, 0 }, { -1, 0, 0 }, {} });
  }

  // Appends the segment added last to its trace.
  void link_segment(const int trace, const double time_of_exit)
  {
    const int segment = static_cast<int>(m_encounters.segments().size()) - 1;
    Trace& t = m_traces[trace];
    m_encounters.segments()[segment].time_of_exit = time_of_exit;
    if(t.last_segment >= 0)
      m_encounters.segments()[t.last_segment].next_in_trace = segment;
    else
      t.first_segment = segment;
    t.last_segment = segment;
  }

  // The trace cannot go further, but a perpendicular one may end it before.
  void end_on_border(const int trace, const std::int64_t time, const T_mesh_location& location)
  {
    Trace& t = m_traces[trace];
    if(t.double_time_of_end <= 2 * time)
      return;
    t.double_time_of_end = 2 * time;
    t.end = Trace::ON_BORDER;
    t.end_on_border = location;
  }

  void meet(const Trace_event& event)
  {
    Trace &a = m_traces[event.later.trace], &b = m_traces[event.earlier.trace];
    if(!a.reaches(event.double_time) || !b.reaches(event.double_time))
      return;
    a.double_time_of_end = b.double_time_of_end = event.double_time;
    a.end = b.end = Trace::MEETS_TRACE;
    a.partner = event.earlier.trace;
    b.partner = event.later.trace;
  }

  void cross(const Trace_event& event)
  {
    Trace& later = m_traces[event.later.trace];
    if(!later.reaches(2 * event.later.time) || !m_traces[event.earlier.trace].reaches(2 * event.earlier.time))
      return;
    m_crossings.emplace_back( event.later, event.location );
    m_crossings.emplace_back( event.earlier, event.location );
    if(later.double_time_of_end > 2 * event.later.time)
    {
      later.double_time_of_end = 2 * event.later.time;
      later.end = Trace::ON_TRACE;
    }
  }

  const Seamless_charts& m_charts;
  const Cut_surface& m_surface;
  const Patch& m_patch;
  std::vector<Trace> m_traces;
  Trace_event_queue m_queue;
  Trace_encounters m_encounters;
  std::vector<Front> m_fronts;     // per trace
  std::vector<Crossing> m_crossings;
  std::vector<char> m_has_ports;   // per sector of the patch
  bool m_is_valid = true;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MOTORCYCLE_GRAPH_H
