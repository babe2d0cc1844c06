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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_QUADS_H

#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/layout/make_T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/make_feature_network.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/compute_seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/assemble.h>
#include <CGAL/Frame_fields/internal/quads/layout_network.h>
#include <CGAL/Frame_fields/internal/quads/quad_connectivity.h>
#include <CGAL/Frame_fields/internal/quads/smooth_quads.h>
#include <CGAL/Frame_fields/internal/quads/split_triangles.h>
#include <CGAL/Frame_fields/internal/quantization/quantize.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The field that the quads follow: the relaxed branches, their matching, and 4 I.
struct Quad_field
{
  std::vector<double> alpha, rho;  // per face
  std::vector<int> matching;       // per dual edge
  std::vector<int> index;          // per sector
};

inline const char* reason_of(const Map_status status)
{
  switch(status)
  {
    case Map_status::CERTIFIED:        return "";
    case Map_status::FORCED_ZERO_SIDE: return "the field forces a feature edge to length zero";
    case Map_status::SOLVER_FAILED:    return "the linear system of the map could not be solved";
    case Map_status::INVERTED_FACE:    return "a face of the map is inverted";
    case Map_status::REVERSED_EDGE:    return "a feature edge of the map runs backward";
    case Map_status::WRONG_CONE:       return "a sector of the map does not have the angle of its index";
  }
  return "";
}

inline const char* reason_of(const T_mesh_status status)
{
  switch(status)
  {
    case T_mesh_status::COMPLETE:           return "no numbers of edges fit its arcs and those of its neighbors";
    case T_mesh_status::NOT_CERTIFIED:      return "the map has no certificate";
    case T_mesh_status::WRONG_SECTOR:       return "a sector of the map does not have the directions of its index";
    case T_mesh_status::TOO_LONG:           return "the lines from the singularities are too long";
    case T_mesh_status::OVERLAPPING_PIECES: return "lines from the singularities overlap";
    case T_mesh_status::NO_RECTANGLES:      return "the lines from the singularities do not bound rectangles";
  }
  return "";
}

// From the T-meshes of the patches to quads. Whatever a patch lacks, quads come out: a patch is filled instead.
class Quad_maker
{
public:
  Quad_maker(const Cut_surface& surface, const Surface_embedding& embedding, const Feature_network& features,
             const Seamless_map& map, std::vector<T_mesh>& t_meshes, const double target_edge_length)
    : m_surface(surface), m_embedding(embedding), m_features(features), m_map(map), m_t_meshes(t_meshes)
    , m_target_edge_length(target_edge_length)
  {}

  // Decides how many edges all pieces and arcs have. Where there are no such integers, or where quads would meet twice,
  // bounds are raised or patches are filled; each round does one or the other, and when all are filled, all fits.
  Quad_complex make()
  {
    quantize_pieces();
    for(int round = 0; ; ++round)
    {
      Quad_complex complex = assemble();
      if(m_number_of_t_meshes == 0 || !raise_bounds_of_conflicts(complex))
        return complex;
      if(round < maximum_number_of_rounds)
        quantize_pieces();
      else
        fill_all();
    }
  }

private:
  static constexpr int maximum_number_of_rounds = 12;

  // The cell that each quad of a patch with a T-mesh comes from.
  struct Quad_origin
  {
    int patch, cell;
  };

  void quantize_pieces()
  {
    for(;;)
    {
      m_sides = collect_arc_sides(m_surface, m_embedding, m_features, m_t_meshes);
      m_layout = make_layout_network(m_surface, m_features, m_t_meshes, m_sides, m_target_edge_length);
      apply_bounds();
      m_number_of_t_meshes = 0;
      for(const T_mesh& t_mesh : m_t_meshes)
        m_number_of_t_meshes += !t_mesh.cells.empty();
      const Quantization quantization = quantize(m_layout.network);
      if(quantization.is_feasible)
      {
        m_value = quantization.value;
        return;
      }
      fill_blocked_patches(quantization);
    }
  }

