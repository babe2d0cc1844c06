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

#ifndef CGAL_FRAME_FIELDS_RELAX_FRAME_FIELD_H
#define CGAL_FRAME_FIELDS_RELAX_FRAME_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/branch_pairs.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/field/relaxation.h>
#include <CGAL/Frame_fields/internal/field/stages.h>
#include <CGAL/Frame_fields/internal/maps/read_field.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <vector>

/// \file relax_frame_field.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

turns the two branch pairs of an orthogonal frame field independently of one another to lower the rotation of the field
(Section 4 of \cgalCite{cgal:dprcs-ffcm-22}): it minimizes
\f$ \sum (r^0_{ij})^2 + (r^1_{ij})^2 + \epsilon \sum \rho_i^2 \f$. In faces with a constrained edge the branch pair
along the edge stays. Where \f$ |\rho_i| \f$ then exceeds the maximum skewness, both pairs are turned back by the same
angle until it does not; in a face with a constrained edge only the free pair is. The matching and the singularity
indices stay what they are.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam AlphaMap a class model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam SkewnessMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param alpha_map holds the orthogonal field of `orthogonal_frame_field()` and gets the angle of the first branch of the
       relaxed one, in radians
\param skewness_map gets the skewness, in radians: the branches of a face stand at
       \f$ \alpha, \alpha + \pi/2 + \rho, \alpha + \pi \f$ and \f$ \alpha + 3\pi/2 + \rho \f$
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
  \cgalParamNBegin{matching_map}
    \cgalParamDescription{the matching \f$ p_{ij} \f$ of the orthogonal field}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type}
    \cgalParamDefault{the one that brings each rotation \f$ r_{ij} \f$ nearest to the prescribed rotation}
  \cgalParamNEnd
  \cgalParamNBegin{prescribed_rotation_map}
    \cgalParamDescription{the rotations \f$ \omega_{ij} \f$ of `prescribe_rotation()`, read if `matching_map` is not
                          given}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `double` as value type}
    \cgalParamDefault{\f$ \omega_{ij} = 0 \f$}
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
  \cgalParamNBegin{repair_matching}
    \cgalParamDescription{tells whether a matching that was not given is changed until every sector on
                          constrained edges has its natural index, see `cad_frame_field()`}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
    \cgalParamExtra{Indices move inside along paths that raise \f$ \sum w_{ij} (r_{ij} - \omega_{ij})^2 \f$ the least. A
                    patch has room for this after `prepare_for_frame_field()`.}
  \cgalParamNEnd
  \cgalParamNBegin{orthogonality_length}
    \cgalParamDescription{the length over which skewness fades out, in place of `orthogonality_weight`, if the weights
                          are not `Edge_weighting::UNIFORM`:
                          \f$ \epsilon_i = A_i / (\sqrt 3 \cdot \mathrm{length}^2) \f$ for a face of area \f$ A_i \f$}
    \cgalParamType{`double`, a length of the mesh, positive, or `std::optional<double>`}
    \cgalParamDefault{a quarter of the square root of the area of the patch}
  \cgalParamNEnd
  \cgalParamNBegin{guiding_direction_map}
    \cgalParamDescription{a direction near which one of the four branches should be in each face; needed here for faces
                          of infinite weight only; its projection to the plane of the face counts}
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
\cgalNamedParamsEnd

\pre No face has more than one constrained edge, see `split_overconstrained_faces()`.

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE`, `ERROR_OVERCONSTRAINED_FACE`, `ERROR_WRONG_PARAMETER`,
        `ERROR_WRONG_FIELD` (an angle or rotation that is not finite or beyond \f$ \pm 10^6 \f$, a frame that is not
        aligned with the constrained edge of its face, a map that is not opposite on opposite halfedges, a prescribed
        rotation far from all that the index targets ask for, a guiding direction or an index target that cannot be
        used), `ERROR_POINCARE_HOPF` (index targets that do not sum to the Euler characteristic) or
        `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`

For each patch one sparse factorization of a symmetric matrix with one row for each branch pair that is free to turn, at
most two for each face, and one solve.

\sa `orthogonal_frame_field()`

\sa `cad_frame_field()`
*/
template <typename TriangleMesh, typename AlphaMap, typename SkewnessMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result relax_frame_field(const TriangleMesh& tm, AlphaMap alpha_map, SkewnessMap skewness_map,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef typename internal::Concurrency_from<CGAL_NP_CLASS>::type Concurrency_tag;

  const internal::Options options = internal::options_from(np);
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  Result result = internal::check_and_cut(options, stage_mesh);
  if(!result)
    return result;
  const auto& cut_mesh = stage_mesh.cut_mesh();

  std::vector<double> alpha;
  std::vector<int> matching;
  result = internal::read_unrelaxed_field(cut_mesh, alpha_map, CGAL::internal_np::Param_not_found(), alpha);
  if(result)
    result = internal::read_or_compute_matching<Concurrency_tag>(cut_mesh, np, options, alpha, matching);
  if(!result)
    return result;

  std::vector<internal::Branch_rotations> gamma;
  int number_of_clamped_faces;
  const auto solver_traits = internal::Solver_traits_from<CGAL_NP_CLASS>::get(np);
  result = internal::to_result(cut_mesh, internal::relax<Concurrency_tag>(
    cut_mesh.surface(), alpha, matching, options,
    internal::order_faces<Concurrency_tag>(cut_mesh.surface(), solver_traits), solver_traits, gamma,
    number_of_clamped_faces));
  if(result)
    internal::write_relaxed_field(cut_mesh, alpha, gamma, alpha_map, skewness_map);
  return result;
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_RELAX_FRAME_FIELD_H
