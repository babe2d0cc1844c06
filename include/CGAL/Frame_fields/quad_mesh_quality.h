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

#ifndef CGAL_FRAME_FIELDS_QUAD_MESH_QUALITY_H
#define CGAL_FRAME_FIELDS_QUAD_MESH_QUALITY_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Quad_quality.h>
#include <CGAL/Frame_fields/internal/named_parameters/give_to_caller.h>
#include <CGAL/Frame_fields/internal/quads/Face_graph_polygons.h>
#include <CGAL/Frame_fields/internal/quads/measure_quads.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

/// \file quad_mesh_quality.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

measures a quad mesh, so that quad meshes can be compared.

\tparam QuadMesh a model of `VertexListGraph`, `FaceListGraph` and `HalfedgeListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param qm the mesh; its faces need not all be quads
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map containing the feature edges of `qm`, which bound the sectors that are counted;
                          border edges always count as such}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<QuadMesh>::%edge_descriptor`
                   as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false` for any edge}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `qm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<QuadMesh>::%vertex_descriptor`
                   as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, qm)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
    \cgalParamExtra{Only the coordinates of points are read; all computation is in `double`.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{quality}
    \cgalParamDescription{gets the figures}
    \cgalParamType{`std::reference_wrapper<Quad_quality>`, that is `std::ref(q)` for an object `q` of type
                   `Quad_quality`}
    \cgalParamDefault{they are not told}
    \cgalParamExtra{Set on success only.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, `ERROR_MESH_TOO_LARGE` (the faces have more than 2^30 corners together) or `ERROR_NON_FINITE_COORDINATE`

\cgalBigO{n} for \f$ n \f$ faces.

\sa `frame_field_quality()`
*/
template <typename QuadMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result quad_mesh_quality(const QuadMesh& qm, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  internal::Polygon_mesh polygons;
  const Result result = internal::Face_graph_polygons<QuadMesh, CGAL_NP_CLASS>(qm, np).read(polygons);
  if(result)
    internal::give_to_caller(internal::measure_quads(polygons),
                             CGAL::parameters::get_parameter(np, internal::quality));
  return result;
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_QUAD_MESH_QUALITY_H
