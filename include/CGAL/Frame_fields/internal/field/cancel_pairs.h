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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_CANCEL_PAIRS_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_CANCEL_PAIRS_H

#include <CGAL/Frame_fields/internal/field/field_of_matching.h>
#include <CGAL/Frame_fields/internal/matching/meshable_matching.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Cancels pairs of a positive and a negative index in a patch whose natural indices are 0, where that lowers the cost:
// sum w (r - omega)^2 plus a price for each index of 1/4. A quadrangle mesh pays such an index with an irregular
// vertex. The price is the least energy of an index of 1/4 in the ring of a vertex of six faces: six times the square
// of pi / 12. There is no price if a rotation is prescribed, which may ask for singularities. Keeps the field smoothed.
//
// Each trial moves the indices of a batch of positive sectors to the negative sectors that are cheapest to reach, and
// smooths the field with this matching; a trial that does not lower the cost is undone. The size of a batch is halved
// after each round. There are 64 trials at most, so many pairs are tried in groups only. A trial takes one pass over
// the patch for each sector of the batch, besides the searches and a solution.
template <typename SolverTraits>
class Pair_cancellation
{
public:
  Pair_cancellation(const Cut_surface& surface, const Patch& patch, const std::vector<double>& omega,
                    Field_of_matching<SolverTraits>& smoother, const bool has_prescribed_rotation,
                    Matched_field& field, double& energy)
    : m_surface(surface), m_patch(patch), m_omega(omega), m_smoother(smoother)
    , m_price_of_index(has_prescribed_rotation ? 0 : CGAL_PI * CGAL_PI / 24), m_field(field), m_energy(energy)
  {}

  void run()
  {
    const int maximum_number_of_trials = 64;
    int number_of_trials = 0;
    for(std::size_t size = positive_sectors().size(); size > 0; size /= 2)
    {
      const std::vector<int> sectors = positive_sectors();
      for(std::size_t k = 0; k < sectors.size() && has_negative_sector(); k += size)
      {
        if(number_of_trials++ == maximum_number_of_trials)
          return;
        const std::size_t end = (std::min)(k + size, sectors.size());
        try_to_cancel(std::vector<int>(sectors.begin() + k, sectors.begin() + end));
      }
    }
  }

private:
  std::vector<int> positive_sectors() const
  {
    std::vector<int> result;
    for(int s = m_patch.sectors.begin_index; s < m_patch.sectors.end_index; ++s)
      if(m_field.index[s] > 0)
        result.push_back(s);
    return result;
  }

  bool has_negative_sector() const
  {
    return std::any_of(m_field.index.begin() + m_patch.sectors.begin_index,
                       m_field.index.begin() + m_patch.sectors.end_index, [](const int index) { return index < 0; });
  }

  void try_to_cancel(const std::vector<int>& sectors)
  {
    const double old_cost = m_energy + m_price_of_index * m_field.sum_of_absolute_indices();
    const Matched_field::State old_state = m_field.state();
    Meshable_matching matching(m_surface, m_patch, m_omega, m_field.alpha, m_field.matching, m_field.index);
    for(const int s : sectors)
      matching.cancel_with_negative(s);
    double energy;
    if(m_smoother.smooth(m_field.matching, m_field.alpha, energy)
       && energy + m_price_of_index * m_field.sum_of_absolute_indices() < old_cost)
      m_energy = energy;
    else
      m_field.restore(old_state);
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<double>& m_omega;
  Field_of_matching<SolverTraits>& m_smoother;
  const double m_price_of_index;
  Matched_field& m_field;
  double& m_energy;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_CANCEL_PAIRS_H
