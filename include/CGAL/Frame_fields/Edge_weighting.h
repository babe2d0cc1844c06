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

#ifndef CGAL_FRAME_FIELDS_EDGE_WEIGHTING_H
#define CGAL_FRAME_FIELDS_EDGE_WEIGHTING_H

/// \file Edge_weighting.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsEnums
///
/// lists the weights \f$ w_{ij} \f$ of the unconstrained edges in the sums that define the prescribed rotation, the
/// orthogonal field and its relaxation.
enum class Edge_weighting
{
  /// \f$ w_{ij} = 1 \f$, as in \cgalCite{cgal:dprcs-ffcm-22}
  UNIFORM,

  /// the length of the edge divided by the length of its dual, 1 for two equilateral triangles: the sums approximate
  /// integrals over the surface, so that the field depends little on the mesh. The dual of an edge joins the centroids
  /// of its two triangles and is measured perpendicular to the edge.
  PRIMAL_OVER_DUAL_LENGTH
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_EDGE_WEIGHTING_H
