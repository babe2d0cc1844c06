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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_BARRIER_ENERGY_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_BARRIER_ENERGY_H

#include <CGAL/Frame_fields/internal/parameterization/Combed_field.h>
#include <CGAL/Frame_fields/internal/parameterization/Frame_energy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The energy that untangles a map: on each face weight ((1 - t) |J|^2 + t (d^2 + 1)) / chi(d) with d = det J, on each
// constrained edge s weight (r^2 + 1) / chi(r) with r = growth / length, where chi(d) = (d + sqrt(eps^2 + d^2)) / 2 is
// a positive substitute for d; t is `theta` and s is `factor_of_sides`. As eps goes to 0, the energy becomes infinite
// for inverted faces and for edges that run backward.
// (Garanzha et al., Foldover-free maps in 50 lines of code, for faces.)
class Barrier_energy
{
public:
  explicit Barrier_energy(const Map_elements& elements) : m_elements(elements) {}

  void set_epsilon(const double epsilon) { m_epsilon = epsilon; }

  // Returns the energy of x and sets its gradient. Finds the least d or r as well, see `least()`.
  double operator()(const std::vector<double>& x, std::vector<double>& gradient)
  {
    gradient.assign(x.size(), 0);
    m_least = std::numeric_limits<double>::infinity();
    double sum = 0;
    for(const Map_elements::Face& face : m_elements.faces())
      sum += add_face(face, x, gradient);
    for(const Map_elements::Side& side : m_elements.sides())
      sum += add_side(side, x, gradient);
    return sum;
  }

  // The least d or r at the last call.
  double least() const { return m_least; }

  // Per face: 1 / chi(d) at x, the factor by which the barrier stiffens the face, within limits.
  std::vector<double> stiffness_of_faces(const std::vector<double>& x) const
  {
    const double least_stiffness = 1e-3, largest_stiffness = 1e8;
    std::vector<double> result;
    for(const Map_elements::Face& face : m_elements.faces())
    {
      const double stiffness = 1 / chi(determinant_of(differential(face, x))).value;
      result.push_back(stiffness < largest_stiffness ? (std::max)(stiffness, least_stiffness) : largest_stiffness);
    }
    return result;
  }

private:
  struct Chi
  {
    double value, slope;
  };

  Chi chi(const double d) const
  {
    const double root = std::sqrt(m_epsilon * m_epsilon + d * d);
    return { d > 0 ? (d + root) / 2 : m_epsilon * m_epsilon / (2 * (root - d)), // without cancellation
             (1 + d / root) / 2 };
  }

  typedef std::array<std::array<double, 2>, 2> Matrix;

  // Entry (r, s) is the derivative of coordinate r along branch s.
  static Matrix differential(const Map_elements::Face& face, const std::vector<double>& x)
  {
    Matrix j{ { { { 0, 0 } }, { { 0, 0 } } } };
    for(int k = 0; k < 3; ++k)
      for(int r = 0; r < 2; ++r)
      {
        j[r][0] += x[2 * face.vertex[k] + r] * face.gradient[k].x;
        j[r][1] += x[2 * face.vertex[k] + r] * face.gradient[k].y;
      }
    return j;
  }

  static double determinant_of(const Matrix& j) { return j[0][0] * j[1][1] - j[0][1] * j[1][0]; }

  double add_face(const Map_elements::Face& face, const std::vector<double>& x, std::vector<double>& gradient)
  {
    const Matrix j = differential(face, x);
    const double d = determinant_of(j);
    const double squared_norm = j[0][0] * j[0][0] + j[0][1] * j[0][1] + j[1][0] * j[1][0] + j[1][1] * j[1][1];
    const Chi c = chi(d);
    const double value = ((1 - theta) * squared_norm + theta * (d * d + 1)) / c.value;
    const double weight = m_elements.weight(face), by_norm = weight * 2 * (1 - theta) / c.value;
    const double by_d = weight * (2 * theta * d - value * c.slope) / c.value;
    const double by_j[2][2] = { { by_norm * j[0][0] + by_d * j[1][1], by_norm * j[0][1] - by_d * j[1][0] },
                                { by_norm * j[1][0] - by_d * j[0][1], by_norm * j[1][1] + by_d * j[0][0] } };
    for(int k = 0; k < 3; ++k)
      for(int r = 0; r < 2; ++r)
        gradient[2 * face.vertex[k] + r] += by_j[r][0] * face.gradient[k].x + by_j[r][1] * face.gradient[k].y;
    m_least = (std::min)(m_least, d);
    return weight * value;
  }

  double add_side(const Map_elements::Side& side, const std::vector<double>& x, std::vector<double>& gradient)
  {
    const double r = (x[side.target] - x[side.source]) / side.length;
    const Chi c = chi(r);
    const double value = (r * r + 1) / c.value;
    const double weight = factor_of_sides * m_elements.weight(side);
    const double by_growth = weight * (2 * r - value * c.slope) / (c.value * side.length);
    gradient[side.target] += by_growth;
    gradient[side.source] -= by_growth;
    m_least = (std::min)(m_least, r);
    return weight * value;
  }

  static constexpr double theta = 0.1; // how much areas count against angles
  static constexpr double factor_of_sides = 3;

  const Map_elements& m_elements;
  double m_epsilon = 1;
  double m_least = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_BARRIER_ENERGY_H
