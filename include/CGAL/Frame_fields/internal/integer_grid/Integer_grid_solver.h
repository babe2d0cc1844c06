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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_SOLVER_H
#define CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_SOLVER_H

#include <CGAL/Frame_fields/internal/integer_grid/Integer_grid_basis.h>
#include <CGAL/Frame_fields/internal/integer_grid/Integer_grid_charts.h>
#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/parameterization/Frame_energy.h>
#include <CGAL/Frame_fields/internal/parameterization/Map_certificate.h>
#include <CGAL/Frame_fields/internal/parameterization/Patch_parameterization.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/Untangler.h>
#include <CGAL/Frame_fields/internal/parameterization/Zero_side_search.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A halfedge in the plane of its face.
inline Plane_vector edge_in_face(const Cut_surface& surface, const int halfedge)
{
  const double angle = halfedge_angle(surface, halfedge), length = surface.length[halfedge];
  return { length * std::cos(angle), length * std::sin(angle) };
}

// Makes the integer-grid map of a patch: a seamless map whose transition functions translate by integers, with its
// singular vertices and constrained edges at integers. Its lines of integer u and v are the edges of the quads.
class Integer_grid_solver
{
public:
  // `map` is the certified seamless map of the T-mesh. `is_fixed` is per sector of the patch.
  Integer_grid_solver(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index,
                      const Seamless_map& map, const Integer_grid_charts& charts, const std::vector<char>& is_fixed,
                      const double edge_length)
    : m_surface(surface), m_patch(patch), m_index(index), m_map(map), m_charts(surface, map)
    , m_basis(surface, patch, m_charts, charts, is_fixed)
    , m_elements(surface, patch, [&](const int halfedge) { return edge_in_face(surface, halfedge); }, corners_of(patch),
                 [edge_length](int) { return edge_length; }, side_edges())
  {}

  // Writes u, v and the quarter turns of the patch into `grid_map`, with 2^fraction_bits steps of its grid per integer.
  // Returns the status of the certificate.
  template <typename SolverTraits>
  Map_status compute(const SolverTraits& solver_traits, Seamless_map& grid_map, int& fraction_bits)
  {
    if(!m_basis.is_consistent())
      return Map_status::SOLVER_FAILED;
    m_basis.reorder(Frame_energy<Integer_grid_basis>(m_elements, m_basis).unknowns_in_elimination_order(solver_traits));
    std::vector<double> z = m_basis.first_guess();
    if(!z.empty() && !untangle(solver_traits, z))
      return Map_status::SOLVER_FAILED;
    if(!write(z, grid_map, fraction_bits))
      return Map_status::SOLVER_FAILED;
    return Map_certificate(m_surface, m_patch, m_index, [this](const int h) { return m_charts.direction_of(h); },
                           grid_map).status();
  }

private:
  static constexpr int number_of_factorizations = 8, steps_of_factorization = 25, number_of_improving_steps = 25;

  static std::vector<int> corners_of(const Patch& patch)
  {
    std::vector<int> result(3 * static_cast<std::size_t>(patch.faces.size()));
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = static_cast<int>(i);
    return result;
  }

  std::vector<Side_edge> side_edges() const
  {
    const int begin = 3 * m_patch.faces.begin_index;
    std::vector<Side_edge> result;
    for(int h = begin; h < 3 * m_patch.faces.end_index; ++h)
      if(m_surface.is_constrained(h))
      {
        const int direction = m_charts.direction_of(h);
        result.push_back({ h, previous_of(h) - begin, h - begin, direction % 2, direction < 2 ? 1 : -1 });
      }
    return result;
  }

  // With a new factorization now and then, for the stiffness that the barrier gives the faces. Gives up where this is
  // of no use, as it is if all three vertices of a face must be on one grid line.
  template <typename SolverTraits>
  bool untangle(const SolverTraits& solver_traits, std::vector<double>& z) const
  {
    typedef decltype(solver_traits.real_solver_object()) Solver;
    std::vector<double> stiffness(m_patch.faces.size(), 1);
    double last_least = -std::numeric_limits<double>::infinity();
    for(int i = 0; i < number_of_factorizations; ++i)
    {
      Map_elements elements = m_elements;
      for(std::size_t f = 0; f < stiffness.size(); ++f)
        elements.stiffen(static_cast<int>(f), stiffness[f]);
      Solver solver = solver_traits.real_solver_object();
      if(!solver.factor(Frame_energy<Integer_grid_basis>(elements, m_basis).matrix()))
        return false;
      Untangler<Solver, Integer_grid_basis> untangler(m_elements, m_basis, solver, z);
      if(untangler.untangle(steps_of_factorization))
      {
        untangler.improve(number_of_improving_steps);
        return true;
      }
      if(i >= 2 && untangler.least() <= 0.95 * last_least)
        break;
      last_least = untangler.least();
      stiffness = untangler.stiffness_of_faces();
    }
    return true; // the certificate tells what is left
  }

  bool write(const std::vector<double>& z, Seamless_map& grid_map, int& fraction_bits) const
  {
    std::vector<double> x;
    m_basis.multiply(z, x);
    fraction_bits = fraction_bits_for(z, x);
    if(fraction_bits < 1) // the centers of quads are at half integers
      return false;
    std::vector<std::int64_t> integer_z(z.size()), integer_x;
    for(std::size_t i = 0; i < z.size(); ++i)
      integer_z[i] = std::llround(std::ldexp(z[i], fraction_bits));
    m_basis.multiply(integer_z, integer_x, std::int64_t(1) << fraction_bits);
    const int first = 3 * m_patch.faces.begin_index;
    for(int h = first; h < 3 * m_patch.faces.end_index; ++h)
    {
      const std::size_t i = 2 * static_cast<std::size_t>(h - first);
      grid_map.u[h] = integer_x[i];
      grid_map.v[h] = integer_x[i + 1];
      grid_map.quarter_turns[h] = m_map.quarter_turns[h];
    }
    return true;
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<int>& m_index;
  const Seamless_map& m_map;
  Seamless_charts m_charts; // of the seamless map
  Integer_grid_basis m_basis;
  Map_elements m_elements;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_SOLVER_H
