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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_ROTATION_DEMAND_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_ROTATION_DEMAND_H

#include <CGAL/Frame_fields/Support_strategy.h>
#include <CGAL/Frame_fields/internal/field/Hub_rings.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Geodesic_ball.h>
#include <CGAL/Frame_fields/internal/surface/Geodesic_distances.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// d omega at a corner: what gives it its natural index (eq. (3) of the paper).
inline double rotation_demand_of_corner(const double total_angle)
{
  return total_angle - natural_number_of_quads(total_angle) * CGAL_PI / 2;
}

// Walks over the sectors of one patch ring by ring along the edges of its faces.
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

  // Goes one ring further; the result is empty when the patch is exhausted.
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

inline void remove_corners(const Cut_surface& surface, const Corner_bounds& bounds, std::vector<int>& sectors)
{
  sectors.erase(std::remove_if(sectors.begin(), sectors.end(),
                               [&](const int s) { return is_prescribed_corner(surface, s, bounds); }),
                sectors.end());
}

// The sectors that are not corners within `number_of_rings` rings of `corner`, or of the nearest further ring
// that has any.
inline std::vector<int> receivers_in_rings(const Cut_surface& surface, const int corner,
                                           const unsigned int number_of_rings, const Corner_bounds& bounds,
                                           Sector_rings& rings)
{
  std::vector<int> receivers;
  rings.start(corner);
  for(unsigned int k = 1; k <= number_of_rings || receivers.empty(); ++k)
  {
    std::vector<int> ring = rings.next();
    if(ring.empty())
      break;
    remove_corners(surface, bounds, ring);
    receivers.insert(receivers.end(), ring.begin(), ring.end());
  }
  return receivers;
}

// The constrained halfedge that follows `halfedge` on the border of its patch.
inline int next_on_border(const Cut_surface& surface, const int halfedge)
{
  return next_of(clockwise_most_corner(surface.opposite, halfedge));
}

// The constrained halfedge that precedes `halfedge` on the border of its patch.
inline int previous_on_border(const Cut_surface& surface, const int halfedge)
{
  int corner = previous_of(halfedge);
  while(!surface.is_constrained(corner))
    corner = previous_of(surface.opposite[corner]);
  return corner;
}

inline bool is_far_from_straight(const Cut_surface& surface, const int sector)
{
  return std::abs(surface.total_angle[sector] - CGAL_PI) > CGAL_PI / 4;
}

// Half the length of the shorter one of the two constrained curves that leave a sharp corner.
inline double local_feature_length(const Cut_surface& surface, const int corner)
{
  const int outgoing = next_of(surface.first_corner[corner]), incoming = previous_on_border(surface, outgoing);

  double length_forward = 0;
  int halfedge = outgoing;
  do
    length_forward += surface.length[halfedge];
  while(!is_far_from_straight(surface, surface.sector[halfedge])
        && (halfedge = next_on_border(surface, halfedge)) != outgoing);

  double length_backward = 0;
  halfedge = incoming;
  while(true)
  {
    length_backward += surface.length[halfedge];
    const int previous = previous_on_border(surface, halfedge);
    if(is_far_from_straight(surface, surface.sector[previous]) || previous == incoming)
      break;
    halfedge = previous;
  }
  return (std::min)(length_forward, length_backward) / 2;
}

// A sector that gives rotation to a corner, and which part of it.
struct Receiver
{
  int sector;
  double part;
};

// The sectors that are not corners among those with a share in a ball, with parts proportional to their shares.
inline std::vector<Receiver> receivers_among(const Cut_surface& surface, const std::vector<Sector_share>& shares,
                                             const Corner_bounds& bounds)
{
  std::vector<Receiver> receivers;
  double total_area = 0;
  for(const Sector_share& share : shares)
    if(!is_prescribed_corner(surface, share.sector, bounds))
    {
      receivers.push_back({ share.sector, share.area });
      total_area += share.area;
    }
  for(Receiver& receiver : receivers)
    receiver.part = total_area > 0 ? receiver.part / total_area : 1. / static_cast<double>(receivers.size());
  return receivers;
}

