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

#ifndef CGAL_FRAME_FIELDS_CAD_QUAD_MESH_H
#define CGAL_FRAME_FIELDS_CAD_QUAD_MESH_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/quads/Quad_output.h>
#include <CGAL/Frame_fields/internal/quads/Quad_stage_clock.h>
#include <CGAL/Frame_fields/internal/quads/make_quads.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Working_mesh.h>
#include <CGAL/Frame_fields/internal/surface/embed.h>
#include <CGAL/Frame_fields/internal/surface/working_copy.h>
#include <CGAL/Frame_fields/parameters.h>
#include <CGAL/Frame_fields/prepare_for_frame_field.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

/// \file cad_quad_mesh.h

namespace CGAL {
namespace Frame_fields {

namespace internal {

// The seconds of the field are one stage of the quads.
struct No_stage_clock
{
  Stage_seconds seconds() const { return {}; }
};

// The size of the quads among the named parameters: one of both, or neither.
struct Quad_size
{
  double target_edge_length; // 0 if it is not given
  double number_of_quads;    // 0 if it is not given
};

template <typename NamedParameters>
Quad_size quad_size_from(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return { static_cast<double>(choose_parameter(get_parameter(np, internal::target_edge_length), 0.)),
           static_cast<double>(choose_parameter(get_parameter(np, internal::number_of_quads), 0.)) };
}

template <typename NamedParameters>
Result check_quad_size(const NamedParameters& np, const Quad_size& size)
{
  constexpr bool has_length =
    !CGAL::parameters::is_default_parameter<NamedParameters, internal::target_edge_length_t>::value;
  constexpr bool has_number =
    !CGAL::parameters::is_default_parameter<NamedParameters, internal::number_of_quads_t>::value;
  if(has_length && !(std::isfinite(size.target_edge_length) && size.target_edge_length > 0))
    return failure(ERROR_WRONG_PARAMETER, "target_edge_length is " + std::to_string(size.target_edge_length)
                                          + " and must be a finite positive number");
  if(has_number && !(size.number_of_quads >= 1))
    return failure(ERROR_WRONG_PARAMETER, "number_of_quads is " + std::to_string(size.number_of_quads)
                                          + " and must be at least 1");
  (void)np;
  return {};
}

// In the unit of `Cut_surface::length`; by default the mean length of the edges.
inline double target_edge_length_of(const Quad_size& size, const Cut_surface& surface)
{
  if(size.target_edge_length > 0)
    return size.target_edge_length / surface.length_unit;
  if(size.number_of_quads > 0)
    return std::sqrt(surface_area(surface) / size.number_of_quads);
  double sum = 0;
  for(const double length : surface.length)
    sum += length;
  return sum / static_cast<double>(surface.length.size());
}

// The relaxed field of the quads.
inline Quad_field quad_field_of(const Frame_field& field)
{
  Quad_field result{ field.alpha, std::vector<double>(field.alpha.size()), field.matching, field.index };
  for(std::size_t f = 0; f < field.alpha.size(); ++f)
  {
    result.alpha[f] += field.gamma[f][0];
    result.rho[f] = field.gamma[f][1] - field.gamma[f][0];
  }
  return result;
}

// Adds the quads to the caller's mesh and writes the maps of its elements. `unit` is that of the points of `embedding`
// and the surface together.
template <typename QuadMesh, typename NamedParameters>
void output_quads(const Cut_surface& surface, const Surface_embedding& embedding, const Quad_complex& complex,
                  const double unit, QuadMesh& quad_mesh, const NamedParameters& np)
{
  typedef typename boost::property_map<QuadMesh, CGAL::vertex_point_t>::type Point_map;
  typedef typename boost::property_traits<Point_map>::value_type Point;
  const Point_map points = get(CGAL::vertex_point, quad_mesh);
  const auto is_constrained = CGAL::parameters::get_parameter(np, internal::output_edge_is_constrained);
  const auto patch_of_face = CGAL::parameters::get_parameter(np, internal::face_to_patch);

  const Quad_connectivity connectivity = connect_quads(complex);
  const std::vector<char> is_on_arc = sides_on_arcs(complex);
  const Written_quads<QuadMesh> written = write_quads(complex, connectivity, quad_mesh);
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
  {
    const Coordinates p = point_of(surface, embedding, complex.vertices[v]);
    put(points, written.vertices[v], Point(unit * p[0], unit * p[1], unit * p[2]));
  }
  for(std::size_t q = 0; q < complex.quads.size(); ++q)
    put_if_given(patch_of_face, written.faces[q], complex.patch[q]);
  for(std::size_t side = 0; side < written.sides.size(); ++side)
    put_if_given(is_constrained, edge(written.sides[side], quad_mesh), is_on_arc[side] != 0);
}

} // namespace internal

/*!
\ingroup PkgFrame_fieldsRef

makes a quadrangle mesh of a triangle mesh that follows all feature and border edges.

\todo
*/
template <typename TriangleMesh, typename QuadMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result cad_quad_mesh(const TriangleMesh& tm, QuadMesh& quad_mesh,
                     const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  typedef typename internal::Concurrency_from<CGAL_NP_CLASS>::type Concurrency_tag;

  internal::Quad_stage_clock<CGAL_NP_CLASS> clock(np);
  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  const internal::Quad_size size = internal::quad_size_from(np);
  const auto solver_traits = internal::Solver_traits_from<CGAL_NP_CLASS>::get(np);
  if(const Result result = internal::check_quad_size(np, size); !result)
    return result;
  if(const Result result = internal::check(options); !result)
    return result;

  clock.start(Quad_stage::PREPARATION);
  internal::Cut_mesh<TriangleMesh, CGAL_NP_CLASS> given_mesh(tm, np);
  const bool accepts_overconstrained_faces = true;
  if(const Result result = given_mesh.build(options, accepts_overconstrained_faces); !result)
    return result;
  const double given_unit = given_mesh.surface().length_unit;
  internal::Working_mesh mesh =
    internal::working_copy(given_mesh.surface(), internal::embed(given_mesh));
  const auto prepared = parameters::edge_is_constrained_map(internal::constraint_map(mesh));
  if(const Result result = prepare_for_frame_field(mesh, prepared); !result)
    return result;
  typedef typename decltype(parameters::edge_is_constrained_map(internal::constraint_map(mesh)))::Pack Prepared_pack;
  internal::Cut_mesh<internal::Working_mesh, Prepared_pack> cut_mesh(mesh, prepared);
  if(const Result result = cut_mesh.build(options); !result)
    return result;
  const internal::Cut_surface& surface = cut_mesh.surface();
  const internal::Surface_embedding embedding = internal::embed(cut_mesh);

  clock.start(Quad_stage::FIELD);
  internal::Frame_field field;
  const internal::Patch_result field_result =
    internal::compute_frame_field<Concurrency_tag>(surface, options, solver_traits, clock, field);
  if(field_result.error_code != OK)
    return internal::to_result(cut_mesh, field_result);

  Quad_statistics statistics;
  internal::write_statistics(surface, options, field, internal::No_stage_clock(), statistics.field);
  const double target_edge_length =
    internal::target_edge_length_of(size, given_mesh.surface()) * (1 / surface.length_unit);
  const internal::Quad_complex complex =
    internal::make_quads<Concurrency_tag>(surface, embedding, internal::quad_field_of(field), {}, target_edge_length,
                                          solver_traits, clock, statistics);
  clock.start(Quad_stage::ASSEMBLY);
  internal::output_quads(surface, embedding, complex, given_unit, quad_mesh, np);
  clock.stop();
  statistics.target_edge_length = target_edge_length * surface.length_unit * given_unit;
  statistics.seconds = clock.seconds();
  internal::put_statistics(CGAL::parameters::get_parameter(np, internal::statistics), statistics);
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_CAD_QUAD_MESH_H
