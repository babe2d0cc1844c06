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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_TRIANGULATE_PATCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_TRIANGULATE_PATCH_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Patch_triangulation.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The vertices of the quads along each feature arc: one more than it has edges, from node to node, or in a loop as many
// as edges.
typedef std::vector<std::vector<int> > Arc_vertices;

inline int number_of_edges(const Arc_vertices& arc_vertices, const Feature_network& network, const int arc)
{
  return static_cast<int>(arc_vertices[arc].size()) - (network.arcs[arc].is_loop ? 0 : 1);
}

// Makes the triangles of a patch, cut such that every second vertex of the quads on its arcs is a vertex. Each two
// successive edges of the quads on an arc are a segment of the border, which may still consist of several halfedges.
class Border_cutter
{
public:
  Border_cutter(const Surface_walker& walker, const Cut_surface& surface, const Surface_embedding& embedding,
                const Feature_network& network, const Patch& patch, const Arc_vertices& arc_vertices,
                const Quad_complex& complex)
    : m_walker(walker), m_surface(surface), m_embedding(embedding), m_network(network), m_patch(patch)
    , m_arc_vertices(arc_vertices), m_complex(complex), m_first_segment(network.arcs.size())
  {}

  Patch_triangulation run()
  {
    copy_faces();
    std::vector<char> is_done(m_network.arcs.size(), false);
    for(int h = 3 * m_patch.faces.begin_index; h < 3 * m_patch.faces.end_index; ++h)
    {
      const int arc = m_surface.is_constrained(h) ? m_network.arc[h] : -1;
      if(arc < 0 || is_done[arc])
        continue;
      is_done[arc] = true;
      m_first_segment[arc] = static_cast<int>(m_arc_of_segment.size());
      for(int i = 0; i < number_of_edges(m_arc_vertices, m_network, arc) / 2; ++i)
      {
        m_arc_of_segment.push_back(arc);
        m_place_of_segment.push_back(i);
      }
      cut_arc(arc);
    }
    return m_triangulation;
  }

  // The vertex of the quads in the middle of a segment.
  int middle_of_segment(const int segment) const
  {
    return m_arc_vertices[m_arc_of_segment[segment]][2 * m_place_of_segment[segment] + 1];
  }

private:
  int local_halfedge(const int h) const { return h - 3 * m_patch.faces.begin_index; }
  int local_vertex(const int h) const { return m_surface.sector[h] - m_patch.sectors.begin_index; }

  // The segment of a halfedge of the border until it is cut itself. It tells which one it is, as the halfedge gets
  // another number when the one beside it in its face is cut.
  static int to_be_cut(const int halfedge) { return -2 - halfedge; }

  void copy_faces()
  {
    Patch_triangulation& t = m_triangulation;
    const std::size_t number_of_halfedges = 3 * static_cast<std::size_t>(m_patch.faces.size());
    t.vertices.resize(m_patch.sectors.size());
    t.corner.assign(m_patch.sectors.size(), -1);
    t.segment.assign(number_of_halfedges, -1);
    t.is_alive.assign(m_patch.faces.size(), true);
    m_current.resize(number_of_halfedges);
    std::iota(m_current.begin(), m_current.end(), 0);
    for(int h = 3 * m_patch.faces.begin_index; h < 3 * m_patch.faces.end_index; ++h)
    {
      const int v = local_vertex(h);
      t.target.push_back(v);
      t.opposite.push_back(m_surface.opposite[h] < 0 ? -1 : local_halfedge(m_surface.opposite[h]));
      t.corner[v] = local_halfedge(h);
      t.vertices[v].point = m_walker.target(h);
      t.vertices[v].location = location_on_halfedge(h, 1);
      if(m_surface.is_constrained(h))
        t.segment[local_halfedge(h)] = to_be_cut(local_halfedge(h));
      if(m_network.is_node[m_embedding.vertex[h]] && !m_surface.is_constrained_sector(m_surface.sector[h]))
        t.vertices[v].mesh_vertex = m_embedding.vertex[h];
    }
  }

  // A place where an arc is cut: at the start of a halfedge of it, or inside.
  struct Cut
  {
    int place;
    double fraction;
    bool is_at_start;
    int id;
  };

  std::vector<Cut> cuts_of_arc(const int arc) const
  {
    const std::vector<int>& ids = m_arc_vertices[arc];
    const bool is_loop = m_network.arcs[arc].is_loop;
    const int number_of_places = static_cast<int>(m_network.arcs[arc].halfedges.size());
    const int number_of_segments = number_of_edges(m_arc_vertices, m_network, arc) / 2;
    std::vector<Cut> cuts;
    double last = 0;
    int last_start = is_loop ? -1 : 0; // the last halfedge that is cut at its start
    const int first_cut = is_loop ? first_of_loop(ids) : 1;
    for(int i = 0; i < number_of_segments - (is_loop ? 0 : 1); ++i)
    {
      const int id = ids[2 * static_cast<std::size_t>((first_cut + i) % number_of_segments)];
      last = (std::max)(last, (std::min)(m_complex.vertices[id].position, double(number_of_places)));
      const int place = (std::min)(static_cast<int>(last), number_of_places - 1);
      const bool is_at_start = last == place && place > last_start && (cuts.empty() || cuts.back().place < place);
      cuts.push_back({ place, last - place, is_at_start, id });
      last_start = is_at_start ? place : last_start;
    }
    return cuts;
  }

