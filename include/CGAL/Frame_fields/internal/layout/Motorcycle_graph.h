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
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Traces in one patch that start together and run at the same speed until they reach the border, or a point where a
// perpendicular trace was before. Of two that come at the same time, the one that was added later ends. Two traces that
// run against each other meet halfway and become one line.
//
// The points where traces cross have integer coordinates, so that the times are integers; no other point is needed.
// A trace enters a face not later than at the time of its entry, in the order of the heap, and is compared there with
// all traces that did so. Thus whatever happens at a time is known before anything of this time is decided.
class Motorcycle_graph
{
public:
  // Every sector with `has_ports` ends the traces that come to it.
  Motorcycle_graph(const Seamless_charts& charts, const Patch& patch, const std::vector<char>& has_ports)
    : m_charts(charts), m_surface(charts.surface()), m_patch(patch), m_has_ports(has_ports)
    , m_first_in_face(patch.faces.size(), -1), m_first_at_vertex(patch.sectors.size(), -1)
    , m_maximum_number_of_segments(100000 + 256 * static_cast<std::size_t>(patch.faces.size()))
    , m_maximum_number_of_comparisons(1000 * m_maximum_number_of_segments) {}

  const std::vector<Trace>& traces() const { return m_traces; }
  const std::vector<Trace_segment>& segments() const { return m_segments; }
  const std::vector<Trace_passing>& passings() const { return m_passings; }

  void add_trace(const int sector, const Port& port)
  {
    const Grid_ray ray = { port.direction, m_charts.point(port.corner) };
    m_traces.push_back(Trace{ vertex_location(sector), port.slot, m_round });
    m_fronts.push_back({ -1, -1, ray });
    leave_vertex(static_cast<int>(m_traces.size()) - 1, port.corner);
  }

  // A trace from a point that is no vertex, in the chart of `start.face`.
  void add_trace(const T_mesh_location& start, const int direction)
  {
    m_traces.push_back(Trace{ start, direction, m_round });
    m_fronts.push_back({ start.face, -1, { direction, start.point } });
    leave_point(static_cast<int>(m_traces.size()) - 1);
  }

  // Runs until all traces have ended. Returns false if the map cannot be a certified one, or if the traces need more
  // than 100,000 segments and 256 per face, or a thousand times as many comparisons.
  bool run()
  {
    while(!m_heap.empty() && m_is_valid)
    {
      std::pop_heap(m_heap.begin(), m_heap.end(), Later());
      const Event event = m_heap.back();
      m_heap.pop_back();
      if(event.kind == ADVANCE)
        advance(event.trace, event.double_time);
      else if(event.kind == MEET)
        meet(event);
      else
        cross(event);
    }
    ++m_round;
    return m_is_valid;
  }

private:
  enum Kind { ADVANCE, MEET, CROSS };

  struct Event
  {
    std::int64_t double_time;
    Kind kind;
    int trace;         // the one that comes later, if two cross
    int other;
    std::int64_t time, time_of_other; // with CROSS
    int slot, slot_of_other;
    T_mesh_location location;
  };

  struct Later
  {
    static std::tuple<std::int64_t, int, int, int> key(const Event& e)
    {
      return std::make_tuple(e.double_time, static_cast<int>(e.kind), e.trace, e.other);
    }
    bool operator()(const Event& a, const Event& b) const { return key(a) > key(b); }
  };

  // Where a trace goes next: into a face, or to the vertex of a corner.
  struct Front
  {
    int face, corner; // one of them is -1
    Grid_ray ray;     // in the chart of that face, or of that of the corner
  };

  struct Arrival
  {
    int trace;
    std::int64_t time;
    int direction; // in the chart of the first corner
    int next;
  };

  T_mesh_location vertex_location(const int sector) const
  {
    const int corner = m_surface.first_corner[sector];
    return { sector, -1, face_of(corner), m_charts.point(corner) };
  }

