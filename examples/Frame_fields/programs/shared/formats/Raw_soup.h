#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_RAW_SOUP_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_RAW_SOUP_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

typedef std::array<double, 3> Coordinates;

// What a file says, without any interpretation: points, and polygons of point indices in the order of the file. All
// coordinates are finite, all indices are in range, and each polygon has a corner at least, but nothing more is sure.
struct Raw_soup
{
  std::vector<Coordinates> points;
  std::vector<std::size_t> corners; // of all polygons, one polygon after the other
  std::vector<std::size_t> ends;    // for each polygon, where its corners end
  std::vector<std::string> warnings;

  void end_polygon() { ends.push_back(corners.size()); }
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_RAW_SOUP_H
