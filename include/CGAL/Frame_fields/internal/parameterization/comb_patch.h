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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMB_PATCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMB_PATCH_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

inline int modulo_4(const int k) { return (k % 4 + 4) % 4; }

// Numbers the branches of a patch anew: direction 0 of a face is the branch that is written. The numbers go from face
// to face in breadth-first order, from the first face on.
inline void comb_patch(const Cut_surface& surface, const Patch& patch, const std::vector<int>& matching,
                       std::vector<int>& first_branch)
{
  const int first_halfedge = 3 * patch.faces.begin_index;
  std::vector<int> matching_on_halfedges(3 * static_cast<std::size_t>(patch.faces.size()), 0);
  for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
  {
    matching_on_halfedges[surface.dual_edges[e].halfedge - first_halfedge] = modulo_4(matching[e]);
    matching_on_halfedges[surface.dual_edges[e].opposite - first_halfedge] = modulo_4(-modulo_4(matching[e]));
  }

  std::vector<char> is_reached(patch.faces.size(), false);
  std::vector<int> queue{ patch.faces.begin_index };
  queue.reserve(patch.faces.size());
  is_reached[0] = true;
  first_branch[patch.faces.begin_index] = 0;
  for(std::size_t next = 0; next < queue.size(); ++next)
    for(int h = 3 * queue[next]; h < 3 * queue[next] + 3; ++h)
    {
      if(surface.is_constrained(h))
        continue;
      const int neighbor = face_of(surface.opposite[h]);
      if(is_reached[neighbor - patch.faces.begin_index])
        continue;
      is_reached[neighbor - patch.faces.begin_index] = true;
      first_branch[neighbor] = modulo_4(first_branch[queue[next]] + matching_on_halfedges[h - first_halfedge]);
      queue.push_back(neighbor);
    }
}

// The matching of the directions as they are numbered now: -1, 0, 1 or 2, and 0 but on seams.
inline int combed_matching(const Cut_surface& surface, const std::vector<int>& matching,
                           const std::vector<int>& first_branch, const int dual_edge)
{
  const int i = face_of(surface.dual_edges[dual_edge].halfedge), j = face_of(surface.dual_edges[dual_edge].opposite);
  const int turns = modulo_4(first_branch[i] + modulo_4(matching[dual_edge]) - first_branch[j]);
  return turns == 3 ? -1 : turns;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMB_PATCH_H
