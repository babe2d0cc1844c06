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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_RELAXATION_H
#define CGAL_FRAME_FIELDS_INTERNAL_RELAXATION_H

#include <CGAL/Frame_fields/internal/Cut_surface.h>
#include <CGAL/Frame_fields/internal/Patch_result.h>
#include <CGAL/Frame_fields/internal/assemble.h>
#include <CGAL/Frame_fields/internal/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/options.h>
#include <CGAL/Frame_fields/internal/solve.h>

#include <CGAL/number_type_config.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The rotation of each pair of opposite branches, gamma0 and gamma1 of Section 4 of the paper.
typedef std::array<double, 2> Branch_rotations;

// The number of the branch pair (0 or 1) that `alpha` puts along the direction an aligned face must keep.
inline int aligned_branch(const Cut_surface& surface, const int face, const double alpha)
{
  const double quarters = (surface.alignment[face] - alpha) / (CGAL_PI / 2);
  return static_cast<int>(std::lround(quarters)) & 1;
}

// The branch of face j that branch `b` of face i goes to.
inline int matched_branch(const int b, const int matching) { return b ^ (matching & 1); }

// The weight of (gamma0 - gamma1)^2 in each face of a patch. With uniform edge weights it is a constant. Otherwise it is
// area / (sqrt(3) length^2), which makes it the integral of (gamma0 - gamma1)^2 / length^2 against the integral of the
// squared gradients, since an edge between equilateral triangles has weight 1.
class Orthogonality
{
public:
  Orthogonality(const Cut_surface& surface, const Patch& patch, const Options& options)
    : m_surface(surface)
    , m_is_integral(options.edge_weighting != UNIFORM_WEIGHTS)
    , m_factor(options.orthogonality_weight)
  {
    if(!m_is_integral)
      return;
    const double length = options.orthogonality_length / surface.length_unit;
    const double default_squared_length = default_length_ratio * default_length_ratio * patch_area(surface, patch);
    const double squared_length =
      options.orthogonality_length > 0 ? (std::max)(length * length, smallest_number) : default_squared_length;
    m_factor = squared_length > 0 ? 1 / (std::sqrt(3.) * squared_length) : 0; // 0: a patch without area
  }

  double weight(const int face) const
  {
    return (std::min)(largest_weight, m_is_integral ? m_factor * area(m_surface, face) : m_factor);
  }

  // Whether the weight ties the two branches of a face to one another. One that vanishes in the rounding errors of the
  // edge weights does not.
  bool ties(const int face) const { return weight(face) > smallest_weight; }

private:
  static constexpr double default_length_ratio = 0.25; // of the square root of the patch's area
  static constexpr double smallest_number = (std::numeric_limits<double>::min)();
  // The edges have weights of about 1. A much larger weight would drown them, and holds the frames orthogonal as it is.
  static constexpr double smallest_weight = 1e-12, largest_weight = 1e8;

  const Cut_surface& m_surface;
  bool m_is_integral;
  double m_factor;
};

// The minimization of sum w (r0^2 + r1^2) + sum weight (gamma0 - gamma1)^2 over one patch. Branch b of a face is a node of
// a graph whose edges are the matched pairs across dual edges and, if the weight ties them, the two branches of a face.
class Relaxation_system
{
public:
  Relaxation_system(const Cut_surface& surface, const Patch& patch, const std::vector<double>& alpha,
                    const std::vector<int>& matching, const Orthogonality& orthogonality)
    : m_surface(surface), m_patch(patch), m_alpha(alpha), m_matching(matching), m_orthogonality(orthogonality)
  {
    std::vector<bool> is_fixed = aligned_nodes();
    fix_one_node_of_each_loose_piece(is_fixed);
    m_unknown.assign(is_fixed.size(), -1);
    for(std::size_t node = 0; node < is_fixed.size(); ++node)
      if(!is_fixed[node])
        m_unknown[node] = m_size++;
  }

  // The number of the unknown of a branch of a face, -1 if its rotation is fixed at 0.
  int unknown(const int face, const int branch) const { return m_unknown[node(face, branch)]; }

  Hermitian_matrix<double> matrix() const
  {
    return assemble<double>(m_size, [this](const auto& add)
    {
      const auto add_square_of_difference = [&add](const int i, const int j, const double weight)
      {
        if(i == j)
          return;
        if(i >= 0)
          add(i, i, weight);
        if(j >= 0)
          add(j, j, weight);
        if(i >= 0 && j >= 0)
          add(i, j, -weight);
      };
      for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
        for(int b = 0; b < 2; ++b)
          add_square_of_difference(m_unknown[first_node(e, b)], m_unknown[second_node(e, b)], m_surface.weight[e]);
      for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
        if(const double weight = m_orthogonality.weight(f); weight > 0)
          add_square_of_difference(unknown(f, 0), unknown(f, 1), weight);
    });
  }

  std::vector<double> right_hand_side() const
  {
    std::vector<double> result(m_size, 0);
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
    {
      const double r = rotation(m_surface, m_alpha, m_matching, e);
      for(int b = 0; b < 2; ++b)
      {
        const int i = m_unknown[first_node(e, b)], j = m_unknown[second_node(e, b)];
        if(i >= 0)
          result[i] += m_surface.weight[e] * r;
        if(j >= 0)
          result[j] -= m_surface.weight[e] * r;
      }
    }
    return result;
  }

private:
  int node(const int face, const int branch) const { return 2 * (face - m_patch.faces.begin_index) + branch; }
  int first_node(const int e, const int b) const { return node(face_of(m_surface.dual_edges[e].halfedge), b); }
  int second_node(const int e, const int b) const
  {
    return node(face_of(m_surface.dual_edges[e].opposite), matched_branch(b, m_matching[e]));
  }

