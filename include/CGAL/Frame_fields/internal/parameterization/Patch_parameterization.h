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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PATCH_PARAMETERIZATION_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PATCH_PARAMETERIZATION_H

#include <CGAL/Frame_fields/internal/linear/accurate_solve.h>
#include <CGAL/Frame_fields/internal/parameterization/Combed_field.h>
#include <CGAL/Frame_fields/internal/parameterization/Combing.h>
#include <CGAL/Frame_fields/internal/parameterization/Cut_graph.h>
#include <CGAL/Frame_fields/internal/parameterization/Frame_energy.h>
#include <CGAL/Frame_fields/internal/parameterization/Map_basis.h>
#include <CGAL/Frame_fields/internal/parameterization/Map_certificate.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/Untangler.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The number of bits after the point for which the values of a map and its unknowns stay below 2^50; negative if they
// are too large or not finite.
inline int fraction_bits_for(const std::vector<double>& z, const std::vector<double>& x)
{
  double largest = (std::numeric_limits<double>::min)();
  for(const std::vector<double>* const values : { &z, &x })
    for(const double value : *values)
    {
      if(!std::isfinite(value))
        return -1;
      largest = (std::max)(largest, std::abs(value));
    }
  const int bits_of_values = 49; // less than 2^50 after the rounding
  return bits_of_values - 1 - std::ilogb(largest);
}

// Writes x = B z, computed in integers from z rounded to the grid. Returns `false` if a value is 2^50 or more.
inline bool write_map(const Patch& patch, const Cut_graph& graph, const Map_basis& basis, const std::vector<double>& z,
                      const int fraction_bits, Seamless_map& map)
{
  std::vector<std::int64_t> integer_z(z.size()), integer_x;
  for(std::size_t i = 0; i < z.size(); ++i)
    integer_z[i] = std::llround(std::ldexp(z[i], fraction_bits));
  basis.multiply(integer_z, integer_x);
  const std::int64_t limit = std::int64_t(1) << 50;
  if(std::any_of(integer_x.begin(), integer_x.end(), [&](const std::int64_t x) { return x <= -limit || x >= limit; }))
    return false;
  const int first = 3 * patch.faces.begin_index;
  for(int h = first; h < 3 * patch.faces.end_index; ++h)
  {
    map.u[h] = integer_x[2 * static_cast<std::size_t>(graph.vertex[h - first])];
    map.v[h] = integer_x[2 * graph.vertex[h - first] + 1];
  }
  return true;
}

// The map of one patch, found by least squares and untangling. If the certificate fails, the faces around the faults
// become stiffer, and another attempt begins.
class Patch_parameterization
{
public:
  // `alpha` and `rho` are the relaxed field, `target_length` is per face, in the unit of `Cut_surface::length`. The
  // chart of the face `root` is that of its field.
  Patch_parameterization(const Cut_surface& surface, const Patch& patch, const std::vector<double>& alpha,
                         const std::vector<double>& rho, const std::vector<int>& matching,
                         const std::vector<int>& index, const std::vector<double>& target_length, const int root)
    : m_surface(surface), m_patch(patch), m_index(index)
    , m_combing(comb(surface, patch, matching, root))
    , m_graph(Patch_cutter(surface, patch, index, m_combing).cut())
    , m_field(surface, patch, alpha, rho, m_combing)
    , m_basis(surface, patch, index, m_graph, m_field)
    , m_elements(surface, patch, m_field, m_graph, target_length, m_basis.side_edges())
  {}

  // If no attempt succeeds, but one leaves few faults, adds the faces around the faults of all to `faulty_faces`, in
  // ascending order.
  template <typename SolverTraits>
  Map_status compute(const SolverTraits& solver_traits, Seamless_map& map, int& fraction_bits,
                     std::vector<int>& faulty_faces)
  {
    if(m_basis.has_overflow())
      return Map_status::SOLVER_FAILED;
    if(m_basis.has_forced_zero_side())
      return Map_status::FORCED_ZERO_SIDE;
    std::copy(m_combing.quarter_turns.begin(), m_combing.quarter_turns.end(),
              map.quarter_turns.begin() + 3 * static_cast<std::ptrdiff_t>(m_patch.faces.begin_index));
    m_basis.reorder(Frame_energy<Map_basis>(m_elements, m_basis).unknowns_in_elimination_order(solver_traits));
    Map_status status = Map_status::SOLVER_FAILED;
    int steps_left = maximum_number_of_steps, first_number_of_faults = 0;
    int least_number_of_faults = (std::numeric_limits<int>::max)(); // after the first attempt
    std::vector<char> is_faulty(m_patch.faces.size(), false);
    for(int attempt = 0; attempt < maximum_number_of_attempts && steps_left > 0; ++attempt)
    {
      std::vector<double> z;
      const bool is_first = attempt == 0;
      if(!solve_and_untangle(solver_traits, is_first, z, steps_left) || !write(z, map, fraction_bits))
        return Map_status::SOLVER_FAILED;
      const Map_certificate certificate(m_surface, m_patch, m_index,
                                        [this](const int h) { return m_field.branch_along(h); }, map);
      status = certificate.status();
      if(status == Map_status::CERTIFIED)
        return status;
      if(is_first)
        first_number_of_faults = certificate.number_of_faults();
      else
        least_number_of_faults = (std::min)(least_number_of_faults, certificate.number_of_faults());
      mark_around_faults(certificate, is_faulty);
      if(!is_first && is_hopeless(least_number_of_faults, first_number_of_faults))
        break;
      stiffen_around_faults(certificate, 3);
    }
    for(int f = 0; f < m_patch.faces.size(); ++f)
      if(is_faulty[f] && least_number_of_faults <= few_faults)
        faulty_faces.push_back(m_patch.faces.begin_index + f);
    return status;
  }

private:
  // Budgets are in steps, not in seconds: the result must not depend on the machine.
  static constexpr int maximum_number_of_attempts = 10, maximum_number_of_steps = 1200;
  static constexpr int steps_of_first_attempt = 150, steps_of_attempt = 250, steps_of_factorization = 10;
  static constexpr int number_of_improving_steps = 10;
  static constexpr int few_faults = 20;

