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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_METRIC_OF_SIZES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_METRIC_OF_SIZES_H

#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The angles of a triangle at the ends of its sides, from the lengths of these; false if there is no such triangle.
inline bool angles_of_sides(const std::array<double, 3>& length, std::array<double, 3>& angle)
{
  for(int k = 0; k < 3; ++k)
  {
    const double a = length[k], b = length[(k + 1) % 3], c = length[(k + 2) % 3];
    const double cosine = (a * a + b * b - c * c) / (2 * a * b);
    if(!(std::abs(cosine) < 1))
      return false;
    angle[k] = std::acos(cosine);
  }
  return true;
}

// The same surface in the metric in which all wanted lengths of edges are the same: lengths are multiplied by the
// density. Where the density changes, that metric is curved, so that a field which is smooth in it turns and gets
// singularities where rows of quads must end or begin. Triangles that would not close keep their angles.
inline Cut_surface surface_in_metric_of_sizes(const Cut_surface& surface, const Surface_embedding& embedding,
                                              const std::vector<double>& density)
{
  Cut_surface result = surface;
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    result.length[h] *= (density_at(embedding, density, h) + density_at(embedding, density, previous_of(h))) / 2;
  for(int h = 0; h < surface.number_of_halfedges(); h += 3)
    if(std::array<double, 3> angle; angles_of_sides({ result.length[h], result.length[h + 1], result.length[h + 2] },
                                                    angle))
      std::copy(angle.begin(), angle.end(), result.angle.begin() + h);

  result.angle_in_space = surface.total_angle;
  std::fill(result.total_angle.begin(), result.total_angle.end(), 0);
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    result.total_angle[result.sector[h]] += result.angle[h];
  // Transports must stay on the same side of their jump by 2 pi, for the matching of the field counts it.
  for(std::size_t e = 0; e < surface.dual_edges.size(); ++e)
    for(const bool is_first : { true, false })
    {
      const int h = is_first ? surface.dual_edges[e].halfedge : surface.dual_edges[e].opposite;
      const double change = halfedge_angle(result, h) - halfedge_angle(surface, h);
      result.transport[e] += is_first ? change : -change;
    }
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    if(surface.is_constrained(h))
      result.alignment[face_of(h)] = halfedge_angle(result, h);
  return result;
}

// Carries the angles of a field from one metric to the other: in aligned faces exactly, as the alignment changes; in
// others they keep their difference from the first side.
inline void carry_angles(const Cut_surface& from, const Cut_surface& to, std::vector<double>& alpha)
{
  for(int f = 0; f < to.number_of_faces(); ++f)
    if(to.is_aligned(f))
      alpha[f] += to.alignment[f] - from.alignment[f];
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_METRIC_OF_SIZES_H
