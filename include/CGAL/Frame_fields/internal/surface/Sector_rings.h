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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SECTOR_RINGS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SECTOR_RINGS_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Walks over the sectors of one patch ring by ring: each ring holds the sectors that share an edge with the ring before
// it and are in no earlier ring. The surface and the patch must outlive it.
class Sector_rings
{
public:
  Sector_rings(const Cut_surface& surface, const Patch& patch)
    : m_surface(surface), m_patch(patch), m_last_visit(patch.sectors.size(), -1)
  {}

  // Starts again at `sector`, which is ring 0.
  void start(const int sector)
  {
    ++m_visit;
    m_ring.assign(1, sector);
    visit(sector);
  }

  // Goes one ring further; the ring is empty when the patch is exhausted. The reference is valid until the next call.
  // The cost is that of the corners of the ring before.
  const std::vector<int>& next()
  {
    m_next_ring.clear();
    for(const int sector : m_ring)
      for_each_corner(m_surface.opposite, m_surface.first_corner[sector], [this](const int corner)
      {
        collect(m_surface.sector[next_of(corner)]);
        collect(m_surface.sector[previous_of(corner)]);
      });
    m_ring.swap(m_next_ring);
    return m_ring;
  }

private:
  bool visit(const int sector)
  {
    int& last_visit = m_last_visit[sector - m_patch.sectors.begin_index];
    const bool is_new = last_visit != m_visit;
    last_visit = m_visit;
    return is_new;
  }

  void collect(const int sector)
  {
    if(visit(sector))
      m_next_ring.push_back(sector);
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  std::vector<int> m_last_visit; // per sector of the patch
  std::vector<int> m_ring, m_next_ring;
  int m_visit = -1;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_SECTOR_RINGS_H
