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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_UNTANGLE_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_UNTANGLE_QUADS_H

#include <CGAL/Frame_fields/internal/quads/Sliding_quads.h>
#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/quads/sliding_step.h>
#include <CGAL/Frame_fields/internal/quads/tangled_parts.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Turns the quads of a part of a quad mesh right side up.
//
// It minimizes the sum of (|a|^2 + |b|^2) / (2 chi(a x b)) over the corners with sides a and b, where a x b is seen
// along the normal of the surface, and chi(t) = (t + sqrt(t^2 + e^2)) / 2 is positive also for inverted corners; e gets
// smaller with them. On the way a quad may get worse. In the end, all moves are undone if the worst scaled Jacobian of
// the part is worse than before, if more quads are inverted, or if neither has improved.
class Untangled_part
{
public:
  // `epsilon` has room for a number per corner of all quads.
  Untangled_part(Sliding_quads& quads, const std::vector<int>& part, const std::vector<int>& vertices,
                 std::vector<double>& epsilon)
    : m_quads(quads), m_part(part), m_vertices(vertices), m_epsilon(epsilon)
  {
    for(const int v : vertices)
      m_old_slide.push_back(quads.slide_of(v));
  }

  // Returns whether it has improved.
  bool run()
  {
    // Small parts get many rounds; large ones are hopeless if a few do not mend them.
    const int number_of_vertices = static_cast<int>(m_vertices.size());
    const int number_of_rounds = (std::min)(40, (std::max)(4, 40000 / (std::max)(1, number_of_vertices)));
    const std::pair<int, double> old_score = score();
    for(int round = 0; round < number_of_rounds && score().first > 0; ++round)
    {
      set_epsilons();
      for(const int v : m_vertices)
        lower_energy(v);
    }
    const std::pair<int, double> new_score = score();
    const bool is_better =
      new_score.second >= old_score.second
      && (new_score.first < old_score.first
          || (new_score.first == old_score.first && new_score.second > old_score.second));
    if(!is_better)
      for(std::size_t i = 0; i < m_vertices.size(); ++i)
        m_quads.move(m_vertices[i], m_old_slide[i]);
    return is_better;
  }

private:
  // The number of inverted quads and the worst scaled Jacobian.
  std::pair<int, double> score() const
  {
    std::pair<int, double> result(0, 1);
    for(const int q : m_part)
    {
      result.first += m_quads.shape(q).scaled_jacobian <= 0;
      result.second = (std::min)(result.second, m_quads.shape(q).scaled_jacobian);
    }
    return result;
  }

  // Each corner has its own scale, so that those with a short side count as well.
  void set_epsilons()
  {
    const double smallest_part = 1e-3, part = 0.2;
    for(const int q : m_part)
    {
      const Quad_points p = m_quads.points(q);
      const Coordinates normal = unit_normal(q);
      for(int k = 0; k < 4; ++k)
      {
        const Coordinates a = p[(k + 1) % 4] - p[k], b = p[(k + 3) % 4] - p[k];
        m_epsilon[4 * static_cast<std::size_t>(q) + k] =
          std::hypot(smallest_part * std::sqrt(dot(a, a) * dot(b, b)),
                     part * (std::min)(0., dot(cross(a, b), normal)));
      }
    }
  }

  Coordinates unit_normal(const int quad) const
  {
    const Coordinates normal = m_quads.surface_normal(quad);
    const double norm = length(normal);
    return norm > 0 ? 1 / norm * normal : normal;
  }

  // Calls `visit(a, b, normal, epsilon, k)` for the corners that depend on a vertex at `point`. Each quad of the vertex
  // has three: k is 0 at the vertex, 1 at the next one of the quad and 3 at the one before.
  template <typename Visit>
  void for_each_moving_corner(const int vertex, const Coordinates& point, const Visit& visit) const
  {
    for(const int* c = m_quads.corners_begin(vertex); c != m_quads.corners_end(vertex); ++c)
    {
      Quad_points p = m_quads.points(*c / 4);
      p[*c % 4] = point;
      const Coordinates normal = unit_normal(*c / 4);
      for(const int k : { 0, 1, 3 })
      {
        const int corner = (*c + k) % 4;
        visit(p[(corner + 1) % 4] - p[corner], p[(corner + 3) % 4] - p[corner], normal,
              m_epsilon[*c - *c % 4 + corner], k);
      }
    }
  }

  // 2 chi, without cancellation.
  static double twice_chi(const double t, const double root, const double epsilon)
  {
    return t >= 0 ? t + root : epsilon * epsilon / (root - t);
  }

  // The energy of the corners that move with a vertex, if the vertex is at `point`.
  double energy(const int vertex, const Coordinates& point) const
  {
    double sum = 0;
    for_each_moving_corner(vertex, point, [&](const Coordinates& a, const Coordinates& b, const Coordinates& normal,
                                              const double epsilon, int)
    {
      const double t = dot(cross(a, b), normal), root = std::hypot(t, epsilon);
      sum += (dot(a, a) + dot(b, b)) / twice_chi(t, root, epsilon);
    });
    return sum;
  }

