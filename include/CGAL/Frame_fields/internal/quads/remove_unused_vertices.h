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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_REMOVE_UNUSED_VERTICES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_REMOVE_UNUSED_VERTICES_H

#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Removes the vertices of no quad, in linear time, and keeps the order of the others. Returns the old numbers of the
// others. Vertices of arcs must be vertices of quads.
inline std::vector<int> remove_unused_vertices(Quad_complex& complex)
{
  std::vector<int> number(complex.vertices.size(), 0), old_number;
  for(const std::array<int, 4>& quad : complex.quads)
    for(const int v : quad)
      number[v] = 1;
  int number_of_vertices = 0;
  for(std::size_t v = 0; v < number.size(); ++v)
    if(number[v] != 0)
    {
      complex.vertices[number_of_vertices] = complex.vertices[v];
      number[v] = number_of_vertices++;
      old_number.push_back(static_cast<int>(v));
    }
  complex.vertices.resize(number_of_vertices);
  renumber_vertices(number, complex);
  return old_number;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_REMOVE_UNUSED_VERTICES_H