  // The segment of a loop whose first vertex has the smallest position.
  int first_of_loop(const std::vector<int>& ids) const
  {
    int first = 0;
    for(int i = 0; i < static_cast<int>(ids.size()) / 2; ++i)
      if(m_complex.vertices[ids[2 * static_cast<std::size_t>(i)]].position
         < m_complex.vertices[ids[2 * static_cast<std::size_t>(first)]].position)
        first = i;
    return first;
  }

  void cut_arc(const int arc)
  {
    const std::vector<Cut> cuts = cuts_of_arc(arc);
    const bool is_loop = m_network.arcs[arc].is_loop;
    const int number_of_segments = number_of_edges(m_arc_vertices, m_network, arc) / 2;
    const int first_cut = is_loop ? first_of_loop(m_arc_vertices[arc]) : 1;
    std::size_t next_cut = 0;
    for(int place = 0; place < static_cast<int>(m_network.arcs[arc].halfedges.size()); ++place)
    {
      const std::size_t begin = next_cut;
      while(next_cut < cuts.size() && cuts[next_cut].place == place)
        ++next_cut;
      const int h = m_network.arcs[arc].halfedges[place];
      for(const int side : { h, m_embedding.twin[h] })
        if(side >= 0 && face_of(side) >= m_patch.faces.begin_index && face_of(side) < m_patch.faces.end_index)
          cut_side(side, side == h, cuts, begin, next_cut, number_of_segments, first_cut + number_of_segments - 1, arc);
      if(!is_loop)
        name_ends(arc, place, h);
    }
  }

  // Cuts one halfedge at the cuts from `begin` to `end`. The segment before cut i is `segment_before` + i.
  void cut_side(const int side, const bool is_forward, const std::vector<Cut>& cuts, const std::size_t begin,
                const std::size_t end, const int number_of_segments, const int segment_before, const int arc)
  {
    const auto segment = [&](const std::size_t cut)
    {
      return m_first_segment[arc] + (segment_before + static_cast<int>(cut)) % number_of_segments;
    };
    std::size_t from = begin;
    if(begin < end && cuts[begin].is_at_start)
    {
      const int at_start = local_vertex(is_forward ? previous_of(side) : side);
      m_triangulation.vertices[at_start].id = cuts[begin].id;
      ++from;
    }
    int rest = m_current[local_halfedge(side)];
    m_triangulation.segment[rest] = segment(is_forward ? from : end);
    for(std::size_t i = 0; i < end - from; ++i)
    {
      const std::size_t cut = is_forward ? from + i : end - 1 - i;
      const double fraction = is_forward ? cuts[cut].fraction : 1 - cuts[cut].fraction;
      const Surface_location location = location_on_halfedge(side, fraction);
      const int v = m_triangulation.add_vertex(location, m_walker.point(location));
      m_triangulation.vertices[v].id = cuts[cut].id;
      rest = m_triangulation.split_edge(rest, v);
      m_triangulation.segment[rest] = segment(is_forward ? cut + 1 : cut);
      const int moved = m_triangulation.segment[next_of(rest)];
      if(moved < -1)
        m_current[to_be_cut(moved)] = next_of(rest);
    }
  }

  // Gives the vertices at the ends of an arc the numbers of the vertices of the quads there.
  void name_ends(const int arc, const int place, const int h)
  {
    const std::vector<int>& ids = m_arc_vertices[arc];
    const int twin = m_embedding.twin[h], last = static_cast<int>(m_network.arcs[arc].halfedges.size()) - 1;
    const auto name = [&](const int corner, const int id)
    {
      if(corner >= 0 && face_of(corner) >= m_patch.faces.begin_index && face_of(corner) < m_patch.faces.end_index)
        m_triangulation.vertices[local_vertex(corner)].id = id;
    };
    if(place == 0)
    {
      name(previous_of(h), ids.front());
      name(twin, ids.front());
    }
    if(place == last)
    {
      name(h, ids.back());
      name(twin >= 0 ? previous_of(twin) : -1, ids.back());
    }
  }

  const Surface_walker& m_walker;
  const Cut_surface& m_surface;
  const Surface_embedding& m_embedding;
  const Feature_network& m_network;
  const Patch& m_patch;
  const Arc_vertices& m_arc_vertices;
  const Quad_complex& m_complex;
  Patch_triangulation m_triangulation;
  std::vector<int> m_current;                            // per halfedge of the patch: where it is by now
  std::vector<int> m_first_segment;                      // per arc of the patch
  std::vector<int> m_arc_of_segment, m_place_of_segment; // per segment
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_TRIANGULATE_PATCH_H
