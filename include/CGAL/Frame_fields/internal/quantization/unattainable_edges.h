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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_UNATTAINABLE_EDGES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_UNATTAINABLE_EDGES_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Double_cover.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The strongly connected components of the double cover (by Tarjan's algorithm without recursion). An arc may be passed
// forward if its edge can have a positive value, and backward if it can have a negative one.
class Strip_components
{
public:
  Strip_components(const Bidirected_network& network, const Double_cover& graph)
    : m_network(network), m_graph(graph), m_component(graph.number_of_nodes(), -1)
    , m_number(graph.number_of_nodes(), -1), m_lowest(graph.number_of_nodes()), m_next(graph.first_place)
  {
    for(int node = 0; node < graph.number_of_nodes(); ++node)
      if(m_number[node] < 0)
        search_from(node);
  }

  int component(const int node) const { return m_component[node]; }

private:
  // The node to which a place of the graph leads, -1 if the value may not have the sign for it.
  int neighbor(const int place) const
  {
    const int arc = m_graph.incident[place] / 2;
    const bool is_forward = m_graph.incident[place] % 2 == 0;
    const Bidirected_edge& edge = m_network.edges[arc / 2];
    if(is_forward ? edge.upper_bound <= 0 : edge.lower_bound >= 0)
      return -1;
    return is_forward ? m_graph.head[arc] : m_graph.tail[arc];
  }

  void enter(const int node)
  {
    m_number[node] = m_lowest[node] = m_count++;
    m_path.push_back(node);
    m_open.push_back(node);
  }

  void search_from(const int start)
  {
    enter(start);
    while(!m_path.empty())
    {
      const int node = m_path.back();
      if(m_next[node] < m_graph.first_place[node + 1])
      {
        const int other = neighbor(m_next[node]++);
        if(other >= 0 && m_number[other] < 0)
          enter(other);
        else if(other >= 0 && m_component[other] < 0)
          m_lowest[node] = (std::min)(m_lowest[node], m_number[other]);
      }
      else
        leave(node);
    }
  }

  void leave(const int node)
  {
    m_path.pop_back();
    if(!m_path.empty())
      m_lowest[m_path.back()] = (std::min)(m_lowest[m_path.back()], m_lowest[node]);
    if(m_lowest[node] < m_number[node])
      return;
    while(m_component[node] < 0)
    {
      m_component[m_open.back()] = node;
      m_open.pop_back();
    }
  }

  const Bidirected_network& m_network;
  const Double_cover& m_graph;
  std::vector<int> m_component;    // per node: the node of its component that was entered first
  std::vector<int> m_number;       // per node: when it was entered
  std::vector<int> m_lowest;       // per node: the lowest number that is known to be in its component
  std::vector<int> m_next;         // per node: its next place to look at
  std::vector<int> m_path, m_open; // nodes
  int m_count = 0;
};

// The edges whose bounds exclude 0, but which are 0 in every solution of the network: those that lie neither on a
// closed strip nor on a strip between free ends, as every solution is a sum of such strips. The time is linear.
inline std::vector<int> unattainable_edges(const Bidirected_network& network)
{
  const Double_cover graph(network);
  const Strip_components components(network, graph);
  std::vector<int> result;
  for(int arc = 0; arc < graph.number_of_arcs(); arc += 2)
  {
    const Bidirected_edge& edge = network.edges[arc / 2];
    const bool must_not_be_0 = edge.lower_bound > 0 || edge.upper_bound < 0;
    if(must_not_be_0 && components.component(graph.tail[arc]) != components.component(graph.head[arc]))
      result.push_back(arc / 2);
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_UNATTAINABLE_EDGES_H
