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

#ifndef CGAL_FRAME_FIELDS_SPLIT_CHORDS_H
#define CGAL_FRAME_FIELDS_SPLIT_CHORDS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Refinement_statistics.h>
#include <CGAL/Frame_fields/internal/named_parameters/give_to_caller.h>
#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>
#include <CGAL/Frame_fields/internal/surface/split_chords.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

/// \file split_chords.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

splits each chord, that is, each unconstrained edge that joins two vertices on constrained edges, at its midpoint, and
its two triangles with it. Thin strips of triangles between two constrained curves then have vertices inside, which can
take the singularities that the sharp corners give up. A chord stays if it is so short that rounding leaves no point
between its ends.

The surface does not change.

\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph` and `MutableFaceGraph`
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
    \cgalParamDescription{gets the number of edges that were split, as `number_of_splits`}
    \cgalParamType{`std::reference_wrapper<Refinement_statistics>`}
    \cgalParamDefault{it is not told}
    \cgalParamExtra{Set on success only.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK` or `ERROR_NON_TRIANGULAR_MESH`; \c tm is unchanged if it is not `OK`

\exception std::bad_alloc if memory is exhausted; a \c %Surface_mesh is unchanged then

\cgalBigO{n} for \f$ n \f$ faces if the degrees of the vertices are bounded: the edges around both ends of each edge
are visited.

\sa `prepare_for_frame_field()`
\sa `split_overconstrained_faces()`
*/
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result split_chords(TriangleMesh& tm, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  const internal::Editable_mesh<TriangleMesh, CGAL_NP_CLASS> mesh(tm, np);
  const Result result = mesh.check_triangles();
  if(!result)
    return result;
  Refinement_statistics statistics;
  statistics.number_of_splits = internal::split_chords_of(tm, mesh);
  internal::give_to_caller(statistics, CGAL::parameters::get_parameter(np, internal::statistics));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_SPLIT_CHORDS_H
