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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_BRANCH_AND_BOUND_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_BRANCH_AND_BOUND_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Half_edges.h>
#include <CGAL/Frame_fields/internal/quantization/Half_integral_flow.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The best integers that were found, and what is known of all others.
struct Integral_values
{
  std::vector<int> value;   // empty if there are none
  double cost = std::numeric_limits<double>::infinity();
  bool is_complete = false; // nothing is cheaper; if there is no value, there is none at all
};

// Searches the integers of least cost. Where the half-integral flow has an odd component, the search branches on one of
// its edges: its value is at most the integer below, or at least the integer above. In each branch the cost of the flow
// is a lower bound.
//
// The search is exact if its budgets suffice. It is worth its time only while the network has few odd components.
class Branch_and_bound
{
public:
  // The flow must be solved.
  explicit Branch_and_bound(Half_integral_flow& flow) : m_flow(flow), m_root(flow.optimum()) {}

  // Starts from a known solution, so that only cheaper ones are searched. If it is optimal, there is nothing to search.
  void start_with(const std::vector<int>& value, const double cost, const bool is_optimal)
  {
    m_best.value = value;
    m_best.cost = cost;
    m_best.is_complete = is_optimal;
  }

  // Solves at most `maximum_number_of_flows` flows and visits about `maximum_number_of_steps` edges in all. At the end
  // the flow is as it was before the search.
  void search(const std::int64_t maximum_number_of_flows, const std::int64_t maximum_number_of_steps)
  {
    const std::int64_t number_of_edges = static_cast<std::int64_t>(m_flow.network().edges.size());
    const std::int64_t work_before = m_flow.work();
    bool has_flow = true;
    for(std::int64_t i = 0; i < maximum_number_of_flows && !m_best.is_complete; ++i)
    {
      // A node of the flow has about four edges in all directions.
      if(i * number_of_edges + 4 * (m_flow.work() - work_before) > maximum_number_of_steps)
        break;
      const int edge = has_flow ? edge_to_branch_on() : -1;
      if(edge >= 0)
        descend(edge);
      else if(!turn_to_next_branch())
        m_best.is_complete = true;
      if(!m_best.is_complete)
        has_flow = m_flow.solve_again();
    }
    leave_all_branches();
  }

  const Integral_values& best() const { return m_best; }

private:
  struct Branch
  {
    int edge, lower, upper;       // the bounds it had before
    int other_lower, other_upper; // the bounds of the other branch
    bool has_other;               // whether the other branch is still to do
  };

  // The edge of the odd components whose cost grows fastest; -1 if nothing better can come of this flow.
  int edge_to_branch_on()
  {
    const double bound = m_flow.cost();
    if(!m_best.value.empty() && !(bound < m_best.cost - 1e-9 * (1 + m_best.cost)))
      return -1;
    const std::vector<int> odd = Half_edges(m_flow).make_integral();
    if(odd.empty())
    {
      store_values(bound);
      return -1;
    }
    int best = odd[0];
    for(const int e : odd)
      if(m_flow.network().edges[e].weight > m_flow.network().edges[best].weight)
        best = e;
    return best;
  }

  void store_values(const double cost)
  {
    m_best.cost = cost;
    m_best.value.resize(m_flow.network().edges.size());
    for(std::size_t e = 0; e < m_best.value.size(); ++e)
      m_best.value[e] = m_flow.doubled_value(static_cast<int>(e)) / 2;
  }

  void descend(const int edge)
  {
    const int lower = m_flow.lower_bound(edge), upper = m_flow.upper_bound(edge);
    const int below = static_cast<int>(std::floor(m_flow.doubled_value(edge) / 2.));
    if(m_flow.network().edges[edge].target < below + .5)
    {
      m_branches.push_back({ edge, lower, upper, below + 1, upper, true });
      m_flow.set_bounds(edge, lower, below);
    }
    else
    {
      m_branches.push_back({ edge, lower, upper, lower, below, true });
      m_flow.set_bounds(edge, below + 1, upper);
    }
  }

  void ascend()
  {
    const Branch& branch = m_branches.back();
    m_flow.set_bounds(branch.edge, branch.lower, branch.upper);
    m_branches.pop_back();
  }

  // Restores the bounds and the flow from before the search.
  void leave_all_branches()
  {
    while(!m_branches.empty())
      ascend();
    m_flow.restore(m_root);
  }

  bool turn_to_next_branch()
  {
    while(!m_branches.empty() && !m_branches.back().has_other)
      ascend();
    if(m_branches.empty())
      return false;
    Branch& branch = m_branches.back();
    branch.has_other = false;
    m_flow.set_bounds(branch.edge, branch.other_lower, branch.other_upper);
    return true;
  }

  Half_integral_flow& m_flow;
  const Half_integral_flow::Optimum m_root;
  Integral_values m_best;
  std::vector<Branch> m_branches;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_BRANCH_AND_BOUND_H
