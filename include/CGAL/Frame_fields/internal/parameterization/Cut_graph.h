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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_CUT_GRAPH_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_CUT_GRAPH_H

#include <CGAL/Frame_fields/internal/parameterization/Combing.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A chain of cut edges without a node inside, given by its halfedges on the left. All charts on its right are turned
// against those on its left by the same number of quarter turns.
struct Cut_branch
{
  Index_range halfedges; // in `Cut_graph::halfedges`
  unsigned char quarter_turns;
};

// The edges along which a patch is cut so that it becomes a disk with all singularities on its border, and the vertices
// of this disk.
struct Cut_graph
{
  std::vector<char> is_cut;          // per halfedge of the patch
  std::vector<int> vertex;           // per halfedge of the patch: the vertex of the disk at its target
  int number_of_vertices = 0;
  std::vector<int> halfedges;        // of the branches, one after the other
  std::vector<Cut_branch> branches;
};

// Cuts a patch along the edges that its combing does not cross.
class Patch_cutter
{
public:
  Patch_cutter(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index, const Combing& combing)
    : m_surface(surface), m_patch(patch), m_index(index), m_combing(combing)
    , m_degree(patch.sectors.size(), 0)
  {
    m_graph.is_cut.resize(3 * static_cast<std::size_t>(patch.faces.size()));
    for(int h = first_halfedge(); h < end_of_halfedges(); ++h)
    {
      m_graph.is_cut[local(h)] = !surface.is_constrained(h) && !combing.is_crossed[local(h)];
      if(is_cut(h))
        ++degree(h);
    }
  }

  Cut_graph cut()
  {
    prune();
    number_vertices();
    collect_branches();
    return std::move(m_graph);
  }

private:
  int first_halfedge() const { return 3 * m_patch.faces.begin_index; }
  int end_of_halfedges() const { return 3 * m_patch.faces.end_index; }
  int local(const int halfedge) const { return halfedge - first_halfedge(); }
  bool is_cut(const int halfedge) const { return m_graph.is_cut[local(halfedge)]; }

  // The number of cut edges that end at the target of a halfedge.
  int& degree(const int halfedge) { return m_degree[m_surface.sector[halfedge] - m_patch.sectors.begin_index]; }

  bool must_be_cut(const int sector) const
  {
    return m_index[sector] != 0 || m_surface.is_constrained_sector(sector);
  }

  // Removes cut edges that end at regular sectors, until there are none.
  void prune()
  {
    std::vector<int> ends; // halfedges to them
    const auto add_if_end = [&](const int h)
    {
      if(is_cut(h) && degree(h) == 1 && m_combing.quarter_turns[local(h)] == 0
         && !must_be_cut(m_surface.sector[h]))
        ends.push_back(h);
    };
    for(int h = first_halfedge(); h < end_of_halfedges(); ++h)
      add_if_end(h);
    while(!ends.empty())
    {
      const int h = ends.back(), opposite = m_surface.opposite[h];
      ends.pop_back();
      if(!is_cut(h))
        continue; // both ends were dead
      m_graph.is_cut[local(h)] = m_graph.is_cut[local(opposite)] = false;
      --degree(h);
      --degree(opposite);
      if(degree(opposite) == 1)
        for_each_corner(m_surface.opposite, m_surface.first_corner[m_surface.sector[opposite]], add_if_end);
    }
  }

  // Walks around each sector, and gives the corners between two cut edges one vertex.
  void number_vertices()
  {
    m_graph.vertex.resize(m_graph.is_cut.size());
    for(int s = m_patch.sectors.begin_index; s < m_patch.sectors.end_index; ++s)
    {
      int first = m_surface.first_corner[s];
      if(!m_surface.is_constrained_sector(s))
        for_each_corner(m_surface.opposite, m_surface.first_corner[s], [&](const int corner)
        {
          if(is_cut(corner))
            first = previous_of(m_surface.opposite[corner]);
        });
      int last = first;
      for_each_corner(m_surface.opposite, first, [&](const int corner)
      {
        m_graph.vertex[local(corner)] = m_graph.number_of_vertices;
        if(is_cut(corner))
          ++m_graph.number_of_vertices;
        last = corner;
      });
      if(!is_cut(last))
        ++m_graph.number_of_vertices;
    }
  }

  bool is_node(const int halfedge)
  {
    return degree(halfedge) != 2 || must_be_cut(m_surface.sector[halfedge]);
  }

  void collect_branches()
  {
    std::vector<char> is_walked(m_graph.is_cut.size(), false);
    const auto walk_if_new = [&](const int h)
    {
      if(is_cut(h) && !is_walked[local(h)])
        walk(h, is_walked);
    };
    for(int h = first_halfedge(); h < end_of_halfedges(); ++h)
      if(is_cut(h) && is_node(m_surface.opposite[h]))
        walk_if_new(h);
    for(int h = first_halfedge(); h < end_of_halfedges(); ++h)
      walk_if_new(h); // a loop without a node
  }

  void walk(const int first, std::vector<char>& is_walked)
  {
    const int begin = static_cast<int>(m_graph.halfedges.size());
    const unsigned char quarter_turns = m_combing.quarter_turns[local(first)];
    int h = first;
    while(true)
    {
      m_graph.halfedges.push_back(h);
      is_walked[local(h)] = is_walked[local(m_surface.opposite[h])] = true;
      if(is_node(h))
        break;
      int next = next_of(h);
      while(!is_cut(next))
        next = next_of(m_surface.opposite[next]);
      if(is_walked[local(next)] || m_combing.quarter_turns[local(next)] != quarter_turns)
        break;
      h = next;
    }
    m_graph.branches.push_back({ { begin, static_cast<int>(m_graph.halfedges.size()) }, quarter_turns });
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<int>& m_index;
  const Combing& m_combing;
  std::vector<int> m_degree; // per sector of the patch: the number of cut edges there
  Cut_graph m_graph;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_CUT_GRAPH_H
