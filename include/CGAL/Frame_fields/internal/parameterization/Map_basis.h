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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_MAP_BASIS_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_MAP_BASIS_H

#include <CGAL/Frame_fields/internal/parameterization/Combed_field.h>
#include <CGAL/Frame_fields/internal/parameterization/Cut_graph.h>
#include <CGAL/Frame_fields/internal/parameterization/Integer_relations.h>
#include <CGAL/Frame_fields/internal/parameterization/Zero_side_search.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Aligned and exactly seamless maps of a patch as x = B z: x holds u and v of vertex i of the disk at 2i and 2i + 1, z
// is free, and B has integer entries, so that integers z give a map on integers.
class Map_basis
{
public:
  Map_basis(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index, const Cut_graph& graph,
            const Combed_field& field)
    : m_surface(surface), m_patch(patch), m_index(index), m_graph(graph)
    , m_number_of_coordinates(2 * graph.number_of_vertices)
  {
    collect_side_edges(field);
    align();
    relate_sides_of_cuts();
  }

  // The number of entries of z.
  int size() const { return m_size; }
  int number_of_coordinates() const { return m_number_of_coordinates; }
  bool has_overflow() const { return m_has_overflow; }
  bool has_forced_zero_side() const { return m_forced_zero_side[0] >= 0; }

  // The sectors at both ends of a side that has, or part of which has, length 0 in all maps; -1 if there is none.
  const std::array<int, 2>& forced_zero_side() const { return m_forced_zero_side; }

  const std::vector<Side_edge>& side_edges() const { return m_side_edges; }

  // Calls `visit(unknown, coefficient)` for the entries of one row of B.
  template <typename Visit>
  void for_each_term(const int coordinate, const Visit& visit) const
  {
    for(int k = m_row_begin[coordinate]; k < m_row_begin[coordinate + 1]; ++k)
      visit(m_unknown[k], m_coefficient[k]);
  }

  // x = B z
  template <typename Number>
  void multiply(const std::vector<Number>& z, std::vector<Number>& x) const
  {
    x.assign(m_number_of_coordinates, Number(0));
    for(int i = 0; i < m_number_of_coordinates; ++i)
      for(int k = m_row_begin[i]; k < m_row_begin[i + 1]; ++k)
        x[i] += m_coefficient[k] * z[m_unknown[k]];
  }

  // z = B^T x
  void multiply_transposed(const std::vector<double>& x, std::vector<double>& z) const
  {
    z.assign(m_size, 0);
    for(int i = 0; i < m_number_of_coordinates; ++i)
      for(int k = m_row_begin[i]; k < m_row_begin[i + 1]; ++k)
        z[m_unknown[k]] += m_coefficient[k] * x[i];
  }

  // Gives the unknowns new numbers: the one that was `order[i]` becomes i.
  void reorder(const std::vector<int>& order)
  {
    std::vector<int> new_number(m_size);
    for(int i = 0; i < m_size; ++i)
      new_number[order[i]] = i;
    for(int& unknown : m_unknown)
      unknown = new_number[unknown];
  }

private:
  int vertex(const int halfedge) const { return m_graph.vertex[halfedge - 3 * m_patch.faces.begin_index]; }

  void collect_side_edges(const Combed_field& field)
  {
    for(int h = 3 * m_patch.faces.begin_index; h < 3 * m_patch.faces.end_index; ++h)
      if(m_surface.is_constrained(h))
      {
        const int branch = field.branch_along(h);
        m_side_edges.push_back({ h, vertex(previous_of(h)), vertex(h), branch % 2, branch < 2 ? 1 : -1 });
      }
  }

  // Merges the coordinates that are constant along a constrained edge into one variable.
  void align()
  {
    Disjoint_sets variables(m_number_of_coordinates);
    for(const Side_edge& e : m_side_edges)
    {
      const int kept = 1 - e.growing_coordinate;
      variables.unite(2 * e.source + kept, 2 * e.target + kept);
    }
    m_variable = variables.representatives();
  }

  // The variables are the coordinates and, after them, the translations of the branches of the cut graph.
  int translation(const std::size_t branch, const int coordinate) const
  {
    return m_number_of_coordinates + 2 * static_cast<int>(branch) + coordinate;
  }

