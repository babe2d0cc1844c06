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

#ifndef CGAL_FRAME_FIELDS_REFINE_TRIANGLES_H
#define CGAL_FRAME_FIELDS_REFINE_TRIANGLES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Refinement_statistics.h>
#include <CGAL/Frame_fields/internal/named_parameters/give_to_caller.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Coplanar_flips.h>
#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Longest_edge_splits.h>
#include <CGAL/Frame_fields/internal/surface/coordinate_rounding.h>
#include <CGAL/Frame_fields/internal/surface/flip_and_split.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>
#include <vector>

/// \file refine_triangles.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

refines a triangle mesh until no edge is longer than a bound, and leaves the surface where it is.

Raw tessellations of CAD models have triangles as long as the model, needles among them, and no vertex inside a patch.
This gives fields and maps triangles to work with. The steps are:

- Edges that are not constrained are flipped inside planes until the triangles there are Delaunay, which takes apart the
  fans of needles that cover planar faces.
- The longest edges are split at their midpoints, the longest first, so that triangles are bisected at their longest
  edge. Those that cannot be flipped count as 1.4 times as long. Both parts of a constrained edge are constrained.
- Edges are flipped again as in the first step.

The last two steps are repeated for shorter and shorter edges, until none is longer than the bound. Only an edge whose
midpoint is rounded to one of its ends stays longer. No pass makes more than eight flips for each edge given to it.

Repeated bisection leaves at least a half of the smallest angle of a triangle, and a flip does not make the smallest
angle of the two triangles smaller. In planes angles usually become much larger. Triangles that are narrow between
constrained edges or on a curved surface stay so.

All vertices stay where they are, and new ones lie on old triangles as far as the rounding of their coordinates allows.
A flip exchanges the diagonals of two triangles if the distance of these diagonals, the most by which the surface moves,
is not above `flip_tolerance`; where flips follow one another, what they move adds up.

\tparam TriangleMesh a model of `VertexListGraph`, `EdgeListGraph`, `FaceListGraph` and `MutableFaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param maximum_edge_length the bound for the lengths of edges, positive, or infinity for flips alone; 4/3 of the edge
       length of the quadrangles to come is a good choice
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map containing the feature edges of `tm`; border edges always count as such}
    \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                   as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false` for any edge}
    \cgalParamExtra{Both parts of an edge get its value, and new edges inside triangles `false`.}
  \cgalParamNEnd
  \cgalParamNBegin{flip_tolerance}
    \cgalParamDescription{the most by which a flip may move the surface}
    \cgalParamType{`double`, a length of the mesh, not negative}
    \cgalParamDefault{eight times the rounding of the coordinates}
    \cgalParamExtra{Four points of a plane, each rounded by up to \f$ u \f$ in its coordinates, have diagonals at a
                    distance of up to \f$ 2 \sqrt 3 u \f$, and the midpoints of edges are rounded once more. If all
                    coordinates are values of `float`, or decimal numbers of 6 to 15 digits, then \f$ u \f$ is the
                    rounding of these, and that of `double` otherwise.}
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
    \cgalParamDescription{gets the numbers of splits and flips}
    \cgalParamType{`std::reference_wrapper<Refinement_statistics>`}
    \cgalParamDefault{they are not told}
    \cgalParamExtra{Set on success only.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_NON_FINITE_COORDINATE`, `ERROR_WRONG_PARAMETER` or
        `ERROR_MESH_TOO_LARGE` (the refined mesh would have more than 2^31 / 6 faces); `tm` is unchanged if it is not
        `OK`

\exception std::bad_alloc if memory is exhausted; `tm` is a valid mesh of the same surface then

\cgalBigO{n \log n} for \f$ n \f$ edges of the refined mesh. The order of `edges(tm)` decides between edges of the same
length.

\sa `split_overconstrained_faces()`
\sa `split_chords()`
*/
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result refine_triangles(TriangleMesh& tm, const double maximum_edge_length,
                        const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;

  if(!(maximum_edge_length > 0))
    return internal::failure(ERROR_WRONG_PARAMETER, "maximum_edge_length must be positive");
  const internal::Editable_mesh<TriangleMesh, CGAL_NP_CLASS> mesh(tm, np);
  std::vector<internal::Coordinates> points;
  const Result result = internal::read_for_refinement(tm, mesh, points);
  if(!result)
    return result;

  Refinement_statistics statistics;
  statistics.flip_tolerance = choose_parameter(get_parameter(np, internal::flip_tolerance),
                                               internal::default_flip_tolerance(points));
  if(!(statistics.flip_tolerance >= 0))
    return internal::failure(ERROR_WRONG_PARAMETER, "flip_tolerance must not be negative");
  const double maximum_number_of_faces = (std::numeric_limits<int>::max)() / 6.;
  if(!(internal::least_number_of_faces(tm, mesh, maximum_edge_length) <= maximum_number_of_faces))
    return internal::failure(ERROR_MESH_TOO_LARGE, "for a maximum_edge_length of "
                                                   + std::to_string(maximum_edge_length));

  double largest = 0;
  for(const internal::Coordinates& point : points)
    largest = (std::max)(largest, internal::maximum_norm(point));
  const double unit = largest > 0 ? std::scalbn(1., std::ilogb(largest)) : 1;
  const internal::Coplanar_flips<TriangleMesh, CGAL_NP_CLASS> flips(tm, mesh, unit, statistics.flip_tolerance);
  const auto is_in_plane = [&](const auto h) { return flips.is_in_plane(h); };
  internal::Longest_edge_splits<TriangleMesh, CGAL_NP_CLASS, decltype(is_in_plane)> splits(
    tm, mesh, maximum_edge_length, (std::numeric_limits<double>::infinity)(), is_in_plane);
  std::deque<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> all_edges;
  for(const auto e : edges(tm))
    all_edges.push_back(halfedge(e, tm));
  internal::flip_and_split(tm, all_edges, flips, splits, maximum_edge_length, statistics);
  internal::give_to_caller(statistics, get_parameter(np, internal::statistics));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_REFINE_TRIANGLES_H
