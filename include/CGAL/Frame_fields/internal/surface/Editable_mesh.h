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

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_reader.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A mesh class can overload these functions to learn where its new elements come from: a vertex between up to three
// vertices of a face, with their weights; an edge or a face that is a part of another one; and a flipped edge. By
// default they do nothing.
template <typename Mesh, typename Vertex>
void note_vertex(Mesh&, const Vertex&, const std::array<Vertex, 3>&, const std::array<double, 3>&) {}
template <typename Mesh, typename Edge>
void note_edge(Mesh&, const Edge&, const Edge&) {}
template <typename Mesh, typename Face>
void note_face(Mesh&, const Face&, const Face&) {}
template <typename Mesh, typename Halfedge>
void note_flip(Mesh&, const Halfedge&) {}

// The factor by which the length between two vertices is multiplied before it is compared with a bound. A mesh class
// overloads it where sizes differ from place to place.
template <typename Mesh, typename Vertex>
double length_factor(const Mesh&, const Vertex&, const Vertex&) { return 1; }

// A mesh that is refined, with the maps of points and constrained edges that must follow its changes.
template <typename TriangleMesh, typename NamedParameters>
class Editable_mesh : public Mesh_reader<TriangleMesh, NamedParameters>
{
public:
  typedef Mesh_reader<TriangleMesh, NamedParameters> Reader;
  typedef typename Reader::Graph_traits Graph_traits;
  typedef typename Reader::vertex_descriptor vertex_descriptor;
  typedef typename Reader::halfedge_descriptor halfedge_descriptor;
  typedef typename Reader::Point_3 Point_3;

  using Reader::Reader;
  using Reader::coordinates;
  using Reader::point;

  // Returns an error that names the first face that is not a triangle, or success.
  Result check_triangles() const
  {
    std::size_t number = 0;
    for(const auto f : faces(m_mesh))
    {
      if(!CGAL::is_triangle(halfedge(f, m_mesh), m_mesh))
        return failure(ERROR_NON_TRIANGULAR_MESH, "face " + std::to_string(number) + " of faces(tm)");
      ++number;
    }
    return {};
  }

  // Reserves memory for new elements, so that no allocation fails while the mesh is changed. Does nothing for a mesh
  // class without `reserve()`.
  void reserve_for(const std::size_t vertices, const std::size_t edges, const std::size_t faces) const
  {
    reserve_in(m_mesh, vertices, edges, faces, 0);
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

  void set_point(const vertex_descriptor v, const Point_3& point) const { put(m_points, v, point); }

  // Where an edge is split: its midpoint, if that is none of the four vertices of its triangles. In a triangle without
  // area the opposite vertex may be there, and the edge to it would have length zero; then it is a point at a third.
  // Returns `false` if rounding leaves no point.
  bool find_splitting_point(const halfedge_descriptor h, Point_3& result, double& weight_of_source) const
  {
    const Point_3 p = point(source(h, m_mesh)), q = point(target(h, m_mesh));
    result = m_traits.construct_midpoint_3_object()(p, q);
    weight_of_source = 1. / 2;
    if(is_away_from_triangles(h, result))
      return true;
    for(const int parts : { 1, 2 })
    {
      result = m_traits.construct_barycenter_3_object()(p, parts, q, 3 - parts);
      weight_of_source = parts / 3.;
      if(is_away_from_triangles(h, result))
        return true;
    }
    return false;
  }

  // Splits an edge at a point. The new vertex is the target of the halfedge that is returned, and the source of `h`.
  halfedge_descriptor split_edge_at(const halfedge_descriptor h, const Point_3& new_point,
                                    const double weight_of_source) const
  {
    const halfedge_descriptor to_point = CGAL::Euler::split_edge(h, m_mesh);
    set_point(target(to_point, m_mesh), new_point);
    note_vertex(m_mesh, target(to_point, m_mesh),
                std::array<vertex_descriptor, 3>{ source(to_point, m_mesh), target(h, m_mesh),
                                                  Graph_traits::null_vertex() },
                std::array<double, 3>{ weight_of_source, 1 - weight_of_source, 0 });
    return to_point;
  }

  // Splits an edge, and each of its triangles in two. The new vertex is the target of the halfedge that is returned,
  // and the source of `h`; the edges across the triangles come next to this halfedge and to the opposite of `h`.
  // Returns the null halfedge and changes nothing if rounding leaves no point to split at.
  halfedge_descriptor split_edge_with_faces(const halfedge_descriptor h) const
  {
    Point_3 splitting_point;
    double weight_of_source;
    if(!find_splitting_point(h, splitting_point, weight_of_source))
      return Graph_traits::null_halfedge();
    const halfedge_descriptor to_point = split_edge_at(h, splitting_point, weight_of_source);
    copy_constraint(h, to_point);
    note_edge(m_mesh, edge(to_point, m_mesh), edge(h, m_mesh));
    for(const halfedge_descriptor half : { to_point, opposite(h, m_mesh) })
      if(!CGAL::is_border(half, m_mesh))
        split_face(half);
    return to_point;
  }

private:
  // Whether a point has other coordinates than the vertices of the triangles beside an edge.
  bool is_away_from_triangles(const halfedge_descriptor h, const Point_3& other) const
  {
    const Coordinates here = coordinates_of(other, m_traits);
    for(const halfedge_descriptor side : { h, opposite(h, m_mesh) })
      if(coordinates(target(side, m_mesh)) == here
         || (!CGAL::is_border(side, m_mesh) && coordinates(target(next(side, m_mesh), m_mesh)) == here))
        return false;
    return true;
  }

  // Splits a face with four vertices by an edge from the target of `to_point` to the opposite vertex.
  void split_face(const halfedge_descriptor to_point) const
  {
    const auto whole = face(to_point, m_mesh);
    const halfedge_descriptor h = CGAL::Euler::split_face(to_point, next(next(to_point, m_mesh), m_mesh), m_mesh);
    mark_unconstrained(h);
    note_face(m_mesh, face(h, m_mesh), whole);
    note_face(m_mesh, face(opposite(h, m_mesh), m_mesh), whole);
  }

  template <typename Mesh>
  static auto reserve_in(Mesh& mesh, const std::size_t vertices, const std::size_t edges, const std::size_t faces, int)
    -> decltype(reserve(mesh, num_vertices(mesh) + vertices, num_edges(mesh) + edges, num_faces(mesh) + faces))
  {
    return reserve(mesh, num_vertices(mesh) + vertices, num_edges(mesh) + edges, num_faces(mesh) + faces);
  }
  template <typename Mesh>
  static void reserve_in(Mesh&, std::size_t, std::size_t, std::size_t, long) {}

  typedef typename Reader::Constraint_map Constraint_map;
  static constexpr bool is_constraint_map_writable =
    std::is_convertible<typename boost::property_traits<Constraint_map>::category,
                        boost::writable_property_map_tag>::value;

  using Reader::m_edge_is_constrained;
  using Reader::m_mesh;
  using Reader::m_points;
  using Reader::m_traits;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_EDITABLE_MESH_H
