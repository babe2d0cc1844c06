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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_CONTRACTED_NETWORK_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_CONTRACTED_NETWORK_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/network_components.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A network without the nodes that only make the values of two edges equal, as most nodes of T-meshes do. A chain of
// edges between such nodes becomes one edge, whose cost is the sum of the costs of the chain up to a constant. The
// given network must outlive this one.
class Contracted_network
{
public:
  explicit Contracted_network(const Bidirected_network& network)
    : m_given(network), m_ends_of_node(2 * static_cast<std::size_t>(network.number_of_nodes), -1)
    , m_number_of_ends(network.number_of_nodes, 0), m_chain(network.edges.size(), -1)
  {
    for(std::size_t e = 0; e < network.edges.size(); ++e)
      for(int end = 0; end < 2; ++end)
        if(network.edges[e].node[end] >= 0)
          note_end(network.edges[e].node[end], 2 * static_cast<int>(e) + end);
    m_network.number_of_nodes = network.number_of_nodes;
    for(int end = 0; end < 2 * static_cast<int>(network.edges.size()); ++end)
      if(m_chain[end / 2] < 0 && next_end(end) < 0)
        add_chain(end);
    for(int end = 0; end < 2 * static_cast<int>(network.edges.size()); end += 2)
      if(m_chain[end / 2] < 0)
        add_chain(end);
    update_bounds();
    set_targets();
  }

  // The bounds of a chain are the tightest ones of its edges. Its lower bound may exceed its upper bound.
  void update_bounds()
  {
    for(Bidirected_edge& chain : m_network.edges)
    {
      chain.lower_bound = (std::numeric_limits<int>::min)();
      chain.upper_bound = (std::numeric_limits<int>::max)();
    }
    for(std::size_t e = 0; e < m_chain.size(); ++e)
    {
      Bidirected_edge& chain = m_network.edges[m_chain[e]];
      chain.lower_bound = (std::max)(chain.lower_bound, m_given.edges[e].lower_bound);
      chain.upper_bound = (std::min)(chain.upper_bound, m_given.edges[e].upper_bound);
    }
  }

  const Bidirected_network& network() const { return m_network; }

  // The edge that has the value of a given edge.
  int chain(const int edge) const { return m_chain[edge]; }

  // Whether a given edge has the lower bound or the finite upper bound of its chain. Other edges do not restrict it.
  bool bounds_its_chain(const int e) const
  {
    const Bidirected_edge& edge = m_given.edges[e];
    const Bidirected_edge& chain = m_network.edges[m_chain[e]];
    return edge.lower_bound == chain.lower_bound
        || (edge.upper_bound == chain.upper_bound && edge.upper_bound < (std::numeric_limits<int>::max)());
  }

private:
  void note_end(const int node, const int end)
  {
    if(m_number_of_ends[node] < 2)
      m_ends_of_node[2 * static_cast<std::size_t>(node) + m_number_of_ends[node]] = end;
    ++m_number_of_ends[node];
  }

  // The other end at the node of an end, if the node makes the values of both edges equal; otherwise -1.
  int next_end(const int end) const
  {
    const int node = m_given.edges[end / 2].node[end % 2];
    if(node < 0 || m_number_of_ends[node] != 2)
      return -1;
    const std::size_t place = 2 * static_cast<std::size_t>(node);
    const int other = m_ends_of_node[place] == end ? m_ends_of_node[place + 1] : m_ends_of_node[place];
    const bool is_equation = other / 2 != end / 2
                             && m_given.edges[other / 2].sign[other % 2] != m_given.edges[end / 2].sign[end % 2];
    return is_equation ? other : -1;
  }

  // Adds the chain that begins with an end. A chain that closes at its beginning has no nodes.
  void add_chain(const int begin)
  {
    const int number = static_cast<int>(m_network.edges.size());
    int end = begin;
    for(;;)
    {
      m_chain[end / 2] = number;
      end ^= 1;
      const int next = next_end(end);
      if(next < 0 || next == begin)
        break;
      end = next;
    }
    Bidirected_edge chain;
    chain.node = { m_given.edges[begin / 2].node[begin % 2], m_given.edges[end / 2].node[end % 2] };
    chain.sign = { m_given.edges[begin / 2].sign[begin % 2], m_given.edges[end / 2].sign[end % 2] };
    if(next_end(begin) >= 0)
      chain.node = { -1, -1 };
    m_network.edges.push_back(chain);
  }

  void set_targets()
  {
    for(Bidirected_edge& chain : m_network.edges)
      chain.target = chain.weight = 0;
    for(std::size_t e = 0; e < m_chain.size(); ++e)
    {
      const Bidirected_edge edge = finite_edge(m_given.edges[e]);
      Bidirected_edge& chain = m_network.edges[m_chain[e]];
      chain.weight += edge.weight;
      chain.target += edge.weight * edge.target;
    }
    for(Bidirected_edge& chain : m_network.edges)
      chain.target /= chain.weight;
  }

  const Bidirected_network& m_given;
  Bidirected_network m_network;
  std::vector<int> m_ends_of_node;   // per node: the first two ends at it, as 2 * edge + end
  std::vector<int> m_number_of_ends; // per node
  std::vector<int> m_chain;          // per given edge
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_CONTRACTED_NETWORK_H
