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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_CARRY_GUIDANCE_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_CARRY_GUIDANCE_H

#include <CGAL/Frame_fields/No_index_target.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Working_mesh.h>

#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Carries guiding directions and index targets from a cut mesh to a refined copy of it. The vertices of the given mesh
// must have the same numbers in its embedding and in the copy.
template <typename TriangleMesh>
class Guidance_carrier
{
public:
  Guidance_carrier(const Cut_mesh<TriangleMesh>& given, const Surface_embedding& given_embedding,
                   Cut_mesh<Working_mesh>& copy)
    : m_given(given), m_given_embedding(given_embedding), m_copy(copy)
  {}

  void run()
  {
    const Cut_surface& given = m_given.surface();
    Cut_surface& surface = m_copy.surface();
    if(!given.guide_weight.empty())
    {
      surface.guide_angle.assign(surface.number_of_faces(), 0);
      surface.guide_weight.assign(surface.number_of_faces(), 0);
      for(int f = 0; f < surface.number_of_faces(); ++f)
        if(!surface.is_aligned(f))
          guide(f);
    }
    if(given.index_target.empty())
      return;
    surface.index_target.assign(surface.number_of_sectors(), NO_INDEX_TARGET);
    for(int h = 0; h < surface.number_of_halfedges(); ++h)
      for(int corner = 3 * origin(face_of(h)); corner < 3 * origin(face_of(h)) + 3; ++corner)
        if(m_given_embedding.vertex[corner] == vertex(h))
          surface.index_target[surface.sector[h]] = given.index_target[given.sector[corner]];
  }

private:
  int origin(const int face) const
  {
    return m_copy.mesh().origin().face(m_copy.face_descriptors()[face].value);
  }

  int vertex(const int halfedge) const { return target(m_copy.halfedge_of(halfedge), m_copy.mesh()).value; }

  // Guides or aligns a face of the copy as the face that it comes from. That face is aligned without a constrained edge
  // if its guiding weight was infinite.
  void guide(const int face)
  {
    const Cut_surface& given = m_given.surface();
    Cut_surface& surface = m_copy.surface();
    const int o = origin(face);
    bool has_constrained_edge = false, is_whole = true;
    for(int k = 0; k < 3; ++k)
    {
      has_constrained_edge = has_constrained_edge || given.is_constrained(3 * o + k);
      is_whole = is_whole && m_given_embedding.vertex[3 * o + k] == vertex(3 * face + k);
    }
    const bool is_aligned = given.is_aligned(o) && !has_constrained_edge;
    if(!is_aligned && !(given.guide_weight[o] > 0))
      return;
    double angle = is_aligned ? given.alignment[o] : given.guide_angle[o];
    if(!is_whole)
      angle = m_copy.angle_in_face(face, m_given.vector_in_face(o, angle));
    if(!std::isfinite(angle))
      return;
    if(is_aligned)
      surface.alignment[face] = angle;
    else
    {
      surface.guide_angle[face] = angle;
      surface.guide_weight[face] = given.guide_weight[o];
    }
  }

  const Cut_mesh<TriangleMesh>& m_given;
  const Surface_embedding& m_given_embedding;
  Cut_mesh<Working_mesh>& m_copy;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_CARRY_GUIDANCE_H
