#ifndef FRAME_FIELDS_PROGRAMS_CLOSE_CRACKS_H
#define FRAME_FIELDS_PROGRAMS_CLOSE_CRACKS_H

#include "../Mesh.h"
#include "Disjoint_sets.h"
#include "Near_borders.h"
#include "Triangle.h"
#include "Triangle_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

// Places of the ends of borders, without repetition.
inline std::vector<std::size_t> border_places(const std::vector<Border>& borders)
{
  std::vector<std::size_t> result;
  for(const Border& border : borders)
    result.insert(result.end(), { border.source, border.target });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

inline std::vector<Point> points_at(const std::vector<std::size_t>& places, const std::vector<Point>& points)
{
  std::vector<Point> result;
  for(const std::size_t place : places)
    result.push_back(points[place]);
  return result;
}

// Gives ends of borders that are at most `tolerance` apart the same place, but not the two ends of one border side.
// Returns false if there are too many of them.
inline bool unite_near_places(const std::vector<Point>& points, const std::vector<Border>& borders,
                              const double tolerance, std::vector<std::size_t>& place)
{
  std::vector<std::pair<std::size_t, std::size_t> > sides;
  for(const Border& border : borders)
    sides.push_back(std::minmax(border.source, border.target));
  std::sort(sides.begin(), sides.end());
  const std::vector<std::size_t> ends = border_places(borders);
  Disjoint_sets places(points.size());
  const bool is_complete = for_each_near_pair(points_at(ends, points), borders, tolerance,
                                              [&](const std::size_t i, const std::size_t j)
  {
    for(const std::size_t end : { borders[j].source, borders[j].target })
      if(end != ends[i] && (points[end] - points[ends[i]]).squared_length() <= tolerance * tolerance
         && !std::binary_search(sides.begin(), sides.end(), std::pair<std::size_t, std::size_t>(
                                                              std::minmax(end, ends[i]))))
        places.unite(end, ends[i]);
  });
  for(std::size_t& p : place)
    p = places.find(p);
  return is_complete;
}

// Vertices to insert on a side of a triangle, in the order that they have along it.
typedef std::array<std::vector<std::size_t>, 3> Inserted_vertices;

inline void split_triangle(Triangle triangle, Inserted_vertices inserted, std::vector<Triangle>& result)
{
  for(int k = 0; k < 2 && inserted[0].empty(); ++k)
  {
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    std::rotate(inserted.begin(), inserted.begin() + 1, inserted.end());
  }
  if(inserted[0].empty())
  {
    result.push_back(triangle);
    return;
  }
  std::vector<std::size_t> chain = inserted[0];
  chain.insert(chain.begin(), triangle[0]);
  chain.push_back(triangle[1]);
  for(std::size_t k = 0; k + 1 < chain.size(); ++k)
  {
    Inserted_vertices rest;
    if(k + 2 == chain.size())
      rest[1] = inserted[1];
    if(k == 0)
      rest[2] = inserted[2];
    split_triangle({ chain[k], chain[k + 1], triangle[2] }, std::move(rest), result);
  }
}

// Splits border sides where ends of others lie on them, up to `tolerance`. Returns false if there are too many.
inline bool split_sides_at_near_places(const std::vector<Point>& points, const Triangle_surface& surface,
                                       const double tolerance, std::vector<Triangle>& triangles)
{
  const std::vector<Border> borders = borders_of(points, surface);
  const std::vector<std::size_t> ends = border_places(borders);
  std::vector<std::vector<std::pair<double, std::size_t> > > on_border(borders.size());
  const bool is_complete = for_each_near_pair(points_at(ends, points), borders, tolerance,
                                              [&](const std::size_t i, const std::size_t j)
  {
    const Border& border = borders[j];
    const double parameter = border.parameter_of(points[ends[i]]);
    if(parameter > 0 && parameter < 1 && border.distance_to(points[ends[i]]) <= tolerance && !border.has_end(ends[i])
       && surface.place_at(previous_side(border.side)) != ends[i])
      on_border[j].emplace_back(parameter, ends[i]);
  });
  std::vector<Inserted_vertices> inserted(surface.triangles().size());
  for(std::size_t j = 0; j < borders.size(); ++j)
  {
    std::sort(on_border[j].begin(), on_border[j].end());
    for(const auto& [parameter, place] : on_border[j])
      inserted[borders[j].side / 3][borders[j].side % 3].push_back(place);
  }
  triangles.clear();
  for(std::size_t t = 0; t < inserted.size(); ++t)
    split_triangle(surface.triangles()[t], std::move(inserted[t]), triangles);
  return is_complete;
}

#endif // FRAME_FIELDS_PROGRAMS_CLOSE_CRACKS_H
