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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WORKING_MESH_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WORKING_MESH_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_elements.h>
#include <CGAL/Frame_fields/internal/surface/Working_mesh_arrays.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// What makes `Working_mesh` a model of `MutableFaceGraph`, but for the functions that remove elements: the functions of
// the concept, property maps and traits.

inline Working_mesh::Vertex target(const Working_mesh::Halfedge h, const Working_mesh& m) { return m.target(h); }
inline Working_mesh::Halfedge opposite(const Working_mesh::Halfedge h, const Working_mesh&)
{
  return Working_mesh::Halfedge(h.value ^ 1);
}
inline Working_mesh::Vertex source(const Working_mesh::Halfedge h, const Working_mesh& m)
{
  return m.target(opposite(h, m));
}
inline Working_mesh::Halfedge next(const Working_mesh::Halfedge h, const Working_mesh& m) { return m.next(h); }
inline Working_mesh::Halfedge prev(const Working_mesh::Halfedge h, const Working_mesh& m) { return m.previous(h); }
inline Working_mesh::Face face(const Working_mesh::Halfedge h, const Working_mesh& m) { return m.face(h); }
inline Working_mesh::Edge edge(const Working_mesh::Halfedge h, const Working_mesh&)
{
  return Working_mesh::Edge(h.value / 2);
}
inline Working_mesh::Halfedge halfedge(const Working_mesh::Edge e, const Working_mesh&)
{
  return Working_mesh::Halfedge(2 * e.value);
}
inline Working_mesh::Halfedge halfedge(const Working_mesh::Vertex v, const Working_mesh& m) { return m.halfedge_of(v); }
inline Working_mesh::Halfedge halfedge(const Working_mesh::Face f, const Working_mesh& m) { return m.halfedge_of(f); }
inline Working_mesh::Vertex source(const Working_mesh::Edge e, const Working_mesh& m)
{
  return source(halfedge(e, m), m);
}
inline Working_mesh::Vertex target(const Working_mesh::Edge e, const Working_mesh& m)
{
  return target(halfedge(e, m), m);
}

inline std::size_t num_vertices(const Working_mesh& m) { return m.number_of_vertices(); }
inline std::size_t num_halfedges(const Working_mesh& m) { return m.number_of_halfedges(); }
inline std::size_t num_edges(const Working_mesh& m) { return m.number_of_halfedges() / 2; }
inline std::size_t num_faces(const Working_mesh& m) { return m.number_of_faces(); }

template <typename Index>
CGAL::Iterator_range<Element_iterator<Index> > first_elements(const int number)
{
  return { Element_iterator<Index>(0), Element_iterator<Index>(number) };
}
inline auto vertices(const Working_mesh& m) { return first_elements<Working_mesh::Vertex>(m.number_of_vertices()); }
inline auto halfedges(const Working_mesh& m) { return first_elements<Working_mesh::Halfedge>(m.number_of_halfedges()); }
inline auto edges(const Working_mesh& m) { return first_elements<Working_mesh::Edge>(m.number_of_halfedges() / 2); }
inline auto faces(const Working_mesh& m) { return first_elements<Working_mesh::Face>(m.number_of_faces()); }

// The halfedge from u to v, if there is one. The cost is the degree of v, as that of degree() below.
inline std::pair<Working_mesh::Halfedge, bool> halfedge(const Working_mesh::Vertex u, const Working_mesh::Vertex v,
                                                        const Working_mesh& m)
{
  const Working_mesh::Halfedge first = m.halfedge_of(v);
  Working_mesh::Halfedge h = first;
  if(h.value >= 0)
    do
    {
      if(source(h, m) == u)
        return { h, true };
      h = opposite(next(h, m), m);
    } while(h != first);
  return { Working_mesh::Halfedge(), false };
}

inline int degree(const Working_mesh::Vertex v, const Working_mesh& m)
{
  int number = 0;
  Working_mesh::Halfedge h = m.halfedge_of(v);
  if(h.value >= 0)
    do
    {
      ++number;
      h = opposite(next(h, m), m);
    } while(h != m.halfedge_of(v));
  return number;
}