  void push(const Event& event)
  {
    m_heap.push_back(event);
    std::push_heap(m_heap.begin(), m_heap.end(), Later());
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
    const Front& front = m_fronts[trace];
    const int corner = front.corner, sector = m_surface.sector[corner];
    const std::int64_t time = front.ray.time(m_charts.point(corner));
    if(m_has_ports[sector - m_patch.sectors.begin_index])
      m_is_valid = false; // the trace that left by this port should have met it
    else if(m_surface.is_constrained_sector(sector))
      end_on_border(trace, time, vertex_location(sector));
    else
    {
      register_at_vertex(trace, corner, time);
      leave_vertex(trace, corner);
    }
  }

  // Starts or goes on from the vertex of a corner, in the direction of the front.
  void leave_vertex(const int trace, int corner)
  {
    Grid_ray ray = m_fronts[trace].ray;
    corner = m_charts.turn_to_direction(corner, ray);
    if(corner < 0)
    {
      m_is_valid = false;
      return;
    }
    const int halfedge = next_of(corner);
    m_fronts[trace] = { face_of(corner), -1, ray };
    if(left_of(ray.direction, m_charts.edge(halfedge)) == 0)
      run_along(trace, halfedge, ray);
    else
      cross_face(trace);
  }

  // Starts from a point inside a face or inside an edge.
  void leave_point(const int trace)
  {
    const Departure departure = m_charts.depart(m_fronts[trace].face, m_fronts[trace].ray);
    m_fronts[trace] = { departure.face, -1, departure.ray };
    if(departure.face < 0)
      m_is_valid = false;
    else if(departure.halfedge >= 0)
      run_along(trace, departure.halfedge, departure.ray);
    else
      cross_face(trace);
  }

  void run_along(const int trace, const int halfedge, const Grid_ray& ray)
  {
    const int opposite = m_surface.opposite[halfedge];
    const std::int64_t time = ray.time(m_charts.point(halfedge));
    if(opposite < 0)
    {
      m_is_valid = false;
      return;
    }
    add_segment(trace, face_of(opposite), m_charts.ray_across(halfedge, ray));
    add_segment(trace, face_of(halfedge), ray);
    link_segment(trace, static_cast<double>(time));
    go_to_vertex(trace, halfedge, ray);
  }

