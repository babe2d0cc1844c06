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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_PLACE_ON_INTEGER_GRIDS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_PLACE_ON_INTEGER_GRIDS_H

#include <CGAL/Frame_fields/internal/integer_grid/Grid_quad_extraction.h>
#include <CGAL/Frame_fields/internal/integer_grid/integer_grid_of_patch.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_maker.h>
#include <CGAL/Frame_fields/internal/quads/Grid_quad_matching.h>
#include <CGAL/Frame_fields/internal/quads/quad_connectivity.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The vertices of the complex that the quads of an integer-grid map are at, -1 if they are not those of the patch. The
// quads of the patch are those from `first_quad` to `end_quad`.
inline std::vector<int> vertices_of_grid(const Grid_quads& grid, const Patch& patch, const std::vector<char>& is_fixed,
                                         const std::vector<Vertex_at_sector>& vertices, const Quad_complex& complex,
                                         const Quad_connectivity& connectivity, const int first_quad,
                                         const int end_quad)
{
  std::vector<int> vertex_of_sector(patch.sectors.size(), -1); // of the fixed sectors
  for(const Vertex_at_sector& v : vertices)
    if(is_fixed[v.sector - patch.sectors.begin_index])
      vertex_of_sector[v.sector - patch.sectors.begin_index] = v.vertex;
  const auto fixed_vertex = [&](const int g)
  {
    return grid.sector[g] < 0 ? -1 : vertex_of_sector[grid.sector[g] - patch.sectors.begin_index];
  };
  const auto fits = [&](const int g, const int v) { return fixed_vertex(g) < 0 || fixed_vertex(g) == v; };
  for(int side = 0; side < 4 * static_cast<int>(grid.quads.size()); ++side)
    if(const int vertex = fixed_vertex(grid.quads[side / 4][side % 4]); vertex >= 0)
    {
      Grid_quad_matching matching(grid, complex, connectivity, first_quad, end_quad);
      return matching.match(side, vertex, fits) ? matching.vertex_image() : std::vector<int>();
    }
  return {};
}

// Moves the vertices inside some patches to the corners of the quads of their integer-grid maps, which are more even
// than cells stretched one by one. A patch stays as it is where the map is not certified; where it is, its quads are
// those of the T-mesh. Returns the number of patches that were moved. `is_wanted` is per patch; `complex` is the one
// that `maker` made last, whose vertices may have been moved.
template <typename ConcurrencyTag, typename SolverTraits>
int place_on_integer_grids(const Cut_surface& surface, const std::vector<int>& index, const Seamless_map& map,
                           const std::vector<T_mesh>& t_meshes, const Quad_maker& maker,
                           const std::vector<char>& is_wanted, const SolverTraits& solver_traits,
                           Quad_complex& complex)
{
  const Quad_connectivity connectivity = connect_quads(complex);
  const std::vector<std::vector<int> > edges_of_piece = maker.layout().edges_of_piece();
  std::vector<int> first_quad(surface.patches.size() + 1, 0); // the quads of a patch follow one another
  for(const int patch : complex.patch)
    ++first_quad[patch + 1];
  for(std::size_t p = 1; p < first_quad.size(); ++p)
    first_quad[p] += first_quad[p - 1];
  Seamless_map grid_map = map;
  std::vector<char> is_moved(surface.patches.size(), 0);
  for_each_patch<ConcurrencyTag>(surface, [&](const int p)
  {
    if(!is_wanted[p] || t_meshes[p].cells.empty())
      return Patch_result();
    const Patch& patch = surface.patches[p];
    const std::vector<char> is_fixed = fixed_sectors(surface, patch, index, t_meshes[p]);
    Grid_quads grid;
    if(integer_grid_map_of_patch(surface, p, index, map, t_meshes[p], edges_of_piece[p], is_fixed, solver_traits,
                                 grid_map) != Map_status::CERTIFIED
       || !Grid_quad_extraction(surface, patch, grid_map, grid_map.fraction_bits[p]).extract(grid))
      return Patch_result();
    const std::vector<int> vertices = vertices_of_grid(grid, patch, is_fixed, maker.vertices_at_sectors(p), complex,
                                                       connectivity, first_quad[p], first_quad[p + 1]);
    is_moved[p] = !vertices.empty();
    for(std::size_t g = 0; g < vertices.size(); ++g)
      if(Quad_vertex& v = complex.vertices[vertices[g]]; v.patch == p)
        v.location = grid.location[g];
    return Patch_result();
  });
  return static_cast<int>(std::count(is_moved.begin(), is_moved.end(), char(1)));
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_PLACE_ON_INTEGER_GRIDS_H
