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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_OUTPUT_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_OUTPUT_H

#include <CGAL/Frame_fields/Streamline.h>
#include <CGAL/Frame_fields/internal/streamlines/Branch_directions.h>
#include <CGAL/Frame_fields/internal/streamlines/evenly_spaced_streamlines.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The point in space with the given barycentric coordinates in a face.
template <typename TriangleMesh>
Coordinates point_in_face(const Cut_mesh<TriangleMesh>& cut_mesh, const int face, const Corner_weights& weights)
{
  Coordinates result{ 0, 0, 0 };
  for(int corner = 0; corner < 3; ++corner)
  {
    const Coordinates p = cut_mesh.coordinates(target(cut_mesh.halfedge_of(3 * face + corner), cut_mesh.mesh()));
    for(int i = 0; i < 3; ++i)
      result[i] += weights[corner] * p[i];
  }
  return result;
}

// The label of the branch pairs (0 or 1) that the larger part of the length of the line has.
inline int branch_pair(const Branch_directions& directions, const Traced_streamline& traced)
{
  double excess_of_ones = 0;
  for(const Streamline_piece& piece : traced.pieces)
    excess_of_ones += directions.pair_label(piece.face, piece.branch) == 1 ? piece.length : -piece.length;
  return excess_of_ones > 0 ? 1 : 0;
}

// The streamline for the caller: n pieces give n + 1 points, n faces and n branches. There must be a piece.
template <typename GeomTraits, typename TriangleMesh>
Streamline<typename GeomTraits::Point_3, typename boost::graph_traits<TriangleMesh>::face_descriptor>
to_streamline(const Cut_mesh<TriangleMesh>& cut_mesh, const Branch_directions& directions,
              const Traced_streamline& traced, const GeomTraits& traits)
{
  typedef typename GeomTraits::FT FT;
  const auto point = [&](const int face, const Corner_weights& weights)
  {
    const Coordinates p = point_in_face(cut_mesh, face, weights);
    return traits.construct_point_3_object()(FT(p[0]), FT(p[1]), FT(p[2]));
  };

  const Streamline_piece& first = traced.pieces.front();
  Streamline<typename GeomTraits::Point_3, typename boost::graph_traits<TriangleMesh>::face_descriptor> result;
  result.branch_pair = branch_pair(directions, traced);
  result.is_closed = traced.is_closed;
  result.points.push_back(point(first.face, first.from));
  for(const Streamline_piece& piece : traced.pieces)
  {
    result.points.push_back(point(piece.face, piece.to));
    result.faces.push_back(cut_mesh.face_descriptors()[piece.face]);
    result.branches.push_back(piece.branch);
  }
  if(result.is_closed)
    result.points.back() = result.points.front();
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_OUTPUT_H
