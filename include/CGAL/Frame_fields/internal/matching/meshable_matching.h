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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MATCHING_MESHABLE_MATCHING_H
#define CGAL_FRAME_FIELDS_INTERNAL_MATCHING_MESHABLE_MATCHING_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/matching/Convex_flow.h>
#include <CGAL/Frame_fields/internal/matching/Sector_graph.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Whether a sector is on constrained edges and has an index that leaves no room for a quadrangle: 4 I is more than 1.
inline bool is_unmeshable(const Cut_surface& surface, const std::vector<int>& index, const int sector)
{
  return index[sector] > maximum_meshable_index && surface.is_constrained_sector(sector);
}

// Changes the matching of one patch, and its indices with it, until the index of each sector is between two bounds.
// The given matching must be nearest to omega. Then the new one has the least sum w (r - omega)^2 for the given alpha
// among all matchings that change the indices of the sectors out of bounds by as much.
class Meshable_matching
{
public:
  Meshable_matching(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                    const std::vector<double>& alpha, std::vector<int>& matching, std::vector<int>& index)
    : m_surface(surface), m_graph(surface, patch, omega, alpha, matching, index), m_flow(m_graph)
  {}

  // Gives every sector its target. The targets must sum to what the patch has.
  void meet_index_targets()
  {
    for(int node = 0; node < m_graph.number_of_nodes(); ++node)
      m_graph.lower_bound(node) = m_graph.upper_bound(node) = target_of_sector(m_surface, m_graph.sector(node));
    take_what_is_too_much();
    add_what_is_missing();
  }

  // Gives each sector on constrained edges its natural index, as far as the sectors inside can make up for it. No 4 I
  // inside becomes more than 1. It falls below -1 only when all sectors inside are at their lower bounds; then the
  // bounds go down evenly.
  void make_natural()
  {
    for(int node = 0; node < m_graph.number_of_nodes(); ++node)
    {
      m_graph.lower_bound(node) = is_inside(node) ? (std::min)(-1, m_graph.index(node)) : natural_index_of(node);
      m_graph.upper_bound(node) = is_inside(node) ? maximum_meshable_index : natural_index_of(node);
    }
    take_what_is_too_much();
    while(!add_what_is_missing() && lower_bounds_inside()) {}
  }

  // For patches that have too little room for natural indices: moves what a sector on constrained edges has above the
  // largest meshable index to other sectors on constrained edges or, if all of these are full, to sectors inside.
  void make_meshable()
  {
    for(const bool goes_inside : { false, true })
    {
      for(int node = 0; node < m_graph.number_of_nodes(); ++node)
        m_graph.upper_bound(node) = is_inside(node) ? (goes_inside ? largest_index_target : m_graph.index(node))
                                                    : maximum_meshable_index;
      m_flow.join_to_hub(Flow::OUT, [this](const int node) { return m_graph.has_room(node); });
      take_what_is_too_much();
    }
  }

  // Moves what one sector has above 0 to sectors below 0, as far as there are any. May be called for one sector after
  // another, as no sector gets room that it did not have before. Takes time linear in the number of sectors of the
  // patch, besides the searches.
  void cancel_with_negative(const int sector)
  {
    for(int node = 0; node < m_graph.number_of_nodes(); ++node)
      m_graph.upper_bound(node) = (std::max)(0, m_graph.index(node));
    const int node = m_graph.node_of_sector(sector);
    m_graph.upper_bound(node) = 0;
    while(m_graph.has_too_much(node) && move_index(node, Flow::OUT)) {}
  }

private:
  typedef Convex_flow<Sector_graph> Flow;

  bool is_inside(const int node) const { return !m_surface.is_constrained_sector(m_graph.sector(node)); }
  int natural_index_of(const int node) const { return natural_index(m_surface, m_graph.sector(node)); }

  // Moves an index of 1/4 from the sector (`OUT`) or to it (`IN`). Returns false if no other sector can take or give
  // it.
  bool move_index(const int node, const Flow::Direction direction)
  {
    const int end = m_flow.move_unit(node, direction);
    if(end < 0)
      return false;
    const int change = direction == Flow::OUT ? -1 : 1;
    m_graph.index(node) += change;
    m_graph.index(end) -= change;
    return true;
  }

  // Moves what sectors have above their upper bounds to sectors with room. The sectors on constrained edges come first,
  // so that they get the room if there is too little for all.
  void take_what_is_too_much()
  {
    for(const bool are_inside : { false, true })
      for(int node = 0; node < m_graph.number_of_nodes(); ++node)
        while(is_inside(node) == are_inside && m_graph.has_too_much(node))
          if(!move_index(node, Flow::OUT))
            return; // no sector has room
  }

  // Moves indices to the sectors below their lower bounds. Returns false if something is missing but no sector can
  // give.
  bool add_what_is_missing()
  {
    for(int node = 0; node < m_graph.number_of_nodes(); ++node)
      while(m_graph.has_too_little(node))
        if(!move_index(node, Flow::IN))
          return false;
    return true;
  }

  // Lowers the lower bounds of all sectors inside by the same number, so that they share evenly in what is missing. All
  // must be at their lower bounds. Returns false if there is no sector inside.
  bool lower_bounds_inside()
  {
    int number_inside = 0, missing = 0;
    for(int node = 0; node < m_graph.number_of_nodes(); ++node)
    {
      number_inside += is_inside(node);
      missing += (std::max)(0, m_graph.lower_bound(node) - m_graph.index(node));
    }
    if(number_inside == 0)
      return false;
    for(int node = 0; node < m_graph.number_of_nodes(); ++node)
      if(is_inside(node))
      {
        m_graph.upper_bound(node) = m_graph.lower_bound(node);
        m_graph.lower_bound(node) -= (std::max)(1, missing / number_inside);
      }
    m_flow.join_to_hub(Flow::IN, [this](const int node) { return m_graph.has_spare(node); });
    return true;
  }

