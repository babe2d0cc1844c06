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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CURVATURE_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CURVATURE_H

#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/coordinate_rounding.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Curvatures of the smooth surface and of the smooth curves whose points the vertices of a mesh are. What is within the
// rounding of coordinates counts as flat. All lengths are in the unit of the embedding.

inline double rounding_of_points(const Cut_surface& surface, const Surface_embedding& embedding)
{
  std::vector<Coordinates> points; // as the caller gave them: they may be decimal numbers of few digits
  points.reserve(embedding.point.size());
  for(const Coordinates& point : embedding.point)
    points.push_back(surface.length_unit * point);
  return coordinate_rounding(points) / surface.length_unit;
}

// A number without the part of it that an error of `tolerance` explains.
inline double beyond(const double number, const double tolerance)
{
  return number > tolerance ? number - tolerance : number < -tolerance ? number + tolerance : 0;
}

// The greatest normal curvature of the surface in each face, without its sign. No normal goes across a constrained
// edge, so creases do not count.
//
// The sagitta of each edge over the tangent plane at an end gives the normal curvature along it, exactly so on spheres
// and on raw tessellations of cylinders. Those of its three edges are the curvature tensor of a face.
class Face_curvatures
{
public:
  Face_curvatures(const Cut_surface& surface, const Surface_embedding& embedding)
    : m_surface(surface), m_embedding(embedding), m_rounding(rounding_of_points(surface, embedding))
  {
    collect_normals();
  }

  double curvature(const int face) const
  {
    int longest = 3 * face;
    std::array<double, 3> along;
    double largest_along = 0;
    for(int k = 0; k < 3; ++k)
    {
      const int h = 3 * face + k;
      if(dot(side(h), side(h)) > dot(side(longest), side(longest)))
        longest = h;
      along[k] = curvature_along(h);
      largest_along = (std::max)(largest_along, std::abs(along[k]));
    }
    const double height = height_over(longest);
    if(!(height > tolerance()))
      return 0;

    // In coordinates with the longest side on the x-axis, from the origin to (a, 0), and the third point at (x, y).
    const int next = next_of(longest), previous = previous_of(longest);
    const double a = std::sqrt(dot(side(longest), side(longest))), y = height;
    const double x = -dot(side(previous), side(longest)) / a;
    const double xx = along[longest % 3];
    const double form_previous = along[previous % 3] * dot(side(previous), side(previous));
    const double form_next = along[next % 3] * dot(side(next), side(next));
    const double xy = (form_previous - form_next - xx * a * (2 * x - a)) / (2 * a * y);
    const double yy = (form_previous - xx * x * x - 2 * xy * x * y) / (y * y);
    const double greatest = std::abs(xx + yy) / 2 + std::hypot((xx - yy) / 2, xy);
    // No direction is much more than 45 degrees from a side unless an angle is very obtuse; then the tensor is mostly
    // noise.
    const double very_obtuse = 5 * CGAL_PI / 6;
    const double factor = m_surface.angle[next] > very_obtuse ? 1 : 2;
    return (std::min)(greatest, factor * largest_along);
  }

private:
  double tolerance() const { return 8 * m_rounding; }

  Coordinates side(const int halfedge) const
  {
    return m_embedding.point[m_embedding.vertex[halfedge]]
         - m_embedding.point[m_embedding.vertex[previous_of(halfedge)]];
  }

  double height_over(const int halfedge) const
  {
    const double base = length(side(halfedge));
    return base > 0 ? length(cross(side(halfedge), side(next_of(halfedge)))) / base : 0;
  }