  void relate_sides_of_cuts()
  {
    Integer_relations relations(weights());
    for(int coordinate = 0; coordinate < 2; ++coordinate)
      relations.add({ { m_variable[coordinate], 1 } }); // vertex 0 stays at the origin
    for(std::size_t b = 0; b < m_graph.branches.size() && !relations.has_overflow(); ++b)
    {
      const Index_range& range = m_graph.branches[b].halfedges;
      const int first = m_graph.halfedges[range.begin_index];
      relate(relations, b, vertex(previous_of(first)), vertex(m_surface.opposite[first]));
      for(int i = range.begin_index; i < range.end_index; ++i)
      {
        const int h = m_graph.halfedges[i];
        relate(relations, b, vertex(h), vertex(previous_of(m_surface.opposite[h])));
      }
    }
    m_forced_zero_side = Zero_side_search(m_surface, m_patch, m_index, m_side_edges)
      .first_side([&](const Side_edge& e) { return length_of(e); },
                  [&](const Integer_row& row) { return relations.reduced(row).empty(); });
    if(!relations.has_overflow())
      collect_rows(relations);
    m_has_overflow = relations.has_overflow();
  }

  // Per variable: how many coordinates it stands for, or how many edges of the cut its translation carries over.
  std::vector<int> weights() const
  {
    std::vector<int> weight(m_number_of_coordinates + 2 * m_graph.branches.size(), 0);
    for(int i = 0; i < m_number_of_coordinates; ++i)
      ++weight[m_variable[i]];
    for(std::size_t b = 0; b < m_graph.branches.size(); ++b)
      weight[translation(b, 0)] = weight[translation(b, 1)] = m_graph.branches[b].halfedges.size();
    return weight;
  }

  // Demands that a vertex on the right of a branch is the one on its left, turned and translated.
  void relate(Integer_relations& relations, const std::size_t branch, const int left, const int right)
  {
    const int turns = m_graph.branches[branch].quarter_turns;
    for(int coordinate = 0; coordinate < 2; ++coordinate)
    {
      // a quarter turn takes (u, v) to (-v, u)
      const int from = 2 * left + (coordinate + turns) % 2;
      const int sign = (coordinate == 0 ? turns == 1 || turns == 2 : turns == 2 || turns == 3) ? -1 : 1;
      relations.add({ { m_variable[2 * right + coordinate], 1 }, { m_variable[from], -sign },
                      { translation(branch, coordinate), -1 } });
    }
  }

  Integer_row length_of(const Side_edge& e) const
  {
    return { { m_variable[2 * e.target + e.growing_coordinate], e.sign },
             { m_variable[2 * e.source + e.growing_coordinate], -e.sign } };
  }

  void collect_rows(Integer_relations& relations)
  {
    std::vector<Integer_row> row_of(m_number_of_coordinates);
    for(int i = 0; i < m_number_of_coordinates; ++i)
      if(m_variable[i] == i)
        row_of[i] = relations.reduced({ { i, 1 } });
    std::vector<int> number_of_rows(relations.number_of_variables(), 0);
    for(int i = 0; i < m_number_of_coordinates; ++i)
      for(const Integer_term& term : row_of[m_variable[i]])
        ++number_of_rows[term.variable];

    // The unknowns that occur in many rows come last.
    std::vector<int> unknowns;
    for(int variable = 0; variable < relations.number_of_variables(); ++variable)
      if(number_of_rows[variable] > 0)
        unknowns.push_back(variable);
    std::stable_sort(unknowns.begin(), unknowns.end(),
                     [&](const int a, const int b) { return number_of_rows[a] < number_of_rows[b]; });
    std::vector<int> number_of(relations.number_of_variables(), -1);
    for(const int variable : unknowns)
      number_of[variable] = m_size++;

    m_row_begin.assign(1, 0);
    for(int i = 0; i < m_number_of_coordinates; ++i)
    {
      for(const Integer_term& term : row_of[m_variable[i]])
      {
        m_unknown.push_back(number_of[term.variable]);
        m_coefficient.push_back(static_cast<int>(term.coefficient));
      }
      m_row_begin.push_back(static_cast<int>(m_unknown.size()));
    }
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<int>& m_index;
  const Cut_graph& m_graph;
  std::vector<Side_edge> m_side_edges;
  std::vector<int> m_variable; // per coordinate: the first one that must have its value
  int m_number_of_coordinates;
  int m_size = 0;
  bool m_has_overflow = false;
  std::array<int, 2> m_forced_zero_side{ { -1, -1 } };
  std::vector<int> m_row_begin;   // per coordinate: B in compressed rows
  std::vector<int> m_unknown;     // per entry of B
  std::vector<int> m_coefficient; // per entry of B
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_MAP_BASIS_H
