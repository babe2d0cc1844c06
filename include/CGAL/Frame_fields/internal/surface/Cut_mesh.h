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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_MESH_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_MESH_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/face_basis.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// How messages name a face.
inline std::string face_text(const int number, const Coordinates& vertex)
{
  return "face " + std::to_string(number) + " of faces(tm), which has a vertex at " + to_text(vertex);
}

// A mesh cut along its constrained edges, as `Mesh_cutter` makes it: the surface that the stages see, and the elements
// of the mesh that correspond to its own. The mesh must outlive it.
template <typename TriangleMesh>
class Cut_mesh
{
public:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef std::function<Coordinates(vertex_descriptor)> Points;

  Cut_mesh() = default;

  // `face_numbers` are the places of the faces in faces(tm).
  Cut_mesh(const TriangleMesh& tm, const Points& points, std::vector<face_descriptor>&& faces,
           std::vector<int>&& face_numbers, Cut_surface&& surface)
    : m_mesh(&tm), m_points(points), m_faces(std::move(faces)), m_face_numbers(std::move(face_numbers))
    , m_surface(std::move(surface))
  {}

  const TriangleMesh& mesh() const { return *m_mesh; }
  const Cut_surface& surface() const { return m_surface; }
  Cut_surface& surface() { return m_surface; }
  const std::vector<face_descriptor>& face_descriptors() const { return m_faces; }
  Coordinates coordinates(const vertex_descriptor v) const { return m_points(v); }

  // The halfedge of the mesh that has a flat index.
  halfedge_descriptor halfedge_of(const int index) const
  {
    halfedge_descriptor h = halfedge(m_faces[face_of(index)], mesh());
    for(int k = index % 3; k > 0; --k)
      h = next(h, mesh());
    return h;
  }

  // Calls `visit(h, i)` for each halfedge of a face with its flat index, and `visit(h, -1)` for each border halfedge.
  template <typename Visit>
  void for_each_halfedge(const Visit& visit) const
  {
    for(std::size_t f = 0; f < m_faces.size(); ++f)
    {
      halfedge_descriptor h = halfedge(m_faces[f], mesh());
      for(int k = 0; k < 3; ++k, h = next(h, mesh()))
      {
        visit(h, static_cast<int>(3 * f) + k);
        if(m_surface.is_constrained(static_cast<int>(3 * f) + k) && is_border(opposite(h, mesh()), mesh()))
          visit(opposite(h, mesh()), -1);
      }
    }
  }

  std::string description_of_face(const int face) const
  {
    return face_text(m_face_numbers[face], coordinates(target(halfedge(m_faces[face], mesh()), mesh())));
  }

  std::string description_of_sector(const int sector) const
  {
    const int corner = m_surface.first_corner[sector];
    return "the vertex at " + to_text(coordinates(target(halfedge_of(corner), mesh()))) + " in "
         + description_of_face(face_of(corner));
  }

  // The angle in radians, from -pi to pi, from the first halfedge of a face to the projection of a vector to its plane;
  // NaN if the projection is zero or not finite.
  double angle_in_face(const int face, const Coordinates& vector) const
  {
    const halfedge_descriptor h = halfedge(m_faces[face], mesh());
    const Face_basis basis = face_basis(coordinates(source(h, mesh())), coordinates(target(h, mesh())),
                                        coordinates(target(next(h, mesh()), mesh())));
    const double x = dot(vector, basis[0]), y = dot(vector, basis[1]);
    const bool has_direction = std::isfinite(x) && std::isfinite(y) && (x != 0 || y != 0);
    return has_direction ? std::atan2(y, x) : std::numeric_limits<double>::quiet_NaN();
  }

  // The unit vector in the plane of a face at an angle, in radians, from its first halfedge.
  Coordinates vector_in_face(const int face, const double angle) const
  {
    const halfedge_descriptor h = halfedge(m_faces[face], mesh());
    const Face_basis basis = face_basis(coordinates(source(h, mesh())), coordinates(target(h, mesh())),
                                        coordinates(target(next(h, mesh()), mesh())));
    Coordinates result;
    for(int k = 0; k < 3; ++k)
      result[k] = std::cos(angle) * basis[0][k] + std::sin(angle) * basis[1][k];
    return result;
  }

private:
  const TriangleMesh* m_mesh = nullptr;
  Points m_points;
  std::vector<face_descriptor> m_faces;
  std::vector<int> m_face_numbers;
  Cut_surface m_surface;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_MESH_H
