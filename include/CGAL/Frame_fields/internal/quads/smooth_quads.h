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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_SMOOTH_QUADS_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_SMOOTH_QUADS_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Sliding_quads.h>
#include <CGAL/Frame_fields/internal/quads/improve_worst_quads.h>
#include <CGAL/Frame_fields/internal/quads/quad_shape.h>
#include <CGAL/Frame_fields/internal/quads/sliding_step.h>
#include <CGAL/Frame_fields/internal/quads/tangled_parts.h>
#include <CGAL/Frame_fields/internal/quads/untangle_quads.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Patch_result.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/internal/surface/for_each_patch.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

struct Smoothing_options
{
  int number_of_sweeps = 40;                // of all vertices by the distortion
  int number_of_rounds = 3;                 // of the search at bad quads, each followed by half as many sweeps
  bool untangles = true;                    // whether inverted quads are turned together with the quads around them
  bool may_release_bends = true;            // whether vertices at bends of arcs may slide where quads are inverted
  double arc_tolerance = 0;                 // how far sides may be from arcs there, in the unit of the embedding
  double good_enough = 0.6;                 // quads may get worse down to this scaled Jacobian for a smaller distortion
  double passable = 0.6;                    // the same in the first sweeps
  double bad = 0.3;                         // below this scaled Jacobian, the worst quad of a vertex is raised alone
};

// What the smoothing around inverted quads has left, of the patches that are not left out.
struct Inverted_quads
{
  std::vector<int> quads;
  std::vector<std::size_t> number_before_round; // how many there were before each round
  bool is_beaten = false;                       // the smoothing stopped as a rival had fewer of them
};

struct Smoothing_report
{
  double worst_before = 0, worst_after = 0;       // scaled Jacobian, negative if the quad lies on its face
  int inverted_before = 0;                        // quads whose scaled Jacobian is not positive
  std::vector<int> inverted_quads;                // after the smoothing
};

inline std::vector<int> inverted_quads(const Sliding_quads& quads)
{
  std::vector<int> result;
  for(int q = 0; q < quads.number_of_quads(); ++q)
    if(quads.shape(q).scaled_jacobian <= 0)
      result.push_back(q);
  return result;
}

// Moves vertices one after the other to where the distortion of their quads is less: first those on arcs, then those
// inside each patch. Patches share no quads, so these are swept in parallel.
//
// A move is accepted if the worst of these quads does not get worse, or stays good enough and not worse than the worst
// quad of all was at the start of the sweep. At a vertex of inverted quads, the worst one must get better and no other
// one may get inverted. So the worst of all never gets worse, and no quad gets inverted.
template <typename ConcurrencyTag>
class Distortion_sweeps
{
public:
  // Only the given vertices move.
  Distortion_sweeps(Sliding_quads& quads, const std::vector<int>& vertices)
    : m_quads(quads), m_vertices(vertices), m_inside(quads.surface().patches.size())
    , m_last_change(quads.number_of_quads(), 0)
  {
    for(const int v : vertices)
      if(quads.freedom(v) == Sliding_quads::IN_PATCH)
        m_inside[quads.vertex(v).patch].push_back(v);
  }

  void run(const int number_of_sweeps, const double good_enough)
  {
    std::vector<int> on_arcs; // more of them after a release
    for(const int v : m_vertices)
      if(m_quads.freedom(v) == Sliding_quads::ON_ARC)
        on_arcs.push_back(v);
    ++m_sweep; // with this as the last change of all quads, all vertices may move in the first sweep
    std::fill(m_last_change.begin(), m_last_change.end(), m_sweep);
    for(int i = 0; i < number_of_sweeps; ++i)
    {
      ++m_sweep;
      m_acceptable = (std::max)(good_enough, m_quads.worst());
      bool has_moved = improve(on_arcs);
      std::vector<char> has_moved_inside(m_inside.size());
      for_each_patch<ConcurrencyTag>(m_quads.surface(), [&](const int patch)
      {
        has_moved_inside[patch] = improve(m_inside[patch]);
        return Patch_result();
      });
      for(const char has_moved_in_patch : has_moved_inside)
        has_moved = has_moved || has_moved_in_patch != 0;
      if(!has_moved)
        return;
    }
  }

private:
  // Whether its quads changed in this sweep or the one before.
  bool may_move(const int vertex) const
  {
    return std::any_of(m_quads.corners_begin(vertex), m_quads.corners_end(vertex), [&](const int c)
                       { return m_last_change[c / 4] + 1 >= m_sweep; });
  }

