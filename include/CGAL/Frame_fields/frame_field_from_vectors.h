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

#ifndef CGAL_FRAME_FIELDS_FRAME_FIELD_FROM_VECTORS_H
#define CGAL_FRAME_FIELDS_FRAME_FIELD_FROM_VECTORS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/Frame.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/named_parameters/give_to_caller.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// \file frame_field_from_vectors.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

makes a frame field from two vectors for each face, as other programs give it, so that `singularity_indices()` and
`frame_field_quality()` can judge it: the inverse of `frame_vectors()`.

The vectors are projected to the planes of their faces; their lengths and signs do not matter. In a face with a
constrained edge the nearer branch is turned onto that edge, as indices are only defined for fields that follow the
constrained edges; `maximum_misalignment` tells by how much at most. The matching \f$ p_{ij} \f$ is the one for which
the two branches turn the least, in the sense of squares.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam VectorMap1 a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `%Vector_3` as value type
\tparam VectorMap2 as `VectorMap1`
\tparam AlphaMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam SkewnessMap as `AlphaMap`
\tparam MatchingMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param u_map one direction of each face
\param v_map the other one
\param alpha_map gets the angle of the first branch of each face, in radians
\param skewness_map gets the skewness of each face, in radians
\param matching_map gets the matching \f$ p_{ij} \f$; 0 on constrained edges
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
    \cgalParamExtra{Only coordinates are read; all computation is in `double`.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{maximum_misalignment}
    \cgalParamDescription{gets the largest angle by which a branch was turned onto a constrained edge, in radians}
    \cgalParamType{`std::reference_wrapper<double>`, that is `std::ref(x)` for an object `x` of type `double`}
    \cgalParamDefault{it is not told}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre No face has more than one constrained edge, see `split_overconstrained_faces()`.

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE`, `ERROR_OVERCONSTRAINED_FACE` or `ERROR_WRONG_FIELD` (a
        vector that is not finite or perpendicular to its face, two parallel vectors); nothing is written unless it is
        `OK`

\cgalBigO{n} for \f$ n \f$ faces.

\sa `singularity_indices()`
\sa `frame_field_quality()`
*/
template <typename TriangleMesh, typename VectorMap1, typename VectorMap2, typename AlphaMap, typename SkewnessMap,
          typename MatchingMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result frame_field_from_vectors(const TriangleMesh& tm, VectorMap1 u_map, VectorMap2 v_map, AlphaMap alpha_map,
                                SkewnessMap skewness_map, MatchingMap matching_map,
                                const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  const Result result = internal::check_and_cut(internal::options_from(np), stage_mesh);
  if(!result)
    return result;
  const auto& cut_mesh = stage_mesh.cut_mesh();
  const internal::Cut_surface& surface = cut_mesh.surface();

  std::vector<double> alpha, rho;
  double largest_turn = 0;
  for(int f = 0; f < surface.number_of_faces(); ++f)
  {
    const auto angle_of = [&](const auto& vector_map)
    {
      return cut_mesh.angle_in_face(f, internal::coordinates_of(get(vector_map, cut_mesh.face_descriptors()[f]),
                                                                stage_mesh.traits()));
    };
    internal::Frame frame = internal::Frame::from_angles(angle_of(u_map), angle_of(v_map));
    bool is_frame = std::abs(frame.rho) < CGAL_PI / 2; // false for NaN, too
    if(is_frame && surface.is_aligned(f))
    {
      largest_turn = (std::max)(largest_turn, internal::align(frame, surface.alignment[f]));
      is_frame = std::abs(frame.rho) < CGAL_PI / 2;
    }
    if(!is_frame)
      return internal::failure(ERROR_WRONG_FIELD, "vectors that are parallel, not finite or perpendicular to "
                                                  + cut_mesh.description_of_face(f));
    alpha.push_back(frame.alpha);
    rho.push_back(frame.rho);
  }

  std::vector<int> matching;
  for(int e = 0; e < surface.number_of_dual_edges(); ++e)
  {
    const internal::Dual_edge& dual_edge = surface.dual_edges[e];
    matching.push_back(internal::nearest_matching(internal::unmatched_rotation(surface, alpha, e),
                                                  rho[internal::face_of(dual_edge.halfedge)],
                                                  rho[internal::face_of(dual_edge.opposite)]));
  }
  internal::write_on_faces(cut_mesh, alpha, alpha_map);
  internal::write_on_faces(cut_mesh, rho, skewness_map);
  internal::write_on_dual_edges(cut_mesh, matching, matching_map);
  internal::give_to_caller(largest_turn, CGAL::parameters::get_parameter(np, internal::maximum_misalignment));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_FRAME_FIELD_FROM_VECTORS_H
