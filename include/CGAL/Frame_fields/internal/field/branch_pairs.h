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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_BRANCH_PAIRS_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_BRANCH_PAIRS_H

#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The branch pairs of a face: 0 are the branches 0 and 2, 1 are the branches 1 and 3.

// The rotation of each pair of opposite branches, gamma0 and gamma1 of Section 4 of the paper.
typedef std::array<double, 2> Branch_rotations;

// The number of the branch pair (0 or 1) of an orthogonal frame that is nearest to a direction of its face.
inline int nearest_branch(const double direction, const double alpha)
{
  return static_cast<int>(std::lround((direction - alpha) / (CGAL_PI / 2))) & 1;
}

// The branch pair (0 or 1) that lies along the direction an aligned face must keep.
inline int aligned_branch(const Cut_surface& surface, const int face, const double alpha)
{
  return nearest_branch(surface.alignment[face], alpha);
}

// The branch pair of face j that branch pair `b` (0 or 1) of face i goes to across a dual edge with this matching.
inline int matched_branch(const int b, const int matching) { return b ^ (matching & 1); }

// The angle of the first branch of branch pair b (0 or 1) in its face, in radians.
inline double branch_angle(const std::vector<double>& alpha, const std::vector<double>& rho, const int face,
                           const int b)
{
  return b == 0 ? alpha[face] : alpha[face] + CGAL_PI / 2 + rho[face];
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_BRANCH_PAIRS_H
