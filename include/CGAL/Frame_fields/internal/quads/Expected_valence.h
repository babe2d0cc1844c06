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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_EXPECTED_VALENCE_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_EXPECTED_VALENCE_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/parameterization/quarter_turns_of_sector.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// How many quads the indices of the field ask for around a vertex of the quads.
class Expected_valence
{
public:
  Expected_valence(const Cut_surface& surface, const Surface_embedding& embedding, const std::vector<int>& index)
    : m_surface(surface), m_embedding(embedding), m_index(index), m_of_vertex(embedding.point.size(), 0)
  {
    for(int s = 0; s < surface.number_of_sectors(); ++s)
      m_of_vertex[embedding.vertex[surface.first_corner[s]]] += quarter_turns_of_sector(surface, index, s);
  }

  // `singular_sector` is the closed sector that a vertex inside a patch is at, -1 if it is a regular one.
  int of(const Quad_vertex& vertex, const int singular_sector, const Feature_network& features) const
  {
    if(vertex.vertex >= 0)
      return m_of_vertex[vertex.vertex];
    if(vertex.arc >= 0)
      return m_embedding.twin[features.arcs[vertex.arc].halfedges.front()] < 0 ? 2 : 4;
    return singular_sector >= 0 ? quarter_turns_of_sector(m_surface, m_index, singular_sector) : 4;
  }

private:
  const Cut_surface& m_surface;
  const Surface_embedding& m_embedding;
  const std::vector<int>& m_index;
  std::vector<int> m_of_vertex;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_EXPECTED_VALENCE_H
