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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_GEODESIC_BALL_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_GEODESIC_BALL_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Geodesic_distances.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The integrals of the linear functions that are 1 at one corner of a triangle of area 1 and 0 at the others, over the
// part of the triangle in which the linear function with the given values at the corners is at most `bound`.
inline std::array<double, 3> hat_integrals_below(const std::array<double, 3>& values, const double bound)
{
  std::array<int, 3> order = { 0, 1, 2 };
  std::sort(order.begin(), order.end(), [&](const int i, const int j) { return values[i] < values[j]; });
  const double low = values[order[0]], middle = values[order[1]], high = values[order[2]];
  // Over the triangle that is cut off at one corner at the fractions s and t of its sides to the two others.
  const auto integrals_at_corner = [](const double s, const double t) -> std::array<double, 3>
  {
    return { s * t * (3 - s - t) / 3, s * t * s / 3, s * t * t / 3 };
  };

  std::array<double, 3> result = { 0, 0, 0 };
  if(bound >= high)
    result.fill(1. / 3);
  else if(bound > middle)
  {
    const auto rest = integrals_at_corner((high - bound) / (high - middle), (high - bound) / (high - low));
    for(int k = 0; k < 3; ++k)
      result[order[2 - k]] = 1. / 3 - rest[k];
  }
  else if(bound > low)
  {
    const auto part = integrals_at_corner((bound - low) / (middle - low), (bound - low) / (high - low));
    for(int k = 0; k < 3; ++k)
      result[order[k]] = part[k];
  }
  return result;
}

// A third of the area of the face at each corner of the sector, in units of `length_unit` squared.
inline double sector_area(const Cut_surface& surface, const int sector)
{
  double sum = 0;
  for_each_corner(surface.opposite, surface.first_corner[sector],
                  [&](const int corner) { sum += area(surface, face_of(corner)) / 3; });
  return sum;
}

// A sector, and the integral of its hat function over a part of the patch, in units of `length_unit` squared.
struct Sector_share
{
  int sector;
  double area;
};

// The part of a patch within a geodesic distance of a sharp corner, and the areas that the sectors have in it. Of a
// triangle that its rim cuts, only the part inside counts, so that shares do not jump when the mesh changes a little.
// A corner is given by its sector; radii are in units of `length_unit`. Visits no
// sector beyond twice the radius.
class Geodesic_ball
{
public:
  Geodesic_ball(const Cut_surface& surface, Geodesic_distances& distances)
    : m_surface(surface), m_distances(distances)
  {}

  std::vector<Sector_share> shares_within(const int corner, const double radius)
  {
    reach(corner, radius);
    return shares(radius);
  }

  // The same in a smaller ball, if the ball of the largest radius does not fill most of the wedge of the corner's
  // angle: then it is the largest ball that does. Beyond it, as in a long strip with a tapered end, the sides of the
  // wedge do not tell how much room the corner has.
  std::vector<Sector_share> shares_in_wedge(const int corner, const double largest_radius)
  {
    reach(corner, largest_radius);
    return shares(radius_of_wedge(corner, largest_radius));
  }

private:
  double distance(const int sector) const { return m_distances.distance_of(sector); }

  // Collects the sectors within the radius in the order in which the front first reaches them, and finds the distances
  // of their neighbors.
  void reach(const int source, const double radius)
  {
    m_inside.clear();
    double farthest_neighbor = radius;
    m_distances.walk_from(source, [&](const int sector, const double d)
    {
      if(d > farthest_neighbor)
        return false;
      if(d > radius)
        return true;
      m_inside.push_back(sector);
      for_each_corner(m_surface.opposite, m_surface.first_corner[sector], [&](const int c)
      {
        farthest_neighbor = (std::max)({ farthest_neighbor, (std::min)(2 * radius, d + m_surface.length[c]),
                                         (std::min)(2 * radius, d + m_surface.length[next_of(c)]) });
      });
      return true;
    });
  }

  double radius_of_wedge(const int corner, const double largest_radius) const
  {
    const double least_filled_part = 0.8;
    double area = 0, filled_radius = 0;
    for(const int sector : m_inside)
    {
      area += sector_area(m_surface, sector);
      const double wedge = m_surface.total_angle[corner] * distance(sector) * distance(sector) / 2;
      if(area >= least_filled_part * wedge)
        filled_radius = sector == m_inside.back() ? largest_radius : distance(sector);
    }
    return filled_radius;
  }

  // A face is added only at its corner that is nearest to the source, so that it counts once.
  bool is_nearest_corner(const int c) const
  {
    const auto is_before = [this](const int a, const int b)
    {
      const double distance_a = distance(m_surface.sector[a]), distance_b = distance(m_surface.sector[b]);
      return distance_a < distance_b || (distance_a == distance_b && a < b);
    };
    return is_before(c, next_of(c)) && is_before(c, previous_of(c));
  }

  std::vector<Sector_share> shares(const double radius) const
  {
    std::vector<Sector_share> result;
    for(const int sector : m_inside)
      for_each_corner(m_surface.opposite, m_surface.first_corner[sector], [&](const int c)
      {
        if(is_nearest_corner(c))
          add_face(c, radius, result);
      });
    return merged(result);
  }

  void add_face(const int c, const double radius, std::vector<Sector_share>& result) const
  {
    const std::array<int, 3> sectors = { m_surface.sector[c], m_surface.sector[next_of(c)],
                                         m_surface.sector[previous_of(c)] };
    const std::array<double, 3> integrals =
      hat_integrals_below({ distance(sectors[0]), distance(sectors[1]), distance(sectors[2]) }, radius);
    const double face_area = area(m_surface, face_of(c));
    for(int k = 0; k < 3; ++k)
      if(integrals[k] > 0)
        result.push_back({ sectors[k], integrals[k] * face_area });
  }

  // One share for each sector.
  static std::vector<Sector_share> merged(std::vector<Sector_share>& shares)
  {
    std::sort(shares.begin(), shares.end(),
              [](const Sector_share& a, const Sector_share& b) { return a.sector < b.sector; });
    std::vector<Sector_share> result;
    for(const Sector_share& share : shares)
      if(!result.empty() && result.back().sector == share.sector)
        result.back().area += share.area;
      else
        result.push_back(share);
    return result;
  }

  const Cut_surface& m_surface;
  Geodesic_distances& m_distances;
  std::vector<int> m_inside;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_GEODESIC_BALL_H
