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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_FACE_GRAPH_POLYGONS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_FACE_GRAPH_POLYGONS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/quads/measure_quads.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The faces of a mesh as flat arrays. The coordinates are divided by a power of two near the largest of them, so that
// products of them neither overflow nor underflow.
template <typename FaceGraph, typename NamedParameters>
class Face_graph_polygons
{
public:
  Face_graph_polygons(const FaceGraph& mesh, const NamedParameters& np)
    : m_mesh(mesh)
    , m_points(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
        CGAL::get_const_property_map(CGAL::vertex_point, mesh)))
    , m_traits(CGAL::parameters::choose_parameter<Geom_traits>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits)))
    , m_edge_is_constrained(CGAL::parameters::choose_parameter<Constraint_map>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained)))
    , m_vertex_number(get(CGAL::dynamic_vertex_property_t<int>(), mesh))
    , m_corner(get(CGAL::dynamic_halfedge_property_t<int>(), mesh))
  {}

  // Reads all faces in linear time, without their vertices that no face has. Fails with `ERROR_MESH_TOO_LARGE` if there
  // are more than 2^30 corners, and with `ERROR_NON_FINITE_COORDINATE`.
  Result read(Polygon_mesh& polygons) const
  {
    polygons = Polygon_mesh();
    for(const vertex_descriptor v : vertices(m_mesh))
      put(m_vertex_number, v, -1);
    for(const halfedge_descriptor h : halfedges(m_mesh))
      put(m_corner, h, -1);
    for(const face_descriptor f : faces(m_mesh))
    {
      if(polygons.vertex.size() > static_cast<std::size_t>((std::numeric_limits<int>::max)()) / 2)
        return failure(ERROR_MESH_TOO_LARGE, "more than 2^30 corners");
      if(!read_face(f, polygons))
        return failure(ERROR_NON_FINITE_COORDINATE, "face " + std::to_string(polygons.first_corner.size() - 1));
    }
    polygons.first_corner.push_back(static_cast<int>(polygons.vertex.size()));
    read_sides(polygons);
    scale(polygons);
    return {};
  }

private:
  typedef boost::graph_traits<FaceGraph> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename CGAL::GetVertexPointMap<FaceGraph, NamedParameters>::const_type Vertex_point_map;
  typedef typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type Geom_traits;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::edge_is_constrained_t, NamedParameters,
    CGAL::Static_boolean_property_map<edge_descriptor, false> >::type Constraint_map;
  typedef typename boost::property_map<FaceGraph, CGAL::dynamic_vertex_property_t<int> >::const_type Vertex_number_map;
  typedef typename boost::property_map<FaceGraph, CGAL::dynamic_halfedge_property_t<int> >::const_type Corner_map;

  // A corner is at the source of its halfedge. Returns whether all coordinates are finite.
  bool read_face(const face_descriptor f, Polygon_mesh& polygons) const
  {
    polygons.first_corner.push_back(static_cast<int>(polygons.vertex.size()));
    for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
    {
      const vertex_descriptor v = source(h, m_mesh);
      if(get(m_vertex_number, v) < 0)
      {
        const Coordinates p = coordinates_of(get(m_points, v), m_traits);
        if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
          return false;
        put(m_vertex_number, v, static_cast<int>(polygons.point.size()));
        polygons.point.push_back(p);
      }
      put(m_corner, h, static_cast<int>(polygons.vertex.size()));
      polygons.vertex.push_back(get(m_vertex_number, v));
      polygons.face.push_back(static_cast<int>(polygons.first_corner.size()) - 1);
    }
    return true;
  }

  void read_sides(Polygon_mesh& polygons) const
  {
    polygons.opposite.assign(polygons.vertex.size(), -1);
    polygons.is_constrained.assign(polygons.vertex.size(), false);
    for(const halfedge_descriptor h : halfedges(m_mesh))
      if(get(m_corner, h) >= 0)
      {
        polygons.opposite[get(m_corner, h)] = get(m_corner, opposite(h, m_mesh));
        polygons.is_constrained[get(m_corner, h)] = get(m_edge_is_constrained, edge(h, m_mesh));
      }
  }

  static void scale(Polygon_mesh& polygons)
  {
    double largest = 0;
    for(const Coordinates& p : polygons.point)
      largest = (std::max)(largest, maximum_norm(p));
    polygons.length_unit = largest > 0 ? std::scalbn(1., std::ilogb(largest)) : 1;
    for(Coordinates& p : polygons.point)
      p = { p[0] / polygons.length_unit, p[1] / polygons.length_unit, p[2] / polygons.length_unit };
  }

  const FaceGraph& m_mesh;
  Vertex_point_map m_points;
  Geom_traits m_traits;
  Constraint_map m_edge_is_constrained;
  Vertex_number_map m_vertex_number;
  Corner_map m_corner; // per halfedge
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_FACE_GRAPH_POLYGONS_H
