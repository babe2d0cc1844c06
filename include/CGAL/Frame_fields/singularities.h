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

#ifndef CGAL_FRAME_FIELDS_SINGULARITIES_H
#define CGAL_FRAME_FIELDS_SINGULARITIES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Geodesic_distances.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <limits>
#include <vector>

/// \file singularities.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsRef
///
/// is a sector whose index is not 0.
///
/// \tparam Halfedge a halfedge descriptor
template <typename Halfedge>
struct Singularity
{
  /// a halfedge with a corner of the sector at its target
  Halfedge halfedge;

  /// four times the index
  int index;

  /// whether the sector is on a constrained edge
  bool is_constrained;

  /// the angle of the sector, in radians
  double angle;

  /// the length of the shortest path on the patch from the sector to the nearest constrained edge's vertex, as a front
  /// that unfolds the triangles finds it; infinite if the patch has no constrained edge
  double distance_to_features;
};

/*!
\ingroup PkgFrame_fieldsRef

lists the sectors of a frame field whose index is not 0, with their places and their distances to the features.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam IndexMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam OutputIterator a model of `OutputIterator` that accepts
        `Singularity<boost::graph_traits<TriangleMesh>::%halfedge_descriptor>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param index_map four times the index of the sector of the corner at the target of each halfedge
\param out gets one `Singularity` for each sector with an index other than 0
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
\cgalNamedParamsEnd

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE` or `ERROR_ZERO_LENGTH_EDGE`

\cgalBigO{n} for \f$ n \f$ faces, and for each singularity in a patch with constrained edges \cgalBigO{m \log m} for
the \f$ m \f$ faces that are nearer to it than the nearest of them.

\sa `singularity_indices()`
*/
template <typename TriangleMesh, typename IndexMap, typename OutputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result singularities(const TriangleMesh& tm, IndexMap index_map, OutputIterator out,
                     const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  const bool accepts_overconstrained_faces = true;
  const Result result = stage_mesh.cut(options, accepts_overconstrained_faces);
  if(!result)
    return result;
  const auto& cut_mesh = stage_mesh.cut_mesh();

  const internal::Cut_surface& surface = cut_mesh.surface();
  typedef typename internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS>::Triangle_mesh Triangle_mesh;
  std::vector<Singularity<typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor> > found;
  for(const internal::Patch& patch : surface.patches)
  {
    const bool has_constrained_sector = internal::has_constrained_sector(surface, patch);
    internal::Geodesic_distances distances(surface, patch);
    for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
    {
      const auto h = cut_mesh.halfedge_of(surface.first_corner[s]);
      const int index = get(index_map, h);
      if(index != 0)
      {
        const double distance = has_constrained_sector
                              ? surface.length_unit * internal::distance_to_constrained_sector(surface, s, distances)
                              : std::numeric_limits<double>::infinity();
        found.push_back({ h, index, surface.is_constrained_sector(s), surface.total_angle[s], distance });
      }
    }
  }
  for(const auto& singularity : found)
    *out++ = singularity;
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_SINGULARITIES_H
