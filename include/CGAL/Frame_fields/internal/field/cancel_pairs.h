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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_CANCEL_PAIRS_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_CANCEL_PAIRS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/accurate_solve.h>
#include <CGAL/Frame_fields/internal/linear/assemble.h>
#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/matching/meshable_matching.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The field of least sum w (r - omega)^2 with a given matching, in a patch in which no face is aligned.
template <typename SolverTraits>
class Field_of_matching
{
public:
  Field_of_matching(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                    const std::vector<int>& face_order, const SolverTraits& solver_traits)
    : m_surface(surface), m_patch(patch), m_omega(omega), m_unknown(patch.faces.size())
    , m_solver(solver_traits.real_solver_object())
  {
    for(int place = patch.faces.begin_index; place < patch.faces.end_index; ++place)
      m_unknown[face_order[place] - patch.faces.begin_index] = place - patch.faces.begin_index - 1; // -1: stays
    m_matrix = assemble<double>(patch.faces.size() - 1, [&](const auto& add)
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

  // Turns the frames of a field; returns whether this was possible such that the matching is the nearest to omega.
  bool smooth(const std::vector<int>& matching, std::vector<double>& alpha)
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
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
      if(!(std::abs(rotation(m_surface, alpha, matching, e) - m_omega[e]) < CGAL_PI / 4))
        return false;
    return true;
  }

  double energy(const std::vector<int>& matching, const std::vector<double>& alpha) const
  {
    double sum = 0;
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
    {
      const double difference = rotation(m_surface, alpha, matching, e) - m_omega[e];
      sum += m_surface.weight[e] * difference * difference;
    }
    return sum;
  }

private:
  int unknown_of(const int halfedge) const { return m_unknown[face_of(halfedge) - m_patch.faces.begin_index]; }
  int first_unknown(const int e) const { return unknown_of(m_surface.dual_edges[e].halfedge); }
  int second_unknown(const int e) const { return unknown_of(m_surface.dual_edges[e].opposite); }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_omega;
  std::vector<int> m_unknown; // per face of the patch, -1 for the one that stays
  decltype(std::declval<const SolverTraits&>().real_solver_object()) m_solver;
  Hermitian_matrix<double> m_matrix;
  bool m_is_factored;
};

// Cancels pairs of a positive and a negative index in a patch that asks for no direction, where that lowers
// sum w (r - omega)^2. The values z of the smoothest field of unit norm are small in wide regions, where the field
// costs next to nothing and has singularities that no unit vectors would have.
//
// Each trial moves the indices of a batch of positive sectors to the negative ones that are the cheapest to reach, and
// smooths the field with this matching. Batches are halved after each round, so that all of a few pairs are tried one
// by one and many pairs in groups. `matching` and `index` are of the whole surface; only the patch is touched.
template <typename SolverTraits>
class Pair_cancellation
{
public:
  Pair_cancellation(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                    std::vector<int>& matching, std::vector<int>& index, std::vector<double>& alpha)
    : m_surface(surface), m_patch(patch), m_omega(omega), m_matching(matching), m_index(index), m_alpha(alpha)
  {}

  Patch_result run(const std::vector<int>& face_order, const SolverTraits& solver_traits)
  {
    match_patch(m_surface, m_patch, m_omega, m_alpha, m_matching);
    const Patch_result result = indices_in_patch(m_surface, m_patch, m_alpha, m_matching, m_index);
    if(result.error_code != OK || positive_sectors().empty() || !has_negative_sector())
      return result;

    Field_of_matching<SolverTraits> field(m_surface, m_patch, m_omega, face_order, solver_traits);
    const State old_state = state();
    field.smooth(m_matching, m_alpha);
    m_energy = field.energy(m_matching, m_alpha);
    restore(old_state);
    int number_of_trials = 0;
    for(std::size_t size = positive_sectors().size(); size > 0; size /= 2)
    {
      const std::vector<int> sectors = positive_sectors();
      for(std::size_t k = 0; k < sectors.size() && has_negative_sector(); k += size)
      {
        if(number_of_trials++ == maximum_number_of_trials)
          return {};
        const std::size_t end = (std::min)(k + size, sectors.size());
        try_to_cancel(std::vector<int>(sectors.begin() + k, sectors.begin() + end), field);
      }
    }
    return {};
  }

private:
  static constexpr int maximum_number_of_trials = 64;

  // The values of the patch.
  struct State
  {
    std::vector<int> matching, index;
    std::vector<double> alpha;
  };

  template <typename T>
  static std::vector<T> part(const std::vector<T>& values, const Index_range& range)
  {
    return std::vector<T>(values.begin() + range.begin_index, values.begin() + range.end_index);
  }

  State state() const
  {
    return { part(m_matching, m_patch.dual_edges), part(m_index, m_patch.sectors), part(m_alpha, m_patch.faces) };
  }

  void restore(const State& state)
  {
    std::copy(state.matching.begin(), state.matching.end(), m_matching.begin() + m_patch.dual_edges.begin_index);
    std::copy(state.index.begin(), state.index.end(), m_index.begin() + m_patch.sectors.begin_index);
    std::copy(state.alpha.begin(), state.alpha.end(), m_alpha.begin() + m_patch.faces.begin_index);
  }

  std::vector<int> positive_sectors() const
  {
    std::vector<int> result;
    for(int s = m_patch.sectors.begin_index; s < m_patch.sectors.end_index; ++s)
      if(m_index[s] > 0)
        result.push_back(s);
    return result;
  }

  bool has_negative_sector() const
  {
    return std::any_of(m_index.begin() + m_patch.sectors.begin_index, m_index.begin() + m_patch.sectors.end_index,
                       [](const int index) { return index < 0; });
  }

  void try_to_cancel(const std::vector<int>& sectors, Field_of_matching<SolverTraits>& field)
  {
    const State old_state = state();
    Meshable_matching matching(m_surface, m_patch, m_omega, m_alpha, m_matching, m_index);
    for(const int s : sectors)
      matching.cancel_with_negative(s);
    const bool is_smooth = field.smooth(m_matching, m_alpha);
    const double energy = field.energy(m_matching, m_alpha);
    if(is_smooth && energy < m_energy)
      m_energy = energy;
    else
      restore(old_state);
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_omega;
  std::vector<int>& m_matching;
  std::vector<int>& m_index;
  std::vector<double>& m_alpha;
  double m_energy = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_CANCEL_PAIRS_H
