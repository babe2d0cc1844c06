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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_RECEIVER_SEARCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_RECEIVER_SEARCH_H

#include <CGAL/Frame_fields/Support_strategy.h>
#include <CGAL/Frame_fields/internal/field/local_feature_length.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Geodesic_ball.h>
#include <CGAL/Frame_fields/internal/surface/Geodesic_distances.h>
#include <CGAL/Frame_fields/internal/surface/Sector_rings.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Removes the corners that get a rotation prescribed: they do not give rotation to one another.
inline void remove_corners(const Cut_surface& surface, const Corner_bounds& bounds, std::vector<int>& sectors)
{
  sectors.erase(std::remove_if(sectors.begin(), sectors.end(),
                               [&](const int s) { return is_prescribed_corner(surface, s, bounds); }),
                sectors.end());
}

// The sectors within `number_of_rings` rings of `corner` that are not prescribed corners. If there are none, those of
// the nearest ring beyond that has any; empty if the patch has none.
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

// A sector that gives rotation to a corner, and which part of it.
struct Receiver
{
  int sector;
  double part;
};

// The sectors with a share in a ball that are not prescribed corners, with parts proportional to their shares; equal
// parts if the shares have no area. The parts sum to 1.
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

// The sector nearest to `corner` along the surface that is not a prescribed corner, as the only receiver; none if all
// are prescribed corners.
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

// All these sectors as receivers, each with the same part.
inline std::vector<Receiver> in_equal_parts(const std::vector<int>& sectors)
{
  std::vector<Receiver> result;
  result.reserve(sectors.size());
  for(const int sector : sectors)
    result.push_back({ sector, 1. / static_cast<double>(sectors.size()) });
  return result;
}

// Finds the receivers of the prescribed corners of one patch, one corner after the other. Each search takes time in
// proportion to the rings or the ball that it visits.
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
    const std::optional<double> radius = m_strategy.support_radius();
    const std::vector<Sector_share> shares =
      radius ? m_ball.shares_within(corner, *radius / m_surface.length_unit)
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

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_RECEIVER_SEARCH_H
