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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MESHABLE_MATCHING_H
#define CGAL_FRAME_FIELDS_INTERNAL_MESHABLE_MATCHING_H

#include <CGAL/Frame_fields/internal/Cut_surface.h>
#include <CGAL/Frame_fields/internal/matching_and_indices.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The largest 4 I that a quadrangle mesh can have at a sector on a constrained edge.
constexpr int maximum_meshable_index = 1;

inline bool is_unmeshable(const Cut_surface& surface, const std::vector<int>& index, const int sector)
{
  return index[sector] > maximum_meshable_index && surface.is_constrained_sector(sector);
}

// Changes the matching of one patch until no constrained sector has an index of 1/2 or more, at the least cost in
// sum (r - omega)^2 for the given alpha.
//
// Lowering p_ij by one moves an index of 1/4 from the sector at one end of the edge to the sector at its other end. Moving
// the excess of the unmeshable sectors to sectors that have room is therefore a flow on the graph of sectors and edges,
// and its cost is convex on each edge: successive shortest paths, with potentials that keep all arc lengths
// non-negative, find the cheapest one. Each path lowers the total excess by one.
class Meshable_matching
{
public:
  Meshable_matching(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                    const std::vector<double>& alpha, std::vector<int>& matching, std::vector<int>& index)
    : m_surface(surface), m_patch(patch), m_omega(omega), m_alpha(alpha), m_matching(matching), m_index(index)
    , m_potential(patch.sectors.size(), 0), m_distance(patch.sectors.size()), m_arrival(patch.sectors.size())
    , m_dual_edge_of(3 * patch.faces.size(), -1)
  {
    for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    {
      dual_edge_of(surface.dual_edges[e].halfedge) = e;
      dual_edge_of(surface.dual_edges[e].opposite) = e;
    }
  }

  // Returns whether the sector is meshable in the end. It fails only if no sector of the patch has room.
  bool repair(const int sector)
  {
    while(m_index[sector] > maximum_meshable_index)
    {
      const int receiver = find_cheapest_receiver(sector);
      if(receiver < 0)
        return false;
      move_index(sector, receiver);
    }
    return true;
  }

private:
  int& dual_edge_of(const int halfedge) { return m_dual_edge_of[halfedge - 3 * m_patch.faces.begin_index]; }
  int local(const int sector) const { return sector - m_patch.sectors.begin_index; }

  // What it costs to move an index of 1/4 from the sector at the target of a halfedge to the one at its source.
  double cost(const int halfedge)
  {
    const int e = dual_edge_of(halfedge);
    const double difference = rotation(m_surface, m_alpha, m_matching, e) - m_omega[e];
    const double signed_difference = m_surface.dual_edges[e].halfedge == halfedge ? difference : -difference;
    return CGAL_PI * (CGAL_PI / 4 - signed_difference); // (x - pi/2)^2 - x^2
  }

  // Dijkstra's algorithm from `sector` up to the first sector that has room; -1 if there is none.
  int find_cheapest_receiver(const int sector)
  {
    typedef std::pair<double, int> Entry; // distance, sector
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    std::fill(m_distance.begin(), m_distance.end(), std::numeric_limits<double>::infinity());
    m_distance[local(sector)] = 0;
    queue.push({ 0, sector });
    while(!queue.empty())
    {
      const auto [distance, nearest] = queue.top();
      queue.pop();
      if(distance > m_distance[local(nearest)])
        continue;
      if(m_index[nearest] < maximum_meshable_index)
      {
        update_potentials(distance);
        return nearest;
      }
      for_each_corner(m_surface.opposite, m_surface.first_corner[nearest], [&, distance = distance, nearest = nearest]
                      (const int corner)
      {
        if(m_surface.is_constrained(corner))
          return;
        const int neighbor = m_surface.sector[m_surface.opposite[corner]];
        const double reduced_cost = (std::max)(
          0., cost(corner) + m_potential[local(nearest)] - m_potential[local(neighbor)]); // 0 but for rounding errors
        if(distance + reduced_cost < m_distance[local(neighbor)])
        {
          m_distance[local(neighbor)] = distance + reduced_cost;
          m_arrival[local(neighbor)] = corner;
          queue.push({ distance + reduced_cost, neighbor });
        }
      });
    }
    return -1;
  }

  void update_potentials(const double distance_of_receiver)
  {
    for(std::size_t s = 0; s < m_potential.size(); ++s)
      m_potential[s] += (std::min)(m_distance[s], distance_of_receiver);
  }

  // Lowers p along the path that the last search took from `sector` to `receiver`.
  void move_index(const int sector, const int receiver)
  {
    for(int s = receiver; s != sector; s = m_surface.sector[m_arrival[local(s)]])
    {
      const int halfedge = m_arrival[local(s)];
      const int e = dual_edge_of(halfedge);
      m_matching[e] += m_surface.dual_edges[e].halfedge == halfedge ? -1 : 1;
    }
    --m_index[sector];
    ++m_index[receiver];
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_omega;
  const std::vector<double>& m_alpha;
  std::vector<int>& m_matching;
  std::vector<int>& m_index;
  std::vector<double> m_potential; // per sector of the patch
  std::vector<double> m_distance;  // per sector of the patch
  std::vector<int> m_arrival;      // per sector of the patch: the halfedge from the sector before it on its path
  std::vector<int> m_dual_edge_of; // per halfedge of the patch
};

// Makes the matching of the patch meshable and keeps its indices up to date. Returns how many sectors were repaired.
inline int repair_patch(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                        const std::vector<double>& alpha, std::vector<int>& matching, std::vector<int>& index)
{
  std::vector<int> unmeshable;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(is_unmeshable(surface, index, s))
      unmeshable.push_back(s);
  if(unmeshable.empty())
    return 0;

  Meshable_matching meshable_matching(surface, patch, omega, alpha, matching, index);
  return static_cast<int>(std::count_if(unmeshable.begin(), unmeshable.end(),
                                        [&](const int s) { return meshable_matching.repair(s); }));
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MESHABLE_MATCHING_H