  std::vector<bool> aligned_nodes() const
  {
    std::vector<bool> is_fixed(2 * static_cast<std::size_t>(m_patch.faces.size()), false);
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      if(m_surface.is_aligned(f))
        is_fixed[node(f, aligned_branch(m_surface, f, m_alpha[f]))] = true;
    return is_fixed;
  }

  // A connected piece of the graph without fixed node is determined only up to a constant.
  void fix_one_node_of_each_loose_piece(std::vector<bool>& is_fixed) const
  {
    const int number_of_nodes = static_cast<int>(is_fixed.size());
    std::vector<int> rank(number_of_nodes, 0), parent(number_of_nodes);
    std::iota(parent.begin(), parent.end(), 0);
    boost::disjoint_sets<int*, int*> pieces(rank.data(), parent.data());
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
      for(int b = 0; b < 2; ++b)
        pieces.union_set(first_node(e, b), second_node(e, b));
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      if(m_orthogonality.ties(f))
        pieces.union_set(node(f, 0), node(f, 1));

    std::vector<bool> is_piece_fixed(number_of_nodes, false);
    for(int n = 0; n < number_of_nodes; ++n)
      if(is_fixed[n])
        is_piece_fixed[pieces.find_set(n)] = true;
    for(int n = 0; n < number_of_nodes; ++n)
      if(!is_piece_fixed[pieces.find_set(n)])
        is_fixed[n] = is_piece_fixed[pieces.find_set(n)] = true;
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_alpha;
  const std::vector<int>& m_matching;
  Orthogonality m_orthogonality;
  std::vector<int> m_unknown; // per node
  int m_size = 0;
};

// Brings gamma0 and gamma1 to a distance of at most `maximum_skewness`; returns whether they were farther apart.
// `fixed_branch` is the one that must stay, -1 if both may move.
inline bool clamp(Branch_rotations& gamma, const int fixed_branch, const double maximum_skewness)
{
  const double skewness = gamma[1] - gamma[0];
  if(std::abs(skewness) <= maximum_skewness)
    return false;
  const double clamped = std::copysign(maximum_skewness, skewness);
  if(fixed_branch == 0)
    gamma[1] = gamma[0] + clamped;
  else if(fixed_branch == 1)
    gamma[0] = gamma[1] - clamped;
  else
  {
    const double mean = (gamma[0] + gamma[1]) / 2;
    gamma = { mean - clamped / 2, mean + clamped / 2 };
  }
  return true;
}

// Writes gamma on the faces of the patch and counts the faces that were clamped.
template <typename SolverTraits>
Patch_result relax_patch(const Cut_surface& surface, const Patch& patch, const std::vector<double>& alpha,
                         const std::vector<int>& matching, const Options& options, const SolverTraits& solver_traits,
                         std::vector<Branch_rotations>& gamma, int& number_of_clamped_faces)
{
  const Relaxation_system system(surface, patch, alpha, matching,
                                 Orthogonality(surface, patch, options));
  auto solver = solver_traits.real_solver_object();
  std::vector<double> solution;
  if(!factor_and_solve(solver, system.matrix(), system.right_hand_side(), solution))
    return { ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, patch.sectors.begin_index };

  number_of_clamped_faces = 0;
  for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
  {
    for(int b = 0; b < 2; ++b)
      gamma[f][b] = system.unknown(f, b) < 0 ? 0 : solution[system.unknown(f, b)];
    const int fixed_branch = surface.is_aligned(f) ? aligned_branch(surface, f, alpha[f]) : -1;
    if(clamp(gamma[f], fixed_branch, options.maximum_skewness))
      ++number_of_clamped_faces;
  }
  return {};
}

// sum w (r - omega)^2 over the dual edges of an orthogonal field.
inline double orthogonal_energy(const Cut_surface& surface, const std::vector<double>& omega,
                                const std::vector<double>& alpha, const std::vector<int>& matching)
{
  double energy = 0;
  for(int e = 0; e < surface.number_of_dual_edges(); ++e)
  {
    const double difference = rotation(surface, alpha, matching, e) - omega[e];
    energy += surface.weight[e] * difference * difference;
  }
  return energy;
}

// sum w (r0^2 + r1^2) over the dual edges; `alpha` is the field before relaxation.
inline double relaxed_energy(const Cut_surface& surface, const std::vector<double>& alpha,
                             const std::vector<int>& matching, const std::vector<Branch_rotations>& gamma)
{
  double energy = 0;
  for(int e = 0; e < surface.number_of_dual_edges(); ++e)
  {
    const double r = rotation(surface, alpha, matching, e);
    const Branch_rotations& gamma_i = gamma[face_of(surface.dual_edges[e].halfedge)];
    const Branch_rotations& gamma_j = gamma[face_of(surface.dual_edges[e].opposite)];
    for(int b = 0; b < 2; ++b)
    {
      const double r_b = r - gamma_i[b] + gamma_j[matched_branch(b, matching[e])];
      energy += surface.weight[e] * r_b * r_b;
    }
  }
  return energy;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_RELAXATION_H
