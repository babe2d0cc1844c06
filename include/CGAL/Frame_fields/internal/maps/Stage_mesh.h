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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_STAGE_MESH_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_STAGE_MESH_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/read_guidance.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_cutter.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_reader.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

template <typename TriangleMesh>
Result find_overconstrained_face(const Cut_mesh<TriangleMesh>& cut_mesh)
{
  const Cut_surface& surface = cut_mesh.surface();
  for(int f = 0; f < surface.number_of_faces(); ++f)
  {
    int number_of_constrained_edges = 0;
    for(int k = 0; k < 3; ++k)
      number_of_constrained_edges += surface.is_constrained(3 * f + k);
    if(number_of_constrained_edges > 1)
      return failure(ERROR_OVERCONSTRAINED_FACE,
                     cut_mesh.description_of_face(f) + "; call split_overconstrained_faces() before");
  }
  return {};
}

// The cut mesh that a public function works on, with the guidance and the index targets of its named parameters.
template <typename TriangleMesh, typename NamedParameters>
class Stage_mesh
{
public:
  Stage_mesh(const TriangleMesh& tm, const NamedParameters& np) : m_mesh(tm), m_np(np) {}

  Result cut(const Options& options, const bool accepts_overconstrained_faces = false)
  {
    Result result = Mesh_cutter<TriangleMesh, NamedParameters>(m_mesh, m_np)
                      .cut(options.edge_weighting, options.needs_lengths(), m_cut_mesh);
    if(result && !accepts_overconstrained_faces)
      result = find_overconstrained_face(m_cut_mesh);
    if(!result)
      return result;
    return read_guidance_and_targets(m_cut_mesh, m_np, Geom_traits_from<TriangleMesh, NamedParameters>::get(m_np));
  }

  const Cut_mesh<TriangleMesh>& cut_mesh() const { return m_cut_mesh; }

private:
  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  Cut_mesh<TriangleMesh> m_cut_mesh;
};

template <typename StageMesh>
Result check_and_cut(const Options& options, StageMesh& stage_mesh)
{
  const Result result = check(options);
  return result ? stage_mesh.cut(options) : result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_STAGE_MESH_H
