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

#ifndef CGAL_FRAME_FIELDS_SPLIT_OVERCONSTRAINED_FACES_H
#define CGAL_FRAME_FIELDS_SPLIT_OVERCONSTRAINED_FACES_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

/// \file split_overconstrained_faces.h

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Marks an edge as unconstrained in maps that can be written.
template <typename Map, typename Edge>
void mark_unconstrained(const Map map, const Edge e)
{
  if constexpr(std::is_convertible<typename boost::property_traits<Map>::category,
                                   boost::writable_property_map_tag>::value)
    put(map, e, false);
}

// A point inside the triangle: its centroid, or on a degenerate triangle whose centroid is a vertex some other point.
template <typename Point, typename GeomTraits>
Point point_inside(const Point& p, const Point& q, const Point& r, const GeomTraits& traits)
{
  const Point centroid = traits.construct_centroid_3_object()(p, q, r);
  if(centroid != p && centroid != q && centroid != r)
    return centroid;
  // That vertex is the midpoint of the two others, which no combination with three different weights gives.
  return traits.construct_barycenter_3_object()(p, 3, q, 2, r, 1);
}

// Throws if a face is not a triangle.
template <typename TriangleMesh>
void check_triangles(const TriangleMesh& tm, const char* const function)
{
  std::size_t number = 0;
  for(const auto f : faces(tm))
  {
    if(!CGAL::is_triangle(halfedge(f, tm), tm))
      throw std::invalid_argument(std::string(function) + ": face " + std::to_string(number)
                                  + " of faces(tm) is not a triangle");
    ++number;
  }
}

} // namespace internal

/*!
\ingroup PkgFrame_fieldsRef

splits each face with two or three constrained edges into three at its centroid, so that no face has more than one
constrained edge, as all other functions of this package require (Section 3.3 of \cgalCite{cgal:dprcs-ffcm-22}). On a
degenerate face whose centroid is one of its vertices it takes another point inside.

A frame cannot be aligned with two edges of a face unless they are perpendicular. The surface does not change. Only
this function and `split_chords()` modify a mesh.

\tparam TriangleMesh a model of `FaceListGraph` and `MutableFaceGraph`
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

\return the number of faces that were split

\exception std::invalid_argument if a face is not a triangle; its message names the face, and `tm` is unchanged

\cgalBigO{n} for \f$ n \f$ faces.

\sa `split_chords()`
*/
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::size_t split_overconstrained_faces(TriangleMesh& tm,
                                        const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename CGAL::GetGeomTraits<TriangleMesh, CGAL_NP_CLASS>::type Geom_traits;
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::edge_is_constrained_t, CGAL_NP_CLASS,
    CGAL::Static_boolean_property_map<edge_descriptor, false> >::type Constraint_map;

  const auto points = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
    CGAL::get_property_map(CGAL::vertex_point, tm));
  const Geom_traits traits = CGAL::parameters::choose_parameter<Geom_traits>(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits));
  const Constraint_map edge_is_constrained = CGAL::parameters::choose_parameter<Constraint_map>(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained));

  const auto is_constrained = [&](const halfedge_descriptor h)
  {
    return is_border(opposite(h, tm), tm) || get(edge_is_constrained, edge(h, tm));
  };

  internal::check_triangles(tm, "split_overconstrained_faces");
  std::vector<halfedge_descriptor> overconstrained; // one halfedge of each face, kept apart from the changing face range
  for(const auto f : faces(tm))
  {
    const halfedge_descriptor h = halfedge(f, tm);
    if(is_constrained(h) + is_constrained(next(h, tm)) + is_constrained(prev(h, tm)) > 1)
      overconstrained.push_back(h);
  }

  for(const halfedge_descriptor h : overconstrained)
  {
    const typename Geom_traits::Point_3 center = internal::point_inside<typename Geom_traits::Point_3>(
      get(points, source(h, tm)), get(points, target(h, tm)), get(points, target(next(h, tm), tm)), traits);
    const halfedge_descriptor to_center = CGAL::Euler::add_center_vertex(h, tm);
    put(points, target(to_center, tm), center);
    halfedge_descriptor spoke = to_center;
    do
    {
      internal::mark_unconstrained(edge_is_constrained, edge(spoke, tm));
      spoke = opposite(next(spoke, tm), tm);
    } while(spoke != to_center);
  }
  return overconstrained.size();
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_SPLIT_OVERCONSTRAINED_FACES_H
