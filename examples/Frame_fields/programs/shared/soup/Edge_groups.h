#ifndef FRAME_FIELDS_PROGRAMS_EDGE_GROUPS_H
#define FRAME_FIELDS_PROGRAMS_EDGE_GROUPS_H

#include "Triangle.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

// The sides of triangles in groups: those of a group join the same two places.
class Edge_groups
{
public:
  Edge_groups(const std::vector<Triangle>& triangles, const std::vector<std::size_t>& place)
  {
    std::vector<Entry> entries;
    entries.reserve(3 * triangles.size());
    for(std::size_t side = 0; side < 3 * triangles.size(); ++side)
    {
      const std::size_t a = place[triangles[side / 3][side % 3]];
      const std::size_t b = place[triangles[side / 3][next_side(side) % 3]];
      entries.push_back({ (std::min)(a, b), (std::max)(a, b), side });
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& i, const Entry& j)
              { return std::tie(i.low, i.high, i.side) < std::tie(j.low, j.high, j.side); });
    m_sides.reserve(entries.size());
    for(std::size_t k = 0; k < entries.size(); ++k)
    {
      if(k == 0 || entries[k].low != entries[k - 1].low || entries[k].high != entries[k - 1].high)
        m_begins.push_back(k);
      m_sides.push_back(entries[k].side);
    }
    m_begins.push_back(entries.size());
  }

  // Calls `visit(first, last)` with a range of pointers to sides, in ascending order, for each group.
  template <typename Visit>
  void for_each(const Visit& visit) const
  {
    for(std::size_t k = 0; k + 1 < m_begins.size(); ++k)
      visit(m_sides.data() + m_begins[k], m_sides.data() + m_begins[k + 1]);
  }

private:
  struct Entry
  {
    std::size_t low, high, side;
  };

  std::vector<std::size_t> m_sides, m_begins;
};

#endif // FRAME_FIELDS_PROGRAMS_EDGE_GROUPS_H
