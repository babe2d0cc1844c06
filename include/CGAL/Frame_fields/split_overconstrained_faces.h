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

#ifndef CGAL_FRAME_FIELDS_SPLIT_OVERCONSTRAINED_FACES_H
#define CGAL_FRAME_FIELDS_SPLIT_OVERCONSTRAINED_FACES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Refinement_statistics.h>
#include <CGAL/Frame_fields/internal/named_parameters/give_to_caller.h>
#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

/// \file split_overconstrained_faces.h

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A point inside the triangle: its centroid, or on a degenerate triangle whose centroid is a vertex some other point.
template <typename Point, typename GeomTraits>
Point point_inside(const Point& p, const Point& q, const Point& r, const GeomTraits traits)
{
  const Point centroid = traits.construct_centroid_3_object()(p, q, r);
  if(centroid != p && centroid != q && centroid != r)
    return centroid;
  // That vertex is the midpoint of the two others, which no combination with three different weights gives.
  return traits.construct_barycenter_3_object()(p, 3, q, 2, r, 1);
}

// Returns the number of faces that were split. All must be triangles.
template <typename TriangleMesh, typename NamedParameters>
std::size_t split_faces_of(TriangleMesh& tm, const Editable_mesh<TriangleMesh, NamedParameters>& mesh)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;

  // One halfedge of each face, kept apart from the changing face range.
  std::vector<halfedge_descriptor> overconstrained;
  for(const auto f : faces(tm))
  {
    const halfedge_descriptor h = halfedge(f, tm);
    if(mesh.is_constrained(h) + mesh.is_constrained(next(h, tm)) + mesh.is_constrained(prev(h, tm)) > 1)
      overconstrained.push_back(h);
  }

  mesh.reserve_for(overconstrained.size(), 3 * overconstrained.size(), 2 * overconstrained.size());
  for(const halfedge_descriptor h : overconstrained)
  {
    const auto center = point_inside(mesh.point(source(h, tm)), mesh.point(target(h, tm)),
                                               mesh.point(target(next(h, tm), tm)), mesh.traits());
    const halfedge_descriptor to_center = CGAL::Euler::add_center_vertex(h, tm);
    mesh.set_point(target(to_center, tm), center);
    halfedge_descriptor spoke = to_center;
    do
    {
      mesh.mark_unconstrained(spoke);
      spoke = opposite(next(spoke, tm), tm);
    } while(spoke != to_center);
  }
  return overconstrained.size();
}

} // namespace internal

/*!
\ingroup PkgFrame_fieldsRef

splits each face with two or three constrained edges into three at its centroid, so that no face has more than one
constrained edge, as all other functions of this package require (Section 3.3 of \cgalCite{cgal:dprcs-ffcm-22}). On a
degenerate face whose centroid is one of its vertices it takes another point inside.

A frame cannot be aligned with two edges of a face unless they are perpendicular. The surface does not change. Only
this function, `split_chords()`, `prepare_for_frame_field()`, which does both, and `refine_triangles()` change a mesh.

\tparam TriangleMesh a model of `FaceListGraph` and `MutableFaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map containing the feature edges of `tm`; border edges always count as such}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                   as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false` for any edge}
    \cgalParamExtra{If the map is a model of `ReadWritePropertyMap`, the new edges are put to `false`; otherwise it must
                    return `false` for them.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{statistics}
    \cgalParamDescription{gets the number of faces that were split, as
                          `number_of_split_faces`}
    \cgalParamType{`std::reference_wrapper<Refinement_statistics>`}
    \cgalParamDefault{it is not told}
    \cgalParamExtra{Set on success only.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK` or `ERROR_NON_TRIANGULAR_MESH`; \c tm is unchanged if it is not `OK`

\exception std::bad_alloc if memory is exhausted; a \c %Surface_mesh is unchanged then

\cgalBigO{n} for \f$ n \f$ faces.

\sa `prepare_for_frame_field()`
\sa `split_chords()`
*/
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result split_overconstrained_faces(TriangleMesh& tm, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  const internal::Editable_mesh<TriangleMesh, CGAL_NP_CLASS> mesh(tm, np);
  const Result result = mesh.check_triangles();
  if(!result)
    return result;
  Refinement_statistics statistics;
  statistics.number_of_split_faces = internal::split_faces_of(tm, mesh);
  internal::give_to_caller(statistics, CGAL::parameters::get_parameter(np, internal::statistics));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_SPLIT_OVERCONSTRAINED_FACES_H
