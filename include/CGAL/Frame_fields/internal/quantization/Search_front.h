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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_SEARCH_FRONT_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_SEARCH_FRONT_H

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The front of Dijkstra's algorithm, for many searches that reach few of the nodes each.
class Search_front
{
public:
  struct Entry
  {
    double distance;
    int node;
  };

  explicit Search_front(const int number_of_nodes)
    : m_distance(number_of_nodes), m_arrival(number_of_nodes, NOT_REACHED)
  {}

  // Forgets the search before, in time linear in the nodes that it reached.
  void start(const int node)
  {
    for(const int reached : m_reached)
      m_arrival[reached] = NOT_REACHED;
    m_reached.clear();
    m_queue.clear();
    reach(node, 0, START);
  }

  // Enters a node to which a step leads, unless it was reached at no greater distance before.
  void reach(const int node, const double distance, const int step)
  {
    if(m_arrival[node] == NOT_REACHED)
      m_reached.push_back(node);
    else if(!(distance < m_distance[node]))
      return;
    m_arrival[node] = step;
    m_distance[node] = distance;
    m_queue.emplace_back( distance, node );
    std::push_heap(m_queue.begin(), m_queue.end(), std::greater<Queue_entry>());
  }

  // Takes out what is nearest.
  Entry pop()
  {
    const Queue_entry nearest = m_queue.front();
    std::pop_heap(m_queue.begin(), m_queue.end(), std::greater<Queue_entry>());
    m_queue.pop_back();
    return { nearest.first, nearest.second };
  }

  bool is_empty() const { return m_queue.empty(); }
  bool is_outdated(const Entry& entry) const { return entry.distance > m_distance[entry.node]; }

  // The nodes that the search has reached, their distances, and the last step to each; the start has none.
  const std::vector<int>& reached() const { return m_reached; }
  double distance(const int node) const { return m_distance[node]; }
  int arrival(const int node) const { return m_arrival[node]; }

private:
  typedef std::pair<double, int> Queue_entry; // distance, node

  enum { NOT_REACHED = -1, START = -2 };

  std::vector<double> m_distance; // per node
  std::vector<int> m_arrival;     // per node
  std::vector<int> m_reached;
  std::vector<Queue_entry> m_queue; // a heap
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_SEARCH_FRONT_H
