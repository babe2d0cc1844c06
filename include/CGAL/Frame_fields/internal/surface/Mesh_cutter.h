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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_MESH_CUTTER_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_MESH_CUTTER_H

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/named_parameters/concurrency.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Mesh_reader.h>
#include <CGAL/Frame_fields/internal/surface/collect_dual_edges.h>
#include <CGAL/Frame_fields/internal/surface/collect_sectors.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/for_each.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Cuts a mesh along its constrained edges. The mesh must outlive the cutter and the cut mesh.
template <typename TriangleMesh, typename NamedParameters>
class Mesh_cutter
{
public:
  typedef Mesh_reader<const TriangleMesh, NamedParameters> Reader;
  typedef typename Reader::face_descriptor face_descriptor;
  typedef typename Reader::halfedge_descriptor halfedge_descriptor;
  typedef typename Reader::vertex_descriptor vertex_descriptor;

  Mesh_cutter(const TriangleMesh& tm, const NamedParameters& np)
    : m_mesh(tm), m_reader(tm, np), m_face_number(get(CGAL::dynamic_face_property_t<int>(), tm))
  {}

  // Sets the cut mesh, but not what guides its field; or returns an error that names the first faulty face. Lengths are
  // measured if `measures_lengths`. Does not read coordinates of isolated vertices. Takes linear time. Must be called
  // only once.
  Result cut(const Edge_weighting weighting, const bool measures_lengths, Cut_mesh<TriangleMesh>& cut_mesh)
  {
    Result result = collect_faces();
    if(result)
      result = sort_by_patches();
    if(result)
      result = measure(measures_lengths);
    if(!result)
      return result;
    collect_sectors<Concurrency_tag>(m_surface);
    collect_dual_edges<Concurrency_tag>(m_surface, weighting);
    align_with_constrained_edges(m_surface);
    const Reader reader = m_reader;
    cut_mesh = Cut_mesh<TriangleMesh>(m_mesh, [reader](const vertex_descriptor v) { return reader.coordinates(v); },
                                      std::move(m_faces), std::move(m_numbers), std::move(m_surface));
    return {};
  }

private:
  typedef typename Given_concurrency<NamedParameters>::type Concurrency_tag;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int> >::const_type Face_number_map;

  // The matrix of the relaxation has up to 6 entries for each face, numbered by `int`.
  static constexpr std::size_t maximum_number_of_faces = INT_MAX / 6;

  Result collect_faces()
  {
    for(const face_descriptor f : faces(m_mesh))
    {
      if(m_faces.size() >= maximum_number_of_faces)
        return failure(ERROR_MESH_TOO_LARGE, "more than " + std::to_string(m_faces.size()) + " faces");
      m_numbers.push_back(static_cast<int>(m_faces.size()));
      put(m_face_number, f, m_numbers.back());
      m_faces.push_back(f);
      if(!CGAL::is_triangle(halfedge(f, m_mesh), m_mesh))
        return failure(ERROR_NON_TRIANGULAR_MESH, description_of_face(m_numbers.back()));
    }
    if(m_faces.empty())
      return failure(ERROR_EMPTY_MESH, "faces(tm) is an empty range");
    return {};
  }

