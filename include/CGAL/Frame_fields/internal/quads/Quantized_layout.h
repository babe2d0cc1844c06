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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUANTIZED_LAYOUT_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUANTIZED_LAYOUT_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/Arc_bends.h>
#include <CGAL/Frame_fields/internal/quads/Layout_demands.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/blocking_patch.h>
#include <CGAL/Frame_fields/internal/quads/bound_layout.h>
#include <CGAL/Frame_fields/internal/quantization/Quantizer.h>
#include <CGAL/Frame_fields/internal/quantization/t_mesh_network.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The numbers of edges of all arcs and pieces, the unknowns of a network, with the bounds that they must keep.
//
// Where there are no such integers, demands are given up in this order: that arcs have vertices at all bends (only if
// there are wanted numbers of edges), wanted numbers of edges, raised bounds, T-meshes, fillings. When all patches are
// split into their triangles, the integers always exist.
//
// So a wanted number of edges has precedence over the bends of arcs, but a patch has precedence over the number.
class Quantized_layout
{
public:
  // Empties the T-meshes of the patches that are filled.
  Quantized_layout(const Cut_surface& surface, const Surface_embedding& embedding, const std::vector<int>& index,
                   const Feature_network& features, std::vector<T_mesh>& t_meshes, const double target_edge_length,
                   const Quad_targets& targets)
    : m_surface(surface), m_embedding(embedding), m_index(index), m_features(features), m_t_meshes(t_meshes)
    , m_target_edge_length(target_edge_length), m_targets(targets)
    , m_bends(surface, measured_surface(), embedding, features)
  {
    for(const T_mesh& t_mesh : t_meshes)
      m_demands.sources.push_back(t_mesh.cells.empty() ? Patch_source::FILLING : Patch_source::T_MESH);
    m_demands.ignores_bends.assign(features.arcs.size(), 0);

    follow_arcs_within(tolerance_of_edge_length());
  }

  // How far sides of quads may be from the arcs, in the unit of `Cut_surface::length`; where the caller gives sizes, in
  // that of the lengths of the sized surface.
  double arc_tolerance() const { return m_bends.tolerance(); }

  const std::vector<double>& tolerance_of_arc() const { return m_bends.tolerance_of_arc(); } // in the unit of lengths

  // Sets this tolerance and starts over: all wanted numbers of edges count again and no bound is raised, but patches
  // that were given up stay so.
  void follow_arcs_within(const double tolerance)
  {
    m_bends.follow_within(tolerance);
    m_demands.number_of_edges = m_targets.number_of_edges;
    reset_bounds();
  }

  // Makes all wanted edge lengths `factor` times as long and starts over as `follow_arcs_within()` does.
  void scale_edge_lengths(const double factor)
  {
    m_target_edge_length *= factor;
    for(double& edge_length : m_targets.edge_length)
      edge_length *= factor;
    follow_arcs_within(tolerance_of_edge_length());
  }

  double edge_length_of(const int patch) const
  {
    return m_targets.edge_length.empty() ? m_target_edge_length : m_targets.edge_length[patch];
  }

  const std::vector<Patch_source>& sources() const { return m_demands.sources; } // per patch
  const Arc_sides& sides() const { return m_sides; }
  int unknown_of_piece(const int patch, const int piece) const { return m_layout.edge_of_piece(patch, piece); }
  int patch_of_piece(const int unknown) const { return m_layout.patch_of_piece(unknown); }
  int value(const int unknown) const { return m_value[unknown]; }

  bool has_fillings() const { return std::count(sources().begin(), sources().end(), Patch_source::FILLING) > 0; }

  bool has_only_split_triangles() const
  {
    return std::all_of(sources().begin(), sources().end(), [](const Patch_source source)
                       { return source == Patch_source::SPLIT_TRIANGLES; });
  }

  std::vector<int> edges_of_arc() const
  {
    return std::vector<int>(m_value.begin(), m_value.begin() + static_cast<std::ptrdiff_t>(m_features.arcs.size()));
  }