  // Where many faults are left, more than half of those after the first attempt, further attempts are of no use.
  static bool is_hopeless(const int number_of_faults, const int first_number)
  {
    return number_of_faults > few_faults && 2 * number_of_faults > first_number;
  }

  // For most patches the factorization of the quadratic energy suffices to precondition all steps. The others need new
  // factorizations on the way, with the stiffness that the barrier gives the faces.
  template <typename SolverTraits>
  bool solve_and_untangle(const SolverTraits& solver_traits, const bool keeps_factorization, std::vector<double>& z,
                          int& steps_left) const
  {
    const Frame_energy<Map_basis> energy(m_elements, m_basis);
    auto solver = solver_traits.real_solver_object();
    if(!factor_and_solve(solver, energy.matrix(), energy.right_hand_side(), z))
      return false;
    Untangler<decltype(solver), Map_basis> untangler(m_elements, m_basis, solver, z);
    if(untangler.is_untangled())
      return true;
    if(keeps_factorization)
    {
      const bool is_untangled = untangler.untangle(steps_of_first_attempt);
      steps_left -= untangler.number_of_steps();
      if(is_untangled)
        untangler.improve(number_of_improving_steps);
      return true;
    }
    std::vector<double> stiffness = untangler.stiffness_of_faces();
    const int end = (std::max)(0, steps_left - steps_of_attempt);
    bool is_untangled = false;
    while(!is_untangled && steps_left > end)
    {
      const std::vector<double> old_z = z, old_stiffness = stiffness;
      const int old_steps_left = steps_left;
      if(!untangle_with(solver_traits, z, stiffness, is_untangled, steps_left))
        break;
      const int steps = old_steps_left - steps_left;
      while(steps_left > end && z == old_z && stiffness == old_stiffness) // the others would be the same
        steps_left -= steps;
    }
    return true;
  }

  // Takes a few steps with a factorization for the stiffness of the faces, and gives them the stiffness at the end.
  // Returns whether the factorization succeeded.
  template <typename SolverTraits>
  bool untangle_with(const SolverTraits& solver_traits, std::vector<double>& z, std::vector<double>& stiffness,
                     bool& is_untangled, int& steps_left) const
  {
    Map_elements elements = m_elements;
    for(std::size_t f = 0; f < stiffness.size(); ++f)
      elements.stiffen(static_cast<int>(f), stiffness[f]);
    auto solver = solver_traits.real_solver_object();
    if(!solver.factor(Frame_energy<Map_basis>(elements, m_basis).matrix()))
      return false;
    Untangler<decltype(solver), Map_basis> untangler(m_elements, m_basis, solver, z);
    is_untangled = untangler.untangle(steps_of_factorization);
    steps_left -= (std::max)(1, untangler.number_of_steps());
    if(is_untangled)
      untangler.improve(number_of_improving_steps);
    else
      stiffness = untangler.stiffness_of_faces();
    return true;
  }

  bool write(const std::vector<double>& z, Seamless_map& map, int& fraction_bits) const
  {
    std::vector<double> x;
    m_basis.multiply(z, x);
    fraction_bits = fraction_bits_for(z, x);
    return fraction_bits >= 0 && write_map(m_patch, m_graph, m_basis, z, fraction_bits, map);
  }

  // Sets the entries of `is_marked`, one per face of the patch, of faulty faces and of those around wrong sectors.
  void mark_around_faults(const Map_certificate& certificate, std::vector<char>& is_marked) const
  {
    const auto mark = [&](const int corner) { is_marked[face_of(corner) - m_patch.faces.begin_index] = true; };
    const auto mark_around = [&](const int sector)
    {
      for_each_corner(m_surface.opposite, m_surface.first_corner[sector], mark);
    };
    for(const int s : certificate.wrong_sectors())
      for_each_corner(m_surface.opposite, m_surface.first_corner[s], [&](const int corner)
      {
        for(const int c : { corner, next_of(corner), previous_of(corner) })
          mark_around(m_surface.sector[c]);
      });
    for(const int f : certificate.inverted_faces())
      mark(3 * f);
    for(const int f : certificate.faces_of_faulty_edges())
      mark(3 * f);
  }

  void stiffen_around_faults(const Map_certificate& certificate, const double factor)
  {
    std::vector<char> is_stiffer(m_patch.faces.size(), false);
    mark_around_faults(certificate, is_stiffer);
    for(int f = 0; f < m_patch.faces.size(); ++f)
      if(is_stiffer[f])
        m_elements.stiffen(f, factor);
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<int>& m_index;
  Combing m_combing;
  Cut_graph m_graph;
  Combed_field m_field;
  Map_basis m_basis;
  Map_elements m_elements;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_PATCH_PARAMETERIZATION_H
