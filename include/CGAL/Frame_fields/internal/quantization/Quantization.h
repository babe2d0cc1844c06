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


#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZATION_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZATION_H

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// How much work may be done beyond what is needed. All budgets count steps, not seconds: results never depend on the
// machine.
struct Quantization_options
{
  std::int64_t maximum_number_of_flows = 2000;     // in branch and bound, per component
  std::int64_t maximum_number_of_steps = 10000000; // in branch and bound, per component: one per edge and visit
  int maximum_number_of_strip_rounds = 20;
  bool joins_by_paths = true;                      // whether `Imbalance_paths` runs before branch and bound
};

// Integers for all edges of a network.
struct Quantization
{
  bool is_feasible = true;          // there are integers within the bounds, and `value` has them
  bool is_optimal = true;           // no integers cost less
  std::vector<int> value;           // per edge; in a component without solution, the integer nearest to the target;
                                    // all 0 if the bounds of a chain of equal edges exclude one another
  std::vector<int> unattainable;    // edges that must not be 0 but lie on no strip: they are 0 in every solution
  std::vector<int> conflicting;     // where nothing is unattainable, but there is no solution: edges whose bounds
                                    // exclude one another
  double cost = 0;                  // sum of weight (value - target)^2
  double cost_bound = 0;            // at most the least cost: where the values are optimal, their cost, elsewhere the
                                    // cost of the best halves
  int number_of_strips_moved = 0;   // by the strip search
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_QUANTIZATION_H
