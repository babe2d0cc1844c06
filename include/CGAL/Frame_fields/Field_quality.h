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

#ifndef CGAL_FRAME_FIELDS_FIELD_QUALITY_H
#define CGAL_FRAME_FIELDS_FIELD_QUALITY_H

/// \file Field_quality.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsRef
///
/// holds the measures that `frame_field_quality()` computes.
struct Field_quality
{
  /// \f$ \sum w_{ij} ((r^0_{ij})^2 + (r^1_{ij})^2) \f$ over the unconstrained edges, in squared radians
  double energy = 0;

  /// the mean of \f$ |r^0_{ij}| \f$ and \f$ |r^1_{ij}| \f$ over the unconstrained edges, in radians
  double mean_rotation = 0;

  /// the largest of them, in radians
  double maximum_rotation = 0;

  /// how far the branches are from gradients of a parameterization: matched branches \f$ u_i, u_j \f$ on the two sides
  /// of an edge \f$ e \f$ differ by \f$ (u_i - u_j) \cdot e \f$ along it; this is the root of the sum of the squares
  /// over all edges and both branch pairs, divided by the root of the sum of \f$ 2 |e|^2 \f$. 0 is best.
  double curl = 0;

  /// the mean of \f$ |\rho| \f$ over the area, in radians
  double mean_skewness = 0;

  /// the largest \f$ |\rho| \f$, in radians
  double maximum_skewness = 0;

  /// the largest angle between a constrained edge and the nearest branch of its face, in radians
  double maximum_misalignment = 0;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_FIELD_QUALITY_H
