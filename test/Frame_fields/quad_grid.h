#ifndef TEST_QUAD_GRID_H
#define TEST_QUAD_GRID_H

#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Certified maps made from rectangles that are glued together, for tests that need no mesh.
namespace test {

using namespace CGAL::Frame_fields::internal;

typedef std::array<std::int64_t, 2> Grid_point;

inline Grid_point turned(Grid_point p, const int quarter_turns)
{
  for(int i = 0; i < (quarter_turns & 3); ++i)
    p = { -p[1], p[0] };
  return p;
}

inline Grid_point sum(const Grid_point& a, const Grid_point& b) { return { a[0] + b[0], a[1] + b[1] }; }
inline Grid_point difference(const Grid_point& a, const Grid_point& b) { return { a[0] - b[0], a[1] - b[1] }; }

// A corner of a polygon.
struct Grid_corner
{
  int vertex, side;  // the side that comes to it, -1 for an edge inside a polygon
  Grid_point point;
  int quads;         // quarter turns of the corners that begin here, counted counter-clockwise
};

// Rectangles with counter-clockwise vertices; the side i runs from vertex i to the next one. Side 0 is along u.
struct Quad_grid
{
  // Several rectangles that make up one, without the vertices inside: a fan around `center`.
  struct Block
  {
    int center_vertex;
    Grid_point center;
    std::vector<Grid_corner> corners;
  };

  std::vector<std::array<int, 4> > vertices;
  std::vector<std::array<std::int64_t, 2> > sizes; // along the sides 0 and 1
  std::set<std::pair<int, int> > constrained;      // the smaller vertex first
  std::vector<Block> blocks;
  std::set<int> quads_in_blocks;

  void constrain(const int a, const int b) { constrained.insert({ (std::min)(a, b), (std::max)(a, b) }); }
  bool is_constrained(const int a, const int b) const
  {
    return constrained.count({ (std::min)(a, b), (std::max)(a, b) }) > 0;
  }
  std::int64_t length(const int side) const { return sizes[side / 4][side % 2]; }
};

// A triangulated Quad_grid with its map; all arrays as the library wants them.
struct Grid_map
{
  Cut_surface surface;
  Seamless_map map;
  std::vector<int> index;          // per sector
  std::vector<char> is_arc_node;   // per sector
  std::vector<int> side;           // per halfedge: 4 q + i on the side i of the rectangle q, -1 on diagonals
  std::vector<int> quad;           // per face
  std::vector<int> chart_turns;    // per face: how often its chart is turned, and then moved by
  std::vector<Grid_point> chart_shift;

  Grid_point point(const int corner) const { return { map.u[corner], map.v[corner] }; }
  void set_point(const int corner, const Grid_point& p)
  {
    map.u[corner] = p[0];
    map.v[corner] = p[1];
  }
  bool is_regular(const int sector) const { return index[sector] == 0 && !is_arc_node[sector]; }

