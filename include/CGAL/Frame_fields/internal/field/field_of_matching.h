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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_FIELD_OF_MATCHING_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_FIELD_OF_MATCHING_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/field/energies.h>
#include <CGAL/Frame_fields/internal/linear/accurate_solve.h>
#include <CGAL/Frame_fields/internal/linear/assemble.h>
#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// References to the arrays of a field for all patches, and copies of the parts of them that belong to one patch.
class Matched_field
{
public:
  Matched_field(const Patch& patch, std::vector<double>& alpha, std::vector<int>& matching, std::vector<int>& index)
    : alpha(alpha), matching(matching), index(index), m_patch(patch)
  {}

  // A copy of the values of the patch.
  struct State
  {
    std::vector<double> alpha;
    std::vector<int> matching, index;
  };

  State state() const
  {
    return { part(alpha, m_patch.faces), part(matching, m_patch.dual_edges), part(index, m_patch.sectors) };
  }

  void restore(const State& state)
  {
    std::copy(state.alpha.begin(), state.alpha.end(), alpha.begin() + m_patch.faces.begin_index);
    std::copy(state.matching.begin(), state.matching.end(), matching.begin() + m_patch.dual_edges.begin_index);
    std::copy(state.index.begin(), state.index.end(), index.begin() + m_patch.sectors.begin_index);
  }

  // The sum of |4 I| over the patch.
  double sum_of_absolute_indices() const
  {
    double sum = 0;
    for(int s = m_patch.sectors.begin_index; s < m_patch.sectors.end_index; ++s)
      sum += std::abs(index[s]);
    return sum;
  }

  std::vector<double>& alpha;
  std::vector<int>& matching;
  std::vector<int>& index;

private:
  template <typename T>
  static std::vector<T> part(const std::vector<T>& values, const Index_range& range)
  {
    return std::vector<T>(values.begin() + range.begin_index, values.begin() + range.end_index);
  }

  const Patch& m_patch;
};

// Finds the field of least sum w (r - omega)^2 with a given matching. Aligned faces keep their frames; if there are
// none, the first face of the order does. Guiding directions are not regarded. The matrix is factored once, for any
// number of matchings.
template <typename SolverTraits>
class Field_of_matching
{
public:
  Field_of_matching(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                    const std::vector<int>& face_order, const SolverTraits& solver_traits)
    : m_surface(surface), m_patch(patch), m_omega(omega), m_unknown(patch.faces.size())
    , m_solver(solver_traits.real_solver_object())
  {
    const bool has_aligned_faces = std::any_of(face_order.begin() + patch.faces.begin_index,
                                               face_order.begin() + patch.faces.end_index,
                                               [&](const int f) { return surface.is_aligned(f); });
    int next_unknown = has_aligned_faces ? 0 : -1; // -1: stays
    for(int place = patch.faces.begin_index; place < patch.faces.end_index; ++place)
    {
      const int f = face_order[place];
      m_unknown[f - patch.faces.begin_index] = surface.is_aligned(f) ? -1 : next_unknown++;
    }
    m_matrix = assemble<double>(next_unknown, [&](const auto& add)
    {
      for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
      {
        const int i = first_unknown(e), j = second_unknown(e);
        if(i == j)
          continue;
        if(i >= 0)
          add(i, i, surface.weight[e]);
        if(j >= 0)
          add(j, j, surface.weight[e]);
        if(i >= 0 && j >= 0)
          add(i, j, -surface.weight[e]);
      }
    });
    m_is_factored = m_matrix.size() > 0 && m_solver.factor(m_matrix);
  }

  // Turns the frames of a field to those of least energy, and sets this energy. Returns whether the matching is still
  // nearest to omega then. If not, or if the solver fails, `alpha` and the energy may be changed: the caller must
  // restore them.
  bool smooth(const std::vector<int>& matching, std::vector<double>& alpha, double& smoothed_energy)
  {
    if(!m_is_factored)
      return false;
    std::vector<double> right_hand_side(m_matrix.size(), 0), turn;
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
    {
      const double pull = m_surface.weight[e] * (rotation(m_surface, alpha, matching, e) - m_omega[e]);
      if(const int i = first_unknown(e); i >= 0)
        right_hand_side[i] += pull;
      if(const int j = second_unknown(e); j >= 0)
        right_hand_side[j] -= pull;
    }
    if(!accurate_solve(m_solver, m_matrix, right_hand_side, turn))
      return false;
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      if(const int unknown = m_unknown[f - m_patch.faces.begin_index]; unknown >= 0)
        alpha[f] += turn[unknown];
    smoothed_energy = orthogonal_energy(m_surface, m_patch.dual_edges, m_omega, alpha, matching);
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
      if(!(std::abs(rotation(m_surface, alpha, matching, e) - m_omega[e]) < CGAL_PI / 4))
        return false;
    return true;
  }

private:
  int unknown_of(const int halfedge) const { return m_unknown[face_of(halfedge) - m_patch.faces.begin_index]; }
  int first_unknown(const int e) const { return unknown_of(m_surface.dual_edges[e].halfedge); }
  int second_unknown(const int e) const { return unknown_of(m_surface.dual_edges[e].opposite); }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_omega;
  std::vector<int> m_unknown; // per face of the patch, -1 for those that stay
  decltype(std::declval<const SolverTraits&>().real_solver_object()) m_solver;
  Hermitian_matrix<double> m_matrix;
  bool m_is_factored;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_FIELD_OF_MATCHING_H
