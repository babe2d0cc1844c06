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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_SLIDING_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_SLIDING_QUADS_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Arc_order.h>
#include <CGAL/Frame_fields/internal/quads/Arc_points.h>
#include <CGAL/Frame_fields/internal/quads/Corner_normals.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where a vertex may go.
struct Slide
{
  Surface_location location;
  double length;      // on an arc: from its start
  Coordinates point;
};

// What a slide makes of the corners of a vertex: the shapes of their quads, and the normals there.
struct Slid_corners
{
  std::vector<Quad_shape> shapes;
  std::vector<Coordinates> normals;
};

// A quad mesh whose vertices slide on the surface, with the shapes of its quads. `arc_tolerance` is in the unit of the
// embedding's points. The complex must outlive the object, and changes with it.
class Sliding_quads
{
public:
  enum Freedom { FIXED, ON_ARC, IN_PATCH };

  Sliding_quads(Quad_complex& complex, const Cut_surface& surface, const Surface_embedding& embedding,
                const Feature_network& network, const double arc_tolerance = 0)
    : m_complex(complex), m_walker(surface, embedding), m_arc_points(embedding, network)
    , m_arc_order(complex, network, m_arc_points), m_arc_tolerance(arc_tolerance)
    , m_normals(complex, surface, embedding, network, m_walker)
  {
    complex.has_free_bends.resize(network.arcs.size(), false);
    collect_corners();
    for(const Quad_vertex& v : complex.vertices)
      m_point.push_back(m_walker.point(v.location));
    for(std::size_t q = 0; q < complex.quads.size(); ++q)
      m_shape.push_back(quad_shape(points(static_cast<int>(q)), surface_normal(static_cast<int>(q))));
    m_number_of_changes.assign(complex.quads.size(), 0);
  }

  int number_of_vertices() const { return static_cast<int>(m_complex.vertices.size()); }
  int number_of_quads() const { return static_cast<int>(m_complex.quads.size()); }

  Freedom freedom(const int vertex) const
  {
    const Quad_vertex& v = m_complex.vertices[vertex];
    return v.vertex >= 0 ? FIXED : v.arc >= 0 ? ON_ARC : v.patch >= 0 ? IN_PATCH : FIXED;
  }

  // Lets a vertex that is kept at a bend of its arc slide like the others there. From then on, a slide on this arc must
  // keep its sides within the tolerance of the arc, or at least as near to it as before. Returns whether the vertex was
  // kept.
  bool release(const int vertex)
  {
    Quad_vertex& v = m_complex.vertices[vertex];
    if(v.vertex < 0 || v.arc < 0)
      return false;
    v.vertex = -1;
    m_complex.has_free_bends[v.arc] = true;
    return true;
  }

  const Quad_vertex& vertex(const int vertex) const { return m_complex.vertices[vertex]; }
  const std::array<int, 4>& quad(const int quad) const { return m_complex.quads[quad]; }
  int patch(const int quad) const { return m_complex.patch[quad]; }
  const Coordinates& point(const int vertex) const { return m_point[vertex]; }
  const Quad_shape& shape(const int quad) const { return m_shape[quad]; }
  const Surface_walker& walker() const { return m_walker; }
  const Cut_surface& surface() const { return m_walker.surface(); }
  const Arc_order& arc_order() const { return m_arc_order; }

  // The corners of a vertex, each four times its quad plus its place in it.
  const int* corners_begin(const int vertex) const { return m_corner.data() + m_first_corner[vertex]; }
  const int* corners_end(const int vertex) const { return m_corner.data() + m_first_corner[vertex + 1]; }

  Quad_points points(const int quad) const
  {
    const std::array<int, 4>& q = m_complex.quads[quad];
    return { m_point[q[0]], m_point[q[1]], m_point[q[2]], m_point[q[3]] };
  }

  // The sum of the unit normals that the surface has at the vertices of a quad, on its side of the arcs.
  Coordinates surface_normal(const int quad) const { return m_normals.sum(quad); }

  // Zero if these cancel out.
  Coordinates unit_normal(const int quad) const
  {
    const Coordinates normal = surface_normal(quad);
    const double norm = length(normal);
    return norm > 0 ? 1 / norm * normal : normal;
  }

