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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZE_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZE_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Branch_and_bound.h>
#include <CGAL/Frame_fields/internal/quantization/Double_cover.h>
#include <CGAL/Frame_fields/internal/quantization/Half_integral_flow.h>
#include <CGAL/Frame_fields/internal/quantization/Integral_solution.h>
#include <CGAL/Frame_fields/internal/quantization/Strip_search.h>
#include <CGAL/Frame_fields/internal/quantization/network_components.h>
#include <CGAL/Frame_fields/internal/quantization/unattainable_edges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// How much work may be done beyond what is needed. All budgets count steps, not seconds: results never depend on the
// machine.
struct Quantization_options
{
  std::int64_t maximum_number_of_flows = 2000;     // in branch and bound, per component
  std::int64_t maximum_number_of_steps = 10000000; // in branch and bound, per component: one per edge and visit
  int maximum_number_of_strip_rounds = 20;
  bool uses_dive = true;                           // whether branch and bound starts with the branches of all odd parts
};

// Integers for all edges of a network.
struct Quantization
{
  bool is_feasible = true;          // there are integers within the bounds, and `value` has them
  bool is_optimal = true;           // no integers cost less
  std::vector<int> value;           // per edge; in a component without solution, the integer nearest to the target
  std::vector<int> unattainable;    // edges that must not be 0 but lie on no strip: they are 0 in every solution
  std::vector<int> conflicting;     // where nothing is unattainable, but there is no solution: edges whose bounds
                                    // exclude one another
  double cost = 0;                  // sum of weight (value - target)^2
  double cost_bound = 0;            // at most the least cost: the cost itself if it is, or that of the best halves
  int number_of_strips_moved = 0;   // by the strip search
};

// The quantization of one connected component, all of whose bounds allow something.
class Component_quantization
{
public:
  Component_quantization(const Bidirected_network& network, const Quantization_options& options)
    : m_network(network), m_options(options), m_flow(network)
  {}

  Quantization run()
  {
    m_result.unattainable = unattainable_edges(m_network);
    if(m_result.unattainable.empty())
    {
      if(!has_consistent_parity(m_network))
        m_result.conflicting = bounded_edges();
      else if(!m_flow.solve())
        m_result.conflicting = blocking_edges();
      else if(find_values())
        return m_result;
      else
        m_result.conflicting = bounded_edges();
    }
    m_result.is_feasible = m_result.is_optimal = false;
    m_result.value.clear();
    for(const Bidirected_edge& edge : m_network.edges)
      m_result.value.push_back(nearest_integer(edge.target, edge.lower_bound, edge.upper_bound));
    return m_result;
  }

private:
  bool find_values()
  {
    m_result.cost_bound = m_flow.cost();
    const std::vector<double> potential = m_flow.potential(); // before bounds change
    Branch_and_bound branch_and_bound(m_flow);
    if(m_options.uses_dive)
      branch_and_bound.dive();
    branch_and_bound.search(m_options.maximum_number_of_flows, m_options.maximum_number_of_steps);
    m_result.value = branch_and_bound.best().value;
    m_result.is_optimal = branch_and_bound.best().is_complete;
    if(m_result.value.empty() && (m_result.is_optimal || !find_any_values()))
      return false;
    if(!m_result.is_optimal)
      m_result.number_of_strips_moved = Strip_search(m_network, m_flow.graph(), potential, m_result.value)
                                          .improve(m_options.maximum_number_of_strip_rounds);
    return true;
  }

  bool find_any_values()
  {
    m_flow.solve_again();
    for(std::size_t e = 0; e < m_network.edges.size(); ++e)
      m_result.value.push_back(static_cast<int>(std::floor(m_flow.doubled_value(static_cast<int>(e)) / 2.)));
    return Integral_solution(m_network, m_result.value).find();
  }

  // The edges that keep an excess where it is, since they are at a bound.
  std::vector<int> blocking_edges() const
  {
    const std::vector<char> is_blocked = m_flow.blocked_nodes();
    const Double_cover& graph = m_flow.graph();
    std::vector<int> result;
    for(int arc = 0; arc < graph.number_of_arcs(); ++arc)
      if(is_blocked[graph.tail[arc]] != is_blocked[graph.head[arc]] && (result.empty() || result.back() != arc / 2))
        result.push_back(arc / 2);
    return result;
  }

  // The edges that are fixed, or bounded from above.
  std::vector<int> bounded_edges() const
  {
    std::vector<int> result;
    for(std::size_t e = 0; e < m_network.edges.size(); ++e)
      if(m_network.edges[e].upper_bound < largest_value)
        result.push_back(static_cast<int>(e));
    return result;
  }

  const Bidirected_network& m_network;
  const Quantization_options& m_options;
  Half_integral_flow m_flow;
  Quantization m_result;
};

// Adds the edges of a component, given by their numbers in it.
inline void add_edges(const Network_component& component, const std::vector<int>& edges, std::vector<int>& all)
{
  for(const int e : edges)
    all.push_back(component.edges[e]);
}

inline void add_component(const Network_component& component, const Quantization& part, Quantization& all)
{
  all.is_feasible = all.is_feasible && part.is_feasible;
  all.is_optimal = all.is_optimal && part.is_optimal;
  all.number_of_strips_moved += part.number_of_strips_moved;
  add_edges(component, part.unattainable, all.unattainable);
  add_edges(component, part.conflicting, all.conflicting);
  double cost = 0;
  for(std::size_t e = 0; e < component.edges.size(); ++e)
  {
    all.value[component.edges[e]] = part.value[e];
    cost += deviation_cost(component.network.edges[e], part.value[e]);
  }
  all.cost += cost;
  all.cost_bound += (part.is_optimal ? cost : (std::min)(cost, part.cost_bound));
}

// Integers that make the sum at every node 0, within their bounds, at a cost as low as can be found. Whether there are
// any is decided exactly.
//
// Halves of least cost are a flow. In most components they are integers already; then nothing is cheaper. Otherwise
// branch and bound makes them integers, and if it cannot finish, the strip search improves what it found.
inline Quantization quantize(const Bidirected_network& network,
                             const Quantization_options& options = Quantization_options())
{
  Quantization result;
  result.value.resize(network.edges.size());
  for(std::size_t e = 0; e < network.edges.size(); ++e)
  {
    const Bidirected_edge edge = finite_edge(network.edges[e]);
    if(edge.lower_bound > edge.upper_bound || edge.lower_bound > largest_value || edge.upper_bound < -largest_value)
      result.conflicting.push_back(static_cast<int>(e));
    else if(is_unconstrained(edge))
    {
      result.value[e] = nearest_integer(edge.target, edge.lower_bound, edge.upper_bound);
      result.cost += deviation_cost(edge, result.value[e]);
      result.cost_bound += deviation_cost(edge, result.value[e]);
    }
  }
  if(!result.conflicting.empty())
  {
    result.is_feasible = result.is_optimal = false;
    return result;
  }
  for(const Network_component& component : network_components(network))
    add_component(component, Component_quantization(component.network, options).run(), result);
  std::sort(result.unattainable.begin(), result.unattainable.end());
  std::sort(result.conflicting.begin(), result.conflicting.end());
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZE_H