  std::int64_t double_area(const int face) const
  {
    const Grid_point a = difference(point(3 * face + 1), point(3 * face));
    const Grid_point b = difference(point(3 * face + 2), point(3 * face));
    return a[0] * b[1] - a[1] * b[0];
  }
};

namespace quad_grid {

struct Triangle
{
  std::array<Grid_corner, 3> corners;
  int polygon; // the rectangle, or behind them the block
};

inline std::vector<Triangle> triangles(const Quad_grid& grid, std::mt19937& random)
{
  std::vector<Triangle> result;
  for(int q = 0; q < static_cast<int>(grid.vertices.size()); ++q)
  {
    if(grid.quads_in_blocks.count(q) > 0)
      continue;
    const std::int64_t w = grid.sizes[q][0], h = grid.sizes[q][1];
    const std::array<Grid_point, 4> points = { { { 0, 0 }, { w, 0 }, { w, h }, { 0, h } } };
    const int first = static_cast<int>(random() % 4);
    const auto corner = [&](const int i, const bool is_on_side, const int quads) -> Grid_corner
    {
      const int k = (first + i) % 4;
      return { grid.vertices[q][k], is_on_side ? 4 * q + (k + 3) % 4 : -1, points[k], quads };
    };
    // The diagonal joins the vertices 0 and 2 counted from `first`.
    result.push_back({ { corner(0, false, 1), corner(1, true, 1), corner(2, true, 0) }, q });
    result.push_back({ { corner(2, false, 1), corner(3, true, 1), corner(0, true, 0) }, q });
  }
  int polygon = static_cast<int>(grid.vertices.size());
  for(const Quad_grid::Block& block : grid.blocks)
  {
    for(std::size_t i = 0; i < block.corners.size(); ++i)
    {
      Grid_corner first = block.corners[i], second = block.corners[(i + 1) % block.corners.size()];
      first.side = -1;
      second.quads = 0;
      result.push_back({ { Grid_corner{ block.center_vertex, -1, block.center, i == 0 ? 4 : 0 }, first, second },
                         polygon });
    }
    ++polygon;
  }
  return result;
}

inline std::vector<int> opposites(const Quad_grid& grid, const std::vector<Triangle>& triangles)
{
  std::map<std::array<int, 3>, int> halfedge_of_edge; // the polygon around it, or -1; source and target
  std::vector<int> result(3 * triangles.size(), -1);
  for(int h = 0; h < static_cast<int>(result.size()); ++h)
  {
    const auto& corners = triangles[h / 3].corners;
    const int source = corners[(h + 2) % 3].vertex, target = corners[h % 3].vertex;
    if(corners[h % 3].side < 0)
      halfedge_of_edge[{ triangles[h / 3].polygon, source, target }] = h;
    else if(!grid.is_constrained(source, target))
      halfedge_of_edge[{ -1, source, target }] = h;
  }
  for(const auto& entry : halfedge_of_edge)
  {
    const auto other = halfedge_of_edge.find({ entry.first[0], entry.first[2], entry.first[1] });
    if(other != halfedge_of_edge.end())
      result[entry.second] = other->second;
  }
  return result;
}

inline void number_sectors(Cut_surface& surface)
{
  surface.sector.assign(surface.opposite.size(), -1);
  for(Patch& patch : surface.patches)
  {
    patch.sectors.begin_index = surface.number_of_sectors();
    patch.dual_edges.begin_index = surface.number_of_dual_edges();
    for(int h = 3 * patch.faces.begin_index; h < 3 * patch.faces.end_index; ++h)
    {
      if(surface.opposite[h] > h)
        surface.dual_edges.push_back({ h, surface.opposite[h] });
      if(surface.sector[h] >= 0)
        continue;
      surface.first_corner.push_back(clockwise_most_corner(surface.opposite, h));
      for_each_corner(surface.opposite, surface.first_corner.back(),
                      [&](const int corner) { surface.sector[corner] = surface.number_of_sectors(); });
      surface.total_angle.push_back(0);
    }
    patch.sectors.end_index = surface.number_of_sectors();
    patch.dual_edges.end_index = surface.number_of_dual_edges();
  }
}

} // namespace quad_grid

inline Grid_map grid_map(const Quad_grid& grid, std::mt19937& random)
{
  const auto triangles = quad_grid::triangles(grid, random);
  Grid_map result;
  Cut_surface& surface = result.surface;
  std::vector<int> patch_of_face;
  const std::vector<int> opposite = quad_grid::opposites(grid, triangles);
  const int number_of_patches = number_patches(opposite, patch_of_face);
  const std::vector<int> order = face_order_by_patches(patch_of_face, number_of_patches, surface.patches);
  surface.opposite = reorder_opposites(opposite, order);
  surface.angle.assign(surface.opposite.size(), 0);
  quad_grid::number_sectors(surface);

  std::vector<int> quads(surface.number_of_sectors(), 0);
  result.map.u.resize(surface.opposite.size());
  result.map.v.resize(surface.opposite.size());
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    const Grid_corner& corner = triangles[order[h / 3]].corners[h % 3];
    quads[surface.sector[h]] += corner.quads;
    result.set_point(h, corner.point);
    result.side.push_back(corner.side);
  }
  for(int s = 0; s < surface.number_of_sectors(); ++s)
    result.index.push_back((surface.is_constrained_sector(s) ? 2 : 4) - quads[s]);
  for(const int triangle : order)
    result.quad.push_back(triangles[triangle].polygon);
  result.is_arc_node.assign(surface.number_of_sectors(), 0);
  result.chart_turns.assign(surface.number_of_faces(), 0);
  result.chart_shift.assign(surface.number_of_faces(), { 0, 0 });
  result.map.status.assign(surface.patches.size(), Map_status::CERTIFIED);
  result.map.fraction_bits.assign(surface.patches.size(), 0);

  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    const int o = surface.opposite[h];
    int turns = 0;
    if(o >= 0)
      while(turns < 3 && turned(difference(result.point(h), result.point(previous_of(h))), turns)
                           != difference(result.point(previous_of(o)), result.point(o)))
        ++turns;
    result.map.quarter_turns.push_back(static_cast<unsigned char>(turns));
  }
  return result;
}

