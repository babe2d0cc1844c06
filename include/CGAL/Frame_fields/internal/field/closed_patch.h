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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_CLOSED_PATCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_CLOSED_PATCH_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/cancel_pairs.h>
#include <CGAL/Frame_fields/internal/field/field_of_matching.h>
#include <CGAL/Frame_fields/internal/field/orthogonal_field.h>
#include <CGAL/Frame_fields/internal/field/prescribed_rotation.h>
#include <CGAL/Frame_fields/internal/linear/smallest_eigenvector.h>
#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <complex>
#include <limits>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Arrays for the fields of patches that ask for no direction. Each patch has its part of them.
struct Closed_patch_arrays
{
  std::vector<double> omega, demand;
  std::vector<int> matching, index;
};

// Lowers sum w (r - omega)^2 of the field of a patch without constrained edges, in steps that no flow of the field
// takes. Singularities of opposite signs cancel where that pays. Along a handle a field turns by some multiple of a
// quarter turn; the least rotation that gives all sectors their indices shows by which. A surface of one handle may do
// without singularities at all.
template <typename SolverTraits>
class Closed_patch_field
{
public:
  Closed_patch_field(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                     const std::vector<int>& face_order, const SolverTraits& solver_traits,
                     Closed_patch_arrays& arrays, std::vector<double>& alpha)
    : m_surface(surface), m_patch(patch), m_omega(omega), m_face_order(face_order), m_solver_traits(solver_traits)
    , m_arrays(arrays), m_field(patch, alpha, arrays.matching, arrays.index)
  {}

  Patch_result improve()
  {
    match_patch(m_surface, m_patch, m_omega, m_field.alpha, m_field.matching);
    const Patch_result result = indices_in_patch(m_surface, m_patch, m_field.alpha, m_field.matching, m_field.index);
    const int characteristic = euler_characteristic(m_patch);
    if(result.error_code != OK || (characteristic > 0 && !has_index([](const int index) { return index < 0; })))
      return result;

    Smoother smoother(m_surface, m_patch, m_omega, m_face_order, m_solver_traits);
    const Matched_field::State start = m_field.state();
    if(!smoother.smooth(m_field.matching, m_field.alpha, m_energy))
      m_field.restore(start);
    Pair_cancellation<SolverTraits>(m_surface, m_patch, m_omega, smoother, m_field, m_energy).run();
    if(characteristic > 0 || !is_without_prescribed_rotation())
      return {};
    try_indices(index_in_patch(m_patch, m_field.index), smoother);
    if(characteristic == 0)
      try_indices(std::vector<int>(m_patch.sectors.size(), 0), smoother);
    return {};
  }

private:
  typedef Field_of_matching<SolverTraits> Smoother;

  template <typename Predicate>
  bool has_index(const Predicate& predicate) const
  {
    return std::any_of(m_field.index.begin() + m_patch.sectors.begin_index,
                       m_field.index.begin() + m_patch.sectors.end_index, predicate);
  }

  bool is_without_prescribed_rotation() const
  {
    return std::all_of(m_omega.begin() + m_patch.dual_edges.begin_index,
                       m_omega.begin() + m_patch.dual_edges.end_index, [](const double omega) { return omega == 0; });
  }

  // Takes the field with these indices and the least rotation if its energy is smaller.
  void try_indices(const std::vector<int>& index, Smoother& smoother)
  {
    const Matched_field::State old_state = m_field.state();
    double energy;
    if(has_field_with(index) && smoother.smooth(m_field.matching, m_field.alpha, energy) && energy < m_energy)
      m_energy = energy;
    else
      m_field.restore(old_state);
  }

  // With such a rotation prescribed, only the turns along the handles are left to be found.
  bool has_field_with(const std::vector<int>& index)
  {
    for(int s = m_patch.sectors.begin_index; s < m_patch.sectors.end_index; ++s)
    {
      const double turns = index[s - m_patch.sectors.begin_index] / 4. - 1;
      m_arrays.demand[s] = m_surface.total_angle[s] + 2 * CGAL_PI * turns;
    }
    if(!least_norm_rotation(m_surface, m_patch, m_arrays.demand, m_solver_traits, m_arrays.omega))
      return false;
    const Orthogonal_field_system system(m_surface, m_patch, m_arrays.omega, m_face_order);
    auto solver = m_solver_traits.complex_solver_object();
    std::vector<std::complex<double> > z;
    if(!smallest_eigenvector(solver, system.matrix(), system.start_vector(), z))
      return false;
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      m_field.alpha[f] = std::arg(z[system.unknown(f)]) / 4;
    match_patch(m_surface, m_patch, m_arrays.omega, m_field.alpha, m_field.matching);
    return indices_in_patch(m_surface, m_patch, m_field.alpha, m_field.matching, m_field.index).error_code == OK
        && index_in_patch(m_patch, m_field.index) == index;
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_omega;
  const std::vector<int>& m_face_order;
  const SolverTraits& m_solver_traits;
  Closed_patch_arrays& m_arrays;
  Matched_field m_field;
  double m_energy = std::numeric_limits<double>::infinity();
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_CLOSED_PATCH_H