  std::vector<std::vector<int> > edges_of_piece() const
  {
    std::vector<std::vector<int> > result(m_t_meshes.size());
    for(std::size_t patch = 0; patch < m_t_meshes.size(); ++patch)
    {
      const auto first = m_value.begin() + m_layout.first_piece[patch];
      result[patch].assign(first, first + static_cast<std::ptrdiff_t>(m_t_meshes[patch].pieces.size()));
    }
    return result;
  }

  // The breakpoints of each arc, or fewer, of a larger tolerance, where the arc has fewer vertices than breakpoints.
  std::vector<std::vector<int> > attainable_breakpoints() const
  {
    return m_bends.attainable_breakpoints(m_value, tolerance_of_edge_length());
  }

  // Finds values within the bounds, and gives up demands until there are some.
  void quantize()
  {
    for(;;)
    {
      if(!m_quantizer)
        m_quantizer.emplace(m_layout.network, quantization_options());
      const Quantization quantization = m_quantizer->run();
      m_value = quantization.value;
      if(quantization.is_feasible)
        return;
      std::vector<int> blocked = quantization.unattainable;
      blocked.insert(blocked.end(), quantization.conflicting.begin(), quantization.conflicting.end());
      if(ignore_bends(blocked, m_demands) || release_blocked_arc(m_layout.network, blocked, m_demands))
        reset_bounds();
      else if(!lower_raised_bounds(blocked))
        give_up_blocked_patch(!quantization.unattainable.empty(), blocked);
    }
  }

  // Raises the bound of an unknown, unless it was found that it cannot be raised. Returns whether it was lower.
  bool raise(const int unknown, const int bound)
  {
    int& lower_bound = m_layout.network.edges[unknown].lower_bound;
    if(m_cannot_be_raised[unknown] || lower_bound >= bound)
      return false;
    lower_bound = bound;
    return true;
  }

  // Gives at least one edge to the longest of the pieces that can have one, or to all of them. Returns whether any can.
  bool raise_longest(const std::vector<int>& unknowns, const bool raises_all)
  {
    int longest = -1;
    for(const int e : unknowns)
      if(!m_cannot_be_raised[e]
         && (longest < 0 || m_layout.network.edges[e].target > m_layout.network.edges[longest].target))
        longest = e;
    for(const int e : unknowns)
      if(e == longest || (raises_all && !m_cannot_be_raised[e]))
        require(e, 1);
    return longest >= 0;
  }

  // Raises the bound of an unknown in any case.
  void require(const int unknown, const int bound)
  {
    int& lower_bound = m_layout.network.edges[unknown].lower_bound;
    lower_bound = (std::max)(lower_bound, bound);
  }

  // The smallest patch without whose T-mesh one of these pieces can have an edge. It need not be the patch of the
  // pieces: a rectangle beside it has equal numbers on opposite sides, and a piece may be the difference of these arcs.
  // If none helps, the patch of the first piece.
  int patch_that_empties(const std::vector<int>& pieces) const
  {
    int result = -1;
    for(const int e : pieces)
    {
      T_mesh_network layout = m_layout;
      layout.network.edges[e].lower_bound = 1;
      const int patch = patch_that_blocks(m_surface, layout, sources());
      if(patch >= 0
         && (result < 0 || m_surface.patches[patch].faces.size() < m_surface.patches[result].faces.size()))
        result = patch;
    }
    return result < 0 ? m_layout.patch_of_piece(pieces.front()) : result;
  }

  void forbid_empty_pieces()
  {
    m_demands.forbids_empty_pieces = true;
    reset_bounds();
  }

  // Gives up the numbers that are wanted on the arcs of a patch; if there are none, its T-mesh; if it has none, its
  // filling.
  void give_up(const int patch)
  {
    if(!release_arcs_of_patch(m_sides, patch, m_demands))
    {
      m_t_meshes[patch] = T_mesh();
      Patch_source& source = m_demands.sources[patch];
      source = source == Patch_source::T_MESH ? Patch_source::FILLING : Patch_source::SPLIT_TRIANGLES;
    }
    reset_bounds();
  }

