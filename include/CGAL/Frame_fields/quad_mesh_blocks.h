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

#ifndef CGAL_FRAME_FIELDS_QUAD_MESH_BLOCKS_H
#define CGAL_FRAME_FIELDS_QUAD_MESH_BLOCKS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Quad_block.h>
#include <CGAL/Frame_fields/T_junctions.h>
#include <CGAL/Frame_fields/internal/named_parameters/give_to_caller.h>
#include <CGAL/Frame_fields/internal/quads/Block_partition.h>
#include <CGAL/Frame_fields/internal/quads/Face_graph_polygons.h>
#include <CGAL/Frame_fields/internal/quads/block_output.h>
#include <CGAL/Frame_fields/internal/quads/measure_quads.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

/// \file quad_mesh_blocks.h

namespace CGAL {
namespace Frame_fields {

/*!
\ingroup PkgFrame_fieldsRef

divides a quad mesh into blocks, each a rectangular grid of quads.

Lines start at irregular vertices and at corners of constrained and border edges, and go straight on through the mesh.
A vertex is irregular if it is on no such edge and has not four quads, or if it is on such edges, unless it is on two
of them with two quads on each side that is not outside.

- By default, lines cross one another and constrained edges, and blocks meet along whole sides. This is the <em>base
  complex</em>, the coarsest such layout that has all these vertices at corners of blocks. Lines may wind around the
  model many times before they end, so there can be nearly as many blocks as quads.
- With `T_junctions::ON_CONSTRAINED_EDGES`, lines end at constrained edges, so blocks meet along whole sides inside each
  patch of the features, and a corner of a block can be anywhere on a feature.
- With `T_junctions::EVERYWHERE`, a line also ends where another one has been before, as in a motorcycle graph. This
  gives the fewest blocks. Their quads still fit together, as all are those of one mesh.

Where there is no irregular vertex and no corner, as on a torus or on an annulus between two features, lines start at
one vertex, so that this is cut into a grid as well. Two sides of such a block lie on each other.

\tparam QuadMesh a model of `VertexListGraph`, `FaceListGraph` and `HalfedgeListGraph`
\tparam FaceBlockMap a class model of `WritablePropertyMap` with `boost::graph_traits<QuadMesh>::%face_descriptor` as
        key type and a value type that `int` converts to
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param qm the mesh, all of whose faces must be quads
\param face_block_map gets the number of the block of each face; blocks are numbered from 0 in the order of their first
       faces
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map containing the feature edges of `qm`, which no block crosses; border edges
                          always count as such}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<QuadMesh>::%edge_descriptor`
                   as key type and `bool` as value type}
    \cgalParamDefault{a constant property map returning `false` for any edge}
    \cgalParamExtra{`cad_quad_mesh()` writes it by its parameter `output_edge_is_constrained_map`.}
  \cgalParamNEnd
  \cgalParamNBegin{t_junctions}
    \cgalParamDescription{where a corner of a block may lie inside a side of another one}
    \cgalParamType{`T_junctions`}
    \cgalParamDefault{`T_junctions::NONE`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `qm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<QuadMesh>::%vertex_descriptor`
                   as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, qm)`}
    \cgalParamExtra{Points name faces in messages; blocks do not depend on them.}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
    \cgalParamExtra{Only the coordinates of points are read.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\cgalNamedParamsBegin{Output Named Parameters}
  \cgalParamNBegin{edge_is_on_block_border_map}
    \cgalParamDescription{gets for each edge whether it is on the border of a block, as all constrained and border edges
                          are}
    \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<QuadMesh>::%edge_descriptor` as key
                   type and `bool` as value type}
    \cgalParamDefault{this is not told}
  \cgalParamNEnd
  \cgalParamNBegin{block_output_iterator}
    \cgalParamDescription{gets a `Quad_block` for each block, in the order of their numbers}
    \cgalParamType{a model of `OutputIterator` that accepts
                   `Quad_block<boost::graph_traits<QuadMesh>::%halfedge_descriptor>`}
    \cgalParamDefault{this is not told}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_blocks}
    \cgalParamDescription{gets the number of blocks}
    \cgalParamType{`std::reference_wrapper<T>`, that is `std::ref(n)` for an object `n` of a type `T` that `std::size_t`
                   converts to}
    \cgalParamDefault{it is not told}
    \cgalParamExtra{Set on success only.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `OK`, `ERROR_MESH_TOO_LARGE` (the faces have more than 2^30 corners together), `ERROR_NON_QUADRANGULAR_MESH`,
        `ERROR_INCONSISTENT_HALFEDGES` or `ERROR_NON_FINITE_COORDINATE`

\cgalBigO{n} for \f$ n \f$ faces.

\sa `cad_quad_mesh()`
*/
template <typename QuadMesh, typename FaceBlockMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Result quad_mesh_blocks(const QuadMesh& qm, FaceBlockMap face_block_map,
                        const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::Polygon_mesh polygons;
  const Result read = internal::Face_graph_polygons<QuadMesh, CGAL_NP_CLASS>(qm, np).read(polygons);
  if(!read)
    return read;
  for(int f = 0; f < polygons.number_of_faces(); ++f)
    if(polygons.size(f) != 4)
      return internal::failure(ERROR_NON_QUADRANGULAR_MESH, internal::quad_mesh_face_text(polygons, f));
  const internal::Block_partition partition(
    polygons, choose_parameter(get_parameter(np, internal::t_junctions), T_junctions::NONE));
  if(partition.wrong_face() >= 0)
    return internal::failure(ERROR_INCONSISTENT_HALFEDGES,
                             internal::quad_mesh_face_text(polygons, partition.wrong_face()));

  const auto blocks = internal::blocks_of_mesh(qm, partition);
  internal::write_block_maps(qm, partition, face_block_map, get_parameter(np, internal::edge_is_on_block_border));
  internal::write_blocks(blocks, get_parameter(np, internal::block_output_iterator));
  internal::give_to_caller(blocks.size(), get_parameter(np, internal::number_of_blocks));
  return {};
}

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_QUAD_MESH_BLOCKS_H
