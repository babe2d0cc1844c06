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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_MESH_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_MESH_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/No_index_target.h>
#include <CGAL/Frame_fields/internal/named_parameters/concurrency.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/collect_dual_edges.h>
#include <CGAL/Frame_fields/internal/surface/collect_sectors.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/internal/surface/face_basis.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/for_each.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The weight of guiding directions for which none is given.
template <typename Face>
struct Unit_weight_map
{
  typedef Face key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;

  friend double get(const Unit_weight_map&, const Face&) { return 1; }
};

// A mesh cut along its constrained edges: reads the mesh for all stages, which see its `Cut_surface` only.
template <typename TriangleMesh, typename NamedParameters>
class Cut_mesh
{
public:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;

  Cut_mesh(const TriangleMesh& tm, const NamedParameters& np)
    : m_mesh(tm)
    , m_points(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
        CGAL::get_const_property_map(CGAL::vertex_point, tm)))
    , m_traits(CGAL::parameters::choose_parameter<Geom_traits>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits)))
    , m_edge_is_constrained(CGAL::parameters::choose_parameter<Constraint_map>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained)))
    , m_guiding_direction(CGAL::parameters::get_parameter(np, internal::guiding_direction))
    , m_guiding_weight(CGAL::parameters::choose_parameter<Weight_map>(
        CGAL::parameters::get_parameter(np, internal::guiding_weight)))
    , m_index_target(CGAL::parameters::get_parameter(np, internal::index_target))
    , m_face_number(get(CGAL::dynamic_face_property_t<int>(), tm))
  {}

  // Sets the surface; does not read coordinates of isolated vertices.
  Result build(const Options& options, const bool accepts_overconstrained_faces = false)
  {
    Result result = collect_faces();
    if(result)
      result = sort_by_patches();
    if(!result)
      return result;
    result = measure(options.needs_lengths());
    if(!result)
      return result;
    if(!accepts_overconstrained_faces)
      result = find_overconstrained_face();
    if(!result)
      return result;
    collect_sectors<Concurrency_tag>(m_surface);
    collect_dual_edges<Concurrency_tag>(m_surface, options.edge_weighting);
    align_with_constrained_edges(m_surface);
    result = read_guidance();
    if(result)
      result = read_index_targets();
    return result ? check_sums_of_index_targets() : result;
  }

  const TriangleMesh& mesh() const { return m_mesh; }
  const Cut_surface& surface() const { return m_surface; }
  const std::vector<face_descriptor>& face_descriptors() const { return m_faces; }

  // The mesh's halfedge of a flat index.
  halfedge_descriptor halfedge_of(const int index) const
  {
    halfedge_descriptor h = halfedge(m_faces[face_of(index)], m_mesh);
    for(int k = index % 3; k > 0; --k)
      h = next(h, m_mesh);
    return h;
  }

  // Calls `visit(h, i)` for each halfedge of a face with its flat index, and `visit(h, -1)` for each border halfedge.
  template <typename Visit>
  void for_each_halfedge(const Visit& visit) const
  {
    for(std::size_t f = 0; f < m_faces.size(); ++f)
    {
      halfedge_descriptor h = halfedge(m_faces[f], m_mesh);
      for(int k = 0; k < 3; ++k, h = next(h, m_mesh))
      {
        visit(h, static_cast<int>(3 * f) + k);
        if(m_surface.is_constrained(static_cast<int>(3 * f) + k) && is_border(opposite(h, m_mesh), m_mesh))
          visit(opposite(h, m_mesh), -1);
      }
    }
  }

  std::string description_of_face(const int face) const { return description_of_face(m_faces[face]); }

  std::string description_of_sector(const int sector) const
  {
    const int corner = m_surface.first_corner[sector];
    std::ostringstream text;
    text << "the vertex at " << position(target(halfedge_of(corner), m_mesh)) << " in "
         << description_of_face(face_of(corner));
    return text.str();
  }

  Coordinates coordinates(const vertex_descriptor v) const { return coordinates_of(get(m_points, v), m_traits); }

  // The angle of the projection of a vector to the plane of a face, from its first halfedge; NaN if the projection has
  // no length or the vector is not finite.
  template <typename Vector_3>
  double angle_in_face(const face_descriptor f, const Vector_3& vector) const
  {
    const halfedge_descriptor h = halfedge(f, m_mesh);
    const Face_basis basis = face_basis(coordinates(source(h, m_mesh)), coordinates(target(h, m_mesh)),
                                        coordinates(target(next(h, m_mesh), m_mesh)));
    const Coordinates v = coordinates_of(vector, m_traits);
    const double x = dot(v, basis[0]), y = dot(v, basis[1]);
    const bool has_direction = std::isfinite(x) && std::isfinite(y) && (x != 0 || y != 0);
    return has_direction ? std::atan2(y, x) : std::numeric_limits<double>::quiet_NaN();
  }

