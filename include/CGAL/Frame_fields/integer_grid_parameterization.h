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

#ifndef CGAL_FRAME_FIELDS_INTEGER_GRID_PARAMETERIZATION_H
#define CGAL_FRAME_FIELDS_INTEGER_GRID_PARAMETERIZATION_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Seamless_map_status.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/seamless_map_output.h>
#include <CGAL/Frame_fields/internal/quads/compute_integer_grid_maps.h>
#include <CGAL/Frame_fields/internal/quads/quad_parameters.h>
#include <CGAL/Frame_fields/internal/quads/read_quad_input.h>

#include <CGAL/Named_function_parameters.h>

/// \file integer_grid_parameterization.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

maps each patch to the plane such that the lines of integer \f$ u \f$ and \f$ v \f$ are the edges of a quad mesh: an
<I>integer-grid map</I>. The map has all that `seamless_parameterization()` promises, and <I>exactly</I>, without
rounding errors,
- the translation across every unconstrained edge is by integers;
- irregular vertices and the ends of feature curves have integer coordinates;
- on a constrained edge, the coordinate that stays is an integer;
- a feature curve has the same integer length on both of its sides.

So the unit squares of the plane are the quads of each patch: those that `quad_mesh()` makes with the same parameters,
before it gives inverted ones more room. Each side of a feature curve is spread over its length by the least distortion
in its patch, so the points at integers need not be the same on both sides. Maps of this kind serve for splines,
textures and the extraction of quads.

This is proved for each patch from its points alone, in integers. A patch for which the proof fails, as it may where
quads are larger than the triangles allow, is reported, and all its corners are at the origin.

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
    \cgalParamDescription{the length that the edges of the quads should have, a length of `tm`}
    \cgalParamType{`double`, positive and finite}
    \cgalParamDefault{the mean length of the sides of the faces of `tm`}
    \cgalParamExtra{Feature curves that bend get more edges, so that the quads leave them by no more than 2 percent of
                    this length.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_quads}
    \cgalParamDescription{about how many quads there should be, in place of `target_edge_length`}
    \cgalParamType{a number, at least 1}
    \cgalParamDefault{it follows from `target_edge_length`}
    \cgalParamExtra{The number is met within about 2 percent, unless features are too close together for so few. Each
                    correction of the edge length, six at most, solves the integer program anew.}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_map}
    \cgalParamDescription{the length that the edges of the quads should have near each vertex, in place of
                          `target_edge_length`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a type that is convertible to
                   `double`, positive and finite, as value type}
    \cgalParamDefault{`target_edge_length` everywhere}
    \cgalParamExtra{Lines get as many edges as the integral of one over the length says, where the integers of
                    opposite sides allow it; so lengths should change slowly. With `number_of_quads`, only the ratios of
                    the lengths count.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_edges_map}
    \cgalParamDescription{the number of quad edges that the feature or border curve of an edge must get, 0 for any. A
                          curve ends at nodes: at vertices where feature edges end, meet or turn, and at those of
                          `vertex_is_constrained_map`. One of its edges is enough.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as
                   key type and `int` as value type}
    \cgalParamDefault{all numbers are chosen by length}
    \cgalParamExtra{Numbers go before the wanted lengths and the bends of curves. Where they contradict one another
                    across a patch, or would cost a patch its certified map, those are given up that are farthest from
                    what the lengths ask for; at a filled patch odd ones are, too. `statistics` tells how many in
                    `Quad_statistics::number_of_unmet_edge_numbers`. No number may be negative, and on a closed curve
                    without a node it must be 0 or at least 3.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{whether a vertex on a feature or border edge must become a vertex of the result}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false` for any vertex}
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

\pre No face has more than one constrained edge, see `split_overconstrained_faces()`. `tm` should be prepared by
     `prepare_for_frame_field()` before the field is computed.

\return what `seamless_parameterization()` returns, and `ERROR_WRONG_PARAMETER` where `quad_mesh()` returns it

The complexity is that of `quad_mesh()` without the smoothing. Each patch needs at most 8 more factorizations.

\sa `seamless_parameterization()`
\sa `quad_mesh()`
*/
template <typename TriangleMesh, typename AlphaMap, typename SkewnessMap, typename MatchingMap, typename IndexMap,
          typename UvMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result integer_grid_parameterization(const TriangleMesh& tm, AlphaMap alpha_map, SkewnessMap skewness_map,
                                     MatchingMap matching_map, IndexMap index_map, UvMap uv_map,
                                     const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef typename internal::Concurrency_from<CGAL_NP_CLASS>::type Concurrency_tag;

  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  const internal::Quad_size size = internal::quad_size_from(np);
  if(const Result result = internal::check_quad_size(np, size); !result)
    return result;
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  if(const Result result = internal::check_and_cut(options, stage_mesh); !result)
    return result;
  const auto& cut_mesh = stage_mesh.cut_mesh();
  internal::Quad_input input;
  if(const Result result = internal::read_quad_input(cut_mesh, alpha_map, skewness_map, matching_map, index_map, np,
                                                     size, input); !result)
    return result;

  internal::Seamless_map grid_map;
  if(const Result result = internal::compute_integer_grid_maps<Concurrency_tag>(
       cut_mesh.surface(), input.embedding, input.request, input.field, input.skewness,
       internal::Solver_traits_from<CGAL_NP_CLASS>::get(np), grid_map); !result)
    return result;
  internal::write_seamless_map(cut_mesh, grid_map, uv_map);
  internal::write_uncertified_patches(
    cut_mesh, grid_map, CGAL::parameters::get_parameter(np, internal::uncertified_patch_output_iterator));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTEGER_GRID_PARAMETERIZATION_H
