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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_GRID_QUAD_EXTRACTION_H
#define CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_GRID_QUAD_EXTRACTION_H

#include <CGAL/Frame_fields/internal/integer_grid/Grid_walker.h>
#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/sign_of_determinant.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The quads between the lines of integer u and v of an integer-grid map of a patch.
struct Grid_quads
{
  std::vector<Surface_location> location;   // per vertex
  std::vector<int> sector;                  // per vertex: the sector of the triangle mesh that it is at, -1 elsewhere
  std::vector<std::array<int, 4> > quads;   // their vertices counter-clockwise
  std::vector<int> opposite;                // per side 4 q + k, from vertex k to vertex k + 1: the side of the quad
                                            // behind it, -1 on the border of the patch
};

// Extracts the quads of a certified map by integers only. Each quad is found at its center, the one point of it with
// coordinates at half integers; its corners and the middles of its sides are half a unit from there.
class Grid_quad_extraction
{
public:
  Grid_quad_extraction(const Cut_surface& surface, const Patch& patch, const Seamless_map& grid_map,
                       const int fraction_bits)
    : m_surface(surface), m_patch(patch), m_charts(surface, grid_map), m_walker(m_charts)
    , m_half(std::int64_t(1) << (fraction_bits - 1))
  {}

  // Returns false if a walk fails, which would be a fault of the map or its certificate.
  bool extract(Grid_quads& quads)
  {
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      if(!add_quads_at_centers(f))
        return false;
    number_vertices(quads);
    pair_sides(quads);
    return true;
  }

private:
  // A point of the patch: at a vertex, the sector; inside an edge, one of its halfedges; else the face. With its
  // coordinates in the chart of this halfedge or face it is unique.
  struct Point_key
  {
    enum Kind { SECTOR, HALFEDGE, FACE };

    int kind, element;
    std::int64_t u, v;

    bool operator<(const Point_key& other) const
    {
      return std::tie(kind, element, u, v) < std::tie(other.kind, other.element, other.u, other.v);
    }
    bool operator==(const Point_key& other) const
    {
      return std::tie(kind, element, u, v) == std::tie(other.kind, other.element, other.u, other.v);
    }
  };

  Point_key key_of(const Point_in_face& p) const
  {
    const int first = 3 * p.face;
    for(int h = first; h < first + 3; ++h)
      if(m_charts.point(h) == p.point)
        return { Point_key::SECTOR, m_surface.sector[h], 0, 0 };
    for(int h = first; h < first + 3; ++h)
      if(m_charts.side(h, p.point) == 0)
      {
        const int opposite = m_surface.opposite[h];
        if(opposite < h) // also on the border, where it is -1
          return { Point_key::HALFEDGE, h, p.point.u, p.point.v };
        const Grid_vector there = m_charts.point_across(h, p.point);
        return { Point_key::HALFEDGE, opposite, there.u, there.v };
      }
    return { Point_key::FACE, p.face, p.point.u, p.point.v };
  }

  // A center on an edge belongs to the face of the halfedge of its key, one at a vertex to that of the first corner.
  bool owns(const int face, const Grid_vector& center) const
  {
    const Point_key key = key_of({ face, center });
    switch(key.kind)
    {
      case Point_key::SECTOR:
        return face_of(m_surface.first_corner[key.element]) == face
            && m_charts.point(m_surface.first_corner[key.element]) == center;
      case Point_key::HALFEDGE: return face_of(key.element) == face && key.u == center.u && key.v == center.v;
      default: return true;
    }
  }

  bool is_inside(const int face, const Grid_vector& p) const
  {
    const int first = 3 * face;
    return m_charts.side(first, p) >= 0 && m_charts.side(first + 1, p) >= 0 && m_charts.side(first + 2, p) >= 0;
  }

  // The first half integer (an odd multiple of half a unit) that is not below a number.
  std::int64_t first_half_integer(const std::int64_t least) const
  {
    const std::int64_t unit = 2 * m_half, shifted = least - m_half;
    const std::int64_t quotient = shifted / unit + (shifted % unit > 0 ? 1 : 0);
    return quotient * unit + m_half;
  }