inline std::vector<Receiver> nearest_receiver(const Cut_surface& surface, const int corner,
                                              const Corner_bounds& bounds, Geodesic_distances& distances)
{
  std::vector<Receiver> receivers;
  distances.walk_from(corner, [&](const int sector, double)
  {
    if(!is_prescribed_corner(surface, sector, bounds))
      receivers.push_back({ sector, 1 });
    return receivers.empty();
  });
  return receivers;
}

inline std::vector<Receiver> in_equal_parts(const std::vector<int>& sectors)
{
  std::vector<Receiver> result;
  result.reserve(sectors.size());
  for(const int sector : sectors)
    result.push_back({ sector, 1. / static_cast<double>(sectors.size()) });
  return result;
}

// Finds the receivers of the corners of one patch, one corner after the other.
class Receiver_search
{
public:
  Receiver_search(const Cut_surface& surface, const Patch& patch, const Support_strategy& strategy,
                  const Corner_bounds& bounds)
    : m_surface(surface), m_strategy(strategy), m_bounds(bounds), m_rings(surface, patch), m_distances(surface, patch)
    , m_ball(surface, m_distances)
  {}

  std::vector<Receiver> receivers_of(const int corner)
  {
    if(m_strategy.kind() == Support_strategy::RINGS)
      return in_equal_parts(receivers_in_rings(m_surface, corner, m_strategy.number_of_rings(), m_bounds, m_rings));
    const double radius = m_strategy.support_radius() / m_surface.length_unit;
    const std::vector<Sector_share> shares =
      radius > 0 ? m_ball.shares_within(corner, radius)
                 : m_ball.shares_in_wedge(corner, local_feature_length(m_surface, corner));
    const std::vector<Receiver> receivers = receivers_among(m_surface, shares, m_bounds);
    return receivers.empty() ? nearest_receiver(m_surface, corner, m_bounds, m_distances) : receivers;
  }

private:
  const Cut_surface& m_surface;
  const Support_strategy& m_strategy;
  Corner_bounds m_bounds;
  Sector_rings m_rings;
  Geodesic_distances m_distances;
  Geodesic_ball m_ball;
};

// Adds to `demand` (K of the paper) what the corners of the patch ask for and takes it from their receivers.
// Returns -1, or a corner that has no receiver; the strategies `none` and `local` have no demand.
inline int spread_rotation_demand(const Cut_surface& surface, const Patch& patch,
                                  const std::vector<int>& corners, const Support_strategy& strategy,
                                  const Corner_bounds& bounds, std::vector<double>& demand)
{
  const auto demand_of = [&](const int corner)
  {
    return rotation_demand_of_corner(surface.total_angle[corner]);
  };
  const auto take_from = [&](const std::vector<Receiver>& receivers, const double rotation)
  {
    for(const Receiver& receiver : receivers)
      demand[receiver.sector] -= rotation * receiver.part;
  };

  if(strategy.kind() == Support_strategy::COMPONENT)
  {
    std::vector<int> receivers;
    for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
      receivers.push_back(s);
    remove_corners(surface, bounds, receivers);
    if(receivers.empty())
      return corners.front();
    double sum = 0;
    for(const int corner : corners)
      sum += (demand[corner] = demand_of(corner));
    take_from(in_equal_parts(receivers), sum);
    return -1;
  }

  Receiver_search search(surface, patch, strategy, bounds);
  const int number_of_rings = static_cast<int>((std::min)(strategy.number_of_rings(), 1000000000u));
  Hub_rings hub_rings(surface, patch, strategy.kind() == Support_strategy::RINGS ? number_of_rings : 0, bounds);
  for(const int corner : corners)
  {
    if(strategy.kind() == Support_strategy::RINGS && hub_rings.take(corner, demand_of(corner), demand))
    {
      demand[corner] = demand_of(corner);
      continue;
    }
    const std::vector<Receiver> receivers = search.receivers_of(corner);
    if(receivers.empty())
      return corner;
    const double rotation = demand_of(corner);
    demand[corner] = rotation;
    take_from(receivers, rotation);
  }
  hub_rings.take_from_shared_receivers(demand);
  return -1;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_ROTATION_DEMAND_H
