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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_BRANCH_DIRECTIONS_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_BRANCH_DIRECTIONS_H

#include <CGAL/Frame_fields/internal/field/branch_pairs.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The four branches of each face as unit vectors of its chart, and how they continue in the neighboring faces: a field
// in the form that is used to trace streamlines.
class Branch_directions
{
public:
  Branch_directions(const Cut_surface& surface, const std::vector<double>& alpha, const std::vector<double>& rho,
                    const std::vector<int>& matching)
    : m_matching(surface.number_of_halfedges(), 0), m_is_end(surface.number_of_sectors())
  {
    m_direction.reserve(2 * alpha.size());
    for(int f = 0; f < surface.number_of_faces(); ++f)
      for(int b = 0; b < 2; ++b)
      {
        const double angle = branch_angle(alpha, rho, f, b);
        m_direction.push_back({ std::cos(angle), std::sin(angle) });
      }
    for(int e = 0; e < surface.number_of_dual_edges(); ++e)
    {
      const int p = (matching[e] % 4 + 4) % 4;
      m_matching[surface.dual_edges[e].halfedge] = p;
      m_matching[surface.dual_edges[e].opposite] = (4 - p) % 4;
    }
    find_ends(surface, matching);
    label_pairs(surface);
  }

  Plane_vector direction(const int face, const int branch) const
  {
    const Plane_vector& v = m_direction[2 * static_cast<std::size_t>(face) + branch % 2];
    return branch < 2 ? v : -v;
  }

  // The branch (0 to 3) of the face on the other side of a halfedge that continues `branch` of the halfedge's face. The
  // halfedge must not be constrained.
  int branch_across(const int halfedge, const int branch) const { return (branch + m_matching[halfedge]) % 4; }

  // Whether streamlines end in a sector: it is singular or on a constrained edge.
  bool is_end(const int sector) const { return m_is_end[sector]; }

  // The branch pair in a labelling of the pairs of a patch that is as consistent as its singularities allow.
  int pair_label(const int face, const int branch) const { return (branch + m_swaps_pairs[face]) % 2; }

private:
  // The index of a sector that is not on a constrained edge follows from the matching alone: the angles of the frames
  // cancel out.
  void find_ends(const Cut_surface& surface, const std::vector<int>& matching)
  {
    std::vector<double> turning(surface.number_of_sectors(), 0);
    for(int e = 0; e < surface.number_of_dual_edges(); ++e)
    {
      const double r = surface.transport[e] + matching[e] * CGAL_PI / 2;
      turning[surface.sector[surface.dual_edges[e].halfedge]] += r;
      turning[surface.sector[surface.dual_edges[e].opposite]] -= r;
    }
    for(int s = 0; s < surface.number_of_sectors(); ++s)
      m_is_end[s] = surface.is_constrained_sector(s)
                    || std::abs(turning[s] - surface.total_angle[s] + 2 * CGAL_PI) > CGAL_PI / 4;
  }

  // Calls `visit(h)` for the halfedges by which a breadth-first search from the faces of `queue` gets to the faces of
  // their patches that are not reached yet. Returns the face that it reaches last. `queue` must not be empty.
  template <typename Visit>
  static int search(const Cut_surface& surface, std::vector<int> queue, std::vector<bool>& is_reached,
                    const Visit& visit)
  {
    for(const int f : queue)
      is_reached[f] = true;
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h)
        if(!surface.is_constrained(h) && !is_reached[face_of(surface.opposite[h])])
        {
          is_reached[face_of(surface.opposite[h])] = true;
          visit(h);
          queue.push_back(face_of(surface.opposite[h]));
        }
    return queue.back();
  }

  // Labels spread from a first face, and the seams where they change run away from it. The first face is farthest from
  // the constrained edges, so that seams run from singularities to the constrained edges, mostly a short way.
  void label_pairs(const Cut_surface& surface)
  {
    m_swaps_pairs.assign(surface.number_of_faces(), 0);
    std::vector<bool> is_reached(surface.number_of_faces(), false), is_labelled = is_reached;
    for(const Patch& patch : surface.patches)
    {
      std::vector<int> rim;
      for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
        if(surface.is_constrained(3 * f) || surface.is_constrained(3 * f + 1) || surface.is_constrained(3 * f + 2))
          rim.push_back(f);
      const int middle = rim.empty() ? patch.faces.begin_index : search(surface, rim, is_reached, [](int) {});
      search(surface, { middle }, is_labelled, [&](const int h)
      {
        m_swaps_pairs[face_of(surface.opposite[h])] = (m_swaps_pairs[face_of(h)] + m_matching[h]) % 2;
      });
    }
  }

  std::vector<Plane_vector> m_direction; // per face: of branches 0 and 1
  std::vector<int> m_matching;           // per halfedge, 0 to 3
  std::vector<char> m_is_end;            // per sector
  std::vector<char> m_swaps_pairs;       // per face
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_BRANCH_DIRECTIONS_H
