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


#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZER_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZER_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Component_quantization.h>
#include <CGAL/Frame_fields/internal/quantization/Contracted_network.h>
#include <CGAL/Frame_fields/internal/quantization/Double_cover.h>
#include <CGAL/Frame_fields/internal/quantization/Quantization.h>
#include <CGAL/Frame_fields/internal/quantization/network_components.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Integers that make the sum at every node 0, within their bounds, at a cost as low as can be found. Whether there are
// any is decided exactly.
//
// Halves of least cost are a flow. In most components they are integers already; then nothing is cheaper. Otherwise
// paths make integers of them, and branch and bound looks for better ones. If it cannot finish, the strip search
// improves what there is.
//
// It may be run again after bounds of the network have changed; nothing else of the network may change, and the network
// must outlive the quantizer. Then only components with new bounds are solved again, starting from their last flows.
class Quantizer
{
public:
  explicit Quantizer(const Bidirected_network& network, const Quantization_options& options = Quantization_options())
    : m_given(network), m_options(options), m_contracted(network)
  {
    for(const Network_component& component : network_components(m_contracted.network()))
    {
      m_components.emplace_back(component.network);
      m_edges.push_back(component.edges);
    }
  }

  Quantization run()
  {
    Quantization result;
    result.value.resize(m_given.edges.size());
    m_contracted.update_bounds();
    if(!add_contradictions(result))
      return result;
    m_value.resize(m_contracted.network().edges.size());
    for(std::size_t c = 0; c < m_value.size(); ++c) // kept by edges of no component
    {
      const Bidirected_edge& edge = m_contracted.network().edges[c];
      m_value[c] = nearest_integer(edge.target, edge.lower_bound, edge.upper_bound);
    }
    m_is_unattainable.assign(m_value.size(), 0);
    m_is_conflicting.assign(m_value.size(), 0);
    for(std::size_t i = 0; i < m_components.size(); ++i)
      run_component(i, result);
    add_edges(result);
    return result;
  }

private:
  // Adds the edges of chains that no integer fits. Returns whether there are none.
  bool add_contradictions(Quantization& result) const
  {
    for(std::size_t e = 0; e < m_given.edges.size(); ++e)
    {
      const Bidirected_edge& chain = m_contracted.network().edges[m_contracted.chain(static_cast<int>(e))];
      if((chain.lower_bound > chain.upper_bound || chain.lower_bound > largest_value
          || chain.upper_bound < -largest_value)
         && m_contracted.bounds_its_chain(static_cast<int>(e)))
        result.conflicting.push_back(static_cast<int>(e));
    }
    result.is_feasible = result.is_optimal = result.conflicting.empty();
    return result.is_feasible;
  }

  void run_component(const std::size_t i, Quantization& result)
  {
    for(std::size_t e = 0; e < m_edges[i].size(); ++e)
    {
      const Bidirected_edge& edge = m_contracted.network().edges[m_edges[i][e]];
      m_components[i].set_bounds(static_cast<int>(e), edge.lower_bound, edge.upper_bound);
    }
    const Quantization& part = m_components[i].run(m_options);
    result.is_feasible = result.is_feasible && part.is_feasible;
    result.is_optimal = result.is_optimal && part.is_optimal;
    result.number_of_strips_moved += part.number_of_strips_moved;
    double cost = 0;
    for(std::size_t e = 0; e < m_edges[i].size(); ++e)
    {
      m_value[m_edges[i][e]] = part.value[e];
      cost += deviation_cost(m_components[i].network().edges[e], part.value[e]);
    }
    result.cost_bound += part.is_optimal ? cost : (std::min)(cost, part.cost_bound);
    for(const int e : part.unattainable)
      m_is_unattainable[m_edges[i][e]] = 1;
    for(const int e : part.conflicting)
      m_is_conflicting[m_edges[i][e]] = 1;
  }

  // From the chains to the given edges.
  void add_edges(Quantization& result) const
  {
    for(std::size_t e = 0; e < m_given.edges.size(); ++e)
    {
      const Bidirected_edge edge = finite_edge(m_given.edges[e]);
      const int c = m_contracted.chain(static_cast<int>(e));
      const Bidirected_edge& chain = m_contracted.network().edges[c];
      result.value[e] = m_value[c];
      result.cost += deviation_cost(edge, m_value[c]);
      result.cost_bound += deviation_cost(edge, chain.target); // what no value of the chain avoids
      if(is_unconstrained(chain))
        result.cost_bound += edge.weight * (m_value[c] - chain.target) * (m_value[c] - chain.target);
      if(m_is_unattainable[c] && (edge.lower_bound > 0 || edge.upper_bound < 0))
        result.unattainable.push_back(static_cast<int>(e));
      if(m_is_conflicting[c] && m_contracted.bounds_its_chain(static_cast<int>(e)))
        result.conflicting.push_back(static_cast<int>(e));
    }
  }

  const Bidirected_network& m_given;
  Quantization_options m_options;
  Contracted_network m_contracted;
  std::deque<Component_quantization> m_components;
  std::vector<std::vector<int> > m_edges; // per component: those of the contracted network
  std::vector<int> m_value;               // per edge of the contracted network
  std::vector<char> m_is_unattainable, m_is_conflicting; // the same
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZER_H
