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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_POINTS_OF_SIDE_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_POINTS_OF_SIDE_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Arc_points.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/walk_along_border.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// How far a constrained halfedge runs in the map.
inline std::int64_t parametric_length(const Seamless_map& map, const int halfedge)
{
  const int source = previous_of(halfedge);
  return std::llabs(map.u[halfedge] - map.u[source]) + std::llabs(map.v[halfedge] - map.v[source]);
}

// How far a node on the border is behind the source of a constrained halfedge.
inline std::int64_t parametric_offset(const Seamless_map& map, const T_mesh_node& node, const int halfedge)
{
  if(node.halfedge < 0)
    return 0;
  const int source = previous_of(halfedge);
  return std::llabs(node.u - map.u[source]) + std::llabs(node.v - map.v[source]);
}

// The points of an arc where the map of one side puts the vertices of quads, as lengths from the beginning of the arc.
// There is one point for each edge of the side, at the source of the edge, in the order of the side. `number_of_edges`
// is per piece of the T-mesh.
inline std::vector<double> arc_points_of_side(const Cut_surface& surface, const Seamless_map& map,
                                              const Feature_network& network, const Arc_points& arc_points,
                                              const T_mesh& t_mesh, const Arc_side& side,
                                              const std::vector<int>& number_of_edges)
{
  std::vector<double> result;
  for(const int p : side.pieces)
  {
    const T_mesh_piece& piece = t_mesh.pieces[p];
    int halfedge = piece.halfedge;
    // From the source of the present halfedge to the beginning of the piece, and to the point that comes next.
    double begin = static_cast<double>(parametric_offset(map, t_mesh.nodes[piece.source], halfedge));
    for(int i = 0; i < number_of_edges[p]; ++i)
    {
      const double wanted = static_cast<double>(piece.parametric_length) * i / number_of_edges[p];
      double length = static_cast<double>(parametric_length(map, halfedge));
      while(begin + wanted > length)
      {
        const int next = next_on_border(surface, halfedge);
        if(network.arc[next] != network.arc[halfedge])
          break; // rounding at the end of the arc
        halfedge = next;
        begin -= length;
        length = static_cast<double>(parametric_length(map, halfedge));
      }
      const double fraction = (std::min)(1., (begin + wanted) / length);
      const double fraction_along_arc = side_of_arc(network, halfedge) == 0 ? fraction : 1 - fraction;
      result.push_back(arc_points.length_at(network.arc[halfedge], network.place[halfedge], fraction_along_arc));
    }
  }
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_ARC_POINTS_OF_SIDE_H
