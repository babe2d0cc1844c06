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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_HALF_INTEGRAL_FLOW_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_HALF_INTEGRAL_FLOW_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Double_cover.h>
#include <CGAL/Frame_fields/internal/quantization/Search_front.h>
#include <CGAL/Frame_fields/internal/quantization/Node_multipliers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The cheapest values of a bidirected network that may be halves, where the cost of k + 1/2 is the mean of those of k
// and k + 1. Nothing with integers is cheaper, and where there is nothing with halves there is nothing with integers.
//
// This is a flow of convex cost in the double cover. It is found by successive shortest paths with potentials, which
// keep all reduced costs non-negative, first with large steps and then with smaller ones. Bounds may change afterward:
// only what they disturb is then done again.
class Half_integral_flow
{
public:
  explicit Half_integral_flow(const Bidirected_network& network, const int number_of_sweeps = 100)
    : m_network(network), m_graph(network), m_lower(network.edges.size()), m_upper(network.edges.size())
    , m_flow(m_graph.number_of_arcs(), 0), m_excess(m_graph.number_of_nodes(), 0)
    , m_potential(m_graph.number_of_nodes(), 0.), m_front(m_graph.number_of_nodes())
    , m_last_dead_phase(m_graph.number_of_nodes(), 0)
  {
    const std::vector<double> multiplier = Node_multipliers(network).run(number_of_sweeps);
    for(int node = 0; node < network.number_of_nodes; ++node)
    {
      m_potential[2 * static_cast<std::size_t>(node)] = multiplier[node];
      m_potential[2 * node + 1] = -multiplier[node];
    }
    for(std::size_t e = 0; e < network.edges.size(); ++e)
    {
      m_lower[e] = (std::max)(network.edges[e].lower_bound, -largest_value);
      m_upper[e] = (std::min)(network.edges[e].upper_bound, largest_value);
      for(int arc = 2 * static_cast<int>(e); arc < 2 * static_cast<int>(e) + 2; ++arc)
        push(arc, best_value(arc));
    }
  }

  // Finds the optimum. Returns whether there is a solution. The lower bound of each edge must be at most its upper
  // bound.
  bool solve()
  {
    std::int64_t largest_excess = 0;
    for(const std::int64_t excess : m_excess)
      largest_excess = (std::max)(largest_excess, excess);
    std::int64_t step = 1;
    while(2 * step <= (std::min<std::int64_t>)(largest_excess, largest_value))
      step *= 2;
    for(; step > 1; step /= 2)
    {
      m_step = static_cast<int>(step);
      for(int arc = 0; arc < m_graph.number_of_arcs(); ++arc)
        make_optimal_for_step(arc);
      remove_excesses();
    }
    m_step = 1;
    for(int arc = 0; arc < m_graph.number_of_arcs(); ++arc)
      make_optimal(arc);
    return remove_excesses();
  }

  // Changes the bounds of an edge, and the flow of its two arcs where the bounds or the costs ask for it. Call
  // `solve_again()` after the last change.
  void set_bounds(const int edge, const int lower, const int upper)
  {
    m_lower[edge] = (std::max)(lower, -largest_value);
    m_upper[edge] = (std::min)(upper, largest_value);
    make_optimal(2 * edge);
    make_optimal(2 * edge + 1);
  }

  // Makes the flow optimal again after `set_bounds()`. Returns whether there is a solution.
  bool solve_again()
  {
    const std::int64_t large_excess = 16; // for single steps
    for(const int source : m_sources)
      if(m_excess[source] >= large_excess)
        return solve();
    return remove_excesses();
  }

  // An optimal flow without its bounds. It may be restored only when the bounds are those that it was optimal for.
  struct Optimum
  {
    std::vector<int> flow;         // per arc
    std::vector<double> potential; // per node
  };

  Optimum optimum() const { return { m_flow, m_potential }; }

