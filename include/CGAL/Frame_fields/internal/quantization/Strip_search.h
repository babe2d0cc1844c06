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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_STRIP_SEARCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_STRIP_SEARCH_H

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Double_cover.h>
#include <CGAL/Frame_fields/internal/quantization/Search_front.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Improves integers that solve a network. Wherever a step of +1 or -1 has a negative reduced cost for the potentials of
// the half-integral flow, it looks for the cheapest strip that closes this step, and moves the strip if that lowers the
// cost. A strip may pass an edge twice, which then changes by 2.
class Strip_search
{
public:
  Strip_search(const Bidirected_network& network, const Double_cover& graph, const std::vector<double>& potential,
               std::vector<int>& value)
    : m_network(network), m_graph(graph), m_potential(potential), m_value(value)
    , m_front(graph.number_of_nodes())
    , m_change(network.edges.size(), 0), m_is_banned(graph.number_of_arcs(), 0)
  {}

  // Tries all steps in rounds until no step lowers the cost. Returns how many strips were moved.
  int improve(const int maximum_number_of_rounds)
  {
    int number_of_strips = 0;
    bool has_improved = true;
    for(int round = 0; round < maximum_number_of_rounds && has_improved; ++round)
    {
      has_improved = false;
      for(const Step& step : promising_steps())
        if(gain(step) > smallest_gain && move_strip_through(step))
        {
          has_improved = true;
          ++number_of_strips;
        }
    }
    return number_of_strips;
  }

private:
  struct Step { int arc, direction; };   // a step of +1 or -1 along an arc
  static constexpr double smallest_gain = 1e-9;

  int begin_of(const Step& step) const { return step.direction > 0 ? m_graph.tail[step.arc] : m_graph.head[step.arc]; }
  int end_of(const Step& step) const { return step.direction > 0 ? m_graph.head[step.arc] : m_graph.tail[step.arc]; }

  bool is_allowed(const Step& step) const
  {
    const Bidirected_edge& edge = m_network.edges[step.arc / 2];
    const int value = m_value[step.arc / 2];
    return step.direction > 0 ? value < (std::min)(edge.upper_bound, largest_value)
                              : value > (std::max)(edge.lower_bound, -largest_value);
  }

  double reduced_cost(const Step& step) const
  {
    const int e = step.arc / 2;
    return step.direction * deviation_slope(m_network.edges[e], m_value[e], step.direction)
           + m_potential[begin_of(step)] - m_potential[end_of(step)];
  }

  double gain(const Step& step) const { return is_allowed(step) ? -reduced_cost(step) : 0; }

  // The steps that gain something by themselves, the most promising ones first.
  std::vector<Step> promising_steps()
  {
    std::vector<std::pair<double, int> > keys;
    m_total_gain = 0;
    for(int arc = 0; arc < m_graph.number_of_arcs(); arc += 2)
      for(const int direction : { 1, -1 })
      {
        const double step_gain = gain({ arc, direction });
        if(step_gain > smallest_gain)
        {
          keys.emplace_back( -step_gain, 2 * arc + (direction > 0 ? 0 : 1) );
          m_total_gain += step_gain;
        }
      }
    std::sort(keys.begin(), keys.end());
    std::vector<Step> result;
    for(const std::pair<double, int>& key : keys)
      result.push_back({ key.second / 2, key.second % 2 == 0 ? 1 : -1 });
    return result;
  }

  // The shortest strip is of no use if it passes an edge twice that may change only once. Then the arc of the second
  // passage is banned and the search is repeated.
  bool move_strip_through(const Step& step)
  {
    const int maximum_number_of_trials = 4;
    std::vector<int> banned;
    bool has_moved = false;
    for(int trial = 0; trial < maximum_number_of_trials && !has_moved; ++trial)
    {
      const std::vector<Step> strip = shortest_strip(step);
      if(strip.empty())
        break;
      has_moved = move_if_it_pays(strip);
      if(!has_moved)
      {
        const int arc = first_repetition(strip);
        if(arc < 0)
          break;
        m_is_banned[arc] = 1;
        banned.push_back(arc);
      }
    }
    for(const int arc : banned)
      m_is_banned[arc] = 0;
    return has_moved;
  }

  // A shortest path from the end of a step to its beginning by Dijkstra's algorithm, and the step itself; empty if 1024
  // visits find none. Negative reduced costs count as 0.
  std::vector<Step> shortest_strip(const Step& step)
  {
    const int maximum_number_of_visits = 1024, end = begin_of(step);
    m_front.start(end_of(step));
    bool is_found = false;
    for(int visit = 0; visit < maximum_number_of_visits && !m_front.is_empty() && !is_found; ++visit)
    {
      const Search_front::Entry nearest = m_front.pop();
      is_found = nearest.node == end;
      if(!is_found && !m_front.is_outdated(nearest))
        visit_neighbors(nearest.node, nearest.distance);
    }
    std::vector<Step> result;
    if(is_found)
    {
      result.push_back(step);
      for(int node = end; node != end_of(step); node = begin_of(result.back()))
        result.push_back({ m_front.arrival(node) / 2, m_front.arrival(node) % 2 == 0 ? 1 : -1 });
    }
    return result;
  }

  void visit_neighbors(const int node, const double distance)
  {
    for(int place = m_graph.first_place[node]; place < m_graph.first_place[node + 1]; ++place)
    {
      const Step step = { m_graph.incident[place] / 2, m_graph.incident[place] % 2 == 0 ? 1 : -1 };
      if(m_is_banned[step.arc] || !is_allowed(step))
        continue;
      const double new_distance = distance + (std::max)(0., reduced_cost(step));
      if(new_distance < m_total_gain)
        m_front.reach(end_of(step), new_distance, m_graph.incident[place]);
    }
  }

  bool move_if_it_pays(const std::vector<Step>& strip)
  {
    for(const Step& step : strip)
      m_change[step.arc / 2] += step.direction;
    double cost = 0;
    bool is_within_bounds = true;
    for(const Step& step : strip) // an edge counts where it is met first
    {
      const int e = step.arc / 2, change = m_change[e];
      const Bidirected_edge& edge = m_network.edges[e];
      m_change[e] = 0;
      if(change == 0)
        continue;
      cost += change * deviation_slope(edge, m_value[e], change);
      is_within_bounds = is_within_bounds && m_value[e] + change >= edge.lower_bound
                         && m_value[e] + change <= edge.upper_bound;
    }
    if(!is_within_bounds || cost >= -smallest_gain)
      return false;
    for(const Step& step : strip)
      m_value[step.arc / 2] += step.direction;
    return true;
  }

  // The first arc of a strip whose edge was passed before, -1 if there is none.
  int first_repetition(const std::vector<Step>& strip)
  {
    int result = -1;
    for(std::size_t i = 0; i < strip.size() && result < 0; ++i)
      if(++m_change[strip[i].arc / 2] > 1)
        result = strip[i].arc;
    for(const Step& step : strip)
      m_change[step.arc / 2] = 0;
    return result;
  }

  const Bidirected_network& m_network;
  const Double_cover& m_graph;
  const std::vector<double>& m_potential; // per node of the double cover
  std::vector<int>& m_value;              // per edge
  Search_front m_front;                   // of nodes of the double cover, with steps as in Double_cover::incident
  std::vector<int> m_change;              // per edge
  std::vector<char> m_is_banned;          // per arc
  double m_total_gain = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_STRIP_SEARCH_H
