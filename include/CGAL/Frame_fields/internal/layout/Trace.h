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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_TRACE_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_TRACE_H

#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where a trace ends or crosses another one: at the vertex of a sector, on a constrained halfedge, or at another point.
// A point on an unconstrained edge is always given in the same one of the two charts.
struct T_mesh_location
{
  int sector;   // -1 elsewhere
  int halfedge; // -1 elsewhere
  int face;
  Grid_vector point;
};

// A line of constant u or v from a port to where it ends. It advances by one unit of length in a unit of time.
struct Trace
{
  enum End { OPEN, ON_TRACE, ON_BORDER, MEETS_TRACE };

  int start_sector, start_slot;
  std::int64_t double_time_of_end = (std::numeric_limits<std::int64_t>::max)(); // twice the time, which may be a half
  End end = OPEN;
  int partner = -1;                   // the trace that it meets
  T_mesh_location end_on_border = {};
  int first_segment = -1, last_segment = -1;

  bool reaches(const std::int64_t double_time) const { return double_time_of_end >= double_time; }
};

// The part of a trace in a face, or along an edge, which is a segment in both faces.
struct Trace_segment
{
  int trace, face;
  Grid_ray ray;             // the trace in the chart of the face
  double time_of_exit = 0;
  int next_in_trace = -1;
};

// A trace at a point where it crosses another one.
struct Trace_passing
{
  int trace;
  std::int64_t time;
  int slot; // its direction there
};

// What happens at a time. Two traces that run against each other meet; one that comes to a point where a perpendicular
// one is or was crosses it.
struct Trace_event
{
  enum Kind { ADVANCE, MEET, CROSS };

  std::int64_t double_time;
  Kind kind;
  Trace_passing later, earlier; // only `later.trace` with ADVANCE, only the traces with MEET
  T_mesh_location location;     // with CROSS
};

// The events in the order of their times. At equal times, advances come before meetings and meetings before crossings:
// all traces have advanced up to a time before any trace is ended at it.
class Trace_event_queue
{
public:
  bool empty() const { return m_heap.empty(); }
  std::size_t number_of_events() const { return m_number_of_events; }

  void push(const Trace_event& event)
  {
    ++m_number_of_events;
    m_heap.push_back(event);
    std::push_heap(m_heap.begin(), m_heap.end(), is_after);
  }

  Trace_event pop()
  {
    std::pop_heap(m_heap.begin(), m_heap.end(), is_after);
    const Trace_event event = m_heap.back();
    m_heap.pop_back();
    return event;
  }

private:
  static bool is_after(const Trace_event& a, const Trace_event& b)
  {
    return std::make_tuple(a.double_time, static_cast<int>(a.kind), a.later.trace, a.earlier.trace)
         > std::make_tuple(b.double_time, static_cast<int>(b.kind), b.later.trace, b.earlier.trace);
  }

  std::vector<Trace_event> m_heap;
  std::size_t m_number_of_events = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_TRACE_H
