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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_T_MESH_NETWORK_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_T_MESH_NETWORK_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The numbers of quads along all pieces of T-meshes and along all arcs, as the unknowns of a network. First come the
// arcs, then the pieces of one patch after the other. Then comes half the number of an arc, once for each side of it on
// a patch without T-mesh.
struct T_mesh_network
{
  Bidirected_network network;
  std::vector<int> first_piece;        // per patch: the edge of its piece 0; then the edge after the last piece
  std::vector<Index_range> cell_nodes; // per patch: the nodes of its cells

  int edge_of_arc(const int arc) const { return arc; }
  int edge_of_piece(const int patch, const int piece) const { return first_piece[patch] + piece; }
  bool is_arc(const int edge) const { return edge < first_piece.front(); }
  bool is_piece(const int edge) const { return edge >= first_piece.front() && edge < first_piece.back(); }

  int patch_of_piece(const int edge) const
  {
    // Patches without pieces have the same first edge as the patch after them.
    const auto after = std::upper_bound(first_piece.begin(), first_piece.end(), edge);
    return static_cast<int>(after - first_piece.begin()) - 1;
  }
};

// What the user wants of the numbers of quads.
struct Edge_length_targets
{
  std::vector<double> edge_length;  // per patch, in the unit of `Cut_surface::length`
  std::vector<int> number_of_edges; // per arc: the number that it must get, 0 if it is free; empty if all are
};

// Makes the network: in each cell, opposite sides have equal sums; the pieces on each side of an arc have the number of
// the arc as their sum. So T-nodes on one side need not match those on the other. A patch whose T-mesh is empty is
// filled without one, which takes any even numbers on its arcs.
class T_mesh_network_builder
{
public:
  T_mesh_network_builder(const Cut_surface& surface, const Feature_network& features,
                         const std::vector<T_mesh>& t_meshes, const Edge_length_targets& targets)
    : m_surface(surface), m_features(features), m_t_meshes(t_meshes), m_targets(targets)
  {}

  T_mesh_network run()
  {
    collect_sides();
    add_arcs();
    for(std::size_t patch = 0; patch < m_t_meshes.size(); ++patch)
      add_t_mesh(static_cast<int>(patch));
    m_result.first_piece.push_back(static_cast<int>(m_result.network.edges.size()));
    add_even_arcs();
    return m_result;
  }

private:
  enum Side_kind { NO_SIDE, PIECES, EVEN };

  struct Side
  {
    Side_kind kind = NO_SIDE;
    int patch = -1;
    int node = -1;
  };

  int add_node() { return m_result.network.number_of_nodes++; }

  // An edge without ends yet; `length` is in space.
  void add_edge(const double length, const double edge_length, const double factor, const int lower_bound)
  {
    Bidirected_edge edge;
    edge.node = { -1, -1 };
    edge.sign = { 1, 1 };
    edge.target = length / edge_length;
    edge.weight = factor / (std::max)(1., edge.target);
    edge.lower_bound = lower_bound;
    m_result.network.edges.push_back(edge);
  }

  void collect_sides()
  {
    m_sides.resize(m_features.arcs.size());
    for(std::size_t patch = 0; patch < m_t_meshes.size(); ++patch)
    {
      const Index_range& faces = m_surface.patches[patch].faces;
      for(int halfedge = 3 * faces.begin_index; halfedge < 3 * faces.end_index; ++halfedge)
        if(m_features.arc[halfedge] >= 0)
        {
          Side& side = m_sides[m_features.arc[halfedge]][side_of_arc(m_features, halfedge)];
          if(side.kind != NO_SIDE)
            continue;
          side.kind = m_t_meshes[patch].cells.empty() ? EVEN : PIECES;
          side.patch = static_cast<int>(patch);
          side.node = add_node();
        }
    }
  }

