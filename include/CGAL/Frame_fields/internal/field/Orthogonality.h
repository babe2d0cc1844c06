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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_ORTHOGONALITY_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_ORTHOGONALITY_H

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>
#include <CGAL/Frame_fields/internal/surface/weights.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The weight of (gamma0 - gamma1)^2 in each face of a patch. With uniform edge weights it is the option
// `orthogonality_weight`. Otherwise it is area / (sqrt(3) length^2), where the option `orthogonality_length` gives the
// length. The sum over the faces is then the integral of (gamma0 - gamma1)^2 / length^2, in the same proportion to the
// integral of the squared gradients as the edge weights, since an edge between equilateral triangles has weight 1.
class Orthogonality
{
public:
  Orthogonality(const Cut_surface& surface, const Patch& patch, const Options& options)
    : m_surface(surface)
    , m_is_integral(surface.edge_weighting != Edge_weighting::UNIFORM)
    , m_factor(options.orthogonality_weight)
  {
    if(!m_is_integral)
      return;
    double squared_length = default_length_ratio * default_length_ratio * patch_area(surface, patch);
    if(options.orthogonality_length)
    {
      const double length = *options.orthogonality_length / surface.length_unit;
      squared_length = (std::max)(length * length, smallest_number);
    }
    m_factor = squared_length > 0 ? 1 / (std::sqrt(3.) * squared_length) : 0; // 0: a patch without area
  }

  double weight(const int face) const
  {
    return (std::min)(largest_weight, m_is_integral ? m_factor * area(m_surface, face) : m_factor);
  }

  // Whether the weight ties the two branches of a face to one another: whether it is more than the rounding errors of
  // the edge weights.
  bool ties(const int face) const { return weight(face) > smallest_effective_weight; }

private:
  static constexpr double default_length_ratio = 0.25; // of the square root of the patch's area
  static constexpr double smallest_number = (std::numeric_limits<double>::min)();
  // The edges have weights of about 1. A larger bound would let them vanish in rounding errors; this one is enough to
  // hold the frames orthogonal.
  static constexpr double largest_weight = 1e8;

  const Cut_surface& m_surface;
  bool m_is_integral;
  double m_factor;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_ORTHOGONALITY_H
