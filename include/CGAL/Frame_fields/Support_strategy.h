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

#ifndef CGAL_FRAME_FIELDS_SUPPORT_STRATEGY_H
#define CGAL_FRAME_FIELDS_SUPPORT_STRATEGY_H

#include <optional>

/// \file Support_strategy.h

namespace CGAL {
namespace Frame_fields {

/// \ingroup PkgFrame_fieldsRef
///
/// tells where the rotation prescribed at a sharp corner is compensated (Section 3.2 of \cgalCite{cgal:dprcs-ffcm-22}).
///
/// The prescribed rotations of a patch sum to zero, so what a sharp corner \f$ v \f$ gets, \f$ \theta_v - \pi/2 \f$,
/// must be taken from other sectors, the *receivers* of the corner. With `rings()`, `component()` and `radius()` the
/// receivers are never sharp corners themselves, so that each sharp corner keeps exactly what it got.
class Support_strategy
{
public:
  /// lists the strategies.
  enum Kind
  {
    NONE,      ///< see `none()`
    LOCAL,     ///< see `local()`
    RINGS,     ///< see `rings()`
    COMPONENT, ///< see `component()`
    RADIUS     ///< see `radius()`
  };

  /// prescribes no rotation: the classical smoothest field.
  static Support_strategy none() { return Support_strategy(NONE); }

  /// shares the rotation evenly among the dual edges of the sharp corner, so that the other ends of these edges are
  /// the receivers. Where two sharp corners share an edge, their shares add up on it. No linear system is solved.
  static Support_strategy local() { return Support_strategy(LOCAL); }

  /// takes the rotation in equal parts from the sectors that are reached from the corner along at most
  /// `number_of_rings` edges of the patch and are not sharp corners; if there is none among them, from those in the
  /// nearest ring that has any.
  static Support_strategy rings(const unsigned int number_of_rings)
  {
    return Support_strategy(RINGS, number_of_rings);
  }

  /// takes the rotation of all sharp corners of the patch in equal parts from all its other sectors.
  static Support_strategy component() { return Support_strategy(COMPONENT); }

  /// takes the rotation from what lies within the geodesic distance `radius` of the corner in its patch, evenly over
  /// its area: each sector that is not a sharp corner gives in proportion to the integral of its hat function, which
  /// is 1 at the sector and 0 at all others, over the part within the distance. If there is no such sector, the
  /// nearest one gives all. What comes out depends little on the mesh, in particular with the weights
  /// `Edge_weighting::PRIMAL_OVER_DUAL_LENGTH`.
  ///
  /// \param radius a length of the mesh, positive
  static Support_strategy radius(const double radius) { return Support_strategy(RADIUS, 0, radius); }

  /// is the same with a radius for each corner: half the length of the shorter one of the two constrained curves that
  /// leave the corner, up to the next sector of less than \f$ 3\pi/4 \f$ or more than \f$ 5\pi/4 \f$, but not beyond
  /// the distance \f$ r \f$ up to which the patch fills at least 0.8 of the wedge \f$ \theta r^2 / 2 \f$.
  static Support_strategy radius() { return Support_strategy(RADIUS); }

  /// returns the kind of the strategy.
  Kind kind() const { return m_kind; }

  /// returns the number of rings; 0 if the kind is not `RINGS`.
  unsigned int number_of_rings() const { return m_number_of_rings; }

  /// returns the radius, if the kind is `RADIUS` and one was given.
  std::optional<double> support_radius() const { return m_radius; }

private:
  explicit Support_strategy(const Kind kind, const unsigned int number_of_rings = 0,
                            const std::optional<double>& radius = std::nullopt)
    : m_kind(kind), m_number_of_rings(number_of_rings), m_radius(radius)
  {}

  Kind m_kind;
  unsigned int m_number_of_rings;
  std::optional<double> m_radius;
};

} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_SUPPORT_STRATEGY_H
