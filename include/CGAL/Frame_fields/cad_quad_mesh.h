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

#ifndef CGAL_FRAME_FIELDS_CAD_QUAD_MESH_H
#define CGAL_FRAME_FIELDS_CAD_QUAD_MESH_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/internal/maps/bound_sizes.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/quads/Mapped_field.h>
#include <CGAL/Frame_fields/internal/quads/Quad_stage_clock.h>
#include <CGAL/Frame_fields/internal/quads/Refined_copy.h>
#include <CGAL/Frame_fields/internal/quads/map_refined_copy.h>
#include <CGAL/Frame_fields/internal/quads/quads_of_field.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

/// \file cad_quad_mesh.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

makes a quad mesh of a triangle mesh: its sides follow all feature and border edges, and its irregular vertices are the
singularities of the frame field that `cad_frame_field()` computes.

The function works on a copy of `tm`, in which triangles that are longer than two quads are refined as by
`refine_triangles()`, and that `prepare_for_frame_field()` prepares. Each patch, a piece of the surface between feature
and border edges, gets a field, a certified seamless map (see `seamless_parameterization()`) and a T-mesh of rectangular
cells. The numbers of quad edges of all cells and all feature curves are one integer program, a flow on a bidirected
network. The cells become grids of quads, whose vertices then slide on the surface until the quads are well shaped.

Where the indices of a field exclude every map, as around a ring whose border has a step, or on a torus with two
irregular vertices, a pair of them is cancelled, up to three times, and the field of the patch computed with the others;
not so if `repair_matching` is `false`. Where the map of a patch fails in a few places, the triangles around these are
split in the copy, twice at most, and the fields and maps computed anew. A patch for which there is still no certified
map, or no such integers, is filled with quads of about the same size instead; it then has more irregular vertices. So
there is always a quad mesh. `statistics` tells which patches lost pairs, which were filled, and why.

The result contains quads only, and it is a manifold of the topology of `tm`. Every vertex at which feature edges end,
meet or turn is a vertex of the result, and the feature edges between such vertices become chains of edges whose
vertices are on them.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam QuadMesh a model of `MutableFaceGraph` with an internal property map for `CGAL::vertex_point_t`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh: manifold, oriented, with or without border, of any genus and any number of components
\param quad_mesh gets the quads, in addition to what it has
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, and those of
       `cad_frame_field()` but its output parameters. Where a face is split in the copy, its parts get its guiding
       direction.

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
  \cgalParamNBegin{chord_height}
    \cgalParamDescription{how far edges may be from the smooth surface and the smooth curves whose points the vertices
                          of `tm` are, a length of `tm`: no edge is longer than the chord of this height of a circle
                          with the greatest normal curvature of the surface, or with that of a feature or border
                          curve. The height is that of the arc over the chord, also called sagitta.}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{infinity: any}
    \cgalParamExtra{Creases and corners are not curvature if they are features, or turns of curves by more than 45
                    degrees. What is within the rounding of coordinates counts as flat.}
  \cgalParamNEnd
  \cgalParamNBegin{edges_across_gap}
    \cgalParamDescription{how many edges there should be at least across the space between two feature or border curves
                          of a patch, or two parts of one: across a strip such as a fillet, or between two holes}
    \cgalParamType{`int`, not negative}
    \cgalParamDefault{0: any}
    \cgalParamExtra{The space is measured on the surface, perpendicular to the curves. Nothing is asked between two
                    curves that meet at a corner of the patch.}
  \cgalParamNEnd
  \cgalParamNBegin{gradation}
    \cgalParamDescription{the greatest ratio of the lengths of consecutive edges. Lengths grow along every edge of the
                          mesh by no more than \f$ \log \f$ of this times its length.}
    \cgalParamType{`double`, greater than 1, or infinity}
    \cgalParamDefault{1.5 if any parameter of these four is given, infinity otherwise}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_edge_length}
    \cgalParamDescription{a length that neither curvature nor gaps make edges shorter than, a length of `tm`}
    \cgalParamType{`double`, finite and not negative}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{field_follows_sizes}
    \cgalParamDescription{whether the field gets singularities where lengths that change make rows of quads end. Without
                          these, a row is as wide at one end of a patch as at the other, and only its columns follow
                          the lengths.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{The field is then smooth in the metric in which all wanted lengths are the same. The more rapidly
                    lengths change, the more irregular vertices there are; a `gradation` of 1.2 or less is advisable.
                    Guiding directions and index targets stay as they are.}
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
  \cgalParamNBegin{refine_long_triangles}
    \cgalParamDescription{whether triangles are refined in the copy where edges are longer than two edges of quads, as
                          in raw tessellations}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
    \cgalParamExtra{The surface stays where it is, and shorter triangles do as well. The copy gets at most 8 triangles
                    for each one of `tm`, and 4 for each quad that the area has room for; those that are split because
                    a map fails there come on top of these, and are not split without refinement. Edges in planes are
                    flipped, unless there is an `index_target_map`; then a face of the copy may be part of several
                    faces of `tm` in one plane and gets the guiding direction of one of them.}
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
    \cgalParamExtra{Set on success only.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, or one of the error codes of `cad_frame_field()` other than `ERROR_OVERCONSTRAINED_FACE`; a size out of
        its range, or one of more than about 10^8 quads, gives `ERROR_WRONG_PARAMETER`, and so do two different numbers
        of edges on one curve, or one below 3 on a closed curve without a node. Nothing is added to `quad_mesh` then.

What is not spent in the linear systems of the field and of the maps, in the flow, and in the smoothing, which makes a
fixed number of sweeps over the quads, is \cgalBigO{n \log n} for \f$ n \f$ faces of both meshes together.

\sa `compute_quad_sizes()`
\sa `refine_triangles()`
\sa `quad_mesh()`, for a field that is given
\sa `quad_mesh_quality()`
\sa `seamless_parameterization()`
\sa `cad_frame_field()`
*/
template <typename TriangleMesh, typename QuadMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result cad_quad_mesh(const TriangleMesh& tm, QuadMesh& quad_mesh,
                     const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef typename internal::Concurrency_from<CGAL_NP_CLASS>::type Concurrency_tag;

  internal::Quad_stage_clock<CGAL_NP_CLASS> clock(np);
  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  const internal::Quad_size size = internal::quad_size_from(np);
  const auto solver_traits = internal::Solver_traits_from<CGAL_NP_CLASS>::get(np);
  if(const Result result = internal::check_quad_size(np, size); !result)
    return result;
  if(const Result result = internal::check(options); !result)
    return result;
  const internal::Size_bounds bounds = internal::size_bounds_from(np);
  if(const Result result = internal::check(bounds); !result)
    return result;

  clock.start(Quad_stage::PREPARATION);
  internal::Refined_copy<TriangleMesh, CGAL_NP_CLASS> copy(tm, np, options);
  if(const Result result = copy.refine(size, bounds); !result)
    return result;
  const bool follows_sizes =
    CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal::field_follows_sizes), false);
  internal::Mapped_field mapped;
  if(const Result result = internal::map_refined_copy<Concurrency_tag>(copy, follows_sizes, options, solver_traits,
                                                                       clock, mapped); !result)
    return result;

  const bool is_field_given = false;
  const auto locate = [&](const internal::Surface_location& location) { return copy.given_location(location); };
  return internal::quads_of_field<Concurrency_tag>(copy.surface(), copy.embedding(), copy.given_unit(), copy.request(),
                                                   options, solver_traits, mapped, is_field_given, locate, clock,
                                                   quad_mesh, np);
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_CAD_QUAD_MESH_H
