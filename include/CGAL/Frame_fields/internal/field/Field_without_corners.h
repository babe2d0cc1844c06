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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_FIELD_WITHOUT_CORNERS_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_FIELD_WITHOUT_CORNERS_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/field/cancel_pairs.h>
#include <CGAL/Frame_fields/internal/field/energies.h>
#include <CGAL/Frame_fields/internal/field/field_of_matching.h>
#include <CGAL/Frame_fields/internal/field/orthogonal_field.h>
#include <CGAL/Frame_fields/internal/field/prescribed_rotation.h>
#include <CGAL/Frame_fields/internal/linear/smallest_eigenvector.h>
#include <CGAL/Frame_fields/internal/matching/matching_and_indices.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <complex>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Whether a patch is a ring between two closed curves without corners, and no face has a guiding weight. The field of
// such a patch needs no singularities. Faces aligned by an infinite guiding weight are not looked for: they stay
// aligned.
inline bool is_ring_without_corners(const Cut_surface& surface, const Patch& patch)
{
  if(euler_characteristic(patch) != 0)
    return false;
  bool has_border = false;
  for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
  {
    if(natural_index(surface, s) != 0)
      return false;
    has_border = has_border || surface.is_constrained_sector(s);
  }
  return has_border && (surface.guide_weight.empty()
                        || std::all_of(surface.guide_weight.begin() + patch.faces.begin_index,
                                       surface.guide_weight.begin() + patch.faces.end_index,
                                       [](const double weight) { return weight == 0; }));
}

// Whether `Field_without_corners` can improve the field of a patch: it has no index targets, and no face asks for a
// direction or it is a ring without corners.
inline bool is_patch_without_corners(const Cut_surface& surface, const Patch& patch)
{
  return !has_index_targets(surface, patch)
      && (!asks_for_direction(surface, patch) || is_ring_without_corners(surface, patch));
}

// Arrays for the fields of patches without corners. Each patch has its part of them.
struct Arrays_without_corners
{
  std::vector<double> omega, demand;
  std::vector<int> matching, index;
};

// Lowers sum w (r - omega)^2 of the field of a patch without corners by discrete changes, which no continuous flow of
// the field makes. Singularities of opposite signs are cancelled where that pays. Along a handle the field turns by
// some multiple of a quarter turn; the least rotation that gives all sectors their indices tells by which. The field of
// a torus or of a ring may need no singularities at all. The field of a ring that has none is left as it is.
template <typename SolverTraits>
class Field_without_corners
{
public:
  Field_without_corners(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                     const std::vector<int>& face_order, const SolverTraits& solver_traits,
                     Arrays_without_corners& arrays, std::vector<double>& alpha)
    : m_surface(surface), m_patch(patch), m_omega(omega), m_face_order(face_order), m_solver_traits(solver_traits)
    , m_arrays(arrays), m_field(patch, alpha, arrays.matching, arrays.index)
  {}

  Patch_result improve()
  {
    match_patch(m_surface, m_patch, m_omega, m_field.alpha, m_field.matching);
    const Patch_result result = indices_in_patch(m_surface, m_patch, m_field.alpha, m_field.matching, m_field.index);
    if(result.error_code != OK)
      return result;
    if(!asks_for_direction(m_surface, m_patch))
      improve_closed_patch();
    else if(has_singularity())
      improve_ring();
    return {};
  }

private:
  typedef Field_of_matching<SolverTraits> Smoother;

  void improve_closed_patch()
  {
    const int characteristic = euler_characteristic(m_patch);
    if(characteristic > 0 && !has_index([](const int index) { return index < 0; }))
      return;
    Smoother smoother(m_surface, m_patch, m_omega, m_face_order, m_solver_traits);
    smooth_with(smoother);
    Pair_cancellation<SolverTraits>(m_surface, m_patch, m_omega, smoother, has_prescribed_rotation(), m_field,
                                    m_energy).run();
    if(characteristic > 0 || has_prescribed_rotation())
      return;
    try_indices(index_in_patch(m_patch, m_field.index), smoother, m_energy);
    if(characteristic == 0)
      try_without_singularities(smoother);
  }

