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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_CONNECTIVITY_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_CONNECTIVITY_H

#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Side k of quad q runs from its vertex k to the next one; its number is 4 q + k.
inline int side_source(const Quad_complex& complex, const int side) { return complex.quads[side / 4][side % 4]; }
inline int side_target(const Quad_complex& complex, const int side) { return complex.quads[side / 4][(side + 1) % 4]; }
inline int next_side(const int side) { return side % 4 == 3 ? side - 3 : side + 1; }
inline int previous_side(const int side) { return side % 4 == 0 ? side + 3 : side - 1; }

// Which sides of quads are one edge.
struct Quad_connectivity
{
  std::vector<int> opposite;  // per side, -1 on the border
  std::vector<int> conflicts; // sides that no halfedge of a manifold can be: from a vertex to itself, of one edge with
                              // more than one other side, or with one of the same direction
};

inline Quad_connectivity connect_quads(const Quad_complex& complex)
{
  const int number_of_sides = 4 * static_cast<int>(complex.quads.size());
  // The sides sorted by the pair of their vertices.
  struct Entry
  {
    int low, high, side;
    bool operator<(const Entry& other) const
    {
      return low != other.low ? low < other.low : high != other.high ? high < other.high : side < other.side;
    }
  };
  std::vector<Entry> entries;
  entries.reserve(number_of_sides);
  for(int side = 0; side < number_of_sides; ++side)
  {
    const int s = side_source(complex, side), t = side_target(complex, side);
    entries.push_back({ (std::min)(s, t), (std::max)(s, t), side });
  }
  std::sort(entries.begin(), entries.end());

  Quad_connectivity result;
  result.opposite.assign(number_of_sides, -1);
  for(std::size_t begin = 0, end; begin < entries.size(); begin = end)
  {
    for(end = begin + 1; end < entries.size() && entries[end].low == entries[begin].low
                         && entries[end].high == entries[begin].high; ++end) {}
    const int first = entries[begin].side;
    const bool is_pair = end == begin + 2
                      && side_source(complex, first) == side_target(complex, entries[begin + 1].side);
    if(entries[begin].low == entries[begin].high || (end > begin + 1 && !is_pair))
      for(std::size_t i = begin; i < end; ++i)
        result.conflicts.push_back(entries[i].side);
    else if(is_pair)
    {
      result.opposite[first] = entries[begin + 1].side;
      result.opposite[entries[begin + 1].side] = first;
    }
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_CONNECTIVITY_H
