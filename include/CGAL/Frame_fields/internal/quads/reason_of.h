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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_REASON_OF_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_REASON_OF_H

#include <CGAL/Frame_fields/internal/layout/make_T_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Why a patch has no map, in words; empty if it has one.
inline const char* reason_of(const Map_status status)
{
  switch(status)
  {
    case Map_status::CERTIFIED:         return "";
    case Map_status::FORCED_ZERO_SIDE:  return "the field forces a feature edge to length zero";
    case Map_status::SOLVER_FAILED:     return "the linear system of the map could not be solved";
    case Map_status::INVERTED_FACE:     return "a face of the map is inverted";
    case Map_status::REVERSED_EDGE:     return "a feature edge of the map runs backward";
    case Map_status::WRONG_CONE:        return "a sector of the map does not have the angle of its index";
    case Map_status::ONE_PAIR_ON_TORUS: return "a torus with one pair of irregular vertices has no map";
    case Map_status::NO_NUMBERS_OF_EDGES: return "no numbers of edges fit to the map";
  }
  return "";
}

// Why a patch with a certified map has no quads of a T-mesh. A complete T-mesh was given up later.
inline const char* reason_of(const T_mesh_status status)
{
  switch(status)
  {
    case T_mesh_status::COMPLETE:           return "no numbers of edges tried give valid quads in it and beside it";
    case T_mesh_status::NOT_CERTIFIED:      return "the map has no certificate";
    case T_mesh_status::WRONG_SECTOR:       return "a sector of the map does not have the directions of its index";
    case T_mesh_status::TOO_LONG:           return "the lines from the singularities are too long";
    case T_mesh_status::OVERLAPPING_PIECES: return "lines from the singularities overlap";
    case T_mesh_status::NO_RECTANGLES:      return "the lines from the singularities do not bound rectangles";
  }
  return "";
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_REASON_OF_H
