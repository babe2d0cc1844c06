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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MATCHING_MESHABLE_MATCHING_H
#define CGAL_FRAME_FIELDS_INTERNAL_MATCHING_MESHABLE_MATCHING_H

#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

inline bool is_unmeshable(const Cut_surface& surface, const std::vector<int>& index, const int sector)
{
  return index[sector] > maximum_meshable_index && surface.is_constrained_sector(sector);
}

// A sharp corner that did not get the index its angle asks for.
inline bool is_unnatural_corner(const Cut_surface& surface, const std::vector<int>& index, const double bound,
                                const int sector)
{
  return is_sharp_corner(surface, sector, bound) && index[sector] != natural_index(surface, sector);
}

// Changes the matching of one patch such that singularities leave the sectors where they must not be, each along the
// path that costs least in sum w (r - omega)^2 for the given alpha.
//
// Lowering p_ij by one moves an index of 1/4 from the sector at one end of the edge to the sector at its other end.
// Moving indices is therefore a flow on the graph of sectors and edges, and its cost is convex on each edge. Potentials
// keep all arc lengths non-negative, so that Dijkstra's algorithm finds each shortest path. Each path moves 1/4.
class Meshable_matching
{
public:
  Meshable_matching(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                    const std::vector<double>& alpha, std::vector<int>& matching, std::vector<int>& index)
    : m_surface(surface), m_patch(patch), m_omega(omega), m_alpha(alpha), m_matching(matching), m_index(index)
    , m_potential(patch.sectors.size(), 0), m_distance(patch.sectors.size()), m_arrival(patch.sectors.size())
    , m_dual_edge_of(3 * static_cast<std::size_t>(patch.faces.size()), -1)
  {
    for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    {
      dual_edge_of(surface.dual_edges[e].halfedge) = e;
      dual_edge_of(surface.dual_edges[e].opposite) = e;
    }
  }

  // Moves what a constrained sector has above the largest meshable index to sectors that stay at or below it, or, in a
  // patch so small that there is none, to those on no constrained edge.
  void remove_excess(const int sector)
  {
    const auto has_room = [this](const int s) { return m_index[s] < maximum_meshable_index; };
    const auto is_inside = [this](const int s) { return !m_surface.is_constrained_sector(s); };
    while(m_index[sector] > maximum_meshable_index
          && (move_index(sector, OUT, has_room) || move_index(sector, OUT, is_inside))) {}
  }

  // Brings a sector to its target by moving indices from or to sectors that get nearer to theirs, as far as there are
  // any.
  void approach_target(const int sector)
  {
    const int target = target_of_sector(m_surface, sector);
    const auto has_too_much = [this](const int s) { return m_index[s] > target_of_sector(m_surface, s); };
    const auto has_too_little = [this](const int s) { return m_index[s] < target_of_sector(m_surface, s); };
    while(m_index[sector] < target && move_index(sector, IN, has_too_much)) {}
    while(m_index[sector] > target && move_index(sector, OUT, has_too_little)) {}
  }

  // Moves what a sector has above 0 to sectors below 0, as far as there are any.
  void cancel_with_negative(const int sector)
  {
    const auto is_negative = [this](const int s) { return m_index[s] < 0; };
    while(m_index[sector] > 0 && move_index(sector, OUT, is_negative)) {}
  }

private:
  enum Direction { OUT, IN };

  int& dual_edge_of(const int halfedge) { return m_dual_edge_of[halfedge - 3 * m_patch.faces.begin_index]; }
  int local(const int sector) const { return sector - m_patch.sectors.begin_index; }

  // What it costs to move an index of 1/4 from the sector at the target of a halfedge to the one at its source.
  double cost(const int halfedge)
  {
    const int e = dual_edge_of(halfedge);
    const double difference = rotation(m_surface, m_alpha, m_matching, e) - m_omega[e];
    const double signed_difference = m_surface.dual_edges[e].halfedge == halfedge ? difference : -difference;
    return m_surface.weight[e] * CGAL_PI * (CGAL_PI / 4 - signed_difference); // (x - pi/2)^2 - x^2
  }

  // The same less the difference of the potentials, which is negative only by rounding errors.
  double reduced_cost(const int halfedge)
  {
    const int from = local(m_surface.sector[halfedge]), to = local(m_surface.sector[m_surface.opposite[halfedge]]);
    return (std::max)(0., cost(halfedge) + m_potential[from] - m_potential[to]);
  }

  // Moves an index of 1/4 from `sector` to the cheapest sector that is accepted, or from there to `sector`. Returns
  // whether there is one.
  template <typename Accepts>
  bool move_index(const int sector, const Direction direction, const Accepts& accepts)
  {
    const int other_end = find_cheapest(sector, direction, accepts);
    if(other_end < 0)
      return false;
    for(int s = other_end; s != sector; s = m_surface.sector[m_arrival[local(s)]])
    {
      const int e = dual_edge_of(m_arrival[local(s)]);
      const bool is_first_halfedge = m_surface.dual_edges[e].halfedge == m_arrival[local(s)];
      m_matching[e] += (is_first_halfedge == (direction == OUT)) ? -1 : 1;
    }
    m_index[sector] += (direction == OUT) ? -1 : 1;
    m_index[other_end] += (direction == OUT) ? 1 : -1;
    return true;
  }

