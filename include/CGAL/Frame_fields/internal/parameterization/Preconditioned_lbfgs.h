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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PRECONDITIONED_LBFGS_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PRECONDITIONED_LBFGS_H

#include <CGAL/Frame_fields/internal/linear/solve.h>

#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

inline double inner_product(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

// a += factor b
inline void add_multiple(std::vector<double>& a, const double factor, const std::vector<double>& b)
{
  for(std::size_t i = 0; i < a.size(); ++i)
    a[i] += factor * b[i];
}

// The directions of the quasi-Newton method L-BFGS whose first guess of the Hessian is the matrix that `Solver` holds.
template <typename Solver>
class Preconditioned_lbfgs
{
public:
  explicit Preconditioned_lbfgs(Solver& solver) : m_solver(solver) {}

  void forget() { m_pairs.clear(); }
  bool has_memory() const { return !m_pairs.empty(); }

  // Sets `direction` to the quasi-Newton direction, which goes downhill up to rounding errors. Returns whether the
  // solver succeeded.
  bool find_direction(const std::vector<double>& gradient, std::vector<double>& direction)
  {
    std::vector<double> rest = gradient, factor(m_pairs.size());
    for(std::size_t k = m_pairs.size(); k-- > 0; )
    {
      factor[k] = m_pairs[k].inverse_curvature * inner_product(m_pairs[k].step, rest);
      add_multiple(rest, -factor[k], m_pairs[k].change);
    }
    if(!checked_solve(m_solver, rest, direction))
      return false;
    for(std::size_t k = 0; k < m_pairs.size(); ++k)
    {
      const double other_factor = m_pairs[k].inverse_curvature * inner_product(m_pairs[k].change, direction);
      add_multiple(direction, factor[k] - other_factor, m_pairs[k].step);
    }
    for(double& d : direction)
      d = -d;
    return true;
  }

  // Learns that the gradient changed by `change` over `step`, unless the curvature there is not positive.
  void learn(std::vector<double>&& step, std::vector<double>&& change)
  {
    const double curvature = inner_product(step, change);
    if(!(curvature > 1e-14 * std::sqrt(inner_product(step, step) * inner_product(change, change))))
      return;
    if(m_pairs.size() == memory)
      m_pairs.pop_front();
    m_pairs.push_back({ std::move(step), std::move(change), 1 / curvature });
  }

private:
  static constexpr std::size_t memory = 8;

  struct Pair
  {
    std::vector<double> step, change;
    double inverse_curvature;
  };

  Solver& m_solver;
  std::deque<Pair> m_pairs;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PRECONDITIONED_LBFGS_H