private:
  typedef typename CGAL::GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  typedef typename CGAL::GetGeomTraits<TriangleMesh, NamedParameters>::type Geom_traits;
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::edge_is_constrained_t, NamedParameters,
    CGAL::Static_boolean_property_map<edge_descriptor, false> >::type Constraint_map;
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    internal::guiding_direction_t, NamedParameters, CGAL::internal_np::Param_not_found>::type Direction_map;
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    internal::guiding_weight_t, NamedParameters, Unit_weight_map<face_descriptor> >::type Weight_map;
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    internal::index_target_t, NamedParameters, CGAL::internal_np::Param_not_found>::type Target_map;
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
      put(m_face_number, f, static_cast<int>(m_faces.size()));
      const halfedge_descriptor h = halfedge(f, m_mesh);
      if(!CGAL::is_triangle(h, m_mesh))
        return failure(ERROR_NON_TRIANGULAR_MESH, description_of_face(f));
      m_faces.push_back(f);
    }
    if(m_faces.empty())
      return failure(ERROR_EMPTY_MESH, "faces(tm) is an empty range");
    return {};
  }

  bool is_constrained(const halfedge_descriptor h) const
  {
    return is_border(opposite(h, m_mesh), m_mesh) || get(m_edge_is_constrained, edge(h, m_mesh));
  }

  // The flat index of a halfedge before the faces are sorted.
  int number_of(const halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_mesh);
    const halfedge_descriptor first = halfedge(f, m_mesh);
    const int place = (h == first) ? 0 : (h == next(first, m_mesh)) ? 1 : 2;
    return 3 * get(m_face_number, f) + place;
  }

  Result sort_by_patches()
  {
    const int unknown = -2;
    std::vector<int> opposite_number(3 * m_faces.size(), unknown);
    for(std::size_t f = 0; f < m_faces.size(); ++f)
    {
      halfedge_descriptor h = halfedge(m_faces[f], m_mesh);
      for(std::size_t i = 3 * f; i < 3 * f + 3; ++i, h = next(h, m_mesh))
      {
        if(opposite_number[i] != unknown) // seen from the other side
          continue;
        opposite_number[i] = is_constrained(h) ? -1 : number_of(opposite(h, m_mesh));
        if(opposite_number[i] >= 0)
          opposite_number[opposite_number[i]] = static_cast<int>(i);
      }
    }
    const int wrong = inconsistent_halfedge(opposite_number);
    if(wrong >= 0)
      return failure(ERROR_INCONSISTENT_HALFEDGES, description_of_face(m_faces[face_of(wrong)]));
    std::vector<int> patch_of_face;
    const int number_of_patches = number_patches(opposite_number, patch_of_face);
    const std::vector<int> order = face_order_by_patches(patch_of_face, number_of_patches, m_surface.patches);
    m_surface.opposite = reorder_opposites(opposite_number, order);

    std::vector<face_descriptor> sorted_faces;
    sorted_faces.reserve(m_faces.size());
    for(const int f : order)
      sorted_faces.push_back(m_faces[f]);
    m_faces.swap(sorted_faces);
    return {};
  }

  // The largest power of two up to the size of the coordinates.
  double length_unit() const
  {
    double largest = 0;
    for(const face_descriptor f : m_faces)
      for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        largest = (std::max)(largest, maximum_norm(coordinates(target(h, m_mesh))));
    return largest > 0 && std::isfinite(largest) ? std::scalbn(1., std::ilogb(largest)) : 1;
  }

  static Coordinates in_unit(const Coordinates& point, const double unit)
  {
    return { point[0] / unit, point[1] / unit, point[2] / unit };
  }

  // The points of the corners of a face in the order of its halfedges.
  typedef std::array<Coordinates, 3> Triangle_points;

  // Sets the points of the face of a number.
  Result read_points(const std::size_t number, Triangle_points& points) const
  {
    const face_descriptor f = m_faces[number];
    const halfedge_descriptor h = halfedge(f, m_mesh);
    points = { coordinates(target(h, m_mesh)), coordinates(target(next(h, m_mesh), m_mesh)),
               coordinates(source(h, m_mesh)) };
    for(const Coordinates& point : points)
      if(!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
        return failure(ERROR_NON_FINITE_COORDINATE, description_of_face(f));
    for(int k = 0; k < 3; ++k)
      if(points[k] == points[(k + 1) % 3])
        return failure(ERROR_ZERO_LENGTH_EDGE, "two vertices at " + position(points[k]) + " in "
                                               + description_of_face(f));
    return {};
  }

  void measure_face(const std::size_t number, const Triangle_points& points)
  {
    const std::array<double, 3> angles = corner_angles(points);
    std::copy(angles.begin(), angles.end(), m_surface.angle.begin() + 3 * number);
    if(m_surface.length.empty())
      return;
    for(int k = 0; k < 3; ++k)
      m_surface.length[3 * number + k] = distance(in_unit(points[(k + 2) % 3], m_surface.length_unit),
                                                  in_unit(points[k], m_surface.length_unit));
  }

  // Sets the points of the faces from number `begin` on.
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

  // One thread reads the mesh, since the caller's maps may not bear more, block after block; all measure a block.
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

  Result find_overconstrained_face() const
  {
    for(int f = 0; f < m_surface.number_of_faces(); ++f)
    {
      int number_of_constrained_edges = 0;
      for(int k = 0; k < 3; ++k)
        number_of_constrained_edges += m_surface.is_constrained(3 * f + k);
      if(number_of_constrained_edges > 1)
        return failure(ERROR_OVERCONSTRAINED_FACE,
                       description_of_face(f) + "; call split_overconstrained_faces() before");
    }
    return {};
  }

  // Reads the guiding directions. An infinite weight aligns a face that has no constrained edge.
  Result read_guidance()
  {
    if constexpr(!std::is_same<Direction_map, CGAL::internal_np::Param_not_found>::value)
    {
      m_surface.guide_angle.assign(m_faces.size(), 0);
      m_surface.guide_weight.assign(m_faces.size(), 0);
      for(std::size_t f = 0; f < m_faces.size(); ++f)
      {
        const double weight = get(m_guiding_weight, m_faces[f]);
        if(!(weight >= 0))
          return failure(ERROR_WRONG_FIELD, "the guiding weight is negative or not a number in "
                                            + description_of_face(m_faces[f]));
        if(weight == 0 || m_surface.is_aligned(static_cast<int>(f)))
          continue;
        const double angle = angle_in_face(m_faces[f], get(m_guiding_direction, m_faces[f]));
        if(!std::isfinite(angle))
          return failure(ERROR_WRONG_FIELD, "the guiding direction is not finite or perpendicular to "
                                            + description_of_face(m_faces[f]));
        if(std::isinf(weight))
          m_surface.alignment[f] = angle;
        else
        {
          m_surface.guide_angle[f] = angle;
          m_surface.guide_weight[f] = weight;
        }
      }
    }
    return {};
  }

  // Reads the index targets; the halfedges of a sector must not contradict one another.
  Result read_index_targets()
  {
    if constexpr(!std::is_same<Target_map, CGAL::internal_np::Param_not_found>::value)
    {
      m_surface.index_target.assign(m_surface.number_of_sectors(), NO_INDEX_TARGET);
      for(int h = 0; h < m_surface.number_of_halfedges(); ++h)
      {
        const int given = get(m_index_target, halfedge_of(h));
        int& target = m_surface.index_target[m_surface.sector[h]];
        if(given == NO_INDEX_TARGET || given == target)
          continue;
        if(given < -largest_index_target || given > largest_index_target)
          return failure(ERROR_WRONG_FIELD, "the index target is beyond +-" + std::to_string(largest_index_target)
                                            + "/4 at " + description_of_sector(m_surface.sector[h]));
        if(target != NO_INDEX_TARGET)
          return failure(ERROR_WRONG_FIELD, "two index targets for the sector of "
                                            + description_of_sector(m_surface.sector[h]));
        target = given;
      }
    }
    return {};
  }

  Result check_sums_of_index_targets() const
  {
    for(const Patch& patch : m_surface.patches)
      if(has_index_targets(m_surface, patch))
        if(const long long missing = missing_index(m_surface, patch); missing != 0)
          return failure(ERROR_POINCARE_HOPF, std::to_string(missing) + "/4 is missing in the patch of "
                                              + description_of_sector(patch.sectors.begin_index));
    return {};
  }

  std::string description_of_face(const face_descriptor f) const
  {
    std::ostringstream text;
    text << "face " << get(m_face_number, f) << " of faces(tm), which has a vertex at "
         << position(target(halfedge(f, m_mesh), m_mesh));
    return text.str();
  }

  std::string position(const vertex_descriptor v) const { return position(coordinates(v)); }

  static std::string position(const Coordinates& point)
  {
    std::ostringstream text;
    text.precision(17);
    text << "(" << point[0] << ", " << point[1] << ", " << point[2] << ")";
    return text.str();
  }

  const TriangleMesh& m_mesh;
  Vertex_point_map m_points;
  Geom_traits m_traits;
  Constraint_map m_edge_is_constrained;
  Direction_map m_guiding_direction;
  Weight_map m_guiding_weight;
  Target_map m_index_target;
  Face_number_map m_face_number; // the number of each face in the order of faces(tm)
  std::vector<face_descriptor> m_faces;
  Cut_surface m_surface;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CUT_MESH_H
