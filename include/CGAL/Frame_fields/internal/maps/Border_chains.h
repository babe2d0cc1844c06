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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_BORDER_CHAINS_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_BORDER_CHAINS_H

#include <CGAL/Frame_fields/internal/field/local_feature_length.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/walk_along_border.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The borders of all patches, cut at their corners into chains.
class Border_chains
{
public:
  explicit Border_chains(const Cut_surface& surface)
    : m_chain(surface.number_of_halfedges(), -1)
  {
    for(int h = 0; h < surface.number_of_halfedges(); ++h)
      if(surface.is_constrained(h) && m_chain[h] < 0)
        add_loop(surface, h);
  }

  // The chain of a constrained halfedge.
  int chain(const int halfedge) const { return m_chain[halfedge]; }

  // Whether one chain follows the other one at a corner.
  bool share_corner(const int chain, const int other) const
  {
    return m_next[chain] == other || m_next[other] == chain;
  }

private:
  void add_loop(const Cut_surface& surface, const int start)
  {
    std::vector<int> loop;
    std::size_t first = 0; // after a corner, if there is one
    bool has_corner = false;
    int h = start;
    do
    {
      loop.push_back(h);
      if(is_far_from_straight(surface, surface.sector[h]))
      {
        has_corner = true;
        first = loop.size();
      }
      h = next_on_border(surface, h);
    } while(h != start);

    const int first_chain = static_cast<int>(m_next.size());
    m_next.push_back(-1);
    for(std::size_t i = 0; i < loop.size(); ++i)
    {
      const int halfedge = loop[(first + i) % loop.size()];
      m_chain[halfedge] = static_cast<int>(m_next.size()) - 1;
      if(i + 1 < loop.size() && is_far_from_straight(surface, surface.sector[halfedge]))
      {
        m_next.back() = static_cast<int>(m_next.size());
        m_next.push_back(-1);
      }
    }
    if(has_corner)
      m_next.back() = first_chain;
  }

  std::vector<int> m_chain; // per halfedge, -1 on unconstrained ones
  std::vector<int> m_next;  // per chain: the one after its end, -1 if it has no end
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_BORDER_CHAINS_H
