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
#include <CGAL/Frame_fields/internal/quads/improve_worst_quads.h>
#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/internal/surface/face_basis.h>

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
// It minimizes the sum of (|a|^2 + |b|^2) / chi(a x b) over the corners with sides a and b, where a x b is seen along
// the normal of the surface, and chi(t) = (t + sqrt(t^2 + e^2)) / 2 is positive also for inverted corners; e gets
// smaller with them. On the way a quad may get worse. All of it is undone unless less quads are inverted in the end,
// or as many and the worst is better.
class Untangled_part
{
public:
  Untangled_part(Sliding_quads& quads, const std::vector<int>& part, const std::vector<int>& vertices)
    : m_quads(quads), m_part(part), m_vertices(vertices)
  {
    for(const int v : vertices)
    {
      m_old_slide.push_back(quads.slide_of(v));
      m_step.push_back(0.25 * mean_length_of_sides(quads, v));
    }
  }

  // Returns whether it has improved.
  bool run()
  {
    // Small parts get many rounds; large ones are hopeless if a few do not mend them.
    const int number_of_vertices = static_cast<int>(m_vertices.size());
    const int number_of_rounds = (std::min)(40, (std::max)(4, 40000 / (std::max)(1, number_of_vertices)));
    const std::pair<int, double> old_score = score();
    double mean_area = 0;
    for(const int q : m_part)
      mean_area += area(q) / static_cast<double>(m_part.size());
    for(int round = 0; round < number_of_rounds && score().first > 0; ++round)
    {
      const double worst = (std::min)(0., least_corner_area());
      const double smallest_part = 1e-3, part = 0.2;
      m_epsilon = std::hypot(smallest_part * mean_area, part * worst);
      for(std::size_t i = 0; i < m_vertices.size(); ++i)
        lower_energy(i);
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

  double area(const int quad) const
  {
    const Quad_points p = m_quads.points(quad);
    return length(cross(p[2] - p[0], p[3] - p[1])) / 2;
  }

  double least_corner_area() const
  {
    double result = 0;
    for(const int q : m_part)
    {
      const Quad_points p = m_quads.points(q);
      const Coordinates normal = unit_normal(q);
      for(int k = 0; k < 4; ++k)
        result = (std::min)(result, dot(cross(p[(k + 1) % 4] - p[k], p[(k + 3) % 4] - p[k]), normal));
    }
    return result;
  }

  Coordinates unit_normal(const int quad) const
  {
    const Coordinates normal = m_quads.surface_normal(quad);
    const double norm = length(normal);
    return norm > 0 ? 1 / norm * normal : normal;
  }

  // Of the quads of a vertex that is at `point`.
  double energy(const int vertex, const Coordinates& point) const
  {
    double sum = 0;
    for(const int* c = m_quads.corners_begin(vertex); c != m_quads.corners_end(vertex); ++c)
    {
      Quad_points p = m_quads.points(*c / 4);
      p[*c % 4] = point;
      const Coordinates normal = unit_normal(*c / 4);
      for(int k = 0; k < 4; ++k)
      {
        const Coordinates a = p[(k + 1) % 4] - p[k], b = p[(k + 3) % 4] - p[k];
        const double t = dot(cross(a, b), normal), root = std::hypot(t, m_epsilon);
        const double twice_chi = t >= 0 ? t + root : m_epsilon * m_epsilon / (root - t); // without cancellation
        sum += (dot(a, a) + dot(b, b)) / twice_chi;
      }
    }
    return sum;
  }

  void lower_energy(const std::size_t place)
  {
    const int vertex = m_vertices[place], maximum_number_of_trials = 3;
    double old_energy = energy(vertex, m_quads.point(vertex));
    for(int trial = 0; trial < maximum_number_of_trials; ++trial)
    {
      const bool has_moved = try_slides_around(m_quads, vertex, m_step[place], [&](const Slide& slide)
      {
        const double new_energy = energy(vertex, slide.point);
        if(!(new_energy < old_energy))
          return false;
        old_energy = new_energy;
        m_quads.move(vertex, slide);
        return true;
      });
      m_step[place] *= has_moved ? 1.5 : 0.5;
    }
    m_step[place] *= 2;
  }

  Sliding_quads& m_quads;
  const std::vector<int>& m_part;     // quads
  const std::vector<int>& m_vertices; // that may slide: all their quads are in the part
  std::vector<Slide> m_old_slide;     // per entry of m_vertices
  std::vector<double> m_step;         // per entry of m_vertices
  double m_epsilon = 0;
};

// Calls `visit(part, vertices)` for the connected parts that inverted quads form with the given number of rings of
// quads around them; the vertices are those that may slide and have all their quads in the part.
template <typename Visit>
void for_each_tangled_part(const Sliding_quads& quads, const int number_of_rings, const Visit& visit)
{
  std::vector<char> is_in_part(quads.number_of_quads(), false);
  std::vector<int> ring, found;
  const auto for_each_neighbor = [&](const int quad, const auto& visit_neighbor)
  {
    for(const int v : quads.quad(quad))
      for(const int* c = quads.corners_begin(v); c != quads.corners_end(v); ++c)
        visit_neighbor(*c / 4);
  };
  for(int q = 0; q < quads.number_of_quads(); ++q)
    if(quads.shape(q).scaled_jacobian <= 0)
    {
      is_in_part[q] = true;
      ring.push_back(q);
    }
  const std::vector<int> seeds = ring;
  for(int i = 0; i < number_of_rings; ++i)
  {
    found.clear();
    for(const int q : ring)
      for_each_neighbor(q, [&](const int neighbor)
      {
        if(!is_in_part[neighbor])
          found.push_back(neighbor);
        is_in_part[neighbor] = true;
      });
    ring.swap(found);
  }

  std::vector<char> is_done(quads.number_of_quads(), false), is_taken(quads.number_of_vertices(), false);
  for(const int seed : seeds)
  {
    if(is_done[seed])
      continue;
    std::vector<int> part(1, seed), vertices;
    is_done[seed] = true;
    for(std::size_t i = 0; i < part.size(); ++i)
      for_each_neighbor(part[i], [&](const int neighbor)
      {
        if(is_in_part[neighbor] && !is_done[neighbor])
        {
          is_done[neighbor] = true;
          part.push_back(neighbor);
        }
      });
    for(const int q : part)
      for(const int v : quads.quad(q))
        if(!is_taken[v] && quads.freedom(v) != Sliding_quads::FIXED
           && std::all_of(quads.corners_begin(v), quads.corners_end(v), [&](const int c) { return is_in_part[c / 4]; }))
        {
          is_taken[v] = true;
          vertices.push_back(v);
        }
    visit(part, vertices);
  }
}

// Lets the vertices at bends of arcs slide where quads are inverted. Returns whether there are any.
inline bool release_tangled_parts(Sliding_quads& quads)
{
  const int number_of_rings = 5;
  std::vector<int> at_fault;
  for_each_tangled_part(quads, number_of_rings, [&](const std::vector<int>& part, const std::vector<int>&)
  {
    at_fault.insert(at_fault.end(), part.begin(), part.end());
  });
  bool is_any_released = false;
  for(const int q : at_fault)
    for(const int v : quads.quad(q))
      is_any_released |= quads.release(v);
  return is_any_released;
}

// Returns whether a part has improved.
inline bool untangle_quads(Sliding_quads& quads)
{
  bool has_improved = false;
  for(const int number_of_rings : { 2, 5 })
    for_each_tangled_part(quads, number_of_rings, [&](const std::vector<int>& part, const std::vector<int>& vertices)
    {
      has_improved |= Untangled_part(quads, part, vertices).run();
    });
  return has_improved;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_UNTANGLE_QUADS_H
