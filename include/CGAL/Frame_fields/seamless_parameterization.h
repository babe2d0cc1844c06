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

#ifndef CGAL_FRAME_FIELDS_SEAMLESS_PARAMETERIZATION_H
#define CGAL_FRAME_FIELDS_SEAMLESS_PARAMETERIZATION_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Seamless_map_status.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/maps/read_field.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/compute_seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/seamless_map_output.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

/// \file seamless_parameterization.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

maps each patch to the plane such that the differential takes the branches of the field near to the axes and lengths to
multiples of the target edge length. Each face has a chart of its own, in which its corners have points. The map of a
patch is <I>exactly</I>, without rounding errors,
- seamless: across an unconstrained edge the charts differ by a number of quarter turns and a translation;
- aligned: along a constrained edge one coordinate stays and the other one grows in the direction of the branch there;
- injective around every point: all faces are positively oriented, and the sector of a corner turns by
  \f$ 4 - 4I \f$ quarter turns, or by \f$ 2 - 4I \f$ on constrained edges, where \f$ I \f$ is its index.

This is proved for each patch from its points alone, in integers. A patch for which the proof fails is reported, and all
its corners are at the origin. Nothing ties different patches to one another, nor the two sides of a feature edge.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam AlphaMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam SkewnessMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam MatchingMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam IndexMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam UvMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a `%Point_2` that is constructible
        from two `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param alpha_map the angle of the first branch of each face, in radians
\param skewness_map the skewness of each face, in radians
\param matching_map the matching \f$ p_{ij} \f$
\param index_map four times the index of the sector of the corner at the target of each halfedge
\param uv_map gets the point of the corner at the target of each halfedge in the chart of its face, and the origin on
       border halfedges. The coordinates are integers below \f$ 2^{50} \f$ times a power of two that is the same in a
       patch, so that sums and differences of two of them are exact in `double`.
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
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length that is to become 1 in the plane}
    \cgalParamType{`double`, positive and finite}
    \cgalParamDefault{the mean length of the sides of the faces}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_quads}
    \cgalParamDescription{the area of the surface in squares of the length that is to become 1, in place
                          of `target_edge_length`}
    \cgalParamType{a number, at least 1}
    \cgalParamDefault{it follows from `target_edge_length`}
    \cgalParamExtra{The area of a map is near to this number as far as the field lets lengths be what they should.}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_map}
    \cgalParamDescription{the length that is to become 1 near each vertex, in place of `target_edge_length`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a type that is convertible to
                   `double`, positive and finite, as value type}
    \cgalParamDefault{`target_edge_length` everywhere}
    \cgalParamExtra{With `number_of_quads`, only the ratios of the lengths count.}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{an instance of the solver traits class}
    \cgalParamType{a class model of `FrameFieldSolverTraits`, or of `SparseLinearAlgebraWithFactorTraits_d` with `NT`
                   = `double` for symmetric positive definite matrices}
    \cgalParamDefault{`Eigen_frame_field_solver_traits` if \ref thirdpartyEigen "Eigen" is available and
                      `CGAL_EIGEN3_ENABLED` is defined; there is no default otherwise}
  \cgalParamNEnd
  \cgalParamNBegin{concurrency_tag}
    \cgalParamDescription{tells whether patches are solved in parallel; the output is the same, bit for bit}
    \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
    \cgalParamDefault{`CGAL::Sequential_tag`}
    \cgalParamExtra{`CGAL::Parallel_tag` requires TBB. Without effect if `Has_independent_solvers` of the solver traits
                    is `CGAL::Tag_false`.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{uncertified_patch_output_iterator}
    \cgalParamDescription{gets one object for each patch without a certified map, in the order of their first faces}
    \cgalParamType{a model of `OutputIterator` that accepts
                   `Uncertified_patch<boost::graph_traits<TriangleMesh>::%face_descriptor>`}
    \cgalParamDefault{they are not listed}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre No face has more than one constrained edge, see `split_overconstrained_faces()`. A patch in which an unconstrained
     edge joins two vertices of constrained edges that lie on one straight side has no map, see `split_chords()`.

\return `OK`, also if there are patches without a certified map, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`,
        `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`, `ERROR_NON_FINITE_COORDINATE`,
        `ERROR_ZERO_LENGTH_EDGE`, `ERROR_OVERCONSTRAINED_FACE`, `ERROR_WRONG_PARAMETER` or `ERROR_WRONG_FIELD` (an
        angle that is not finite or beyond \f$ \pm 10^6 \f$, a skewness of \f$ \pi / 2 \f$ or more, a
        frame that is not aligned with the constrained edge of its face, a matching that is not opposite on opposite
        halfedges, an index that is not that of the field)

For each patch one sparse factorization of a symmetric matrix with about one row for each face. A patch whose first
solution is not injective needs more solves, about 1200 at most, and a few patches need more factorizations as well.

\sa `cad_frame_field()`
\sa `singularity_indices()`
*/
template <typename TriangleMesh, typename AlphaMap, typename SkewnessMap, typename MatchingMap, typename IndexMap,
          typename UvMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result seamless_parameterization(const TriangleMesh& tm, AlphaMap alpha_map, SkewnessMap skewness_map,
                                 MatchingMap matching_map,
                                 IndexMap index_map, UvMap uv_map,
                                 const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef typename internal::Concurrency_from<CGAL_NP_CLASS>::type Concurrency_tag;

  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  Result result = internal::check_and_cut(options, stage_mesh);
  const auto& cut_mesh = stage_mesh.cut_mesh();
  std::vector<double> alpha, rho, target_length;
  std::vector<int> matching, index;
  if(result)
    result = internal::read_field(cut_mesh, alpha_map, skewness_map, matching_map, alpha, rho, matching);
  if(result)
    result = internal::check_skewness(cut_mesh, rho);
  if(result)
    result = internal::read_indices(cut_mesh, alpha_map, skewness_map, matching, index_map, index);
  if(result)
    result = internal::read_target_length(cut_mesh, np, target_length);
  if(!result)
    return result;

  internal::Seamless_map map;
  internal::compute_seamless_map<Concurrency_tag>(cut_mesh.surface(), alpha, rho, matching, index, target_length,
                                                  internal::Solver_traits_from<CGAL_NP_CLASS>::get(np), map);
  internal::write_seamless_map(cut_mesh, map, uv_map);
  internal::write_uncertified_patches(
    cut_mesh, map, CGAL::parameters::get_parameter(np, internal::uncertified_patch_output_iterator));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_SEAMLESS_PARAMETERIZATION_H
