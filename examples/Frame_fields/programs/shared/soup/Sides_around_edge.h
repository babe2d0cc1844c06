#ifndef FRAME_FIELDS_PROGRAMS_SIDES_AROUND_EDGE_H
#define FRAME_FIELDS_PROGRAMS_SIDES_AROUND_EDGE_H

#include "../Mesh.h"

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// A side of a triangle at an edge from point a to point b.
struct Side_at_edge
{
  std::size_t side;
  bool is_forward; // from a to b
  Point corner;    // the third one of its triangle
};

// Sorts sides around an edge by the angle from the first one, counter-clockwise as seen from b.
class Sides_around_edge
{
public:
  Sides_around_edge(const Point& a, const Point& b) : m_a(a), m_b(b) {}

  // Joins sides that bound the same solid there, if there are as many forward as backward ones, and none is of a
  // triangle without area. With the normals outwards, solids follow backward sides and end at forward ones.
  std::vector<std::pair<std::size_t, std::size_t> > pairs(std::vector<Side_at_edge> sides,
                                                          const bool is_inside_out) const
  {
    const auto is_flat = [&](const Side_at_edge& side) { return CGAL::collinear(m_a, m_b, side.corner); };
    const auto number_of_forward = std::count_if(sides.begin(), sides.end(),
                                                 [](const Side_at_edge& side) { return side.is_forward; });
    if(2 * static_cast<std::size_t>(number_of_forward) != sides.size()
       || std::any_of(sides.begin(), sides.end(), is_flat))
      return {};

    const Point reference = sides.front().corner;
    std::stable_sort(sides.begin(), sides.end(), [&](const Side_at_edge& i, const Side_at_edge& j)
    {
      const CGAL::Comparison_result angles = compare_angles(reference, i.corner, j.corner);
      if(angles != CGAL::EQUAL)
        return angles == CGAL::SMALLER;
      return i.is_forward != j.is_forward && i.is_forward != is_inside_out; // one solid ends before another begins
    });
    return matched(sides, !is_inside_out);
  }

private:
  // 0: at the angle of the reference, 1: less than half a turn, 2: half a turn, 3: more.
  int quarter(const Point& reference, const Point& p) const
  {
    const CGAL::Orientation turn = CGAL::orientation(m_a, m_b, reference, p);
    if(turn == CGAL::COPLANAR)
      return CGAL::coplanar_orientation(m_a, m_b, reference, p) == CGAL::POSITIVE ? 0 : 2;
    return turn == CGAL::POSITIVE ? 1 : 3;
  }

  CGAL::Comparison_result compare_angles(const Point& reference, const Point& p, const Point& q) const
  {
    const int p_quarter = quarter(reference, p), q_quarter = quarter(reference, q);
    if(p_quarter != q_quarter)
      return p_quarter < q_quarter ? CGAL::SMALLER : CGAL::LARGER;
    if(p_quarter % 2 == 0)
      return CGAL::EQUAL;
    const CGAL::Orientation turn = CGAL::orientation(m_a, m_b, p, q);
    return turn == CGAL::POSITIVE ? CGAL::SMALLER : turn == CGAL::NEGATIVE ? CGAL::LARGER : CGAL::EQUAL;
  }

  // Matches sides like parentheses around a circle: the ones that are forward or not close those before them.
  static std::vector<std::pair<std::size_t, std::size_t> > matched(std::vector<Side_at_edge>& sides,
                                                                   const bool forward_closes)
  {
    const auto closes = [&](const Side_at_edge& side) { return side.is_forward == forward_closes; };
    long long depth = 0, least_depth = 0;
    std::size_t start = 0; // where the depth is least
    for(std::size_t k = 0; k < sides.size(); ++k)
    {
      depth += closes(sides[k]) ? -1 : 1;
      if(depth < least_depth)
      {
        least_depth = depth;
        start = k + 1;
      }
    }
    std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(start), sides.end());
    std::vector<std::pair<std::size_t, std::size_t> > result;
    std::vector<std::size_t> open;
    for(const Side_at_edge& side : sides)
      if(closes(side))
      {
        result.emplace_back(open.back(), side.side);
        open.pop_back();
      }
      else
        open.push_back(side.side);
    return result;
  }

  Point m_a, m_b;
};

#endif // FRAME_FIELDS_PROGRAMS_SIDES_AROUND_EDGE_H