  bool improve(const std::vector<int>& vertices)
  {
    bool has_moved = false;
    Slid_corners slid;
    for(const int v : vertices)
      if(may_move(v) && improve(v, slid))
      {
        for(const int* c = m_quads.corners_begin(v); c != m_quads.corners_end(v); ++c)
          m_last_change[*c / 4] = m_sweep;
        has_moved = true;
      }
    return has_moved;
  }

  // `slid` is overwritten.
  bool improve(const int vertex, Slid_corners& slid)
  {
    const int maximum_number_of_halvings = 3;
    const bool is_on_arc = m_quads.freedom(vertex) == Sliding_quads::ON_ARC;
    const Quad_shape old_shape = m_quads.shape_around(vertex);
    const double old_length = m_quads.arc_order().length(vertex);
    const double length_step = is_on_arc ? length_of_least_distortion(m_quads, vertex) - old_length : 0;
    const Coordinates step = is_on_arc ? Coordinates{ 0, 0, 0 } : step_inside(m_quads, vertex);
    double part = 1;
    for(int i = 0; i <= maximum_number_of_halvings; ++i, part /= 2)
    {
      Slide slide;
      const bool is_possible = is_on_arc ? m_quads.slide_on_arc(vertex, old_length + part * length_step, slide)
                                         : m_quads.slide_inside(vertex, part * step, slide);
      if(!is_possible)
        continue;
      if(is_negligible(vertex, slide))
        return false;
      if(is_better(vertex, slide, old_shape, slid))
      {
        m_quads.move(vertex, slide, slid);
        return true;
      }
    }
    return false;
  }

  bool is_negligible(const int vertex, const Slide& slide) const
  {
    const double smallest_step = 1e-3; // over the length of an edge
    const int* const c = m_quads.corners_begin(vertex);
    if(c == m_quads.corners_end(vertex))
      return true;
    const Coordinates step = slide.point - m_quads.point(vertex);
    const Coordinates edge = m_quads.point(m_quads.quad(*c / 4)[(*c + 1) % 4]) - m_quads.point(vertex);
    return dot(step, step) <= smallest_step * smallest_step * dot(edge, edge);
  }

  bool is_better(const int vertex, const Slide& slide, const Quad_shape& old_shape, Slid_corners& slid) const
  {
    const Quad_shape shape = m_quads.shape_around(vertex, slide, slid);
    if(!std::isfinite(old_shape.distortion))
      return shape.scaled_jacobian > old_shape.scaled_jacobian && !m_quads.inverts_quad(vertex, slide);
    return shape.distortion < old_shape.distortion
           && (shape.scaled_jacobian >= old_shape.scaled_jacobian || shape.scaled_jacobian >= m_acceptable);
  }

  Sliding_quads& m_quads;
  const std::vector<int>& m_vertices;
  std::vector<std::vector<int> > m_inside; // per patch
  double m_acceptable = 0;
  int m_sweep = 0;
  std::vector<int> m_last_change; // per quad: the sweep
};

// The inverted quads of patches that are not left out (a flag per patch).
inline std::vector<int> inverted_quads(const Sliding_quads& quads, const std::vector<char>& is_patch_left_out)
{
  std::vector<int> result = inverted_quads(quads);
  result.erase(std::remove_if(result.begin(), result.end(), [&](const int q)
                              { return is_patch_left_out[quads.patch(q)] != 0; }), result.end());
  return result;
}

