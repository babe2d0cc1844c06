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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_DISJOINT_SETS_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_DISJOINT_SETS_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Disjoint sets of integers from 0 (with path halving). The least number of a set stands for it.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(const int size)
    : m_parent(size)
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }

  int find(int i)
  {
    while(m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  void unite(const int i, const int j)
  {
    const int a = find(i), b = find(j);
    m_parent[(std::max)(a, b)] = (std::min)(a, b);
  }

  // What stands for the set of each number.
  std::vector<int> representatives()
  {
    std::vector<int> result(m_parent.size());
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = find(static_cast<int>(i));
    return result;
  }

private:
  std::vector<int> m_parent;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_DISJOINT_SETS_H
