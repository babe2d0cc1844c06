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
#ifndef CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FEATURE_GRAPH_H
#define CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FEATURE_GRAPH_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The edges of a mesh in flat arrays, and which of them are features.
struct Feature_graph
{
  std::vector<Coordinates> points;      // per vertex
  std::vector<std::array<int, 2> > ends; // per edge: its vertices
  std::vector<double> length;           // per edge
  std::vector<char> is_border;          // per edge
  std::vector<char> is_feature;         // per edge

  int number_of_vertices() const { return static_cast<int>(points.size()); }
  int number_of_edges() const { return static_cast<int>(ends.size()); }
  int other_end(const int edge, const int vertex) const { return ends[edge][ends[edge][0] == vertex]; }
};

// For each vertex, the edges at it that have a property. Takes linear time; the graph may change afterwards.
class Edges_around_vertices
{
public:
  template <typename HasProperty>
  Edges_around_vertices(const Feature_graph& graph, const HasProperty& has_property)
    : m_begin(graph.points.size() + 1, 0)
  {
    for_each_end(graph, has_property, [&](const int vertex, int) { ++m_begin[vertex + 1]; });
    for(std::size_t v = 1; v < m_begin.size(); ++v)
      m_begin[v] += m_begin[v - 1];
    m_edges.resize(m_begin.back());
    std::vector<int> place = m_begin;
    for_each_end(graph, has_property, [&](const int vertex, const int edge) { m_edges[place[vertex]++] = edge; });
  }

  int number(const int vertex) const { return m_begin[vertex + 1] - m_begin[vertex]; }
  const int* begin(const int vertex) const { return m_edges.data() + m_begin[vertex]; }
  const int* end(const int vertex) const { return m_edges.data() + m_begin[vertex + 1]; }

private:
  template <typename HasProperty, typename Visit>
  static void for_each_end(const Feature_graph& graph, const HasProperty& has_property, const Visit& visit)
  {
    for(int e = 0; e < graph.number_of_edges(); ++e)
      if(has_property(e))
        for(const int vertex : graph.ends[e])
          visit(vertex, e);
  }

  std::vector<int> m_begin, m_edges;
};

inline Edges_around_vertices features_around_vertices(const Feature_graph& graph)
{
  return Edges_around_vertices(graph, [&](const int e) { return graph.is_feature[e]; });
}

// Marks the edges of at least the strong angle, and those of at least the weak angle that a path of such edges connects
// with them. All angles are in the same unit. Takes linear time.
inline void mark_with_hysteresis(Feature_graph& graph, const std::vector<double>& angle, const double strong_angle,
                                 const double weak_angle)
{
  const Edges_around_vertices weak_edges(graph, [&](const int e) { return angle[e] >= weak_angle; });
  std::vector<int> front;
  const auto mark = [&](const int e)
  {
    graph.is_feature[e] = true;
    front.push_back(e);
  };
  for(int e = 0; e < graph.number_of_edges(); ++e)
    if(angle[e] >= strong_angle && !graph.is_feature[e])
      mark(e);
  while(!front.empty())
  {
    const std::array<int, 2> ends = graph.ends[front.back()];
    front.pop_back();
    for(const int vertex : ends)
      for(const int* e = weak_edges.begin(vertex); e != weak_edges.end(vertex); ++e)
        if(!graph.is_feature[*e])
          mark(*e);
  }
}

// Marks the edges that join two dangling ends and turn by less than a right angle at both, the straightest ones first.
// An end is joined once at most. Takes O(n log n) time.
inline void join_dangling_ends(Feature_graph& graph)
{
  const Edges_around_vertices features = features_around_vertices(graph);
  const auto turn_at = [&](const int vertex, const int edge)
  {
    const int before = graph.other_end(*features.begin(vertex), vertex), after = graph.other_end(edge, vertex);
    return angle_between(scaled_direction(graph.points[before], graph.points[vertex]),
                         scaled_direction(graph.points[vertex], graph.points[after]));
  };
  std::vector<std::pair<double, int> > gaps; // the larger turn, and the edge
  for(int e = 0; e < graph.number_of_edges(); ++e)
  {
    const std::array<int, 2> ends = graph.ends[e];
    if(graph.is_feature[e] || features.number(ends[0]) != 1 || features.number(ends[1]) != 1)
      continue;
    const double turn = (std::max)(turn_at(ends[0], e), turn_at(ends[1], e));
    if(turn < CGAL_PI / 2)
      gaps.emplace_back(turn, e);
  }
  std::sort(gaps.begin(), gaps.end());

  std::vector<char> is_joined(graph.points.size(), false);
  for(const auto& [turn, e] : gaps)
  {
    const std::array<int, 2> ends = graph.ends[e];
    if(is_joined[ends[0]] || is_joined[ends[1]])
      continue;
    graph.is_feature[e] = true;
    is_joined[ends[0]] = is_joined[ends[1]] = true;
  }
}