  // The edge length of an arc is that of its patch, or the geometric mean of those of its two patches.
  double edge_length_of_arc(const std::size_t arc) const
  {
    double product = 1;
    int number_of_sides = 0;
    for(const Side& side : m_sides[arc])
      if(side.patch >= 0)
      {
        product *= m_targets.edge_length[side.patch];
        ++number_of_sides;
      }
    return number_of_sides == 2 ? std::sqrt(product) : product;
  }

  void add_arcs()
  {
    const double weight_factor = 2;
    for(std::size_t a = 0; a < m_features.arcs.size(); ++a)
    {
      const Feature_arc& arc = m_features.arcs[a];
      double length = 0;
      for(const int halfedge : arc.halfedges)
        length += m_surface.length[halfedge];
      add_edge(length, edge_length_of_arc(a), weight_factor, arc.is_loop ? 3 : 1);
      Bidirected_edge& edge = m_result.network.edges.back();
      edge.node = { m_sides[a][0].node, m_sides[a][1].node };
      edge.sign = { -1, -1 };
      if(!m_targets.number_of_edges.empty() && m_targets.number_of_edges[a] > 0)
        edge.lower_bound = edge.upper_bound = m_targets.number_of_edges[a];
    }
  }

  // Puts an end of an edge that is free so far at a node.
  void attach(const int edge, const int end, const int node, const int sign)
  {
    m_result.network.edges[edge].node[end] = node;
    m_result.network.edges[edge].sign[end] = sign;
  }

  void add_t_mesh(const int patch)
  {
    const T_mesh& t_mesh = m_t_meshes[patch];
    m_result.first_piece.push_back(static_cast<int>(m_result.network.edges.size()));
    std::vector<int> number_of_ends(t_mesh.pieces.size(), 0);
    for(std::size_t i = 0; i < t_mesh.pieces.size(); ++i)
    {
      const T_mesh_piece& piece = t_mesh.pieces[i];
      add_edge(piece.length, m_targets.edge_length[patch], 1, 1);
      if(piece.halfedge >= 0)
      {
        const Side& side = m_sides[m_features.arc[piece.halfedge]][side_of_arc(m_features, piece.halfedge)];
        attach(m_result.edge_of_piece(patch, static_cast<int>(i)), number_of_ends[i]++, side.node, 1);
      }
    }
    const int first_node = m_result.network.number_of_nodes;
    for(const T_mesh_cell& cell : t_mesh.cells)
    {
      const std::array<int, 2> node = { add_node(), add_node() };
      for(int side = 0; side < 4; ++side)
        for(const Directed_piece& directed : cell.sides[side])
          attach(m_result.edge_of_piece(patch, directed.piece), number_of_ends[directed.piece]++, node[side % 2],
                 side < 2 ? 1 : -1);
    }
    m_result.cell_nodes.push_back({ first_node, m_result.network.number_of_nodes });
  }

  // Makes the number of an arc even, as twice an integer: an edge with both ends at the node of the side.
  void add_even_arcs()
  {
    const double negligible_factor = 1e-6;
    for(std::size_t a = 0; a < m_sides.size(); ++a)
      for(const Side& side : m_sides[a])
        if(side.kind == EVEN)
        {
          const double half_target = m_result.network.edges[a].target / 2;
          add_edge(half_target, 1, negligible_factor, 1);
          const int edge = static_cast<int>(m_result.network.edges.size()) - 1;
          attach(edge, 0, side.node, 1);
          attach(edge, 1, side.node, 1);
        }
  }

  const Cut_surface& m_surface;
  const Feature_network& m_features;
  const std::vector<T_mesh>& m_t_meshes;
  const Edge_length_targets& m_targets;
  std::vector<std::array<Side, 2> > m_sides; // per arc
  T_mesh_network m_result;
};

// The network of T-meshes, one per patch and empty where there is none, in linear time.
inline T_mesh_network t_mesh_network(const Cut_surface& surface, const Feature_network& features,
                                     const std::vector<T_mesh>& t_meshes, const Edge_length_targets& targets)
{
  return T_mesh_network_builder(surface, features, t_meshes, targets).run();
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_T_MESH_NETWORK_H
