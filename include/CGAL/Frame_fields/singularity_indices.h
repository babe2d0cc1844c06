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

#ifndef CGAL_FRAME_FIELDS_SINGULARITY_INDICES_H
#define CGAL_FRAME_FIELDS_SINGULARITY_INDICES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/field/stages.h>
#include <CGAL/Frame_fields/internal/maps/read_field.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <vector>

/// \file singularity_indices.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

computes the singularity index of each sector of a frame field,
\f$ I = (\sum r_{ij} - \theta) / 2\pi + 1 \f$, less \f$ 1/2 \f$ for a sector on a constrained edge
(Equation (3) of \cgalCite{cgal:dprcs-ffcm-22}).

A quadrangle mesh that follows the field has \f$ 4 - 4I \f$ quadrangles at a sector that is not on a constrained edge
and \f$ 2 - 4I \f$ at one that is. So an index of 0 is regular, \f$ 1/4 \f$ stands for the corner of a square or an
inner vertex of valence 3, and a sector on a constrained edge with an index of \f$ 1/2 \f$ or more cannot be meshed. The
indices of a patch sum to its Euler characteristic.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam AlphaMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam MatchingMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam IndexMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param alpha_map holds the angle of the first branch of each face, in radians
\param matching_map holds the matching \f$ p_{ij} \f$ of `orthogonal_frame_field()`
\param index_map gets \f$ 4 I \f$ of the sector that contains the corner at the target of a halfedge; 0 on border
       halfedges
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
  \cgalParamNBegin{skewness_map}
    \cgalParamDescription{the skewness \f$ \rho \f$ of each face, in radians; required if the field was relaxed}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type}
    \cgalParamDefault{\f$ \rho = 0 \f$}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre No face has more than one constrained edge, see `split_overconstrained_faces()`.

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE`, `ERROR_OVERCONSTRAINED_FACE` or `ERROR_WRONG_FIELD`
        (an angle that is not finite or beyond \f$ \pm 10^6 \f$, a frame that is not aligned with the constrained edge
        of its face, a matching that is not opposite on opposite halfedges)

\cgalBigO{n} for \f$ n \f$ faces.

\sa `orthogonal_frame_field()`
\sa `relax_frame_field()`
*/
template <typename TriangleMesh, typename AlphaMap, typename MatchingMap, typename IndexMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Result singularity_indices(const TriangleMesh& tm, AlphaMap alpha_map, MatchingMap matching_map, IndexMap index_map,
                           const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  Result result = internal::check_and_cut(internal::options_from(np), stage_mesh);
  if(!result)
    return result;
  const auto& cut_mesh = stage_mesh.cut_mesh();

  std::vector<double> alpha;
  std::vector<int> matching, index;
  result = internal::read_unrelaxed_field(cut_mesh, alpha_map,
                                          CGAL::parameters::get_parameter(np, internal::skewness), alpha);
  if(result)
    result = internal::read_from_dual_edges(cut_mesh, "the matching", matching_map, matching);
  if(result)
    result = internal::to_result(cut_mesh, internal::compute_indices<CGAL::Sequential_tag>(
      cut_mesh.surface(), alpha, matching, index));
  if(result)
    internal::write_on_sectors(cut_mesh, index, index_map);
  return result;
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_SINGULARITY_INDICES_H
