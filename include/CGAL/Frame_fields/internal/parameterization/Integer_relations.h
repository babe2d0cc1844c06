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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_INTEGER_RELATIONS_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_INTEGER_RELATIONS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <queue>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

struct Integer_term
{
  int variable;
  std::int64_t coefficient;
};

typedef std::vector<Integer_term> Integer_row;

// A system of homogeneous linear equations with integer coefficients, solved as it grows: it expresses each variable by
// free ones with integer coefficients, such that all its integer solutions come from integers. Variables are eliminated
// where their coefficient is 1 or -1; where there is none, a unimodular change of variables makes one.
class Integer_relations
{
public:
  // The weight of a variable is the number of the caller's rows that it occurs in; lighter ones are eliminated first.
  explicit Integer_relations(const std::vector<int>& weight)
    : m_weight(weight), m_place_of(weight.size(), -1), m_value(weight.size(), 0), m_is_touched(weight.size(), false)
  {}

  int number_of_variables() const { return static_cast<int>(m_weight.size()); }
  bool is_free(const int variable) const { return m_place_of[variable] < 0; }

  // Whether a coefficient exceeded `largest_coefficient`. Rows are meaningless then.
  bool has_overflow() const { return m_has_overflow; }

  // Demands that the row vanishes.
  void add(const Integer_row& row)
  {
    Integer_row rest = reduced(row);
    divide_by_common_factor(rest);
    while(!rest.empty() && !m_has_overflow)
    {
      const std::size_t pivot = best_pivot(rest);
      if(std::abs(rest[pivot].coefficient) == 1)
      {
        eliminate(rest[pivot].variable, rest, pivot);
        return;
      }
      change_variable(rest, pivot);
    }
  }

  // The row in terms of the free variables, in increasing order of these.
  Integer_row reduced(const Integer_row& row)
  {
    // A variable is replaced by ones that are free or were eliminated later, so that each is replaced once.
    std::priority_queue<int, std::vector<int>, std::greater<int> > places;
    std::vector<int> touched;
    const auto add_term = [&](const int variable, const std::int64_t coefficient)
    {
      m_value[variable] += coefficient;
      if(m_is_touched[variable])
        return;
      m_is_touched[variable] = true;
      touched.push_back(variable);
      if(!is_free(variable))
        places.push(m_place_of[variable]);
    };
    for(const Integer_term& term : row)
      add_term(term.variable, term.coefficient);
    while(!places.empty())
    {
      const Elimination& elimination = m_eliminations[places.top()];
      places.pop();
      const std::int64_t factor = m_value[elimination.variable];
      m_value[elimination.variable] = 0;
      m_has_overflow = m_has_overflow || std::abs(factor) > largest_coefficient;
      if(factor != 0 && !m_has_overflow)
        for(const Integer_term& term : elimination.row)
          add_term(term.variable, factor * term.coefficient);
    }

    std::sort(touched.begin(), touched.end());
    Integer_row result;
    for(const int variable : touched)
    {
      if(m_value[variable] != 0)
        result.push_back({ variable, m_value[variable] });
      m_has_overflow = m_has_overflow || std::abs(m_value[variable]) > largest_coefficient;
      m_value[variable] = 0;
      m_is_touched[variable] = false;
    }
    return result;
  }

private:
  struct Elimination
  {
    int variable;
    Integer_row row; // what the variable equals, in variables that are free or were eliminated later
  };

  static void divide_by_common_factor(Integer_row& row)
  {
    std::int64_t factor = 0;
    for(const Integer_term& term : row)
      factor = std::gcd(factor, term.coefficient);
    if(factor > 1)
      for(Integer_term& term : row)
        term.coefficient /= factor;
  }

  // The term with the smallest coefficient, and among these the one whose variable weighs least.
  std::size_t best_pivot(const Integer_row& row) const
  {
    std::size_t best = 0;
    for(std::size_t k = 1; k < row.size(); ++k)
    {
      const std::int64_t size = std::abs(row[k].coefficient), best_size = std::abs(row[best].coefficient);
      if(size < best_size || (size == best_size && m_weight[row[k].variable] < m_weight[row[best].variable]))
        best = k;
    }
    return best;
  }

  void eliminate(const int variable, const Integer_row& row, const std::size_t pivot)
  {
    Elimination elimination{ variable, {} };
    elimination.row.reserve(row.size() - 1);
    for(std::size_t k = 0; k < row.size(); ++k)
      if(k != pivot)
        elimination.row.push_back({ row[k].variable, -row[pivot].coefficient * row[k].coefficient });
    m_place_of[variable] = static_cast<int>(m_eliminations.size());
    m_eliminations.push_back(elimination);
  }

  // Replaces the variable of the smallest coefficient by a new one minus multiples of the others. This leaves the
  // remainders as their coefficients, as in Euclid's algorithm.
  void change_variable(Integer_row& row, const std::size_t pivot)
  {
    const Integer_term old = row[pivot];
    const int new_variable = number_of_variables();
    m_weight.push_back(m_weight[old.variable]);
    m_place_of.push_back(-1);
    m_value.push_back(0);
    m_is_touched.push_back(false);

    Elimination elimination{ old.variable, { { new_variable, 1 } } };
    Integer_row rest;
    for(std::size_t k = 0; k < row.size(); ++k)
      if(k != pivot)
      {
        const std::int64_t quotient = row[k].coefficient / old.coefficient;
        const std::int64_t remainder = row[k].coefficient - quotient * old.coefficient;
        if(quotient != 0)
          elimination.row.push_back({ row[k].variable, -quotient });
        if(remainder != 0)
          rest.push_back({ row[k].variable, remainder });
      }
    rest.push_back({ new_variable, old.coefficient });
    m_place_of[old.variable] = static_cast<int>(m_eliminations.size());
    m_eliminations.push_back(elimination);
    row.swap(rest);
  }

  static constexpr std::int64_t largest_coefficient = 1 << 20;

  std::vector<int> m_weight;    // per variable
  std::vector<int> m_place_of;  // per variable: its place in `m_eliminations`, -1 if it is free
  std::vector<Elimination> m_eliminations;
  std::vector<std::int64_t> m_value; // per variable: 0 between the calls
  std::vector<char> m_is_touched;    // per variable
  bool m_has_overflow = false;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_INTEGER_RELATIONS_H
