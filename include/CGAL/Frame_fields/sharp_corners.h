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

#ifndef CGAL_FRAME_FIELDS_SHARP_CORNERS_H
#define CGAL_FRAME_FIELDS_SHARP_CORNERS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>

#include <CGAL/Named_function_parameters.h>

/// \file sharp_corners.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

lists the sharp corners of a mesh: the sectors on constrained edges whose total angle is smaller than a bound
(Section 3.1 of \cgalCite{cgal:dprcs-ffcm-22}).

Faces with several constrained edges are accepted. A sector angle does not change when such a face is split.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam OutputIterator a model of `OutputIterator` that accepts
       `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param out gets one halfedge of each sharp corner: the corner at the halfedge's target is the clockwise-most of the
       sector
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map containing the feature edges of `tm`; border edges always count as such}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                   as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false` for any edge}
  \cgalParamNEnd
  \cgalParamNBegin{sharp_corner_bound}
    \cgalParamDescription{the angle under which a sector is a sharp corner, in radians}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{\f$ 3 \pi / 4 \f$}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
    \cgalParamExtra{Only the coordinates of points are read; all computation is in `double`.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE` or `ERROR_WRONG_PARAMETER`

\cgalBigO{n} for \f$ n \f$ faces.

\sa `prescribe_rotation()`
*/
template <typename TriangleMesh, typename OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result sharp_corners(const TriangleMesh& tm, OutputIterator out,
                     const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  const internal::Options options = internal::options_from(np);
  Result result = internal::check(options);
  if(!result)
    return result;
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  const bool accepts_overconstrained_faces = true;
  result = stage_mesh.cut(options, accepts_overconstrained_faces);
  if(!result)
    return result;
  const auto& cut_mesh = stage_mesh.cut_mesh();
  internal::write_sectors(cut_mesh, [&]()
  {
    return internal::sharp_corners_of_surface(cut_mesh.surface(), options.sharp_corner_bound);
  }, out);
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_SHARP_CORNERS_H
