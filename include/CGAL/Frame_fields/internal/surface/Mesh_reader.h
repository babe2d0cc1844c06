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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_MESH_READER_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_MESH_READER_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <type_traits>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The point map that the caller gave or else that of the mesh. The map of a constant mesh is only read.
template <typename Mesh, typename NamedParameters>
struct Vertex_point_map_of
{
  typedef typename CGAL::GetVertexPointMap<Mesh, NamedParameters>::type type;

  static type get(Mesh& mesh, const NamedParameters& np)
  {
    return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                              CGAL::get_property_map(CGAL::vertex_point, mesh));
  }
};

template <typename Mesh, typename NamedParameters>
struct Vertex_point_map_of<const Mesh, NamedParameters>
{
  typedef typename CGAL::GetVertexPointMap<Mesh, NamedParameters>::const_type type;

  static type get(const Mesh& mesh, const NamedParameters& np)
  {
    return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                              CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  }
};

// The geometric traits that the caller gave or that belong to the points.
template <typename FaceGraph, typename NamedParameters>
struct Geom_traits_from
{
  typedef typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type type;

  static type get(const NamedParameters& np)
  {
    return CGAL::parameters::choose_parameter<type>(CGAL::parameters::get_parameter(np,
                                                                                    CGAL::internal_np::geom_traits));
  }
};

// A mesh with its points, traits and constrained edges as the named parameters give them. Meshes are read through this
// class or through one derived from it only. The mesh must outlive it.
template <typename Mesh, typename NamedParameters>
class Mesh_reader
{
public:
  typedef typename std::remove_const<Mesh>::type Face_graph;
  typedef boost::graph_traits<Face_graph> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Geom_traits_from<Face_graph, NamedParameters>::type Geom_traits;
  typedef typename Geom_traits::Point_3 Point_3;

  Mesh_reader(Mesh& mesh, const NamedParameters& np)
    : m_mesh(mesh)
    , m_points(Vertex_point_map_of<Mesh, NamedParameters>::get(mesh, np))
    , m_traits(Geom_traits_from<Face_graph, NamedParameters>::get(np))
    , m_edge_is_constrained(CGAL::parameters::choose_parameter<Constraint_map>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained)))
  {}

  Mesh& mesh() const { return m_mesh; }
  const Geom_traits& traits() const { return m_traits; }
  Point_3 point(const vertex_descriptor v) const { return get(m_points, v); }
  Coordinates coordinates(const vertex_descriptor v) const { return coordinates_of(get(m_points, v), m_traits); }

  // Tells whether the edge of a halfedge is a border edge or marked by the caller's map.
  bool is_constrained(const halfedge_descriptor h) const
  {
    return is_border(opposite(h, m_mesh), m_mesh) || is_border(h, m_mesh)
        || get(m_edge_is_constrained, edge(h, m_mesh));
  }

protected:
  typedef typename Vertex_point_map_of<Mesh, NamedParameters>::type Vertex_point_map;
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::edge_is_constrained_t, NamedParameters,
    CGAL::Static_boolean_property_map<edge_descriptor, false> >::type Constraint_map;

  Mesh& m_mesh;
  Vertex_point_map m_points;
  Geom_traits m_traits;
  Constraint_map m_edge_is_constrained;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_MESH_READER_H
