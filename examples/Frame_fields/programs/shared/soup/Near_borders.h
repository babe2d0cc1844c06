#ifndef FRAME_FIELDS_PROGRAMS_NEAR_BORDERS_H
#define FRAME_FIELDS_PROGRAMS_NEAR_BORDERS_H

#include "../Mesh.h"
#include "Triangle_surface.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// A border side of a surface as a segment.
struct Border
{
  std::size_t side, source, target; // the places that it joins
  Point a, b;

  bool has_end(const std::size_t place) const { return place == source || place == target; }
  bool has_ends_of(const Border& other) const { return has_end(other.source) && has_end(other.target); }
  double length() const { return std::sqrt((b - a).squared_length()); }
  Point middle() const { return a + 0.5 * (b - a); }

  // The place on it that is nearest to a point: 0 at its source, 1 at its target.
  double parameter_of(const Point& p) const
  {
    const double squared_length = (b - a).squared_length();
    return squared_length > 0 ? (std::min)((std::max)(((p - a) * (b - a)) / squared_length, 0.0), 1.0) : 0;
  }

  double distance_to(const Point& p) const
  {
    return std::sqrt((a + parameter_of(p) * (b - a) - p).squared_length());
  }
};

inline std::vector<Border> borders_of(const std::vector<Point>& points, const Triangle_surface& surface)
{
  std::vector<Border> result;
  for(std::size_t side = 0; side < surface.number_of_sides(); ++side)
    if(surface.is_border(side))
    {
      const std::size_t source = surface.place_at(side), target = surface.place_at(next_side(side));
      result.push_back({ side, source, target, points[source], points[target] });
    }
  return result;
}

// Calls `visit(i, j)` for points i and borders j at most about `tolerance` apart. Gives up and returns false after more
// pairs than there are where borders run along one another in a few layers.
template <typename Visit>
bool for_each_near_pair(const std::vector<Point>& points, const std::vector<Border>& borders, const double tolerance,
                        const Visit& visit)
{
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;
  struct Too_many {};

  const std::size_t maximum_number = 1000000 + 100 * (points.size() + borders.size());
  std::vector<Box> point_boxes, border_boxes;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Point& p = points[i];
    point_boxes.emplace_back(CGAL::Bbox_3(p.x() - tolerance, p.y() - tolerance, p.z() - tolerance, p.x() + tolerance,
                                          p.y() + tolerance, p.z() + tolerance), i);
  }
  for(std::size_t j = 0; j < borders.size(); ++j)
    border_boxes.emplace_back(borders[j].a.bbox() + borders[j].b.bbox(), j);
  std::size_t number = 0;
  try
  {
    CGAL::box_intersection_d(point_boxes.begin(), point_boxes.end(), border_boxes.begin(), border_boxes.end(),
                             [&](const Box& point, const Box& border)
    {
      if(++number > maximum_number)
        throw Too_many();
      visit(point.info(), border.info());
    });
  }
  catch(const Too_many&)
  {
    return false;
  }
  return true;
}

// Border sides that run along others, but do not join the same places as these.
struct Crack_figures
{
  std::size_t number_of_sides = 0;
  double maximum_distance = 0;
};

// Only the middles of sides are compared, and short sides are left out: these are near their neighbors.
inline Crack_figures find_cracks(const std::vector<Border>& borders, const double tolerance)
{
  std::vector<Point> middles;
  for(const Border& border : borders)
    middles.push_back(border.middle());
  const double none = 2 * tolerance;
  std::vector<double> distance(borders.size(), none);
  const bool is_complete = for_each_near_pair(middles, borders, tolerance,
                                              [&](const std::size_t i, const std::size_t j)
  {
    if(borders[i].length() > 2 * tolerance && !borders[i].has_ends_of(borders[j]))
      distance[i] = (std::min)(distance[i], borders[j].distance_to(middles[i]));
  });
  Crack_figures result;
  for(const double d : distance)
    if(is_complete && d <= tolerance)
    {
      ++result.number_of_sides;
      result.maximum_distance = (std::max)(result.maximum_distance, d);
    }
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_NEAR_BORDERS_H
