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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_EMBED_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_EMBED_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Reads where a cut mesh lies in space. The vertices are numbered in the order in which the flat halfedges first point
// to them; isolated vertices have no number. Points are in units of `length_unit`. Takes linear time.
template <typename CutMesh>
Surface_embedding embed(const CutMesh& cut_mesh)
{
  const auto& tm = cut_mesh.mesh();
  const Cut_surface& surface = cut_mesh.surface();
  const auto vertex_number = get(CGAL::dynamic_vertex_property_t<int>(), tm);
  const auto halfedge_number = get(CGAL::dynamic_halfedge_property_t<int>(), tm);
  cut_mesh.for_each_halfedge([&](const auto h, const int i)
  {
    put(halfedge_number, h, i);
    put(vertex_number, target(h, tm), -1);
  });

  Surface_embedding embedding;
  embedding.vertex.reserve(surface.number_of_halfedges());
  embedding.twin.reserve(surface.number_of_halfedges());
  for(int i = 0; i < surface.number_of_halfedges(); ++i)
  {
    const auto h = cut_mesh.halfedge_of(i);
    const auto v = target(h, tm);
    if(get(vertex_number, v) < 0)
    {
      put(vertex_number, v, static_cast<int>(embedding.point.size()));
      embedding.point.push_back(cut_mesh.coordinates(v) / surface.length_unit);
    }
    embedding.vertex.push_back(get(vertex_number, v));
    embedding.twin.push_back(get(halfedge_number, opposite(h, tm)));
  }
  return embedding;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_EMBED_H
