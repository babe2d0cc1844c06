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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_PARAMETERS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_PARAMETERS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Quad_quality.h>
#include <CGAL/Frame_fields/Statistics.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/quads/Quad_output.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/make_quads.h>
#include <CGAL/Frame_fields/internal/quads/measure_quads.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/areas.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Stands for the clock of the field's stages, whose seconds the quads count as one stage.
struct No_stage_clock
{
  Stage_seconds seconds() const { return {}; }
};

// The number of quads up to which quads, their sides and their vertices certainly have numbers of the type int.
inline double largest_number_of_quads() { return (std::numeric_limits<int>::max)() / 16.; }

// Fails with `ERROR_WRONG_PARAMETER` if the wanted edge length asks for more quads than that in the area of the
// surface, or for more edges along its halfedges. Lengths are in the unit of `Cut_surface::length`.
inline Result check_number_of_quads(const Cut_surface& surface, const Surface_embedding& embedding,
                                    const Quad_request& request)
{
  const double largest_number = largest_number_of_quads(), target_edge_length = request.edge_length;
  double length = 0;
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    length += surface.length[h] * (std::max)(density_at(embedding, request.density, h),
                                             density_at(embedding, request.density, previous_of(h)));
  const double number = surface_area(surface) / target_edge_length / target_edge_length;
  if(number <= largest_number && length / target_edge_length <= largest_number)
    return {};
  return failure(ERROR_WRONG_PARAMETER, "the quads asked for are too many for 32-bit indices");
}

// The edge of a halfedge in words, for messages; its points are multiplied by `unit`.
inline std::string text_of_edge(const Surface_embedding& embedding, const int halfedge, const double unit)
{
  const auto text = [&](const int h)
  {
    const Coordinates& p = embedding.point[embedding.vertex[h]];
    return to_text({ unit * p[0], unit * p[1], unit * p[2] });
  };
  return "the edge from " + text(previous_of(halfedge)) + " to " + text(halfedge);
}

inline void note_cancelled_pairs(const std::vector<int>& cancelled_pairs, Quad_statistics& statistics)
{
  for(std::size_t p = 0; p < cancelled_pairs.size(); ++p)
  {
    statistics.patches[p].number_of_cancelled_pairs = cancelled_pairs[p];
    statistics.number_of_repaired_patches += cancelled_pairs[p] > 0;
  }
}

// Adds the quads to the caller's mesh and writes the maps of its elements. The quads must have no conflicts. `unit` is
// the length by which the caller's lengths were divided before the surface was made; the surface has a unit besides.
// `locate(l)` is the face of the caller's mesh that a location is in, and its barycentric coordinates there.
template <typename Locate, typename QuadMesh, typename NamedParameters>
void output_quads(const Cut_surface& surface, const Surface_embedding& embedding, const Quad_complex& complex,
                  const double unit, const Locate& locate, QuadMesh& quad_mesh, const NamedParameters& np)
{
  typedef typename boost::property_map<QuadMesh, CGAL::vertex_point_t>::type Point_map;
  typedef typename boost::property_traits<Point_map>::value_type Point;
  const Point_map points = get(CGAL::vertex_point, quad_mesh);
  const auto is_constrained = CGAL::parameters::get_parameter(np, internal::output_edge_is_constrained);
  const auto patch_of_face = CGAL::parameters::get_parameter(np, internal::face_to_patch);
  const auto location_of_vertex = CGAL::parameters::get_parameter(np, internal::vertex_to_face_location);

  const Quad_connectivity connectivity = connect_quads(complex);
  const std::vector<char> is_on_arc = sides_on_arcs(complex);
  const Written_quads<QuadMesh> written = write_quads(complex, connectivity, quad_mesh);
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
  {
    const Coordinates p = point_of(surface, embedding, complex.vertices[v]);
    put(points, written.vertices[v], Point(unit * p[0], unit * p[1], unit * p[2]));
    put_location(location_of_vertex, written.vertices[v], locate, complex.vertices[v].location);
  }
  for(std::size_t q = 0; q < complex.quads.size(); ++q)
    put_if_given(patch_of_face, written.faces[q], complex.patch[q]);
  for(std::size_t side = 0; side < written.sides.size(); ++side)
    put_if_given(is_constrained, edge(written.sides[side], quad_mesh), is_on_arc[side] != 0);
}

// The quality of quads, with lengths in the caller's unit; `unit` is as for `output_quads()`.
inline Quad_quality quality_of(const Cut_surface& surface, const Surface_embedding& embedding,
                               const Quad_complex& complex, const double unit)
{
  std::vector<Coordinates> points;
  for(const Quad_vertex& vertex : complex.vertices)
  {
    const Coordinates p = point_of(surface, embedding, vertex);
    points.push_back({ unit * p[0], unit * p[1], unit * p[2] });
  }
  return measure_quads(polygon_mesh(complex, points, sides_on_arcs(complex)));
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_PARAMETERS_H
