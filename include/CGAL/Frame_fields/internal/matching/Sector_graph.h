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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MATCHING_SECTOR_GRAPH_H
#define CGAL_FRAME_FIELDS_INTERNAL_MATCHING_SECTOR_GRAPH_H

#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The sectors of one patch as the nodes of a graph for `Convex_flow`, where a unit is an index of 1/4. The arcs are the
// unconstrained halfedges, each from the sector at its target to the one at its source: lowering p_ij by one moves a
// unit along the halfedge of face i. `push()` changes the matching only; the caller changes the indices at both ends of
// a path. Costs are those of sum w (r - omega)^2 for the given alpha. Each sector has bounds between which its 4 I may
// change; at first both are its present 4 I.
class Sector_graph
{
public:
  Sector_graph(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
               const std::vector<double>& alpha, std::vector<int>& matching, std::vector<int>& index)
    : m_surface(surface), m_patch(patch), m_omega(omega), m_alpha(alpha), m_matching(matching), m_index(index)
    , m_dual_edge_of(3 * static_cast<std::size_t>(patch.faces.size()), -1)
    , m_lower_bound(index.begin() + patch.sectors.begin_index, index.begin() + patch.sectors.end_index)
    , m_upper_bound(m_lower_bound)
  {
    for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    {
      m_dual_edge_of[local_halfedge(surface.dual_edges[e].halfedge)] = e;
      m_dual_edge_of[local_halfedge(surface.dual_edges[e].opposite)] = e;
    }
  }

  int& lower_bound(const int node) { return m_lower_bound[node]; }
  int& upper_bound(const int node) { return m_upper_bound[node]; }
  int& index(const int node) { return m_index[sector(node)]; }
  int index(const int node) const { return m_index[sector(node)]; }
  int sector(const int node) const { return m_patch.sectors.begin_index + node; }
  int node_of_sector(const int sector) const { return sector - m_patch.sectors.begin_index; }
  bool has_too_much(const int node) const { return index(node) > m_upper_bound[node]; }
  bool has_too_little(const int node) const { return index(node) < m_lower_bound[node]; }

  int number_of_nodes() const { return m_patch.sectors.size(); }

  template <typename Visit>
  void for_each_arc(const int node, const Visit& visit) const
  {
    for_each_corner(m_surface.opposite, m_surface.first_corner[sector(node)], [&](const int corner)
    {
      if(!m_surface.is_constrained(corner))
        visit(corner, node_of(m_surface.opposite[corner]));
    });
  }

  int reverse(const int halfedge) const { return m_surface.opposite[halfedge]; }
  int source(const int halfedge) const { return node_of(halfedge); }

  // The change of sum w (r - omega)^2 when one more unit moves along the halfedge, rounded to a multiple of 2^-30. That
  // is far above the rounding errors of alpha and far below the differences between costs. Symmetric models have paths
  // of equal cost; thanks to the rounding the same one is the cheapest whatever solver found alpha. Sums below 2^23 of
  // such multiples are exact.
  double cost(const int halfedge) const
  {
    const double scale = 1 << 30;
    const int e = m_dual_edge_of[local_halfedge(halfedge)];
    const double difference = rotation(m_surface, m_alpha, m_matching, e) - m_omega[e];
    const double signed_difference = is_first(halfedge, e) ? difference : -difference;
    const double change = m_surface.weight[e] * CGAL_PI * (CGAL_PI / 4 - signed_difference); // (x - pi/2)^2 - x^2
    return std::nearbyint(change * scale) / scale;
  }

  void push(const int halfedge)
  {
    const int e = m_dual_edge_of[local_halfedge(halfedge)];
    m_matching[e] += is_first(halfedge, e) ? -1 : 1;
  }

  bool has_room(const int node) const { return index(node) < m_upper_bound[node]; }
  bool has_spare(const int node) const { return index(node) > m_lower_bound[node]; }

private:
  int local_halfedge(const int halfedge) const { return halfedge - 3 * m_patch.faces.begin_index; }
  int node_of(const int corner) const { return node_of_sector(m_surface.sector[corner]); }
  bool is_first(const int halfedge, const int e) const { return m_surface.dual_edges[e].halfedge == halfedge; }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_omega;
  const std::vector<double>& m_alpha;
  std::vector<int>& m_matching;
  std::vector<int>& m_index;
  std::vector<int> m_dual_edge_of;               // per halfedge of the patch
  std::vector<int> m_lower_bound, m_upper_bound; // per node
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MATCHING_SECTOR_GRAPH_H