  // Arcs beside filled patches have two quad edges per edge of the triangle mesh.
  void apply_bounds()
  {
    if(m_raised.empty())
      m_raised.assign(m_layout.network.edges.size(), 0);
    for(std::size_t e = 0; e < m_raised.size(); ++e)
      m_layout.network.edges[e].lower_bound = (std::max)(m_layout.network.edges[e].lower_bound, m_raised[e]);
    for(std::size_t a = 0; a < m_features.arcs.size(); ++a)
      if(is_beside_filled_patch(m_sides, static_cast<int>(a)))
      {
        Bidirected_edge& arc = m_layout.network.edges[m_layout.first_arc + a];
        arc.lower_bound = arc.upper_bound = 2 * static_cast<int>(m_features.arcs[a].halfedges.size());
      }
  }

  void fill_patch(const int patch)
  {
    m_t_meshes[patch] = T_mesh();
    m_raised.clear(); // the unknowns are others now
  }

  void fill_all()
  {
    for(std::size_t patch = 0; patch < m_t_meshes.size(); ++patch)
      fill_patch(static_cast<int>(patch));
    quantize_pieces();
  }

  // Fills the patches that have, or whose arcs have, unknowns without a solution; all if there are none.
  void fill_blocked_patches(const Quantization& quantization)
  {
    std::vector<char> is_blocked(m_t_meshes.size(), 0);
    for(const std::vector<int>* const edges : { &quantization.unattainable, &quantization.conflicting })
      for(const int e : *edges)
      {
        if(e < m_layout.first_arc)
          is_blocked[patch_of_piece(e)] = 1;
        else
          for(const Arc_side& side : m_sides[e - m_layout.first_arc])
            if(side.patch >= 0)
              is_blocked[side.patch] = 1;
      }
    bool is_any_filled = false;
    for(std::size_t patch = 0; patch < m_t_meshes.size(); ++patch)
      if(is_blocked[patch] && !m_t_meshes[patch].cells.empty())
      {
        fill_patch(static_cast<int>(patch));
        is_any_filled = true;
      }
    if(!is_any_filled)
      for(std::size_t patch = 0; patch < m_t_meshes.size(); ++patch)
        fill_patch(static_cast<int>(patch));
  }

  int patch_of_piece(const int unknown) const
  {
    const auto after = std::upper_bound(m_layout.first_piece.begin(), m_layout.first_piece.end(), unknown);
    return static_cast<int>(after - m_layout.first_piece.begin()) - 1;
  }

  Quad_complex assemble()
  {
    std::vector<std::vector<int> > edges_of_piece(m_t_meshes.size());
    for(std::size_t patch = 0; patch < m_t_meshes.size(); ++patch)
    {
      const auto first = m_value.begin() + m_layout.first_piece[patch];
      edges_of_piece[patch].assign(first, first + static_cast<std::ptrdiff_t>(m_t_meshes[patch].pieces.size()));
    }
    const std::vector<int> edges_of_arc(m_value.begin() + m_layout.first_arc, m_value.end());
    const Quad_layout layout{ m_surface, m_embedding, m_features, m_map, m_t_meshes, m_sides, edges_of_piece,
                              edges_of_arc };
    Quad_complex complex;
    const Arc_vertices arc_vertices = make_arc_vertices(layout, complex);
    m_origin.clear();
    for(std::size_t p = 0; p < m_t_meshes.size(); ++p)
    {
      const int patch = static_cast<int>(p);
      if(m_t_meshes[p].cells.empty())
      {
        split_triangles_of_patch(layout, patch, complex);
        m_origin.resize(complex.quads.size(), { patch, -1 });
        continue;
      }
      Patch_assembly assembly(layout, arc_vertices, patch, complex);
      for(std::size_t cell = 0; cell < m_t_meshes[p].cells.size(); ++cell)
      {
        assembly.fill_cell(m_t_meshes[p].cells[cell]);
        m_origin.resize(complex.quads.size(), { patch, static_cast<int>(cell) });
      }
    }
    return complex;
  }

  // Asks for more edges where sides of quads contradict each other. Returns whether there are such sides.
  bool raise_bounds_of_conflicts(const Quad_complex& complex)
  {
    const std::vector<int> conflicts = connect_quads(complex).conflicts;
    for(const int side : conflicts)
    {
      const Quad_origin origin = m_origin[side / 4];
      if(origin.cell < 0)
        continue;
      // Sides 0 and 2 of a quad run along sides 0 and 2 of its cell.
      const std::vector<Directed_piece>& pieces = m_t_meshes[origin.patch].cells[origin.cell].sides[side % 2];
      const int unknown = m_layout.first_piece[origin.patch] + pieces.front().piece;
      m_raised[unknown] = (std::max)(m_raised[unknown], m_value[unknown] + 1);
    }
    return !conflicts.empty();
  }

