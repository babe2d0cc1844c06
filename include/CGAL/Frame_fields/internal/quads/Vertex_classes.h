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
  // Joins two vertices; `unknown` has the value 0 and would separate them if it had not.
  void unite(const int a, const int b, const int unknown)
  {
    if(a != b)
      m_links.push_back({ a, b, unknown });
  }

  bool is_empty() const { return m_links.empty(); }

  // The class of each vertex, named by the least vertex in it.
  std::vector<int> representatives(const int number_of_vertices) const
  {
    std::vector<int> parent(number_of_vertices);
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v)
    {
      while(parent[v] != v)
        v = parent[v] = parent[parent[v]];
      return v;
    };
    for(const Link& link : m_links)
    {
      const int a = root(link.a), b = root(link.b);
      parent[(std::max)(a, b)] = (std::min)(a, b);
    }
    for(int v = 0; v < number_of_vertices; ++v)
      parent[v] = root(v);
    return parent;
  }

  // The unknowns on a shortest chain of links between two vertices of a class.
  std::vector<int> unknowns_between(const int a, const int b) const
  {
    std::vector<int> vertices;
    for(const Link& link : m_links)
    {
      vertices.push_back(link.a);
      vertices.push_back(link.b);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto place = [&](const int v)
    {
      return static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
    };
    std::vector<std::vector<int> > links_of(vertices.size());
    for(std::size_t l = 0; l < m_links.size(); ++l)
    {
      links_of[place(m_links[l].a)].push_back(static_cast<int>(l));
      links_of[place(m_links[l].b)].push_back(static_cast<int>(l));
    }

    const int unseen = -2;
    std::vector<int> arrival(vertices.size(), unseen); // the link by which a vertex was reached
    std::vector<int> queue(1, a);
    arrival[place(a)] = -1;
    for(std::size_t i = 0; i < queue.size() && arrival[place(b)] == unseen; ++i)
      for(const int l : links_of[place(queue[i])])
      {
        const int other = m_links[l].a == queue[i] ? m_links[l].b : m_links[l].a;
        if(arrival[place(other)] != unseen)
          continue;
        arrival[place(other)] = l;
        queue.push_back(other);
      }
    std::vector<int> unknowns;
    for(int v = b; arrival[place(v)] >= 0; )
    {
      const Link& link = m_links[arrival[place(v)]];
      unknowns.push_back(link.unknown);
      v = link.a == v ? link.b : link.a;
    }
    return unknowns;
  }

  // The unknowns of all links of the class of a vertex.
  std::vector<int> unknowns_of_class(const std::vector<int>& representative, const int vertex) const
  {
    std::vector<int> unknowns;
    for(const Link& link : m_links)
      if(representative[link.a] == representative[vertex])
        unknowns.push_back(link.unknown);
    return unknowns;
  }

private:
  struct Link
  {
    int a, b, unknown;
  };

  std::vector<Link> m_links;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_VERTEX_CLASSES_H
