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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_BASIS_H
#define CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_BASIS_H

#include <CGAL/Frame_fields/internal/integer_grid/Integer_grid_charts.h>
#include <CGAL/Frame_fields/internal/integer_grid/Rigid_motion.h>
#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The coordinates of the corners of a patch in its integer-grid maps: x = B z + c with entries 0, 1 and -1 in B, one at
// most in a row, and integers c. So every z gives a map whose charts differ by the prescribed motions, whose singular
// and other fixed vertices are at integers, and whose constrained edges are on grid lines.
//
// The coordinates of the corner at the target of halfedge h of the patch are 2 h and 2 h + 1.
class Integer_grid_basis
{
public:
  // `is_fixed` is per sector of the patch: those that must be at the integers where the charts place them.
  Integer_grid_basis(const Cut_surface& surface, const Patch& patch, const Seamless_charts& seamless_charts,
                     const Integer_grid_charts& charts, const std::vector<char>& is_fixed)
    : m_surface(surface), m_patch(patch), m_term(6 * static_cast<std::size_t>(patch.faces.size()))
  {
    for(int sector = patch.sectors.begin_index; sector < patch.sectors.end_index && m_is_consistent; ++sector)
      add_sector(seamless_charts, charts, sector, is_fixed[sector - patch.sectors.begin_index] != 0);
  }

  // Whether the charts have all fixed coordinates at integers, and fit together around each sector.
  bool is_consistent() const { return m_is_consistent; }

  int size() const { return static_cast<int>(m_first_guess.size()); }
  int number_of_coordinates() const { return static_cast<int>(m_term.size()); }

  // The z of the corners where the charts place them.
  const std::vector<double>& first_guess() const { return m_first_guess; }

  // Calls `visit(unknown, coefficient)` for the entry of one row of B, if there is one.
  template <typename Visit>
  void for_each_term(const int coordinate, const Visit& visit) const
  {
    if(m_term[coordinate].unknown >= 0)
      visit(m_term[coordinate].unknown, m_term[coordinate].coefficient);
  }

  // x = B z + c, with lengths of `unit` steps per integer.
  template <typename Number>
  void multiply(const std::vector<Number>& z, std::vector<Number>& x, const Number& unit = 1) const
  {
    x.resize(m_term.size());
    for(std::size_t i = 0; i < m_term.size(); ++i)
    {
      const Term& term = m_term[i];
      x[i] = static_cast<Number>(term.constant) * unit + (term.unknown < 0 ? 0 : term.coefficient * z[term.unknown]);
    }
  }

  // z = B^T x
  void multiply_transposed(const std::vector<double>& x, std::vector<double>& z) const
  {
    z.assign(size(), 0);
    for(std::size_t i = 0; i < m_term.size(); ++i)
      if(m_term[i].unknown >= 0)
        z[m_term[i].unknown] += m_term[i].coefficient * x[i];
  }

  // Gives the unknowns new numbers: the one that was `order[i]` becomes i.
  void reorder(const std::vector<int>& order)
  {
    std::vector<int> new_number(size());
    std::vector<double> guess(size());
    for(int i = 0; i < size(); ++i)
    {
      new_number[order[i]] = i;
      guess[i] = m_first_guess[order[i]];
    }
    m_first_guess.swap(guess);
    for(Term& term : m_term)
      if(term.unknown >= 0)
        term.unknown = new_number[term.unknown];
  }

private:
  struct Term
  {
    int unknown = -1, coefficient = 0;
    std::int64_t constant = 0;
  };

  std::size_t local(const int halfedge) const
  {
    return static_cast<std::size_t>(halfedge - 3 * m_patch.faces.begin_index);
  }

  void add_sector(const Seamless_charts& seamless_charts, const Integer_grid_charts& charts, const int sector,
                  const bool is_fixed)
  {
    const int first_corner = m_surface.first_corner[sector];
    const std::array<double, 2> guess = charts.corners()[local(first_corner)];
    // In the chart of the first corner. A constrained edge keeps the coordinate across it.
    std::array<Term, 2> terms;
    const int kept = m_surface.is_constrained_sector(sector)
                       ? 1 - seamless_charts.direction_of(next_of(first_corner)) % 2 : -1;
    for(int c = 0; c < 2; ++c)
      if(is_fixed || c == kept)
      {
        terms[c].constant = std::llround(guess[c]);
        m_is_consistent = m_is_consistent && static_cast<double>(terms[c].constant) == guess[c];
      }
      else
      {
        terms[c] = { size(), 1, 0 };
        m_first_guess.push_back(guess[c]);
      }
    Rigid_motion motion;
    for_each_corner(m_surface.opposite, first_corner, [&](const int corner)
    {
      for(int c = 0; c < 2; ++c)
        m_term[2 * local(corner) + c] = moved(motion, terms, c);
      if(!m_surface.is_constrained(corner))
        motion = charts.motion_across(corner) * motion;
    });
    if(!m_surface.is_constrained_sector(sector))
      m_is_consistent = m_is_consistent && is_closed(motion, terms, is_fixed);
  }

  static Term moved(const Rigid_motion& motion, const std::array<Term, 2>& terms, const int coordinate)
  {
    const int turns = motion.quarter_turns;
    Term result = terms[(coordinate + turns) % 2];
    if(coordinate == 0 ? turns == 1 || turns == 2 : turns == 2 || turns == 3) // a quarter turn takes (u, v) to (-v, u)
    {
      result.coefficient = -result.coefficient;
      result.constant = -result.constant;
    }
    result.constant += coordinate == 0 ? motion.shift.u : motion.shift.v;
    return result;
  }

  // Whether the way around a vertex takes its place to itself.
  static bool is_closed(const Rigid_motion& motion, const std::array<Term, 2>& terms, const bool is_fixed)
  {
    const Grid_vector p = { terms[0].constant, terms[1].constant };
    return is_fixed ? motion(p) == p : motion == Rigid_motion();
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  std::vector<Term> m_term;          // per coordinate
  std::vector<double> m_first_guess; // per unknown
  bool m_is_consistent = true;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_INTEGER_GRID_INTEGER_GRID_BASIS_H