  const Cut_surface& m_surface;
  Sector_graph m_graph;
  Flow m_flow;
};

// A sector whose index was changed, and 4 I as the rounding left it.
struct Repaired_sector
{
  int sector, rounded_index;
};

// The sectors of a patch whose index is not the rounded one any more.
inline std::vector<Repaired_sector> changed_sectors(const Patch& patch, const std::vector<int>& rounded_index_in_patch,
                                                    const std::vector<int>& index)
{
  std::vector<Repaired_sector> result;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
  {
    const int rounded_index = rounded_index_in_patch[s - patch.sectors.begin_index];
    if(rounded_index != index[s])
      result.push_back({ s, rounded_index });
  }
  return result;
}

// The indices of the sectors of the patch.
inline std::vector<int> index_in_patch(const Patch& patch, const std::vector<int>& index)
{
  return std::vector<int>(index.begin() + patch.sectors.begin_index, index.begin() + patch.sectors.end_index);
}

// The sum over the sectors of how far 4 I is from natural: from the natural index on constrained edges, above the
// largest meshable index inside.
inline long long quarters_to_move(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index)
{
  long long sum = 0;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(surface.is_constrained_sector(s))
      sum += std::abs(static_cast<long long>(index[s]) - natural_index(surface, s));
    else
      sum += (std::max)(0, index[s] - maximum_meshable_index);
  return sum;
}

// Whether any sector of the patch is unmeshable.
inline bool has_unmeshable_sector(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index)
{
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    if(is_unmeshable(surface, index, s))
      return true;
  return false;
}

// Brings each sector on constrained edges of the patch to its natural index and each one inside to one that can be
// meshed, and keeps the indices up to date. Returns the sectors whose index changed. A patch that needs more than
// `largest_index_target` moves and 8 for each sector is left as it is.
inline std::vector<Repaired_sector> repair_patch(const Cut_surface& surface, const Patch& patch,
                                                 const std::vector<double>& omega, const std::vector<double>& alpha,
                                                 std::vector<int>& matching, std::vector<int>& index)
{
  const long long number_of_moves = quarters_to_move(surface, patch, index);
  // Angles and rounding ask for a few moves in each sector. Many more come only from a rotation that the caller
  // prescribed, and each takes a search: the repair would not end in reasonable time.
  if(number_of_moves == 0 || number_of_moves > largest_index_target + 8LL * patch.sectors.size())
    return {};

  const std::vector<int> rounded_index = index_in_patch(patch, index);
  Meshable_matching meshable_matching(surface, patch, omega, alpha, matching, index);
  meshable_matching.make_natural();
  if(has_unmeshable_sector(surface, patch, index))
    meshable_matching.make_meshable();
  return changed_sectors(patch, rounded_index, index);
}

// How far 4 I of a sector is from its target.
inline long long distance_from_target(const Cut_surface& surface, const std::vector<int>& index, const int sector)
{
  return std::abs(static_cast<long long>(index[sector]) - target_of_sector(surface, sector));
}

// More quarters than the indices of a patch can be away from their targets, together, unless the caller prescribed a
// rotation that has nothing to do with these.
//
// Let n be the number of corners of a sector. Of the r nearest to omega, each differs from it by at most an eighth of a
// turn, so 4 I differs by at most n / 2 from what omega asks for. If omega meets the targets, that is all; if omega is
// 0, it asks for 4 I = 4 - 2 angle / pi inside and 2 - 2 angle / pi on constrained edges. All n sum to three times the
// number of faces and all angles to pi times it, so what is missing sums to at most 3.5 quarters for each face, 4 for
// each sector, and the targets themselves. The rest is for rotations that are prescribed for a few other indices.
inline long long most_quarters_from_targets(const Cut_surface& surface, const Patch& patch)
{
  long long sum = largest_index_target + 8LL * patch.faces.size() + 8LL * patch.sectors.size();
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    sum += std::abs(target_of_sector(surface, s));
  return sum;
}

// Gives every sector of the patch its target; the targets must sum to what the patch has. Tells which sectors changed.
// Each move brings two sectors nearer to their targets by a quarter, and each takes a search. So a patch is left as it
// is that needs more of them than its targets can ask for: returns `ERROR_WRONG_FIELD` with the sector farthest from
// its target.
inline Patch_result enforce_index_targets(const Cut_surface& surface, const Patch& patch,
                                          const std::vector<double>& omega, const std::vector<double>& alpha,
                                          std::vector<int>& matching, std::vector<int>& index,
                                          std::vector<Repaired_sector>& repaired_sectors)
{
  long long number_of_quarters = 0;
  int farthest = patch.sectors.begin_index;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
  {
    number_of_quarters += distance_from_target(surface, index, s);
    if(distance_from_target(surface, index, s) > distance_from_target(surface, index, farthest))
      farthest = s;
  }
  if(number_of_quarters > most_quarters_from_targets(surface, patch))
    return { ERROR_WRONG_FIELD, farthest };

  const std::vector<int> rounded_index = index_in_patch(patch, index);
  Meshable_matching(surface, patch, omega, alpha, matching, index).meet_index_targets();
  repaired_sectors = changed_sectors(patch, rounded_index, index);
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MATCHING_MESHABLE_MATCHING_H
