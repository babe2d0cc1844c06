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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_ENERGIES_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_ENERGIES_H

#include <CGAL/Frame_fields/internal/field/branch_pairs.h>
#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// sum w (r - omega)^2 over some dual edges of an orthogonal field.
inline double orthogonal_energy(const Cut_surface& surface, const Index_range& dual_edges,
                                const std::vector<double>& omega, const std::vector<double>& alpha,
                                const std::vector<int>& matching)
{
  double energy = 0;
  for(int e = dual_edges.begin_index; e < dual_edges.end_index; ++e)
  {
    const double difference = rotation(surface, alpha, matching, e) - omega[e];
    energy += surface.weight[e] * difference * difference;
  }
  return energy;
}

// sum w (r0^2 + r1^2) over all dual edges; `alpha` is the field before relaxation, which `gamma` relaxes.
inline double relaxed_energy(const Cut_surface& surface, const std::vector<double>& alpha,
                             const std::vector<int>& matching, const std::vector<Branch_rotations>& gamma)
{
  double energy = 0;
  for(int e = 0; e < surface.number_of_dual_edges(); ++e)
  {
    const double r = rotation(surface, alpha, matching, e);
    const Branch_rotations& gamma_i = gamma[face_of(surface.dual_edges[e].halfedge)];
    const Branch_rotations& gamma_j = gamma[face_of(surface.dual_edges[e].opposite)];
    for(int b = 0; b < 2; ++b)
    {
      const double r_b = r - gamma_i[b] + gamma_j[matched_branch(b, matching[e])];
      energy += surface.weight[e] * r_b * r_b;
    }
  }
  return energy;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_ENERGIES_H
