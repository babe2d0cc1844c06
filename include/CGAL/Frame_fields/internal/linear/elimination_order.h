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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LINEAR_ELIMINATION_ORDER_H
#define CGAL_FRAME_FIELDS_INTERNAL_LINEAR_ELIMINATION_ORDER_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/assemble.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Whether a solver traits class is a model of `FrameFieldOrderingSolverTraits`.
template <typename SolverTraits, typename = void>
struct Chooses_elimination_order : std::false_type {};

template <typename SolverTraits>
struct Chooses_elimination_order<
  SolverTraits,
  std::void_t<decltype(std::declval<const SolverTraits&>().elimination_order(
    std::declval<const Hermitian_matrix<float>&>()))> > : std::true_type {};

// The numbers from 0 to `size` - 1 in increasing order.
inline std::vector<int> natural_order(const int size)
{
  std::vector<int> result(size);
  std::iota(result.begin(), result.end(), 0);
  return result;
}

// The numbers from 0 to `size` - 1 in the order in which unknowns should be eliminated; the natural order if the
// solvers find their own. `emit(add)` must call `add(i, j, 1.f)` once or more for every two unknowns i != j with an
// entry in the matrix.
template <typename SolverTraits, typename Emit>
std::vector<int> elimination_order(const int size, const Emit& emit, const SolverTraits& solver_traits)
{
  if constexpr(Chooses_elimination_order<SolverTraits>::value)
  {
    if(size > 0)
      return solver_traits.elimination_order(assemble<float>(size, emit));
  }
  return natural_order(size);
}

// The faces of a patch, by their numbers in the surface, in the order in which a system with an unknown in each face
// should number these.
template <typename SolverTraits>
std::vector<int> elimination_order_of_faces(const Cut_surface& surface, const Patch& patch,
                                            const SolverTraits& solver_traits)
{
  const int first = patch.faces.begin_index;
  const auto emit = [&](const auto& add)
  {
    for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    {
      const int i = face_of(surface.dual_edges[e].halfedge), j = face_of(surface.dual_edges[e].opposite);
      if(i != j)
        add(i - first, j - first, 1.f);
    }
  };
  std::vector<int> faces = elimination_order(patch.faces.size(), emit, solver_traits);
  for(int& face : faces)
    face += first;
  return faces;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LINEAR_ELIMINATION_ORDER_H
