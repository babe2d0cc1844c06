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

#ifndef CGAL_FRAME_FIELDS_PRESCRIBE_ROTATION_H
#define CGAL_FRAME_FIELDS_PRESCRIBE_ROTATION_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Support_strategy.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/field/stages.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <vector>

/// \file prescribe_rotation.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

computes the rotation \f$ \omega_{ij} \f$ that a frame field should make across each unconstrained edge so that sharp
corners do not become singularities of index \f$ 1/2 \f$ (Section 3.2 of \cgalCite{cgal:dprcs-ffcm-22}).

With the strategies `Support_strategy::rings()`, `Support_strategy::component()` and `Support_strategy::radius()` the
rotations sum to \f$ \theta - \pi/2 \f$ counter-clockwise around a sharp corner of angle \f$ \theta < 3\pi/4 \f$, which
is what index \f$ 1/4 \f$ needs; elsewhere they sum to what the strategy takes back. In a patch with index targets they
sum to what the targets need, whatever the strategy. Among all rotations with these sums this one has the smallest
\f$ \sum w_{ij} \omega_{ij}^2 \f$. It is exactly zero in patches that have neither sharp nor blunt corners nor index
targets.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam PrescribedRotationMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param prescribed_rotation_map gets the rotation, in radians, from the face of a halfedge to the face of its opposite;
       \f$ \omega_{ji} = -\omega_{ij} \f$, and 0 on constrained edges
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
        `ERROR_WRONG_FIELD` (two index targets for one sector, or one out of range), `ERROR_POINCARE_HOPF` (index
        targets that do not sum to the Euler characteristic; the message names what is missing),
        `ERROR_NO_RECEIVING_SECTOR` (only for sharp bounds of \f$ \pi \f$ and more) or
        `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`

For each patch with sharp or blunt corners, or with index targets, one sparse factorization of a symmetric matrix with
one row less than the patch has sectors. Patches without index targets need none with `Support_strategy::none()` and
`Support_strategy::local()`.

\sa `sharp_corners()`

\sa `orthogonal_frame_field()`
*/
template <typename TriangleMesh, typename PrescribedRotationMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result prescribe_rotation(const TriangleMesh& tm, PrescribedRotationMap prescribed_rotation_map,
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
  result = internal::to_result(cut_mesh, internal::prescribe_rotation<Concurrency_tag>(
    cut_mesh.surface(), options, internal::Solver_traits_from<CGAL_NP_CLASS>::get(np), omega));
  if(result)
    internal::write_on_dual_edges(cut_mesh, omega, prescribed_rotation_map);
  return result;
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_PRESCRIBE_ROTATION_H
