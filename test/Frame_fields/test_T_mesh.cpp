#include "motorcycle_simulation.h"
#include "quad_grid.h"

#include <CGAL/Frame_fields/internal/layout/make_T_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/sign_of_determinant.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

// T-meshes of maps that are known: rectangles glued together. That vertices of the triangulation are moved and charts
// changed must not change the T-mesh.
namespace {

using namespace test;

constexpr std::int64_t unit = 1 << 20;

std::vector<std::int64_t> equal_sizes(const std::size_t number) { return std::vector<std::int64_t>(number, unit); }

std::vector<std::int64_t> random_sizes(const std::size_t number, const bool is_generic, std::mt19937& random)
{
  std::vector<std::int64_t> sizes;
  for(std::size_t i = 0; i < number; ++i)
    sizes.push_back(is_generic ? unit / 8 + random() % unit : unit * (1 + random() % 3));
  return sizes;
}

typedef std::vector<std::vector<bool> > Pixels; // [x][y]

Quad_grid planar_domain(const Pixels& pixels, const std::vector<std::int64_t>& widths,
                        const std::vector<std::int64_t>& heights)
{
  Quad_grid grid;
  const int columns = static_cast<int>(widths.size()) + 1;
  for(int x = 0; x < static_cast<int>(widths.size()); ++x)
    for(int y = 0; y < static_cast<int>(heights.size()); ++y)
      if(pixels[x][y])
      {
        const int v = x + columns * y;
        grid.vertices.push_back({ v, v + 1, v + 1 + columns, v + columns });
        grid.sizes.push_back({ widths[x], heights[y] });
      }
  return grid;
}

Quad_grid rectangle(const int width, const int height)
{
  return planar_domain(Pixels(width, std::vector<bool>(height, true)), equal_sizes(width), equal_sizes(height));
}

// Takes all pixels but the outer ones together to a block, with the vertices only that it shares with others.
void make_room(Quad_grid& grid, const std::vector<std::int64_t>& widths, const std::vector<std::int64_t>& heights,
               std::mt19937& random)
{
  const int columns = static_cast<int>(widths.size()), rows = static_cast<int>(heights.size());
  std::set<int> vertices_of_others;
  for(int q = 0; q < static_cast<int>(grid.vertices.size()); ++q)
  {
    const int x = grid.vertices[q][0] % (columns + 1), y = grid.vertices[q][0] / (columns + 1);
    if(x > 0 && y > 0 && x + 1 < columns && y + 1 < rows)
      grid.quads_in_blocks.insert(q);
    else
      vertices_of_others.insert(grid.vertices[q].begin(), grid.vertices[q].end());
  }
  Quad_grid::Block block = { (columns + 1) * (rows + 1), { 0, 0 }, {} };
  int x = 1, y = 1;
  Grid_point point = { 0, 0 };
  do
  {
    const bool is_corner = (x == 1 || x == columns - 1) && (y == 1 || y == rows - 1);
    const int vertex = x + (columns + 1) * y;
    if(is_corner || vertices_of_others.count(vertex) > 0)
      block.corners.push_back({ vertex, 0, point, is_corner ? 1 : 2 });
    if(x == columns - 1 && y == rows - 1)
      block.center = { 1 + static_cast<std::int64_t>(random() % (point[0] - 1)),
                       1 + static_cast<std::int64_t>(random() % (point[1] - 1)) };
    if(y == 1 && x + 1 < columns)
      point[0] += widths[x++];
    else if(x + 1 == columns && y + 1 < rows)
      point[1] += heights[y++];
    else if(y + 1 == rows && x > 1)
      point[0] -= widths[--x];
    else
      point[1] -= heights[--y];
  } while(x != 1 || y != 1);
  grid.blocks.push_back(block);
}

// Glued at the left and at the right, where `shift` rows are left out; also at the top and the bottom if `is_closed`.
Quad_grid ring(const int width, const int height, const int shift, const bool is_closed)
{
  Quad_grid grid;
  const auto vertex = [&](const int x, const int y)
  {
    const int row = y + (x == width ? shift : 0);
    return x % width + width * (is_closed ? row % height : row);
  };
  for(int x = 0; x < width; ++x)
    for(int y = 0; y < height; ++y)
    {
      grid.vertices.push_back({ vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1) });
      grid.sizes.push_back({ unit, unit });
    }
  return grid;
}

