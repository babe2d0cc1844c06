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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_ORTHOGONAL_FIELD_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_ORTHOGONAL_FIELD_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/field/falling_values.h>
#include <CGAL/Frame_fields/internal/field/unit_length_flow.h>
#include <CGAL/Frame_fields/internal/field/vanishing_values.h>
#include <CGAL/Frame_fields/internal/linear/accurate_solve.h>
#include <CGAL/Frame_fields/internal/linear/assemble.h>
#include <CGAL/Frame_fields/internal/linear/smallest_eigenvector.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/weights.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <complex>
#include <random>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The angle of the branch that an aligned face must have, up to quarter turns: in [-pi / 4, pi / 4].
inline double aligned_alpha(const Cut_surface& surface, const int face)
{
  return std::remainder(surface.alignment[face], CGAL_PI / 2);
}

// Whether any face of a patch is aligned or guided; otherwise its field is determined only up to a rotation and scale.
inline bool asks_for_direction(const Cut_surface& surface, const Patch& patch)
{
  for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
    if(surface.is_aligned(f) || guide_weight(surface, f) > smallest_effective_weight)
      return true;
  return false;
}

// The minimization of sum w |z_i - z_j exp(4i (c_ij - omega_ij))|^2 over the faces of one patch that are not aligned
// (eq. (8) of the paper), plus the squared differences from guiding directions.
class Orthogonal_field_system
{
public:
  // The unknowns are numbered in the order of the faces in `face_order`.
  Orthogonal_field_system(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                          const std::vector<int>& face_order)
    : m_surface(surface), m_patch(patch), m_unknown(patch.faces.size(), -1)
    , m_is_anchored(asks_for_direction(surface, patch))
  {
    m_transport.reserve(patch.dual_edges.size());
    for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
      m_transport.push_back(std::polar(1., 4 * (surface.transport[e] - omega[e])));
    for(int place = patch.faces.begin_index; place < patch.faces.end_index; ++place)
    {
      const int f = face_order[place];
      if(!surface.is_aligned(f))
        m_unknown[f - patch.faces.begin_index] = m_size++;
    }
  }

  int size() const { return m_size; }

  bool is_anchored() const { return m_is_anchored; }

  // The number of the unknown of a face, -1 if the face is aligned.
  int unknown(const int face) const { return m_unknown[face - m_patch.faces.begin_index]; }

  // The factor that carries the value of face j of a dual edge over to face i.
  const Complex& transport(const int e) const { return m_transport[e - m_patch.dual_edges.begin_index]; }

  Hermitian_matrix<Complex> matrix() const
  {
    return assemble<Complex>(m_size, [this](const auto& add)
    {
      for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
      {
        const int i = unknown(face_of(m_surface.dual_edges[e].halfedge));
        const int j = unknown(face_of(m_surface.dual_edges[e].opposite));
        const double weight = m_surface.weight[e];
        if(i >= 0)
          add(i, i, Complex(weight));
        if(j >= 0)
          add(j, j, Complex(weight));
        if(i >= 0 && i == j) // a face glued to itself
          add(i, i, Complex(-2 * weight * transport(e).real()));
        else if(i >= 0 && j >= 0)
          add(i, j, -weight * transport(e));
      }
      if(!m_surface.guide_weight.empty())
        for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
          if(unknown(f) >= 0)
            add(unknown(f), unknown(f), Complex(guide_weight(m_surface, f)));
    });
  }

  std::vector<Complex> right_hand_side() const
  {
    std::vector<Complex> result(m_size, Complex(0));
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
    {
      const int face_i = face_of(m_surface.dual_edges[e].halfedge);
      const int face_j = face_of(m_surface.dual_edges[e].opposite);
      if(unknown(face_i) >= 0 && unknown(face_j) < 0)
        result[unknown(face_i)] += m_surface.weight[e] * transport(e) * aligned_value(face_j);
      else if(unknown(face_i) < 0 && unknown(face_j) >= 0)
        result[unknown(face_j)] += m_surface.weight[e] * std::conj(transport(e)) * aligned_value(face_i);
    }
    if(!m_surface.guide_weight.empty())
      for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
        if(unknown(f) >= 0)
          result[unknown(f)] += guide_weight(m_surface, f) * std::polar(1., 4 * m_surface.guide_angle[f]);
    return result;
  }

  // Where the search for the smallest eigenvector starts. The patch must have no aligned face. The values are
  // pseudorandom, so that no pattern of a mesh is orthogonal to them; they depend on the number of the face, not on
  // that of its unknown.
  std::vector<Complex> start_vector() const
  {
    std::mt19937 generator;
    const auto coordinate = [&generator] { return generator() / 4294967296. - 0.5; };
    std::vector<Complex> result(m_size);
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
    {
      const double real = coordinate();
      result[unknown(f)] = { real, coordinate() };
    }
    return result;
  }

private:
  Complex aligned_value(const int face) const
  {
    return std::polar(1., 4 * aligned_alpha(m_surface, face));
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  std::vector<Complex> m_transport; // per dual edge of the patch
  std::vector<int> m_unknown;       // per face of the patch
  int m_size = 0;
  bool m_is_anchored;
};

// Finds the values of the unknowns and their levels, which stand for factors below the range of `double` (see
// `Falling_values`). If no face of the patch asks for a direction, the field comes from the smallest eigenvector by
// `flow_to_unit_length()`, and `level` is left as it is. Returns false if the solver fails.
template <typename Solver>
bool solve_orthogonal_field(Solver& solver, const Orthogonal_field_system& system, std::vector<Complex>& z,
                            std::vector<int>& level)
{
  const Hermitian_matrix<Complex> matrix = system.matrix();
  if(!system.is_anchored())
    return smallest_eigenvector(solver, matrix, system.start_vector(), z) && flow_to_unit_length(solver, matrix, z);
  const std::vector<Complex> right_hand_side = system.right_hand_side();
  return factor_and_solve(solver, matrix, right_hand_side, z)
      && Falling_values<Solver>(solver, matrix, right_hand_side, z).find(level);
}

// Writes alpha on the faces of the patch, given the values of the unknowns.
inline void write_alpha(const Cut_surface& surface, const Patch& patch, const Orthogonal_field_system& system,
                        const std::vector<Complex>& z, std::vector<double>& alpha)
{
  for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
    alpha[f] = system.unknown(f) < 0 ? aligned_alpha(surface, f) : std::arg(z[system.unknown(f)]) / 4;
}

// Writes the smoothest field on the faces of the patch.
template <typename SolverTraits>
Patch_result orthogonal_field_in_patch(const Cut_surface& surface, const Patch& patch,
                                       const std::vector<double>& omega, const std::vector<int>& face_order,
                                       const SolverTraits& solver_traits, std::vector<double>& alpha)
{
  const Orthogonal_field_system system(surface, patch, omega, face_order);
  auto solver = solver_traits.complex_solver_object();
  std::vector<Complex> z;
  std::vector<int> level;
  if(!solve_orthogonal_field(solver, system, z, level))
    return { ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, patch.sectors.begin_index };

  Field_without_zeros<Orthogonal_field_system>(surface, patch, system, level, z).replace_vanishing_values();
  write_alpha(surface, patch, system, z, alpha);
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_ORTHOGONAL_FIELD_H