  // Means of the normals of faces with the weights of Max (1999), which are exact on spheres and on raw tessellations
  // of cylinders. Rounding turns the normals of needles, so these count less.
  void collect_normals()
  {
    const double heights_of_doubt = 128;
    m_normal.assign(m_surface.number_of_sectors(), Coordinates{ 0, 0, 0 });
    for(int f = 0; f < m_surface.number_of_faces(); ++f)
    {
      const Coordinates normal = cross(side(3 * f), side(3 * f + 1));
      const double norm = length(normal);
      double height = height_over(3 * f);
      for(int k = 1; k < 3; ++k)
        height = (std::min)(height, height_over(3 * f + k));
      if(!(norm > 0 && height > 0))
        continue;
      const double doubt = heights_of_doubt * m_rounding / height, confidence = 1 / (1 + doubt * doubt);
      for(int h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Coordinates in = side(h), out = side(next_of(h));
        const double weight = confidence / dot(in, in) / dot(out, out);
        Coordinates& sum = m_normal[m_surface.sector[h]];
        if(std::isfinite(weight * norm))
          sum = sum + weight * normal;
      }
    }
    for(Coordinates& normal : m_normal)
      if(const double norm = length(normal); norm > 0)
        normal = normal / norm;
  }

  // The normal curvature along a halfedge: the mean of those over the tangent planes at its ends. At constrained edges
  // a normal is a mean over one side only, and the curvature seen from there too small, 0 instead of the full one at
  // the worst. So the other end counts alone, with at most twice the mean.
  double curvature_along(const int halfedge) const
  {
    const Coordinates d = side(halfedge);
    const double squared_length = dot(d, d);
    if(!(squared_length > 0))
      return 0;
    const int source = m_surface.sector[previous_of(halfedge)], target = m_surface.sector[halfedge];
    const double from_source = 2 * beyond(dot(m_normal[source], d), tolerance()) / squared_length;
    const double from_target = -2 * beyond(dot(m_normal[target], d), tolerance()) / squared_length;
    const double mean = (from_source + from_target) / 2;
    if(!m_surface.is_constrained_sector(source) && !m_surface.is_constrained_sector(target))
      return mean;
    const double larger = std::abs(from_source) > std::abs(from_target) ? from_source : from_target;
    const double bound = 2 * std::abs(mean);
    return (std::max)(-bound, (std::min)(bound, larger));
  }

  const Cut_surface& m_surface;
  const Surface_embedding& m_embedding;
  double m_rounding;
  std::vector<Coordinates> m_normal; // per sector
};

// The curvature of the feature and border curves, per constrained halfedge: the larger one of the circles through its
// ends and their neighbors on the curve. 0 on other halfedges, and where a curve ends, branches, or turns by more than
// 45 degrees, as polygons do.
inline std::vector<double> curvature_of_curves(const Cut_surface& surface, const Surface_embedding& embedding)
{
  const double tolerance = 8 * rounding_of_points(surface, embedding);
  std::vector<std::array<int, 2> > neighbors(embedding.point.size(), { -1, -1 });
  std::vector<int> degree(embedding.point.size(), 0);
  const auto is_first_side = [&](const int h)
  {
    return surface.is_constrained(h) && (embedding.twin[h] < 0 || h < embedding.twin[h]);
  };
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    if(is_first_side(h))
      for(const bool is_source : { false, true })
      {
        const int v = embedding.vertex[is_source ? previous_of(h) : h];
        const int w = embedding.vertex[is_source ? h : previous_of(h)];
        if(degree[v] < 2)
          neighbors[v][degree[v]] = w;
        ++degree[v];
      }

  std::vector<double> at_vertex(embedding.point.size(), 0);
  for(std::size_t v = 0; v < at_vertex.size(); ++v)
  {
    if(degree[v] != 2)
      continue;
    const Coordinates a = embedding.point[v] - embedding.point[neighbors[v][0]];
    const Coordinates b = embedding.point[neighbors[v][1]] - embedding.point[v];
    const double chord = length(a + b);
    if(chord > 0 && angle_between(a, b) <= CGAL_PI / 4)
      at_vertex[v] = 2 * beyond(length(cross(a, b)) / chord, tolerance) / (length(a) * length(b));
  }
  std::vector<double> result(surface.number_of_halfedges(), 0);
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
    if(surface.is_constrained(h))
      result[h] = (std::max)(at_vertex[embedding.vertex[h]], at_vertex[embedding.vertex[previous_of(h)]]);
  return result;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_CURVATURE_H