  // A ring that cannot do without singularities keeps its field.
  void improve_ring()
  {
    const Matched_field::State start = m_field.state();
    Smoother smoother(m_surface, m_patch, m_omega, m_face_order, m_solver_traits);
    smooth_with(smoother);
    try_without_singularities(smoother);
    if(has_singularity())
      m_field.restore(start);
  }

  // Smooths the field where that keeps the matching the nearest one, and sets its energy.
  void smooth_with(Smoother& smoother)
  {
    const Matched_field::State start = m_field.state();
    if(!smoother.smooth(m_field.matching, m_field.alpha, m_energy))
    {
      m_field.restore(start);
      m_energy = orthogonal_energy(m_surface, m_patch.dual_edges, m_omega, m_field.alpha, m_field.matching);
    }
  }

  bool has_singularity() const
  {
    return has_index([](const int index) { return index != 0; });
  }

  template <typename Predicate>
  bool has_index(const Predicate& predicate) const
  {
    return std::any_of(m_field.index.begin() + m_patch.sectors.begin_index,
                       m_field.index.begin() + m_patch.sectors.end_index, predicate);
  }

  bool has_prescribed_rotation() const
  {
    return std::any_of(m_omega.begin() + m_patch.dual_edges.begin_index,
                       m_omega.begin() + m_patch.dual_edges.end_index, [](const double omega) { return omega != 0; });
  }

  // Tries a field without singularities. In a closed patch its energy may be higher by a price for each index of 1/4
  // that vanishes. The price is the energy of a quarter turn over two edges. These are the fewest that it can be spread
  // over, since a nearest matching leaves at most an eighth of a turn across an edge. Without the price, coarse or very
  // long faces would keep pairs of singularities, which flatten the field around them. There is no price if a rotation
  // is prescribed, which may ask for singularities, nor on a ring, whose borders hold the field.
  void try_without_singularities(Smoother& smoother)
  {
    const bool has_price = !has_prescribed_rotation() && !asks_for_direction(m_surface, m_patch);
    const double price_of_index = has_price ? 2 * (CGAL_PI / 4) * (CGAL_PI / 4) : 0;
    try_indices(std::vector<int>(m_patch.sectors.size(), 0), smoother,
                m_energy + price_of_index * m_field.sum_of_absolute_indices());
  }

  // Computes the field with these indices (4 I per sector of the patch), smooths it, and keeps it if its energy is
  // below the bound. Otherwise the field is left as it was.
  void try_indices(const std::vector<int>& index, Smoother& smoother, const double bound)
  {
    const Matched_field::State old_state = m_field.state();
    double energy;
    if(has_field_with(index) && smoother.smooth(m_field.matching, m_field.alpha, energy) && energy < bound)
      m_energy = energy;
    else
      m_field.restore(old_state);
  }

  // Sets the smoothest field with respect to the least rotation that gives the sectors these indices. The rotation
  // fixes all but the turns along the handles, or across the ring. Returns whether the field has the indices.
  bool has_field_with(const std::vector<int>& index)
  {
    for(int s = m_patch.sectors.begin_index; s < m_patch.sectors.end_index; ++s)
      m_arrays.demand[s] = demand_of_index(m_surface, s, index[s - m_patch.sectors.begin_index]);
    if(!least_norm_rotation(m_surface, m_patch, m_arrays.demand, m_solver_traits, m_arrays.omega))
      return false;
    const Orthogonal_field_system system(m_surface, m_patch, m_arrays.omega, m_face_order);
    auto solver = m_solver_traits.complex_solver_object();
    std::vector<std::complex<double> > z;
    std::vector<int> level;
    if(!(system.is_anchored() ? solve_orthogonal_field(solver, system, z, level)
                              : smallest_eigenvector(solver, system.matrix(), system.start_vector(), z)))
      return false;
    write_alpha(m_surface, m_patch, system, z, m_field.alpha);
    match_patch(m_surface, m_patch, m_arrays.omega, m_field.alpha, m_field.matching);
    return indices_in_patch(m_surface, m_patch, m_field.alpha, m_field.matching, m_field.index).error_code == OK
        && index_in_patch(m_patch, m_field.index) == index;
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_omega;
  const std::vector<int>& m_face_order;
  const SolverTraits& m_solver_traits;
  Arrays_without_corners& m_arrays;
  Matched_field m_field;
  double m_energy = 0; // sum w (r - omega)^2
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_FIELD_WITHOUT_CORNERS_H
