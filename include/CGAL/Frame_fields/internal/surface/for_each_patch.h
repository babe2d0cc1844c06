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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FOR_EACH_PATCH_H
#define CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FOR_EACH_PATCH_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>

#include <CGAL/for_each.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The numbers of the patches, those with the most faces first.
inline std::vector<int> patches_by_decreasing_size(const Cut_surface& surface)
{
  std::vector<int> numbers(surface.patches.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const auto size = [&](const int patch) { return surface.patches[patch].faces.size(); };
  std::sort(numbers.begin(), numbers.end(), [&](const int a, const int b)
            { return size(a) > size(b) || (size(a) == size(b) && a < b); });
  return numbers;
}

// Calls `stage(patch_number)` for every patch, also after a failure, and returns the result of the failed patch with
// the smallest number, or success. Each call must write to its own patch only; then the output does not depend on the
// number of threads.
template <typename ConcurrencyTag, typename Stage>
Patch_result for_each_patch(const Cut_surface& surface, const Stage& stage)
{
  const std::vector<int> numbers = patches_by_decreasing_size(surface);
  std::vector<Patch_result> results(numbers.size());
  // Whichever thread is free takes the largest patch that is left, wherever its share of the range begins.
  std::atomic<std::size_t> next_place(0);
  CGAL::for_each<ConcurrencyTag>(numbers, [&](int) -> bool
  {
    const int patch = numbers[next_place++];
    results[patch] = stage(patch);
    return true;
  });
  for(const Patch_result& result : results)
    if(result.error_code != OK)
      return result;
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_SURFACE_FOR_EACH_PATCH_H