// A path of feature edges whose inner vertices have just two features, or a closed one.
struct Feature_chain
{
  double length = 0;
  int first_vertex, last_vertex; // equal if it is closed
  std::vector<int> edges;

  bool operator<(const Feature_chain& other) const
  {
    return std::tie(length, edges) < std::tie(other.length, other.edges);
  }
};

// The chain that starts with an edge at a vertex. It ends at a vertex that does not have just two features, or at its
// start.
inline Feature_chain follow_chain(const Feature_graph& graph, const Edges_around_vertices& features, const int vertex,
                                  const int first_edge)
{
  Feature_chain chain;
  chain.first_vertex = chain.last_vertex = vertex;
  for(int e = first_edge;;)
  {
    chain.edges.push_back(e);
    chain.length += graph.length[e];
    chain.last_vertex = graph.other_end(e, chain.last_vertex);
    if(chain.last_vertex == vertex || features.number(chain.last_vertex) != 2)
      return chain;
    const int* const around = features.begin(chain.last_vertex);
    e = around[around[0] == e];
  }
}

// The chains shorter than a length that have a dangling end, or are closed, meet no other and are not a border.
inline std::set<Feature_chain> removable_chains(const Feature_graph& graph, const double minimum_length)
{
  const Edges_around_vertices features = features_around_vertices(graph);
  std::set<Feature_chain> result;
  std::vector<char> is_visited(graph.ends.size(), false);
  const auto visit = [&](const int vertex, const int edge, const bool is_removable)
  {
    const Feature_chain chain = follow_chain(graph, features, vertex, edge);
    for(const int e : chain.edges)
      is_visited[e] = true;
    if(is_removable && chain.length < minimum_length)
      result.insert(chain);
  };
  for(int v = 0; v < graph.number_of_vertices(); ++v)
    if(features.number(v) == 1 && !is_visited[*features.begin(v)])
      visit(v, *features.begin(v), true);
  for(int v = 0; v < graph.number_of_vertices(); ++v)
    if(features.number(v) > 2)
      for(const int* e = features.begin(v); e != features.end(v); ++e)
        if(!is_visited[*e])
          visit(v, *e, false);
  for(int e = 0; e < graph.number_of_edges(); ++e) // what is left is closed
    if(graph.is_feature[e] && !is_visited[e])
      visit(graph.ends[e][0], e, !graph.is_border[e]);
  return result;
}

// Removes the chains that `removable_chains()` finds, the shortest first, until none is left. Removals can merge the
// chains that remain, which are then measured anew: so each round, which takes O(n log n) time, ends at a vertex when
// no more than two features are left there. Until then the other chains at the vertex stay as they are.
inline void remove_short_chains(Feature_graph& graph, const double minimum_length)
{
  for(std::set<Feature_chain> chains = removable_chains(graph, minimum_length); !chains.empty();
      chains = removable_chains(graph, minimum_length))
  {
    const Edges_around_vertices features = features_around_vertices(graph);
    std::map<int, int> number_left; // of features, at the ends of removed chains
    const auto may_be_merged = [&](const int vertex)
    {
      const auto changed = number_left.find(vertex);
      return changed != number_left.end() && changed->second <= 2;
    };
    for(const Feature_chain& chain : chains)
    {
      if(may_be_merged(chain.first_vertex) || may_be_merged(chain.last_vertex))
        continue;
      for(const int e : chain.edges)
        graph.is_feature[e] = false;
      for(const int vertex : { chain.first_vertex, chain.last_vertex })
        --number_left.insert({ vertex, features.number(vertex) }).first->second;
    }
  }
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FEATURE_GRAPH_H
