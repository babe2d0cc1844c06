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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_MAP_CERTIFICATE_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_MAP_CERTIFICATE_H

#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/quarter_turns_of_sector.h>
#include <CGAL/Frame_fields/internal/parameterization/sign_of_determinant.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Proves from the integers of a map alone that it is seamless, aligned and injective around every point of a patch, and
// has the indices of the field. Nothing is assumed of how the map was found.
class Map_certificate
{
public:
  // `branch_along` tells for each constrained halfedge which branch of its chart it must follow.
  template <typename BranchAlong>
  Map_certificate(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index,
                  const BranchAlong& branch_along, const Seamless_map& map)
    : m_surface(surface), m_patch(patch), m_index(index), m_map(map)
  {
    check_faces();
    check_edges(branch_along);
    check_sectors();
  }

  Map_status status() const
  {
    return !m_inverted_faces.empty() ? Map_status::INVERTED_FACE
         : !m_faces_of_faulty_edges.empty() ? Map_status::REVERSED_EDGE
         : !m_wrong_sectors.empty() ? Map_status::WRONG_CONE
         : Map_status::CERTIFIED;
  }

  int number_of_faults() const
  {
    return static_cast<int>(m_inverted_faces.size() + m_faces_of_faulty_edges.size() + m_wrong_sectors.size());
  }

  const std::vector<int>& inverted_faces() const { return m_inverted_faces; }
  const std::vector<int>& faces_of_faulty_edges() const { return m_faces_of_faulty_edges; }

  // Sectors that do not turn as their indices say. This is reliable only where no face around a sector is inverted.
  const std::vector<int>& wrong_sectors() const { return m_wrong_sectors; }

  // Whether the map across a dual edge is the quarter turns of the edge and a translation.
  static bool is_seamless(const Seamless_map& map, const Dual_edge& e)
  {
    const Vector here = turned(vector_along(map, e.halfedge), map.quarter_turns[e.halfedge]);
    const Vector there = vector_along(map, e.opposite);
    return here.u == -there.u && here.v == -there.v
        && ((map.quarter_turns[e.halfedge] + map.quarter_turns[e.opposite]) & 3) == 0;
  }

private:
  struct Vector
  {
    std::int64_t u, v;
  };

  static Vector vector_along(const Seamless_map& map, const int halfedge)
  {
    const int source = previous_of(halfedge);
    return { map.u[halfedge] - map.u[source], map.v[halfedge] - map.v[source] };
  }

  static Vector turned(const Vector& d, const int quarter_turns)
  {
    switch(quarter_turns)
    {
      case 0: return d;
      case 1: return { -d.v, d.u };
      case 2: return { -d.u, -d.v };
      default: return { d.v, -d.u };
    }
  }

  // The number of the quadrant of a vector; an axis belongs to the quadrant that it begins.
  static int quadrant(const Vector& d)
  {
    if(d.u > 0 && d.v >= 0)
      return 0;
    if(d.u <= 0 && d.v > 0)
      return 1;
    return d.u < 0 ? 2 : 3;
  }

  void check_faces()
  {
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
    {
      const Vector a = vector_along(m_map, 3 * f), b = vector_along(m_map, 3 * f + 1);
      if(sign_of_determinant(a.u, a.v, b.u, b.v) <= 0)
        m_inverted_faces.push_back(f);
    }
  }

  // A constrained edge must run along its branch, and the two sides of all other edges must fit.
  template <typename BranchAlong>
  void check_edges(const BranchAlong& branch_along)
  {
    for(int h = 3 * m_patch.faces.begin_index; h < 3 * m_patch.faces.end_index; ++h)
      if(m_surface.is_constrained(h))
      {
        const Vector along_u = turned(vector_along(m_map, h), (4 - branch_along(h)) & 3);
        if(!(along_u.u > 0 && along_u.v == 0))
          m_faces_of_faulty_edges.push_back(face_of(h));
      }
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
      if(!is_seamless(m_map, m_surface.dual_edges[e]))
        m_faces_of_faulty_edges.push_back(face_of(m_surface.dual_edges[e].halfedge));
  }

  // Counts how often the direction from the vertex enters another quadrant on its way around the sector. Each triangle
  // is positively oriented and turns by less than a half turn, and the whole way is a number of quarter turns.
  int quarter_turns_around(const int sector) const
  {
    int turns = 0;
    for_each_corner(m_surface.opposite, m_surface.first_corner[sector], [&](const int corner)
    {
      const Vector incoming = vector_along(m_map, corner);
      const Vector last = { -incoming.u, -incoming.v };
      turns += (quadrant(last) - quadrant(vector_along(m_map, next_of(corner)))) & 3;
    });
    return turns;
  }

  void check_sectors()
  {
    for(int s = m_patch.sectors.begin_index; s < m_patch.sectors.end_index; ++s)
      if(quarter_turns_around(s) != quarter_turns_of_sector(m_surface, m_index, s))
        m_wrong_sectors.push_back(s);
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<int>& m_index;
  const Seamless_map& m_map;
  std::vector<int> m_inverted_faces, m_faces_of_faulty_edges, m_wrong_sectors;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_MAP_CERTIFICATE_H
