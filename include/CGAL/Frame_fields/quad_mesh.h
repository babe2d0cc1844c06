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

#ifndef CGAL_FRAME_FIELDS_QUAD_MESH_H
#define CGAL_FRAME_FIELDS_QUAD_MESH_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/quads/Mapped_field.h>
#include <CGAL/Frame_fields/internal/quads/Quad_stage_clock.h>
#include <CGAL/Frame_fields/internal/quads/quad_parameters.h>
#include <CGAL/Frame_fields/internal/quads/quads_of_field.h>
#include <CGAL/Frame_fields/internal/quads/read_quad_input.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>

#include <CGAL/Named_function_parameters.h>

#include <utility>

/// \file quad_mesh.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

makes a quad mesh of a triangle mesh and a frame field on it, which may come from `cad_frame_field()`, from
`frame_field_from_vectors()` or from another program. What `cad_quad_mesh()` does with the field that it computes on a
copy of its mesh, this function does with the one that it gets, on `tm` as it is. See there for what holds of the quads.

Patches without a certified map are filled. So `tm` should be prepared by `prepare_for_frame_field()` before the field
is computed. Where the indices exclude every map, the field of the patch is computed anew with a pair less, as there,
unless `repair_matching` is `false`.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam AlphaMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam SkewnessMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam MatchingMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam IndexMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam QuadMesh a model of `MutableFaceGraph` with an internal property map for `CGAL::vertex_point_t`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param alpha_map the angle of the first branch of each face, in radians
\param skewness_map the skewness of each face, in radians
\param matching_map the matching \f$ p_{ij} \f$
\param index_map four times the index of the sector of the corner at the target of each halfedge
\param quad_mesh gets the quads, in addition to what it has
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, and those of
       `cad_frame_field()` that are not outputs, for fields that are computed anew

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map containing the feature edges of `tm`; border edges always count as such}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                   as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false` for any edge}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
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
    \cgalParamDescription{tells whether patches are treated in parallel; the output is the same, bit for bit}
    \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
    \cgalParamDefault{`CGAL::Sequential_tag`}
    \cgalParamExtra{`CGAL::Parallel_tag` requires TBB.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an instance of a visitor class, told when a stage starts}
    \cgalParamType{a class that has the functions of `Default_quad_mesh_visitor`}
    \cgalParamDefault{`Default_quad_mesh_visitor()`}
    \cgalParamExtra{Pass `std::ref(visitor)` to have the instance itself called and not a copy.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{output_edge_is_constrained_map}
    \cgalParamDescription{gets for each edge of the result whether it is on a feature or border edge of `tm`}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<QuadMesh>::%edge_descriptor` as key
                   type and `bool` as value type}
    \cgalParamDefault{it is not written}
  \cgalParamNEnd
  \cgalParamNBegin{face_to_patch_map}
    \cgalParamDescription{gets for each face of the result the number of its patch, counted from 0}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<QuadMesh>::%face_descriptor` as key
                   type and `int` as value type}
    \cgalParamDefault{it is not written}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_to_face_location_map}
    \cgalParamDescription{gets for each vertex of the result where it is on `tm`: a face, and its barycentric
                          coordinates there for the source of the halfedge of the face, its target, and the third
                          vertex}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<QuadMesh>::%vertex_descriptor` as
                   key type and `std::pair<boost::graph_traits<TriangleMesh>::%face_descriptor, std::array<FT, 3> >` as
                   value type, which is `CGAL::Polygon_mesh_processing::Face_location<TriangleMesh, FT>`}
    \cgalParamDefault{it is not written}
  \cgalParamNEnd
  \cgalParamNBegin{fallback_patch_output_iterator}
    \cgalParamDescription{gets the numbers of the patches that were filled, as in `face_to_patch_map`}
    \cgalParamType{a model of `OutputIterator` that accepts `int`}
    \cgalParamDefault{they are not listed}
  \cgalParamNEnd
  \cgalParamNBegin{statistics}
    \cgalParamDescription{gets the counts, the way of each patch, the quality of the result and the seconds of each
                          stage}
    \cgalParamType{`std::reference_wrapper<Quad_statistics>`, that is `std::ref(s)` for an object `s` of type
                   `Quad_statistics`}
    \cgalParamDefault{they are not computed}
    \cgalParamExtra{Set on success only; the member `field` gets its default values.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre No face has more than one constrained edge, see `split_overconstrained_faces()`.

\return `OK`, one of the error codes of `seamless_parameterization()`, among them `ERROR_WRONG_FIELD` for a field that
        is not aligned or whose indices are not those of its matching, or `ERROR_WRONG_PARAMETER` where
        `cad_quad_mesh()` returns it. Nothing is added to `quad_mesh` then.

The complexity is that of `cad_quad_mesh()` without its field, except that fields that are computed anew take what
`cad_frame_field()` does.

\sa `cad_quad_mesh()`
\sa `compute_quad_sizes()`
\sa `seamless_parameterization()`
\sa `frame_field_from_vectors()`
*/
template <typename TriangleMesh, typename AlphaMap, typename SkewnessMap, typename MatchingMap, typename IndexMap,
          typename QuadMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result quad_mesh(const TriangleMesh& tm, AlphaMap alpha_map, SkewnessMap skewness_map, MatchingMap matching_map,
                 IndexMap index_map, QuadMesh& quad_mesh,
                 const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef typename internal::Concurrency_from<CGAL_NP_CLASS>::type Concurrency_tag;

  internal::Quad_stage_clock<CGAL_NP_CLASS> clock(np);
  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  const internal::Quad_size size = internal::quad_size_from(np);
  if(const Result result = internal::check_quad_size(np, size); !result)
    return result;

  clock.start(Quad_stage::PREPARATION);
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  if(const Result result = internal::check_and_cut(options, stage_mesh); !result)
    return result;
  const auto& cut_mesh = stage_mesh.cut_mesh();
  clock.start(Quad_stage::FIELD);
  internal::Quad_input input;
  if(const Result result = internal::read_quad_input(cut_mesh, alpha_map, skewness_map, matching_map, index_map, np,
                                                     size, input); !result)
    return result;
  clock.start(Quad_stage::SEAMLESS_MAP);
  const auto solver_traits = internal::Solver_traits_from<CGAL_NP_CLASS>::get(np);
  internal::Mapped_field mapped;
  mapped.field = std::move(input.field);
  internal::map_field<Concurrency_tag>(cut_mesh.surface(), input.embedding, input.request, options, solver_traits,
                                       mapped);

  const double unit = 1;
  const bool is_field_given = true;
  const auto locate = [&](const internal::Surface_location& location)
  {
    return std::make_pair(cut_mesh.face_descriptors()[location.face], location.barycentric);
  };
  return internal::quads_of_field<Concurrency_tag>(cut_mesh.surface(), input.embedding, unit, input.request, options,
                                                   solver_traits, mapped, is_field_given, locate, clock, quad_mesh, np);
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_QUAD_MESH_H
