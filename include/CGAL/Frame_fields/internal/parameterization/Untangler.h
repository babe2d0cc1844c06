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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_UNTANGLER_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_UNTANGLER_H

#include <CGAL/Frame_fields/internal/parameterization/Barrier_energy.h>
#include <CGAL/Frame_fields/internal/parameterization/Preconditioned_lbfgs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Moves a map x = B z, or x = B z + c, until all its faces are positively oriented and all its constrained edges run
// forward.
template <typename Solver, typename Basis>
class Untangler
{
public:
  // `solver` holds the factorization of a matrix that approximates the Hessian of the barrier energy.
  Untangler(const Map_elements& elements, const Basis& basis, Solver& solver, std::vector<double>& z)
    : m_basis(basis), m_energy(elements), m_lbfgs(solver), m_z(z)
  {
    evaluate(m_z, m_value, m_gradient);
  }

  bool is_untangled() const { return m_least > 0; }
  int number_of_steps() const { return m_number_of_steps; }

  // The least determinant of a face, or growth of a constrained edge over its length.
  double least() const { return m_least; }

  // Takes at most `maximum_number_of_steps` steps; returns whether the map is untangled.
  bool untangle(const int maximum_number_of_steps)
  {
    const int steps_of_round = 80, end = m_number_of_steps + maximum_number_of_steps;
    while(!is_untangled() && m_number_of_steps < end && !m_is_stuck)
    {
      set_epsilon(next_epsilon());
      const int end_of_round = (std::min)(end, m_number_of_steps + steps_of_round);
      while(!is_untangled() && m_number_of_steps < end_of_round && step()) {}
    }
    return is_untangled();
  }

  // Per face: how much stiffer the barrier makes it in the next round.
  std::vector<double> stiffness_of_faces()
  {
    m_energy.set_epsilon(next_epsilon());
    m_basis.multiply(m_z, m_x);
    return m_energy.stiffness_of_faces(m_x);
  }

  // Makes an untangled map more even and leaves it untangled: without epsilon the barrier is infinitely high.
  void improve(const int number_of_steps)
  {
    set_epsilon(0);
    const int end = m_number_of_steps + number_of_steps;
    while(m_number_of_steps < end && step()) {}
  }

private:
  double next_epsilon() const
  {
    const double least_epsilon = 1e-3, part_of_least = 0.05;
    return std::hypot(least_epsilon, part_of_least * (std::min)(m_least, 0.));
  }

  void set_epsilon(const double epsilon)
  {
    m_energy.set_epsilon(epsilon);
    m_lbfgs.forget();
    evaluate(m_z, m_value, m_gradient);
  }

  void evaluate(const std::vector<double>& z, double& value, std::vector<double>& gradient)
  {
    m_basis.multiply(z, m_x);
    value = m_energy(m_x, m_gradient_of_x);
    m_least = m_energy.least();
    m_basis.multiply_transposed(m_gradient_of_x, gradient);
  }

  // The fraction of a step at which the parabola through both ends with the slope at the beginning has its minimum,
  // within 0.1 and 0.5.
  static double shortening(const double slope, const double gain)
  {
    const double minimum = -slope / (2 * (gain - slope));
    return minimum > 0.1 ? (std::min)(minimum, 0.5) : 0.1; // also if the energy is not a number
  }

  // One step downhill. Returns `false` if no step lowers the energy, or if it gained too little for another one.
  bool step()
  {
    const double smallest_relative_gain = 1e-6;
    m_is_stuck = true;
    ++m_number_of_steps;
    std::vector<double> direction;
    if(!m_lbfgs.find_direction(m_gradient, direction))
      return false;
    double slope = inner_product(m_gradient, direction);
    if(!(slope < 0) && m_lbfgs.has_memory())
    {
      m_lbfgs.forget();
      if(!m_lbfgs.find_direction(m_gradient, direction))
        return false;
      slope = inner_product(m_gradient, direction);
    }
    const double old_least = m_least;
    double length = m_lbfgs.has_memory() ? (std::min)(1., 4 * m_length) : 1;
    for(int trial = 0; trial < 40; ++trial)
    {
      std::vector<double> z = m_z, gradient;
      add_multiple(z, length, direction);
      double value;
      evaluate(z, value, gradient);
      if(!(value < m_value + 1e-4 * length * slope))
      {
        length *= shortening(length * slope, value - m_value);
        continue;
      }
      m_length = length;
      for(std::size_t i = 0; i < direction.size(); ++i)
      {
        direction[i] *= length;
        m_gradient[i] = gradient[i] - m_gradient[i];
      }
      m_lbfgs.learn(std::move(direction), std::move(m_gradient));
      m_z = std::move(z);
      m_gradient = std::move(gradient);
      const double relative_gain = (m_value - value) / m_value;
      m_value = value;
      m_is_stuck = false;
      return relative_gain >= smallest_relative_gain;
    }
    m_least = old_least;
    return false;
  }

  const Basis& m_basis;
  Barrier_energy m_energy;
  Preconditioned_lbfgs<Solver> m_lbfgs;
  std::vector<double>& m_z;
  std::vector<double> m_x, m_gradient_of_x;
  std::vector<double> m_gradient;
  double m_value = 0, m_least = 0;
  int m_number_of_steps = 0;
  double m_length = 1; // of the last step
  bool m_is_stuck = false;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_UNTANGLER_H
