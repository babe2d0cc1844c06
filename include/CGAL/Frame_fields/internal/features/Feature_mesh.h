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
#ifndef CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FEATURE_MESH_H
#define CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FEATURE_MESH_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/features/feature_graph.h>
#include <CGAL/Frame_fields/internal/features/flat_faces.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_reader.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <climits>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A mesh whose features are looked for. The mesh must outlive it.
template <typename TriangleMesh, typename NamedParameters>
class Feature_mesh : private Mesh_reader<const TriangleMesh, NamedParameters>
{
public:
  typedef Mesh_reader<const TriangleMesh, NamedParameters> Reader;
  typedef typename Reader::vertex_descriptor vertex_descriptor;
  typedef typename Reader::halfedge_descriptor halfedge_descriptor;
  typedef typename Reader::edge_descriptor edge_descriptor;
  typedef typename Reader::face_descriptor face_descriptor;

  Feature_mesh(const TriangleMesh& tm, const NamedParameters& np)
    : Reader(tm, np)
    , m_vertex_number(get(CGAL::dynamic_vertex_property_t<int>(), tm))
    , m_edge_number(get(CGAL::dynamic_edge_property_t<int>(), tm))
    , m_face_number(get(CGAL::dynamic_face_property_t<int>(), tm))
  {}

  // Reads vertices, edges and faces into empty arrays; the border edges become features. Returns an error that names
  // the first face that is not a triangle or the first vertex of a face that is not finite; isolated vertices may have
  // any coordinates. `int` must be able to count the ends of the edges. Must be called only once. Takes linear time.
  Result read(Feature_graph& graph, Feature_faces& feature_faces)
  {
    if(const Result result = read_vertices(graph); !result)
      return result;
    for(const edge_descriptor e : edges(m_mesh))
    {
      if(m_edges.size() >= maximum_number_of_elements)
        return failure(ERROR_MESH_TOO_LARGE, "more than " + std::to_string(m_edges.size()) + " edges");
      const halfedge_descriptor h = halfedge(e, m_mesh);
      put(m_edge_number, e, graph.number_of_edges());
      m_edges.push_back(e);
      graph.ends.push_back({ number_of(source(h, m_mesh)), number_of(target(h, m_mesh)) });
      graph.length.push_back(distance(graph.points[graph.ends.back()[0]], graph.points[graph.ends.back()[1]]));
      graph.is_border.push_back(is_border(h, m_mesh) || is_border(opposite(h, m_mesh), m_mesh));
    }
    graph.is_feature = graph.is_border;
    return read_faces(graph, feature_faces);
  }

  // The angle in degrees between the normals of the two faces at each edge; 0 at border edges and at faces without a
  // normal. `normal_face` gives for each face the face whose normal it takes, as `Flat_faces` finds it.
  std::vector<double> dihedral_angles(const Feature_graph& graph, const Feature_faces& feature_faces,
                                      const std::vector<int>& normal_face) const
  {
    const auto normal_at = [&](const halfedge_descriptor h) -> Coordinates
    {
      const int f = get(m_face_number, face(h, m_mesh));
      if(normal_face[f] == f)
        return normal(graph.points[number_of(source(h, m_mesh))], graph.points[number_of(target(h, m_mesh))],
                      graph.points[number_of(target(next(h, m_mesh), m_mesh))]);
      const std::array<int, 3>& v = feature_faces.vertices[normal_face[f]];
      return normal(graph.points[v[0]], graph.points[v[1]], graph.points[v[2]]);
    };

    std::vector<double> result;
    result.reserve(m_edges.size());
    for(std::size_t e = 0; e < m_edges.size(); ++e)
    {
      const halfedge_descriptor h = halfedge(m_edges[e], m_mesh);
      result.push_back(graph.is_border[e] ? 0 : angle_between(normal_at(h), normal_at(opposite(h, m_mesh)))
                                                  * 180 / CGAL_PI);
    }
    return result;
  }

  const std::vector<edge_descriptor>& edge_descriptors() const { return m_edges; }

private:
  using Reader::m_mesh;

  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int> >::const_type
    Vertex_number_map;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_edge_property_t<int> >::const_type Edge_number_map;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int> >::const_type Face_number_map;

  static constexpr std::size_t maximum_number_of_elements = INT_MAX / 2;

  int number_of(const vertex_descriptor v) const { return get(m_vertex_number, v); }
  int number_of(const edge_descriptor e) const { return get(m_edge_number, e); }

  Result read_vertices(Feature_graph& graph)
  {
    for(const vertex_descriptor v : vertices(m_mesh))
    {
      if(graph.points.size() >= maximum_number_of_elements)
        return failure(ERROR_MESH_TOO_LARGE, "more than " + std::to_string(graph.points.size()) + " vertices");
      put(m_vertex_number, v, graph.number_of_vertices());
      graph.points.push_back(this->coordinates(v));
    }
    return {};
  }

  Result read_faces(const Feature_graph& graph, Feature_faces& feature_faces) const
  {
    for(const face_descriptor f : faces(m_mesh))
    {
      const int number = feature_faces.size();
      halfedge_descriptor h = halfedge(f, m_mesh);
      if(!CGAL::is_triangle(h, m_mesh))
        return failure(ERROR_NON_TRIANGULAR_MESH, "face " + std::to_string(number) + " of faces(tm)");
      put(m_face_number, f, number);
      std::array<int, 3> face_vertices, face_edges;
      for(int k = 0; k < 3; ++k, h = next(h, m_mesh))
      {
        face_vertices[k] = number_of(source(h, m_mesh));
        face_edges[k] = number_of(edge(h, m_mesh));
        if(!is_finite(graph.points[face_vertices[k]]))
          return failure(ERROR_NON_FINITE_COORDINATE,
                         "vertex " + std::to_string(face_vertices[k]) + " of vertices(tm)");
      }
      feature_faces.vertices.push_back(face_vertices);
      feature_faces.edges.push_back(face_edges);
    }
    if(feature_faces.size() == 0)
      return failure(ERROR_EMPTY_MESH, "faces(tm) is an empty range");
    return {};
  }

  Vertex_number_map m_vertex_number;
  Edge_number_map m_edge_number;
  Face_number_map m_face_number;
  std::vector<edge_descriptor> m_edges;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FEATURE_MESH_H
