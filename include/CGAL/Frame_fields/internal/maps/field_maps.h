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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_FIELD_MAPS_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_FIELD_MAPS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/branch_pairs.h>
#include <CGAL/Frame_fields/internal/field/relaxation.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Between flat arrays and the caller's property maps and named parameters.

// The result for the caller: the error of a patch with the place in the mesh where it is.
template <typename CutMesh>
Result to_result(const CutMesh& cut_mesh, const Patch_result& patch_result)
{
  if(patch_result.error_code == OK)
    return {};
  const std::string sector = cut_mesh.description_of_sector(patch_result.sector);
  switch(patch_result.error_code)
  {
    case ERROR_POINCARE_HOPF:
      return failure(ERROR_POINCARE_HOPF,
                     std::to_string(patch_result.missing_index) + "/4 is missing in the patch of " + sector);
    case ERROR_CANNOT_SOLVE_LINEAR_SYSTEM:
      return failure(ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, "in the patch of " + sector);
    default:
      return failure(patch_result.error_code, sector);
  }
}

// Writes a value per face.
template <typename CutMesh, typename FaceMap, typename Value>
void write_on_faces(const CutMesh& cut_mesh, const std::vector<Value>& values, const FaceMap map)
{
  for(std::size_t f = 0; f < values.size(); ++f)
    put(map, cut_mesh.face_descriptors()[f], values[f]);
}

// Writes the values of the dual edges with opposite signs on their two halfedges, and 0 on all other halfedges. It
// allocates nothing, so that it cannot fail between two maps.
template <typename CutMesh, typename Value, typename HalfedgeMap>
void write_on_dual_edges(const CutMesh& cut_mesh, const std::vector<Value>& values, const HalfedgeMap map)
{
  const Cut_surface& surface = cut_mesh.surface();
  cut_mesh.for_each_halfedge([&](const auto h, const int i)
  {
    if(i < 0 || surface.is_constrained(i))
      put(map, h, Value(0));
  });
  for(std::size_t e = 0; e < values.size(); ++e)
  {
    put(map, cut_mesh.halfedge_of(surface.dual_edges[e].halfedge), values[e]);
    put(map, cut_mesh.halfedge_of(surface.dual_edges[e].opposite), -values[e]);
  }
}

// Writes the values of the sectors on all their halfedges, and 0 on border halfedges.
template <typename CutMesh, typename Value, typename HalfedgeMap>
void write_on_sectors(const CutMesh& cut_mesh, const std::vector<Value>& values, const HalfedgeMap map)
{
  const std::vector<int>& sector = cut_mesh.surface().sector;
  cut_mesh.for_each_halfedge([&](const auto h, const int i) { put(map, h, i < 0 ? Value(0) : values[sector[i]]); });
}

// Writes one halfedge of each sector of a list. The list is computed only if there is an output iterator.
template <typename CutMesh, typename ListSectors, typename OutputIterator>
void write_sectors(const CutMesh& cut_mesh, const ListSectors& list_sectors, OutputIterator out)
{
  for(const int s : list_sectors())
    *out++ = cut_mesh.halfedge_of(cut_mesh.surface().first_corner[s]);
}

template <typename CutMesh, typename ListSectors>
void write_sectors(const CutMesh&, const ListSectors&, const CGAL::internal_np::Param_not_found) {}

// Writes the field that the relaxation makes of `alpha`.
template <typename CutMesh, typename AlphaMap, typename SkewnessMap>
void write_relaxed_field(const CutMesh& cut_mesh, const std::vector<double>& alpha,
                         const std::vector<Branch_rotations>& gamma, const AlphaMap alpha_map,
                         const SkewnessMap skewness_map)
{
  for(std::size_t f = 0; f < alpha.size(); ++f)
  {
    put(alpha_map, cut_mesh.face_descriptors()[f], alpha[f] + gamma[f][0]);
    put(skewness_map, cut_mesh.face_descriptors()[f], gamma[f][1] - gamma[f][0]);
  }
}

