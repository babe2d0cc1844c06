#ifndef FRAME_FIELDS_PROGRAMS_SOUP_H
#define FRAME_FIELDS_PROGRAMS_SOUP_H

#include "Console.h"
#include "Mesh.h"
#include "formats/Raw_soup.h"
#include "formats/read_raw_soup.h"
#include "read_content.h"

#include <cstddef>
#include <string>
#include <vector>

// What a file holds: points and polygons of point indices.
struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
};

inline Soup soup_of(const Raw_soup& raw)
{
  Soup soup;
  soup.points.reserve(raw.points.size());
  for(const Coordinates& point : raw.points)
    soup.points.emplace_back(point[0], point[1], point[2]);
  soup.polygons.reserve(raw.ends.size());
  std::size_t start = 0;
  for(const std::size_t end : raw.ends)
  {
    soup.polygons.emplace_back(raw.corners.begin() + start, raw.corners.begin() + end);
    start = end;
  }
  return soup;
}

inline Soup read_soup(const std::string& path, Console& console)
{
  const Raw_soup raw = read_raw_soup(path, read_content(path));
  for(const std::string& warning : raw.warnings)
    console.warn(path + ": " + warning);
  return soup_of(raw);
}

#endif // FRAME_FIELDS_PROGRAMS_SOUP_H