  void restore(const Optimum& optimum)
  {
    m_flow = optimum.flow;
    m_potential = optimum.potential;
    std::fill(m_excess.begin(), m_excess.end(), 0);
    m_sources.clear();
  }

  int lower_bound(const int edge) const { return m_lower[edge]; }
  int upper_bound(const int edge) const { return m_upper[edge]; }

  static std::size_t first_arc(const int edge) { return 2 * static_cast<std::size_t>(edge); }

  int doubled_value(const int edge) const { return m_flow[first_arc(edge)] + m_flow[first_arc(edge) + 1]; }

  bool is_half(const int edge) const { return doubled_value(edge) % 2 != 0; }

  // Gives both arcs of an edge an integer that differs from its value by at most 1/2. The excesses are not updated, so
  // the caller must change edges that balance one another.
  void set_value(const int edge, const int value) { m_flow[first_arc(edge)] = m_flow[first_arc(edge) + 1] = value; }

  double cost() const
  {
    double sum = 0;
    for(std::size_t e = 0; e < m_network.edges.size(); ++e)
    {
      const double low = std::floor(doubled_value(static_cast<int>(e)) / 2.);
      const Bidirected_edge& edge = m_network.edges[e];
      sum += is_half(static_cast<int>(e)) ? (deviation_cost(edge, low) + deviation_cost(edge, low + 1)) / 2
                                          : deviation_cost(edge, low);
    }
    return sum;
  }

  const Bidirected_network& network() const { return m_network; }
  const Double_cover& graph() const { return m_graph; }
  const std::vector<double>& potential() const { return m_potential; }

  // The number of nodes that all shortest paths have visited so far, a measure of time.
  std::int64_t work() const { return m_work; }

  // After a failure: the nodes from which an excess could not go on.
  std::vector<char> blocked_nodes() const
  {
    std::vector<char> result(m_graph.number_of_nodes());
    for(std::size_t node = 0; node < result.size(); ++node)
      result[node] = m_last_dead_phase[node] == m_phase;
    return result;
  }

private:
  double potential_difference(const int arc) const
  {
    return m_potential[m_graph.tail[arc]] - m_potential[m_graph.head[arc]];
  }

  // The reduced cost, per unit, of `m_step` more or fewer units on an arc.
  double forward_cost(const int arc) const
  {
    return deviation_slope(m_network.edges[arc / 2], m_flow[arc], m_step) + potential_difference(arc);
  }
  double backward_cost(const int arc) const
  {
    return -deviation_slope(m_network.edges[arc / 2], m_flow[arc], -m_step) - potential_difference(arc);
  }
  bool can_increase(const int arc) const { return m_flow[arc] <= m_upper[arc / 2] - m_step; }
  bool can_decrease(const int arc) const { return m_flow[arc] >= m_lower[arc / 2] + m_step; }

  void push(const int arc, const int amount)
  {
    m_flow[arc] += amount;
    m_excess[m_graph.head[arc]] += amount;
    m_excess[m_graph.tail[arc]] -= amount;
  }

  // The value of an arc that costs least for the potentials of its ends.
  int best_value(const int arc) const
  {
    const Bidirected_edge& edge = m_network.edges[arc / 2];
    return nearest_integer(edge.target - potential_difference(arc) / (2 * edge.weight), m_lower[arc / 2],
                           m_upper[arc / 2]);
  }

  void make_optimal_for_step(const int arc)
  {
    if(can_increase(arc) && forward_cost(arc) < 0)
      push(arc, m_step);
    else if(can_decrease(arc) && backward_cost(arc) < 0)
      push(arc, -m_step);
  }

