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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PROPOSE_INDEX_TARGETS_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PROPOSE_INDEX_TARGETS_H

#include <CGAL/Frame_fields/internal/parameterization/Combed_field.h>
#include <CGAL/Frame_fields/internal/parameterization/Combing.h>
#include <CGAL/Frame_fields/internal/parameterization/Cut_graph.h>
#include <CGAL/Frame_fields/internal/parameterization/Map_basis.h>
#include <CGAL/Frame_fields/internal/parameterization/one_pair_on_torus.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The way along edges of a patch from a sector to the nearest one whose index has a given sign.
struct Way_to_index
{
  int sector = -1; // -1 if there is none
  double length = (std::numeric_limits<double>::infinity)();
};

inline Way_to_index nearest_index(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index,
                                  const int start, const int sign)
{
  typedef std::pair<double, int> Entry; // distance, sector
  const int first = patch.sectors.begin_index;
  std::vector<double> distance(patch.sectors.size(), (std::numeric_limits<double>::infinity)());
  std::vector<Entry> queue(1, { 0, start });
  distance[start - first] = 0;
  const auto reach = [&](const int s, const double new_distance)
  {
    if(!(new_distance < distance[s - first]))
      return;
    distance[s - first] = new_distance;
    queue.emplace_back(new_distance, s);
    std::push_heap(queue.begin(), queue.end(), std::greater<Entry>());
  };
  while(!queue.empty())
  {
    const Entry entry = queue.front();
    std::pop_heap(queue.begin(), queue.end(), std::greater<Entry>());
    queue.pop_back();
    if(entry.first > distance[entry.second - first])
      continue;
    if(index[entry.second] * sign > 0)
      return { entry.second, entry.first };
    for_each_corner(surface.opposite, surface.first_corner[entry.second], [&](const int corner)
    {
      reach(surface.sector[previous_of(corner)], entry.first + surface.length[corner]);
      reach(surface.sector[next_of(corner)], entry.first + surface.length[next_of(corner)]);
    });
  }
  return {};
}

// The sectors of a positive and of a negative index that should each come nearer to 0 by a quarter: those at the ends
// of the side of length 0, or else the nearest pair with one of these. -1 if there are none.
inline std::array<int, 2> pair_at_side(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index,
                                       const std::array<int, 2>& ends)
{
  std::array<int, 2> best{ { -1, -1 } };
  const auto pair = [&](const int a, const int b)
  {
    return index[a] > 0 ? std::array<int, 2>{ { a, b } } : std::array<int, 2>{ { b, a } };
  };
  if((index[ends[0]] > 0 && index[ends[1]] < 0) || (index[ends[0]] < 0 && index[ends[1]] > 0))
    return pair(ends[0], ends[1]);
  double least_length = (std::numeric_limits<double>::infinity)();
  for(const int end : ends)
  {
    if(index[end] == 0)
      continue;
    const Way_to_index way = nearest_index(surface, patch, index, end, index[end] > 0 ? -1 : 1);
    if(way.length < least_length)
    {
      least_length = way.length;
      best = pair(end, way.sector);
    }
  }
  return best;
}

// Where the indices of a patch leave no length to a side, as around a ring with a step, or where they are those of a
// torus with one pair, there is no map. Then this sets the targets of all sectors of the patch to their indices, but
// lowers a positive one and raises a negative one by a quarter. The caller computes the field of the patch anew with
// these targets. Returns whether there is such a pair.
inline bool propose_index_targets(const Cut_surface& surface, const Patch& patch, const std::vector<double>& alpha,
                                  const std::vector<double>& rho, const std::vector<int>& matching,
                                  const std::vector<int>& index, std::vector<int>& index_target)
{
  std::array<int, 2> pair = one_pair_on_torus(surface, patch, index);
  if(pair[0] < 0)
  {
    const Combing combing = comb(surface, patch, matching, patch.faces.begin_index);
    const Cut_graph graph = Patch_cutter(surface, patch, index, combing).cut();
    const Combed_field field(surface, patch, alpha, rho, combing);
    const Map_basis basis(surface, patch, index, graph, field);
    if(basis.has_forced_zero_side())
      pair = pair_at_side(surface, patch, index, basis.forced_zero_side());
  }
  if(pair[0] < 0)
    return false;
  std::copy(index.begin() + patch.sectors.begin_index, index.begin() + patch.sectors.end_index,
            index_target.begin() + patch.sectors.begin_index);
  --index_target[pair[0]];
  ++index_target[pair[1]];
  return true;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PROPOSE_INDEX_TARGETS_H