inline Working_mesh::Vertex add_vertex(Working_mesh& m)
{
  m.resize(m.number_of_vertices() + 1, m.number_of_halfedges() / 2, m.number_of_faces());
  return Working_mesh::Vertex(m.number_of_vertices() - 1);
}
inline Working_mesh::Edge add_edge(Working_mesh& m)
{
  m.resize(m.number_of_vertices(), m.number_of_halfedges() / 2 + 1, m.number_of_faces());
  return Working_mesh::Edge(m.number_of_halfedges() / 2 - 1);
}
inline Working_mesh::Face add_face(Working_mesh& m)
{
  m.resize(m.number_of_vertices(), m.number_of_halfedges() / 2, m.number_of_faces() + 1);
  return Working_mesh::Face(m.number_of_faces() - 1);
}
inline void set_next(const Working_mesh::Halfedge h, const Working_mesh::Halfedge n, Working_mesh& m)
{
  m.connect(h, n);
}
inline void set_target(const Working_mesh::Halfedge h, const Working_mesh::Vertex v, Working_mesh& m)
{
  m.target(h) = v;
}
inline void set_face(const Working_mesh::Halfedge h, const Working_mesh::Face f, Working_mesh& m) { m.face(h) = f; }
inline void set_halfedge(const Working_mesh::Vertex v, const Working_mesh::Halfedge h, Working_mesh& m)
{
  m.halfedge_of(v) = h;
}
inline void set_halfedge(const Working_mesh::Face f, const Working_mesh::Halfedge h, Working_mesh& m)
{
  m.halfedge_of(f) = h;
}
inline void reserve(Working_mesh& m, const std::size_t vertices, const std::size_t edges, const std::size_t faces)
{
  m.reserve(vertices, edges, faces);
}

// The overloads of what `Editable_mesh.h` declares: they keep the origins and the densities up to date.
inline void note_vertex(Working_mesh& m, const Working_mesh::Vertex v, const std::array<Working_mesh::Vertex, 3>& ends,
                        const std::array<double, 3>& weights)
{
  m.origin().add_vertex(v.value, { ends[0].value, ends[1].value, ends[2].value }, weights);
  if(m.density().empty())
    return;
  double density = 0;
  for(int i = 0; i < 3; ++i)
    if(ends[i].value >= 0)
      density += weights[i] * m.density()[ends[i].value];
  m.density().resize(m.number_of_vertices());
  m.density()[v.value] = density;
}
inline void note_edge(Working_mesh& m, const Working_mesh::Edge e, const Working_mesh::Edge other)
{
  m.origin().add_edge(e.value, other.value);
}
inline void note_face(Working_mesh& m, const Working_mesh::Face f, const Working_mesh::Face other)
{
  m.origin().add_face(f.value, other.value);
}
inline void note_flip(Working_mesh& m, const Working_mesh::Halfedge h)
{
  const auto point = [&](const Working_mesh::Halfedge g)
  {
    const Working_mesh::Point& p = m.points()[m.target(g).value];
    return Coordinates{ p.x(), p.y(), p.z() };
  };
  const Working_mesh::Halfedge o = opposite(h, m);
  const Coordinates p = point(h), q = point(o), r = point(next(h, m)), s = point(next(o, m));
  m.origin().flip(m.face(h).value, m.face(o).value, (r + s) / 2, (p + q + r) / 3, (p + q + s) / 3);
}
inline double length_factor(const Working_mesh& m, const Working_mesh::Vertex u, const Working_mesh::Vertex v)
{
  return m.density().empty() ? 1 : (m.density()[u.value] + m.density()[v.value]) / 2;
}

typedef Element_map<Working_mesh::Vertex, Working_mesh::Point> Working_point_map;
typedef Element_map<Working_mesh::Edge, bool, char> Working_constraint_map;

// `Element_map` refers to an array that is not const, so this casts; the map of a constant mesh must only be read.
inline Working_point_map get(boost::vertex_point_t, const Working_mesh& m)
{
  return Working_point_map(const_cast<Working_mesh&>(m).points());
}
inline Working_constraint_map constraint_map(Working_mesh& m) { return Working_constraint_map(m.constrained_edges()); }

