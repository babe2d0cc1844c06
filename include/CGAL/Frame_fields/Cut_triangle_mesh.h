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

#ifndef CGAL_FRAME_FIELDS_CUT_TRIANGLE_MESH_H
#define CGAL_FRAME_FIELDS_CUT_TRIANGLE_MESH_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_cutter.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_reader.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>

/// \file Cut_triangle_mesh.h

namespace CGAL {
namespace Frame_fields {

namespace internal {

template <typename TriangleMesh, typename NamedParameters>
class Stage_mesh;

} // namespace internal

/*!
\ingroup PkgFrame_fieldsRef

is a triangle mesh that is cut along its constrained edges, once for all functions that are called for it.

Each function that computes, reads or measures a field cuts the mesh first. Where several are called for the same mesh,
a `Cut_triangle_mesh` can be passed to each in place of the mesh; the results are the same, bit for bit. The functions
are `cad_frame_field()`, `cad_quad_mesh()`, `comb_frame_field()`, `frame_field_from_vectors()`,
`frame_field_quality()`, `orthogonal_frame_field()`, `prescribe_rotation()`, `quad_mesh()`, `relax_frame_field()`,
`seamless_parameterization()`, `sharp_corners()`, `singularities()`, `singularity_indices()` and `trace_streamlines()`.

The points, the constrained edges and the weights of the edges are those given to the constructor. So these functions
do not compile with a `Cut_triangle_mesh` and one of the named parameters `edge_is_constrained_map`,
`vertex_point_map`, `geom_traits` or `edge_weighting`. All other named parameters are given to them as ever, also those
that guide the field.

The object refers to the mesh and holds copies of the maps. Neither the mesh nor what these maps hold may change as
long as it is used; a mesh with another number of faces gives `ERROR_MESH_CHANGED`. Functions only read the object, so
several threads may share it.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam GeomTraits a model of `Kernel`, the one of the points by default
*/
template <typename TriangleMesh, typename GeomTraits = CGAL::Default>
class Cut_triangle_mesh
{
public:
  /// the geometric traits class
  typedef
#ifdef DOXYGEN_RUNNING
    unspecified_type
#else
    typename CGAL::Default::Lazy_get<GeomTraits, CGAL::GetGeomTraits<TriangleMesh> >::type
#endif
    Geom_traits;

  /*!
  cuts a mesh.

  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param tm the mesh
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{edge_is_constrained_map}
      \cgalParamDescription{a property map containing the feature edges of `tm`; border edges always count as such}
      \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                     as key type and `bool` as value type}
      \cgalParamDefault{a constant property map returning `false` for any edge}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{a property map associating points to the vertices of `tm`}
      \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                     as key type and `%Point_3` as value type}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
    \cgalParamNEnd
    \cgalParamNBegin{geom_traits}
      \cgalParamDescription{an instance of a geometric traits class}
      \cgalParamType{`Geom_traits`}
      \cgalParamDefault{`Geom_traits()`}
      \cgalParamExtra{Only the coordinates of points are read; all computation is in `double`.}
    \cgalParamNEnd
    \cgalParamNBegin{edge_weighting}
      \cgalParamDescription{the weights of the edges in all sums}
      \cgalParamType{`Edge_weighting`}
      \cgalParamDefault{`Edge_weighting::UNIFORM`}
    \cgalParamNEnd
    \cgalParamNBegin{concurrency_tag}
      \cgalParamDescription{tells whether patches are cut in parallel; the result is the same, bit for bit}
      \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
      \cgalParamDefault{`CGAL::Sequential_tag`}
      \cgalParamExtra{`CGAL::Parallel_tag` requires TBB.}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  Faces with several constrained edges are accepted; the functions that cannot treat them say so.

  \cgalBigO{n} for \f$ n \f$ faces.
  */
  template <typename CGAL_NP_TEMPLATE_PARAMETERS>
  explicit Cut_triangle_mesh(const TriangleMesh& tm, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
    : m_mesh(&tm), m_number_of_faces(num_faces(tm)), m_traits(traits_from(np))
  {
    const bool measures_lengths = true;
    m_result = internal::Mesh_cutter<TriangleMesh, CGAL_NP_CLASS>(tm, np).cut(
      internal::options_from(np).edge_weighting, measures_lengths, m_cut_mesh);
  }

  /// returns whether the mesh could be cut: `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`,
  /// `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`, `ERROR_NON_FINITE_COORDINATE` or
  /// `ERROR_ZERO_LENGTH_EDGE`. All functions return the same if it could not.
  const Result& result() const { return m_result; }

  /// returns the mesh.
  const TriangleMesh& triangle_mesh() const { return *m_mesh; }

  /// returns the number of patches that the constrained edges bound, 0 if the mesh could not be cut.
  std::size_t number_of_patches() const { return m_cut_mesh.surface().patches.size(); }

private:
  template <typename, typename>
  friend class internal::Stage_mesh;

  template <typename NamedParameters>
  static Geom_traits traits_from(const NamedParameters& np)
  {
    return CGAL::parameters::choose_parameter<Geom_traits>(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits));
  }

  const TriangleMesh* m_mesh;
  std::size_t m_number_of_faces;
  Geom_traits m_traits;
  internal::Cut_mesh<TriangleMesh> m_cut_mesh;
  Result m_result;
};

#ifndef DOXYGEN_RUNNING
template <typename TriangleMesh>
Cut_triangle_mesh(const TriangleMesh&) -> Cut_triangle_mesh<TriangleMesh>;

// The geometric traits class is the one that the named parameters give, or that belongs to their points.
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Cut_triangle_mesh(const TriangleMesh&, const CGAL_NP_CLASS&)
  -> Cut_triangle_mesh<TriangleMesh, typename CGAL::GetGeomTraits<TriangleMesh, CGAL_NP_CLASS>::type>;
#endif

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_CUT_TRIANGLE_MESH_H
