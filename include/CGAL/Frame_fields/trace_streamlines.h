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

#ifndef CGAL_FRAME_FIELDS_TRACE_STREAMLINES_H
#define CGAL_FRAME_FIELDS_TRACE_STREAMLINES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Streamline.h>
#include <CGAL/Frame_fields/internal/streamlines/Branch_directions.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_options.h>
#include <CGAL/Frame_fields/internal/streamlines/evenly_spaced_streamlines.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/maps/read_field.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/streamlines/streamline_output.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <utility>
#include <vector>

/// \file trace_streamlines.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

traces evenly spaced streamlines of a frame field, of both branch pairs, see Section \ref Frame_fieldsStreamlines.

In a face a streamline is straight. Across an edge it goes on along the branch that the matching gives. It ends on
constrained edges, at singular sectors, at its maximum length, where it closes up, and where it comes too near to
another line of its branch pair or to itself.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam AlphaMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam SkewnessMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
\tparam MatchingMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `int` as value type
\tparam OutputIterator a model of `OutputIterator` that accepts
        `Streamline<Point_3, boost::graph_traits<TriangleMesh>::%face_descriptor>`, with the point type of the geometric
        traits
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param alpha_map the angle of the first branch of each face, in radians
\param skewness_map the skewness of each face, in radians
\param matching_map the matching \f$ p_{ij} \f$
\param out gets the streamlines, patch by patch
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
    \cgalParamExtra{All computation is in `double`; the points are built from `double` coordinates.}
  \cgalParamNEnd
  \cgalParamNBegin{streamline_spacing}
    \cgalParamDescription{the distance of streamlines of a branch pair where they run side by side, and from constrained
                          edges that the field is aligned with}
    \cgalParamType{`double`, a length, or `std::optional<double>`}
    \cgalParamDefault{a fiftieth of the square root of the area of `tm`, or \f$ 10^{-3} \f$ of its longest edge if that
                      is more}
    \cgalParamExtra{It must be at least \f$ 10^{-6} \f$ of the longest edge, and its square at least
                    \f$ 10^{-9} \f$ of the area.}
  \cgalParamNEnd
  \cgalParamNBegin{streamline_separation}
    \cgalParamDescription{the part of the spacing at which a line stops when it comes near to another one of its
                          branch pair, to itself or to a constrained edge that the field is aligned with; with 0 no
                          line stops for this reason}
    \cgalParamType{`double` in \f$ [0, 1] \f$}
    \cgalParamDefault{0.5}
    \cgalParamExtra{This is checked at points of the line that are a quarter of the separation apart.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_streamline_length}
    \cgalParamDescription{the length at which a streamline ends. From where it begins it goes half as far either way.}
    \cgalParamType{`double`, a length}
    \cgalParamDefault{infinity}
  \cgalParamNEnd
  \cgalParamNBegin{concurrency_tag}
    \cgalParamDescription{tells whether patches are done in parallel; the output is the same, bit for bit}
    \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
    \cgalParamDefault{`CGAL::Sequential_tag`}
    \cgalParamExtra{`CGAL::Parallel_tag` requires TBB.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE`, `ERROR_WRONG_PARAMETER` or `ERROR_WRONG_FIELD` (an
        angle that is not finite or beyond \f$ \pm 10^6 \f$, a matching that is not opposite on opposite halfedges)

Takes time \cgalBigO{n \log n + m \log m} for \f$ n \f$ faces and lines of \f$ m \f$ segments, if the triangles are
not much longer than wide and lines are separated.

\sa `cad_frame_field()`
\sa `frame_vectors()`
*/
template <typename TriangleMesh, typename AlphaMap, typename SkewnessMap, typename MatchingMap, typename OutputIterator,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Result trace_streamlines(const TriangleMesh& tm, AlphaMap alpha_map, SkewnessMap skewness_map, MatchingMap matching_map,
                         OutputIterator out, const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  const bool accepts_overconstrained_faces = true;
  Result result = stage_mesh.cut(options, accepts_overconstrained_faces);
  const auto& cut_mesh = stage_mesh.cut_mesh();
  std::vector<double> alpha, rho;
  std::vector<int> matching;
  if(result)
    result = internal::read_field(cut_mesh, alpha_map, skewness_map, matching_map, alpha, rho, matching);
  if(!result)
    return result;

  const internal::Cut_surface& surface = cut_mesh.surface();
  const internal::Face_charts charts(surface);
  internal::Streamline_options streamline_options;
  result = internal::streamline_options_from(np, charts, streamline_options);
  if(!result)
    return result;
  typedef typename internal::Given_concurrency<CGAL_NP_CLASS>::type Concurrency_tag;
  typedef internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> Stage_mesh;
  typedef typename boost::graph_traits<typename Stage_mesh::Triangle_mesh>::face_descriptor face_descriptor;
  typedef typename Stage_mesh::Geom_traits::Point_3 Point_3;
  const internal::Branch_directions directions(surface, alpha, rho, matching);
  std::vector<Streamline<Point_3, face_descriptor> > output; // all of it, or an exception
  for(const auto& streamlines : internal::trace_in_patches<Concurrency_tag>(charts, directions, streamline_options))
    for(const internal::Traced_streamline& streamline : streamlines)
      output.push_back(internal::to_streamline(cut_mesh, directions, streamline, stage_mesh.traits()));
  std::move(output.begin(), output.end(), out);
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_TRACE_STREAMLINES_H