// The surface of a set of boxes in a grid of n^3.
Quad_grid polycube(const std::set<std::array<int, 3> >& boxes, const int n,
                   const std::array<std::vector<std::int64_t>, 3>& sizes)
{
  Quad_grid grid;
  for(const std::array<int, 3>& box : boxes)
    for(int axis = 0; axis < 3; ++axis)
      for(const int side : { 0, 1 })
      {
        std::array<int, 3> neighbor = box, corner = box;
        neighbor[axis] += 2 * side - 1;
        corner[axis] += side;
        if(boxes.count(neighbor) > 0)
          continue;
        const int b = (axis + (side == 1 ? 1 : 2)) % 3, c = (axis + (side == 1 ? 2 : 1)) % 3;
        std::array<int, 4> vertices;
        for(int i = 0; i < 4; ++i)
        {
          std::array<int, 3> p = corner;
          p[b] += i == 1 || i == 2 ? 1 : 0;
          p[c] += i >= 2 ? 1 : 0;
          vertices[i] = p[0] + (n + 1) * (p[1] + (n + 1) * p[2]);
        }
        grid.vertices.push_back(vertices);
        grid.sizes.push_back({ sizes[b][box[b]], sizes[c][box[c]] });
      }
  return grid;
}

Quad_grid box(const int x, const int y, const int z)
{
  std::set<std::array<int, 3> > boxes;
  for(int i = 0; i < x * y * z; ++i)
    boxes.insert({ i % x, i / x % y, i / (x * y) });
  const int n = (std::max)({ x, y, z });
  return polycube(boxes, n, { equal_sizes(n), equal_sizes(n), equal_sizes(n) });
}

bool is_manifold(const Quad_grid& grid)
{
  std::set<std::pair<int, int> > edges;
  for(const std::array<int, 4>& v : grid.vertices)
    for(int i = 0; i < 4; ++i)
      if(!edges.insert({ v[i], v[(i + 1) % 4] }).second)
        return false;
  return true;
}

void constrain_some_sides(Quad_grid& grid, const unsigned int one_of, std::mt19937& random)
{
  for(const std::array<int, 4>& v : grid.vertices)
    for(int i = 0; i < 4; ++i)
      if(random() % one_of == 0)
        grid.constrain(v[i], v[(i + 1) % 4]);
}

void mark_some_nodes(Grid_map& grid, const unsigned int one_of, std::mt19937& random)
{
  for(char& is_node : grid.is_arc_node)
    is_node = random() % one_of == 0;
}

int source(const T_mesh& mesh, const Directed_piece& p)
{
  return p.is_reversed ? mesh.pieces[p.piece].target : mesh.pieces[p.piece].source;
}

int target(const T_mesh& mesh, const Directed_piece& p)
{
  return p.is_reversed ? mesh.pieces[p.piece].source : mesh.pieces[p.piece].target;
}

std::int64_t length(const T_mesh& mesh, const std::vector<Directed_piece>& side)
{
  std::int64_t result = 0;
  for(const Directed_piece& p : side)
    result += mesh.pieces[p.piece].parametric_length;
  return result;
}

int quads_at(const Grid_map& grid, const T_mesh_node& node)
{
  if(node.sector < 0)
    return node.halfedge >= 0 ? 2 : 4;
  return (grid.surface.is_constrained_sector(node.sector) ? 2 : 4) - grid.index[node.sector];
}

