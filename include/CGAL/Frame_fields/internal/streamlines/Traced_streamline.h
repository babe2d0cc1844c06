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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_TRACED_STREAMLINE_H
#define CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_TRACED_STREAMLINE_H

#include <CGAL/Frame_fields/internal/streamlines/Face_neighborhood.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_tracer.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A streamline from its first point to its last.
struct Traced_streamline
{
  std::vector<Streamline_piece> pieces;
  bool is_closed = false;
};

// A point of a face and a branch there.
struct Streamline_seed
{
  int face, branch;
  Corner_weights weights;
};

inline Chart_point chart_point(const Face_charts& charts, const Streamline_seed& seed)
{
  return { seed.face, seed.branch, charts.place(seed.face, seed.weights) };
}

inline Streamline_head head_at(const Streamline_seed& seed)
{
  return { Streamline_head::INSIDE, -1, seed.face, seed.branch, seed.weights };
}

// A part of the spacing that is far more than rounding errors and far less than the eye can see.
constexpr double relative_streamline_tolerance = 1e-6;

inline Streamline_piece reversed(const Streamline_piece& piece)
{
  return { piece.face, (piece.branch + 2) % 4, piece.to, piece.from, piece.length };
}

// The part of a piece up to `length` from its start; all of it if that is longer. The piece must not have length 0.
inline Streamline_piece first_part(const Streamline_piece& piece, const double length)
{
  const double t = (std::min)(1., length / piece.length);
  return { piece.face, piece.branch, piece.from, between(piece.from, piece.to, t), t * piece.length };
}

// A streamline while it is traced from its seed in one direction.
struct Growing_streamline
{
  std::vector<Streamline_piece> pieces;
  double length = 0;
  std::size_t number_of_settled_pieces = 0; // will not be cut off any more
  double settled_length = 0;

  void append(const Streamline_piece& piece)
  {
    pieces.push_back(piece);
    length += piece.length;
  }

  void cut(const double new_length)
  {
    while(!pieces.empty() && length - pieces.back().length >= new_length)
    {
      length -= pieces.back().length;
      pieces.pop_back();
    }
    if(!pieces.empty() && length > new_length)
      pieces.back() = first_part(pieces.back(), pieces.back().length - (length - new_length));
    length = (std::min)(length, new_length);
  }
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_STREAMLINES_TRACED_STREAMLINE_H