  // The same for steps of 1, also if the flow of the arc is far from its optimum or violates its bounds.
  void make_optimal(const int arc)
  {
    const int lower = m_lower[arc / 2], upper = m_upper[arc / 2];
    // Rounding errors must not move what is optimal.
    const double tolerance = 1e-12 * (1 + std::abs(potential_difference(arc)));
    const bool is_optimal = m_flow[arc] >= lower && m_flow[arc] <= upper
                            && !(can_increase(arc) && forward_cost(arc) < -tolerance)
                            && !(can_decrease(arc) && backward_cost(arc) < -tolerance);
    if(!is_optimal)
      push(arc, best_value(arc) - m_flow[arc]);
    m_sources.push_back(m_graph.tail[arc]);
    m_sources.push_back(m_graph.head[arc]);
  }

  // Moves all excesses of at least a step to where that much is missing. Returns whether that was possible.
  bool remove_excesses()
  {
    ++m_phase;
    if(m_step > 1)
    {
      m_sources.resize(m_graph.number_of_nodes());
      for(std::size_t node = 0; node < m_sources.size(); ++node)
        m_sources[node] = static_cast<int>(node);
    }
    std::size_t number_of_blocked_sources = 0;
    for(std::size_t i = 0; i < m_sources.size(); ++i)
    {
      const int source = m_sources[i];
      while(m_excess[source] >= m_step && m_last_dead_phase[source] != m_phase)
        move_excess(source);
      if(m_excess[source] >= m_step)
        m_sources[number_of_blocked_sources++] = source;
    }
    m_sources.resize(number_of_blocked_sources); // for the next time, with other bounds
    return number_of_blocked_sources == 0;
  }

  // Moves one step of excess along a shortest path, by Dijkstra's algorithm with reduced costs. If no path leads to a
  // node that lacks a step, none does from the nodes that were reached either, until the phase ends.
  void move_excess(const int source)
  {
    m_front.start(source);
    int end = -1;
    while(!m_front.is_empty() && end < 0)
    {
      const Search_front::Entry nearest = m_front.pop();
      if(m_front.is_outdated(nearest))
        continue;
      ++m_work;
      if(m_excess[nearest.node] <= -m_step)
        end = nearest.node;
      else
        visit_neighbors(nearest.node, nearest.distance);
    }
    if(end >= 0)
      augment(source, end);
    else
      for(const int node : m_front.reached())
        m_last_dead_phase[node] = m_phase;
  }

  void visit_neighbors(const int node, const double distance)
  {
    for(int place = m_graph.first_place[node]; place < m_graph.first_place[node + 1]; ++place)
    {
      const int arc = m_graph.incident[place] / 2;
      const bool is_forward = m_graph.incident[place] % 2 == 0;
      if(is_forward ? !can_increase(arc) : !can_decrease(arc))
        continue;
      const double cost = (std::max)(0., is_forward ? forward_cost(arc) : backward_cost(arc));
      m_front.reach(is_forward ? m_graph.head[arc] : m_graph.tail[arc], distance + cost, m_graph.incident[place]);
    }
  }

  void augment(const int source, const int end)
  {
    for(int node = end; node != source; )
    {
      const int arc = m_front.arrival(node) / 2;
      const bool is_forward = m_front.arrival(node) % 2 == 0;
      push(arc, is_forward ? m_step : -m_step);
      node = is_forward ? m_graph.tail[arc] : m_graph.head[arc];
    }
    for(const int node : m_front.reached())
      m_potential[node] += (std::min)(0., m_front.distance(node) - m_front.distance(end));
  }

  const Bidirected_network& m_network;
  Double_cover m_graph;
  std::vector<int> m_lower, m_upper;     // per edge
  std::vector<int> m_flow;               // per arc
  std::vector<std::int64_t> m_excess;    // per node: what arrives less what leaves
  std::vector<double> m_potential;       // per node
  Search_front m_front;                  // by reduced distances, with steps as in Double_cover::incident
  std::vector<int> m_last_dead_phase;    // per node: the last phase in which no path left it, 0 if there was none
  std::vector<int> m_sources;            // nodes
  int m_step = 1;
  int m_phase = 0;
  std::int64_t m_work = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_HALF_INTEGRAL_FLOW_H
