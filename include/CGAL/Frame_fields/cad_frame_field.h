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

#ifndef CGAL_FRAME_FIELDS_CAD_FRAME_FIELD_H
#define CGAL_FRAME_FIELDS_CAD_FRAME_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Statistics.h>
#include <CGAL/Frame_fields/Support_strategy.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/field/Stage_clock.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <functional>

/// \file cad_frame_field.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

computes a smooth frame field that is aligned with all feature and border edges, and that is kept from singularities of
index \f$ 1/2 \f$ at sharp corners (\cgalCite{cgal:dprcs-ffcm-22}).

It does in one call, on one cut surface, what `prescribe_rotation()`, `orthogonal_frame_field()`,
`singularity_indices()` and `relax_frame_field()` do one after the other, with the same output.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam AlphaMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam SkewnessMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam IndexMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh: manifold, oriented, with or without border, of any genus and any number of components
\param alpha_map gets the angle of the first branch of each face `f`, in radians, counted counter-clockwise from the
       direction of `halfedge(f, tm)`
\param skewness_map gets the skewness, in radians: the branches of a face stand at
       \f$ \alpha, \alpha + \pi/2 + \rho, \alpha + \pi \f$ and \f$ \alpha + 3\pi/2 + \rho \f$
\param index_map gets four times the singularity index of the sector that contains the corner at the target of a
       halfedge; 0 on border halfedges
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
  \cgalParamNBegin{sharp_corner_bound}
    \cgalParamDescription{the angle under which a sector is a sharp corner, in radians}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{\f$ 3 \pi / 4 \f$}
    \cgalParamExtra{A sharp corner of angle \f$ \theta \f$ is meant to hold
                    \f$ k = \max(1, \mathrm{round}(2 \theta / \pi)) \f$ quadrangles, that is to have index
                    \f$ 1/2 - k/4 \f$. Under \f$ 3 \pi / 4 \f$ this is always one quadrangle and index \f$ 1/4 \f$.}
  \cgalParamNEnd
  \cgalParamNBegin{blunt_corner_bound}
    \cgalParamDescription{a sector on constrained edges that is meant to hold two quadrangles or more is a blunt corner
                          if its angle differs from \f$ \pi \f$ by more than this, in radians}
    \cgalParamType{`double`, not negative, or infinity}
    \cgalParamDefault{\f$ \pi / 8 \f$}
    \cgalParamExtra{Rotation is prescribed at blunt corners as at sharp ones, unless all sectors of the patch would
                    be such corners. With infinity there are no blunt corners, as in the paper.}
  \cgalParamNEnd
  \cgalParamNBegin{support_strategy}
    \cgalParamDescription{tells where the rotation prescribed at sharp corners is compensated}
    \cgalParamType{`Support_strategy`}
    \cgalParamDefault{`Support_strategy::rings(4)`}
  \cgalParamNEnd
  \cgalParamNBegin{repair_matching}
    \cgalParamDescription{tells whether the matching is changed until every sector on constrained edges has its natural
                          index \f$ 1/2 - k/4 \f$, where \f$ k = \max(1, \mathrm{round}(2 \theta / \pi)) \f$, and every
                          other sector an index of at most \f$ 1/4 \f$}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
    \cgalParamExtra{Indices move inside along paths that raise \f$ \sum w_{ij} (r_{ij} - \omega_{ij})^2 \f$ the least. A
                    patch has room for this after `prepare_for_frame_field()`. In others as many sectors as possible
                    become natural, and none on constrained edges keeps an index of \f$ 1/2 \f$ or more if the patch has
                    at least four sectors. With `false` the field is that of the paper.}
  \cgalParamNEnd
  \cgalParamNBegin{orthogonality_weight}
    \cgalParamDescription{the weight \f$ \epsilon \f$ of the squared skewness in the relaxation}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{`1e-2`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_skewness}
    \cgalParamDescription{the largest \f$ |\rho| \f$ allowed, in radians}
    \cgalParamType{`double` in \f$ [0, \pi / 2) \f$}
    \cgalParamDefault{\f$ 0.45 \pi \f$}
  \cgalParamNEnd
  \cgalParamNBegin{relax_orthogonality}
    \cgalParamDescription{tells whether the orthogonal field is relaxed; \f$ \rho = 0 \f$ otherwise}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{orthogonality_length}
    \cgalParamDescription{the length over which skewness fades out, in place of `orthogonality_weight`, if the weights
                          are not `Edge_weighting::UNIFORM`:
                          \f$ \epsilon_i = A_i / (\sqrt 3 \cdot \mathrm{length}^2) \f$ for a face of area \f$ A_i \f$}
    \cgalParamType{`double`, a length of the mesh, positive, or `std::optional<double>`}
    \cgalParamDefault{a quarter of the square root of the area of the patch}
  \cgalParamNEnd
  \cgalParamNBegin{guiding_direction_map}
    \cgalParamDescription{a direction near which one of the four branches should be in each face; its projection to the
                          plane of the face counts}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `%Vector_3` as value type}
    \cgalParamDefault{there is no guidance}
    \cgalParamExtra{Faces with a constrained edge keep to that edge.}
  \cgalParamNEnd
  \cgalParamNBegin{guiding_weight_map}
    \cgalParamDescription{how strongly the direction of each face guides: the factor of
                          \f$ |z_i - z_{i,\mathrm{guide}}|^2 \f$; 0 for not at all, infinity for exactly. With edge
                          weights other than `Edge_weighting::UNIFORM` it is multiplied by the area of the face divided
                          by \f$ \sqrt 3 \f$, so that the sum is an integral. In the relaxation, the squared angle to
                          the nearest branch pair has twice this factor.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type}
    \cgalParamDefault{1 for all faces, if there is guidance}
  \cgalParamNEnd
  \cgalParamNBegin{index_target_map}
    \cgalParamDescription{four times the index that a sector must get, on any of its halfedges, or `NO_INDEX_TARGET`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type}
    \cgalParamDefault{`NO_INDEX_TARGET` for all halfedges}
    \cgalParamExtra{If any sector of a patch has a target, all have: by default 0 inside, and on constrained edges the
                    index nearest to the angle, at most \f$ 1/4 \f$. They must sum to the Euler
                    characteristic of the patch, and none may be beyond \f$ \pm 250 \f$ turns.}
  \cgalParamNEnd
  \cgalParamNBegin{edge_weighting}
    \cgalParamDescription{the weights of the edges in all sums}
    \cgalParamType{`Edge_weighting`}
    \cgalParamDefault{`Edge_weighting::UNIFORM`}
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
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an instance of a visitor class, told when a stage starts}
    \cgalParamType{a class model of `FrameFieldVisitor`}
    \cgalParamDefault{`Default_frame_field_visitor()`}
    \cgalParamExtra{Pass `std::ref(visitor)` to have the instance itself called and not a copy.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{matching_map}
    \cgalParamDescription{gets the matching \f$ p_{ij} \f$: branch \f$ k \f$ of the face of a halfedge corresponds to
                          branch \f$ k + p_{ij} \f$ (modulo 4) of the face of its opposite}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type}
    \cgalParamDefault{it is not written}
    \cgalParamExtra{\f$ p_{ji} = -p_{ij} \f$, and 0 on constrained edges}
  \cgalParamNEnd
  \cgalParamNBegin{prescribed_rotation_map}
    \cgalParamDescription{gets the prescribed rotation \f$ \omega_{ij} \f$, in radians}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `double` as value type}
    \cgalParamDefault{it is not written}
    \cgalParamExtra{\f$ \omega_{ji} = -\omega_{ij} \f$, and 0 on constrained edges}
  \cgalParamNEnd
  \cgalParamNBegin{sharp_corner_output_iterator}
    \cgalParamDescription{gets one halfedge of each sharp corner, as in `sharp_corners()`}
    \cgalParamType{a class model of `OutputIterator` that accepts
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`}
    \cgalParamDefault{they are not listed}
  \cgalParamNEnd
  \cgalParamNBegin{repaired_sector_output_iterator}
    \cgalParamDescription{gets one halfedge, with a corner at its target, of each sector whose index is not the one that
                          rounding gave it: those that `repair_matching` brought to their natural index, and those
                          where the index went; with `index_target_map` also those
                          that were brought to their targets}
    \cgalParamType{a class model of `OutputIterator` that accepts
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`}
    \cgalParamDefault{they are not listed}
  \cgalParamNEnd
  \cgalParamNBegin{unmeshable_sector_output_iterator}
    \cgalParamDescription{gets one halfedge, with a corner at its target, of each sector on constrained edges with an
                          index of \f$ 1/2 \f$ or more}
    \cgalParamType{a class model of `OutputIterator` that accepts
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`}
    \cgalParamDefault{they are not listed}
    \cgalParamExtra{With `repair_matching` there are none in a patch of at least four sectors, unless
                    `index_target_map` asks for them.}
  \cgalParamNEnd
  \cgalParamNBegin{unnatural_sector_output_iterator}
    \cgalParamDescription{gets one halfedge, with a corner at its target, of each sector on constrained edges that does
                          not have its natural index, and of each other one with an index of \f$ 1/2 \f$ or more}
    \cgalParamType{a class model of `OutputIterator` that accepts
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`}
    \cgalParamDefault{they are not listed}
    \cgalParamExtra{With `repair_matching` there are none after `prepare_for_frame_field()`, unless `index_target_map`
                    asks for them.}
  \cgalParamNEnd
  \cgalParamNBegin{statistics}
    \cgalParamDescription{gets the counts, the energies and the seconds of each stage}
    \cgalParamType{`std::reference_wrapper<Statistics>`, that is `std::ref(s)` for an object `s` of type `Statistics`}
    \cgalParamDefault{they are not computed}
    \cgalParamExtra{Set on success only.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre No face has more than one constrained edge, see `split_overconstrained_faces()`.

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE`, `ERROR_OVERCONSTRAINED_FACE`, `ERROR_WRONG_PARAMETER`,
        `ERROR_WRONG_FIELD` (a guiding direction or an index target that cannot be used), `ERROR_POINCARE_HOPF` (index
        targets that do not sum to the Euler characteristic; the message names what is missing),
        `ERROR_NO_RECEIVING_SECTOR` (only for sharp bounds of \f$ \pi \f$ and more) or
        `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`

For each patch up to three sparse factorizations, of matrices with at most as many rows as the patch has sectors, faces,
and twice its faces. All other work takes \cgalBigO{n} time and memory for \f$ n \f$ faces, with two exceptions:
`Support_strategy::rings()` visits the rings of each sharp corner, and the repair searches the patch once for each
quarter index that it moves, \cgalBigO{n \log n} at most.

\sa `split_overconstrained_faces()`
\sa `frame_vectors()`
*/
template <typename TriangleMesh, typename AlphaMap, typename SkewnessMap, typename IndexMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Result cad_frame_field(const TriangleMesh& tm, AlphaMap alpha_map, SkewnessMap skewness_map, IndexMap index_map,
                       const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::get_parameter;
  typedef typename internal::Concurrency_from<CGAL_NP_CLASS>::type Concurrency_tag;

  internal::Stage_clock<CGAL_NP_CLASS> clock(np);
  const internal::Options options = internal::options_from(np);
  const auto solver_traits = internal::Solver_traits_from<CGAL_NP_CLASS>::get(np);

  clock.start(Stage::CUT_SURFACE);
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  const Result cut_result = internal::check_and_cut(options, stage_mesh);
  if(!cut_result)
    return cut_result;
  const auto& cut_mesh = stage_mesh.cut_mesh();

  internal::Frame_field field;
  const internal::Patch_result field_result =
    internal::compute_frame_field<Concurrency_tag>(cut_mesh.surface(), options, solver_traits, clock, field);
  if(field_result.error_code != OK)
    return internal::to_result(cut_mesh, field_result);
  clock.stop();

  // What may allocate comes first, so that the maps are written together or not at all.
  const internal::Cut_surface& surface = cut_mesh.surface();
  internal::write_sectors(
    cut_mesh, [&]() { return internal::sharp_corners_of_surface(surface, options.sharp_corner_bound); },
    get_parameter(np, internal::sharp_corner_output_iterator));
  internal::write_sectors(cut_mesh, [&]() { return internal::repaired_sectors_of(field); },
                          get_parameter(np, internal::repaired_sector_output_iterator));
  internal::write_sectors(cut_mesh, [&]() { return internal::unmeshable_sectors_of(surface, field); },
                          get_parameter(np, internal::unmeshable_sector_output_iterator));
  internal::write_sectors(cut_mesh, [&]() { return internal::unnatural_sectors_of(surface, field); },
                          get_parameter(np, internal::unnatural_sector_output_iterator));
  internal::write_relaxed_field(cut_mesh, field.alpha, field.gamma, alpha_map, skewness_map);
  internal::write_on_sectors(cut_mesh, field.index, index_map);
  internal::write_on_dual_edges(cut_mesh, field.matching, get_parameter(np, internal::matching));
  internal::write_on_dual_edges(cut_mesh, field.omega, get_parameter(np, internal::prescribed_rotation));
  internal::write_statistics(surface, options, field, clock, get_parameter(np, internal::statistics));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_CAD_FRAME_FIELD_H
