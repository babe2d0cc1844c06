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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_INTEGRAL_SOLUTION_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_INTEGRAL_SOLUTION_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Double_cover.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/max_cardinality_matching.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Decides whether a network has integers within its bounds, whatever they cost, by Edmonds' matching algorithm.
//
// Each edge may change by up to 2 in both directions, by unit steps that are done or not. A node of the network becomes
// as many vertices of a graph as it needs units, and each step becomes vertices between those of its two ends; the
// matching of these vertices tells whether the step is done. An augmenting path of the matching is a strip between two
// nodes whose sums are not 0 yet. If there is such a strip, there is one that passes no edge more than twice. So if
// nothing improves, there are no integers. The vertex of a free end need not be matched: the graph is taken twice, and
// the two copies of such a vertex are joined by an edge.
//
// A node of degree d adds O(d^2) edges to the graph, so a graph of too many edges is not made.
class Integral_solution
{
public:
  Integral_solution(const Bidirected_network& network, std::vector<int>& value)
    : m_network(network), m_value(value)
  {}

  // Changes the values until all sums are 0. Returns whether that is possible with a graph of no more than this number
  // of edges. The values must be within the bounds.
  bool find(const std::int64_t maximum_number_of_graph_edges = 10000000)
  {
    std::int64_t rest = total_imbalance(m_value);
    while(rest > 0)
    {
      collect_steps();
      collect_node_vertices();
      if(number_of_graph_edges() > maximum_number_of_graph_edges)
        return false;
      improve();
      const std::int64_t new_rest = total_imbalance(m_value);
      if(new_rest >= rest)
        return false;
      rest = new_rest;
    }
    return true;
  }

private:
  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> Graph;
  typedef boost::graph_traits<Graph>::vertex_descriptor Vertex;

  struct Step
  {
    int edge, direction;
    int first_vertex, number_of_vertices;
  };

  std::vector<std::int64_t> node_sums(const std::vector<int>& value) const
  {
    std::vector<std::int64_t> sum(m_network.number_of_nodes, 0);
    for(std::size_t e = 0; e < m_network.edges.size(); ++e)
      for(int end = 0; end < 2; ++end)
        if(m_network.edges[e].node[end] >= 0)
          sum[m_network.edges[e].node[end]] += m_network.edges[e].sign[end] * static_cast<std::int64_t>(value[e]);
    return sum;
  }

  std::int64_t total_imbalance(const std::vector<int>& value) const
  {
    std::int64_t result = 0;
    for(const std::int64_t sum : node_sums(value))
      result += std::abs(sum);
    return result;
  }

  // Whether a step increases the sum at the node of an end. Then a vertex of the node is matched if the step is done,
  // otherwise if it is not done.
  bool is_positive(const Step& step, const int end) const
  {
    return m_network.edges[step.edge].sign[end] * step.direction > 0;
  }

  void collect_steps()
  {
    m_steps.clear();
    m_number_of_vertices = 0;
    for(std::size_t e = 0; e < m_network.edges.size(); ++e)
    {
      const Bidirected_edge& edge = m_network.edges[e];
      const std::int64_t value = m_value[e];
      for(int i = 1; i <= 2; ++i)
        for(const int direction : { 1, -1 })
        {
          const std::int64_t new_value = value + static_cast<std::int64_t>(i) * direction;
          if(new_value < edge.lower_bound || new_value > edge.upper_bound || std::abs(new_value) > largest_value)
            continue;
          const int size = edge.sign[0] == edge.sign[1] ? 2 : 1;
          m_steps.push_back({ static_cast<int>(e), direction, m_number_of_vertices, size });
          m_number_of_vertices += size;
        }
    }
  }

  // Gives each node and each free end of a step a range of vertices after those of the steps.
  void collect_node_vertices()
  {
    std::vector<std::int64_t> needed = node_sums(m_value);
    for(std::int64_t& sum : needed)
      sum = -sum;
    m_free_vertices.assign(m_steps.size(), -1);
    for(std::size_t i = 0; i < m_steps.size(); ++i)
      for(int end = 0; end < 2; ++end)
      {
        const int node = m_network.edges[m_steps[i].edge].node[end];
        if(node < 0)
          m_free_vertices[i] = m_number_of_vertices++;
        else if(!is_positive(m_steps[i], end))
          ++needed[node];
      }
    m_first_vertex.assign(1, m_number_of_vertices);
    for(const std::int64_t number : needed)
    {
      m_number_of_vertices += static_cast<int>((std::max<std::int64_t>)(0, number));
      m_first_vertex.push_back(m_number_of_vertices);
    }
  }

  // The vertex of a step that stands for its end.
  int vertex_of(const Step& step, const int end) const
  {
    return step.first_vertex + (end < step.number_of_vertices ? end : 0);
  }