// What holds of every T-mesh.
void expect_rectangles(const Grid_map& grid, const T_mesh& mesh)
{
  std::vector<int> quads(mesh.nodes.size(), 0);
  std::vector<std::array<int, 2> > uses(mesh.pieces.size(), { 0, 0 });
  for(const T_mesh_cell& cell : mesh.cells)
  {
    for(int side = 0; side < 4; ++side)
    {
      ASSERT_FALSE(cell.sides[side].empty());
      EXPECT_EQ(length(mesh, cell.sides[side]), length(mesh, cell.sides[(side + 2) % 4]));
      const std::vector<Directed_piece>& next_side = cell.sides[(side + 1) % 4];
      for(std::size_t i = 0; i < cell.sides[side].size(); ++i)
      {
        const Directed_piece& p = cell.sides[side][i];
        const bool is_last = i + 1 == cell.sides[side].size();
        EXPECT_EQ(target(mesh, p), source(mesh, is_last ? next_side[0] : cell.sides[side][i + 1]));
        quads[target(mesh, p)] += is_last ? 1 : 2;
        ++uses[p.piece][p.is_reversed];
      }
    }
  }
  for(std::size_t n = 0; n < mesh.nodes.size(); ++n)
    EXPECT_EQ(quads_at(grid, mesh.nodes[n]), quads[n]);
  for(std::size_t p = 0; p < mesh.pieces.size(); ++p)
  {
    EXPECT_EQ(1, uses[p][0]);
    EXPECT_EQ(mesh.pieces[p].halfedge >= 0 ? 0 : 1, uses[p][1]);
    const double expected_length = static_cast<double>(mesh.pieces[p].parametric_length) / unit;
    EXPECT_NEAR(expected_length, mesh.pieces[p].length, 1e-9 * expected_length);
  }
}

std::vector<std::int64_t> areas(const T_mesh& mesh)
{
  std::vector<std::int64_t> result;
  for(const T_mesh_cell& cell : mesh.cells)
    result.push_back(length(mesh, cell.sides[0]) * length(mesh, cell.sides[1]));
  return result;
}

std::vector<T_mesh> t_meshes(const Grid_map& grid)
{
  std::vector<T_mesh> result;
  for(const Patch& patch : grid.surface.patches)
  {
    const T_mesh_result r = make_T_mesh(grid.surface, patch, grid.index, grid.map, grid.is_arc_node);
    EXPECT_EQ(T_mesh_status::COMPLETE, r.status);
    expect_rectangles(grid, r.mesh);
    result.push_back(r.mesh);
  }
  return result;
}

std::size_t number_of_cells(const std::vector<T_mesh>& meshes)
{
  std::size_t result = 0;
  for(const T_mesh& mesh : meshes)
    result += mesh.cells.size();
  return result;
}

std::size_t number_of_nodes_without_sector(const std::vector<T_mesh>& meshes)
{
  std::size_t result = 0;
  for(const T_mesh& mesh : meshes)
    for(const T_mesh_node& node : mesh.nodes)
      result += node.sector < 0 ? 1 : 0;
  return result;
}

void expect_cells_of_simulation(const Quad_grid& quads, const Grid_map& grid, const std::vector<T_mesh>& meshes)
{
  std::vector<std::int64_t> found;
  for(const T_mesh& mesh : meshes)
    for(const std::int64_t area : areas(mesh))
      found.push_back(area);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(Motorcycle_simulation(quads, grid).areas_of_cells(), found);
}

void expect_equal(const T_mesh& a, const T_mesh& b)
{
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  ASSERT_EQ(a.cells.size(), b.cells.size());
  for(std::size_t i = 0; i < a.nodes.size(); ++i)
  {
    EXPECT_EQ(a.nodes[i].sector, b.nodes[i].sector);
    EXPECT_EQ(a.nodes[i].halfedge, b.nodes[i].halfedge);
    EXPECT_EQ(a.nodes[i].face, b.nodes[i].face);
  }
  for(std::size_t i = 0; i < a.pieces.size(); ++i)
  {
    EXPECT_EQ(a.pieces[i].source, b.pieces[i].source);
    EXPECT_EQ(a.pieces[i].target, b.pieces[i].target);
    EXPECT_EQ(a.pieces[i].parametric_length, b.pieces[i].parametric_length);
    EXPECT_EQ(a.pieces[i].halfedge, b.pieces[i].halfedge);
    EXPECT_NEAR(a.pieces[i].length, b.pieces[i].length, 1e-12 * a.pieces[i].length);
  }
  for(std::size_t i = 0; i < a.cells.size(); ++i)
  {
    EXPECT_EQ(a.cells[i].face, b.cells[i].face);
    for(int side = 0; side < 4; ++side)
    {
      ASSERT_EQ(a.cells[i].sides[side].size(), b.cells[i].sides[side].size());
      for(std::size_t k = 0; k < a.cells[i].sides[side].size(); ++k)
      {
        EXPECT_EQ(a.cells[i].sides[side][k].piece, b.cells[i].sides[side][k].piece);
        EXPECT_EQ(a.cells[i].sides[side][k].is_reversed, b.cells[i].sides[side][k].is_reversed);
      }
    }
  }
}