  // The unit vector along its arc at a vertex; zero where the edge of the surface has no length.
  Coordinates direction_of_arc(const int vertex) const
  {
    const Quad_vertex& v = m_complex.vertices[vertex];
    const int h = m_arc_points.halfedge(v.arc, v.position);
    const Coordinates edge = m_walker.target(h) - m_walker.target(previous_of(h));
    const double norm = length(edge);
    return norm > 0 ? 1 / norm * edge : edge;
  }

  // A number that grows with each change of the quads at a vertex.
  std::int64_t number_of_changes(const int vertex) const
  {
    std::int64_t sum = 0;
    for(const int* c = corners_begin(vertex); c != corners_end(vertex); ++c)
      sum += m_number_of_changes[*c / 4];
    return sum;
  }

  double worst() const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const Quad_shape& shape : m_shape)
      result = (std::min)(result, shape.scaled_jacobian);
    return result;
  }

  Slide slide_of(const int vertex) const
  {
    return { m_complex.vertices[vertex].location, m_arc_order.length(vertex), m_point[vertex] };
  }

  // Walks by a displacement from where a vertex is; false if it cannot walk as far inside its patch.
  bool slide_inside(const int vertex, const Coordinates& displacement, Slide& slide) const
  {
    slide.location = m_complex.vertices[vertex].location;
    slide.length = 0;
    if(!m_walker.walk(slide.location, displacement))
      return false;
    slide.point = m_walker.point(slide.location);
    return true;
  }

  // Slides on its arc to a length; false if that is too close to a neighbour, or if a side would leave a released arc.
  bool slide_on_arc(const int vertex, const double length, Slide& slide) const
  {
    const int arc = m_complex.vertices[vertex].arc;
    const std::pair<double, double> range = m_arc_order.range(vertex, arc);
    const double margin = smallest_part_of_range * (range.second - range.first);
    if(!(length > range.first + margin && length < range.second - margin))
      return false;
    const double position = m_arc_order.position(arc, length);
    slide.location = m_arc_points.location(arc, position);
    slide.length = m_arc_points.length_at(arc, position);
    slide.point = m_walker.point(slide.location);
    return !m_complex.has_free_bends[arc] || keeps_arc(vertex, range, length, slide.point);
  }

  // The worst scaled Jacobian and the sum of the distortions of the quads at a vertex.
  Quad_shape shape_around(const int vertex) const
  {
    Quad_shape result = no_shape();
    for(const int* c = corners_begin(vertex); c != corners_end(vertex); ++c)
      add(m_shape[*c / 4], result);
    return result;
  }

  // The same after a slide. Gives up, with an infinite distortion, where a quad is not better than `bound`.
  Quad_shape shape_around(const int vertex, const Slide& slide,
                          const double bound = -std::numeric_limits<double>::infinity()) const
  {
    Quad_shape result = no_shape();
    for(const int* c = corners_begin(vertex); c != corners_end(vertex); ++c)
    {
      add(shape_after(*c, slide), result);
      if(!(result.scaled_jacobian > bound))
      {
        result.distortion = std::numeric_limits<double>::infinity();
        return result;
      }
    }
    return result;
  }

  // The same, kept for `move()`.
  Quad_shape shape_around(const int vertex, const Slide& slide, Slid_corners& slid) const
  {
    slid.shapes.clear();
    slid.normals.clear();
    Quad_shape result = no_shape();
    for(const int* c = corners_begin(vertex); c != corners_end(vertex); ++c)
    {
      slid.normals.push_back(m_normals.normal_after(slide.location, *c));
      slid.shapes.push_back(shape_after(*c, slide, slid.normals.back()));
      add(slid.shapes.back(), result);
    }
    return result;
  }

  // Whether a slide inverts a quad that is not inverted.
  bool inverts_quad(const int vertex, const Slide& slide) const
  {
    for(const int* c = corners_begin(vertex); c != corners_end(vertex); ++c)
      if(m_shape[*c / 4].scaled_jacobian > 0 && !(shape_after(*c, slide).scaled_jacobian > 0))
        return true;
    return false;
  }

  void move(const int vertex, const Slide& slide)
  {
    Slid_corners slid;
    shape_around(vertex, slide, slid);
    move(vertex, slide, slid);
  }

  void move(const int vertex, const Slide& slide, const Slid_corners& slid)
  {
    const int* const corner = corners_begin(vertex);
    for(std::size_t i = 0; i < slid.shapes.size(); ++i)
    {
      m_shape[corner[i] / 4] = slid.shapes[i];
      ++m_number_of_changes[corner[i] / 4];
      m_normals.set_normal(corner[i], slid.normals[i]);
    }
    Quad_vertex& v = m_complex.vertices[vertex];
    v.location = slide.location;
    m_point[vertex] = slide.point;
    if(freedom(vertex) == ON_ARC)
    {
      v.position = m_arc_order.position(v.arc, slide.length);
      m_arc_order.set_length(vertex, slide.length);
    }
  }

