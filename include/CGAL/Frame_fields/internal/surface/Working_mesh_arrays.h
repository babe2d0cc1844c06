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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WORKING_MESH_ARRAYS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WORKING_MESH_ARRAYS_H

#include <CGAL/Frame_fields/internal/surface/Mesh_elements.h>
#include <CGAL/Frame_fields/internal/surface/Refinement_origin.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A mesh of the package's own in arrays, which is refined in place of the caller's. Elements are only added. The
// halfedges of edge e are 2e and 2e + 1. `Working_mesh.h` makes it a model of `MutableFaceGraph`, but for removal.
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

  // Sets the numbers of elements, which must not decrease. New elements have no connections, and new edges are not
  // constrained.
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

  // Reserves memory for these numbers of elements in all, but not for their origins and densities.
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
  std::vector<double> m_density;      // per vertex: the factor by which lengths count; empty if it is 1
  std::vector<char> m_is_constrained; // per edge
  Refinement_origin m_origin;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_WORKING_MESH_ARRAYS_H