// The T-mesh of a grid must not depend on where the vertices are that are no nodes, nor on the charts.
void expect_consistent(const Quad_grid& quads, Grid_map grid, std::mt19937& random)
{
  set_lengths(grid, unit);
  expect_cells_of_simulation(quads, grid, t_meshes(grid));
  for(const bool also_near_nodes : { false, true })
  {
    for(int round = 0; round < 3; ++round)
      move_vertices(grid, unit, also_near_nodes, random);
    set_lengths(grid, unit);
    const std::vector<T_mesh> meshes = t_meshes(grid);
    if(!also_near_nodes) // otherwise the ports of a sector may be in another order, which decides between them
      expect_cells_of_simulation(quads, grid, meshes);
    change_charts(grid, 38, random);
    const std::vector<T_mesh> meshes_in_other_charts = t_meshes(grid);
    for(std::size_t i = 0; i < meshes.size(); ++i)
      expect_equal(meshes[i], meshes_in_other_charts[i]);
  }
}

struct Layout
{
  std::size_t cells, nodes_without_sector;
};

Layout layout(const Quad_grid& quads)
{
  std::mt19937 random(1);
  Grid_map grid = grid_map(quads, random);
  set_lengths(grid, unit);
  const std::vector<T_mesh> meshes = t_meshes(grid);
  expect_consistent(quads, grid, random);
  return { number_of_cells(meshes), number_of_nodes_without_sector(meshes) };
}

Pixels pixels(const std::vector<const char*>& rows)
{
  Pixels result;
  for(const char* row : rows)
  {
    result.push_back({});
    for(; *row != 0; ++row)
      result.back().push_back(*row == 'x');
  }
  return result;
}

Quad_grid drawn(const std::vector<const char*>& rows)
{
  const Pixels domain = pixels(rows);
  return planar_domain(domain, equal_sizes(domain.size()), equal_sizes(domain[0].size()));
}

TEST(T_mesh, known_layouts)
{
  EXPECT_EQ(1u, layout(rectangle(4, 3)).cells);
  EXPECT_EQ(1u, layout(rectangle(1, 1)).cells);
  EXPECT_EQ(3u, layout(drawn({ "xxxx", "xxxx", "xx..", "xx.." })).cells);
  EXPECT_EQ(8u, layout(drawn({ "xxx", "x.x", "xxx" })).cells);
  EXPECT_EQ(6u, layout(box(3, 3, 3)).cells);
  EXPECT_EQ(6u, layout(box(1, 2, 4)).cells);
  EXPECT_EQ(1u, layout(ring(5, 3, 0, false)).cells);
  EXPECT_EQ(1u, layout(ring(4, 3, 0, true)).cells);
}

TEST(T_mesh, disk_with_four_cones)
{
  Quad_grid quads = box(3, 3, 3);
  Quad_grid open;
  for(std::size_t q = 0; q < quads.vertices.size(); ++q)
  {
    const std::array<int, 4>& v = quads.vertices[q];
    if(std::any_of(v.begin(), v.end(), [](const int vertex) { return vertex >= 16; })) // not the bottom
    {
      open.vertices.push_back(v);
      open.sizes.push_back(quads.sizes[q]);
    }
  }
  EXPECT_EQ(5u, layout(open).cells);
}

