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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_JOINT_DESCENT_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_JOINT_DESCENT_H

#include <CGAL/Frame_fields/internal/quads/Sliding_quads.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The energy s / (2 chi(t)) of a corner with s = |a|^2 + |b|^2 and t = a x b, where chi(t) = (t + sqrt(t^2 + e^2)) / 2.
struct Corner_energy
{
  Corner_energy(const double s, const double t, const double epsilon)
  {
    const double root = std::hypot(t, epsilon);
    const double twice_chi = t >= 0 ? t + root : epsilon * epsilon / (root - t); // without cancellation
    if(!(twice_chi > 0)) // all of the quad is at one point
      return;
    by_s = 1 / twice_chi;
    value = s * by_s;
    by_t = -value / root;
    by_tt = value / (root * root) * (1 + t / root);
  }

  double value = 0, by_s = 0, by_t = 0, by_tt = 0; // with its derivatives
};

// Moves vertices of a part of a quad mesh, all at once, to where the sum of the energies of its corners is less.
//
// The directions are those of the quasi-Newton method L-BFGS. Its first guess of the Hessian are the blocks of single
// vertices, without the terms that mix s and t, so they are positive definite. A vector has three coordinates per
// vertex and is tangential there; steps are walked on the surface or slid on an arc.
class Joint_descent
{
public:
  // `epsilon` is e per corner of all quads. `local` has an entry per vertex of all quads; all must be -1, as they are
  // afterward.
  Joint_descent(Sliding_quads& quads, const std::vector<int>& part, const std::vector<int>& vertices,
                const std::vector<double>& epsilon, std::vector<int>& local)
    : m_quads(quads), m_part(part), m_vertices(vertices), m_epsilon(epsilon), m_local(local), m_normal(part.size())
    , m_gradient(vertices.size()), m_block(vertices.size()), m_longest_step(vertices.size()), m_trial(vertices.size())
    , m_trial_length(vertices.size())
  {
    for(std::size_t i = 0; i < vertices.size(); ++i)
      m_local[vertices[i]] = static_cast<int>(i);
  }

  ~Joint_descent()
  {
    for(const int v : m_vertices)
      m_local[v] = -1;
  }

  Joint_descent(const Joint_descent&) = delete;
  Joint_descent& operator=(const Joint_descent&) = delete;

  // Returns whether any vertex has moved.
  bool run(const int maximum_number_of_steps)
  {
    const double least_gain = 1e-6; // over the energy
    m_pairs.clear();
    bool has_moved = false;
    double energy = expand();
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      if(!find_trial(direction(), energy))
      {
        if(m_pairs.empty())
          break;
        m_pairs.clear();
        continue;
      }
      Pair pair{ points(), m_gradient, 0 };
      move_to_trial();
      has_moved = true;
      const double new_energy = expand();
      if(!(new_energy < (1 - least_gain) * energy))
        break;
      energy = new_energy;
      learn(std::move(pair));
    }
    return has_moved;
  }

