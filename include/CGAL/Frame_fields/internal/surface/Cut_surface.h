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

#include <algorithm>
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

// The surface cut along its constrained edges, in flat arrays. Face f has the halfedges 3f, 3f+1 and 3f+2, the first of
// which is that of the mesh. A halfedge stands for the corner at its target as well. (Section 2 of the paper; only
// corner angles and the combinatorics are needed.)
struct Cut_surface
{
  std::vector<Patch> patches;
  std::vector<double> angle;                 // per halfedge: the corner angle at its target
  std::vector<int> opposite;                 // per halfedge: its opposite, -1 on constrained edges
  std::vector<int> sector;                   // per halfedge: the sector of the corner at its target
  std::vector<int> first_corner;             // per sector: its clockwise-most corner, any one if it is closed
  std::vector<double> total_angle;           // per sector
  std::vector<Dual_edge> dual_edges;
  std::vector<double> transport;             // per dual edge: c_ij
  Edge_weighting edge_weighting = UNIFORM_WEIGHTS;
  std::vector<double> weight;                // per dual edge: w_ij
  double length_unit = 1;                    // a power of two near the size of the mesh: areas do not overflow then
  std::vector<double> length;                // per halfedge: its length in this unit; empty unless asked for
  std::vector<double> alignment;             // per face: the angle that a branch must keep, NaN if there is none
  std::vector<double> guide_angle;           // per face: the angle near which a branch should be; empty if not guided
  std::vector<double> guide_weight;          // per face: how strongly, 0 if not at all; empty if not guided
  std::vector<int> index_target;             // per sector: 4 I that it must get, or NO_INDEX_TARGET; empty if none must

  int number_of_faces() const { return static_cast<int>(angle.size() / 3); }
  int number_of_halfedges() const { return static_cast<int>(angle.size()); }
  int number_of_sectors() const { return static_cast<int>(total_angle.size()); }
  int number_of_dual_edges() const { return static_cast<int>(dual_edges.size()); }
  bool is_constrained(const int halfedge) const { return opposite[halfedge] < 0; }

  // A sector is on a constrained edge unless its fan of corners is closed.
  bool is_constrained_sector(const int s) const;

  bool is_aligned(const int face) const { return !std::isnan(alignment[face]); }
};