TEST(T_mesh, boundary_of_an_annulus_gets_one_virtual_port)
{
  std::mt19937 random(1);
  Grid_map grid = grid_map(ring(6, 2, 0, false), random);
  set_lengths(grid, unit);
  const T_mesh mesh = t_meshes(grid)[0];
  ASSERT_EQ(3u, mesh.pieces.size());
  EXPECT_EQ(2u, mesh.nodes.size());
  std::vector<std::int64_t> lengths;
  for(const T_mesh_piece& piece : mesh.pieces)
    lengths.push_back(piece.parametric_length / unit);
  std::sort(lengths.begin(), lengths.end());
  EXPECT_EQ((std::vector<std::int64_t>{ 2, 6, 6 }), lengths);

  // Where an arc has a node, the port is there, and no further node comes about.
  for(int s = 0; s < grid.surface.number_of_sectors(); ++s)
    if(grid.surface.is_constrained_sector(s))
    {
      grid.is_arc_node[s] = 1;
      const T_mesh mesh_with_node = t_meshes(grid)[0];
      EXPECT_EQ(3u, mesh_with_node.pieces.size());
      EXPECT_EQ(2u, mesh_with_node.nodes.size());
      grid.is_arc_node[s] = 0;
    }
}

// Lines that do not close after one turn are ended by the perpendicular ones.
TEST(T_mesh, twisted_tori)
{
  std::mt19937 random(3);
  for(int width = 3; width < 7; ++width)
    for(int height = 3; height < 7; ++height)
      for(int shift = 0; shift < height; ++shift)
      {
        const Quad_grid quads = ring(width, height, shift, true);
        expect_consistent(quads, grid_map(quads, random), random);
      }
}

TEST(T_mesh, random_planar_domains)
{
  std::mt19937 random(4);
  for(int repetition = 0; repetition < 300; ++repetition)
  {
    const std::size_t width = 1 + random() % 8, height = 1 + random() % 8;
    Pixels domain(width, std::vector<bool>(height));
    for(std::vector<bool>& column : domain)
      for(std::size_t y = 0; y < height; ++y)
        column[y] = random() % 5 != 0;
    const bool is_generic = random() % 2 == 0;
    Quad_grid quads = planar_domain(domain, random_sizes(width, is_generic, random),
                                    random_sizes(height, is_generic, random));
    if(random() % 2 == 0)
      constrain_some_sides(quads, 12, random);
    Grid_map grid = grid_map(quads, random);
    if(random() % 2 == 0)
      mark_some_nodes(grid, 5, random);
    expect_consistent(quads, grid, random);
  }
}

// Traces from notches in the walls of a room run through few faces. They cross at different times, since no two lengths
// are equal.
TEST(T_mesh, rooms_with_notches)
{
  std::mt19937 random(10);
  for(int repetition = 0; repetition < 300; ++repetition)
  {
    const std::size_t width = 3 + random() % 12, height = 3 + random() % 12;
    Pixels domain(width, std::vector<bool>(height, true));
    for(std::size_t x = 0; x < width; ++x)
      for(std::size_t y = 0; y < height; ++y)
      {
        const bool is_at_side = x == 0 || x + 1 == width, is_at_end = y == 0 || y + 1 == height;
        if(is_at_side || is_at_end)
          domain[x][y] = is_at_side != is_at_end && random() % 3 == 0;
      }
    const std::vector<std::int64_t> widths = random_sizes(width, true, random);
    const std::vector<std::int64_t> heights = random_sizes(height, true, random);
    const Quad_grid fine = planar_domain(domain, widths, heights);
    Quad_grid coarse = fine;
    make_room(coarse, widths, heights, random);
    Grid_map grid = grid_map(coarse, random);
    change_charts(grid, 30, random);
    set_lengths(grid, unit);
    expect_cells_of_simulation(fine, grid_map(fine, random), t_meshes(grid));
  }
}

