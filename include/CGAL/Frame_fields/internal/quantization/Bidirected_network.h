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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_BIDIRECTED_NETWORK_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_BIDIRECTED_NETWORK_H

#include <array>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// An edge of a bidirected network, with an unknown integer n. At each end n is added to the sum of a node (sign +1) or
// subtracted from it (sign -1). The sum of each node must be 0. Both ends may be at the same node. An end with node -1
// is free.
struct Bidirected_edge
{
  std::array<int, 2> node;
  std::array<int, 2> sign;  // +1 or -1
  double target;            // the value it should have: it costs weight * (n - target)^2
  double weight;            // positive
  int lower_bound = 1;
  int upper_bound = (std::numeric_limits<int>::max)(); // no bound
};

struct Bidirected_network
{
  int number_of_nodes = 0;
  std::vector<Bidirected_edge> edges;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUANTIZATION_BIDIRECTED_NETWORK_H
