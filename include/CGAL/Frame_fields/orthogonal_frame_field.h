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

#ifndef CGAL_FRAME_FIELDS_ORTHOGONAL_FRAME_FIELD_H
#define CGAL_FRAME_FIELDS_ORTHOGONAL_FRAME_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/matching/meshable_matching.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/field/stages.h>
#include <CGAL/Frame_fields/internal/maps/read_field.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <vector>

/// \file orthogonal_frame_field.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

computes the orthogonal frame field whose rotation is nearest to a prescribed one (Section 3.3 of
\cgalCite{cgal:dprcs-ffcm-22}): with \f$ z_i = e^{4 i \alpha_i} \f$ it minimizes
\f$ \sum |z_i - z_j e^{4 i (c_{ij} - \omega_{ij})}|^2 \f$, where the frame of each face with a constrained edge is
aligned with that edge.

A patch without any constrained edge, whose minimizer is 0, starts from the \f$ z \f$ of unit norm with the smallest
energy, an eigenvector to the smallest eigenvalue of the same hermitian matrix. From there it goes to a local minimum of
\f$ \sum (r_{ij} - \omega_{ij})^2 \f$, and pairs of singularities of opposite signs are canceled where that lowers this
sum plus a price of irregular vertices, see Section \ref Frame_fieldsOrthogonal. The field is determined up to a common
rotation of all frames. A patch between two closed curves without corners gets a field without singularities if that has
a smaller sum. The field does not depend on the number of threads.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam AlphaMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param alpha_map gets the angle of the first branch of each face `f`, in radians, counted counter-clockwise from the
       direction of `halfedge(f, tm)`
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
  \cgalParamNBegin{prescribed_rotation_map}
    \cgalParamDescription{the rotations \f$ \omega_{ij} \f$ that `prescribe_rotation()` computes}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `double` as value type}
    \cgalParamDefault{\f$ \omega_{ij} = 0 \f$}
  \cgalParamNEnd
  \cgalParamNBegin{repair_matching}
    \cgalParamDescription{tells whether the matching is changed until every sector on constrained
                          edges has its natural index, see `cad_frame_field()`}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
    \cgalParamExtra{Indices move inside along paths that raise \f$ \sum w_{ij} (r_{ij} - \omega_{ij})^2 \f$ the least. A
                    patch has room for this after `prepare_for_frame_field()`.}
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
                          by \f$ \sqrt 3 \f$, so that the sum is an integral.}
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

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{matching_map}
    \cgalParamDescription{gets the matching \f$ p_{ij} \f$: branch \f$ k \f$ of the face of a halfedge corresponds to
                          branch \f$ k + p_{ij} \f$ (modulo 4) of the face of its opposite}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type}
    \cgalParamDefault{it is not computed}
    \cgalParamExtra{\f$ p_{ji} = -p_{ij} \f$, and 0 on constrained edges}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre No face has more than one constrained edge, see `split_overconstrained_faces()`.

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE`, `ERROR_OVERCONSTRAINED_FACE`, `ERROR_WRONG_PARAMETER`,
        `ERROR_WRONG_FIELD` (a prescribed rotation that is not finite, beyond \f$ \pm 10^6 \f$, not opposite on
        opposite halfedges or far from all that the index targets ask for, a guiding direction or an index target that
        cannot be used), `ERROR_POINCARE_HOPF` (index targets that do not sum to the Euler characteristic) or
        `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`

For each patch one sparse factorization of a hermitian matrix with one row for each face without constrained edge, and
one solve; up to 100 solves in a patch without any constrained edge.

\sa `relax_frame_field()`
\sa `singularity_indices()`
*/
template <typename TriangleMesh, typename AlphaMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result orthogonal_frame_field(const TriangleMesh& tm, AlphaMap alpha_map,
                              const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef typename internal::Concurrency_from<CGAL_NP_CLASS>::type Concurrency_tag;

  const internal::Options options = internal::options_from(np);
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  Result result = internal::check_and_cut(options, stage_mesh);
  if(!result)
    return result;
  const auto& cut_mesh = stage_mesh.cut_mesh();
  std::vector<double> omega;
  result = internal::read_prescribed_rotation(cut_mesh, np, omega);
  if(!result)
    return result;

  std::vector<double> alpha;
  const auto solver_traits = internal::Solver_traits_from<CGAL_NP_CLASS>::get(np);
  result = internal::to_result(cut_mesh, internal::compute_orthogonal_field<Concurrency_tag>(
    cut_mesh.surface(), omega, internal::order_faces<Concurrency_tag>(cut_mesh.surface(), solver_traits), solver_traits,
    alpha));
  if(!result)
    return result;

  if(!CGAL::parameters::is_default_parameter<CGAL_NP_CLASS, internal::matching_t>::value)
  {
    std::vector<int> matching, index;
    std::vector<internal::Repaired_sector> repaired_sectors;
    result = internal::to_result(cut_mesh, internal::compute_matching_and_indices<Concurrency_tag>(
      cut_mesh.surface(), omega, alpha, options, matching, index, repaired_sectors));
    if(!result)
      return result;
    internal::write_on_dual_edges(cut_mesh, matching, CGAL::parameters::get_parameter(np, internal::matching));
  }
  internal::write_on_faces(cut_mesh, alpha, alpha_map);
  return result;
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_ORTHOGONAL_FRAME_FIELD_H
