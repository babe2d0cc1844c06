#ifndef FRAME_FIELDS_PROGRAMS_FIRST_AT_EACH_PLACE_H
#define FRAME_FIELDS_PROGRAMS_FIRST_AT_EACH_PLACE_H

#include "../Mesh.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

// For each point the first one with the same coordinates: the number of its place.
inline std::vector<std::size_t> first_at_each_place(const std::vector<Point>& points)
{
  std::vector<std::size_t> order(points.size()), result(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto key = [&](const std::size_t i) { return std::make_tuple(points[i].x(), points[i].y(), points[i].z(), i); };
  std::sort(order.begin(), order.end(), [&](const std::size_t i, const std::size_t j) { return key(i) < key(j); });
  for(std::size_t k = 0; k < order.size(); ++k)
    result[order[k]] = k > 0 && points[order[k]] == points[order[k - 1]] ? result[order[k - 1]] : order[k];
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_FIRST_AT_EACH_PLACE_H
