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

#include <CGAL/Frame_fields/internal/surface/Refinement_origin.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_facade.hpp>

#include <array>
#include <cstddef>
#include <iostream>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The number of an element of a mesh, one type per kind of element.
template <typename Kind>
struct Element_index
{
  int value = -1;

  Element_index() = default;
  explicit Element_index(const int v) : value(v) {}

  friend bool operator==(const Element_index a, const Element_index b) { return a.value == b.value; }
  friend bool operator!=(const Element_index a, const Element_index b) { return a.value != b.value; }
  friend bool operator<(const Element_index a, const Element_index b) { return a.value < b.value; }
  friend std::size_t hash_value(const Element_index i) { return boost::hash<int>()(i.value); }
  friend std::ostream& operator<<(std::ostream& out, const Element_index i) { return out << i.value; }
};

// Runs over the elements 0, 1, 2, ...
template <typename Index>
class Element_iterator
  : public boost::iterator_facade<Element_iterator<Index>, Index, boost::random_access_traversal_tag, Index>
{
public:
  Element_iterator() = default;
  explicit Element_iterator(const int value) : m_value(value) {}

private:
  friend class boost::iterator_core_access;

  Index dereference() const { return Index(m_value); }
  bool equal(const Element_iterator& other) const { return m_value == other.m_value; }
  void increment() { ++m_value; }
  void decrement() { --m_value; }
  void advance(const std::ptrdiff_t n) { m_value += static_cast<int>(n); }
  std::ptrdiff_t distance_to(const Element_iterator& other) const { return other.m_value - m_value; }

  int m_value = 0;
};

// A mesh of the package's own, a model of `MutableFaceGraph` whose elements are only added, to be refined in place of
// the caller's. The halfedges of edge e are 2e and 2e + 1.
class Working_mesh
{
public:
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef Kernel::Point_3 Point;
  typedef Element_index<struct Vertex_kind> Vertex;
  typedef Element_index<struct Halfedge_kind> Halfedge;
  typedef Element_index<struct Edge_kind> Edge;
  typedef Element_index<struct Face_kind> Face;

  int number_of_vertices() const { return static_cast<int>(m_vertex_halfedge.size()); }
  int number_of_halfedges() const { return static_cast<int>(m_next.size()); }
  int number_of_faces() const { return static_cast<int>(m_face_halfedge.size()); }

  // Sets the size at once; all connections are unset.
  void resize(const int vertices, const int edges, const int faces)
  {
    m_vertex_halfedge.resize(vertices);
    m_point.resize(vertices);
    m_next.resize(2 * static_cast<std::size_t>(edges));
    m_previous.resize(m_next.size());
    m_target.resize(m_next.size());
    m_face.resize(m_next.size());
    m_is_constrained.resize(edges);
    m_face_halfedge.resize(faces);
  }

  void reserve(const std::size_t vertices, const std::size_t edges, const std::size_t faces)
  {
    m_vertex_halfedge.reserve(vertices);
    m_point.reserve(vertices);
    m_next.reserve(2 * edges);
    m_previous.reserve(2 * edges);
    m_target.reserve(2 * edges);
    m_face.reserve(2 * edges);
    m_is_constrained.reserve(edges);
    m_face_halfedge.reserve(faces);
  }

  Halfedge& halfedge_of(const Vertex v) { return m_vertex_halfedge[v.value]; }
  Halfedge halfedge_of(const Vertex v) const { return m_vertex_halfedge[v.value]; }
  Halfedge& halfedge_of(const Face f) { return m_face_halfedge[f.value]; }
  Halfedge halfedge_of(const Face f) const { return m_face_halfedge[f.value]; }
  Halfedge next(const Halfedge h) const { return m_next[h.value]; }
  Halfedge previous(const Halfedge h) const { return m_previous[h.value]; }
  Vertex& target(const Halfedge h) { return m_target[h.value]; }
  Vertex target(const Halfedge h) const { return m_target[h.value]; }
  Face& face(const Halfedge h) { return m_face[h.value]; }
  Face face(const Halfedge h) const { return m_face[h.value]; }

  void connect(const Halfedge h, const Halfedge next)
  {
    m_next[h.value] = next;
    m_previous[next.value] = h;
  }

  Refinement_origin& origin() { return m_origin; }
  const Refinement_origin& origin() const { return m_origin; }
  std::vector<Point>& points() { return m_point; }
  const std::vector<Point>& points() const { return m_point; }
  std::vector<double>& density() { return m_density; }
  const std::vector<double>& density() const { return m_density; }
  std::vector<char>& constrained_edges() { return m_is_constrained; }
  const std::vector<char>& constrained_edges() const { return m_is_constrained; }

private:
  std::vector<Halfedge> m_vertex_halfedge, m_next, m_previous, m_face_halfedge;
  std::vector<Vertex> m_target;
  std::vector<Face> m_face;
  std::vector<Point> m_point;
  std::vector<double> m_density;      // per vertex: by what lengths there count as longer than they are; empty if by 1
  std::vector<char> m_is_constrained; // per edge
  Refinement_origin m_origin;
};

// The functions of the concept.

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

// What `Editable_mesh` tells of its changes.
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

// Values by the number of their element, in an array that the map refers to or shares. What was never put is `Value()`.
template <typename Index, typename Value, typename Stored = Value>
class Element_map
{
public:
  typedef Index key_type;
  typedef Value value_type;
  typedef Value reference;
  typedef boost::read_write_property_map_tag category;

  Element_map() : m_values(std::make_shared<std::vector<Stored> >()) {}

  // Refers to an array that must outlive the map.
  explicit Element_map(std::vector<Stored>& values) : m_values(&values, [](std::vector<Stored>*) {}) {}

  friend Value get(const Element_map& map, const Index i)
  {
    const std::size_t place = static_cast<std::size_t>(i.value);
    return place < map.m_values->size() ? static_cast<Value>((*map.m_values)[place]) : Value();
  }

  friend void put(const Element_map& map, const Index i, const Value& value)
  {
    const std::size_t place = static_cast<std::size_t>(i.value);
    if(place >= map.m_values->size())
      map.m_values->resize(place + 1);
    (*map.m_values)[place] = static_cast<Stored>(value);
  }

private:
  std::shared_ptr<std::vector<Stored> > m_values;
};

typedef Element_map<Working_mesh::Vertex, Working_mesh::Point> Working_point_map;
typedef Element_map<Working_mesh::Edge, bool, char> Working_constraint_map;

// A map that is read only may refer to a mesh that is const.
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