// Lengths and angles in space: the map is an isometry with `scale` steps of the grid per unit.
inline void set_lengths(Grid_map& grid, const double scale)
{
  grid.surface.length.clear();
  for(int h = 0; h < grid.surface.number_of_halfedges(); ++h)
  {
    const Grid_point edge = difference(grid.point(h), grid.point(previous_of(h)));
    grid.surface.length.push_back(std::hypot(static_cast<double>(edge[0]), static_cast<double>(edge[1])) / scale);
    const Grid_point next_edge = difference(grid.point(next_of(h)), grid.point(h));
    grid.surface.angle[h] = std::atan2(static_cast<double>(edge[0] * next_edge[1] - edge[1] * next_edge[0]),
                                       static_cast<double>(-edge[0] * next_edge[0] - edge[1] * next_edge[1]));
  }
}

// Moves the vertex of a regular sector, on the border along it, unless a face would be turned over.
inline void move_vertex(Grid_map& grid, const int sector, Grid_point vector)
{
  const Cut_surface& surface = grid.surface;
  const int first = surface.first_corner[sector];
  if(surface.is_constrained_sector(sector))
  {
    const Grid_point edge = difference(grid.point(next_of(first)), grid.point(first));
    vector = edge[0] == 0 ? Grid_point{ 0, vector[1] } : Grid_point{ vector[0], 0 };
  }
  const auto move = [&](const int sign)
  {
    Grid_point moved = { sign * vector[0], sign * vector[1] };
    for_each_corner(surface.opposite, first, [&](const int corner)
    {
      grid.set_point(corner, sum(grid.point(corner), moved));
      if(surface.opposite[corner] >= 0)
        moved = turned(moved, grid.map.quarter_turns[corner]);
    });
  };
  move(1);
  bool is_valid = true;
  for_each_corner(surface.opposite, first,
                  [&](const int corner) { is_valid = is_valid && grid.double_area(face_of(corner)) > 0; });
  if(!is_valid)
    move(-1);
}

// Whether the vertex of a sector is a node, or joined to one by an edge.
inline bool is_near_node(const Grid_map& grid, const int sector)
{
  bool result = !grid.is_regular(sector);
  for_each_corner(grid.surface.opposite, grid.surface.first_corner[sector], [&](const int corner)
  {
    result = result || !grid.is_regular(grid.surface.sector[next_of(corner)])
          || !grid.is_regular(grid.surface.sector[previous_of(corner)]);
  });
  return result;
}

// Moves all vertices that it may by up to `largest`, those near nodes only if asked for. Some move along an axis or a
// diagonal, so that points of the grid come to lie on edges.
inline void move_vertices(Grid_map& grid, const std::int64_t largest, const bool also_near_nodes, std::mt19937& random)
{
  const auto coordinate = [&] { return static_cast<std::int64_t>(random() % (2 * largest + 1)) - largest; };
  for(int s = 0; s < grid.surface.number_of_sectors(); ++s)
  {
    const std::int64_t u = coordinate(), v = coordinate();
    const std::array<Grid_point, 5> vectors = { { { u, v }, { u, 0 }, { 0, v }, { u, u }, { u, -u } } };
    const Grid_point vector = vectors[random() % 5];
    if(grid.is_regular(s) && (also_near_nodes || !is_near_node(grid, s)))
      move_vertex(grid, s, vector);
  }
}

// Turns and moves the charts of all faces.
inline void change_charts(Grid_map& grid, const int shift_bits, std::mt19937& random)
{
  const std::int64_t step = std::int64_t(1) << shift_bits;
  const auto coordinate = [&] { return (static_cast<std::int64_t>(random() % 2048) - 1024) * step; };
  std::vector<int> turns;
  for(int f = 0; f < grid.surface.number_of_faces(); ++f)
  {
    turns.push_back(static_cast<int>(random() % 4));
    const std::int64_t u = coordinate(), v = coordinate();
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      grid.set_point(h, sum(turned(grid.point(h), turns[f]), { u, v }));
    grid.chart_shift[f] = sum(turned(grid.chart_shift[f], turns[f]), { u, v });
    grid.chart_turns[f] += turns[f];
  }
  for(int h = 0; h < grid.surface.number_of_halfedges(); ++h)
    if(grid.surface.opposite[h] >= 0)
    {
      const int change = turns[face_of(grid.surface.opposite[h])] - turns[face_of(h)];
      grid.map.quarter_turns[h] = static_cast<unsigned char>((grid.map.quarter_turns[h] + change) & 3);
    }
}

} // namespace test

#endif // TEST_QUAD_GRID_H
