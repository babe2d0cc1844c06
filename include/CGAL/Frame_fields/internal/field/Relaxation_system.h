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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_RELAXATION_SYSTEM_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_RELAXATION_SYSTEM_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/field/Orthogonality.h>
#include <CGAL/Frame_fields/internal/field/branch_pairs.h>
#include <CGAL/Frame_fields/internal/linear/assemble.h>
#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/weights.h>

#include <CGAL/number_type_config.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The minimization of sum w (r0^2 + r1^2) + sum weight (gamma0 - gamma1)^2 over one patch, plus 2 guide_weight times
// the squared angles between guiding directions and the branch pairs nearest to them: the same balance as in the
// orthogonal field, where |z_i - z_j ...|^2 is 16 r^2 for small r.
//
// The variables are s = gamma0 + gamma1 and d = gamma0 - gamma1: with sigma = (-1)^p,
//   2 (r0^2 + r1^2) = (2 r - s_i + s_j)^2 + (d_i - sigma d_j)^2,
// so that only guided faces couple a sum with a difference, and aligned faces, where gamma0 or gamma1 is 0. The
// factorization has less fill-in than with gamma0 and gamma1 as unknowns, which are coupled in each face.
class Relaxation_system
{
public:
  // The unknowns are numbered in the order of the faces in `face_order`. An elimination order of the unknowns
  // themselves would give a sixth less fill-in, but takes longer to find.
  Relaxation_system(const Cut_surface& surface, const Patch& patch, const std::vector<double>& alpha,
                    const std::vector<int>& matching, const Orthogonality& orthogonality,
                    const std::vector<int>& face_order)
    : m_surface(surface), m_patch(patch), m_alpha(alpha), m_matching(matching), m_orthogonality(orthogonality)
    , m_variable(2 * static_cast<std::size_t>(patch.faces.size()))
  {
    for(int place = patch.faces.begin_index; place < patch.faces.end_index; ++place)
    {
      const int f = face_order[place];
      m_variable[sum(f)] = { m_size++, 1 };
      if(!surface.is_aligned(f))
        m_variable[difference(f)] = { m_size++, 1 };
      else
        m_variable[difference(f)] = { m_variable[sum(f)].unknown, aligned_branch(surface, f, alpha[f]) == 0 ? -1 : 1 };
    }
    fix_what_is_free();
  }

  Hermitian_matrix<double> matrix() const
  {
    return assemble<double>(m_size, [this](const auto& add)
    {
      for_each_square([&](const Variable& a, const Variable& b, const double weight)
      {
        if(a.unknown >= 0 && a.unknown == b.unknown)
          add(a.unknown, a.unknown, a.sign == b.sign ? 0. : 4 * weight);
        else
        {
          if(a.unknown >= 0)
            add(a.unknown, a.unknown, weight);
          if(b.unknown >= 0)
            add(b.unknown, b.unknown, weight);
          if(a.unknown >= 0 && b.unknown >= 0)
            add(a.unknown, b.unknown, -weight * a.sign * b.sign);
        }
      });
    });
  }

  std::vector<double> right_hand_side() const
  {
    std::vector<double> result(m_size, 0);
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
    {
      const double twice_r = 2 * rotation(m_surface, m_alpha, m_matching, e);
      const int i = m_variable[sum(first_face(e))].unknown, j = m_variable[sum(second_face(e))].unknown;
      if(i >= 0)
        result[i] += m_surface.weight[e] * twice_r;
      if(j >= 0)
        result[j] -= m_surface.weight[e] * twice_r;
    }
    for_each_guided_face([&](const int face, const Variable& s, const Variable& d)
    {
      const double twice_angle = 2 * std::remainder(m_surface.guide_angle[face] - m_alpha[face], CGAL_PI / 2);
      for(const Variable& variable : { s, d })
        if(variable.unknown >= 0)
          result[variable.unknown] += variable.sign * guide_weight(m_surface, face) * twice_angle;
    });
    return result;
  }

  // gamma0 and gamma1 of a face, exactly 0 for the branch that an aligned face must keep.
  Branch_rotations branch_rotations(const std::vector<double>& solution, const int face) const
  {
    const double s = value(solution, m_variable[sum(face)]), d = value(solution, m_variable[difference(face)]);
    return { (s + d) / 2, (s - d) / 2 };
  }

private:
  // `sign` times an unknown, or 0 if `unknown` is -1.
  struct Variable
  {
    int unknown, sign;

    Variable operator-() const { return { unknown, -sign }; }
  };

