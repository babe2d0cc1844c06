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


#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_COMPONENT_QUANTIZATION_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_COMPONENT_QUANTIZATION_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Branch_and_bound.h>
#include <CGAL/Frame_fields/internal/quantization/Double_cover.h>
#include <CGAL/Frame_fields/internal/quantization/Half_edges.h>
#include <CGAL/Frame_fields/internal/quantization/Half_integral_flow.h>
#include <CGAL/Frame_fields/internal/quantization/Imbalance_paths.h>
#include <CGAL/Frame_fields/internal/quantization/Integral_solution.h>
#include <CGAL/Frame_fields/internal/quantization/Quantization.h>
#include <CGAL/Frame_fields/internal/quantization/Strip_search.h>
#include <CGAL/Frame_fields/internal/quantization/network_components.h>
#include <CGAL/Frame_fields/internal/quantization/unattainable_edges.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The quantization of one connected component. It may be run again with other bounds: the new flow starts from the flow
// before, and only what the new bounds disturb is computed again.
class Component_quantization
{
public:
  explicit Component_quantization(const Bidirected_network& network)
    : m_network(network)
  {}
  // The flow refers to the network.
  Component_quantization(const Component_quantization&) = delete;
  Component_quantization& operator=(const Component_quantization&) = delete;

  void set_bounds(const int e, const int lower, const int upper)
  {
    Bidirected_edge& edge = m_network.edges[e];
    if(edge.lower_bound == lower && edge.upper_bound == upper)
      return;
    edge.lower_bound = lower;
    edge.upper_bound = upper;
    m_changed_edges.push_back(e);
    m_is_done = false;
  }

  const Bidirected_network& network() const { return m_network; }

  // The bounds of each edge must contain an integer of [-largest_value, largest_value].
  const Quantization& run(const Quantization_options& options)
  {
    if(!m_is_done)
      quantize(options);
    m_is_done = true;
    return m_result;
  }

private:
  void quantize(const Quantization_options& options)
  {
    m_result = Quantization();
    m_result.unattainable = unattainable_edges(m_network);
    if(m_result.unattainable.empty())
    {
      if(!has_consistent_parity(m_network))
        m_result.conflicting = bounded_edges();
      else if(!update_flow())
        m_result.conflicting = blocking_edges();
      else if(find_values(options))
        return;
      else
        m_result.conflicting = bounded_edges();
    }
    m_result.is_feasible = m_result.is_optimal = false;
    m_result.value.clear();
    for(const Bidirected_edge& edge : m_network.edges)
      m_result.value.push_back(nearest_integer(edge.target, edge.lower_bound, edge.upper_bound));
  }

  bool update_flow()
  {
    if(!m_has_optimal_flow)
    {
      m_flow.emplace(m_network);
      m_has_optimal_flow = m_flow->solve();
    }
    else
    {
      for(const int e : m_changed_edges)
        m_flow->set_bounds(e, m_network.edges[e].lower_bound, m_network.edges[e].upper_bound);
      m_has_optimal_flow = m_flow->solve_again();
    }
    m_changed_edges.clear();
    return m_has_optimal_flow;
  }

  bool find_values(const Quantization_options& options)
  {
    m_result.cost_bound = m_flow->cost();
    bool has_odd_components;
    std::vector<int> value = rounded_halves(has_odd_components);
    Branch_and_bound branch_and_bound(*m_flow);
    if(!has_odd_components
       || (options.joins_by_paths && Imbalance_paths(m_network, m_flow->graph(), m_flow->potential(), value).join()))
      branch_and_bound.start_with(value, cost_of(value), !has_odd_components);
    branch_and_bound.search(options.maximum_number_of_flows, options.maximum_number_of_steps);
    m_result.is_optimal = branch_and_bound.best().is_complete;
    m_result.value = branch_and_bound.best().value;
    if(m_result.value.empty())
    {
      m_result.value.swap(value);
      if(m_result.is_optimal || !Integral_solution(m_network, m_result.value).find())
        return false;
    }
    if(!m_result.is_optimal)
      m_result.number_of_strips_moved = Strip_search(m_network, m_flow->graph(), m_flow->potential(), m_result.value)
                                          .improve(options.maximum_number_of_strip_rounds);
    return true;
  }

  // The halves rounded to integers. The integers cost as much as the halves, but in each odd component one sum is 1 or
  // -1. The flow stays as it is.
  std::vector<int> rounded_halves(bool& has_odd_components)
  {
    const Half_integral_flow::Optimum halves = m_flow->optimum();
    has_odd_components = Half_edges(*m_flow).round_all();
    std::vector<int> result;
    for(std::size_t e = 0; e < m_network.edges.size(); ++e)
      result.push_back(m_flow->doubled_value(static_cast<int>(e)) / 2);
    m_flow->restore(halves);
    return result;
  }

  double cost_of(const std::vector<int>& value) const
  {
    double sum = 0;
    for(std::size_t e = 0; e < value.size(); ++e)
      sum += deviation_cost(m_network.edges[e], value[e]);
    return sum;
  }

  // The edges that keep an excess where it is, since they are at a bound.
  std::vector<int> blocking_edges() const
  {
    const std::vector<char> is_blocked = m_flow->blocked_nodes();
    const Double_cover& graph = m_flow->graph();
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

  Bidirected_network m_network;
  std::optional<Half_integral_flow> m_flow;
  std::vector<int> m_changed_edges; // whose bounds the flow does not know yet
  bool m_has_optimal_flow = false;  // for the bounds before those changes
  bool m_is_done = false;
  Quantization m_result;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_COMPONENT_QUANTIZATION_H
