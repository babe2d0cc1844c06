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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_SIZED_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_SIZED_QUADS_H

#include <CGAL/Frame_fields/internal/quads/Arc_bends.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_maker.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Where features are close together, sides come out much shorter than asked for. If the mean is below half the target,
// a second run follows the arcs more closely in the same proportion.
inline Quad_complex make_quads_along_arcs(Quad_maker& maker)
{
  Quad_complex complex = maker.make();
  const double tolerance = Arc_bends::part_of_edge_length * maker.mean_length_of_sides(complex);
  if(maker.layout().arc_tolerance() > 2 * tolerance)
  {
    maker.layout().follow_arcs_within(tolerance);
    complex = maker.make();
  }
  return complex;
}

// Changes the edge lengths until the number of quads is within 2% of the wanted one. Features that are close together
// may prevent this: after six runs, the quads are made anew with the lengths that came nearest.
inline Quad_complex make_quads_of_number(Quad_maker& maker, const double wanted_number)
{
  const int maximum_number_of_runs = 6;
  const double tolerance = 0.02, largest_factor = 2;
  double scale = 1, best_scale = 1, best_error = 0;
  for(int run = 0; run < maximum_number_of_runs; ++run)
  {
    Quad_complex complex = make_quads_along_arcs(maker);
    const double ratio = static_cast<double>(complex.quads.size()) / wanted_number, error = std::abs(std::log(ratio));
    if(error <= tolerance)
      return complex;
    if(run == 0 || error < best_error)
    {
      best_error = error;
      best_scale = scale;
    }
    const double factor = (std::min)(largest_factor, (std::max)(1 / largest_factor, std::sqrt(ratio)));
    maker.layout().scale_edge_lengths(factor);
    scale *= factor;
  }
  maker.layout().scale_edge_lengths(best_scale / scale);
  return make_quads_along_arcs(maker);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_MAKE_SIZED_QUADS_H
