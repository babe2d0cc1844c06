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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_STAGE_CLOCK_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_STAGE_CLOCK_H

#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/Statistics.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <chrono>
#include <functional>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Measures the stages of the quad mesh. The stages on arrays know it without the type of the visitor, so that they are
// the same functions for all visitors.
class Quad_stage_timer
{
public:
  virtual ~Quad_stage_timer() = default;

  void start(const Quad_stage stage)
  {
    stop();
    m_stage = static_cast<int>(stage);
    tell(stage);
    m_stage_start = Clock::now();
  }

  void start(const Stage stage) { tell(stage); }

  void stop()
  {
    if(m_stage >= 0)
      m_seconds[m_stage] += seconds_since(m_stage_start);
    m_stage = -1;
  }

  Quad_stage_seconds seconds() const
  {
    return { m_seconds[0], m_seconds[1], m_seconds[2], m_seconds[3], m_seconds[4], m_seconds[5], m_seconds[6],
             seconds_since(m_start) };
  }

private:
  typedef std::chrono::steady_clock Clock;

  virtual void tell(Quad_stage) = 0;
  virtual void tell(Stage) = 0;

  static double seconds_since(const Clock::time_point start)
  {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  Clock::time_point m_start = Clock::now(), m_stage_start;
  int m_stage = -1; // -1 between stages
  std::array<double, static_cast<int>(Quad_stage::SMOOTHING) + 1> m_seconds{};
};

// Tells the visitor which stage starts, also inside the field.
template <typename NamedParameters>
class Quad_stage_clock : public Quad_stage_timer
{
public:
  explicit Quad_stage_clock(const NamedParameters& np)
    : m_visitor(CGAL::parameters::choose_parameter<Visitor>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::visitor)))
  {}

private:
  typedef typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::visitor_t, NamedParameters,
                                                             Default_quad_mesh_visitor>::type Visitor;

  void tell(const Quad_stage stage) override { unwrap(m_visitor).start_stage(stage); }
  void tell(const Stage stage) override { unwrap(m_visitor).start_stage(stage); }

  template <typename T>
  static T& unwrap(T& visitor) { return visitor; }
  template <typename T>
  static T& unwrap(std::reference_wrapper<T>& visitor) { return visitor.get(); }

  Visitor m_visitor;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_STAGE_CLOCK_H
