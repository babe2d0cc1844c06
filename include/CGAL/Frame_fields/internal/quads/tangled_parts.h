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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_TANGLED_PARTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_TANGLED_PARTS_H

#include <CGAL/Frame_fields/internal/quads/Sliding_quads.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Calls `visit(part, vertices)` for the connected parts that inverted quads form with the given number of rings of
// quads around them. Inverted quads of patches that are left out do not count. The vertices are those that may slide
// and have all their quads in the part. The calls may move them: all parts are found before.
template <typename Visit>
void for_each_tangled_part(const Sliding_quads& quads, const std::vector<char>& is_patch_left_out,
                           const int number_of_rings, const Visit& visit)
{
  std::vector<char> is_in_part(quads.number_of_quads(), false);
  std::vector<int> ring, found;
  const auto for_each_neighbor = [&](const int quad, const auto& visit_neighbor)
  {
    for(const int v : quads.quad(quad))
      for(const int* c = quads.corners_begin(v); c != quads.corners_end(v); ++c)
        visit_neighbor(*c / 4);
  };
  for(int q = 0; q < quads.number_of_quads(); ++q)
    if(quads.shape(q).scaled_jacobian <= 0 && !is_patch_left_out[quads.patch(q)])
    {
      is_in_part[q] = true;
      ring.push_back(q);
    }
  const std::vector<int> seeds = ring;
  for(int i = 0; i < number_of_rings; ++i)
  {
    found.clear();
    for(const int q : ring)
      for_each_neighbor(q, [&](const int neighbor)
      {
        if(!is_in_part[neighbor])
          found.push_back(neighbor);
        is_in_part[neighbor] = true;
      });
    ring.swap(found);
  }

  std::vector<char> is_done(quads.number_of_quads(), false), is_taken(quads.number_of_vertices(), false);
  for(const int seed : seeds)
  {
    if(is_done[seed])
      continue;
    std::vector<int> part(1, seed), vertices;
    is_done[seed] = true;
    for(std::size_t i = 0; i < part.size(); ++i)
      for_each_neighbor(part[i], [&](const int neighbor)
      {
        if(is_in_part[neighbor] && !is_done[neighbor])
        {
          is_done[neighbor] = true;
          part.push_back(neighbor);
        }
      });
    for(const int q : part)
      for(const int v : quads.quad(q))
        if(!is_taken[v] && quads.freedom(v) != Sliding_quads::FIXED
           && std::all_of(quads.corners_begin(v), quads.corners_end(v), [&](const int c) { return is_in_part[c / 4]; }))
        {
          is_taken[v] = true;
          vertices.push_back(v);
        }
    visit(part, vertices);
  }
}

// The vertices of the tangled parts with five rings around them.
inline std::vector<int> tangled_vertices(const Sliding_quads& quads, const std::vector<char>& is_patch_left_out)
{
  const int number_of_rings = 5;
  std::vector<int> result;
  for_each_tangled_part(quads, is_patch_left_out, number_of_rings,
                        [&](const std::vector<int>& part, const std::vector<int>&)
  {
    for(const int q : part)
      result.insert(result.end(), quads.quad(q).begin(), quads.quad(q).end());
  });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_TANGLED_PARTS_H
