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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_OF_PATCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_OF_PATCH_H

#include <CGAL/Frame_fields/internal/integer_grid/Integer_grid_charts.h>
#include <CGAL/Frame_fields/internal/integer_grid/Integer_grid_solver.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Per sector of a patch: whether an integer-grid map must place it at integers. These are the nodes of the T-mesh at
// irregular or constrained vertices, and if there are none, one other node.
inline std::vector<char> fixed_sectors(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index,
                                       const T_mesh& t_mesh)
{
  std::vector<char> is_fixed(patch.sectors.size(), 0);
  int other = -1;
  for(const T_mesh_node& node : t_mesh.nodes)
    if(node.sector >= 0 && (index[node.sector] != 0 || surface.is_constrained_sector(node.sector)))
      is_fixed[node.sector - patch.sectors.begin_index] = 1;
    else if(node.sector >= 0 && other < 0)
      other = node.sector - patch.sectors.begin_index;
  if(other >= 0 && std::find(is_fixed.begin(), is_fixed.end(), char(1)) == is_fixed.end())
    is_fixed[other] = 1;
  return is_fixed;
}

inline double area_of_patch(const Cut_surface& surface, const Patch& patch)
{
  double sum = 0;
  for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
  {
    const int h = 3 * f;
    sum += surface.length[h] * surface.length[h + 1] * std::sin(surface.angle[h]) / 2;
  }
  return sum;
}

// The number of quads of a patch.
inline double number_of_grid_quads(const T_mesh& t_mesh, const std::vector<int>& edges_of_piece)
{
  double sum = 0;
  for(const T_mesh_cell& cell : t_mesh.cells)
  {
    double edges[2] = { 0, 0 };
    for(int side = 0; side < 2; ++side)
      for(const Directed_piece& directed : cell.sides[side])
        edges[side] += edges_of_piece[directed.piece];
    sum += edges[0] * edges[1];
  }
  return sum;
}

// Writes the integer-grid map of a patch with the numbers of edges of its T-mesh into `grid_map`. Returns the status of
// its certificate. Different patches may run in parallel.
template <typename SolverTraits>
Map_status integer_grid_map_of_patch(const Cut_surface& surface, const int patch_number, const std::vector<int>& index,
                                     const Seamless_map& map, const T_mesh& t_mesh,
                                     const std::vector<int>& edges_of_piece, const std::vector<char>& is_fixed,
                                     const SolverTraits& solver_traits, Seamless_map& grid_map)
{
  const Patch& patch = surface.patches[patch_number];
  Integer_grid_charts charts(surface, patch, map, t_mesh, edges_of_piece);
  if(!charts.compute())
    return Map_status::SOLVER_FAILED;
  const double edge_length = std::sqrt(area_of_patch(surface, patch) / number_of_grid_quads(t_mesh, edges_of_piece));
  return Integer_grid_solver(surface, patch, index, map, charts, is_fixed, edge_length)
    .compute(solver_traits, grid_map, grid_map.fraction_bits[patch_number]);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_OF_PATCH_H
