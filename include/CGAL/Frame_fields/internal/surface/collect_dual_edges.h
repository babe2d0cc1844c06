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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COLLECT_DUAL_EDGES_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COLLECT_DUAL_EDGES_H

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>
#include <CGAL/Frame_fields/internal/surface/weights.h>

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// c_ij in radians, from -pi to pi. Then c_ji = -c_ij, and the matching can be used without the order of the faces here;
// only where both halfedges have the same angle, c_ij is -pi from both sides.
inline double transport_across(const Cut_surface& surface, const Dual_edge& e)
{
  const double angle = halfedge_angle(surface, e.halfedge) - halfedge_angle(surface, e.opposite); // between +-2 pi
  return angle < 0 ? angle + CGAL_PI : angle - CGAL_PI;
}

// Calls `visit(dual_edge)` for the dual edges of a patch, in the order of the halfedges.
template <typename Visit>
void for_each_dual_edge(const Cut_surface& surface, const Patch& patch, const Visit& visit)
{
  for(int halfedge = 3 * patch.faces.begin_index; halfedge < 3 * patch.faces.end_index; ++halfedge)
    if(surface.opposite[halfedge] >= halfedge)
      visit(Dual_edge{ halfedge, surface.opposite[halfedge] });
}

// Gives each patch its interval of dual edges; returns their number.
inline int number_dual_edges(Cut_surface& surface)
{
  int number = 0;
  for(Patch& patch : surface.patches)
  {
    patch.dual_edges.begin_index = number;
    for_each_dual_edge(surface, patch, [&](const Dual_edge&) { ++number; });
    patch.dual_edges.end_index = number;
  }
  return number;
}

// Sets the dual edges of a surface with patches and angles, their transports and their weights.
template <typename ConcurrencyTag>
void collect_dual_edges(Cut_surface& surface, const Edge_weighting weighting)
{
  surface.edge_weighting = weighting;
  const int number_of_dual_edges = number_dual_edges(surface);
  surface.dual_edges.resize(number_of_dual_edges);
  surface.transport.resize(number_of_dual_edges);
  surface.weight.resize(number_of_dual_edges);
  for_each_patch<ConcurrencyTag>(surface, [&](const int number)
  {
    const Patch& patch = surface.patches[number];
    int i = patch.dual_edges.begin_index;
    for_each_dual_edge(surface, patch, [&](const Dual_edge& e)
    {
      surface.dual_edges[i] = e;
      surface.transport[i] = transport_across(surface, e);
      surface.weight[i] = edge_weight(surface, e, weighting);
      ++i;
    });
    return Patch_result();
  });
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_COLLECT_DUAL_EDGES_H
