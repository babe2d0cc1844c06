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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_UNTANGLE_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_UNTANGLE_QUADS_H

#include <CGAL/Frame_fields/internal/quads/Joint_descent.h>
#include <CGAL/Frame_fields/internal/quads/Sliding_quads.h>
#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/quads/tangled_parts.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Turns the quads of a part of a quad mesh right side up.
//
// It minimizes the sum of (|a|^2 + |b|^2) / (2 chi(a x b)) over the corners with sides a and b, where a x b is seen
// along the normal of the surface, and chi(t) = (t + sqrt(t^2 + e^2)) / 2 is positive also for inverted corners; e gets
// smaller with them. On the way a quad may get worse. In the end, all moves are undone unless fewer quads are inverted,
// or as many and the worst scaled Jacobian of the part is better.
class Untangled_part
{
public:
  // `epsilon` has room for a number per corner of all quads. `local` has an entry -1 per vertex of all quads.
  Untangled_part(Sliding_quads& quads, const std::vector<int>& part, const std::vector<int>& vertices,
                 std::vector<double>& epsilon, std::vector<int>& local)
    : m_quads(quads), m_part(part), m_vertices(vertices), m_epsilon(epsilon), m_local(local)
  {
    for(const int v : vertices)
      m_old_slide.push_back(quads.slide_of(v));
  }

  // Returns whether it has improved.
  bool run()
  {
    // Small parts get many rounds and steps; large ones are hopeless if a few do not mend them.
    const int number_of_vertices = static_cast<int>(m_vertices.size());
    const int number_of_rounds = number_of_vertices <= 10000 ? 10 : 2;
    const int number_of_steps = (std::min)(50, (std::max)(5, 50000 / (std::max)(1, number_of_vertices)));
    const std::pair<int, double> old_score = score();
    Joint_descent descent(m_quads, m_part, m_vertices, m_epsilon, m_local);
    std::pair<int, double> new_score = old_score;
    for(int round = 0; round < number_of_rounds && new_score.first > 0; ++round)
    {
      set_epsilons();
      if(!descent.run(number_of_steps))
        break;
      new_score = score();
      if(is_hopeless(old_score.first, new_score.first))
        break;
    }
    const bool is_better = new_score.first < old_score.first
                        || (new_score.first == old_score.first && new_score.second > old_score.second);
    if(!is_better)
      for(std::size_t i = 0; i < m_vertices.size(); ++i)
        m_quads.move(m_vertices[i], m_old_slide[i]);
    return is_better;
  }

private:
  // The number of inverted quads and the worst scaled Jacobian.
  std::pair<int, double> score() const
  {
    std::pair<int, double> result(0, 1);
    for(const int q : m_part)
    {
      result.first += m_quads.shape(q).scaled_jacobian <= 0;
      result.second = (std::min)(result.second, m_quads.shape(q).scaled_jacobian);
    }
    return result;
  }

  // In small parts, more quads may be inverted on the way to none. Large ones, which take the most time, do not recover
  // once a quarter more are.
  bool is_hopeless(const int old_number_of_inverted, const int number_of_inverted) const
  {
    const std::size_t least_number_of_vertices = 1000;
    return m_vertices.size() >= least_number_of_vertices && 4 * number_of_inverted > 5 * old_number_of_inverted;
  }

  // Each corner has its own scale, so that those with a short side count as well.
  void set_epsilons()
  {
    const double smallest_part = 1e-3, part = 0.2, part_of_diagonals = 1e-9; // where a side has no length
    for(const int q : m_part)
    {
      const Quad_points p = m_quads.points(q);
      const Coordinates normal = m_quads.unit_normal(q), c = p[2] - p[0], d = p[3] - p[1];
      for(int k = 0; k < 4; ++k)
      {
        const Coordinates a = p[(k + 1) % 4] - p[k], b = p[(k + 3) % 4] - p[k];
        m_epsilon[4 * static_cast<std::size_t>(q) + k] =
          std::hypot(smallest_part * std::sqrt(dot(a, a) * dot(b, b)),
                     part * (std::min)(0., dot(cross(a, b), normal)), part_of_diagonals * (dot(c, c) + dot(d, d)));
      }
    }
  }

  Sliding_quads& m_quads;
  const std::vector<int>& m_part;     // quads
  const std::vector<int>& m_vertices; // that may slide: all their quads are in the part
  std::vector<double>& m_epsilon;     // per corner
  std::vector<int>& m_local;          // for the descent
  std::vector<Slide> m_old_slide;     // per entry of m_vertices
};

// Untangles all parts with two rings around inverted quads, then those with five. Returns whether any part has
// improved.
inline bool untangle_quads(Sliding_quads& quads, const std::vector<char>& is_patch_left_out)
{
  bool has_improved = false;
  std::vector<double> epsilon(4 * static_cast<std::size_t>(quads.number_of_quads()));
  std::vector<int> local(quads.number_of_vertices(), -1);
  for(const int number_of_rings : { 2, 5 })
    for_each_tangled_part(quads, is_patch_left_out, number_of_rings,
                          [&](const std::vector<int>& part, const std::vector<int>& vertices)
    {
      has_improved |= Untangled_part(quads, part, vertices, epsilon, local).run();
    });
  return has_improved;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_UNTANGLE_QUADS_H