  void split_all_triangles()
  {
    m_t_meshes.assign(m_t_meshes.size(), T_mesh());
    m_demands.sources.assign(m_demands.sources.size(), Patch_source::SPLIT_TRIANGLES);
    reset_bounds();
  }

private:
  // Makes the network anew, as the unknowns depend on which patches have T-meshes. This drops all raised bounds.
  void reset_bounds()
  {
    m_sides = collect_arc_sides(m_surface, m_embedding, m_features, m_t_meshes);
    release_arcs_of_fillings(m_embedding, m_features, m_sides, m_demands);
    if(!m_demands.has_fixed_arcs())
      m_demands.ignores_bends.assign(m_demands.ignores_bends.size(), 0);
    const std::vector<double> edge_length(m_t_meshes.size(), m_target_edge_length);
    m_layout =
      t_mesh_network(measured_surface(), m_features, m_t_meshes, { edge_length, m_demands.number_of_edges });
    bound_pieces(m_surface, m_index, m_t_meshes, m_demands, m_layout);
    bound_arcs(m_bends, m_demands, m_layout);
    bound_arcs_of_fillings(m_embedding, m_features, m_sides, m_demands.sources, m_layout);
    m_quantizer.reset();
    m_cannot_be_raised.assign(m_layout.network.edges.size(), 0);
  }

  // A twentieth of the usual steps of the search. There are several rounds, and a longer search hardly finds anything
  // better; on networks where it does not finish, the usual one would take most of the time of all stages.
  static Quantization_options quantization_options()
  {
    Quantization_options options;
    options.maximum_number_of_steps /= 20;
    return options;
  }

  // Lets pieces be empty again whose raised bounds are among those without a solution. Returns whether there are any.
  bool lower_raised_bounds(const std::vector<int>& blocked)
  {
    bool is_any_lowered = false;
    for(const int e : blocked)
      if(m_layout.is_piece(e) && m_layout.network.edges[e].lower_bound > 0 && !m_demands.forbids_empty_pieces)
      {
        m_layout.network.edges[e].lower_bound = 0;
        m_cannot_be_raised[e] = 1;
        is_any_lowered = true;
      }
    return is_any_lowered;
  }

  // Gives up the patch that makes unknowns 0 in every solution; if none does, the smallest patch at an unknown without
  // a solution; and if there is none, all patches.
  void give_up_blocked_patch(const bool has_unattainable, const std::vector<int>& blocked)
  {
    int patch = has_unattainable ? patch_that_blocks(m_surface, m_layout, sources()) : -1;
    if(patch < 0)
      patch = smallest_blocked_patch(m_surface, m_layout, m_sides, sources(), blocked);
    if(patch >= 0)
      give_up(patch);
    else
      split_all_triangles();
  }

  const Cut_surface& measured_surface() const
  {
    return m_targets.sized_surface != nullptr ? *m_targets.sized_surface : m_surface;
  }

  double tolerance_of_edge_length() const { return Arc_bends::part_of_edge_length * m_target_edge_length; }

  const Cut_surface& m_surface;
  const Surface_embedding& m_embedding;
  const std::vector<int>& m_index;
  const Feature_network& m_features;
  std::vector<T_mesh>& m_t_meshes;
  double m_target_edge_length;
  Quad_targets m_targets;
  Arc_bends m_bends;
  Layout_demands m_demands;
  Arc_sides m_sides;
  T_mesh_network m_layout;
  std::optional<Quantizer> m_quantizer; // of the network of the layout
  std::vector<char> m_cannot_be_raised; // per unknown: with its bound at 1 there is no solution
  std::vector<int> m_value;             // per unknown
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUANTIZED_LAYOUT_H
