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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_T_MESHES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_T_MESHES_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/make_T_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The T-meshes of all patches. Those without one get an empty one; the result says why.
template <typename ConcurrencyTag>
std::vector<T_mesh_status> make_T_meshes(const Cut_surface& surface, const Surface_embedding& embedding,
                                         const std::vector<int>& index, const Seamless_map& map,
                                         const Feature_network& features, std::vector<T_mesh>& t_meshes)
{
  std::vector<char> is_arc_node(surface.number_of_sectors(), 0);
  for(int s = 0; s < surface.number_of_sectors(); ++s)
    is_arc_node[s] =
      surface.is_constrained_sector(s) && features.is_node[embedding.vertex[surface.first_corner[s]]];
  std::vector<T_mesh_status> status(surface.patches.size());
  t_meshes.resize(surface.patches.size());
  for_each_patch<ConcurrencyTag>(surface, [&](const int patch)
  {
    T_mesh_result result = make_T_mesh(surface, surface.patches[patch], index, map, is_arc_node);
    t_meshes[patch] = std::move(result.mesh);
    status[patch] = result.status;
    return Patch_result();
  });
  return status;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_T_MESHES_H
