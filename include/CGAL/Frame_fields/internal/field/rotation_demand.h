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
#include <CGAL/Frame_fields/internal/field/Receiver_search.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// d omega, in radians, that gives a sector on constrained edges its natural index (eq. (3) of the paper).
inline double rotation_demand_of_corner(const Cut_surface& surface, const int corner)
{
  return surface.total_angle[corner] - natural_number_of_quads(surface.angle_of_sector(corner)) * CGAL_PI / 2;
}

// Sets in `demand` (K of the paper) what the corners of the patch ask for and takes it from their receivers. `corners`
// must not be empty, and `demand` must be 0 in the patch before; it is in radians, per sector. Returns -1, or a corner
// that has no receiver. The strategies `NONE` and `LOCAL` have no demand and must not be given.
inline int spread_rotation_demand(const Cut_surface& surface, const Patch& patch,
                                  const std::vector<int>& corners, const Support_strategy& strategy,
                                  const Corner_bounds& bounds, std::vector<double>& demand)
{
  const auto demand_of = [&](const int corner)
  {
    return rotation_demand_of_corner(surface, corner);
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
