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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_OPTIONS_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_OPTIONS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Lengths in the unit of the charts.
struct Streamline_options
{
  double spacing;        // at which new lines begin
  double least_distance; // at which lines stop; 0 if they do not
  double maximum_length;
};

// Checks the parameters and sets the options from them. `spacing` and `maximum_length` are in the unit of the mesh,
// `separation` is a part of the spacing. The default spacing is a 50th of the square root of the area, but at least a
// thousandth of the longest edge.
inline Result set_streamline_options(const Face_charts& charts, const std::optional<double>& spacing,
                                     const double separation,
                                     const double maximum_length, Streamline_options& options)
{
  const double largest_number_of_squares = 1e9;
  const double total_area = charts.total_area();
  // In units of the longest edge. The first bound is for surfaces of hardly any area: without it too many lines could
  // end on one edge.
  const double smallest_spacing = (std::max)(1e-6, std::sqrt(total_area / largest_number_of_squares));

  options.spacing = spacing ? *spacing / charts.unit() : (std::max)(1e-3, std::sqrt(total_area) / 50);
  if(!(options.spacing >= smallest_spacing && std::isfinite(options.spacing)))
    return wrong_parameter("streamline_spacing", spacing.value_or(options.spacing * charts.unit()),
                           "finite and at least " + std::to_string(smallest_spacing * charts.unit()));
  if(!(separation >= 0 && separation <= 1))
    return wrong_parameter("streamline_separation", separation, "in [0, 1]");
  if(!(maximum_length > 0))
    return wrong_parameter("maximum_streamline_length", maximum_length, "positive");
  options.least_distance = separation * options.spacing;
  options.maximum_length = maximum_length / charts.unit();
  return {};
}

template <typename NamedParameters>
Result streamline_options_from(const NamedParameters& np, const Face_charts& charts, Streamline_options& options)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return set_streamline_options(
    charts, choose_parameter(get_parameter(np, internal::streamline_spacing), std::optional<double>()),
    static_cast<double>(choose_parameter(get_parameter(np, internal::streamline_separation), 0.5)),
    static_cast<double>(choose_parameter(get_parameter(np, internal::maximum_streamline_length),
                                         std::numeric_limits<double>::infinity())),
    options);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_STREAMLINE_OPTIONS_H
