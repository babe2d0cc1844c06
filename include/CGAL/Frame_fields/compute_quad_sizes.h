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

#ifndef CGAL_FRAME_FIELDS_COMPUTE_QUAD_SIZES_H
#define CGAL_FRAME_FIELDS_COMPUTE_QUAD_SIZES_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/maps/Target_sizes.h>
#include <CGAL/Frame_fields/internal/maps/bound_sizes.h>
#include <CGAL/Frame_fields/internal/maps/read_target_sizes.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/embed.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

/// \file compute_quad_sizes.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

computes for each vertex how long the edges of quads should be there: short where the surface or a feature curve bends,
and where feature curves are close to one another, and growing slowly from there.

The result can be given to `cad_quad_mesh()` or `quad_mesh()` as `sizing_map`, perhaps after changes.

The lengths are those at vertices, and functions of this package interpolate between them. On long triangles, as in raw
tessellations, a gap in the middle of an edge makes the lengths at both of its ends short; the result is then shorter
than necessary. `cad_quad_mesh()` has the same named parameters, and takes curvatures from the triangles that it gets
and gaps from those that it refines.

The curvature of a triangle is that of the smooth surface through its vertices with the normals there, which are means
over the triangles on the same side of feature edges. It is exact for spheres with exact normals and for raw
tessellations of cylinders.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or a `Cut_triangle_mesh`
\tparam SizeMap a class model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as
        key type and `double` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param size_map gets the lengths; isolated vertices get none
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map containing the feature edges of `tm`; border edges always count as such}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                   as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false` for any edge}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
    \cgalParamExtra{Only the coordinates of points are read; all computation is in `double`.}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the greatest length, a length of `tm`}
    \cgalParamType{`double`, positive and finite}
    \cgalParamDefault{the mean length of the sides of the faces of `tm`}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_map}
    \cgalParamDescription{the greatest length at each vertex, in place of `target_edge_length`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a type that is convertible to
                   `double`, positive and finite, as value type}
    \cgalParamDefault{`target_edge_length` everywhere}
  \cgalParamNEnd
  \cgalParamNBegin{chord_height}
    \cgalParamDescription{how far edges may be from the smooth surface and the smooth curves whose points the vertices
                          of `tm` are, a length of `tm`: no edge is longer than the chord of this height of a circle
                          with the greatest normal curvature of the surface, or with that of a feature or border
                          curve. The height is that of the arc over the chord, also called sagitta.}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{infinity: any}
    \cgalParamExtra{Creases and corners are not curvature if they are features, or turns of curves by more than 45
                    degrees. What is within the rounding of coordinates counts as flat.}
  \cgalParamNEnd
  \cgalParamNBegin{edges_across_gap}
    \cgalParamDescription{how many edges there should be at least across the space between two feature or border curves
                          of a patch, or two parts of one: across a strip such as a fillet, or between two holes}
    \cgalParamType{`int`, not negative}
    \cgalParamDefault{0: any}
    \cgalParamExtra{The space is measured on the surface, perpendicular to the curves. Nothing is asked between two
                    curves that meet at a corner of the patch.}
  \cgalParamNEnd
  \cgalParamNBegin{gradation}
    \cgalParamDescription{the greatest ratio of the lengths of consecutive edges. Lengths grow along every edge of the
                          mesh by no more than \f$ \log \f$ of this times its length.}
    \cgalParamType{`double`, greater than 1, or infinity}
    \cgalParamDefault{1.5}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_edge_length}
    \cgalParamDescription{a length that neither curvature nor gaps make edges shorter than, a length of `tm`}
    \cgalParamType{`double`, finite and not negative}
    \cgalParamDefault{0}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, `ERROR_EMPTY_MESH`, `ERROR_MESH_TOO_LARGE`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_INCONSISTENT_HALFEDGES`,
        `ERROR_NON_FINITE_COORDINATE`, `ERROR_ZERO_LENGTH_EDGE`, or `ERROR_WRONG_PARAMETER` (a number out of its range)

\cgalBigO{n \log n} for \f$ n \f$ faces, and the triangles that are within `edges_across_gap` greatest lengths of
feature and border edges, straight across, for each of these.

\sa `cad_quad_mesh()`
\sa `quad_mesh()`
*/
template <typename TriangleMesh, typename SizeMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result compute_quad_sizes(const TriangleMesh& tm, SizeMap size_map,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  internal::Options options = internal::options_from(np);
  options.measures_lengths = true;
  const internal::Quad_size size = internal::quad_size_from(np);
  internal::Size_bounds bounds = internal::size_bounds_from(np);
  if(const Result result = internal::check_quad_size(np, size); !result)
    return result;
  if(const Result result = internal::check(bounds); !result)
    return result;

  internal::Stage_mesh<TriangleMesh, CGAL_NP_CLASS> stage_mesh(tm, np);
  const bool accepts_overconstrained_faces = true;
  if(const Result result = stage_mesh.cut(options, accepts_overconstrained_faces); !result)
    return result;
  const auto& cut_mesh = stage_mesh.cut_mesh();
  const internal::Cut_surface& surface = cut_mesh.surface();
  const internal::Surface_embedding embedding = internal::embed(cut_mesh);
  internal::Target_sizes sizes;
  sizes.edge_length = internal::target_edge_length_of(size, surface);
  if constexpr(internal::is_given<CGAL_NP_CLASS, internal::sizing_t>)
    if(const Result result = internal::read_sizes(
         cut_mesh, embedding, CGAL::parameters::get_parameter(np, internal::sizing), size, sizes); !result)
      return result;

  std::vector<double> length = internal::lengths_at_vertices(embedding, sizes);
  bounds = internal::in_unit(bounds, surface.length_unit);
  internal::bound_sizes(surface, embedding, bounds, internal::chord_lengths(surface, embedding, bounds.chord_height),
                        length);
  return internal::for_each_vertex(cut_mesh, embedding, [&](const auto v, const int number) -> Result
  {
    put(size_map, v, length[number] * surface.length_unit);
    return {};
  });
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_COMPUTE_QUAD_SIZES_H
