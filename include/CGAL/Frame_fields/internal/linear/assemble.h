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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LINEAR_ASSEMBLE_H
#define CGAL_FRAME_FIELDS_INTERNAL_LINEAR_ASSEMBLE_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/conjugate.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Counts the entries below the diagonal of each column.
struct Entry_counter
{
  std::vector<int>& column_size;

  template <typename Scalar>
  void operator()(const int i, const int j, const Scalar&) const
  {
    if(i != j)
      ++column_size[(std::min)(i, j)];
  }
};

// Puts each entry at the next free place of its column of the lower triangle, and adds those of the diagonal up.
template <typename Scalar>
struct Entry_writer
{
  Hermitian_matrix<Scalar>& matrix;
  std::vector<int>& next_place;

  void operator()(const int i, const int j, const Scalar& a_ij) const
  {
    if(i == j)
    {
      matrix.value[matrix.column_begin[i]] += a_ij;
      return;
    }
    const int place = next_place[(std::min)(i, j)]++;
    matrix.row[place] = (std::max)(i, j);
    matrix.value[place] = (i > j) ? a_ij : conjugate(a_ij);
  }
};

// Sorts a column by rows, and keeps entries of equal rows in their order, so that their sum does not depend on the
// sort.
template <typename Scalar>
void sort_column(int* const row, Scalar* const value, const int size)
{
  const int largest_handful = 64;
  if(size > largest_handful)
  {
    std::vector<std::pair<int, Scalar> > entries(size);
    for(int k = 0; k < size; ++k)
      entries[k] = { row[k], value[k] };
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for(int k = 0; k < size; ++k)
    {
      row[k] = entries[k].first;
      value[k] = entries[k].second;
    }
    return;
  }
  for(int k = 1; k < size; ++k) // most columns hold a handful of entries
    for(int l = k; l > 0 && row[l - 1] > row[l]; --l)
    {
      std::swap(row[l - 1], row[l]);
      std::swap(value[l - 1], value[l]);
    }
}

// Sorts one column by rows and adds up the entries of equal rows; returns the number of entries that are left.
template <typename Scalar>
int sort_and_merge_column(int* const row, Scalar* const value, const int size)
{
  sort_column(row, value, size);
  int kept = 0;
  for(int k = 0; k < size; ++k)
  {
    if(kept > 0 && row[kept - 1] == row[k])
    {
      value[kept - 1] += value[k];
      continue;
    }
    row[kept] = row[k];
    value[kept] = value[k];
    ++kept;
  }
  return kept;
}

// Assembles a hermitian matrix with `size` columns. `emit(sink)` is called twice and must call `sink(i, j, a_ij)` for
// the same positions both times. Each contribution to an entry off the diagonal is given once, for (i, j) or for (j,
// i), and stands for both. Contributions to the same entry add up. Every column gets a diagonal entry, 0 if none is
// given. The number of calls plus `size` must fit into `int`. Takes O(n log n) time for n calls.
template <typename Scalar, typename Emit>
Hermitian_matrix<Scalar> assemble(const int size, const Emit& emit)
{
  std::vector<int> column_size(size, 1);
  emit(Entry_counter{column_size});

  Hermitian_matrix<Scalar> matrix;
  matrix.column_begin.resize(static_cast<std::size_t>(size) + 1, 0);
  std::vector<int> next_place(size);
  for(int j = 0; j < size; ++j)
  {
    matrix.column_begin[j + 1] = matrix.column_begin[j] + column_size[j];
    next_place[j] = matrix.column_begin[j] + 1;
  }
  matrix.row.resize(matrix.column_begin[size]);
  matrix.value.resize(matrix.column_begin[size], Scalar(0));
  for(int j = 0; j < size; ++j)
    matrix.row[matrix.column_begin[j]] = j;

  emit(Entry_writer<Scalar>{matrix, next_place});

  int end = 0;
  for(int j = 0; j < size; ++j)
  {
    const int begin = matrix.column_begin[j];
    const int kept = sort_and_merge_column(&matrix.row[begin], &matrix.value[begin], column_size[j]);
    if(begin != end) // nothing moves until two entries have met
    {
      std::copy_n(matrix.row.begin() + begin, kept, matrix.row.begin() + end);
      std::copy_n(matrix.value.begin() + begin, kept, matrix.value.begin() + end);
    }
    matrix.column_begin[j] = end;
    end += kept;
  }
  matrix.column_begin[size] = end;
  matrix.row.resize(end);
  matrix.value.resize(end);
  return matrix;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LINEAR_ASSEMBLE_H