  int sum(const int face) const { return 2 * (face - m_patch.faces.begin_index); }
  int difference(const int face) const { return sum(face) + 1; }
  int first_face(const int e) const { return face_of(m_surface.dual_edges[e].halfedge); }
  int second_face(const int e) const { return face_of(m_surface.dual_edges[e].opposite); }

  static double value(const std::vector<double>& solution, const Variable& variable)
  {
    return variable.unknown < 0 ? 0 : variable.sign * solution[variable.unknown];
  }

  // Calls `visit(face, s, d)` for the faces with soft guiding directions, where (s + d) / 2 is the rotation of the
  // branch pair that the direction pulls at.
  template <typename Visit>
  void for_each_guided_face(const Visit& visit) const
  {
    if(m_surface.guide_weight.empty())
      return;
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      if(guide_weight(m_surface, f) > 0)
      {
        const Variable& d = m_variable[difference(f)];
        visit(f, m_variable[sum(f)], nearest_branch(m_surface.guide_angle[f], m_alpha[f]) == 0 ? d : -d);
      }
  }

  // Calls `visit(a, b, weight)` for the terms weight (a - b)^2 of the energy, without what is constant in them.
  template <typename Visit>
  void for_each_square(const Visit& visit) const
  {
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
    {
      const int i = first_face(e), j = second_face(e);
      const Variable& d_j = m_variable[difference(j)];
      visit(m_variable[sum(i)], m_variable[sum(j)], m_surface.weight[e]);
      visit(m_variable[difference(i)], m_matching[e] % 2 == 0 ? d_j : -d_j, m_surface.weight[e]);
    }
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      if(const double weight = m_orthogonality.weight(f); weight > 0)
        visit(m_variable[difference(f)], Variable{ -1, 1 }, 2 * weight);
    for_each_guided_face([&](const int face, const Variable& s, const Variable& d)
                         { visit(s, -d, guide_weight(m_surface, face)); });
  }

  // The terms join unknowns, up to sign, to pieces. A piece that contains 0, or some unknown with both signs, is held.
  // Any other one may shift by a constant without a change of the energy: one of its unknowns is fixed at 0.
  void fix_what_is_free()
  {
    if(has_face([this](const int f) { return m_orthogonality.ties(f); })
       && has_face([this](const int f) { return m_surface.is_aligned(f); }))
      return; // a difference is held, hence all are, and they hold the sums at an aligned face

    const int zero = 2 * m_size, number_of_nodes = zero + 2; // node 2 u is unknown u, node 2 u + 1 is its negative
    std::vector<int> rank(number_of_nodes, 0), parent(number_of_nodes);
    std::iota(parent.begin(), parent.end(), 0);
    // Not bare pointers: boost::get() for those may be hidden by another one, depending on what was included before.
    const boost::typed_identity_property_map<int> number;
    boost::disjoint_sets pieces(boost::make_iterator_property_map(rank.begin(), number),
                                boost::make_iterator_property_map(parent.begin(), number));
    const auto node = [&](const Variable& v) { return v.unknown < 0 ? zero : 2 * v.unknown + (v.sign < 0); };
    pieces.union_set(zero, zero + 1);
    for_each_square([&](const Variable& a, const Variable& b, const double weight)
    {
      if(weight <= smallest_effective_weight)
        return;
      pieces.union_set(node(a), node(b));
      pieces.union_set(node(-a), node(-b));
    });

    std::vector<bool> is_piece_held(number_of_nodes, false), is_fixed(m_size, false);
    for(const Variable& variable : m_variable) // in the order of the faces, which does not depend on the solver
    {
      const int piece = pieces.find_set(node(variable)), negative_piece = pieces.find_set(node(-variable));
      if(piece != negative_piece && !is_piece_held[piece])
        is_fixed[variable.unknown] = true;
      is_piece_held[piece] = is_piece_held[negative_piece] = true;
    }
    leave_out(is_fixed);
  }

  void leave_out(const std::vector<bool>& is_fixed)
  {
    std::vector<int> new_unknown(m_size, -1);
    int new_size = 0;
    for(int u = 0; u < m_size; ++u)
      if(!is_fixed[u])
        new_unknown[u] = new_size++;
    for(Variable& variable : m_variable)
      variable.unknown = new_unknown[variable.unknown];
    m_size = new_size;
  }

  template <typename Predicate>
  bool has_face(const Predicate& predicate) const
  {
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      if(predicate(f))
        return true;
    return false;
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_alpha;
  const std::vector<int>& m_matching;
  Orthogonality m_orthogonality;
  std::vector<Variable> m_variable; // per face: s and d
  int m_size = 0;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_RELAXATION_SYSTEM_H
