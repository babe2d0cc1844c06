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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_VERTEX_CLASSES_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_VERTEX_CLASSES_H

#include <CGAL/Frame_fields/internal/surface/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Vertices that coincide because something between them has no width, with the unknowns that would hold them apart.
class Vertex_classes
{
public:
  // Joins two vertices that coincide as `unknown` has the value 0.
  void unite(const int a, const int b, const int unknown)
  {
    if(a != b)
      m_links.push_back({ a, b, unknown });
  }

  bool is_empty() const { return m_links.empty(); }

  // The class of each vertex, named by its smallest vertex. Call this before the functions below, and again after
  // `unite()`.
  std::vector<int> representatives(const int number_of_vertices)
  {
    m_number_of_vertices = number_of_vertices;
    m_first_place.clear();
    Disjoint_sets classes(number_of_vertices);
    for(const Link& link : m_links)
      classes.unite(link.a, link.b);
    return classes.representatives();
  }

  // The unknowns on a shortest chain of links between two vertices of a class, in time linear in the class.
  std::vector<int> unknowns_between(const int a, const int b)
  {
    sort_links();
    m_queue.assign(1, a);
    m_arrival[a] = START;
    for(std::size_t i = 0; i < m_queue.size() && m_arrival[b] == UNSEEN; ++i)
      for(int place = m_first_place[m_queue[i]]; place < m_first_place[m_queue[i] + 1]; ++place)
      {
        const Link& link = m_links[m_links_of[place]];
        const int other = link.a == m_queue[i] ? link.b : link.a;
        if(m_arrival[other] != UNSEEN)
          continue;
        m_arrival[other] = m_links_of[place];
        m_queue.push_back(other);
      }
    std::vector<int> unknowns;
    for(int v = b; m_arrival[v] >= 0; )
    {
      const Link& link = m_links[m_arrival[v]];
      unknowns.push_back(link.unknown);
      v = link.a == v ? link.b : link.a;
    }
    for(const int v : m_queue)
      m_arrival[v] = UNSEEN;
    return unknowns;
  }

  // The unknowns of all links of the class of a vertex, which may name an unknown more than once.
  std::vector<int> unknowns_of_class(const int vertex)
  {
    sort_links();
    m_queue.assign(1, vertex);
    m_arrival[vertex] = START;
    std::vector<int> links;
    for(std::size_t i = 0; i < m_queue.size(); ++i)
      for(int place = m_first_place[m_queue[i]]; place < m_first_place[m_queue[i] + 1]; ++place)
      {
        const Link& link = m_links[m_links_of[place]];
        links.push_back(m_links_of[place]);
        for(const int end : { link.a, link.b })
          if(m_arrival[end] == UNSEEN)
          {
            m_arrival[end] = m_links_of[place];
            m_queue.push_back(end);
          }
      }
    for(const int v : m_queue)
      m_arrival[v] = UNSEEN;
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
    for(int& link : links)
      link = m_links[link].unknown;
    return links;
  }

private:
  enum { UNSEEN = -2, START = -1 };

  struct Link
  {
    int a, b, unknown;
  };

  // Lists the links of each vertex, once all have been made.
  void sort_links()
  {
    if(!m_first_place.empty())
      return;
    m_first_place.assign(static_cast<std::size_t>(m_number_of_vertices) + 1, 0);
    m_arrival.assign(m_number_of_vertices, UNSEEN);
    for(const Link& link : m_links)
    {
      ++m_first_place[link.a + 1];
      ++m_first_place[link.b + 1];
    }
    std::partial_sum(m_first_place.begin(), m_first_place.end(), m_first_place.begin());
    m_links_of.resize(2 * m_links.size());
    std::vector<int> next(m_first_place);
    for(std::size_t l = 0; l < m_links.size(); ++l)
      for(const int v : { m_links[l].a, m_links[l].b })
        m_links_of[next[v]++] = static_cast<int>(l);
  }

  std::vector<Link> m_links;
  int m_number_of_vertices = 0;
  std::vector<int> m_first_place, m_links_of; // per vertex: its links; empty until `sort_links()`
  std::vector<int> m_arrival, m_queue;        // of searches: the link by which a vertex was reached
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_VERTEX_CLASSES_H
