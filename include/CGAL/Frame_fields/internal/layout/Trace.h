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

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where a trace starts, ends or meets another one: at the vertex of a sector, on a constrained halfedge, or at a point
// elsewhere, in the one chart that is chosen for it if it is on an edge.
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

  T_mesh_location start;
  int start_slot;
  int round; // traces of later rounds start when all earlier ones have ended
  std::int64_t double_time_of_end = (std::numeric_limits<std::int64_t>::max)(); // twice the time, which may be a half
  End end = OPEN;
  int partner = -1;               // the trace that it meets
  T_mesh_location end_on_border = {};
  int first_segment = -1, last_segment = -1;
};

// The part of a trace in a face, or along an edge, which is a segment in both faces.
struct Trace_segment
{
  int trace, face;
  Grid_ray ray;          // the trace in the chart of the face
  double time_of_exit;
  int next_in_face = -1;
  int next_in_trace = -1;
};

// A trace at a point where it meets another one.
struct Trace_passing
{
  int trace;
  std::int64_t time;
  int slot; // its direction there
  T_mesh_location location;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_TRACE_H
