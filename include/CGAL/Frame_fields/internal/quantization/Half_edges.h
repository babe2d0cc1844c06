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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_HALF_EDGES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_HALF_EDGES_H

#include <CGAL/Frame_fields/internal/quantization/Half_integral_flow.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The edges with half values of a half-integral flow. In each of their connected components, steps of +1/2 and -1/2 are
// passed along a closed tour through all of its edges. If they agree where the tour closes, the component gets integers
// at no cost, since both directions cost the same at an optimum. Otherwise it is odd: it has no integers of its own.
//
// An object rounds only once, either by `round_all()` or by `make_integral()`, in linear time.
class Half_edges
{
public:
  explicit Half_edges(Half_integral_flow& flow)
    : m_flow(flow), m_free_node(flow.network().number_of_nodes)
  {
    const std::vector<Bidirected_edge>& edges = flow.network().edges;
    m_first_place.assign(static_cast<std::size_t>(m_free_node) + 2, 0);
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(flow.is_half(static_cast<int>(e)))
        m_half_edges.push_back(static_cast<int>(e));
    if(m_half_edges.empty())
      return;

    m_was_passed.assign(edges.size(), 0);
    for(const int e : m_half_edges)
      for(int end = 0; end < 2; ++end)
        ++m_first_place[node_of(e, end) + 1];
    for(int node = 0; node <= m_free_node; ++node)
      m_first_place[node + 1] += m_first_place[node];
    m_next.assign(m_first_place.begin(), m_first_place.end() - 1);
    m_incident.resize(2 * m_half_edges.size());
    for(const int e : m_half_edges)
      for(int end = 0; end < 2; ++end)
        m_incident[m_next[node_of(e, end)]++] = { e, end };
    m_next.assign(m_first_place.begin(), m_first_place.end() - 1);
  }

  // Gives integers to all components. Odd ones leave a sum of 1 or -1 at one of their nodes. Returns whether there are
  // any.
  bool round_all()
  {
    m_rounds_odd_tours = true;
    return !make_integral().empty();
  }

  // Gives integers to all components but the odd ones; returns an edge of largest weight of each of these.
  std::vector<int> make_integral()
  {
    std::vector<int> odd;
    if(m_half_edges.empty())
      return odd;
    // A tour that starts at the free ends may change its sign there, and is never odd.
    make_tour_integral(m_free_node, odd);
    for(const int e : m_half_edges)
      if(!m_was_passed[e])
        make_tour_integral(node_of(e, 0), odd);
    return odd;
  }

private:
  struct End { int edge, end; };             // one of the two ends of an edge
  struct Passage { int node; End arrival; }; // arrival: the end at which the edge to the node was entered

  int node_of(const int edge, const int end) const
  {
    const int node = m_flow.network().edges[edge].node[end];
    return node < 0 ? m_free_node : node;
  }
  int sign_of(const End end) const { return m_flow.network().edges[end.edge].sign[end.end]; }

  // A closed tour through all edges that can be reached (by Hierholzer's algorithm), each as the end where it begins.
  std::vector<End> tour(const int start)
  {
    std::vector<End> result;
    std::vector<Passage> stack(1, { start, { -1, 0 } });
    while(!stack.empty())
    {
      const int node = stack.back().node;
      int& next = m_next[node];
      while(next < m_first_place[node + 1] && m_was_passed[m_incident[next].edge])
        ++next;
      if(next < m_first_place[node + 1])
      {
        const End departure = m_incident[next];
        m_was_passed[departure.edge] = 1;
        stack.push_back({ node_of(departure.edge, 1 - departure.end), departure });
      }
      else
      {
        if(stack.back().arrival.edge >= 0) // the tour comes out backward
          result.push_back({ stack.back().arrival.edge, 1 - stack.back().arrival.end });
        stack.pop_back();
      }
    }
    return result;
  }

  void make_tour_integral(const int start, std::vector<int>& odd)
  {
    const std::vector<End> ends = tour(start);
    if(ends.empty())
      return;
    std::vector<int> step(ends.size(), 1); // in halves
    for(std::size_t i = 1; i < ends.size(); ++i)
    {
      const End arrival = { ends[i - 1].edge, 1 - ends[i - 1].end };
      step[i] = -sign_of(arrival) * step[i - 1] * sign_of(ends[i]);
    }
    const End last = { ends.back().edge, 1 - ends.back().end };
    const bool is_odd = start != m_free_node && sign_of(last) * step.back() + sign_of(ends[0]) * step[0] != 0;
    if(is_odd)
      odd.push_back(heaviest_edge(ends));
    if(!is_odd || m_rounds_odd_tours)
      for(std::size_t i = 0; i < ends.size(); ++i)
        m_flow.set_value(ends[i].edge, (m_flow.doubled_value(ends[i].edge) + step[i]) / 2);
  }

  int heaviest_edge(const std::vector<End>& ends) const
  {
    int result = ends[0].edge;
    for(const End& end : ends)
      if(m_flow.network().edges[end.edge].weight > m_flow.network().edges[result].weight)
        result = end.edge;
    return result;
  }

  Half_integral_flow& m_flow;
  int m_free_node;
  bool m_rounds_odd_tours = false;
  std::vector<int> m_half_edges;
  std::vector<int> m_first_place; // per node, and one more
  std::vector<End> m_incident;    // by places
  std::vector<int> m_next;        // per node: the place of the next end to leave by
  std::vector<char> m_was_passed; // per edge
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_HALF_EDGES_H
