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

#include <CGAL/Frame_fields/Cut_triangle_mesh.h>
#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/read_guidance.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_cutter.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_reader.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <string>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// An error that names the first face with more than one constrained edge, or success.
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
template <typename Mesh, typename NamedParameters>
class Stage_mesh
{
public:
  typedef Mesh Triangle_mesh;
  typedef typename Geom_traits_from<Triangle_mesh, NamedParameters>::type Geom_traits;

  Stage_mesh(const Triangle_mesh& tm, const NamedParameters& np)
    : m_mesh(tm), m_np(np), m_traits(Geom_traits_from<Triangle_mesh, NamedParameters>::get(np))
  {}

  Result cut(const Options& options, const bool accepts_overconstrained_faces = false)
  {
    Result result = Mesh_cutter<Triangle_mesh, NamedParameters>(m_mesh, m_np)
                      .cut(options.edge_weighting, options.needs_lengths(), m_cut_mesh);
    if(result && !accepts_overconstrained_faces)
      result = find_overconstrained_face(m_cut_mesh);
    return result ? read_guidance_and_targets(m_cut_mesh, m_np, m_traits) : result;
  }

  Cut_mesh<Triangle_mesh>& cut_mesh() { return m_cut_mesh; }
  const Cut_mesh<Triangle_mesh>& cut_mesh() const { return m_cut_mesh; }
  const Geom_traits& traits() const { return m_traits; }

private:
  const Triangle_mesh& m_mesh;
  const NamedParameters& m_np;
  Geom_traits m_traits;
  Cut_mesh<Triangle_mesh> m_cut_mesh;
};

// The same for a mesh that the caller has cut before. It is not changed: guidance and index targets go into a copy,
// which is made only if they are given.
template <typename TriangleMesh, typename GeomTraits, typename NamedParameters>
class Stage_mesh<Cut_triangle_mesh<TriangleMesh, GeomTraits>, NamedParameters>
{
  static_assert(!is_given<NamedParameters, CGAL::internal_np::edge_is_constrained_t>,
                "edge_is_constrained_map is a named parameter of the constructor of Cut_triangle_mesh.");
  static_assert(!is_given<NamedParameters, CGAL::internal_np::vertex_point_t>,
                "vertex_point_map is a named parameter of the constructor of Cut_triangle_mesh.");
  static_assert(!is_given<NamedParameters, CGAL::internal_np::geom_traits_t>,
                "geom_traits is a named parameter of the constructor of Cut_triangle_mesh.");
  static_assert(!is_given<NamedParameters, internal::edge_weighting_t>,
                "edge_weighting is a named parameter of the constructor of Cut_triangle_mesh.");

public:
  typedef TriangleMesh Triangle_mesh;
  typedef typename Cut_triangle_mesh<TriangleMesh, GeomTraits>::Geom_traits Geom_traits;

  Stage_mesh(const Cut_triangle_mesh<TriangleMesh, GeomTraits>& cut, const NamedParameters& np)
    : m_kept(cut), m_np(np), m_cut_mesh(&cut.m_cut_mesh)
  {}

  Result cut(const Options&, const bool accepts_overconstrained_faces = false)
  {
    Result result = m_kept.result();
    if(result && num_faces(m_kept.triangle_mesh()) != m_kept.m_number_of_faces)
      result = failure(ERROR_MESH_CHANGED, std::to_string(m_kept.m_number_of_faces) + " faces then, "
                                           + std::to_string(num_faces(m_kept.triangle_mesh())) + " now");
    if(result && !accepts_overconstrained_faces)
      result = find_overconstrained_face(*m_cut_mesh);
    if(!result)
      return result;
    if constexpr(is_given<NamedParameters, internal::guiding_direction_t>
                 || is_given<NamedParameters, internal::index_target_t>)
    {
      m_guided = m_kept.m_cut_mesh;
      m_cut_mesh = &m_guided;
      return read_guidance_and_targets(m_guided, m_np, traits());
    }
    return {};
  }

  const Cut_mesh<Triangle_mesh>& cut_mesh() const { return *m_cut_mesh; }
  const Geom_traits& traits() const { return m_kept.m_traits; }

private:
  const Cut_triangle_mesh<TriangleMesh, GeomTraits>& m_kept;
  const NamedParameters& m_np;
  const Cut_mesh<Triangle_mesh>* m_cut_mesh;
  Cut_mesh<Triangle_mesh> m_guided;
};

// Cuts the mesh unless an option is out of range.
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
