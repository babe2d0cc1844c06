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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMBING_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMBING_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The charts of the faces of one patch. Charts joined by an edge of a spanning tree of dual edges agree; across the
// other edges they differ by quarter turns.
struct Combing
{
  std::vector<unsigned char> turn;          // per face of the patch: its branch k is branch k + turn of the field
  std::vector<unsigned char> quarter_turns; // per halfedge of the patch: from its chart to the one across, 0 to 3
  std::vector<char> is_crossed;             // per halfedge of the patch: whether the tree crosses its edge
};

inline unsigned char modulo_4(const int quarter_turns) { return static_cast<unsigned char>(quarter_turns & 3); }

// The quarter turns that the matching of the field makes across each halfedge of the patch.
inline std::vector<unsigned char> matching_on_halfedges(const Cut_surface& surface, const Patch& patch,
                                                        const std::vector<int>& matching)
{
  const int first = 3 * patch.faces.begin_index;
  std::vector<unsigned char> result(3 * static_cast<std::size_t>(patch.faces.size()), 0);
  for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
  {
    result[surface.dual_edges[e].halfedge - first] = modulo_4(matching[e]);
    result[surface.dual_edges[e].opposite - first] = modulo_4(-modulo_4(matching[e]));
  }
  return result;
}

// Grows the spanning tree breadth-first from the face `root`, so that the edges it does not cross, once pruned, form
// short cuts that lead away from the root.
inline Combing comb(const Cut_surface& surface, const Patch& patch, const std::vector<int>& matching, const int root)
{
  const int first_face = patch.faces.begin_index, first_halfedge = 3 * first_face;
  const std::vector<unsigned char> matched = matching_on_halfedges(surface, patch, matching);
  Combing result;
  result.turn.assign(patch.faces.size(), 0);
  result.is_crossed.assign(matched.size(), false);

  std::vector<char> is_reached(patch.faces.size(), false);
  std::vector<int> queue(1, root);
  queue.reserve(patch.faces.size());
  is_reached[root - first_face] = true;
  for(std::size_t place = 0; place < queue.size(); ++place)
  {
    const int face = queue[place];
    for(int halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
    {
      const int opposite = surface.opposite[halfedge];
      if(opposite < 0 || is_reached[face_of(opposite) - first_face])
        continue;
      const int neighbor = face_of(opposite);
      is_reached[neighbor - first_face] = true;
      result.turn[neighbor - first_face] =
        modulo_4(result.turn[face - first_face] + matched[halfedge - first_halfedge]);
      result.is_crossed[halfedge - first_halfedge] = result.is_crossed[opposite - first_halfedge] = true;
      queue.push_back(neighbor);
    }
  }

  result.quarter_turns.assign(matched.size(), 0);
  for(int halfedge = first_halfedge; halfedge < 3 * patch.faces.end_index; ++halfedge)
    if(!surface.is_constrained(halfedge))
      result.quarter_turns[halfedge - first_halfedge] =
        modulo_4(matched[halfedge - first_halfedge] + result.turn[face_of(halfedge) - first_face]
                 - result.turn[face_of(surface.opposite[halfedge]) - first_face]);
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMBING_H
