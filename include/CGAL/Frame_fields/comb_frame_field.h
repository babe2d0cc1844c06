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

#ifndef CGAL_FRAME_FIELDS_COMB_FRAME_FIELD_H
#define CGAL_FRAME_FIELDS_COMB_FRAME_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/parameterization/comb_patch.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

/// \file comb_frame_field.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

numbers the branches of a frame field such that direction \f$ k \f$ of a face goes on as direction \f$ k \f$ of its
neighbor across all unconstrained edges but the <em>seams</em>. A quad mesher calls the directions 0, 1, 2 and 3 of a
face \f$ u, v, -u \f$ and \f$ -v \f$.

The numbers follow the matching, which `cad_frame_field()` and `orthogonal_frame_field()` write on demand; the angles of
the field do not matter. From the first face of a patch they go from face to face across unconstrained edges. The edges
that are not crossed on this way, with the constrained edges, are a <em>cut graph</em>: cut along them, the patch is
a disk. Seams are edges of the cut graph. The directions on both sides of a seam differ by quarter turns, which only
the matching determines: the quarter turns across the edges around a sector that is not on a constrained edge,
counter-clockwise, sum to \f$ 4I \f$ modulo 4. So seams end at constrained edges and at such sectors where \f$ 4I \f$ is
no multiple of 4; where no seam ends, they go on.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam MatchingMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam FirstBranchMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `int` as value type
\tparam QuarterTurnMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param matching_map holds the matching \f$ p_{ij} \f$ of the field
\param first_branch_map gets the number of the branch, 0 to 3, that is direction 0 of a face: direction \f$ k \f$ is
       branch \f$ k \f$ plus this, modulo 4, of `frame_vectors()`
\param quarter_turn_map gets \f$ q \f$ such that direction \f$ k \f$ of the face of a halfedge goes on as direction
       \f$ k + q \f$, modulo 4, of the face of its opposite, with the opposite sign there; 0 but on seams. This is the
       matching of the field with its new numbers.
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
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre No face has more than one constrained edge, see `split_overconstrained_faces()`.

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE`, `ERROR_OVERCONSTRAINED_FACE` or
        `ERROR_WRONG_FIELD` (a matching that is not opposite on opposite halfedges)

\cgalBigO{n} for \f$ n \f$ faces.

\sa `cad_frame_field()`
\sa `frame_vectors()`
\sa `singularities()`
*/
template <typename TriangleMesh, typename MatchingMap, typename FirstBranchMap, typename QuarterTurnMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Result comb_frame_field(const TriangleMesh& tm, MatchingMap matching_map, FirstBranchMap first_branch_map,
                        QuarterTurnMap quarter_turn_map,
                        const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  Result result = internal::check_and_cut(internal::options_from(np), stage_mesh);
  const auto& cut_mesh = stage_mesh.cut_mesh();
  std::vector<int> matching;
  if(result)
    result = internal::read_from_dual_edges(cut_mesh, "the matching", matching_map, matching);
  if(!result)
    return result;

  const internal::Cut_surface& surface = cut_mesh.surface();
  std::vector<int> first_branch(surface.number_of_faces()), quarter_turns(surface.number_of_dual_edges());
  for(const internal::Patch& patch : surface.patches)
    internal::comb_patch(surface, patch, matching, first_branch, quarter_turns);
  internal::write_on_faces(cut_mesh, first_branch, first_branch_map);
  internal::write_on_dual_edges(cut_mesh, quarter_turns, quarter_turn_map);
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_COMB_FRAME_FIELD_H
