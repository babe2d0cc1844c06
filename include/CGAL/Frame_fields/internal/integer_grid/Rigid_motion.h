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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_RIGID_MOTION_H
#define CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_RIGID_MOTION_H

#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A number of quarter turns about the origin, followed by a translation. It takes the points of one chart to another.
struct Rigid_motion
{
  int quarter_turns = 0; // 0 to 3
  Grid_vector shift = { 0, 0 };

  Grid_vector operator()(const Grid_vector& p) const { return rotate(p, quarter_turns) + shift; }
};

// First `b`, then `a`.
inline Rigid_motion operator*(const Rigid_motion& a, const Rigid_motion& b)
{
  return { (a.quarter_turns + b.quarter_turns) & 3, a(b.shift) };
}

inline Rigid_motion inverse(const Rigid_motion& a)
{
  const int back = (4 - a.quarter_turns) & 3;
  return { back, rotate(Grid_vector{ 0, 0 } - a.shift, back) };
}

inline Rigid_motion turning(const int quarter_turns) { return { quarter_turns & 3, { 0, 0 } }; }

inline bool operator==(const Rigid_motion& a, const Rigid_motion& b)
{
  return a.quarter_turns == b.quarter_turns && a.shift == b.shift;
}

// The motion from the chart of the face of an unconstrained halfedge to the chart on its other side.
inline Rigid_motion motion_across(const Seamless_charts& charts, const int halfedge)
{
  return { charts.direction_across(halfedge, 0), charts.point_across(halfedge, { 0, 0 }) };
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_RIGID_MOTION_H
