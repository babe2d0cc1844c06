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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FEATURE_OPTIONS_H
#define CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FEATURE_OPTIONS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <optional>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The named parameters of the detection of features; `check()` below has their ranges.
struct Feature_options
{
  double strong_angle, weak_angle; // degrees
  double minimum_chain_length;            // in units of the mesh
  std::optional<double> coordinate_error; // in units of the mesh; by default, from the coordinates
  bool closes_gaps;
};

template <typename NamedParameters>
Feature_options feature_options_from(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Feature_options options;
  options.strong_angle = choose_parameter(get_parameter(np, internal::strong_angle), 40.);
  options.weak_angle = choose_parameter(get_parameter(np, internal::weak_angle), options.strong_angle);
  options.minimum_chain_length = choose_parameter(get_parameter(np, internal::minimum_chain_length), 0.);
  options.coordinate_error = choose_parameter(get_parameter(np, internal::coordinate_error), std::optional<double>());
  options.closes_gaps = choose_parameter(get_parameter(np, internal::close_gaps), false);
  return options;
}

// Returns an error that names the first option out of its range, or success.
inline Result check(const Feature_options& options)
{
  if(!(options.strong_angle >= 0 && options.strong_angle <= 180))
    return failure(ERROR_WRONG_PARAMETER, "strong_angle_in_degrees must be from 0 to 180");
  if(!(options.weak_angle >= 0 && options.weak_angle <= options.strong_angle))
    return failure(ERROR_WRONG_PARAMETER, "weak_angle_in_degrees must be from 0 to strong_angle_in_degrees");
  if(!(options.minimum_chain_length >= 0))
    return failure(ERROR_WRONG_PARAMETER, "minimum_chain_length must not be negative");
  if(options.coordinate_error && !(*options.coordinate_error >= 0))
    return failure(ERROR_WRONG_PARAMETER, "coordinate_error must not be negative");
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FEATURES_FEATURE_OPTIONS_H
