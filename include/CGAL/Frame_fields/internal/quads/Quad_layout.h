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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_LAYOUT_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_LAYOUT_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where the quads of a patch come from: its T-mesh, a new triangulation with triangles of about the size of the quads,
// or the triangles of the mesh, each split into three quads.
enum class Patch_source { T_MESH, FILLING, SPLIT_TRIANGLES };

// What the stages before the assembly have found: one T-mesh per patch, without cells where the patch has no certified
// map, and the number of quad edges of each piece and arc.
struct Quad_layout
{
  const Cut_surface& surface;
  const Surface_embedding& embedding;
  const Feature_network& network;
  const Seamless_map& map;
  const std::vector<T_mesh>& t_meshes;
  const std::vector<Patch_source>& sources; // per patch
  const Arc_sides& sides;
  const std::vector<std::vector<int> >& edges_of_piece; // per patch
  const std::vector<int>& edges_of_arc;
  const std::vector<std::vector<int> >& breakpoints; // per arc: places where it must have a vertex
  const std::vector<double>& arc_tolerance;          // per arc: how far sides of quads may be from it
};

// Whether a patch beside an arc is made of split triangles.
inline bool is_beside_split_patch(const Arc_sides& sides, const std::vector<Patch_source>& sources, const int arc)
{
  return std::any_of(sides[arc].begin(), sides[arc].end(), [&](const Arc_side& side)
                     { return side.patch >= 0 && sources[side.patch] == Patch_source::SPLIT_TRIANGLES; });
}

// Per patch: the arcs along it, in increasing order.
inline std::vector<std::vector<int> > arcs_of_patches(const Arc_sides& sides, const std::size_t number_of_patches)
{
  std::vector<std::vector<int> > result(number_of_patches);
  for(std::size_t a = 0; a < sides.size(); ++a)
    for(const Arc_side& side : sides[a])
      if(side.patch >= 0 && (result[side.patch].empty() || result[side.patch].back() != static_cast<int>(a)))
        result[side.patch].push_back(static_cast<int>(a));
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_LAYOUT_H
