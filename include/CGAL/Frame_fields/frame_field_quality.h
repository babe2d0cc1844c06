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

#ifndef CGAL_FRAME_FIELDS_FRAME_FIELD_QUALITY_H
#define CGAL_FRAME_FIELDS_FRAME_FIELD_QUALITY_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Field_quality.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/named_parameters/give_to_caller.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/field/quality.h>
#include <CGAL/Frame_fields/internal/maps/read_field.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <vector>

/// \file frame_field_quality.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

measures a frame field, so that fields can be compared.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam AlphaMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam SkewnessMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam MatchingMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param alpha_map the angle of the first branch of each face, in radians
\param skewness_map the skewness of each face, in radians
\param matching_map the matching \f$ p_{ij} \f$
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
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
    \cgalParamExtra{Only the coordinates of points are read; all computation is in `double`.}
  \cgalParamNEnd
  \cgalParamNBegin{edge_weighting}
    \cgalParamDescription{the weights of the edges in the energy}
    \cgalParamType{`Edge_weighting`}
    \cgalParamDefault{`Edge_weighting::UNIFORM`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{quality}
    \cgalParamDescription{gets the figures}
    \cgalParamType{`std::reference_wrapper<Field_quality>`, that is `std::ref(q)` for an object `q` of type
                   `Field_quality`}
    \cgalParamDefault{they are not told}
    \cgalParamExtra{Set on success only.}
  \cgalParamNEnd
  \cgalParamNBegin{rotation_map}
    \cgalParamDescription{gets the rotations across each edge, in radians: \f$ r^0_{ij} \f$ of the branch pair of
                          branch 0 of the face of a halfedge, towards the face of its opposite, and
                          \f$ r^1_{ij} \f$ of the other pair (eq. (4) of \cgalCite{cgal:dprcs-ffcm-22})}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `std::array<double, 2>`
                   as value type}
    \cgalParamDefault{it is not written}
    \cgalParamExtra{The opposite halfedge gets the opposite numbers, in exchanged order where \f$ p_{ij} \f$ is odd.
                    Both are equal in an orthogonal field, and 0 on constrained edges. Written on success only.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE`, `ERROR_OVERCONSTRAINED_FACE` or `ERROR_WRONG_FIELD`
        (an angle that is not finite or beyond \f$ \pm 10^6 \f$, a matching that is not opposite on opposite halfedges)

\cgalBigO{n} for \f$ n \f$ faces.
*/
template <typename TriangleMesh, typename AlphaMap, typename SkewnessMap, typename MatchingMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Result frame_field_quality(const TriangleMesh& tm, AlphaMap alpha_map, SkewnessMap skewness_map,
                           MatchingMap matching_map, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  Result result = internal::check_and_cut(options, stage_mesh);
  const auto& cut_mesh = stage_mesh.cut_mesh();
  std::vector<double> alpha, rho;
  std::vector<int> matching;
  if(result)
    result = internal::read_field(cut_mesh, alpha_map, skewness_map, matching_map, alpha, rho, matching);
  if(!result)
    return result;
  const std::vector<std::array<double, 2> > rotations =
    internal::rotations_of_branches(cut_mesh.surface(), alpha, rho, matching);
  internal::give_to_caller(internal::measure_quality(cut_mesh.surface(), alpha, rho, rotations),
                           CGAL::parameters::get_parameter(np, internal::quality));
  internal::write_rotations(cut_mesh, matching, rotations,
                            CGAL::parameters::get_parameter(np, internal::halfedge_rotation));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_FRAME_FIELD_QUALITY_H
