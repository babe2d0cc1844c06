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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_PATCHES_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_PATCHES_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The number of vertices less that of edges plus that of faces of a patch that is cut along its constrained edges.
inline int euler_characteristic(const Patch& patch)
{
  const int number_of_constrained_sides = 3 * patch.faces.size() - 2 * patch.dual_edges.size();
  return patch.sectors.size() - patch.dual_edges.size() - number_of_constrained_sides + patch.faces.size();
}

// Gives each face the number of its patch, patches numbered in the order of their first faces; returns their number.
inline int number_patches(const std::vector<int>& opposite, std::vector<int>& patch_of_face)
{
  const int number_of_faces = static_cast<int>(opposite.size() / 3);
  patch_of_face.assign(number_of_faces, -1);
  int number_of_patches = 0;
  std::vector<int> stack;
  for(int seed = 0; seed < number_of_faces; ++seed)
  {
    if(patch_of_face[seed] >= 0)
      continue;
    patch_of_face[seed] = number_of_patches;
    stack.push_back(seed);
    while(!stack.empty())
    {
      const int face = stack.back();
      stack.pop_back();
      for(int halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
        if(opposite[halfedge] >= 0 && patch_of_face[face_of(opposite[halfedge])] < 0)
        {
          patch_of_face[face_of(opposite[halfedge])] = number_of_patches;
          stack.push_back(face_of(opposite[halfedge]));
        }
    }
    ++number_of_patches;
  }
  return number_of_patches;
}

// Sorts the faces by patches, keeping their order inside each patch: face `order[f]` becomes face f.
inline std::vector<int> face_order_by_patches(const std::vector<int>& patch_of_face, const int number_of_patches,
                                              std::vector<Patch>& patches)
{
  std::vector<int> next_place(static_cast<std::size_t>(number_of_patches) + 1, 0);
  for(const int patch : patch_of_face)
    ++next_place[patch + 1];
  for(int patch = 0; patch < number_of_patches; ++patch)
    next_place[patch + 1] += next_place[patch];

  patches.resize(number_of_patches);
  for(int patch = 0; patch < number_of_patches; ++patch)
    patches[patch].faces = { next_place[patch], next_place[patch + 1] };

  std::vector<int> order(patch_of_face.size());
  for(std::size_t face = 0; face < patch_of_face.size(); ++face)
    order[next_place[patch_of_face[face]]++] = static_cast<int>(face);
  return order;
}

// The opposites of the halfedges after the faces are sorted: face `face_order[f]` becomes face f.
inline std::vector<int> reorder_opposites(const std::vector<int>& opposite, const std::vector<int>& face_order)
{
  std::vector<int> new_face(face_order.size());
  for(std::size_t face = 0; face < face_order.size(); ++face)
    new_face[face_order[face]] = static_cast<int>(face);

  std::vector<int> result(opposite.size());
  for(std::size_t halfedge = 0; halfedge < result.size(); ++halfedge)
  {
    const int old_opposite = opposite[3 * static_cast<std::size_t>(face_order[halfedge / 3]) + halfedge % 3];
    result[halfedge] = old_opposite < 0 ? -1 : 3 * new_face[face_of(old_opposite)] + old_opposite % 3;
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_PATCHES_H
