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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_CORNER_NORMALS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_CORNER_NORMALS_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The unit normals that the surface has at the corners of quads, on their side of the arcs.
class Corner_normals
{
public:
  Corner_normals(const Quad_complex& complex, const Cut_surface& surface, const Surface_embedding& embedding,
                 const Feature_network& network, const Surface_walker& walker)
    : m_complex(complex), m_embedding(embedding), m_network(network), m_walker(walker)
    , m_patch_of_face(surface.number_of_faces()), m_normal(4 * complex.quads.size(), Coordinates{ 0, 0, 0 })
  {
    for(std::size_t patch = 0; patch < surface.patches.size(); ++patch)
      for(int f = surface.patches[patch].faces.begin_index; f < surface.patches[patch].faces.end_index; ++f)
        m_patch_of_face[f] = static_cast<int>(patch);
    for(std::size_t c = 0; c < m_normal.size(); ++c)
      if(vertex_at(c).vertex < 0)
        m_normal[c] = normal_after(vertex_at(c).location, static_cast<int>(c));
    add_faces_at_mesh_vertices();
  }

  const Coordinates& normal(const int corner) const { return m_normal[corner]; }
  void set_normal(const int corner, const Coordinates& normal) { m_normal[corner] = normal; }

  // The sum of the normals at the four corners of a quad.
  Coordinates sum(const int quad) const
  {
    const Coordinates* const n = &m_normal[4 * static_cast<std::size_t>(quad)];
    return n[0] + n[1] + (n[2] + n[3]);
  }

  // The normal at a corner that slides to a location. On an arc it is that of the face on the side of the quad.
  Coordinates normal_after(const Surface_location& location, const int corner) const
  {
    const Quad_vertex& v = vertex_at(corner);
    if(v.vertex >= 0)
      return m_normal[corner]; // it does not slide
    if(v.arc < 0)
      return m_walker.normal(location.face);
    const int patch = m_complex.patch[corner / 4];
    Coordinates sum{ 0, 0, 0 };
    for(int h = 3 * location.face; h < 3 * location.face + 3; ++h)
      if(location.barycentric[(h + 1) % 3] == 0 && m_network.arc[h] == v.arc)
      {
        if(m_patch_of_face[location.face] == patch)
          sum = sum + m_walker.normal(location.face);
        if(m_embedding.twin[h] >= 0 && m_patch_of_face[face_of(m_embedding.twin[h])] == patch)
          sum = sum + m_walker.normal(face_of(m_embedding.twin[h]));
        return sum;
      }
    return sum;
  }

private:
  const Quad_vertex& vertex_at(const std::size_t corner) const
  {
    return m_complex.vertices[m_complex.quads[corner / 4][corner % 4]];
  }

  // A corner at a vertex of the surface gets the normalized sum over the faces at this vertex in the patch of its quad.
  void add_faces_at_mesh_vertices()
  {
    std::vector<std::vector<int> > corners_at(m_embedding.point.size());
    for(std::size_t c = 0; c < m_normal.size(); ++c)
      if(vertex_at(c).vertex >= 0)
        corners_at[vertex_at(c).vertex].push_back(static_cast<int>(c));
    for(std::size_t h = 0; h < m_embedding.vertex.size(); ++h)
    {
      const int face = face_of(static_cast<int>(h));
      for(const int c : corners_at[m_embedding.vertex[h]])
        if(m_complex.patch[c / 4] == m_patch_of_face[face])
          m_normal[c] = m_normal[c] + m_walker.normal(face);
    }
    for(const std::vector<int>& corners : corners_at)
      for(const int c : corners)
        if(length(m_normal[c]) > 0)
          m_normal[c] = 1 / length(m_normal[c]) * m_normal[c];
  }

  const Quad_complex& m_complex;
  const Surface_embedding& m_embedding;
  const Feature_network& m_network;
  const Surface_walker& m_walker;
  std::vector<int> m_patch_of_face;
  std::vector<Coordinates> m_normal; // per corner
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_CORNER_NORMALS_H
