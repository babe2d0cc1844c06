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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_NAMED_PARAMETERS_OPTIONS_H
#define CGAL_FRAME_FIELDS_INTERNAL_NAMED_PARAMETERS_OPTIONS_H

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/Linear_algebra_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/Support_strategy.h>
#include <CGAL/Frame_fields/internal/named_parameters/concurrency.h>
#include <CGAL/Frame_fields/parameters.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#endif

#include <CGAL/Default.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <cmath>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The options of the field among the named parameters; `check()` below has their ranges.
struct Options
{
  double sharp_corner_bound; // radians
  double blunt_corner_bound; // radians
  Support_strategy support_strategy;
  bool repair_matching;
  double maximum_skewness; // radians
  double orthogonality_weight;
  std::optional<double> orthogonality_length; // in units of the mesh; by default, from the areas of the patches
  Edge_weighting edge_weighting;
  bool relax_orthogonality;
  bool measures_lengths = false; // even if no option needs them

  bool needs_lengths() const
  {
    return measures_lengths || edge_weighting != Edge_weighting::UNIFORM
        || support_strategy.kind() == Support_strategy::RADIUS;
  }
};

template <typename NamedParameters>
Options options_from(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return { static_cast<double>(choose_parameter(get_parameter(np, internal::sharp_corner_bound), 0.75 * CGAL_PI)),
           static_cast<double>(choose_parameter(get_parameter(np, internal::blunt_corner_bound), CGAL_PI / 8)),
           choose_parameter(get_parameter(np, internal::support_strategy), Support_strategy::rings(4)),
           static_cast<bool>(choose_parameter(get_parameter(np, internal::repair_matching), true)),
           static_cast<double>(choose_parameter(get_parameter(np, internal::maximum_skewness), 0.45 * CGAL_PI)),
           static_cast<double>(choose_parameter(get_parameter(np, internal::orthogonality_weight), 1e-2)),
           choose_parameter(get_parameter(np, internal::orthogonality_length), std::optional<double>()),
           choose_parameter(get_parameter(np, internal::edge_weighting), Edge_weighting::UNIFORM),
           static_cast<bool>(choose_parameter(get_parameter(np, internal::relax_orthogonality), true)) };
}

// Returns an error that names the first option out of its range, or success.
inline Result check(const Options& options)
{
  if(!(std::isfinite(options.sharp_corner_bound) && options.sharp_corner_bound >= 0))
    return wrong_parameter("sharp_corner_bound", options.sharp_corner_bound,
                           "a finite number that is not negative");
  if(!(options.blunt_corner_bound >= 0))
    return wrong_parameter("blunt_corner_bound", options.blunt_corner_bound,
                           "a number that is not negative, or infinity");
  if(!(options.maximum_skewness >= 0 && options.maximum_skewness < CGAL_PI / 2))
    return wrong_parameter("maximum_skewness", options.maximum_skewness, "in [0, pi/2)");
  if(!(std::isfinite(options.orthogonality_weight) && options.orthogonality_weight >= 0))
    return wrong_parameter("orthogonality_weight", options.orthogonality_weight,
                           "a finite number that is not negative");
  if(const std::optional<double>& length = options.orthogonality_length)
    if(!(std::isfinite(*length) && *length > 0))
      return wrong_parameter("orthogonality_length", *length, "a positive finite number");
  if(const std::optional<double> radius = options.support_strategy.support_radius())
    if(!(*radius > 0))
      return wrong_parameter("the radius of support_strategy", *radius, "positive");
  return {};
}

#ifdef CGAL_EIGEN3_ENABLED
typedef Eigen_frame_field_solver_traits Default_solver_traits;
#else
typedef CGAL::Default Default_solver_traits;
#endif

// A solver traits class as it is; the type of a solver of CGAL or of the same interface wrapped into one.
template <typename SolverTraits, typename = void>
struct Solver_traits_selector
{
  static_assert(!std::is_same<SolverTraits, CGAL::Default>::value,
                "Without Eigen (CGAL_EIGEN3_ENABLED) the named parameter sparse_linear_solver must be given.");
  typedef Linear_algebra_frame_field_solver_traits<SolverTraits> type;
};

template <typename SolverTraits>
struct Solver_traits_selector<SolverTraits, std::void_t<typename SolverTraits::Real_solver> >
{
  typedef SolverTraits type;
};

// The solver traits that the caller gave, or else those of Eigen.
template <typename NamedParameters>
struct Solver_traits_from
{
  typedef typename CGAL::internal_np::Lookup_named_param_def<
    CGAL::internal_np::sparse_linear_solver_t, NamedParameters, Default_solver_traits>::type Given_traits;
  typedef typename Solver_traits_selector<Given_traits>::type type;

  static type get(const NamedParameters& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    return type(choose_parameter<Given_traits>(get_parameter(np, CGAL::internal_np::sparse_linear_solver)));
  }
};

// The tag that the caller gave, but `Sequential_tag` for solvers that share state: these must not run at the same time.
template <typename NamedParameters>
struct Concurrency_from
{
  typedef typename std::conditional<Solver_traits_from<NamedParameters>::type::Has_independent_solvers::value,
                                    typename Given_concurrency<NamedParameters>::type,
                                    CGAL::Sequential_tag>::type type;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_NAMED_PARAMETERS_OPTIONS_H
