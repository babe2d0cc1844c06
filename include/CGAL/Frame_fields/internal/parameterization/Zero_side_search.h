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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_ZERO_SIDE_SEARCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_ZERO_SIDE_SEARCH_H

#include <CGAL/Frame_fields/internal/parameterization/Integer_relations.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/walk_along_border.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A constrained edge in its chart: one coordinate stays, the other one must grow in the direction of `sign`.
struct Side_edge
{
  int halfedge;
  int source, target;      // vertices of the disk
  int growing_coordinate;  // 0: u, 1: v
  int sign;
};

// Looks for a side that has length 0 in all maps of a patch, or an edge of length 0. A side runs from one corner, a
// constrained sector of index other than 0, to the next one, or once around a border without corners.
class Zero_side_search
{
public:
  Zero_side_search(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index,
                   const std::vector<Side_edge>& side_edges)
    : m_surface(surface), m_index(index), m_side_edges(side_edges), m_first_halfedge(3 * patch.faces.begin_index)
    , m_place(3 * static_cast<std::size_t>(patch.faces.size()), -1)
    , m_is_added(side_edges.size(), false)
  {
    for(std::size_t i = 0; i < side_edges.size(); ++i)
      m_place[side_edges[i].halfedge - m_first_halfedge] = static_cast<int>(i);
  }

  // The sectors at the ends of the first such side; -1 if there is none. `length_of(e)` is the length of an edge as a
  // row, and `is_zero(row)` tells whether it vanishes in all maps.
  template <typename LengthOf, typename IsZero>
  std::array<int, 2> first_side(const LengthOf& length_of, const IsZero& is_zero)
  {
    std::array<int, 2> ends{ { -1, -1 } };
    const auto is_side_zero = [&](const int first) { return is_zero_side(first, length_of, is_zero, ends); };
    for(const Side_edge& e : m_side_edges)
      if(ends_side(e.halfedge) && is_side_zero(next_on_border(m_surface, e.halfedge)))
        return ends;
    for(const Side_edge& e : m_side_edges)
      if(is_side_zero(e.halfedge)) // of a border without corner
        break;
    return ends;
  }

private:
  bool ends_side(const int halfedge) const { return m_index[m_surface.sector[halfedge]] != 0; }

  // Sums the edges from `first` to the end of its side that were not visited before. Returns whether the side or one of
  // the edges has length 0 in all maps, and sets `ends` to the sectors at its ends then.
  template <typename LengthOf, typename IsZero>
  bool is_zero_side(const int first, const LengthOf& length_of, const IsZero& is_zero, std::array<int, 2>& ends)
  {
    Integer_row length;
    bool has_zero_edge = false;
    int last = first;
    for(int h = first; ; h = next_on_border(m_surface, h))
    {
      const int place = m_place[h - m_first_halfedge];
      if(m_is_added[place])
        break; // once around
      m_is_added[place] = true;
      last = h;
      const Integer_row part = length_of(m_side_edges[place]);
      length.insert(length.end(), part.begin(), part.end());
      has_zero_edge = has_zero_edge || is_zero(part);
      if(ends_side(h))
        break;
    }
    if(length.empty() || !(has_zero_edge || is_zero(length)))
      return false;
    ends = { { m_surface.sector[previous_of(first)], m_surface.sector[last] } };
    return true;
  }

  const Cut_surface& m_surface;
  const std::vector<int>& m_index;
  const std::vector<Side_edge>& m_side_edges;
  int m_first_halfedge;
  std::vector<int> m_place;     // per halfedge of the patch: its place among the edges, or -1
  std::vector<char> m_is_added; // per side edge
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_ZERO_SIDE_SEARCH_H
