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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_FACE_NEIGHBORHOOD_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_FACE_NEIGHBORHOOD_H

#include <CGAL/Frame_fields/internal/streamlines/Branch_directions.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point in the chart of a face, in the face or beyond it, and a branch of this face.
struct Chart_point
{
  int face, branch;
  Plane_vector place;
};

// Visits the faces of a patch around a point in breadth-first order without crossing constrained edges. Each face is
// laid into the plane next to the one from which it is reached; the matching carries the branch along.
class Face_neighborhood
{
public:
  Face_neighborhood(const Face_charts& charts, const Branch_directions& directions, const Patch& patch)
    : m_charts(charts), m_surface(charts.surface()), m_directions(directions), m_first_face(patch.faces.begin_index)
    , m_last_walk(patch.faces.size(), 0)
  {}

  // Calls `visit(p)` for the faces within the distance (in units of the charts), with the point and the branch as each
  // face sees them, until it returns false.
  template <typename Visit>
  void walk(const Chart_point& point, const double distance, const Visit& visit)
  {
    ++m_walk;
    m_queue.clear();
    enqueue(point);
    for(std::size_t i = 0; i < m_queue.size(); ++i)
    {
      const Chart_point p = m_queue[i];
      if(!visit(p))
        return;
      for(int h = 3 * p.face; h < 3 * p.face + 3; ++h)
        if(!m_surface.is_constrained(h) && m_last_walk[face_of(m_surface.opposite[h]) - m_first_face] != m_walk
           && m_charts.distance_to(h, p.place) < distance)
          enqueue({ face_of(m_surface.opposite[h]), m_directions.branch_across(h, p.branch),
                    m_charts.place_across(h, p.place) });
    }
  }

private:
  void enqueue(const Chart_point& point)
  {
    m_last_walk[point.face - m_first_face] = m_walk;
    m_queue.push_back(point);
  }

  const Face_charts& m_charts;
  const Cut_surface& m_surface;
  const Branch_directions& m_directions;
  int m_first_face;
  std::vector<std::size_t> m_last_walk; // per face of the patch
  std::size_t m_walk = 0;
  std::vector<Chart_point> m_queue;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_FACE_NEIGHBORHOOD_H
