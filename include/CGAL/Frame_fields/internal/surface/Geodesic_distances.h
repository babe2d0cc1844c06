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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_GEODESIC_DISTANCES_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_GEODESIC_DISTANCES_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The distance of P from a source beyond the side CN of the triangle CNP, when the source is laid out in its plane at
// `distance_c` from C and `distance_n` from N; infinite if the straight line to P misses that side, or if no point has
// these distances.
inline double distance_across_side(const double side_cn, const double side_cp, const double angle_at_c,
                                   const double distance_c, const double distance_n)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double x = side_cp * std::cos(angle_at_c), y = side_cp * std::sin(angle_at_c);
  const double source_x = (distance_c * distance_c - distance_n * distance_n + side_cn * side_cn) / (2 * side_cn);
  const double squared_y = distance_c * distance_c - source_x * source_x;
  if(!(squared_y >= 0))
    return infinity;
  const double source_y = std::sqrt(squared_y);
  const double crossing = source_x + (x - source_x) * source_y / (y + source_y);
  if(!(crossing >= 0 && crossing <= side_cn))
    return infinity;
  return std::hypot(x - source_x, y + source_y);
}

// Distances in a patch from one sector, in units of `length_unit`, by a front that unfolds the triangles it enters.
// They are exact where straight lines from the source are the shortest paths. The surface and the patch must outlive
// it.
class Geodesic_distances
{
public:
  Geodesic_distances(const Cut_surface& surface, const Patch& patch)
    : m_surface(surface), m_patch(patch), m_distance(patch.sectors.size(), infinity())
    , m_number_of_visits(patch.sectors.size(), 0)
  {}

  // Calls `visit(sector, distance)` once for each sector, in the order in which the front first reaches them, until it
  // returns false. A distance may still be lowered later. A walk over n sectors takes O(n log n) time; what the walk
  // before it reached is reset first.
  template <typename Visit>
  void walk_from(const int source, const Visit& visit)
  {
    for(const int sector : m_reached)
    {
      distance(sector) = infinity();
      m_number_of_visits[local(sector)] = 0;
    }
    m_reached.clear();
    m_queue = Queue();
    lower(source, 0);
    while(!m_queue.empty())
    {
      const auto [d, sector] = m_queue.top();
      m_queue.pop();
      if(d > distance(sector))
        continue;
      if(m_number_of_visits[local(sector)]++ == 0 && !visit(sector, d))
        return;
      for_each_corner(m_surface.opposite, m_surface.first_corner[sector],
                      [this](const int corner) { advance(corner); });
    }
  }

  // The distance of a sector from the last source if it was visited; otherwise an upper bound, infinity at most.
  double distance_of(const int sector) const { return m_distance[local(sector)]; }

private:
  typedef std::pair<double, int> Entry; // distance, sector
  typedef std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > Queue;

  static double infinity() { return std::numeric_limits<double>::infinity(); }
  int local(const int sector) const { return sector - m_patch.sectors.begin_index; }
  double& distance(const int sector) { return m_distance[local(sector)]; }

  // Beyond obtuse corners the front may come again by a shorter way. In needles, rounding errors could lower distances
  // forever, so there is a limit.
  void lower(const int sector, const double d)
  {
    const unsigned char maximum_number_of_visits = 8;
    if(m_number_of_visits[local(sector)] >= maximum_number_of_visits || !(d < distance(sector)))
      return;
    if(distance(sector) == infinity())
      m_reached.push_back(sector);
    distance(sector) = d;
    m_queue.push({ d, sector });
  }

  // Lowers the distances at the two other corners of the face of `c`, along its sides and across them.
  void advance(const int c)
  {
    const int n = next_of(c), p = previous_of(c);
    const int sector_n = m_surface.sector[n], sector_p = m_surface.sector[p];
    const double side_cn = m_surface.length[n], side_cp = m_surface.length[c], angle = m_surface.angle[c];
    const double distance_c = distance(m_surface.sector[c]);
    lower(sector_n, distance_c + side_cn);
    lower(sector_p, distance_c + side_cp);
    lower(sector_p, distance_across_side(side_cn, side_cp, angle, distance_c, distance(sector_n)));
    lower(sector_n, distance_across_side(side_cp, side_cn, angle, distance_c, distance(sector_p)));
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  std::vector<double> m_distance; // per sector of the patch
  std::vector<unsigned char> m_number_of_visits; // per sector of the patch
  std::vector<int> m_reached;
  Queue m_queue;
};

// Whether a patch has a border or a feature edge; a closed one without features has none.
inline bool has_constrained_sector(const Cut_surface& surface, const Patch& patch)
{
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(surface.is_constrained_sector(s))
      return true;
  return false;
}

// The distance from a sector to the nearest constrained one, in units of `length_unit`; infinite if the patch has none.
// Visits all sectors that are nearer, so the caller should ask `has_constrained_sector()` first.
inline double distance_to_constrained_sector(const Cut_surface& surface, const int sector,
                                             Geodesic_distances& distances)
{
  double result = std::numeric_limits<double>::infinity();
  distances.walk_from(sector, [&](const int reached, const double distance)
  {
    if(!surface.is_constrained_sector(reached))
      return true;
    result = distance;
    return false;
  });
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_GEODESIC_DISTANCES_H