  // Finds where the ray of the front leaves its face, through the inside of which it runs.
  void cross_face(const int trace)
  {
    const int face = m_fronts[trace].face;
    const Grid_ray ray = m_fronts[trace].ray;
    add_segment(trace, face, ray);
    for(int halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
    {
      const std::int64_t at_source = ray.offset(m_charts.point(previous_of(halfedge)));
      const std::int64_t at_target = ray.offset(m_charts.point(halfedge));
      if(at_source < 0 && at_target > 0)
      {
        go_through_edge(trace, halfedge, ray, at_source, at_target);
        return;
      }
      if(at_target == 0 && at_source < 0 && ray.offset(m_charts.point(next_of(halfedge))) > 0)
      {
        link_segment(trace, static_cast<double>(ray.time(m_charts.point(halfedge))));
        go_to_vertex(trace, halfedge, ray);
        return;
      }
    }
    m_is_valid = false;
  }

  void go_to_vertex(const int trace, const int corner, const Grid_ray& ray)
  {
    m_fronts[trace] = { -1, corner, ray };
    push_advance(trace, 2 * ray.time(m_charts.point(corner)));
  }

  void go_through_edge(const int trace, const int halfedge, const Grid_ray& ray, const std::int64_t at_source,
                       const std::int64_t at_target)
  {
    const Grid_vector target = m_charts.point(halfedge);
    const std::int64_t time_of_target = ray.time(target);
    const std::int64_t progress = along(ray.direction, m_charts.edge(halfedge));
    if(m_surface.is_constrained(halfedge))
    {
      if(progress != 0)
      {
        m_is_valid = false;
        return;
      }
      link_segment(trace, static_cast<double>(time_of_target));
      const Grid_vector to_target = rotate({ at_target, 0 }, ray.direction + 1);
      end_on_border(trace, time_of_target, { -1, halfedge, face_of(halfedge), target - to_target });
      return;
    }
    const double share = static_cast<double>(at_target) / static_cast<double>(at_target - at_source);
    const double time = static_cast<double>(time_of_target) - share * static_cast<double>(progress);
    link_segment(trace, time);
    m_fronts[trace] = { face_of(m_surface.opposite[halfedge]), -1, m_charts.ray_across(halfedge, ray) };

    // The rounding errors are below 4 steps of the grid and 2^-50 of the time; an entry that is too early does no harm.
    const std::int64_t earliest = time_of_target - (std::max<std::int64_t>)(progress, 0);
    const std::int64_t error = 4 + static_cast<std::int64_t>(std::ldexp(std::abs(time), -50));
    push_advance(trace, 2 * (std::max)(earliest, static_cast<std::int64_t>(std::floor(time)) - error));
  }

  void push_advance(const int trace, const std::int64_t double_time)
  {
    const std::int64_t longest = std::int64_t(1) << 60;
    if(std::abs(double_time) > longest)
      m_is_valid = false;
    else
      push({ double_time, ADVANCE, trace, -1, 0, 0, 0, 0, {} });
  }

  // A bound: a perpendicular trace may end it before.
  void end_on_border(const int trace, const std::int64_t time, const T_mesh_location& location)
  {
    Trace& t = m_traces[trace];
    if(t.double_time_of_end <= 2 * time)
      return;
    t.double_time_of_end = 2 * time;
    t.end = Trace::ON_BORDER;
    t.end_on_border = location;
  }

  void add_segment(const int trace, const int face, const Grid_ray& ray)
  {
    if(m_segments.size() >= m_maximum_number_of_segments || m_number_of_comparisons > m_maximum_number_of_comparisons)
      m_is_valid = false;
    int& first = m_first_in_face[face - m_patch.faces.begin_index];
    for(int other = first; other >= 0; other = m_segments[other].next_in_face, ++m_number_of_comparisons)
      compare_in_face(face, trace, ray, m_segments[other].trace, m_segments[other].ray);
    m_segments.push_back({ trace, face, ray, 0, first, -1 });
    first = static_cast<int>(m_segments.size()) - 1;
  }

  // Appends the segment added last to its trace.
  void link_segment(const int trace, const double time_of_exit)
  {
    const int segment = static_cast<int>(m_segments.size()) - 1;
    Trace& t = m_traces[trace];
    m_segments[segment].time_of_exit = time_of_exit;
    if(t.last_segment >= 0)
      m_segments[t.last_segment].next_in_trace = segment;
    else
      t.first_segment = segment;
    t.last_segment = segment;
  }

  void compare_in_face(const int face, const int a, const Grid_ray& ray_a, const int b, const Grid_ray& ray_b)
  {
    if((ray_a.direction - ray_b.direction) % 2 == 0)
    {
      if(ray_a.direction != ray_b.direction && ray_a.offset(ray_b.origin) == 0)
        push_meeting(a, b, ray_a.time(ray_b.origin));
      return;
    }
    const Grid_vector point = ray_a.direction % 2 == 0 ? Grid_vector{ ray_b.origin.u, ray_a.origin.v }
                                                       : Grid_vector{ ray_a.origin.u, ray_b.origin.v };
    if(ray_a.time(point) <= 0 || ray_b.time(point) <= 0)
      return;
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
    if(number_of_edges > 1 || (edge >= 0 && m_surface.is_constrained(edge))) // vertices have their own lists
      return;
    int turns = 0;
    if(edge >= 0 && m_surface.opposite[edge] < edge)
    {
      location = { -1, -1, face_of(m_surface.opposite[edge]), m_charts.point_across(edge, point) };
      turns = m_charts.direction_across(edge, 0);
    }
    push_crossing({ a, ray_a.time(point), (ray_a.direction + turns) & 3, location },
                  { b, ray_b.time(point), (ray_b.direction + turns) & 3, location });
  }

  void register_at_vertex(const int trace, const int corner, const std::int64_t time)
  {
    Grid_ray ray = m_fronts[trace].ray;
    if(m_charts.turn_to_first_corner(corner, ray) < 0)
      m_is_valid = false;
    const int sector = m_surface.sector[corner];
    const T_mesh_location location = vertex_location(sector);
    int& first = m_first_at_vertex[sector - m_patch.sectors.begin_index];
    for(int other = first; other >= 0; other = m_arrivals[other].next)
    {
      const Arrival& arrival = m_arrivals[other];
      const int turn = (ray.direction - arrival.direction) & 3;
      if(turn == 2)
        push_meeting(trace, arrival.trace, time + arrival.time);
      else if(turn != 0)
        push_crossing({ trace, time, ray.direction, location },
                      { arrival.trace, arrival.time, arrival.direction, location });
    }
    m_arrivals.push_back({ trace, time, ray.direction, first });
    first = static_cast<int>(m_arrivals.size()) - 1;
  }

  // Two traces on one line, against each other; `distance` is that of their starts, negative if they run apart.
  void push_meeting(const int a, const int b, const std::int64_t distance)
  {
    if(a != b && distance > 0 && m_traces[a].round == m_traces[b].round)
      push({ distance, MEET, (std::min)(a, b), (std::max)(a, b), 0, 0, 0, 0, {} });
  }

  void push_crossing(const Trace_passing& a, const Trace_passing& b)
  {
    const auto arrival = [this](const Trace_passing& p)
    {
      return std::make_tuple(m_traces[p.trace].round, p.time, p.trace);
    };
    const bool is_a_later = arrival(a) > arrival(b);
    const Trace_passing &later = is_a_later ? a : b, &earlier = is_a_later ? b : a;
    push({ 2 * later.time, CROSS, later.trace, earlier.trace, later.time, earlier.time, later.slot, earlier.slot,
           later.location });
  }

  bool reaches(const int trace, const std::int64_t double_time) const
  {
    return m_traces[trace].double_time_of_end >= double_time;
  }

  void meet(const Event& event)
  {
    if(!reaches(event.trace, event.double_time) || !reaches(event.other, event.double_time))
      return;
    for(const auto& pair : { std::make_pair(event.trace, event.other), std::make_pair(event.other, event.trace) })
    {
      Trace& trace = m_traces[pair.first];
      trace.double_time_of_end = event.double_time;
      trace.end = Trace::MEETS_TRACE;
      trace.partner = pair.second;
    }
  }

  void cross(const Event& event)
  {
    if(!reaches(event.trace, 2 * event.time) || !reaches(event.other, 2 * event.time_of_other))
      return;
    m_passings.push_back({ event.trace, event.time, event.slot, event.location });
    m_passings.push_back({ event.other, event.time_of_other, event.slot_of_other, event.location });
    Trace& later = m_traces[event.trace];
    if(later.double_time_of_end > 2 * event.time)
    {
      later.double_time_of_end = 2 * event.time;
      later.end = Trace::ON_TRACE;
    }
  }

  const Seamless_charts& m_charts;
  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<char>& m_has_ports; // per sector of the patch
  std::vector<Trace> m_traces;
  std::vector<Front> m_fronts;          // per trace
  std::vector<Trace_segment> m_segments;
  std::vector<int> m_first_in_face;     // per face of the patch: the last segment added
  std::vector<Arrival> m_arrivals;
  std::vector<int> m_first_at_vertex;   // per sector of the patch: the last arrival
  std::vector<Trace_passing> m_passings;
  std::vector<Event> m_heap;
  std::size_t m_maximum_number_of_segments, m_maximum_number_of_comparisons, m_number_of_comparisons = 0;
  int m_round = 0;
  bool m_is_valid = true;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MOTORCYCLE_GRAPH_H
