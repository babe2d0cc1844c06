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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCK_OUTPUT_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCK_OUTPUT_H

#include <CGAL/Frame_fields/Quad_block.h>
#include <CGAL/Frame_fields/internal/quads/Block_partition.h>
#include <CGAL/Frame_fields/internal/quads/Quad_output.h>
#include <CGAL/Frame_fields/internal/quads/measure_quads.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <string>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

template <typename QuadMesh>
using Block_of_mesh = Quad_block<typename boost::graph_traits<QuadMesh>::halfedge_descriptor>;

// The blocks for the caller. Corners are in the order of `Face_graph_polygons`.
template <typename QuadMesh>
std::vector<Block_of_mesh<QuadMesh> > blocks_of_mesh(const QuadMesh& mesh, const Block_partition& partition)
{
  std::vector<typename boost::graph_traits<QuadMesh>::halfedge_descriptor> halfedges;
  for(const auto f : faces(mesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      halfedges.push_back(h);
  std::vector<Block_of_mesh<QuadMesh> > result;
  result.reserve(partition.blocks().size());
  for(const Block_partition::Block& block : partition.blocks())
    result.push_back({ halfedges[block.corner], block.columns, block.rows });
  return result;
}

// How messages name a face.
inline std::string quad_mesh_face_text(const Polygon_mesh& mesh, const int f)
{
  Coordinates vertex = mesh.point[mesh.vertex[mesh.first_corner[f]]];
  for(double& coordinate : vertex)
    coordinate *= mesh.length_unit;
  return "face " + std::to_string(f) + " of faces(qm), which has a vertex at " + to_text(vertex);
}

template <typename Block, typename OutputIterator>
void write_blocks(const std::vector<Block>& blocks, OutputIterator out)
{
  for(const Block& block : blocks)
    *out++ = block;
}
template <typename Block>
void write_blocks(const std::vector<Block>&, const CGAL::internal_np::Param_not_found) {}

// Writes the block of each face, and to each edge whether it is on the border of one.
template <typename QuadMesh, typename FaceMap, typename EdgeMap>
void write_block_maps(const QuadMesh& mesh, const Block_partition& partition, const FaceMap block_map,
                      const EdgeMap is_border_map)
{
  for(const auto h : halfedges(mesh)) // also those without a face
    put_if_given(is_border_map, edge(h, mesh), true);
  int f = 0, c = 0;
  for(const auto face : faces(mesh))
  {
    put(block_map, face, partition.block_of_faces()[f++]);
    for(const auto h : CGAL::halfedges_around_face(halfedge(face, mesh), mesh))
      put_if_given(is_border_map, edge(h, mesh), partition.is_line(c++));
  }
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_BLOCK_OUTPUT_H