// Untangles, improves the worst quads and sweeps, in rounds. Only the given vertices move, but untangling moves those
// of the tangled parts. Calls `goes_on()` before each round, and stops if it returns false.
template <typename ConcurrencyTag, typename GoesOn>
void smooth_vertices(Sliding_quads& quads, const std::vector<int>& vertices,
                     const std::vector<char>& is_patch_left_out, const Smoothing_options& options,
                     const GoesOn& goes_on)
{
  Distortion_sweeps<ConcurrencyTag> sweeps(quads, vertices);
  std::vector<std::int64_t> tried(quads.number_of_vertices(), -1);
  bool may_untangle = options.untangles && untangle_quads(quads, is_patch_left_out);
  sweeps.run(options.number_of_sweeps, options.passable);
  for(int round = 0; round < options.number_of_rounds && goes_on(); ++round)
  {
    if(options.may_release_bends)
      for(const int v : tangled_vertices(quads, is_patch_left_out))
        may_untangle |= quads.release(v);
    may_untangle = may_untangle && untangle_quads(quads, is_patch_left_out);
    const bool has_improved = improve_worst_quads(quads, vertices, options.bad, tried);
    sweeps.run(options.number_of_sweeps / 2, options.good_enough);
    if(!may_untangle && !has_improved)
      break;
  }
}

// Smooths only around inverted quads of patches that are not left out (a flag per patch). Stops early once a quarter
// more quads are inverted than `rival` had before the same round.
template <typename ConcurrencyTag>
Inverted_quads smooth_inverted_quads(Quad_complex& complex, const Cut_surface& surface,
                                     const Surface_embedding& embedding, const Feature_network& network,
                                     const std::vector<char>& is_patch_left_out, const Smoothing_options& options,
                                     const Inverted_quads& rival = Inverted_quads())
{
  Sliding_quads quads(complex, surface, embedding, network, options.arc_tolerance);
  const std::vector<int> vertices = tangled_vertices(quads, is_patch_left_out);
  Inverted_quads result;
  const auto is_not_beaten = [&]
  {
    const std::size_t round = result.number_before_round.size();
    const std::size_t number = inverted_quads(quads, is_patch_left_out).size();
    result.number_before_round.push_back(number);
    result.is_beaten =
      round < rival.number_before_round.size() && 4 * number > 5 * rival.number_before_round[round];
    return !result.is_beaten;
  };
  if(!vertices.empty())
    smooth_vertices<ConcurrencyTag>(quads, vertices, is_patch_left_out, options, is_not_beaten);
  result.quads = inverted_quads(quads, is_patch_left_out);
  return result;
}

// Smooths a quad mesh on its surface: vertices in a patch stay in it, vertices on an arc stay on it and in their order,
// and vertices at vertices of the surface stay where they are.
template <typename ConcurrencyTag = CGAL::Sequential_tag>
Smoothing_report smooth(Quad_complex& complex, const Cut_surface& surface, const Surface_embedding& embedding,
                        const Feature_network& network, const Smoothing_options& options = {})
{
  Smoothing_report report;
  if(complex.quads.empty())
    return report;
  Sliding_quads quads(complex, surface, embedding, network, options.arc_tolerance);
  report.worst_before = quads.worst();
  report.inverted_before = static_cast<int>(inverted_quads(quads).size());
  std::vector<int> vertices(quads.number_of_vertices());
  std::iota(vertices.begin(), vertices.end(), 0);
  smooth_vertices<ConcurrencyTag>(quads, vertices, std::vector<char>(surface.patches.size(), 0), options,
                                  [] { return true; });
  report.worst_after = quads.worst();
  report.inverted_quads = inverted_quads(quads);
  return report;
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_SMOOTH_QUADS_H
