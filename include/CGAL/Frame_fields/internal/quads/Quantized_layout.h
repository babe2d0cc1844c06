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
#include <CGAL/Frame_fields/internal/layout/arc_breakpoints.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/fill_patch.h>
#include <CGAL/Frame_fields/internal/quantization/Quantizer.h>
#include <CGAL/Frame_fields/internal/quantization/group_to_free.h>
#include <CGAL/Frame_fields/internal/quantization/t_mesh_network.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
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
    , m_target_edge_length(target_edge_length), m_targets(targets), m_ignores_bends(features.arcs.size(), 0)
  {
    for(const T_mesh& t_mesh : t_meshes)
      m_sources.push_back(t_mesh.cells.empty() ? Patch_source::FILLING : Patch_source::T_MESH);

    follow_arcs_within(part_of_edge_length * target_edge_length);
  }

  // How far sides of quads may be from the arcs, in the unit of `Cut_surface::length`; where the caller gives sizes, in
  // that of the lengths of the sized surface.
  double arc_tolerance() const { return m_arc_tolerance; }

  const std::vector<double>& tolerance_of_arc() const { return m_tolerance_of_arc; } // in the unit of the lengths

  // Sets this tolerance and starts over: all wanted numbers of edges count again and no bound is raised, but patches
  // that were given up stay so. The tolerance of an arc is also bounded by a small part of its length, as no side is
  // longer than its arc.
  void follow_arcs_within(const double tolerance)
  {
    m_arc_tolerance = tolerance;
    m_breakpoints.clear();
    m_tolerance_of_arc.clear();
    for(const Feature_arc& arc : m_features.arcs)
    {
      double arc_length = 0, sized_length = 0;
      for(const int h : arc.halfedges)
      {
        arc_length += m_surface.length[h];
        sized_length += measured_surface().length[h];
      }
      m_tolerance_of_arc.push_back((std::min)(tolerance * (arc_length / sized_length),
                                              part_of_edge_length * arc_length));
      m_breakpoints.push_back(arc_breakpoints(m_embedding, arc, source_vertices(arc), m_tolerance_of_arc.back()));
    }
    m_number_of_edges = m_targets.number_of_edges;
    reset_bounds();
  }

  // Makes all wanted edge lengths `factor` times as long and starts over as `follow_arcs_within()` does.
  void scale_edge_lengths(const double factor)
  {
    m_target_edge_length *= factor;
    for(double& edge_length : m_targets.edge_length)
      edge_length *= factor;
    follow_arcs_within(part_of_edge_length * m_target_edge_length);
  }

  double edge_length_of(const int patch) const
  {
    return m_targets.edge_length.empty() ? m_target_edge_length : m_targets.edge_length[patch];
  }

  const std::vector<Patch_source>& sources() const { return m_sources; } // per patch
  const Arc_sides& sides() const { return m_sides; }
  int unknown_of_piece(const int patch, const int piece) const { return m_layout.edge_of_piece(patch, piece); }
  int value(const int unknown) const { return m_value[unknown]; }

  bool has_fillings() const { return std::count(m_sources.begin(), m_sources.end(), Patch_source::FILLING) > 0; }

  bool has_only_split_triangles() const
  {
    return std::all_of(m_sources.begin(), m_sources.end(), [](const Patch_source source)
                       { return source == Patch_source::SPLIT_TRIANGLES; });
  }

  std::vector<int> edges_of_arc() const
  {
    return std::vector<int>(m_value.begin(), m_value.begin() + number_of_arcs());
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
    std::vector<std::vector<int> > result = m_breakpoints;
    for(std::size_t a = 0; a < result.size(); ++a)
    {
      const std::size_t number = m_value[a] - (m_features.arcs[a].is_loop ? 0 : 1);
      double tolerance = part_of_edge_length * m_target_edge_length;
      while(result[a].size() > number)
      {
        tolerance *= 2;
        result[a] = arc_breakpoints(m_embedding, m_features.arcs[a], source_vertices(m_features.arcs[a]), tolerance);
      }
    }
    return result;
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
      if(!ignore_bends(blocked) && !release_blocked_arc(blocked) && !lower_raised_bounds(blocked)
         && (quantization.unattainable.empty() || !give_up_patch_that_blocks()))
        give_up_blocked_patch(blocked);
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

  void forbid_empty_pieces()
  {
    m_forbids_empty_pieces = true;
    reset_bounds();
  }

  // Gives up the numbers that are wanted on the arcs of a patch; if there are none, its T-mesh; if it has none, its
  // filling.
  void give_up(const int patch)
  {
    if(release_arcs_of(patch))
    {
      reset_bounds();
      return;
    }
    m_t_meshes[patch] = T_mesh();
    m_sources[patch] = m_sources[patch] == Patch_source::T_MESH ? Patch_source::FILLING
                                                                : Patch_source::SPLIT_TRIANGLES;
    reset_bounds();
  }

  void split_all_triangles()
  {
    m_t_meshes.assign(m_t_meshes.size(), T_mesh());
    m_sources.assign(m_sources.size(), Patch_source::SPLIT_TRIANGLES);
    reset_bounds();
  }

  int patch_of_piece(const int unknown) const
  {
    // Patches without pieces have the same first unknown as the patch after them.
    const auto after = std::upper_bound(m_layout.first_piece.begin(), m_layout.first_piece.end(), unknown);
    return static_cast<int>(after - m_layout.first_piece.begin()) - 1;
  }

  // A tolerance that is hardly seen, over the length of edges.
  static constexpr double part_of_edge_length = 0.02;

private:
  // Makes the network anew, as the unknowns depend on which patches have T-meshes. This drops all raised bounds.
  void reset_bounds()
  {
    m_sides = collect_arc_sides(m_surface, m_embedding, m_features, m_t_meshes);
    release_arcs_of_fillings();
    m_has_fixed_arcs =
      std::any_of(m_number_of_edges.begin(), m_number_of_edges.end(), [](const int n) { return n > 0; });
    if(!m_has_fixed_arcs)
      m_ignores_bends.assign(m_ignores_bends.size(), 0);
    const std::vector<double> edge_length(m_t_meshes.size(), m_target_edge_length);
    m_layout = t_mesh_network(measured_surface(), m_features, m_t_meshes, { edge_length, m_number_of_edges });
    m_quantizer.reset();
    m_cannot_be_raised.assign(m_layout.network.edges.size(), 0);
    for(std::size_t patch = 0; patch < m_t_meshes.size(); ++patch)
      for(std::size_t piece = 0; piece < m_t_meshes[patch].pieces.size(); ++piece)
      {
        Bidirected_edge& edge = m_layout.network.edges[m_layout.first_piece[patch] + piece];
        const bool needs_edge = m_forbids_empty_pieces
                                || separates_critical_vertices(m_t_meshes[patch], m_t_meshes[patch].pieces[piece]);
        edge.lower_bound = (std::max)(needs_edge ? 1 : 0, least_count(edge.target));
      }
    for(std::size_t a = 0; a < m_features.arcs.size(); ++a)
    {
      if(is_fixed(a))
        continue;
      int& bound = m_layout.network.edges[a].lower_bound;
      if(m_ignores_bends[a])
        continue;
      const int least_at_bends = static_cast<int>(m_breakpoints[a].size()) + (m_features.arcs[a].is_loop ? 0 : 1);
      bound = (std::max)({ bound, least_at_bends, least_count(m_layout.network.edges[a].target) });
    }
    bound_arcs_of_other_patches();
  }

  // The least number of edges of a piece or arc. The quadratic costs rate half of the wanted number no worse than one
  // and a half times it. So no edge may be longer than about twice the wanted length, unless the caller fixes numbers.
  int least_count(const double target) const
  {
    const double largest_count = 1e8;
    if(m_has_fixed_arcs)
      return 0;
    return static_cast<int>((std::min)(largest_count, target / 2));
  }

  // Whether a piece would join two vertices that must not coincide if it got no edge. Of chains of pieces, only the
  // rounds can tell.
  bool separates_critical_vertices(const T_mesh& t_mesh, const T_mesh_piece& piece) const
  {
    const auto is_critical_node = [&](const int n)
    {
      const T_mesh_node& node = t_mesh.nodes[n];
      return node.halfedge >= 0
          || (node.sector >= 0 && (m_surface.is_constrained_sector(node.sector) || m_index[node.sector] != 0));
    };
    return piece.halfedge < 0 && is_critical_node(piece.source) && is_critical_node(piece.target);
  }

  // The fillings need a few edges on each of their arcs; split triangles have two for each edge of the mesh.
  void bound_arcs_of_other_patches()
  {
    for(std::size_t a = 0; a < m_features.arcs.size(); ++a)
    {
      Bidirected_edge& edge = m_layout.network.edges[a];
      for(const Arc_side& side : m_sides[a])
        if(side.patch >= 0 && m_sources[side.patch] == Patch_source::FILLING)
          edge.lower_bound = (std::max)(edge.lower_bound, smallest_even_count(m_embedding, m_features.arcs[a]));
      if(is_beside_split_patch(m_sides, m_sources, static_cast<int>(a)))
        edge.lower_bound = edge.upper_bound = 2 * static_cast<int>(m_features.arcs[a].halfedges.size());
    }
  }

  // A twentieth of the usual steps of the search. There are several rounds, and a longer search hardly finds anything
  // better; on networks where it does not finish, the usual one would take most of the time of all stages.
  static Quantization_options quantization_options()
  {
    Quantization_options options;
    options.maximum_number_of_steps /= 20;
    return options;
  }

  bool is_fixed(const std::size_t arc) const { return !m_number_of_edges.empty() && m_number_of_edges[arc] > 0; }

  // Gives up wanted numbers that no filling takes, as they are odd or too small, and all beside split triangles.
  void release_arcs_of_fillings()
  {
    for(std::size_t a = 0; a < m_features.arcs.size(); ++a)
      for(const Arc_side& side : m_sides[a])
        if(is_fixed(a) && side.patch >= 0 && m_sources[side.patch] != Patch_source::T_MESH
           && (m_sources[side.patch] == Patch_source::SPLIT_TRIANGLES || m_number_of_edges[a] % 2 != 0
               || m_number_of_edges[a] < smallest_even_count(m_embedding, m_features.arcs[a])))
          m_number_of_edges[a] = 0;
  }

  bool release_arcs_of(const int patch)
  {
    bool is_any_released = false;
    for(std::size_t a = 0; a < m_features.arcs.size(); ++a)
      for(const Arc_side& side : m_sides[a])
        if(is_fixed(a) && side.patch == patch)
        {
          m_number_of_edges[a] = 0;
          is_any_released = true;
        }
    return is_any_released;
  }

  // If any numbers are wanted, lets the other arcs among the unknowns without a solution have fewer edges than bends.
  // Returns whether there are any.
  bool ignore_bends(const std::vector<int>& blocked)
  {
    bool is_any_ignored = false;
    if(m_has_fixed_arcs)
      for(const int e : blocked)
        if(e < number_of_arcs() && !is_fixed(e) && !m_ignores_bends[e])
          m_ignores_bends[e] = is_any_ignored = true;
    if(is_any_ignored)
      reset_bounds();
    return is_any_ignored;
  }

  // Of the wanted numbers among the unknowns without a solution, gives up the one that is farthest from what the length
  // of its arc asks for. Returns whether there is one.
  bool release_blocked_arc(const std::vector<int>& blocked)
  {
    int farthest = -1;
    const auto ratio = [&](const int arc)
    {
      const double number = m_number_of_edges[arc], target = (std::max)(1e-3, m_layout.network.edges[arc].target);
      return (std::max)(number / target, target / number);
    };
    for(const int e : blocked)
      if(e < number_of_arcs() && is_fixed(e) && (farthest < 0 || ratio(e) > ratio(farthest)))
        farthest = e;
    if(farthest < 0)
      return false;
    m_number_of_edges[farthest] = 0;
    reset_bounds();
    return true;
  }

  // Lets pieces be empty again whose raised bounds are among those without a solution. Returns whether there are any.
  bool lower_raised_bounds(const std::vector<int>& blocked)
  {
    bool is_any_lowered = false;
    for(const int e : blocked)
      if(is_piece(e) && m_layout.network.edges[e].lower_bound > 0 && !m_forbids_empty_pieces)
      {
        m_layout.network.edges[e].lower_bound = 0;
        m_cannot_be_raised[e] = 1;
        is_any_lowered = true;
      }
    return is_any_lowered;
  }

  // Gives up the T-mesh without which the fewest unknowns are 0 in every solution, of the smallest patch of several.
  // It need not be beside any of them: a strip around the whole model may be cut anywhere. Returns whether there is one
  // that makes them fewer.
  bool give_up_patch_that_blocks()
  {
    const std::int64_t maximum_number_of_steps = 20000000;
    std::vector<int> patches;
    for(std::size_t patch = 0; patch < m_sources.size(); ++patch)
      if(m_sources[patch] == Patch_source::T_MESH)
        patches.push_back(static_cast<int>(patch));
    std::stable_sort(patches.begin(), patches.end(), [&](const int p, const int q)
                     { return m_surface.patches[p].faces.size() < m_surface.patches[q].faces.size(); });
    std::vector<Index_range> groups;
    for(const int patch : patches)
      groups.push_back(m_layout.cell_nodes[patch]);
    const int group = group_to_free(m_layout.network, groups, maximum_number_of_steps);
    if(group >= 0)
      give_up(patches[group]);
    return group >= 0;
  }

  // Of the patches that have, or whose arcs have, unknowns without a solution, gives up the smallest with a T-mesh, or
  // the smallest filling; if there are none, all.
  void give_up_blocked_patch(const std::vector<int>& blocked)
  {
    int smallest = -1;
    const auto key = [&](const int patch)
    {
      return std::make_pair(m_sources[patch], m_surface.patches[patch].faces.size());
    };
    const auto consider = [&](const int patch)
    {
      if(patch >= 0 && m_sources[patch] != Patch_source::SPLIT_TRIANGLES
         && (smallest < 0 || key(patch) < key(smallest)))
        smallest = patch;
    };
    for(const int e : blocked)
      if(is_piece(e))
        consider(patch_of_piece(e));
      else if(e < number_of_arcs())
        for(const Arc_side& side : m_sides[e])
          consider(side.patch);
    if(smallest >= 0)
      give_up(smallest);
    else
      split_all_triangles();
  }

  // The unknowns are those of `T_mesh_network`: the arcs, the pieces, and half the numbers of arcs at fillings.
  int number_of_arcs() const { return static_cast<int>(m_features.arcs.size()); }
  bool is_piece(const int unknown) const
  {
    return unknown >= number_of_arcs()
        && unknown < m_layout.first_piece.back() + static_cast<int>(m_t_meshes.back().pieces.size());
  }

  std::vector<int> source_vertices(const Feature_arc& arc) const
  {
    std::vector<int> result;
    for(const int h : arc.halfedges)
      result.push_back(m_embedding.vertex[previous_of(h)]);
    return result;
  }

  const Cut_surface& measured_surface() const
  {
    return m_targets.sized_surface != nullptr ? *m_targets.sized_surface : m_surface;
  }

  const Cut_surface& m_surface;
  const Surface_embedding& m_embedding;
  const std::vector<int>& m_index;
  const Feature_network& m_features;
  std::vector<T_mesh>& m_t_meshes;
  double m_target_edge_length;
  double m_arc_tolerance = 0;
  Quad_targets m_targets;
  std::vector<int> m_number_of_edges;           // per arc: what is wanted and not given up, 0 if it is free; or empty
  bool m_has_fixed_arcs = false;
  std::vector<char> m_ignores_bends;            // per arc
  std::vector<Patch_source> m_sources;          // per patch
  bool m_forbids_empty_pieces = false;
  Arc_sides m_sides;
  std::vector<double> m_tolerance_of_arc;       // per arc, in the unit of the lengths
  std::vector<std::vector<int> > m_breakpoints; // per arc: the places where it must have a vertex
  T_mesh_network m_layout;
  std::optional<Quantizer> m_quantizer; // of the network of the layout
  std::vector<char> m_cannot_be_raised; // per unknown: with its bound at 1 there is no solution
  std::vector<int> m_value;             // per unknown
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUANTIZED_LAYOUT_H