TEST(T_mesh, random_polycubes)
{
  std::mt19937 random(5);
  int number_of_polycubes = 0;
  while(number_of_polycubes < 150)
  {
    const int n = 1 + static_cast<int>(random() % 4);
    std::set<std::array<int, 3> > boxes;
    for(int i = 0; i < n * n * n; ++i)
      if(random() % 4 != 0)
        boxes.insert({ i % n, i / n % n, i / (n * n) });
    const bool is_generic = random() % 2 == 0;
    const auto sizes = [&] { return random_sizes(n, is_generic, random); };
    const std::array<std::vector<std::int64_t>, 3> all_sizes = { sizes(), sizes(), sizes() };
    Quad_grid quads = polycube(boxes, n, all_sizes);
    if(boxes.empty() || !is_manifold(quads))
      continue;
    ++number_of_polycubes;
    if(random() % 2 == 0)
      constrain_some_sides(quads, 5, random);
    Grid_map grid = grid_map(quads, random);
    if(random() % 2 == 0)
      mark_some_nodes(grid, 5, random);
    expect_consistent(quads, grid, random);
  }
}

// In the plane all charts are parts of one: cells cover the domain, each point once, and start where they say.
TEST(T_mesh, cells_lie_where_they_say)
{
  std::mt19937 random(6);
  for(int repetition = 0; repetition < 50; ++repetition)
  {
    Pixels domain(6, std::vector<bool>(6));
    for(std::vector<bool>& column : domain)
      for(std::size_t y = 0; y < 6; ++y)
        column[y] = random() % 4 != 0;
    Quad_grid quads = planar_domain(domain, equal_sizes(6), equal_sizes(6));
    constrain_some_sides(quads, 20, random);
    Grid_map grid = grid_map(quads, random);
    // The chart of the plane is the one in which the rectangle has its place.
    for(int f = 0; f < grid.surface.number_of_faces(); ++f)
    {
      const int corner = quads.vertices[grid.quad[f]][0];
      grid.chart_shift[f] = { -(corner % 7) * unit, -(corner / 7) * unit };
    }
    for(int round = 0; round < 3; ++round)
      move_vertices(grid, unit, true, random);
    change_charts(grid, 30, random);
    set_lengths(grid, unit);
    const auto in_plane = [&](const int face, const Grid_point& p)
    {
      return turned(difference(p, grid.chart_shift[face]), -grid.chart_turns[face]);
    };
    std::array<std::array<int, 6>, 6> covered = {};
    for(const T_mesh& mesh : t_meshes(grid))
      for(const T_mesh_cell& cell : mesh.cells)
      {
        const T_mesh_node& first = mesh.nodes[source(mesh, cell.sides[0][0])];
        const T_mesh_node& second = mesh.nodes[target(mesh, cell.sides[0].back())];
        const Grid_point start = in_plane(first.face, { first.u, first.v });
        const Grid_point end = in_plane(second.face, { second.u, second.v });
        const int turns = cell.quarter_turns - grid.chart_turns[cell.face];
        EXPECT_EQ(sum(start, turned({ length(mesh, cell.sides[0]), 0 }, turns)), end);

        // A point a bit to the left of the begin of side 0 lies in the face.
        const Grid_point inside = sum(turned(start, grid.chart_turns[cell.face]), grid.chart_shift[cell.face]);
        for(int h = 3 * cell.face; h < 3 * cell.face + 3; ++h)
        {
          const Grid_point edge = difference(grid.point(h), grid.point(previous_of(h)));
          const auto cross = [&](const Grid_point& a) { return edge[0] * a[1] - edge[1] * a[0]; };
          const Grid_point ahead = turned({ 1, 0 }, cell.quarter_turns), left = turned(ahead, 1);
          const std::array<std::int64_t, 3> signs = { cross(difference(inside, grid.point(h))), cross(ahead),
                                                      cross(left) };
          EXPECT_GT(signs, (std::array<std::int64_t, 3>{ 0, 0, 0 })); // lexicographically
        }

        const Grid_point diagonal = turned({ length(mesh, cell.sides[0]), length(mesh, cell.sides[1]) }, turns);
        const Grid_point opposite = sum(start, diagonal);
        for(std::int64_t x = (std::min)(start[0], opposite[0]) / unit;
            x < (std::max)(start[0], opposite[0]) / unit; ++x)
          for(std::int64_t y = (std::min)(start[1], opposite[1]) / unit;
              y < (std::max)(start[1], opposite[1]) / unit; ++y)
            ++covered[x][y];
      }
    for(int x = 0; x < 6; ++x)
      for(int y = 0; y < 6; ++y)
        EXPECT_EQ(domain[x][y] ? 1 : 0, covered[x][y]);
  }
}

