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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_SURFACE_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_SURFACE_H

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/internal/surface/strict_floating_point.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// An interval of indices.
struct Index_range
{
  int begin_index, end_index;

  int size() const { return end_index - begin_index; }
};

// A connected piece of the cut surface. The faces, dual edges and sectors of a patch have consecutive indices.
struct Patch
{
  Index_range faces, dual_edges, sectors;
};

// An unconstrained edge: `halfedge` lies in face i and `opposite` in face j.
struct Dual_edge
{
  int halfedge, opposite;
};

// The surface cut along its constrained edges, in flat arrays. Face f has the halfedges 3f, 3f+1 and 3f+2; the first
// one is `halfedge(f, tm)` of the mesh. A halfedge also stands for the corner at its target. All angles are in radians.
// (Section 2 of the paper, whose field needs only the corner angles and the combinatorics; lengths serve weights, areas
// and distances.)
struct Cut_surface
{
  std::vector<Patch> patches;
  std::vector<double> angle;                 // per halfedge: the corner angle at its target
  std::vector<int> opposite;                 // per halfedge: its opposite, -1 on constrained edges
  std::vector<int> sector;                   // per halfedge: the sector of the corner at its target
  std::vector<int> first_corner;             // per sector: its clockwise-most corner, any corner if it is closed
  std::vector<double> total_angle;           // per sector
  std::vector<double> angle_in_space;        // per sector: its total angle in space, where all angles and lengths here
                                             // are those of another metric; empty otherwise
  std::vector<Dual_edge> dual_edges;
  std::vector<double> transport;             // per dual edge: c_ij
  Edge_weighting edge_weighting = Edge_weighting::UNIFORM;
  std::vector<double> weight;                // per dual edge: w_ij
  double length_unit = 1;                    // a power of two near the largest coordinate: no area overflows
  std::vector<double> length;                // per halfedge: in this unit; empty unless asked for
  std::vector<double> alignment;             // per face: the angle that a branch must keep, NaN if there is none
  std::vector<double> guide_angle;           // per face: the angle near which a branch should be; empty if not guided
  std::vector<double> guide_weight;          // per face: how strongly, 0 if not at all; empty if not guided
  std::vector<int> index_target;             // per sector: 4 I that it must get, or NO_INDEX_TARGET; empty if none must

  int number_of_faces() const { return static_cast<int>(angle.size() / 3); }
  int number_of_halfedges() const { return static_cast<int>(angle.size()); }
  int number_of_sectors() const { return static_cast<int>(total_angle.size()); }
  int number_of_dual_edges() const { return static_cast<int>(dual_edges.size()); }
  bool is_constrained(const int halfedge) const { return opposite[halfedge] < 0; }

  // Whether the sector begins and ends with constrained edges; otherwise its fan of corners is closed.
  bool is_constrained_sector(const int s) const;

  // The angle of a sector that tells how many quadrangles fit into it.
  double angle_of_sector(const int s) const { return angle_in_space.empty() ? total_angle[s] : angle_in_space[s]; }

  bool is_aligned(const int face) const { return !std::isnan(alignment[face]); }
};

inline int face_of(const int halfedge) { return halfedge / 3; }
inline int next_of(const int halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
inline int previous_of(const int halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }

inline bool Cut_surface::is_constrained_sector(const int s) const
{
  return is_constrained(next_of(first_corner[s]));
}

// The angle, from 0 to 2 pi, from the first halfedge of a face counter-clockwise to a halfedge of the same face.
inline double halfedge_angle(const Cut_surface& surface, const int halfedge)
{
  const int first = halfedge - halfedge % 3;
  switch(halfedge % 3)
  {
    case 0: return 0;
    case 1: return CGAL_PI - surface.angle[first];
    default: return CGAL_PI + surface.angle[first + 2];
  }
}

// Returns the first halfedge that is its own opposite or not the opposite of its opposite, -1 if there is none. If
// there is none, the step to the next corner of a sector is injective, and every walk around a sector ends.
inline int inconsistent_halfedge(const std::vector<int>& opposite)
{
  for(std::size_t h = 0; h < opposite.size(); ++h)
    if(const int other = opposite[h]; other >= 0)
      if(other == static_cast<int>(h) || opposite[other] != static_cast<int>(h))
        return static_cast<int>(h);
  return -1;
}

// Aligns each face that has a constrained edge with it, with the last one if there are more.
inline void align_with_constrained_edges(Cut_surface& surface)
{
  surface.alignment.assign(surface.number_of_faces(), std::numeric_limits<double>::quiet_NaN());
  for(int halfedge = 0; halfedge < surface.number_of_halfedges(); ++halfedge)
    if(surface.is_constrained(halfedge))
      surface.alignment[face_of(halfedge)] = halfedge_angle(surface, halfedge);
}

// Calls `visit(h)` for the corners of a sector in counter-clockwise order, from `first_corner` on. An open sector is
// visited whole only from its clockwise-most corner.
template <typename Visit>
void for_each_corner(const std::vector<int>& opposite, const int first_corner, const Visit& visit)
{
  int corner = first_corner;
  do
  {
    visit(corner);
    if(opposite[corner] < 0)
      return;
    corner = previous_of(opposite[corner]);
  } while(corner != first_corner);
}

// The clockwise-most corner of the sector of `corner`; `corner` itself if the sector is closed.
inline int clockwise_most_corner(const std::vector<int>& opposite, const int corner)
{
  int result = corner;
  do
  {
    const int outgoing = next_of(result);
    if(opposite[outgoing] < 0)
      return result;
    result = opposite[outgoing];
  } while(result != corner);
  return corner;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_SURFACE_H