  // The step against the gradient of the energy, scaled by a positive definite part of its second derivatives: that
  // of f(s, t) = s / (2 chi(t)) without the terms that mix s and t.
  Coordinates descent_step(const int vertex) const
  {
    const Vertex_plane plane(m_quads, vertex);
    Plane_vector gradient{ 0, 0 };
    double xx = 0, xy = 0, yy = 0;
    for_each_moving_corner(vertex, m_quads.point(vertex),
                           [&](const Coordinates& a, const Coordinates& b, const Coordinates& normal,
                               const double epsilon, const int k)
    {
      const double s = dot(a, a) + dot(b, b), t = dot(cross(a, b), normal), root = std::hypot(t, epsilon);
      const double f = 1 / twice_chi(t, root, epsilon), df = -f / root, ddf = f / (root * root) * (1 + t / root);
      // The vertex is the apex, the end of b, or the end of a.
      const Coordinates ds = k == 0 ? -2 * (a + b) : 2 * (k == 1 ? b : a);
      const Coordinates dt = cross(normal, k == 0 ? b - a : k == 1 ? a : -1 * b);
      const Plane_vector u = plane.tangential(ds), w = plane.tangential(dt);
      gradient = gradient + f * u + s * df * w;
      const double diagonal = (k == 0 ? 4 : 2) * f;
      xx += diagonal + s * ddf * w.x * w.x;
      yy += diagonal + s * ddf * w.y * w.y;
      xy += s * ddf * w.x * w.y;
    });
    const double determinant = xx * yy - xy * xy;
    if(!(determinant > 0))
      return { 0, 0, 0 };
    return plane.in_space({ (xy * gradient.y - yy * gradient.x) / determinant,
                            (xy * gradient.x - xx * gradient.y) / determinant });
  }

  bool try_slide(const int vertex, const Slide& slide, double& old_energy)
  {
    const double new_energy = energy(vertex, slide.point);
    if(!(new_energy < old_energy))
      return false;
    old_energy = new_energy;
    m_quads.move(vertex, slide);
    return true;
  }

  void lower_energy(const int vertex)
  {
    if(m_quads.freedom(vertex) == Sliding_quads::ON_ARC)
      lower_energy_on_arc(vertex);
    else
      lower_energy_inside(vertex);
  }

  void lower_energy_inside(const int vertex)
  {
    const int maximum_number_of_steps = 2, maximum_number_of_halvings = 4;
    double old_energy = energy(vertex, m_quads.point(vertex));
    for(int i = 0; i < maximum_number_of_steps; ++i)
    {
      const Coordinates step = descent_step(vertex);
      bool has_moved = false;
      Slide slide;
      double part = 1;
      for(int j = 0; j <= maximum_number_of_halvings && !has_moved; ++j, part /= 2)
        has_moved = m_quads.slide_inside(vertex, part * step, slide) && try_slide(vertex, slide, old_energy);
      if(!has_moved)
        return;
    }
  }

  void lower_energy_on_arc(const int vertex)
  {
    const int maximum_number_of_trials = 5;
    double old_energy = energy(vertex, m_quads.point(vertex));
    const std::pair<double, double> range = m_quads.arc_order().range(vertex, m_quads.vertex(vertex).arc);
    double step = 0.25;
    for(int trial = 0; trial < maximum_number_of_trials; ++trial)
    {
      const double here = m_quads.arc_order().length(vertex);
      bool has_moved = false;
      for(const double length : { here + step * (range.second - here), here + step * (range.first - here) })
      {
        Slide slide;
        has_moved = has_moved || (m_quads.slide_on_arc(vertex, length, slide) && try_slide(vertex, slide, old_energy));
      }
      step *= has_moved ? 1.5 : 0.5;
    }
  }

  Sliding_quads& m_quads;
  const std::vector<int>& m_part;     // quads
  const std::vector<int>& m_vertices; // that may slide: all their quads are in the part
  std::vector<double>& m_epsilon;     // per corner
  std::vector<Slide> m_old_slide;     // per entry of m_vertices
};

// Untangles all parts with two rings around inverted quads, then those with five. Returns whether any part has
// improved.
inline bool untangle_quads(Sliding_quads& quads, const std::vector<char>& is_patch_left_out)
{
  bool has_improved = false;
  std::vector<double> epsilon(4 * static_cast<std::size_t>(quads.number_of_quads()));
  for(const int number_of_rings : { 2, 5 })
    for_each_tangled_part(quads, is_patch_left_out, number_of_rings,
                          [&](const std::vector<int>& part, const std::vector<int>& vertices)
    {
      has_improved |= Untangled_part(quads, part, vertices, epsilon).run();
    });
  return has_improved;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_UNTANGLE_QUADS_H
