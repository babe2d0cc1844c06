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

#ifndef CGAL_FRAME_FIELDS_QUAD_STATISTICS_H
#define CGAL_FRAME_FIELDS_QUAD_STATISTICS_H

#include <CGAL/Frame_fields/Quad_quality.h>
#include <CGAL/Frame_fields/Statistics.h>

#include <cstddef>
#include <string>
#include <vector>

/// \file Quad_statistics.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsEnums
///
/// lists the stages of `cad_quad_mesh()` and `quad_mesh()`. Quantization and smoothing take turns while quadrangles
/// stay inverted; the assembly comes last.
enum class Quad_stage
{
  PREPARATION,   ///< a copy of the mesh is refined until the field and the map have room
  FIELD,         ///< see `cad_frame_field()`
  SEAMLESS_MAP,  ///< each patch gets a seamless map and its certificate
  T_MESH,        ///< each certified patch is divided into rectangular cells
  QUANTIZATION,  ///< all arcs get their numbers of edges, in one system, and the quadrangles are made and checked
  ASSEMBLY,      ///< the quadrangles become faces of the output mesh
  SMOOTHING      ///< vertices move on the surface
};

/// \ingroup PkgFrame_fieldsRef
///
/// is the default visitor of `cad_quad_mesh()` and `quad_mesh()`; it does nothing.
///
/// A visitor class can derive from it and hide the functions that it wants to be called.
struct Default_quad_mesh_visitor : Default_frame_field_visitor
{
  using Default_frame_field_visitor::start_stage;

  /// does nothing.
  void start_stage(Quad_stage) {}
};

/// \ingroup PkgFrame_fieldsEnums
///
/// tells how a patch got its quadrangles.
enum class Patch_way
{
  CERTIFIED_MAP, ///< from its seamless map, with the irregular vertices of its field and no others inside
  FILLING        ///< by a combinatorial filling of its boundary, since its map has no certificate
};

/// \ingroup PkgFrame_fieldsRef
///
/// tells of one patch what it is and how it got its quadrangles.
struct Patch_quad_statistics
{
  std::size_t number_of_faces = 0;           ///< triangles of the prepared mesh
  std::size_t number_of_quads = 0;           ///< quadrangles of the result
  Patch_way way = Patch_way::CERTIFIED_MAP;  ///< where these come from
  std::string reason;                        ///< why the patch was filled; empty otherwise
  std::size_t number_of_cancelled_pairs = 0; ///< pairs of indices that its field lost, since they excluded every map
};

/// \ingroup PkgFrame_fieldsRef
///
/// holds the wall-clock seconds of each stage of `cad_quad_mesh()` or `quad_mesh()`.
struct Quad_stage_seconds
{
  double preparation = 0;   ///< of `Quad_stage::PREPARATION`
  double field = 0;         ///< of `Quad_stage::FIELD`
  double seamless_map = 0;  ///< of `Quad_stage::SEAMLESS_MAP`
  double t_mesh = 0;        ///< of `Quad_stage::T_MESH`
  double quantization = 0;  ///< of `Quad_stage::QUANTIZATION`
  double assembly = 0;      ///< of `Quad_stage::ASSEMBLY`
  double smoothing = 0;     ///< of `Quad_stage::SMOOTHING`
  double total = 0;         ///< from the call to the return
};

/// \ingroup PkgFrame_fieldsRef
///
/// holds the figures of one call of `cad_quad_mesh()` or `quad_mesh()`; see their named parameter `statistics`.
struct Quad_statistics
{
  std::size_t number_of_patches = 0;           ///< pieces of the surface cut along its features
  std::size_t number_of_certified_patches = 0; ///< patches with the way `Patch_way::CERTIFIED_MAP`
  std::size_t number_of_filled_patches = 0;    ///< patches with the way `Patch_way::FILLING`
  std::size_t number_of_repaired_patches = 0;  ///< patches whose field lost pairs of indices
  std::size_t number_of_nodes = 0;             ///< vertices at which feature curves end, meet or turn
  std::size_t number_of_arcs = 0;              ///< feature curves between nodes, or closed without any
  std::size_t number_of_unmet_edge_numbers = 0; ///< arcs that do not have the number of edges of `number_of_edges_map`
  std::size_t number_of_quads = 0;             ///< faces of the result
  double target_edge_length = 0;               ///< the one given, or what `number_of_quads` or all lengths amount to
  double minimum_target_edge_length = 0;       ///< the least of all lengths asked for: by `sizing_map` or the bounds
  double maximum_target_edge_length = 0;       ///< the greatest one

  /// one entry for each patch, in the order of the numbers in `face_to_patch_map`
  std::vector<Patch_quad_statistics> patches;

  Quad_quality quality;       ///< of the result
  Statistics field;           ///< of the field, see `cad_frame_field()`
  Quad_stage_seconds seconds; ///< the time spent in each stage
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_QUAD_STATISTICS_H
