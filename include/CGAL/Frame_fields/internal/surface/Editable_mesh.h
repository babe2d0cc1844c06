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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_EDITABLE_MESH_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_EDITABLE_MESH_H

#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A mesh that is about to be refined, with the maps that must follow.
template <typename TriangleMesh, typename NamedParameters>
class Editable_mesh
{
public:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename CGAL::GetGeomTraits<TriangleMesh, NamedParameters>::type Geom_traits;
  typedef typename Geom_traits::Point_3 Point_3;

  Editable_mesh(TriangleMesh& tm, const NamedParameters& np)
    : m_mesh(tm)
    , m_points(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
        CGAL::get_property_map(CGAL::vertex_point, tm)))
    , m_traits(CGAL::parameters::choose_parameter<Geom_traits>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits)))
    , m_edge_is_constrained(CGAL::parameters::choose_parameter<Constraint_map>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained)))
  {}

  // Throws if a face is not a triangle.
  void check_triangles(const char* const function) const
  {
    std::size_t number = 0;
    for(const auto f : faces(m_mesh))
    {
      if(!CGAL::is_triangle(halfedge(f, m_mesh), m_mesh))
        throw std::invalid_argument(std::string(function) + ": face " + std::to_string(number)
                                    + " of faces(tm) is not a triangle");
      ++number;
    }
  }

  // Makes room for new elements, so that no allocation fails while the mesh is changed; as far as its class has this.
  void reserve_for(const std::size_t vertices, const std::size_t edges, const std::size_t faces) const
  {
    reserve_in(m_mesh, vertices, edges, faces, 0);
  }

  bool is_constrained(const halfedge_descriptor h) const
  {
    return is_border(h, m_mesh) || is_border(opposite(h, m_mesh), m_mesh)
        || get(m_edge_is_constrained, edge(h, m_mesh));
  }

  // Marks a new edge as unconstrained if the map can be written.
  void mark_unconstrained(const halfedge_descriptor h) const
  {
    if constexpr(is_constraint_map_writable)
      put(m_edge_is_constrained, edge(h, m_mesh), false);
  }

  // Gives a part of a split edge the mark of the other part if the map can be written.
  void copy_constraint(const halfedge_descriptor from, const halfedge_descriptor to) const
  {
    if constexpr(is_constraint_map_writable)
      put(m_edge_is_constrained, edge(to, m_mesh), get(m_edge_is_constrained, edge(from, m_mesh)));
  }

  Point_3 point(const vertex_descriptor v) const { return get(m_points, v); }
  Coordinates coordinates(const vertex_descriptor v) const { return coordinates_of(point(v), m_traits); }
  void set_point(const vertex_descriptor v, const Point_3& point) const { put(m_points, v, point); }
  Geom_traits traits() const { return m_traits; }

  // Splits an unconstrained edge at its midpoint, and its two triangles with it.
  void split_edge_with_faces(const halfedge_descriptor h) const
  {
    const Point_3 midpoint =
      m_traits.construct_midpoint_3_object()(point(source(h, m_mesh)), point(target(h, m_mesh)));
    const halfedge_descriptor to_midpoint = CGAL::Euler::split_edge(h, m_mesh);
    set_point(target(to_midpoint, m_mesh), midpoint);
    mark_unconstrained(to_midpoint);
    mark_unconstrained(h);
    split_face(to_midpoint);
    split_face(opposite(h, m_mesh));
  }

private:
  // Joins the vertex at the target of `to_midpoint` to the opposite one of a face with four of them.
  void split_face(const halfedge_descriptor to_midpoint) const
  {
    mark_unconstrained(CGAL::Euler::split_face(to_midpoint, next(next(to_midpoint, m_mesh), m_mesh), m_mesh));
  }

  template <typename Mesh>
  static auto reserve_in(Mesh& mesh, const std::size_t vertices, const std::size_t edges, const std::size_t faces, int)
    -> decltype(reserve(mesh, num_vertices(mesh) + vertices, num_edges(mesh) + edges, num_faces(mesh) + faces))
  {
    return reserve(mesh, num_vertices(mesh) + vertices, num_edges(mesh) + edges, num_faces(mesh) + faces);
  }
  template <typename Mesh>
  static void reserve_in(Mesh&, std::size_t, std::size_t, std::size_t, long) {}

  typedef typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::type Vertex_point_map;
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::edge_is_constrained_t, NamedParameters,
    CGAL::Static_boolean_property_map<edge_descriptor, false> >::type Constraint_map;
  static constexpr bool is_constraint_map_writable =
    std::is_convertible<typename boost::property_traits<Constraint_map>::category,
                        boost::writable_property_map_tag>::value;

  TriangleMesh& m_mesh;
  Vertex_point_map m_points;
  Geom_traits m_traits;
  Constraint_map m_edge_is_constrained;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_EDITABLE_MESH_H