  // Dijkstra's algorithm with reduced costs from `sector`, until no sector that is not reached yet can be cheaper than
  // the cheapest accepted one; -1 if none is accepted. With `IN` the paths run backward, and potentials change sign.
  template <typename Accepts>
  int find_cheapest(const int sector, const Direction direction, const Accepts& accepts)
  {
    typedef std::pair<double, int> Entry; // reduced distance, sector
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    std::fill(m_distance.begin(), m_distance.end(), infinity());
    m_distance[local(sector)] = 0;
    queue.push({ 0, sector });

    const double least_potential = least_accepted_potential(sector, direction, accepts);
    int cheapest = -1;
    double least_cost = infinity();
    while(!queue.empty())
    {
      const double distance = queue.top().first;
      const int nearest = queue.top().second;
      queue.pop();
      if(distance > m_distance[local(nearest)])
        continue;
      if(!(distance + least_potential < least_cost))
        break;
      if(nearest != sector && accepts(nearest) && distance + signed_potential(direction, nearest) < least_cost)
      {
        cheapest = nearest;
        least_cost = distance + signed_potential(direction, nearest);
      }
      for_each_corner(m_surface.opposite, m_surface.first_corner[nearest], [&](const int corner)
      {
        if(m_surface.is_constrained(corner))
          return;
        const int opposite = m_surface.opposite[corner];
        const int neighbor = m_surface.sector[opposite];
        const double new_distance = distance + reduced_cost(direction == OUT ? corner : opposite);
        if(new_distance < m_distance[local(neighbor)])
        {
          m_distance[local(neighbor)] = new_distance;
          m_arrival[local(neighbor)] = corner;
          queue.push({ new_distance, neighbor });
        }
      });
    }
    if(cheapest >= 0)
      update_potentials(direction, m_distance[local(cheapest)]);
    return cheapest;
  }

  template <typename Accepts>
  double least_accepted_potential(const int sector, const Direction direction, const Accepts& accepts) const
  {
    double least = infinity();
    for(int s = m_patch.sectors.begin_index; s < m_patch.sectors.end_index; ++s)
      if(s != sector && accepts(s))
        least = (std::min)(least, signed_potential(direction, s));
    return least;
  }

  static double infinity() { return std::numeric_limits<double>::infinity(); }

  double signed_potential(const Direction direction, const int sector) const
  {
    return direction == OUT ? m_potential[local(sector)] : -m_potential[local(sector)];
  }

  void update_potentials(const Direction direction, const double distance_of_end)
  {
    const double sign = direction == OUT ? 1 : -1;
    for(std::size_t s = 0; s < m_potential.size(); ++s)
      m_potential[s] += sign * (std::min)(m_distance[s], distance_of_end);
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_omega;
  const std::vector<double>& m_alpha;
  std::vector<int>& m_matching;
  std::vector<int>& m_index;
  std::vector<double> m_potential; // per sector of the patch
  std::vector<double> m_distance;  // per sector of the patch
  std::vector<int> m_arrival;      // per sector of the patch: a halfedge at the sector before it on its path
  std::vector<int> m_dual_edge_of; // per halfedge of the patch
};

// A sector whose index was changed, and 4 I as the rounding left it.
struct Repaired_sector
{
  int sector, rounded_index;
};

// The sectors of a patch whose index is not the rounded one any more.
inline std::vector<Repaired_sector> changed_sectors(const Patch& patch, const std::vector<int>& rounded_index_in_patch,
                                                    const std::vector<int>& index)
{
  std::vector<Repaired_sector> result;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
  {
    const int rounded_index = rounded_index_in_patch[s - patch.sectors.begin_index];
    if(rounded_index != index[s])
      result.push_back({ s, rounded_index });
  }
  return result;
}

inline std::vector<int> index_in_patch(const Patch& patch, const std::vector<int>& index)
{
  return std::vector<int>(index.begin() + patch.sectors.begin_index, index.begin() + patch.sectors.end_index);
}

// Makes the matching of the patch meshable and its sharp corners natural, and keeps its indices up to date. Returns the
// sectors whose index changed.
inline std::vector<Repaired_sector> repair_patch(const Cut_surface& surface, const Patch& patch,
                                                 const std::vector<double>& omega, const std::vector<double>& alpha,
                                                 const double sharp_corner_bound, std::vector<int>& matching,
                                                 std::vector<int>& index)
{
  std::vector<int> unmeshable, unnatural;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
  {
    if(is_unmeshable(surface, index, s))
      unmeshable.push_back(s);
    else if(is_unnatural_corner(surface, index, sharp_corner_bound, s))
      unnatural.push_back(s);
  }
  if(unmeshable.empty() && unnatural.empty())
    return {};

  const std::vector<int> rounded_index = index_in_patch(patch, index);
  Meshable_matching meshable_matching(surface, patch, omega, alpha, matching, index);
  for(const int s : unmeshable)
    meshable_matching.remove_excess(s);
  for(const int s : unnatural)
    meshable_matching.approach_target(s);
  return changed_sectors(patch, rounded_index, index);
}

// Gives every sector of the patch its target; the targets must sum to what the patch has. Returns the sectors whose
// index changed.
inline std::vector<Repaired_sector> enforce_index_targets(const Cut_surface& surface, const Patch& patch,
                                                          const std::vector<double>& omega,
                                                          const std::vector<double>& alpha,
                                                          std::vector<int>& matching, std::vector<int>& index)
{
  const std::vector<int> rounded_index = index_in_patch(patch, index);
  Meshable_matching meshable_matching(surface, patch, omega, alpha, matching, index);
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    meshable_matching.approach_target(s);
  return changed_sectors(patch, rounded_index, index);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MATCHING_MESHABLE_MATCHING_H
