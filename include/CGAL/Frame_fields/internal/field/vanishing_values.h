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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_FIELD_VANISHING_VALUES_H
#define CGAL_FRAME_FIELDS_INTERNAL_FIELD_VANISHING_VALUES_H

#include <CGAL/Frame_fields/internal/field/falling_values.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/weights.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

typedef std::complex<double> Complex;

// The values around a face cancel out if the norm of their mean is at most this part of the mean of their norms. The
// rounding errors of solvers, direct or iterative, are smaller still.
constexpr double largest_vanishing_ratio = 1e-6;

// Says that the values of two neighboring faces fulfil z(to) = factor * z(from) if the field does not rotate in
// between.
struct Vanishing_value_link
{
  int from, to;
  Complex factor;

  bool operator<(const Vanishing_value_link& other) const { return from < other.from; }
};

// The sum of the fourth powers of the edge vectors of a face, as complex numbers in the unit of its circumdiameter.
inline Complex mean_edge_value(const Cut_surface& surface, const int face)
{
  Complex sum(0);
  for(int h = 3 * face; h < 3 * face + 3; ++h)
    sum += std::polar(std::pow(std::sin(surface.angle[next_of(h)]), 4), 4 * halfedge_angle(surface, h));
  return sum;
}

// Replaces the values of a field that vanish in faces of a patch. Where the values around a face cancel out, every
// direction costs the same, and the rounding errors of the solver would choose one. Such a face takes the mean
// direction of its edges instead, and a connected group of such faces that of all its edges. In general this depends
// neither on the solver nor on the numbers of the faces. There are two exceptions: an equilateral face has no mean
// direction, and in a group that closes up around a vertex the direction depends on the order in which its faces are
// reached.
template <typename Field_system>
class Field_without_zeros
{
public:
  // `z` are the values of the unknowns of `system`, `level` is as in `Falling_values`.
  Field_without_zeros(const Cut_surface& surface, const Patch& patch, const Field_system& system,
                      const std::vector<int>& level, std::vector<Complex>& z)
    : m_surface(surface), m_patch(patch), m_system(system), m_level(level), m_z(z)
  {}

  void replace_vanishing_values()
  {
    if(!has_small_value())
      return;
    mark_vanishing_values();
    collect_links();
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
      if(is_vanishing(f))
        replace_group(f);
  }

private:
  bool has_small_value() const
  {
    double smallest = HUGE_VAL, largest = 0;
    for(const Complex& value : m_z)
    {
      smallest = (std::min)(smallest, std::norm(value));
      largest = (std::max)(largest, std::norm(value));
    }
    if(m_system.is_anchored())
      largest = (std::max)(largest, 1.); // the norm of aligned values and of guides
    return smallest <= largest_vanishing_ratio * largest_vanishing_ratio * largest;
  }

  int level_in(const int face) const
  {
    return m_level.empty() || m_system.unknown(face) < 0 ? 0 : m_level[m_system.unknown(face)];
  }

  double norm_in(const int face, const int level) const
  {
    const Complex value = m_system.unknown(face) < 0 ? Complex(1) : m_z[m_system.unknown(face)];
    return norm_at_level(value, level_in(face), level);
  }

  void mark_vanishing_values()
  {
    std::vector<double> weight(m_patch.faces.size()), norm(m_patch.faces.size());
    const auto add = [&](const int face, const double w, const double n)
    {
      if(w == 0) // n may be infinite
        return;
      weight[face - m_patch.faces.begin_index] += w;
      norm[face - m_patch.faces.begin_index] += w * n;
    };
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
    {
      const auto [halfedge, opposite] = m_surface.dual_edges[e];
      const int i = face_of(halfedge), j = face_of(opposite);
      add(i, m_surface.weight[e], norm_in(j, level_in(i)));
      add(j, m_surface.weight[e], norm_in(i, level_in(j)));
    }
    m_is_vanishing.assign(m_patch.faces.size(), false);
    for(int f = m_patch.faces.begin_index; f < m_patch.faces.end_index; ++f)
    {
      const int i = f - m_patch.faces.begin_index;
      add(f, guide_weight(m_surface, f), norm_at_level(1, 0, level_in(f)));
      m_is_vanishing[i] = m_system.unknown(f) >= 0
                          && norm_in(f, level_in(f)) * weight[i] <= largest_vanishing_ratio * norm[i];
    }
  }

  void collect_links()
  {
    for(int e = m_patch.dual_edges.begin_index; e < m_patch.dual_edges.end_index; ++e)
    {
      const int i = face_of(m_surface.dual_edges[e].halfedge), j = face_of(m_surface.dual_edges[e].opposite);
      if(i != j && is_vanishing(i) && is_vanishing(j))
      {
        m_links.push_back({ j, i, m_system.transport(e) });
        m_links.push_back({ i, j, std::conj(m_system.transport(e)) });
      }
    }
    std::stable_sort(m_links.begin(), m_links.end()); // the order tells in which order values are summed up
  }

  // Replaces the values of the faces that are linked with the given one.
  void replace_group(const int first_face)
  {
    std::vector<Vanishing_value_link> group{ { first_face, first_face, Complex(1) } };
    m_is_vanishing[first_face - m_patch.faces.begin_index] = false;
    Complex sum(0);
    for(std::size_t k = 0; k < group.size(); ++k)
    {
      const auto [root, face, factor] = group[k];
      sum += std::conj(factor) * mean_edge_value(m_surface, face);
      const Vanishing_value_link from_face = { face, face, {} };
      const auto [begin, end] = std::equal_range(m_links.begin(), m_links.end(), from_face);
      for(auto link = begin; link != end; ++link)
        if(is_vanishing(link->to))
        {
          m_is_vanishing[link->to - m_patch.faces.begin_index] = false;
          group.push_back({ root, link->to, link->factor * factor });
        }
    }
    for(const Vanishing_value_link& link : group)
      m_z[m_system.unknown(link.to)] = link.factor * sum;
  }

  bool is_vanishing(const int face) const { return m_is_vanishing[face - m_patch.faces.begin_index]; }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const Field_system& m_system;
  const std::vector<int>& m_level;
  std::vector<Complex>& m_z;
  std::vector<bool> m_is_vanishing; // per face of the patch
  std::vector<Vanishing_value_link> m_links;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_FIELD_VANISHING_VALUES_H
