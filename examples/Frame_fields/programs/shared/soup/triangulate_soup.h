#ifndef FRAME_FIELDS_PROGRAMS_TRIANGULATE_SOUP_H
#define FRAME_FIELDS_PROGRAMS_TRIANGULATE_SOUP_H

#include "../Mesh.h"
#include "Polygon_triangulator.h"
#include "Triangle.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

// The triangles of a soup of polygons, and what became of these.
struct Triangulated_soup
{
  std::vector<Triangle> triangles;
  std::size_t number_of_triangulated_polygons = 0;
  std::size_t number_of_degenerate_polygons = 0; // without area, which have no triangles
  std::size_t number_of_wrong_polygons = 0, first_wrong_polygon = 0;
  std::string fault_of_first; // what the first wrong polygon does
};

inline Triangulated_soup triangulate_soup(const std::vector<Point>& points,
                                          const std::vector<std::vector<std::size_t> >& polygons,
                                          const std::vector<std::size_t>& place)
{
  Triangulated_soup result;
  Polygon_triangulator triangulate(points);
  std::vector<std::size_t> vertex_at(points.size()), ring; // a vertex of the polygon at each of its places
  std::vector<Triangle> triangles;
  for(std::size_t f = 0; f < polygons.size(); ++f)
  {
    const std::vector<std::size_t>& polygon = polygons[f];
    ring.clear();
    for(std::size_t k = polygon.size(); k-- > 0;)
      vertex_at[place[polygon[k]]] = polygon[k];
    for(const std::size_t vertex : polygon)
      ring.push_back(place[vertex]);
    triangles.clear();
    const char* const fault = triangulate(ring, triangles);
    const auto is_degenerate = [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(), is_degenerate), triangles.end());
    if(fault != nullptr && result.number_of_wrong_polygons++ == 0)
    {
      result.first_wrong_polygon = f;
      result.fault_of_first = fault;
    }
    result.number_of_degenerate_polygons += fault == nullptr && triangles.empty();
    result.number_of_triangulated_polygons += polygon.size() > 3 && !triangles.empty();
    for(const Triangle& t : triangles)
      result.triangles.push_back({ vertex_at[t[0]], vertex_at[t[1]], vertex_at[t[2]] });
  }
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_TRIANGULATE_SOUP_H
