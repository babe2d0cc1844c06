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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_REFINED_COPY_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_REFINED_COPY_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/maps/bound_sizes.h>
#include <CGAL/Frame_fields/internal/maps/carry_guidance.h>
#include <CGAL/Frame_fields/internal/maps/field_maps.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/bound_sizes_of_copy.h>
#include <CGAL/Frame_fields/internal/quads/carry_to_copy.h>
#include <CGAL/Frame_fields/internal/quads/read_quad_request.h>
#include <CGAL/Frame_fields/internal/quads/refine_for_quads.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Editable_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>
#include <CGAL/Frame_fields/internal/surface/Working_mesh.h>
#include <CGAL/Frame_fields/internal/surface/embed.h>
#include <CGAL/Frame_fields/internal/surface/split_edges_longest_first.h>
#include <CGAL/Frame_fields/internal/surface/working_copy.h>
#include <CGAL/Frame_fields/parameters.h>
#include <CGAL/Frame_fields/prepare_for_frame_field.h>

#include <CGAL/Named_function_parameters.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The mesh that is given to `cad_quad_mesh()`, and the copy of it that the quads are made of. The parts refer to one
// another. `prepare_and_cut()` comes after `refine()`, and again after `split()`.
template <typename TriangleMesh, typename NamedParameters>
class Refined_copy
{
public:
  typedef decltype(parameters::edge_is_constrained_map(constraint_map(std::declval<Working_mesh&>()))) Parameters;

  Refined_copy(const TriangleMesh& tm, const NamedParameters& np, const Options& options)
    : m_np(np), m_options(options), m_given(tm, np)
    , m_parameters(parameters::edge_is_constrained_map(constraint_map(m_mesh))), m_copy(m_mesh, m_parameters)
  {}
  Refined_copy(const Refined_copy&) = delete;
  Refined_copy& operator=(const Refined_copy&) = delete;

  // Reads the given mesh and what is wanted of its quads, and copies it with triangles of the size of the quads.
  Result refine(const Quad_size& size, const Size_bounds& bounds)
  {
    const bool accepts_overconstrained_faces = true;
    if(const Result result = m_given.cut(m_options, accepts_overconstrained_faces); !result)
      return result;
    m_given_embedding = embed(given());
    if(const Result result = read_quad_request(given(), m_given_embedding, m_np, size, m_given_request); !result)
      return result;

    m_mesh = working_copy(given_surface(), m_given_embedding);
    m_mesh.density() = m_given_request.density;
    m_mesh.origin().walk_by(m_given_walker.emplace(given_surface(), m_given_embedding));
    if(may_split())
      refine_for_quads(m_mesh, m_parameters, given_surface(), m_given_request);
    if constexpr(has_size_bounds<NamedParameters>)
      return bound_sizes_of_copy(m_mesh, m_parameters, given_surface(), m_given_embedding, m_options,
                                 in_unit(bounds, given_unit()), may_split(), m_given_request);
    return {};
  }

  // Cuts the copy and carries to it what the caller gave with the given mesh.
  Result prepare_and_cut()
  {
    Result result = prepare_for_frame_field(m_mesh, m_parameters);
    if(result)
      result = m_copy.cut(m_options);
    if(!result)
      return given_result(result);
    m_embedding = embed(m_copy.cut_mesh());
    Guidance_carrier(given(), m_given_embedding, m_copy.cut_mesh()).run();
    m_request = carry_to_copy(m_given_request, given_surface(), m_given_embedding, m_copy.cut_mesh(), m_embedding);
    return {};
  }

  // Whether triangles may be split to help the maps.
  bool may_split() const
  {
    return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(m_np, internal::refine_long_triangles),
                                              true);
  }

  // Splits faces of the cut copy in four each, and those beside them as their edges require.
  void split(const std::vector<int>& faces)
  {
    std::vector<Working_mesh::Halfedge> halfedges;
    for(const int f : faces)
    {
      const Working_mesh::Halfedge h = halfedge(m_copy.cut_mesh().face_descriptors()[f], m_mesh);
      halfedges.insert(halfedges.end(), { h, next(h, m_mesh), prev(h, m_mesh) });
    }
    split_edges_longest_first(m_mesh, Editable_mesh<Working_mesh, typename Parameters::Pack>(m_mesh, m_parameters),
                              halfedges);
  }

  // What `split()` and `prepare_and_cut()` change.
  struct State
  {
    Working_mesh mesh;
    Cut_mesh<Working_mesh> cut_mesh;
    Surface_embedding embedding;
    Quad_request request;
  };

  State state() const { return { m_mesh, m_copy.cut_mesh(), m_embedding, m_request }; }

  void restore(State&& state)
  {
    m_mesh = std::move(state.mesh);
    m_copy.cut_mesh() = std::move(state.cut_mesh);
    m_embedding = std::move(state.embedding);
    m_request = std::move(state.request);
  }

  double given_unit() const { return given_surface().length_unit; } // the given lengths over those of the copy

  // After `prepare_and_cut()`.
  const Cut_surface& surface() const { return m_copy.cut_mesh().surface(); }
  const Surface_embedding& embedding() const { return m_embedding; }
  const Quad_request& request() const { return m_request; }

  // The result of a stage on the cut copy, with its sector named in the given mesh.
  Result given_result(const Patch_result& result) const
  {
    return to_result(given(), result_in_given_mesh(given(), m_given_embedding, m_copy.cut_mesh(), result));
  }

  // The face of the given mesh and the barycentric coordinates there of a location on the copy.
  auto given_location(const Surface_location& location) const
  {
    const Surface_location result = location_in_given_mesh(m_given_embedding, m_copy.cut_mesh(), location);
    return std::make_pair(given().face_descriptors()[result.face], result.barycentric);
  }

private:
  typedef Stage_mesh<TriangleMesh, NamedParameters> Given_stage_mesh;
  typedef Stage_mesh<Working_mesh, typename Parameters::Pack> Copy_stage_mesh;

  const auto& given() const { return m_given.cut_mesh(); }
  const Cut_surface& given_surface() const { return given().surface(); }

  // The result of a step on the copy. Where a face that must be split has no point inside, its parts have an edge of
  // length zero; then this names the face.
  Result given_result(const Result& result) const
  {
    if(result.error_code == ERROR_ZERO_LENGTH_EDGE)
      for(int h = 0; h < 2 * static_cast<int>(num_edges(m_mesh)); ++h)
      {
        const Working_mesh::Halfedge halfedge(h);
        if(m_mesh.face(halfedge).value >= 0
           && m_mesh.points()[source(halfedge, m_mesh).value] == m_mesh.points()[m_mesh.target(halfedge).value])
          return failure(ERROR_ZERO_LENGTH_EDGE, "there is no room for a vertex in "
                         + given().description_of_face(m_mesh.origin().face(m_mesh.face(halfedge).value)));
      }
    return result;
  }

  const NamedParameters& m_np;
  const Options& m_options;
  Given_stage_mesh m_given;
  Surface_embedding m_given_embedding;
  Quad_request m_given_request; // in the unit of the given surface
  std::optional<Surface_walker> m_given_walker;
  Working_mesh m_mesh;
  Parameters m_parameters;
  Copy_stage_mesh m_copy;
  Surface_embedding m_embedding;
  Quad_request m_request; // in the unit of the surface
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_REFINED_COPY_H
