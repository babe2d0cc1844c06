#ifndef FRAME_FIELDS_PROGRAMS_TRIANGLE_SURFACE_H
#define FRAME_FIELDS_PROGRAMS_TRIANGLE_SURFACE_H

#include "../Mesh.h"
#include "Disjoint_sets.h"
#include "Edge_groups.h"
#include "Sides_around_edge.h"
#include "Triangle.h"
#include "remove_duplicates.h"

#include <CGAL/Kernel/global_functions_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

// Joins triangles along their sides so that they make an oriented manifold, whatever they are: a side is joined with at
// most one other one, that runs the other way, and a vertex is a fan of corners between joined sides.
//
// A vertex of the file stands at a place; vertices at different places are never joined. Where more than two sides join
// two places, those of the same vertices of the file belong together, and what is left bounds solids.
class Triangle_surface
{
public:
  Triangle_surface(const std::vector<Point>& points, const std::vector<std::size_t>& place,
                   std::vector<Triangle> triangles)
    : m_points(points)
    , m_place(place)
    , m_triangles(std::move(triangles))
    , m_opposite(3 * m_triangles.size(), NO_SIDE)
  {
    join_sides();
    orient();
    join_sides_of_solids();
    join_corners();
  }

  const std::vector<Triangle>& triangles() const { return m_triangles; }
  std::size_t opposite(const std::size_t side) const { return m_opposite[side]; }
  bool is_border(const std::size_t side) const { return m_opposite[side] == NO_SIDE; }
  std::size_t number_of_sides() const { return m_opposite.size(); }

  // The vertex of the surface at a corner, named by a corner.
  std::size_t vertex_at(const std::size_t corner) const { return m_vertex_at[corner]; }
  std::size_t file_vertex(const std::size_t corner) const { return m_triangles[corner / 3][corner % 3]; }
  std::size_t place_at(const std::size_t corner) const { return m_place[file_vertex(corner)]; }

  std::size_t number_of_turned_triangles() const { return m_number_of_turned_triangles; }
  std::size_t number_of_cut_edges() const { return m_number_of_cut_edges; } // of a surface that has one side

private:
  typedef std::vector<std::size_t> Group;

  bool is_forward(const std::size_t side) const { return place_at(side) < place_at(next_side(side)); }

  void join(const std::size_t side, const std::size_t other)
  {
    m_opposite[side] = other;
    m_opposite[other] = side;
  }

  bool is_on(const std::size_t triangle, const std::size_t other) const
  {
    const std::array<std::size_t, 3> a = places_of(m_triangles[triangle], m_place);
    const std::array<std::size_t, 3> b = places_of(m_triangles[other], m_place);
    return a[0] == b[0] && (std::min)(a[1], a[2]) == (std::min)(b[1], b[2])
           && (std::max)(a[1], a[2]) == (std::max)(b[1], b[2]);
  }

  void join_sides()
  {
    Edge_groups(m_triangles, m_place).for_each([&](const std::size_t* const first, const std::size_t* const last)
    {
      Group group(first, last);
      if(group.size() > 2)
        join_sides_of_same_vertices(group);
      if(group.size() == 2)
        join(group[0], group[1]);
      else if(group.size() > 2)
        m_groups_of_solids.push_back(std::move(group));
    });
  }

  // Leaves the other sides in the group.
  void join_sides_of_same_vertices(Group& group)
  {
    const auto vertices = [&](const std::size_t side)
    {
      return std::minmax({ file_vertex(side), file_vertex(next_side(side)) });
    };
    std::stable_sort(group.begin(), group.end(),
                     [&](const std::size_t i, const std::size_t j) { return vertices(i) < vertices(j); });
    Group rest;
    for(std::size_t begin = 0, end = 0; begin < group.size(); begin = end)
    {
      while(end < group.size() && vertices(group[end]) == vertices(group[begin]))
        ++end;
      if(end - begin == 2 && !is_on(group[begin] / 3, group[begin + 1] / 3))
        join(group[begin], group[begin + 1]);
      else
        rest.insert(rest.end(), group.begin() + static_cast<std::ptrdiff_t>(begin),
                    group.begin() + static_cast<std::ptrdiff_t>(end));
    }
    group = std::move(rest);
  }