// Writes r0 and r1 on both halfedges of each dual edge, seen from the face of each, and 0 on all other halfedges.
template <typename CutMesh, typename HalfedgeMap>
void write_rotations(const CutMesh& cut_mesh, const std::vector<int>& matching,
                     const std::vector<std::array<double, 2> >& rotations, const HalfedgeMap map)
{
  typedef std::array<double, 2> Rotations;
  const Cut_surface& surface = cut_mesh.surface();
  cut_mesh.for_each_halfedge([&](const auto h, int) { put(map, h, Rotations{ 0, 0 }); });
  for(std::size_t e = 0; e < rotations.size(); ++e)
  {
    Rotations from_opposite;
    for(int b = 0; b < 2; ++b)
      from_opposite[matched_branch(b, matching[e])] = -rotations[e][b];
    put(map, cut_mesh.halfedge_of(surface.dual_edges[e].halfedge), rotations[e]);
    put(map, cut_mesh.halfedge_of(surface.dual_edges[e].opposite), from_opposite);
  }
}

template <typename CutMesh>
void write_rotations(const CutMesh&, const std::vector<int>&, const std::vector<std::array<double, 2> >&,
                     const CGAL::internal_np::Param_not_found) {}

// Nothing is written to an output map that was not given.
template <typename CutMesh, typename Value>
void write_on_dual_edges(const CutMesh&, const std::vector<Value>&, const CGAL::internal_np::Param_not_found) {}


// The largest |angle| that is accepted, in radians. In much larger ones the digits that tell a direction are lost, and
// the number of quarter turns does not fit into an `int`.
constexpr double largest_angle_read = 1e6;

inline bool is_angle(const double value) { return std::abs(value) <= largest_angle_read; }

inline std::string beyond_largest_angle()
{
  return " is not finite or beyond +-" + std::to_string(static_cast<int>(largest_angle_read)) + " radians in ";
}

// Reads an angle in radians per face. `values` must be empty before. Fails with `ERROR_WRONG_FIELD` if one is not
// finite or too large; `name` tells in the message what was read.
template <typename CutMesh, typename FaceMap>
Result read_from_faces(const CutMesh& cut_mesh, const char* const name, const FaceMap map, std::vector<double>& values)
{
  values.reserve(cut_mesh.face_descriptors().size());
  for(std::size_t f = 0; f < cut_mesh.face_descriptors().size(); ++f)
  {
    values.push_back(get(map, cut_mesh.face_descriptors()[f]));
    if(!is_angle(values.back()))
      return failure(ERROR_WRONG_FIELD, name + beyond_largest_angle()
                                        + cut_mesh.description_of_face(static_cast<int>(f)));
  }
  return {};
}

// Reads values on halfedges, for each dual edge that of its first halfedge. They must be opposite on both halfedges:
// integers exactly, others up to 1e-9. `values` must be empty before.
template <typename CutMesh, typename HalfedgeMap, typename Value>
Result read_from_dual_edges(const CutMesh& cut_mesh, const char* const name, const HalfedgeMap map,
                            std::vector<Value>& values)
{
  const Cut_surface& surface = cut_mesh.surface();
  std::vector<Value> on_halfedges(surface.number_of_halfedges());
  cut_mesh.for_each_halfedge([&](const auto h, const int i) { if(i >= 0) on_halfedges[i] = get(map, h); });

  const double tolerance = std::is_integral<Value>::value ? 0 : 1e-9;
  values.reserve(surface.dual_edges.size());
  for(const Dual_edge& e : surface.dual_edges)
  {
    values.push_back(on_halfedges[e.halfedge]);
    const double sum = static_cast<double>(on_halfedges[e.halfedge]) + static_cast<double>(on_halfedges[e.opposite]);
    if(!(std::abs(sum) <= tolerance))
      return failure(ERROR_WRONG_FIELD, std::string(name) + " is not opposite on the two halfedges of an edge of "
                                        + cut_mesh.description_of_face(face_of(e.halfedge)));
  }
  return {};
}

// Leaves `values` empty, since the map was not given.
template <typename CutMesh, typename Value>
Result read_from_dual_edges(const CutMesh&, const char*, const CGAL::internal_np::Param_not_found,
                            std::vector<Value>&)
{
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_FIELD_MAPS_H
