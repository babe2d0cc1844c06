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

#ifndef CGAL_FRAME_FIELDS_PREPARE_FOR_FRAME_FIELD_H
#define CGAL_FRAME_FIELDS_PREPARE_FOR_FRAME_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Refinement_statistics.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/named_parameters/give_to_caller.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>
#include <CGAL/Frame_fields/internal/surface/room_for_indices.h>
#include <CGAL/Frame_fields/split_chords.h>
#include <CGAL/Frame_fields/split_overconstrained_faces.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

/// \file prepare_for_frame_field.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

splits faces and edges until a mesh has all that a field for quadrangles needs: no face has more than one constrained
edge, every face has a vertex that is on no constrained edge, and every patch has enough of them for the singularities
that `cad_frame_field()` must move inside so that every sector on constrained edges gets its natural index.

It does what `split_overconstrained_faces()` and `split_chords()` do, and then splits the longest unconstrained edges of
each patch that still lacks vertices inside at their midpoints, with their triangles. The surface does not change. A
mesh that needs nothing stays as it is.

\tparam TriangleMesh a model of `FaceListGraph`, `EdgeListGraph`, `HalfedgeListGraph` and `MutableFaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map containing the feature edges of `tm`; border edges always count as such}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                   as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false` for any edge}
    \cgalParamExtra{If the map is a model of `ReadWritePropertyMap`, the new edges are put to `false`; otherwise it must
                    return `false` for them.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{statistics}
    \cgalParamDescription{gets the numbers of split faces and edges}
    \cgalParamType{`std::reference_wrapper<Refinement_statistics>`}
    \cgalParamDefault{they are not told}
    \cgalParamExtra{Set on success only.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE` or `ERROR_ZERO_LENGTH_EDGE`. On an error of the mesh as it was given,
        \c tm is unchanged. Where a face with two constrained edges is so small that rounding leaves no point inside,
        the split mesh has an edge of length zero; then `ERROR_ZERO_LENGTH_EDGE` is returned, and \c tm stays split.
        Edges without a point between their ends are not split.

\exception std::bad_alloc if memory is exhausted

\cgalBigO{n} for \f$ n \f$ faces if the degrees of the vertices are bounded, see `split_chords()`; patches that lack
vertices sort their edges.

\sa `cad_frame_field()`
\sa `split_overconstrained_faces()`
\sa `split_chords()`
*/
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result prepare_for_frame_field(TriangleMesh& tm, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> Stage_mesh;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;

  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  const bool accepts_overconstrained_faces = true;
  const Result result = Stage_mesh(tm, np).cut(options, accepts_overconstrained_faces);
  if(!result)
    return result;
  const internal::Editable_mesh<TriangleMesh, CGAL_NP_CLASS> mesh(tm, np);
  Refinement_statistics statistics;
  statistics.number_of_split_faces = internal::split_faces_of(tm, mesh);
  statistics.number_of_splits = internal::split_chords_of(tm, mesh);

  // One round is enough unless a patch has fewer edges than it needs vertices, or a new rounding error changes a
  // natural index. A round that splits all edges of a patch at least doubles them, and no patch needs more than a few
  // for each sector.
  const int maximum_number_of_rounds = 32;
  for(int round = 0; round < maximum_number_of_rounds; ++round)
  {
    std::vector<halfedge_descriptor> edges;
    {
      Stage_mesh stage_mesh(tm, np);
      const Result split_result = stage_mesh.cut(options);
      if(!split_result)
        return split_result;
      const auto& cut_mesh = stage_mesh.cut_mesh();
      for(const int e : internal::edges_that_make_room(cut_mesh.surface()))
        edges.push_back(cut_mesh.halfedge_of(cut_mesh.surface().dual_edges[e].halfedge));
    }
    if(edges.empty())
      break;
    mesh.reserve_for(edges.size(), 3 * edges.size(), 2 * edges.size());
    std::size_t number_of_splits = 0;
    for(const halfedge_descriptor h : edges)
      number_of_splits += mesh.split_edge_with_faces(h) != boost::graph_traits<TriangleMesh>::null_halfedge();
    if(number_of_splits == 0)
      break; // they are too short
    statistics.number_of_splits += number_of_splits;
  }
  internal::give_to_caller(statistics, CGAL::parameters::get_parameter(np, internal::statistics));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_PREPARE_FOR_FRAME_FIELD_H
