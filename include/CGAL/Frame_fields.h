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

#ifndef CGAL_FRAME_FIELDS_H
#define CGAL_FRAME_FIELDS_H

/// \file Frame_fields.h
/// includes all functions of this package.

#include <CGAL/Frame_fields/Cut_triangle_mesh.h>
#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Linear_algebra_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/No_index_target.h>
#include <CGAL/Frame_fields/Quad_block.h>
#include <CGAL/Frame_fields/Quad_quality.h>
#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/Seamless_map_status.h>
#include <CGAL/Frame_fields/Statistics.h>
#include <CGAL/Frame_fields/Streamline.h>
#include <CGAL/Frame_fields/Support_strategy.h>
#include <CGAL/Frame_fields/T_junctions.h>
#include <CGAL/Frame_fields/cad_frame_field.h>
#include <CGAL/Frame_fields/cad_quad_mesh.h>
#include <CGAL/Frame_fields/comb_frame_field.h>
#include <CGAL/Frame_fields/compute_quad_sizes.h>
#include <CGAL/Frame_fields/detect_feature_edges.h>
#include <CGAL/Frame_fields/frame_field_from_vectors.h>
#include <CGAL/Frame_fields/frame_field_quality.h>
#include <CGAL/Frame_fields/frame_vectors.h>
#include <CGAL/Frame_fields/integer_grid_parameterization.h>
#include <CGAL/Frame_fields/orthogonal_frame_field.h>
#include <CGAL/Frame_fields/parameters.h>
#include <CGAL/Frame_fields/prepare_for_frame_field.h>
#include <CGAL/Frame_fields/prescribe_rotation.h>
#include <CGAL/Frame_fields/quad_mesh.h>
#include <CGAL/Frame_fields/quad_mesh_blocks.h>
#include <CGAL/Frame_fields/quad_mesh_quality.h>
#include <CGAL/Frame_fields/refine_triangles.h>
#include <CGAL/Frame_fields/relax_frame_field.h>
#include <CGAL/Frame_fields/seamless_parameterization.h>
#include <CGAL/Frame_fields/sharp_corners.h>
#include <CGAL/Frame_fields/singularities.h>
#include <CGAL/Frame_fields/singularity_indices.h>
#include <CGAL/Frame_fields/split_chords.h>
#include <CGAL/Frame_fields/split_overconstrained_faces.h>
#include <CGAL/Frame_fields/trace_streamlines.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#endif

#endif // CGAL_FRAME_FIELDS_H
