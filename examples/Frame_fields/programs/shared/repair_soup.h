#ifndef FRAME_FIELDS_PROGRAMS_REPAIR_SOUP_H
#define FRAME_FIELDS_PROGRAMS_REPAIR_SOUP_H

#include "Console.h"
#include "Failure.h"
#include "Soup.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

inline bool has_zero_length_edge(const Soup& soup)
{
  return std::any_of(soup.polygons.begin(), soup.polygons.end(), [&](const std::vector<std::size_t>& polygon)
  {
    for(std::size_t i = 0; i < polygon.size(); ++i)
      if(soup.points[polygon[i]] == soup.points[polygon[(i + 1) % polygon.size()]])
        return true;
    return false;
  });
}

// Tells whether the polygons are the faces of an oriented manifold mesh without edges of length zero.
inline bool is_mesh(const Soup& soup)
{
  return CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(soup.polygons) && !has_zero_length_edge(soup);
}

struct Orientation_counter : CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
  explicit Orientation_counter(std::size_t& number_of_reversed_polygons)
    : number_of_reversed_polygons(&number_of_reversed_polygons)
  {}

  void polygon_orientation_reversed(std::size_t) { ++*number_of_reversed_polygons; }

  std::size_t* number_of_reversed_polygons;
};

// Makes the polygons the faces of an oriented manifold mesh; no coordinate changes.
inline void repair_soup(const std::string& path, Soup& soup, Console& console)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const auto warn = [&](const char* const change, const std::size_t number)
  {
    if(number > 0)
      console.warn(path + ": " + change + ": " + std::to_string(number));
  };

  warn("duplicate vertices merged", PMP::merge_duplicate_points_in_polygon_soup(soup.points, soup.polygons));

  const std::size_t number_of_points = soup.points.size(), number_of_polygons = soup.polygons.size();
  PMP::repair_polygon_soup(soup.points, soup.polygons);
  if(soup.polygons.size() > number_of_polygons)
    warn("faces added by splitting those that touch themselves", soup.polygons.size() - number_of_polygons);
  else
    warn("degenerate or duplicate faces removed", number_of_polygons - soup.polygons.size());
  warn("vertices without faces removed", number_of_points - soup.points.size());

  const std::size_t number_of_distinct_points = soup.points.size();
  std::size_t number_of_reversed_polygons = 0;
  PMP::orient_polygon_soup(soup.points, soup.polygons,
                           CGAL::parameters::visitor(Orientation_counter(number_of_reversed_polygons)));
  warn("faces turned around for a consistent orientation", number_of_reversed_polygons);
  warn("vertices duplicated where the surface is not a manifold", soup.points.size() - number_of_distinct_points);

  if(soup.polygons.empty())
    throw Failure(BAD_FILE, path + ": all its faces are degenerate");
  if(!is_mesh(soup))
    throw Failure(BAD_FILE, path + ": its faces cannot be made an oriented manifold mesh");
}

#endif // FRAME_FIELDS_PROGRAMS_REPAIR_SOUP_H