  bool add_quads_at_centers(const int face)
  {
    const Grid_vector a = m_charts.point(3 * face), b = m_charts.point(3 * face + 1), c = m_charts.point(3 * face + 2);
    const std::int64_t top = (std::max)({ a.v, b.v, c.v }), unit = 2 * m_half;
    for(std::int64_t v = first_half_integer((std::min)({ a.v, b.v, c.v })); v <= top; v += unit)
    {
      const auto range = m_charts.range_in_face(face, { 0, { 0, v } });
      for(std::int64_t u = first_half_integer(range.first); u <= range.second; u += unit)
        if(is_inside(face, { u, v }) && owns(face, { u, v }) && !add_quad(face, { u, v }))
          return false;
    }
    return true;
  }

  bool add_quad(const int face, const Grid_vector& center)
  {
    for(int k = 0; k < 4; ++k)
    {
      const Grid_vector to_corner = rotate({ -m_half, -m_half }, k), to_middle = rotate({ 0, -m_half }, k);
      const Point_in_face corner = m_walker.walk(face, center, center + to_corner);
      const Point_in_face middle = m_walker.walk(face, center, center + to_middle);
      if(corner.face < 0 || middle.face < 0)
        return false;
      m_corners.push_back(corner);
      m_corner_keys.push_back(key_of(corner));
      m_middle_keys.push_back(key_of(middle));
    }
    return true;
  }

  Surface_location location_of(const Point_in_face& p) const
  {
    Surface_location location;
    location.face = p.face;
    const int first = 3 * p.face;
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      // The edge against corner k runs from corner k + 1 to corner k + 2.
      const Grid_vector edge = m_charts.edge(first + (k + 2) % 3), d = p.point - m_charts.point(first + (k + 1) % 3);
      location.barycentric[k] = (std::max)(0., to_double(wide_determinant(edge.u, edge.v, d.u, d.v)));
      sum += location.barycentric[k];
    }
    for(double& weight : location.barycentric)
      weight /= sum;
    return location;
  }

  // The places of keys in their order, equal keys together; calls `visit(i, number)` for each with the number of the
  // different keys before it.
  template <typename Visit>
  static int visit_in_order(const std::vector<Point_key>& keys, const Visit& visit)
  {
    std::vector<int> order(keys.size());
    for(std::size_t i = 0; i < order.size(); ++i)
      order[i] = static_cast<int>(i);
    std::sort(order.begin(), order.end(), [&](const int i, const int j)
              { return keys[i] < keys[j] || (keys[i] == keys[j] && i < j); });
    int number = -1;
    for(std::size_t i = 0; i < order.size(); ++i)
    {
      if(i == 0 || !(keys[order[i]] == keys[order[i - 1]]))
        ++number;
      visit(order[i], number);
    }
    return number + 1;
  }

  void number_vertices(Grid_quads& quads) const
  {
    quads.quads.resize(m_corner_keys.size() / 4);
    quads.location.clear();
    quads.sector.clear();
    visit_in_order(m_corner_keys, [&](const int corner, const int number)
    {
      quads.quads[corner / 4][corner % 4] = number;
      if(number < static_cast<int>(quads.location.size()))
        return;
      const Point_key& key = m_corner_keys[corner];
      quads.location.push_back(location_of(m_corners[corner]));
      quads.sector.push_back(key.kind == Point_key::SECTOR ? key.element : -1);
    });
  }

  // Two sides with the same middle are the two sides of an edge.
  void pair_sides(Grid_quads& quads) const
  {
    quads.opposite.assign(m_middle_keys.size(), -1);
    int last_side = -1, last_number = -1;
    visit_in_order(m_middle_keys, [&](const int side, const int number)
    {
      if(number == last_number)
      {
        quads.opposite[side] = last_side;
        quads.opposite[last_side] = side;
      }
      last_side = side;
      last_number = number;
    });
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  Seamless_charts m_charts;
  Grid_walker m_walker;
  std::int64_t m_half;
  std::vector<Point_in_face> m_corners;     // per corner 4 q + k
  std::vector<Point_key> m_corner_keys;   // per corner
  std::vector<Point_key> m_middle_keys;   // per side 4 q + k
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_GRID_QUAD_EXTRACTION_H
