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
#ifndef CGAL_FRAME_FIELDS_DETECT_FEATURE_EDGES_H
#define CGAL_FRAME_FIELDS_DETECT_FEATURE_EDGES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/features/Feature_mesh.h>
#include <CGAL/Frame_fields/internal/features/Feature_options.h>
#include <CGAL/Frame_fields/internal/features/feature_graph.h>
#include <CGAL/Frame_fields/internal/features/flat_faces.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <vector>

/// \file detect_feature_edges.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

finds feature edges by the angles between the normals of their faces, and cleans them up.

-# Edges of the strong angle or more are features, and edges of the weak angle or more that are connected with them by
   such edges. So a crease that fades out is followed, and one that is weak all along is not taken.
-# If `close_gaps` is `true`, an edge becomes a feature that joins two dangling ends, vertices at which exactly one
   feature ends, and that turns by less than a right angle at both. If several edges compete for an end, the one with
   the smaller turns is taken.
-# Features form chains, which reach from one vertex where not exactly two features meet to the next. A chain shorter
   than the minimum length is no feature if one of its ends dangles, or if it is closed and meets no other. The shortest
   chain goes first; two chains that are left at a vertex become one. So spurs are removed; the chains that they branch
   from and the boundaries of patches stay.

Border edges always are features. Coordinates have errors, so a face that is hardly higher than they are has no normal
of its own: one whose height over its longest edge is at most 4.5 times the error of a coordinate. The normal of the
neighbor that it lies along stands for it, and its own where no neighbor is better off.

\tparam TriangleMesh a model of `VertexListGraph`, `FaceListGraph`, `EdgeListGraph` and `HalfedgeListGraph`
\tparam EdgeIsFeatureMap a class model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param edge_is_feature_map is written for all edges on success, and not at all otherwise
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{strong_angle_in_degrees}
    \cgalParamDescription{the angle between normals from which an edge is a feature}
    \cgalParamType{`double`, from 0 to 180}
    \cgalParamDefault{40}
  \cgalParamNEnd
  \cgalParamNBegin{weak_angle_in_degrees}
    \cgalParamDescription{the angle between normals from which an edge continues features}
    \cgalParamType{`double`, from 0 to `strong_angle_in_degrees`}
    \cgalParamDefault{`strong_angle_in_degrees`}
  \cgalParamNEnd
  \cgalParamNBegin{close_gaps}
    \cgalParamDescription{whether gaps of one edge are closed}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_chain_length}
    \cgalParamDescription{the length under which chains that dangle, or are closed and alone, are removed}
    \cgalParamType{`double`, a length of the mesh, not negative}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{coordinate_error}
    \cgalParamDescription{the largest error of a coordinate}
    \cgalParamType{`double`, a length, not negative, or `std::optional<double>`}
    \cgalParamDefault{\f$ 2^{-24} \f$ of the longest side of the bounding box; if all coordinates of `tm` are numbers of
                      type `float`, as in STL files, at least half the distance from the largest coordinate of a face to
                      the next such number}
    \cgalParamExtra{Give \f$ 0.5 \cdot 10^{-d} \f$ for coordinates with \f$ d \f$ digits after the point. Less
                    than the rounding of `double` does not count.}
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

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`,
        `ERROR_NON_FINITE_COORDINATE` or `ERROR_WRONG_PARAMETER`

\cgalBigO{n} for \f$ n \f$ edges, \cgalBigO{m \log m} for \f$ m \f$ faces without normal, and \cgalBigO{n \log n}
for each round in which chains are removed; a second round is needed where chains have become one.

\sa `dangling_feature_ends()`
\sa `cad_frame_field()`
*/
template <typename TriangleMesh, typename EdgeIsFeatureMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result detect_feature_edges(const TriangleMesh& tm, EdgeIsFeatureMap edge_is_feature_map,
                            const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  const internal::Feature_options options = internal::feature_options_from(np);
  Result result = internal::check(options);
  if(!result)
    return result;
  internal::Feature_mesh<TriangleMesh, CGAL_NP_CLASS> mesh(tm, np);
  internal::Feature_graph graph;
  internal::Feature_faces faces;
  result = mesh.read(graph, faces);
  if(!result)
    return result;
  const internal::Coordinate_error coordinate_error(graph, faces, options.coordinate_error);
  const std::vector<int> normal_face =
    internal::Flat_faces(graph, faces, coordinate_error).faces_with_normals();
  internal::mark_with_hysteresis(graph, mesh.dihedral_angles(graph, faces, normal_face), options.strong_angle,
                                 options.weak_angle);
  if(options.closes_gaps)
    internal::join_dangling_ends(graph);
  if(options.minimum_chain_length > 0)
    internal::remove_short_chains(graph, options.minimum_chain_length);
  for(std::size_t e = 0; e < graph.is_feature.size(); ++e)
    put(edge_is_feature_map, mesh.edge_descriptors()[e], static_cast<bool>(graph.is_feature[e]));
  return {};
}

/*!
\ingroup PkgFrame_fieldsRef

lists the dangling ends of features: the vertices at which exactly one feature edge ends. There a curve ends inside a
patch, and the field sees one sector of a full turn. Often an edge of the features is missing.

\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph` and `HalfedgeListGraph`
\tparam EdgeIsFeatureMap a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam OutputIterator a model of `OutputIterator` that accepts `boost::graph_traits<TriangleMesh>::%vertex_descriptor`

\param tm the mesh
\param edge_is_feature_map the feature edges of `tm`; border edges always count as such
\param out gets the vertices in the order of `vertices(tm)`

\cgalBigO{n} for \f$ n \f$ edges.

\sa `detect_feature_edges()`
*/
template <typename TriangleMesh, typename EdgeIsFeatureMap, typename OutputIterator>
void dangling_feature_ends(const TriangleMesh& tm, EdgeIsFeatureMap edge_is_feature_map, OutputIterator out)
{
  const auto number_of_features = get(CGAL::dynamic_vertex_property_t<int>(), tm);
  for(const auto v : vertices(tm))
    put(number_of_features, v, 0);
  for(const auto e : edges(tm))
  {
    const auto h = halfedge(e, tm);
    if(get(edge_is_feature_map, e) || is_border(h, tm) || is_border(opposite(h, tm), tm))
      for(const auto v : { source(h, tm), target(h, tm) })
        put(number_of_features, v, get(number_of_features, v) + 1);
  }
  for(const auto v : vertices(tm))
    if(get(number_of_features, v) == 1)
      *out++ = v;
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_DETECT_FEATURE_EDGES_H
