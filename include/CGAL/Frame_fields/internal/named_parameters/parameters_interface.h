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

// The named parameters of this package: the type of each, its name in the code, and its name for callers. No include
// guard: the list is included once for each definition of the macro.
CGAL_add_named_parameter(sharp_corner_bound_t, sharp_corner_bound, sharp_corner_bound)
CGAL_add_named_parameter(blunt_corner_bound_t, blunt_corner_bound, blunt_corner_bound)
CGAL_add_named_parameter(support_strategy_t, support_strategy, support_strategy)
CGAL_add_named_parameter(guiding_direction_t, guiding_direction, guiding_direction_map)
CGAL_add_named_parameter(guiding_weight_t, guiding_weight, guiding_weight_map)
CGAL_add_named_parameter(index_target_t, index_target, index_target_map)
CGAL_add_named_parameter(edge_weighting_t, edge_weighting, edge_weighting)
CGAL_add_named_parameter(orthogonality_length_t, orthogonality_length, orthogonality_length)
CGAL_add_named_parameter(repair_matching_t, repair_matching, repair_matching)
CGAL_add_named_parameter(maximum_skewness_t, maximum_skewness, maximum_skewness)
CGAL_add_named_parameter(orthogonality_weight_t, orthogonality_weight, orthogonality_weight)
CGAL_add_named_parameter(relax_orthogonality_t, relax_orthogonality, relax_orthogonality)
CGAL_add_named_parameter(prescribed_rotation_t, prescribed_rotation, prescribed_rotation_map)
CGAL_add_named_parameter(matching_t, matching, matching_map)
CGAL_add_named_parameter(skewness_t, skewness, skewness_map)
CGAL_add_named_parameter(sharp_corner_output_iterator_t, sharp_corner_output_iterator, sharp_corner_output_iterator)
CGAL_add_named_parameter(repaired_sector_output_iterator_t, repaired_sector_output_iterator,
                         repaired_sector_output_iterator)
CGAL_add_named_parameter(unmeshable_sector_output_iterator_t, unmeshable_sector_output_iterator,
                         unmeshable_sector_output_iterator)
CGAL_add_named_parameter(unnatural_sector_output_iterator_t, unnatural_sector_output_iterator,
                         unnatural_sector_output_iterator)
CGAL_add_named_parameter(halfedge_rotation_t, halfedge_rotation, rotation_map)
CGAL_add_named_parameter(statistics_t, statistics, statistics)
CGAL_add_named_parameter(quality_t, quality, quality)
CGAL_add_named_parameter(maximum_misalignment_t, maximum_misalignment, maximum_misalignment)
CGAL_add_named_parameter(concurrency_t, concurrency, concurrency_tag)
CGAL_add_named_parameter(streamline_spacing_t, streamline_spacing, streamline_spacing)
CGAL_add_named_parameter(streamline_separation_t, streamline_separation, streamline_separation)
CGAL_add_named_parameter(maximum_streamline_length_t, maximum_streamline_length, maximum_streamline_length)
CGAL_add_named_parameter(strong_angle_t, strong_angle, strong_angle_in_degrees)
CGAL_add_named_parameter(weak_angle_t, weak_angle, weak_angle_in_degrees)
CGAL_add_named_parameter(minimum_chain_length_t, minimum_chain_length, minimum_chain_length)
CGAL_add_named_parameter(coordinate_error_t, coordinate_error, coordinate_error)
CGAL_add_named_parameter(close_gaps_t, close_gaps, close_gaps)
CGAL_add_named_parameter(target_edge_length_t, target_edge_length, target_edge_length)
CGAL_add_named_parameter(number_of_quads_t, number_of_quads, number_of_quads)
CGAL_add_named_parameter(sizing_t, sizing, sizing_map)
CGAL_add_named_parameter(chord_height_t, chord_height, chord_height)
CGAL_add_named_parameter(edges_across_gap_t, edges_across_gap, edges_across_gap)
CGAL_add_named_parameter(gradation_t, gradation, gradation)
CGAL_add_named_parameter(minimum_edge_length_t, minimum_edge_length, minimum_edge_length)
CGAL_add_named_parameter(field_follows_sizes_t, field_follows_sizes, field_follows_sizes)
CGAL_add_named_parameter(refine_long_triangles_t, refine_long_triangles, refine_long_triangles)
CGAL_add_named_parameter(fixed_number_of_edges_t, fixed_number_of_edges, number_of_edges_map)
CGAL_add_named_parameter(output_edge_is_constrained_t, output_edge_is_constrained, output_edge_is_constrained_map)
CGAL_add_named_parameter(face_to_patch_t, face_to_patch, face_to_patch_map)
CGAL_add_named_parameter(vertex_to_face_location_t, vertex_to_face_location, vertex_to_face_location_map)
CGAL_add_named_parameter(fallback_patch_output_iterator_t, fallback_patch_output_iterator,
                         fallback_patch_output_iterator)
CGAL_add_named_parameter(uncertified_patch_output_iterator_t, uncertified_patch_output_iterator,
                         uncertified_patch_output_iterator)
CGAL_add_named_parameter(flip_tolerance_t, flip_tolerance, flip_tolerance)
CGAL_add_named_parameter(t_junctions_t, t_junctions, t_junctions)
CGAL_add_named_parameter(edge_is_on_block_border_t, edge_is_on_block_border, edge_is_on_block_border_map)
CGAL_add_named_parameter(block_output_iterator_t, block_output_iterator, block_output_iterator)
CGAL_add_named_parameter(number_of_blocks_t, number_of_blocks, number_of_blocks)
