#ifndef FRAME_FIELDS_PROGRAMS_REMOVE_DUPLICATES_H
#define FRAME_FIELDS_PROGRAMS_REMOVE_DUPLICATES_H

#include "Disjoint_sets.h"
#include "Edge_groups.h"
#include "Triangle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

// The places of a triangle, the least one first.
inline std::array<std::size_t, 3> places_of(const Triangle& triangle, const std::vector<std::size_t>& place)
{
  std::array<std::size_t, 3> result = { place[triangle[0]], place[triangle[1]], place[triangle[2]] };
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

inline void remove_marked(const std::vector<bool>& is_marked, std::vector<Triangle>& triangles)
{
  std::size_t number = 0;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    if(!is_marked[t])
      triangles[number++] = triangles[t];
  triangles.resize(number);
}

inline void remove_degenerate_triangles(const std::vector<std::size_t>& place, std::vector<Triangle>& triangles)
{
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), [&](const Triangle& triangle)
  {
    const std::size_t a = place[triangle[0]], b = place[triangle[1]], c = place[triangle[2]];
    return a == b || b == c || c == a;
  }), triangles.end());
}

// Marks triangles that lie on earlier ones of the same orientation, and returns for each other one the triangle of
// opposite orientation that lies on it, or itself.
inline std::vector<std::size_t> find_duplicates(const std::vector<Triangle>& triangles,
                                                const std::vector<std::size_t>& place,
                                                std::vector<bool>& is_duplicate)
{
  const auto key = [&](const std::size_t t)
  {
    const std::array<std::size_t, 3> places = places_of(triangles[t], place);
    const bool is_ascending = places[1] < places[2];
    return std::make_tuple(places[0], (std::min)(places[1], places[2]), (std::max)(places[1], places[2]), is_ascending,
                           t);
  };
  std::vector<decltype(key(0))> keys;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    keys.push_back(key(t));
  std::sort(keys.begin(), keys.end());

  std::vector<std::size_t> opposite(triangles.size());
  std::iota(opposite.begin(), opposite.end(), std::size_t(0));
  for(std::size_t k = 1, kept = 0; k < keys.size(); ++k)
  {
    const auto& [a, b, c, is_ascending, t] = keys[k];
    const auto& [kept_a, kept_b, kept_c, kept_is_ascending, kept_t] = keys[kept];
    const bool is_same_place = a == kept_a && b == kept_b && c == kept_c;
    if(is_same_place && is_ascending == kept_is_ascending)
      is_duplicate[t] = true;
    else
    {
      if(is_same_place)
      {
        opposite[t] = kept_t;
        opposite[kept_t] = t;
      }
      kept = k;
    }
  }
  return opposite;
}

// Where two solids touch, there are pairs of triangles of opposite orientation, and the number of sides at each edge is
// even. Otherwise the later triangle of a pair is a duplicate that is wrongly oriented, too, as are those of all pairs
// that such pairs are connected with.
inline void mark_reversed_duplicates(const std::vector<Triangle>& triangles, const std::vector<std::size_t>& place,
                                     const std::vector<std::size_t>& opposite, std::vector<bool>& is_duplicate)
{
  Disjoint_sets pairs(triangles.size());
  std::vector<bool> is_at_odd_edge(triangles.size(), false);
  Edge_groups(triangles, place).for_each([&](const std::size_t* const first, const std::size_t* const last)
  {
    const std::size_t none = triangles.size();
    std::size_t pair = none, number_of_sides = 0;
    for(const std::size_t* side = first; side != last; ++side)
    {
      const std::size_t t = *side / 3;
      number_of_sides += !is_duplicate[t];
      if(is_duplicate[t] || opposite[t] == t)
        continue;
      pairs.unite(t, opposite[t]);
      if(pair != none)
        pairs.unite(t, pair);
      pair = t;
    }
    if(pair != none && number_of_sides % 2 == 1)
      is_at_odd_edge[pair] = true;
  });
  std::vector<bool> is_wrong(triangles.size(), false);
  for(std::size_t t = 0; t < triangles.size(); ++t)
    if(is_at_odd_edge[t])
      is_wrong[pairs.find(t)] = true;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    if(opposite[t] < t && is_wrong[pairs.find(t)])
      is_duplicate[t] = true;
}

inline void remove_duplicate_triangles(const std::vector<std::size_t>& place, std::vector<Triangle>& triangles)
{
  std::vector<bool> is_duplicate(triangles.size(), false);
  const std::vector<std::size_t> opposite = find_duplicates(triangles, place, is_duplicate);
  mark_reversed_duplicates(triangles, place, opposite, is_duplicate);
  remove_marked(is_duplicate, triangles);
}

#endif // FRAME_FIELDS_PROGRAMS_REMOVE_DUPLICATES_H
