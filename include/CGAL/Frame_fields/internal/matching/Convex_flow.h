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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MATCHING_CONVEX_FLOW_H
#define CGAL_FRAME_FIELDS_INTERNAL_MATCHING_CONVEX_FLOW_H

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// An integer flow of least cost on a graph whose arcs have convex costs, by successive shortest paths.
//
// Units move between nodes, and between nodes and a *hub*. Arcs without cost join the hub to the nodes; it stands for
// all places where a unit may be put or taken. The initial flow must be optimal: it has no cycle of negative cost.
// Each call of `move_unit()` keeps it optimal, since its path is a cheapest one. So, whatever the order of the calls,
// the flow costs least among all that move as many units from and to the nodes for which `move_unit()` was called.
//
// A search is Dijkstra's algorithm on reduced costs. It stops when no unvisited node is nearer than the hub, and it
// changes only the potentials of the nodes that are nearer. The potentials keep the reduced costs of the arcs to and
// from the hub non-negative, too. So a call takes O(k log k) for the k arcs that it visits, not for all arcs of the
// graph.
//
// `Graph` has the members
//   int number_of_nodes() const;
//   template <typename Visit> void for_each_arc(int node, const Visit& visit) const; // visit(arc, its other node)
//   int reverse(int arc) const;
//   int source(int arc) const;
//   double cost(int arc) const;     // of one more unit along the arc: grows with each, and reverse(arc) takes one back
//   void push(int arc);             // moves a unit along the arc
//   bool has_room(int node) const;  // one more unit may end there: there is an arc from the node to the hub
//   bool has_spare(int node) const; // one may start there: there is an arc from the hub to the node
template <typename Graph>
class Convex_flow
{
public:
  enum Direction { OUT, IN }; // to the hub, from the hub

  explicit Convex_flow(Graph& graph)
    : m_graph(graph), m_potential(graph.number_of_nodes(), 0), m_distance(graph.number_of_nodes(), infinity())
    , m_arrival(graph.number_of_nodes(), -1)
  {}

  // Moves a unit from `node` to the hub or from the hub to `node`, along the cheapest path. Returns the node of the
  // path that is next to the hub, or -1 if there is no path.
  int move_unit(const int node, const Direction direction)
  {
    const int end = find_cheapest(node, direction);
    if(end >= 0)
    {
      update_potentials(direction);
      push_path(node, end, direction);
    }
    for(const int reached : m_reached)
      m_distance[reached] = infinity();
    return end;
  }

  // Must be called when nodes get new arcs to the hub (`OUT`) or from it (`IN`); `is_new_end(node)` tells which nodes.
  // Before, no node may have had such an arc left. Arcs of the other direction must not be used any more, since all
  // potentials are shifted. Takes time linear in the number of nodes.
  template <typename IsNewEnd>
  void join_to_hub(const Direction direction, const IsNewEnd& is_new_end)
  {
    double least = infinity();
    for(int node = 0; node < m_graph.number_of_nodes(); ++node)
      if(is_new_end(node))
        least = (std::min)(least, cost_of_hub_arc(node, direction));
    if(least == infinity())
      return;
    for(double& potential : m_potential)
      potential -= direction == OUT ? least : -least;
  }

private:
  static double infinity() { return std::numeric_limits<double>::infinity(); }

  // The cost of an arc with the difference of its potentials. It is non-negative but for rounding errors, which are
  // cut off. The hub has potential 0.
  double reduced_cost(const int arc, const int from, const int to) const
  {
    return (std::max)(0., m_graph.cost(arc) + m_potential[from] - m_potential[to]);
  }

  double cost_of_hub_arc(const int node, const Direction direction) const
  {
    return direction == OUT ? m_potential[node] : -m_potential[node];
  }

  bool is_end(const int node, const Direction direction) const
  {
    return direction == OUT ? m_graph.has_room(node) : m_graph.has_spare(node);
  }

  // Dijkstra's algorithm from `node`, with `IN` along reversed arcs; -1 if the hub is not reached.
  int find_cheapest(const int node, const Direction direction)
  {
    typedef std::pair<double, int> Entry; // distance, node
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    m_reached.assign(1, node);
    m_distance[node] = 0;
    queue.push({ 0, node });
    int cheapest = -1;
    m_distance_of_hub = infinity();
    while(!queue.empty() && queue.top().first < m_distance_of_hub)
    {
      const auto [distance, nearest] = queue.top();
      queue.pop();
      if(distance > m_distance[nearest])
        continue;
      if(is_end(nearest, direction))
      {
        const double distance_of_hub = distance + (std::max)(0., cost_of_hub_arc(nearest, direction));
        if(distance_of_hub < m_distance_of_hub)
        {
          cheapest = nearest;
          m_distance_of_hub = distance_of_hub;
        }
      }
      m_graph.for_each_arc(nearest, [&, distance = distance, nearest = nearest](const int arc, const int neighbor)
      {
        const double new_distance = distance + (direction == OUT ? reduced_cost(arc, nearest, neighbor)
                                                : reduced_cost(m_graph.reverse(arc), neighbor, nearest));
        if(!(new_distance < m_distance[neighbor]))
          return;
        if(m_distance[neighbor] == infinity())
          m_reached.push_back(neighbor);
        m_distance[neighbor] = new_distance;
        m_arrival[neighbor] = arc;
        queue.push({ new_distance, neighbor });
      });
    }
    return cheapest;
  }

  // The usual change of a potential is min(distance, distance of the hub). Here the distance of the hub is subtracted
  // from it, so that nodes that are not nearer than the hub keep their potentials.
  void update_potentials(const Direction direction)
  {
    for(const int node : m_reached)
    {
      const double lead = (std::max)(0., m_distance_of_hub - m_distance[node]);
      m_potential[node] -= direction == OUT ? lead : -lead;
    }
  }

  void push_path(const int node, const int end, const Direction direction)
  {
    for(int place = end; place != node; place = m_graph.source(m_arrival[place]))
      m_graph.push(direction == OUT ? m_arrival[place] : m_graph.reverse(m_arrival[place]));
  }

  Graph& m_graph;
  std::vector<double> m_potential; // per node
  std::vector<double> m_distance;  // per node: from where the search started; infinity between searches
  std::vector<int> m_arrival;      // per node: the arc by which the search came
  std::vector<int> m_reached;
  double m_distance_of_hub = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MATCHING_CONVEX_FLOW_H