  const Cut_surface& m_surface;
  const Surface_embedding& m_embedding;
  const Feature_network& m_features;
  const Seamless_map& m_map;
  std::vector<T_mesh>& m_t_meshes;
  double m_target_edge_length;
  Arc_sides m_sides;
  Layout_network m_layout;
  std::vector<int> m_raised;     // per unknown: a lower bound that the quads ask for
  std::vector<int> m_value;      // per unknown
  int m_number_of_t_meshes = 0;
  std::vector<Quad_origin> m_origin; // per quad
};

// The number of quads asked for as an edge length, or the other way round.
inline double surface_area(const Cut_surface& surface)
{
  double sum = 0;
  for(const Patch& patch : surface.patches)
    sum += patch_area(surface, patch);
  return sum;
}

// All stages behind the field, with lengths in the unit of `Cut_surface::length`.
template <typename ConcurrencyTag, typename SolverTraits, typename StageClock>
Quad_complex make_quads(const Cut_surface& surface, const Surface_embedding& embedding, const Quad_field& field,
                        const std::vector<char>& is_marked_vertex, const double target_edge_length,
                        const SolverTraits& solver_traits, StageClock& clock, Quad_statistics& statistics)
{
  clock.start(Quad_stage::SEAMLESS_MAP);
  Seamless_map map;
  const std::vector<double> target_length(surface.number_of_faces(), target_edge_length);
  compute_seamless_map<ConcurrencyTag>(surface, field.alpha, field.rho, field.matching, field.index, target_length,
                                       solver_traits, map);

  clock.start(Quad_stage::T_MESH);
  const std::vector<char> is_node = feature_nodes(surface, embedding, field.index, is_marked_vertex);
  const Feature_network features = make_feature_network(surface, embedding, is_node);
  std::vector<char> is_arc_node(surface.number_of_sectors(), 0);
  for(int s = 0; s < surface.number_of_sectors(); ++s)
    is_arc_node[s] = surface.is_constrained_sector(s) && is_node[embedding.vertex[surface.first_corner[s]]];
  std::vector<T_mesh> t_meshes(surface.patches.size());
  std::vector<T_mesh_status> t_mesh_status(surface.patches.size());
  for_each_patch<ConcurrencyTag>(surface, [&](const int patch)
  {
    T_mesh_result result = make_T_mesh(surface, surface.patches[patch], field.index, map, is_arc_node);
    t_meshes[patch] = std::move(result.mesh);
    t_mesh_status[patch] = result.status;
    return Patch_result();
  });

  clock.start(Quad_stage::QUANTIZATION);
  Quad_complex complex =
    Quad_maker(surface, embedding, features, map, t_meshes, target_edge_length).make();

  clock.start(Quad_stage::SMOOTHING);
  smooth(complex, surface, embedding, features);

  statistics.number_of_patches = surface.patches.size();
  statistics.number_of_arcs = features.arcs.size();
  statistics.number_of_nodes = static_cast<std::size_t>(std::count(is_node.begin(), is_node.end(), char(1)));
  statistics.number_of_quads = complex.quads.size();
  statistics.patches.resize(surface.patches.size());
  for(std::size_t p = 0; p < surface.patches.size(); ++p)
  {
    Patch_quad_statistics& patch = statistics.patches[p];
    patch.number_of_faces = surface.patches[p].faces.size();
    patch.way = t_meshes[p].cells.empty() ? Patch_way::FILLING : Patch_way::CERTIFIED_MAP;
    if(patch.way == Patch_way::FILLING)
      patch.reason = map.status[p] == Map_status::CERTIFIED ? reason_of(t_mesh_status[p]) : reason_of(map.status[p]);
    ++(patch.way == Patch_way::FILLING ? statistics.number_of_filled_patches
                                       : statistics.number_of_certified_patches);
  }
  for(const int patch : complex.patch)
    ++statistics.patches[patch].number_of_quads;
  return complex;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_QUADS_H
