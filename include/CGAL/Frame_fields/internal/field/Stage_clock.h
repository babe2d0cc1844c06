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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_STAGE_CLOCK_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_STAGE_CLOCK_H

#include <CGAL/Frame_fields/Statistics.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <chrono>
#include <functional>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Tells the visitor which stage starts and measures the stages.
template <typename NamedParameters>
class Stage_clock
{
public:
  explicit Stage_clock(const NamedParameters& np)
    : m_visitor(CGAL::parameters::choose_parameter<Visitor>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::visitor)))
    , m_start(Clock::now())
  {}

  void start(const Stage stage)
  {
    stop();
    m_stage = static_cast<int>(stage);
    unwrap(m_visitor).start_stage(stage);
    m_stage_start = Clock::now();
  }

  void stop()
  {
    if(m_stage >= 0)
      m_seconds[m_stage] += seconds_since(m_stage_start);
    m_stage = -1;
  }

  Stage_seconds seconds() const
  {
    return { seconds_of(Stage::CUT_SURFACE), seconds_of(Stage::PRESCRIBED_ROTATION),
             seconds_of(Stage::ORTHOGONAL_FIELD), seconds_of(Stage::MATCHING_AND_INDICES),
             seconds_of(Stage::RELAXATION), seconds_since(m_start) };
  }

private:
  typedef std::chrono::steady_clock Clock;
  typedef typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::visitor_t, NamedParameters,
                                                             Default_frame_field_visitor>::type Visitor;

  template <typename T>
  static T& unwrap(T& visitor) { return visitor; }
  template <typename T>
  static T& unwrap(std::reference_wrapper<T>& visitor) { return visitor.get(); }

  double seconds_of(const Stage stage) const { return m_seconds[static_cast<int>(stage)]; }

  static double seconds_since(const Clock::time_point start)
  {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  Visitor m_visitor;
  Clock::time_point m_start, m_stage_start;
  int m_stage = -1; // -1 between stages
  std::array<double, static_cast<int>(Stage::RELAXATION) + 1> m_seconds{};
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_STAGE_CLOCK_H
