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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_CHARTS_H
#define CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_CHARTS_H

#include <CGAL/Frame_fields/internal/integer_grid/Cell_walker.h>
#include <CGAL/Frame_fields/internal/integer_grid/Quantized_cells.h>
#include <CGAL/Frame_fields/internal/integer_grid/Rigid_motion.h>
#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The charts of an integer-grid map of a patch, as the numbers of edges of the T-mesh prescribe them: the motions
// between neighboring faces, which are integers, and where the corners of the faces are if each cell is stretched to
// its numbers of edges. The axes of a face are those of the seamless map.
class Integer_grid_charts
{
public:
  Integer_grid_charts(const Cut_surface& surface, const Patch& patch, const Seamless_map& map, const T_mesh& t_mesh,
                      const std::vector<int>& edges_of_piece)
    : m_surface(surface), m_patch(patch), m_map(map), m_charts(surface, map), m_cells(t_mesh, edges_of_piece)
    , m_walker(surface, m_charts, t_mesh, m_cells), m_place(patch.faces.size())
    , m_across(3 * static_cast<std::size_t>(patch.faces.size()))
  {}

  // Returns false if the numbers of edges do not fit to the map, which would be a fault of an earlier stage.
  bool compute() { return find_motions() && place_corners(); }

  // From the chart of the face of an unconstrained halfedge to the chart on its other side.
  const Rigid_motion& motion_across(const int halfedge) const { return m_across[local(halfedge)]; }

  // Per halfedge of the patch: where the corner at its target is in the chart of its face.
  const std::vector<std::array<double, 2> >& corners() const { return m_corner; }

private:
  std::size_t local(const int halfedge) const
  {
    return static_cast<std::size_t>(halfedge - 3 * m_patch.faces.begin_index);
  }
  Cell_place& place_of(const int face) { return m_place[face - m_patch.faces.begin_index]; }

  // From the centroid of the face of the place to the centroid of the face behind a halfedge.
  bool walk_across(Cell_place& place, const int halfedge) const
  {
    if(!m_walker.walk(place, m_walker.centroid(place.face), m_walker.midpoint(halfedge)))
      return false;
    m_walker.cross_halfedge(place, halfedge);
    return m_walker.walk(place, m_walker.midpoint(m_surface.opposite[halfedge]), m_walker.centroid(place.face));
  }

  // Finds a cell for the centroid of every face and the motions across all edges, from face to face.
  bool find_motions()
  {
    std::vector<char> is_placed(m_patch.faces.size(), 0), is_found(m_across.size(), 0);
    const auto place_at = [&](const int face, Cell_place place)
    {
      place.counts = Rigid_motion();
      place_of(face) = place;
      is_placed[face - m_patch.faces.begin_index] = 1;
    };
    Grid_vector corner;
    Cell_place first = m_walker.at_first_corner(0, corner);
    if(!m_walker.walk(first, corner, m_walker.centroid(first.face)))
      return false;
    place_at(first.face, first);
    std::vector<int> queue{ first.face };
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h)
      {
        if(m_surface.is_constrained(h) || is_found[local(h)])
          continue;
        const int opposite = m_surface.opposite[h], neighbor = face_of(opposite);
        Cell_place place = place_of(queue[i]);
        if(!walk_across(place, h))
          return false;
        if(!is_placed[neighbor - m_patch.faces.begin_index])
        {
          place_at(neighbor, place);
          queue.push_back(neighbor);
        }
        else if(!m_walker.change_cell(place, place_of(neighbor), m_walker.centroid(neighbor)))
          return false;
        const Rigid_motion motion = turning(4 - place.to_cell.quarter_turns) * place.counts
                                  * turning(place_of(queue[i]).to_cell.quarter_turns);
        if(motion.quarter_turns != m_map.quarter_turns[h])
          return false;
        m_across[local(h)] = motion;
        m_across[local(opposite)] = inverse(motion);
        is_found[local(h)] = is_found[local(opposite)] = 1;
      }
    return queue.size() == is_placed.size();
  }

  bool place_corners()
  {
    m_corner.resize(m_across.size());
    for(int h = 3 * m_patch.faces.begin_index; h < 3 * m_patch.faces.end_index; ++h)
    {
      Cell_place place = place_of(face_of(h));
      const Grid_vector target = Cell_walker::sixfold(m_charts.point(h));
      if(!m_walker.walk(place, m_walker.centroid(place.face), target))
        return false;
      const Grid_vector in_cell = place.to_cell(m_charts.point(h));
      const std::array<double, 2> counts = m_cells.to_counts(
        place.cell, { { static_cast<double>(in_cell.u), static_cast<double>(in_cell.v) } });
      const Rigid_motion back =
        turning(4 - place_of(face_of(h)).to_cell.quarter_turns) * inverse(place.counts);
      m_corner[local(h)] = moved(back, counts);
    }
    return true;
  }

  static std::array<double, 2> moved(const Rigid_motion& motion, const std::array<double, 2>& p)
  {
    const double u = static_cast<double>(motion.shift.u), v = static_cast<double>(motion.shift.v);
    switch(motion.quarter_turns)
    {
      case 0: return { u + p[0], v + p[1] };
      case 1: return { u - p[1], v + p[0] };
      case 2: return { u - p[0], v - p[1] };
      default: return { u + p[1], v - p[0] };
    }
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const Seamless_map& m_map;
  Seamless_charts m_charts;
  Quantized_cells m_cells;
  Cell_walker m_walker;
  std::vector<Cell_place> m_place;               // per face of the patch: at its centroid
  std::vector<Rigid_motion> m_across;            // per halfedge of the patch
  std::vector<std::array<double, 2> > m_corner;  // per halfedge of the patch
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_CHARTS_H