private:
  typedef std::vector<Coordinates> Vectors; // per vertex that moves

  // What a step has taught: how it changed the gradient.
  struct Pair
  {
    Vectors step, change;
    double inverse_curvature;
  };

  static constexpr std::size_t memory = 8;

  static double product(const Vectors& a, const Vectors& b)
  {
    double sum = 0;
    for(std::size_t i = 0; i < a.size(); ++i)
      sum += dot(a[i], b[i]);
    return sum;
  }

  static void add_multiple(Vectors& a, const double factor, const Vectors& b)
  {
    for(std::size_t i = 0; i < a.size(); ++i)
      a[i] = a[i] + factor * b[i];
  }

  bool is_on_arc(const std::size_t i) const { return m_quads.freedom(m_vertices[i]) == Sliding_quads::ON_ARC; }

  Vectors points() const
  {
    Vectors result;
    for(const int v : m_vertices)
      result.push_back(m_quads.point(v));
    return result;
  }

  // The energy where the vertices are. Sets its gradient and the blocks of its second derivatives.
  double expand()
  {
    std::fill(m_gradient.begin(), m_gradient.end(), Coordinates{ 0, 0, 0 });
    std::fill(m_block.begin(), m_block.end(), Block{ 0, 0, 0, 0, 0, 0 });
    std::fill(m_longest_step.begin(), m_longest_step.end(), 0.);
    double sum = 0;
    for(std::size_t i = 0; i < m_part.size(); ++i)
    {
      const std::array<int, 4>& q = m_quads.quad(m_part[i]);
      const Quad_points p = m_quads.points(m_part[i]);
      m_normal[i] = m_quads.unit_normal(m_part[i]);
      for(int k = 0; k < 4; ++k)
      {
        const int next = (k + 1) % 4, previous = (k + 3) % 4;
        const Coordinates a = p[next] - p[k], b = p[previous] - p[k];
        const double s = dot(a, a) + dot(b, b), t = dot(cross(a, b), m_normal[i]);
        const Corner_energy energy(s, t, m_epsilon[4 * static_cast<std::size_t>(m_part[i]) + k]);
        sum += energy.value;
        const Coordinates t_by_a = cross(b, m_normal[i]), t_by_b = cross(m_normal[i], a);
        add_derivatives(q[k], energy, -2 * (a + b), -1 * (t_by_a + t_by_b), 4);
        add_derivatives(q[next], energy, 2 * a, t_by_a, 2);
        add_derivatives(q[previous], energy, 2 * b, t_by_b, 2);
        if(const int v = m_local[q[k]]; v >= 0)
          m_longest_step[v] = (std::max)(m_longest_step[v], std::sqrt(s));
      }
    }
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      m_gradient[i] = tangential(i, m_gradient[i]);
    return sum;
  }

  // Adds a corner with these gradients of s and t at a vertex, and second derivative of s (times the identity).
  void add_derivatives(const int vertex, const Corner_energy& energy, const Coordinates& s_gradient,
                       const Coordinates& t_gradient, const double second_derivative)
  {
    const int i = m_local[vertex];
    if(i < 0)
      return;
    m_gradient[i] = m_gradient[i] + energy.by_s * s_gradient + energy.by_t * t_gradient;
    const double diagonal = second_derivative * energy.by_s;
    const Coordinates scaled = energy.by_tt * t_gradient;
    m_block[i][0] += diagonal + scaled[0] * t_gradient[0];
    m_block[i][1] += scaled[0] * t_gradient[1];
    m_block[i][2] += scaled[0] * t_gradient[2];
    m_block[i][3] += diagonal + scaled[1] * t_gradient[1];
    m_block[i][4] += scaled[1] * t_gradient[2];
    m_block[i][5] += diagonal + scaled[2] * t_gradient[2];
  }

  Coordinates tangential(const std::size_t i, const Coordinates& v) const
  {
    if(is_on_arc(i))
    {
      const Coordinates direction = m_quads.direction_of_arc(m_vertices[i]);
      return dot(v, direction) * direction;
    }
    const Coordinates& normal = m_quads.walker().normal(m_quads.vertex(m_vertices[i]).location.face);
    return v - dot(v, normal) * normal;
  }

  // The tangential part of the block's inverse times a vector.
  Coordinates solve_block(const std::size_t i, const Coordinates& v) const
  {
    const Block& b = m_block[i];
    const Coordinates row0{ b[0], b[1], b[2] }, row1{ b[1], b[3], b[4] }, row2{ b[2], b[4], b[5] };
    if(is_on_arc(i))
    {
      const Coordinates d = m_quads.direction_of_arc(m_vertices[i]);
      const double curvature = dot(d, { dot(row0, d), dot(row1, d), dot(row2, d) });
      return curvature > 0 ? dot(v, d) / curvature * d : Coordinates{ 0, 0, 0 };
    }
    const Coordinates column0 = cross(row1, row2), column1 = cross(row2, row0), column2 = cross(row0, row1);
    const double determinant = dot(row0, column0);
    if(!(determinant > 0))
      return { 0, 0, 0 };
    return tangential(i, 1 / determinant * (v[0] * column0 + v[1] * column1 + v[2] * column2));
  }

  // The direction of L-BFGS. No vertex goes farther than its sides are long.
  Vectors direction() const
  {
    Vectors result = m_gradient;
    std::vector<double> factor(m_pairs.size());
    for(std::size_t k = m_pairs.size(); k-- > 0; )
    {
      factor[k] = m_pairs[k].inverse_curvature * product(m_pairs[k].step, result);
      add_multiple(result, -factor[k], m_pairs[k].change);
    }
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = solve_block(i, tangential(i, result[i]));
    for(std::size_t k = 0; k < m_pairs.size(); ++k)
      add_multiple(result, factor[k] - m_pairs[k].inverse_curvature * product(m_pairs[k].change, result),
                   m_pairs[k].step);
    for(std::size_t i = 0; i < result.size(); ++i)
    {
      result[i] = -1 * tangential(i, result[i]);
      const double norm = length(result[i]);
      if(!(norm < std::numeric_limits<double>::infinity()))
        result[i] = { 0, 0, 0 };
      else if(norm > m_longest_step[i])
        result[i] = m_longest_step[i] / norm * result[i];
    }
    return result;
  }

  // Sets the trial to the first of shorter and shorter steps that lowers the energy; false if none does.
  bool find_trial(const Vectors& step, const double energy)
  {
    const int maximum_number_of_trials = 8;
    const double ratio = 0.4;
    double part = 1;
    for(int trial = 0; trial < maximum_number_of_trials; ++trial, part *= ratio)
    {
      for(std::size_t i = 0; i < m_vertices.size(); ++i)
        is_on_arc(i) ? try_on_arc(i, part * step[i]) : try_inside(i, part * step[i]);
      if(energy_of_trial() < energy)
        return true;
    }
    return false;
  }

  // Neighbours on an arc move at the same time, so neither may go halfway to the other.
  void try_on_arc(const std::size_t i, const Coordinates& step)
  {
    const double largest_part = 0.45;
    const int v = m_vertices[i];
    const double here = m_quads.arc_order().length(v);
    const std::pair<double, double> range = m_quads.arc_order().range(v, m_quads.vertex(v).arc);
    const double wanted = dot(step, m_quads.direction_of_arc(v));
    m_trial_length[i] = here + (std::min)(largest_part * (range.second - here),
                                          (std::max)(largest_part * (range.first - here), wanted));
    if(!m_quads.slide_on_arc(v, m_trial_length[i], m_trial[i]))
      m_trial[i] = m_quads.slide_of(v);
  }

  void try_inside(const std::size_t i, const Coordinates& step)
  {
    for(const double part : { 1., 0.25, 0.0625 })
      if(m_quads.slide_inside(m_vertices[i], part * step, m_trial[i]))
        return;
    m_trial[i] = m_quads.slide_of(m_vertices[i]);
  }

  double energy_of_trial() const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_part.size(); ++i)
    {
      const std::array<int, 4>& q = m_quads.quad(m_part[i]);
      Quad_points p;
      for(int k = 0; k < 4; ++k)
        p[k] = m_local[q[k]] >= 0 ? m_trial[m_local[q[k]]].point : m_quads.point(q[k]);
      for(int k = 0; k < 4; ++k)
      {
        const Coordinates a = p[(k + 1) % 4] - p[k], b = p[(k + 3) % 4] - p[k];
        sum += Corner_energy(dot(a, a) + dot(b, b), dot(cross(a, b), m_normal[i]),
                             m_epsilon[4 * static_cast<std::size_t>(m_part[i]) + k]).value;
      }
    }
    return sum;
  }

  // On a released arc, the sides must keep to it with the neighbours where they are by then.
  void move_to_trial()
  {
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      if(!is_on_arc(i) || m_quads.slide_on_arc(m_vertices[i], m_trial_length[i], m_trial[i]))
        m_quads.move(m_vertices[i], m_trial[i]);
  }

  // `pair` has the points and the gradient before the step. Pairs without positive curvature teach nothing.
  void learn(Pair&& pair)
  {
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
    {
      pair.step[i] = m_quads.point(m_vertices[i]) - pair.step[i];
      pair.change[i] = m_gradient[i] - pair.change[i];
    }
    const double curvature = product(pair.step, pair.change);
    if(!(curvature > 1e-10 * std::sqrt(product(pair.step, pair.step) * product(pair.change, pair.change))))
      return;
    pair.inverse_curvature = 1 / curvature;
    if(m_pairs.size() == memory)
      m_pairs.pop_front();
    m_pairs.push_back(std::move(pair));
  }

  typedef std::array<double, 6> Block; // xx, xy, xz, yy, yz, zz

  Sliding_quads& m_quads;
  const std::vector<int>& m_part;     // quads
  const std::vector<int>& m_vertices; // that move
  const std::vector<double>& m_epsilon;
  std::vector<int>& m_local;          // per vertex of all quads: its place in m_vertices, -1 if it does not move
  Vectors m_normal;                   // per quad of the part
  Vectors m_gradient;
  std::vector<Block> m_block;
  std::vector<double> m_longest_step;
  std::vector<Slide> m_trial;
  std::vector<double> m_trial_length; // on arcs; may lie beyond the ends of a loop
  std::deque<Pair> m_pairs;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_JOINT_DESCENT_H