template <typename T>
Element_map<Working_mesh::Vertex, T> get(CGAL::dynamic_vertex_property_t<T>, const Working_mesh&) { return {}; }
template <typename T>
Element_map<Working_mesh::Halfedge, T> get(CGAL::dynamic_halfedge_property_t<T>, const Working_mesh&) { return {}; }
template <typename T>
Element_map<Working_mesh::Edge, T> get(CGAL::dynamic_edge_property_t<T>, const Working_mesh&) { return {}; }
template <typename T>
Element_map<Working_mesh::Face, T> get(CGAL::dynamic_face_property_t<T>, const Working_mesh&) { return {}; }

struct Working_mesh_traversal : virtual boost::bidirectional_graph_tag, virtual boost::vertex_list_graph_tag,
                                virtual boost::edge_list_graph_tag
{};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

namespace boost {

template <>
struct graph_traits<CGAL::Frame_fields::internal::Working_mesh>
{
  typedef CGAL::Frame_fields::internal::Working_mesh Mesh;
  typedef Mesh::Vertex vertex_descriptor;
  typedef Mesh::Halfedge halfedge_descriptor;
  typedef Mesh::Edge edge_descriptor;
  typedef Mesh::Face face_descriptor;
  typedef CGAL::Frame_fields::internal::Element_iterator<vertex_descriptor> vertex_iterator;
  typedef CGAL::Frame_fields::internal::Element_iterator<halfedge_descriptor> halfedge_iterator;
  typedef CGAL::Frame_fields::internal::Element_iterator<edge_descriptor> edge_iterator;
  typedef CGAL::Frame_fields::internal::Element_iterator<face_descriptor> face_iterator;
  typedef undirected_tag directed_category;
  typedef disallow_parallel_edge_tag edge_parallel_category;
  typedef CGAL::Frame_fields::internal::Working_mesh_traversal traversal_category;
  typedef std::size_t vertices_size_type;
  typedef std::size_t halfedges_size_type;
  typedef std::size_t edges_size_type;
  typedef std::size_t faces_size_type;
  typedef int degree_size_type;

  static vertex_descriptor null_vertex() { return vertex_descriptor(); }
  static halfedge_descriptor null_halfedge() { return halfedge_descriptor(); }
  static face_descriptor null_face() { return face_descriptor(); }
};

template <>
struct graph_traits<const CGAL::Frame_fields::internal::Working_mesh>
  : graph_traits<CGAL::Frame_fields::internal::Working_mesh>
{};

template <>
struct property_map<CGAL::Frame_fields::internal::Working_mesh, CGAL::vertex_point_t>
{
  typedef CGAL::Frame_fields::internal::Working_point_map type;
  typedef type const_type;
};

template <typename T>
struct property_map<CGAL::Frame_fields::internal::Working_mesh, CGAL::dynamic_vertex_property_t<T> >
{
  typedef CGAL::Frame_fields::internal::Element_map<CGAL::Frame_fields::internal::Working_mesh::Vertex, T> type;
  typedef type const_type;
};

template <typename T>
struct property_map<CGAL::Frame_fields::internal::Working_mesh, CGAL::dynamic_halfedge_property_t<T> >
{
  typedef CGAL::Frame_fields::internal::Element_map<CGAL::Frame_fields::internal::Working_mesh::Halfedge, T> type;
  typedef type const_type;
};

template <typename T>
struct property_map<CGAL::Frame_fields::internal::Working_mesh, CGAL::dynamic_edge_property_t<T> >
{
  typedef CGAL::Frame_fields::internal::Element_map<CGAL::Frame_fields::internal::Working_mesh::Edge, T> type;
  typedef type const_type;
};

template <typename T>
struct property_map<CGAL::Frame_fields::internal::Working_mesh, CGAL::dynamic_face_property_t<T> >
{
  typedef CGAL::Frame_fields::internal::Element_map<CGAL::Frame_fields::internal::Working_mesh::Face, T> type;
  typedef type const_type;
};

} // namespace boost

namespace CGAL {

template <>
struct graph_has_property<Frame_fields::internal::Working_mesh, boost::vertex_point_t> : CGAL::Tag_true
{};

} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WORKING_MESH_H
