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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMBED_FIELD_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMBED_FIELD_H

#include <CGAL/Frame_fields/internal/parameterization/Combing.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The field of a patch in the charts of its combing.
class Combed_field
{
public:
  Combed_field(const Cut_surface& surface, const Patch& patch, const std::vector<double>& alpha,
               const std::vector<double>& rho, const Combing& combing)
    : m_surface(surface), m_patch(patch), m_alpha(alpha), m_rho(rho), m_combing(combing)
  {}

  // The angle of a branch of the chart, in radians from the first halfedge of its face.
  double angle(const int face, const int branch) const
  {
    const int k = (branch + m_combing.turn[face - m_patch.faces.begin_index]) & 3;
    return m_alpha[face] + k * CGAL_PI / 2 + (k % 2 == 0 ? 0 : m_rho[face]);
  }

  // The branch of the chart that is nearest to the direction of a halfedge.
  int branch_along(const int halfedge) const
  {
    const double direction = halfedge_angle(m_surface, halfedge);
    int best = 0;
    double largest_cosine = -2;
    for(int branch = 0; branch < 4; ++branch)
    {
      const double cosine = std::cos(direction - angle(face_of(halfedge), branch));
      if(cosine > largest_cosine)
      {
        largest_cosine = cosine;
        best = branch;
      }
    }
    return best;
  }

  // The coefficients of a halfedge in the unit vectors along branches 0 and 1, which need not be perpendicular.
  Plane_vector coordinates(const int halfedge) const
  {
    const int face = face_of(halfedge);
    const double direction = halfedge_angle(m_surface, halfedge), length = m_surface.length[halfedge];
    const double angle_0 = angle(face, 0), angle_1 = angle(face, 1);
    const double sine = std::sin(angle_1 - angle_0);
    return { length * std::sin(angle_1 - direction) / sine, length * std::sin(direction - angle_0) / sine };
  }

private:
  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_alpha;
  const std::vector<double>& m_rho;
  const Combing& m_combing;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_COMBED_FIELD_H
