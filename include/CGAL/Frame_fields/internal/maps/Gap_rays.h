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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_GAP_RAYS_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_GAP_RAYS_H

#include <CGAL/Frame_fields/internal/maps/Border_chains.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Measures how far the borders of a patch are from one another: straight rays start perpendicular to a border and cross
// unfolded triangles until they meet a border. Where that is a chain that shares a corner with the first one, the two
// simply meet there, and nothing is measured.
class Gap_rays
{
public:
  Gap_rays(const Cut_surface& surface, const Surface_embedding& embedding)
    : m_surface(surface), m_embedding(embedding), m_chains(surface)
  {}

  // Calls `visit(vertex, gap)` for the vertices that are beside a gap that is not above `maximum_gap`, or in it: the
  // ends of the edges at both ends of each ray, and the vertices of its triangles that are no farther from it than the
  // gap is wide. The rays that start at an edge are not farther apart than `spacing`.
  template <typename Visit>
  void for_each_gap(const double maximum_gap, const double spacing, const Visit& visit)
  {
    const double maximum_number_of_rays = 64; // of an edge
    for(int h = 0; h < m_surface.number_of_halfedges(); ++h)
    {
      if(!m_surface.is_constrained(h))
        continue;
      const double wanted = std::ceil(m_surface.length[h] / spacing);
      const int number = static_cast<int>((std::max)(1., (std::min)(maximum_number_of_rays, wanted)));
      for(int i = 0; i < number; ++i)
        if(const double gap = gap_at(h, (i + 0.5) / number, maximum_gap); gap <= maximum_gap)
          for(const Passed_vertex& passed : m_passed)
            if(passed.offset <= gap)
              visit(passed.vertex, gap);
    }
  }

private:
  struct Passed_vertex
  {
    int vertex;
    double offset; // from the ray
  };

  // The length of the ray from a point of a border halfedge, at the given fraction of it; infinite if it ends nowhere.
  // Collects the vertices that it passes.
  double gap_at(const int start, const double fraction, const double maximum_gap)
  {
    const int maximum_number_of_faces = 4096;
    const double infinity = std::numeric_limits<double>::infinity();
    const double start_length = m_surface.length[start];
    Plane_vector left{ -fraction * start_length, 0 }, right{ (1 - fraction) * start_length, 0 };
    m_passed.clear();
    pass(previous_of(start), 0);
    pass(start, 0);
    int h = start; // from `left` to `right`; the ray is the y-axis
    for(int i = 0; i < maximum_number_of_faces; ++i)
    {
      const Plane_vector apex = apex_of(h, left, right);
      pass(next_of(h), std::abs(apex.x));
      const bool leaves_by_left_side = apex.x >= 0;
      (leaves_by_left_side ? right : left) = apex;
      const int exit = leaves_by_left_side ? previous_of(h) : next_of(h);
      const double width = right.x - left.x;
      const double height = width > 0 ? left.y - left.x / width * (right.y - left.y) : apex.y;
      if(!(height <= maximum_gap))
        return infinity;
      if(m_surface.is_constrained(exit))
      {
        pass(exit, 0);
        pass(previous_of(exit), 0);
        return m_chains.share_corner(m_chains.chain(start), m_chains.chain(exit)) ? infinity : height;
      }
      h = m_surface.opposite[exit];
    }
    return infinity;
  }

  // The third point of the face of `halfedge`, laid out on the left of it.
  Plane_vector apex_of(const int halfedge, const Plane_vector& source, const Plane_vector& target) const
  {
    const Plane_vector back = source - target;
    const double angle = m_surface.angle[halfedge], length = std::hypot(back.x, back.y);
    const double factor = length > 0 ? m_surface.length[next_of(halfedge)] / length : 0;
    const double c = std::cos(angle), s = std::sin(angle);
    return target + factor * Plane_vector{ c * back.x + s * back.y, c * back.y - s * back.x };
  }

  void pass(const int halfedge, const double offset) { m_passed.push_back({ m_embedding.vertex[halfedge], offset }); }

  const Cut_surface& m_surface;
  const Surface_embedding& m_embedding;
  Border_chains m_chains;
  std::vector<Passed_vertex> m_passed;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_GAP_RAYS_H