inline int face_of(const int halfedge) { return halfedge / 3; }
inline int next_of(const int halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
inline int previous_of(const int halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }

inline bool Cut_surface::is_constrained_sector(const int s) const
{
  return is_constrained(next_of(first_corner[s]));
}

// The angle of a halfedge counted counter-clockwise from the first halfedge of its face.
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

// A halfedge that is not the opposite of its opposite, or is its own; -1 if there is none. Then to go on to the next
// corner of a sector is a permutation, and every walk around a sector comes to an end.
inline int inconsistent_halfedge(const std::vector<int>& opposite)
{
  for(std::size_t h = 0; h < opposite.size(); ++h)
    if(const int other = opposite[h]; other >= 0)
      if(other == static_cast<int>(h) || opposite[other] != static_cast<int>(h))
        return static_cast<int>(h);
  return -1;
}

// Aligns the faces with their constrained edges.
inline void align_with_constrained_edges(Cut_surface& surface)
{
  surface.alignment.assign(surface.number_of_faces(), std::numeric_limits<double>::quiet_NaN());
  for(int halfedge = 0; halfedge < surface.number_of_halfedges(); ++halfedge)
    if(surface.is_constrained(halfedge))
      surface.alignment[face_of(halfedge)] = halfedge_angle(surface, halfedge);
}

// Calls `visit(h)` for the corners of a sector in counter-clockwise order.
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

// Vertices less edges plus faces of a patch that is cut along its constrained edges.
inline int euler_characteristic(const Patch& patch)
{
  const int number_of_constrained_sides = 3 * patch.faces.size() - 2 * patch.dual_edges.size();
  return patch.sectors.size() - patch.dual_edges.size() - number_of_constrained_sides + patch.faces.size();
}

// Gives each face the number of its patch, patches numbered in the order of their first faces; returns their number.
inline int number_patches(const std::vector<int>& opposite, std::vector<int>& patch_of_face)
{
  const int number_of_faces = static_cast<int>(opposite.size() / 3);
  patch_of_face.assign(number_of_faces, -1);
  int number_of_patches = 0;
  std::vector<int> stack;
  for(int seed = 0; seed < number_of_faces; ++seed)
  {
    if(patch_of_face[seed] >= 0)
      continue;
    patch_of_face[seed] = number_of_patches;
    stack.push_back(seed);
    while(!stack.empty())
    {
      const int face = stack.back();
      stack.pop_back();
      for(int halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
        if(opposite[halfedge] >= 0 && patch_of_face[face_of(opposite[halfedge])] < 0)
        {
          patch_of_face[face_of(opposite[halfedge])] = number_of_patches;
          stack.push_back(face_of(opposite[halfedge]));
        }
    }
    ++number_of_patches;
  }
  return number_of_patches;
}

// Sorts the faces by patches, keeping their order inside each patch: face `order[f]` becomes face f.
inline std::vector<int> face_order_by_patches(const std::vector<int>& patch_of_face, const int number_of_patches,
                                              std::vector<Patch>& patches)
{
  std::vector<int> next_place(static_cast<std::size_t>(number_of_patches) + 1, 0);
  for(const int patch : patch_of_face)
    ++next_place[patch + 1];
  for(int patch = 0; patch < number_of_patches; ++patch)
    next_place[patch + 1] += next_place[patch];

  patches.resize(number_of_patches);
  for(int patch = 0; patch < number_of_patches; ++patch)
    patches[patch].faces = { next_place[patch], next_place[patch + 1] };

  std::vector<int> order(patch_of_face.size());
  for(std::size_t face = 0; face < patch_of_face.size(); ++face)
    order[next_place[patch_of_face[face]]++] = static_cast<int>(face);
  return order;
}

inline std::vector<int> reorder_opposites(const std::vector<int>& opposite, const std::vector<int>& face_order)
{
  std::vector<int> new_face(face_order.size());
  for(std::size_t face = 0; face < face_order.size(); ++face)
    new_face[face_order[face]] = static_cast<int>(face);

  std::vector<int> result(opposite.size());
  for(std::size_t halfedge = 0; halfedge < result.size(); ++halfedge)
  {
    const int old_opposite = opposite[3 * static_cast<std::size_t>(face_order[halfedge / 3]) + halfedge % 3];
    result[halfedge] = old_opposite < 0 ? -1 : 3 * new_face[face_of(old_opposite)] + old_opposite % 3;
  }
  return result;
}

// The height of a triangle over the edge of a halfedge divided by the length of that edge.
inline double height_over_length(const Cut_surface& surface, const int halfedge)
{
  const double at_target = surface.angle[halfedge], at_source = surface.angle[previous_of(halfedge)];
  const double length_over_height =
    std::sin(at_target + at_source) / (std::sin(at_target) * std::sin(at_source));
  return std::isnan(length_over_height) ? 0 : 1 / length_over_height; // 0 / 0 in a triangle without area
}

inline double edge_weight(const Cut_surface& surface, const Dual_edge& e, const Edge_weighting weighting)
{
  if(weighting == UNIFORM_WEIGHTS)
    return 1;
  // In needles and caps one of the two ratios may be infinite; the bounds keep the systems solvable.
  const double smallest = 1e-6, largest = 1e6;
  const double dual_over_primal = height_over_length(surface, e.halfedge) + height_over_length(surface, e.opposite);
  return (std::min)(largest, (std::max)(smallest, std::sqrt(3.) / dual_over_primal));
}

inline double area(const Cut_surface& surface, const int face)
{
  const int h = 3 * face;
  return surface.length[h] * surface.length[h + 1] * std::sin(surface.angle[h]) / 2;
}

// The weight of |z - z_guide|^2 in a face. With uniform edge weights it is the one given; otherwise the sum over the
// faces is an integral, as it is for the relaxation.
inline double guide_weight(const Cut_surface& surface, const int face)
{
  if(surface.guide_weight.empty() || surface.guide_weight[face] == 0)
    return 0;
  double weight = surface.guide_weight[face];
  if(surface.edge_weighting != UNIFORM_WEIGHTS)
    weight *= surface.length_unit * area(surface, face) / std::sqrt(3.) * surface.length_unit;
  // The edges have weights of about 1. A much larger weight would drown them, and holds the frame as it is.
  const double largest = 1e8;
  return (std::min)(largest, weight);
}

// A weight that is not more is lost in the rounding errors of the edge weights.
constexpr double smallest_effective_weight = 1e-12;

inline double patch_area(const Cut_surface& surface, const Patch& patch)
{
  double sum = 0;
  for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
    sum += area(surface, f);
  return sum;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_SURFACE_H