private:
  static constexpr double smallest_part_of_range = 1e-3;

  static Quad_shape no_shape() { return { std::numeric_limits<double>::infinity(), 0 }; }

  static void add(const Quad_shape& shape, Quad_shape& sum)
  {
    sum.scaled_jacobian = (std::min)(sum.scaled_jacobian, shape.scaled_jacobian);
    sum.distortion += shape.distortion;
  }

  Quad_shape shape_after(const int corner, const Slide& slide) const
  {
    return shape_after(corner, slide, m_normals.normal_after(slide.location, corner));
  }

  Quad_shape shape_after(const int corner, const Slide& slide, const Coordinates& normal_after) const
  {
    const int quad = corner / 4;
    Quad_points moved = points(quad);
    moved[corner % 4] = slide.point;
    return quad_shape(moved, surface_normal(quad) - m_normals.normal(corner) + normal_after);
  }

  // Whether the two sides on the arc at a vertex still follow it if the vertex slides to a length. `range` has the
  // lengths of its neighbours.
  bool keeps_arc(const int vertex, const std::pair<double, double>& range, const double length,
                 const Coordinates& point) const
  {
    const int arc = m_complex.vertices[vertex].arc;
    const auto point_of = [&](const int neighbor, const double end)
    {
      return neighbor >= 0 ? m_point[neighbor] : m_arc_points.point(arc, m_arc_order.position(arc, end));
    };
    const Coordinates before = point_of(m_arc_order.previous(vertex), range.first);
    const Coordinates behind = point_of(m_arc_order.next(vertex), range.second);
    const auto deviation = [&](const double middle, const Coordinates& p)
    {
      return (std::max)(m_arc_points.deviation(arc, range.first, middle, before, p),
                        m_arc_points.deviation(arc, middle, range.second, p, behind));
    };
    const double new_deviation = deviation(length, point);
    return new_deviation <= m_arc_tolerance
        || new_deviation <= deviation(m_arc_order.length(vertex), m_point[vertex]);
  }

  void collect_corners()
  {
    m_first_corner.assign(m_complex.vertices.size() + 1, 0);
    for(const std::array<int, 4>& quad : m_complex.quads)
      for(const int v : quad)
        ++m_first_corner[v + 1];
    for(std::size_t v = 0; v < m_complex.vertices.size(); ++v)
      m_first_corner[v + 1] += m_first_corner[v];
    m_corner.resize(4 * m_complex.quads.size());
    std::vector<int> next = m_first_corner;
    for(std::size_t c = 0; c < m_corner.size(); ++c)
      m_corner[next[m_complex.quads[c / 4][c % 4]]++] = static_cast<int>(c);
  }

  Quad_complex& m_complex;
  Surface_walker m_walker;
  Arc_points m_arc_points;
  Arc_order m_arc_order;
  double m_arc_tolerance;
  Corner_normals m_normals;
  std::vector<int> m_first_corner, m_corner; // per vertex: its first entry in `m_corner`
  std::vector<Coordinates> m_point;          // per vertex
  std::vector<Quad_shape> m_shape;           // per quad
  std::vector<int> m_number_of_changes;      // per quad
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_SLIDING_QUADS_H