  // Turns triangles, the fewer ones of each component, until those that are joined are oriented alike, and cuts what
  // has one side only.
  void orient()
  {
    enum { UNKNOWN, KEPT, TURNED };
    std::vector<char> state(m_triangles.size(), UNKNOWN);
    std::vector<std::size_t> component;
    for(std::size_t seed = 0; seed < m_triangles.size(); ++seed)
    {
      if(state[seed] != UNKNOWN)
        continue;
      component.assign(1, seed);
      state[seed] = KEPT;
      std::size_t number_of_turned = 0;
      for(std::size_t i = 0; i < component.size(); ++i)
        for(std::size_t side = 3 * component[i]; side < 3 * component[i] + 3; ++side)
        {
          if(is_border(side))
            continue;
          const std::size_t t = m_opposite[side] / 3;
          const bool is_turned = (state[side / 3] == TURNED) != (is_forward(side) == is_forward(m_opposite[side]));
          if(state[t] == UNKNOWN)
          {
            state[t] = is_turned ? TURNED : KEPT;
            number_of_turned += is_turned;
            component.push_back(t);
          }
          else if((state[t] == TURNED) != is_turned)
          {
            m_opposite[m_opposite[side]] = NO_SIDE;
            m_opposite[side] = NO_SIDE;
            ++m_number_of_cut_edges;
          }
        }
      if(2 * number_of_turned > component.size())
        for(const std::size_t t : component)
          state[t] = state[t] == TURNED ? KEPT : TURNED;
    }
    turn([&](const std::size_t t) { return state[t] == TURNED; });
  }

  // A triangle that is turned has its first corner first, so that its sides have other numbers.
  template <typename IsTurned>
  void turn(const IsTurned& is_turned)
  {
    const auto new_side = [&](const std::size_t side)
    {
      return side != NO_SIDE && is_turned(side / 3) ? side - side % 3 + (2 - side % 3) : side;
    };
    std::vector<std::size_t> opposite(m_opposite.size());
    for(std::size_t side = 0; side < m_opposite.size(); ++side)
      opposite[new_side(side)] = new_side(m_opposite[side]);
    m_opposite = std::move(opposite);
    for(Group& group : m_groups_of_solids)
      std::transform(group.begin(), group.end(), group.begin(), new_side);
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      if(is_turned(t))
      {
        std::swap(m_triangles[t][1], m_triangles[t][2]);
        ++m_number_of_turned_triangles;
      }
  }

  const Point& point_at(const std::size_t corner) const { return m_points[place_at(corner)]; }

  // Whether the volume inside is negative.
  bool is_inside_out() const
  {
    double volume = 0;
    const Point& origin = point_at(0);
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      volume += CGAL::determinant(point_at(3 * t) - origin, point_at(3 * t + 1) - origin, point_at(3 * t + 2) - origin);
    return volume < 0;
  }

  void join_sides_of_solids()
  {
    if(m_groups_of_solids.empty())
      return;
    const bool inside_out = is_inside_out();
    for(const Group& group : m_groups_of_solids)
    {
      const bool first_is_forward = is_forward(group.front());
      const Point& start = point_at(group.front());
      const Point& end = point_at(next_side(group.front()));
      std::vector<Side_at_edge> sides;
      for(const std::size_t side : group)
        sides.push_back({ side, is_forward(side), point_at(previous_side(side)) });
      const Sides_around_edge around_edge(first_is_forward ? start : end, first_is_forward ? end : start);
      for(const auto& [side, other] : around_edge.pairs(std::move(sides), inside_out))
        join(side, other);
    }
  }

  void unite_corners(const std::size_t side, Disjoint_sets& fans) const
  {
    fans.unite(side, next_side(m_opposite[side]));
    fans.unite(next_side(side), m_opposite[side]);
  }

  void join_corners()
  {
    Disjoint_sets fans(m_opposite.size());
    for(std::size_t side = 0; side < m_opposite.size(); ++side)
      if(!is_border(side))
        unite_corners(side, fans);
    m_vertex_at.resize(m_opposite.size());
    for(std::size_t corner = 0; corner < m_opposite.size(); ++corner)
      m_vertex_at[corner] = fans.find(corner);
    close_holes_of_two_sides();
  }

  // Border sides that run to and fro between two vertices are joined, too; this changes no vertex.
  void close_holes_of_two_sides()
  {
    std::vector<std::pair<std::array<std::size_t, 2>, std::size_t> > borders; // by the vertices
    for(std::size_t side = 0; side < m_opposite.size(); ++side)
      if(is_border(side))
      {
        const std::size_t a = m_vertex_at[side], b = m_vertex_at[next_side(side)];
        borders.push_back({ { (std::min)(a, b), (std::max)(a, b) }, side });
      }
    std::sort(borders.begin(), borders.end());
    for(std::size_t k = 1; k < borders.size(); ++k)
      if(borders[k].first == borders[k - 1].first && is_border(borders[k - 1].second)
         && m_vertex_at[borders[k].second] != m_vertex_at[borders[k - 1].second])
        join(borders[k - 1].second, borders[k].second);
  }

  const std::vector<Point>& m_points;
  const std::vector<std::size_t>& m_place;
  std::vector<Triangle> m_triangles;
  std::vector<std::size_t> m_opposite;
  std::vector<Group> m_groups_of_solids;
  std::vector<std::size_t> m_vertex_at;
  std::size_t m_number_of_turned_triangles = 0, m_number_of_cut_edges = 0;
};

#endif // FRAME_FIELDS_PROGRAMS_TRIANGLE_SURFACE_H