  // The flat index of a halfedge before the faces are sorted.
  int number_of(const halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_mesh);
    const halfedge_descriptor first = halfedge(f, m_mesh);
    const int place = (h == first) ? 0 : (h == next(first, m_mesh)) ? 1 : 2;
    return 3 * get(m_face_number, f) + place;
  }

  // The opposites of the halfedges before the faces are sorted.
  std::vector<int> opposite_numbers() const
  {
    const int unknown = -2;
    std::vector<int> result(3 * m_faces.size(), unknown);
    for(std::size_t f = 0; f < m_faces.size(); ++f)
    {
      halfedge_descriptor h = halfedge(m_faces[f], m_mesh);
      for(std::size_t i = 3 * f; i < 3 * f + 3; ++i, h = next(h, m_mesh))
      {
        if(result[i] != unknown) // seen from the other side
          continue;
        result[i] = m_reader.is_constrained(h) ? -1 : number_of(opposite(h, m_mesh));
        if(result[i] >= 0)
          result[result[i]] = static_cast<int>(i);
      }
    }
    return result;
  }

  Result sort_by_patches()
  {
    const std::vector<int> opposite_number = opposite_numbers();
    const int wrong = inconsistent_halfedge(opposite_number);
    if(wrong >= 0)
      return failure(ERROR_INCONSISTENT_HALFEDGES, description_of_face(face_of(wrong)));
    std::vector<int> patch_of_face;
    const int number_of_patches = number_patches(opposite_number, patch_of_face);
    m_numbers = face_order_by_patches(patch_of_face, number_of_patches, m_surface.patches);
    m_surface.opposite = reorder_opposites(opposite_number, m_numbers);

    std::vector<face_descriptor> sorted_faces;
    sorted_faces.reserve(m_faces.size());
    for(const int f : m_numbers)
      sorted_faces.push_back(m_faces[f]);
    m_faces.swap(sorted_faces);
    return {};
  }

  // The largest power of two up to the largest absolute value of a coordinate; 1 if all are zero.
  double length_unit() const
  {
    double largest = 0;
    for(const face_descriptor f : m_faces)
      for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        largest = (std::max)(largest, maximum_norm(m_reader.coordinates(target(h, m_mesh))));
    return largest > 0 && std::isfinite(largest) ? std::scalbn(1., std::ilogb(largest)) : 1;
  }

  // The points of the corners of a face in the order of its halfedges.
  typedef std::array<Coordinates, 3> Triangle_points;

  Result read_points(const std::size_t face, Triangle_points& points) const
  {
    const halfedge_descriptor h = halfedge(m_faces[face], m_mesh);
    points = { m_reader.coordinates(target(h, m_mesh)), m_reader.coordinates(target(next(h, m_mesh), m_mesh)),
               m_reader.coordinates(source(h, m_mesh)) };
    for(const Coordinates& point : points)
      if(!is_finite(point))
        return failure(ERROR_NON_FINITE_COORDINATE, description_of_face(face));
    for(int k = 0; k < 3; ++k)
      if(points[k] == points[(k + 1) % 3])
        return failure(ERROR_ZERO_LENGTH_EDGE, "two vertices at " + to_text(points[k]) + " in "
                                               + description_of_face(face));
    return {};
  }

  void measure_face(const std::size_t face, const Triangle_points& points)
  {
    const std::array<double, 3> angles = corner_angles(points);
    std::copy(angles.begin(), angles.end(), m_surface.angle.begin() + 3 * face);
    if(m_surface.length.empty())
      return;
    const double unit = m_surface.length_unit;
    for(int k = 0; k < 3; ++k)
      m_surface.length[3 * face + k] = distance(points[(k + 2) % 3] / unit, points[k] / unit);
  }

  // Reads the points of the faces from `begin` up to `end`.
  Result read_block(const std::size_t begin, const std::size_t end, std::vector<Triangle_points>& block) const
  {
    for(std::size_t f = begin; f < end; ++f)
      if(const Result result = read_points(f, block[f - begin]); !result)
        return result;
    return {};
  }

  void measure_block(const std::size_t begin, const std::size_t end, const std::vector<Triangle_points>& block)
  {
    const std::size_t share_size = 256;
    std::vector<std::size_t> shares;
    for(std::size_t share = begin; share < end; share += share_size)
      shares.push_back(share);
    CGAL::for_each<Concurrency_tag>(shares, [&](const std::size_t share) -> bool
    {
      for(std::size_t f = share; f < (std::min)(share + share_size, end); ++f)
        measure_face(f, block[f - begin]);
      return true;
    });
  }

  // One thread reads the mesh, block after block, since the caller's maps may not be safe for several threads. All
  // threads measure a block.
  Result measure(const bool measures_lengths)
  {
    if(measures_lengths)
      m_surface.length_unit = length_unit();
    m_surface.angle.resize(3 * m_faces.size());
    m_surface.length.resize(measures_lengths ? 3 * m_faces.size() : 0);
    const std::size_t block_size = 4096;
    std::vector<Triangle_points> block((std::min)(block_size, m_faces.size()));
    for(std::size_t begin = 0; begin < m_faces.size(); begin += block_size)
    {
      const std::size_t end = (std::min)(begin + block_size, m_faces.size());
      if(const Result result = read_block(begin, end, block); !result)
        return result;
      measure_block(begin, end, block);
    }
    return {};
  }

  std::string description_of_face(const std::size_t face) const
  {
    return face_text(m_numbers[face], m_reader.coordinates(target(halfedge(m_faces[face], m_mesh), m_mesh)));
  }

  const TriangleMesh& m_mesh;
  Reader m_reader;
  Face_number_map m_face_number; // the place of each face in faces(tm)
  std::vector<face_descriptor> m_faces;
  std::vector<int> m_numbers;    // the places of `m_faces` in faces(tm)
  Cut_surface m_surface;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_MESH_CUTTER_H