TEST(T_mesh, says_what_is_wrong)
{
  std::mt19937 random(7);
  Grid_map grid = grid_map(drawn({ "xxxx", "xxxx", "xx..", "xx.." }), random);
  set_lengths(grid, unit);
  const auto status = [&]
  {
    return make_T_mesh(grid.surface, grid.surface.patches[0], grid.index, grid.map, grid.is_arc_node).status;
  };
  EXPECT_EQ(T_mesh_status::COMPLETE, status());
  grid.map.status[0] = Map_status::INVERTED_FACE;
  EXPECT_EQ(T_mesh_status::NOT_CERTIFIED, status());
  grid.map.status[0] = Map_status::CERTIFIED;
  for(int s = 0; s < grid.surface.number_of_sectors(); ++s)
  {
    ++grid.index[s];
    EXPECT_EQ(T_mesh_status::COMPLETE == status(), false);
    --grid.index[s];
  }
}

// Whatever the map is, the call returns, and what it calls complete consists of rectangles.
TEST(T_mesh, survives_maps_that_only_seem_certified)
{
  std::mt19937 random(8);
  for(int repetition = 0; repetition < 300; ++repetition)
  {
    Grid_map grid = grid_map(repetition % 2 == 0 ? box(3, 2, 2) : ring(5, 4, 0, random() % 2 == 0), random);
    set_lengths(grid, unit);
    const std::uint32_t faults = 1 + random() % 20;
    for(std::uint32_t i = 0; i < faults; ++i)
    {
      const int h = static_cast<int>(random() % grid.surface.number_of_halfedges());
      if(random() % 3 == 0)
        grid.map.quarter_turns[h] = static_cast<unsigned char>(random() % 4);
      else if(random() % 2 == 0)
        grid.set_point(h, sum(grid.point(h), { unit * (std::int64_t(random() % 5) - 2), std::int64_t(random() % 2) }));
      else
        grid.index[grid.surface.sector[h]] = static_cast<int>(random() % 9) - 4;
    }
    const T_mesh_result r =
      make_T_mesh(grid.surface, grid.surface.patches[0], grid.index, grid.map, grid.is_arc_node);
    EXPECT_EQ(r.status == T_mesh_status::COMPLETE, !r.mesh.cells.empty());
    for(const T_mesh_cell& cell : r.mesh.cells)
      EXPECT_EQ(length(r.mesh, cell.sides[0]), length(r.mesh, cell.sides[2]));
  }
}

TEST(T_mesh, signs_of_determinants_are_exact)
{
  std::mt19937_64 random(9);
  const std::int64_t largest = std::int64_t(1) << 61;
  for(int i = 0; i < 10000; ++i)
  {
    // (a + k) (b - k) - a b = k (b - a - k), with factors far apart in size
    const int bits = static_cast<int>(random() % 61);
    const std::int64_t a = static_cast<std::int64_t>(random() % largest) >> bits;
    const std::int64_t b = static_cast<std::int64_t>(random() % largest) >> (random() % 61);
    const std::int64_t k = static_cast<std::int64_t>(random() % 3);
    const std::int64_t factor = b - a - k;
    const int expected = k == 0 || factor == 0 ? 0 : factor > 0 ? 1 : -1;
    EXPECT_EQ(expected, sign_of_determinant(a + k, a, b, b - k));
    EXPECT_EQ(-expected, sign_of_determinant(-(a + k), a, -b, b - k));
    EXPECT_EQ(-expected, sign_of_determinant(a, a + k, b - k, b));
    const double value = static_cast<double>(k) * static_cast<double>(factor);
    EXPECT_NEAR(value, CGAL::Frame_fields::internal::to_double(wide_determinant(a + k, a, b, b - k)),
                1e-15 * std::abs(value));
  }
}

} // namespace