  // The vertices to which the vertex of an end can be matched.
  std::pair<int, int> partners(const std::size_t step, const int end) const
  {
    const int node = m_network.edges[m_steps[step].edge].node[end];
    if(node < 0)
      return { m_free_vertices[step], m_free_vertices[step] + 1 };
    return { m_first_vertex[node], m_first_vertex[node + 1] };
  }

  // Of both copies, but for one or two edges of each step.
  std::int64_t number_of_graph_edges() const
  {
    std::int64_t result = 0;
    for(std::size_t i = 0; i < m_steps.size(); ++i)
      for(int end = 0; end < 2; ++end)
      {
        const std::pair<int, int> range = partners(i, end);
        result += 2 * static_cast<std::int64_t>(range.second - range.first);
      }
    return result;
  }

  void improve()
  {
    const std::size_t size = 2 * static_cast<std::size_t>(m_number_of_vertices);
    Graph graph(size);
    std::vector<Vertex> mate(size, boost::graph_traits<Graph>::null_vertex());
    for(int copy = 0; copy < 2; ++copy)
    {
      const int offset = copy * m_number_of_vertices;
      std::vector<int> next_vertex(m_first_vertex.begin(), m_first_vertex.end() - 1);
      for(std::size_t i = 0; i < m_steps.size(); ++i)
        add_step(graph, mate, i, offset, next_vertex);
    }
    for(const int vertex : m_free_vertices)
      if(vertex >= 0)
      {
        add_edge(vertex, vertex + m_number_of_vertices, graph);
        if(mate[vertex] == boost::graph_traits<Graph>::null_vertex())
          match(mate, vertex, vertex + m_number_of_vertices);
      }

    typedef boost::property_map<Graph, boost::vertex_index_t>::type Index_map;
    boost::edmonds_augmenting_path_finder<Graph, Vertex*, Index_map> finder(graph, mate.data(),
                                                                            get(boost::vertex_index, graph));
    while(finder.augment_matching()) {}
    finder.get_current_matching(mate.data());
    store_better_copy(mate);
  }

  static void match(std::vector<Vertex>& mate, const int vertex, const int other)
  {
    mate[vertex] = other;
    mate[other] = vertex;
  }

  // The edges of a step, and the matching that says that it is not done.
  void add_step(Graph& graph, std::vector<Vertex>& mate, const std::size_t i, const int offset,
                std::vector<int>& next_vertex) const
  {
    const Step& step = m_steps[i];
    for(int end = 0; end < 2; ++end)
    {
      const std::pair<int, int> range = partners(i, end);
      for(int partner = range.first; partner < range.second; ++partner)
        add_edge(vertex_of(step, end) + offset, partner + offset, graph);
      if(is_positive(step, end))
        continue;
      const int node = m_network.edges[step.edge].node[end];
      if(node < 0)
        match(mate, vertex_of(step, end) + offset, range.first + offset);
      else if(next_vertex[node] < range.second)
        match(mate, vertex_of(step, end) + offset, offset + next_vertex[node]++);
    }
    if(step.number_of_vertices == 2)
    {
      add_edge(step.first_vertex + offset, step.first_vertex + 1 + offset, graph);
      if(is_positive(step, 0))
        match(mate, step.first_vertex + offset, step.first_vertex + 1 + offset);
    }
  }

  bool is_done(const std::size_t i, const std::vector<Vertex>& mate, const int offset) const
  {
    const Step& step = m_steps[i];
    const int first = step.first_vertex + offset;
    if(step.number_of_vertices == 2)
    {
      const bool touches_nodes = mate[first] != static_cast<Vertex>(first) + 1;
      return touches_nodes == is_positive(step, 0);
    }
    const std::pair<int, int> range = partners(i, is_positive(step, 0) ? 0 : 1);
    return mate[first] >= static_cast<Vertex>(range.first) + static_cast<Vertex>(offset)
           && mate[first] < static_cast<Vertex>(range.second) + static_cast<Vertex>(offset);
  }

  // The values after the steps that are done according to one copy.
  std::vector<int> values_of_copy(const std::vector<Vertex>& mate, const int copy) const
  {
    std::vector<int> result = m_value;
    for(std::size_t i = 0; i < m_steps.size(); ++i)
      if(is_done(i, mate, copy * m_number_of_vertices))
        result[m_steps[i].edge] += m_steps[i].direction;
    return result;
  }

  void store_better_copy(const std::vector<Vertex>& mate)
  {
    const std::array<std::vector<int>, 2> copies = { values_of_copy(mate, 0), values_of_copy(mate, 1) };
    for(const std::vector<int>& value : copies)
      if(total_imbalance(value) < total_imbalance(m_value))
        m_value = value;
  }

  const Bidirected_network& m_network;
  std::vector<int>& m_value;
  std::vector<Step> m_steps;
  std::vector<int> m_free_vertices; // per step: that of its free end, -1 if it has none
  std::vector<int> m_first_vertex;  // per node, and one more
  int m_number_of_vertices = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_INTEGRAL_SOLUTION_H
