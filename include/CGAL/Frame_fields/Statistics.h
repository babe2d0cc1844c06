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

#ifndef CGAL_FRAME_FIELDS_STATISTICS_H
#define CGAL_FRAME_FIELDS_STATISTICS_H

#include <cstddef>

/// \file Statistics.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsRef
///
/// lists the stages of `cad_frame_field()` in their order.
enum class Stage
{
  CUT_SURFACE,           ///< the mesh is read and cut along its constrained edges
  PRESCRIBED_ROTATION,   ///< the rotation prescribed across the dual edges, see `prescribe_rotation()`
  ORTHOGONAL_FIELD,      ///< see `orthogonal_frame_field()`
  MATCHING_AND_INDICES,  ///< see `singularity_indices()`
  RELAXATION             ///< see `relax_frame_field()`
};

/// \ingroup PkgFrame_fieldsRef
///
/// is the default visitor of `cad_frame_field()`; it does nothing. A visitor class need not derive from it.
///
/// \cgalModels{FrameFieldVisitor}
struct Default_frame_field_visitor
{
  /// does nothing.
  void start_stage(Stage) {}
};

/// \ingroup PkgFrame_fieldsRef
///
/// holds the wall-clock seconds of each stage of `cad_frame_field()`.
struct Stage_seconds
{
  double cut_surface = 0;          ///< of `Stage::CUT_SURFACE`
  double prescribed_rotation = 0;  ///< of `Stage::PRESCRIBED_ROTATION`
  double orthogonal_field = 0;     ///< of `Stage::ORTHOGONAL_FIELD`
  double matching_and_indices = 0; ///< of `Stage::MATCHING_AND_INDICES`
  double relaxation = 0;           ///< of `Stage::RELAXATION`, 0 if the field is not relaxed
  double total = 0;                ///< from the call to the return, with the writing of the output maps
};

/// \ingroup PkgFrame_fieldsRef
///
/// holds the figures of one call of `cad_frame_field()`; see its named parameter `statistics`.
struct Statistics
{
  /// the number of connected pieces of the surface cut along its constrained edges
  std::size_t number_of_patches = 0;

  /// the number of sharp corners, as `sharp_corners()` lists them, whatever the support strategy
  std::size_t number_of_sharp_corners = 0;

  /// the number of sectors on constrained edges whose index the repair changed
  std::size_t number_of_repaired_sectors = 0;

  /// the number of sectors on constrained edges that still have an index of \f$ 1/2 \f$ or more
  std::size_t number_of_unmeshable_sectors = 0;

  /// the number of sectors on no constrained edge with an index of \f$ 1/2 \f$ or more: at most two quadrangles
  std::size_t number_of_unmeshable_inner_sectors = 0;

  /// the number of sectors on constrained edges that do not have their natural index, the one nearest to their angle
  std::size_t number_of_unnatural_sectors = 0;

  /// the number of sharp corners among the sectors that do not have their natural index
  std::size_t number_of_unnatural_corners = 0;

  /// the number of faces whose skewness was brought back to the maximum
  std::size_t number_of_clamped_faces = 0;

  /// \f$ \sum (r_{ij} - \omega_{ij})^2 \f$ of the orthogonal field
  double energy_orthogonal = 0;

  /// \f$ \sum (r^0_{ij})^2 + (r^1_{ij})^2 \f$ of the final field, after the skewness was clamped
  double energy_relaxed = 0;

  /// the time spent in each stage
  Stage_seconds seconds;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_STATISTICS_H
