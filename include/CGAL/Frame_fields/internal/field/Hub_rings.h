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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_HUB_RINGS_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_HUB_RINGS_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Takes rotation in equal parts from the rings around prescribed corners if the rings hold *hubs*: sectors of very many
// face corners, like the middle of a fan. Thousands of prescribed corners may then have thousands of receivers each,
// nearly all of them the same ones around the hubs. These shared receivers are collected once for all prescribed
// corners that are equally far from the hubs, and give at the end what these corners take together. Only the few other
// receivers are visited corner by corner. Each new combination of distances from the hubs takes a pass over the patch.
class Hub_rings
{
public:
  Hub_rings(const Cut_surface& surface, const Patch& patch, const int number_of_rings,
            const Corner_bounds& bounds)
    : m_surface(surface), m_patch(patch), m_number_of_rings(number_of_rings), m_bounds(bounds)
    , m_hub(patch.sectors.size(), -1)
  {
    std::vector<int> number_of_corners(patch.sectors.size(), 0);
    for(int corner = 3 * patch.faces.begin_index; corner < 3 * patch.faces.end_index; ++corner)
      ++number_of_corners[local(surface.sector[corner])];
    std::vector<std::pair<int, int> > hubs; // number of corners, sector
    for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
      if(number_of_corners[local(s)] > smallest_hub)
        hubs.emplace_back(number_of_corners[local(s)], s);
    std::sort(hubs.begin(), hubs.end(), std::greater<std::pair<int, int> >());
    hubs.resize((std::min)(hubs.size(), largest_number_of_hubs));
    for(const auto& hub : hubs)
    {
      m_hub[local(hub.second)] = static_cast<int>(m_ring_around_hub.size());
      m_ring_around_hub.push_back(rings_around(hub.second));
    }
    if(!hubs.empty())
      m_last_visit.assign(patch.sectors.size(), -1);
  }

  // Takes `rotation`, in radians, from the receivers of a corner. Returns false and leaves `demand` as it is if there
  // is no hub in the rings of the corner, or no receiver. `take_from_shared_receivers()` completes the demand.
  bool take(const int corner, const double rotation, std::vector<double>& demand)
  {
    if(m_ring_around_hub.empty())
      return false;
    std::vector<int> reach(m_ring_around_hub.size(), -1); // per hub: how many rings around it are in the corner's
    const std::vector<int> visited = visit_without_hubs(corner, reach);
    if(*std::max_element(reach.begin(), reach.end()) < 0)
      return false;

    Shared_receivers& shared = shared_receivers(reach);
    std::vector<int> others;
    for(const int s : visited)
      if(!is_around_hubs(s, reach) && !is_prescribed_corner(m_surface, s, m_bounds))
        others.push_back(s);
    const std::size_t number_of_receivers = shared.sectors.size() + others.size();
    if(number_of_receivers == 0)
      return false;
    const double part = rotation / static_cast<double>(number_of_receivers);
    shared.rotation += part;
    for(const int s : others)
      demand[s] -= part;
    return true;
  }

  // Takes from the shared receivers what all corners asked them for. To be called once, after all corners.
  void take_from_shared_receivers(std::vector<double>& demand) const
  {
    for(const auto& shared : m_shared)
      for(const int s : shared.second.sectors)
        demand[s] -= shared.second.rotation;
  }

private:
  // A hub has more face corners than this; where all sectors have fewer, rings are small. Of the hubs only the largest
  // ones are used, since each keeps a number for every sector of the patch.
  static constexpr int smallest_hub = 64;
  static constexpr std::size_t largest_number_of_hubs = 8;

  // The receivers that all corners share which reach the same rings around hubs, and how much each of them gives.
  struct Shared_receivers
  {
    std::vector<int> sectors;
    double rotation = 0;
  };

  int local(const int sector) const { return sector - m_patch.sectors.begin_index; }

  template <typename Visit>
  void for_each_neighbor(const int sector, const Visit& visit) const
  {
    for_each_corner(m_surface.opposite, m_surface.first_corner[sector], [&](const int corner)
    {
      visit(m_surface.sector[next_of(corner)]);
      visit(m_surface.sector[previous_of(corner)]);
    });
  }

  // The number of the ring around a hub that each sector of the patch is in, -1 beyond the last one.
  std::vector<int> rings_around(const int hub) const
  {
    std::vector<int> ring(m_patch.sectors.size(), -1), queue(1, hub);
    ring[local(hub)] = 0;
    for(std::size_t i = 0; i < queue.size() && ring[local(queue[i])] < m_number_of_rings; ++i)
      for_each_neighbor(queue[i], [&](const int neighbor)
      {
        if(ring[local(neighbor)] >= 0)
          return;
        ring[local(neighbor)] = ring[local(queue[i])] + 1;
        queue.push_back(neighbor);
      });
    return ring;
  }

  bool is_around_hubs(const int sector, const std::vector<int>& reach) const
  {
    for(std::size_t hub = 0; hub < reach.size(); ++hub)
      if(const int ring = m_ring_around_hub[hub][local(sector)]; ring >= 0 && ring <= reach[hub])
        return true;
    return false;
  }

  // The sectors in the rings of a corner that no shortest path through a hub reaches; the others are in the rings
  // around that hub. Sets in `reach` how many rings around each hub are within the rings of the corner; it must be -1
  // before.
  std::vector<int> visit_without_hubs(const int corner, std::vector<int>& reach)
  {
    ++m_visit;
    std::vector<int> all, ring(1, corner), next_ring;
    m_last_visit[local(corner)] = m_visit;
    for(int k = 0; !ring.empty(); ++k, ring.swap(next_ring))
    {
      next_ring.clear();
      for(const int s : ring)
        if(const int hub = m_hub[local(s)]; hub >= 0)
          reach[hub] = m_number_of_rings - k;
      for(const int s : ring)
      {
        if(m_hub[local(s)] >= 0 || is_behind_hub(s, k, reach))
          continue;
        all.push_back(s);
        if(k < m_number_of_rings)
          for_each_neighbor(s, [&](const int neighbor)
          {
            if(m_last_visit[local(neighbor)] == m_visit)
              return;
            m_last_visit[local(neighbor)] = m_visit;
            next_ring.push_back(neighbor);
          });
      }
    }
    return all;
  }

  // Whether a path through a hub leads from a corner to a sector in its ring k in at most k steps.
  bool is_behind_hub(const int sector, const int k, const std::vector<int>& reach) const
  {
    for(std::size_t hub = 0; hub < reach.size(); ++hub)
      if(const int ring = m_ring_around_hub[hub][local(sector)];
         reach[hub] >= 0 && ring >= 0 && m_number_of_rings - reach[hub] + ring <= k)
        return true;
    return false;
  }

  Shared_receivers& shared_receivers(const std::vector<int>& reach)
  {
    const auto [place, is_new] = m_shared.emplace(reach, Shared_receivers());
    if(is_new)
      for(int s = m_patch.sectors.begin_index; s < m_patch.sectors.end_index; ++s)
        if(is_around_hubs(s, reach) && !is_prescribed_corner(m_surface, s, m_bounds))
          place->second.sectors.push_back(s);
    return place->second;
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  int m_number_of_rings;
  Corner_bounds m_bounds;
  std::vector<int> m_hub;                           // per sector of the patch: its number as a hub, or -1
  std::vector<std::vector<int> > m_ring_around_hub; // per hub and sector of the patch
  std::vector<int> m_last_visit;                    // per sector of the patch
  int m_visit = -1;
  std::map<std::vector<int>, Shared_receivers> m_shared;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_HUB_RINGS_H
