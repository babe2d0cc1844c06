#include <CGAL/Frame_fields/quad_mesh_blocks.h>
#include <CGAL/Frame_fields/quad_mesh_quality.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

// The figures and the blocks of quad meshes that are a mesh class.
namespace {

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
namespace FF = CGAL::Frame_fields;

struct Cube
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> features;

  // The faces of a cube of the given side, each of n x n quads.
  Cube(const int n, const double side)
  {
    features = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
    std::vector<Mesh::Vertex_index> vertex_at((n + 1) * (n + 1) * (n + 1));
    const auto vertex = [&](const int x, const int y, const int z)
    {
      Mesh::Vertex_index& v = vertex_at[(x * (n + 1) + y) * (n + 1) + z];
      if(v == Mesh::null_vertex())
        v = mesh.add_vertex(Point(side * x / n, side * y / n, side * z / n));
      return v;
    };
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
      {
        mesh.add_face(vertex(i, j, 0), vertex(i, j + 1, 0), vertex(i + 1, j + 1, 0), vertex(i + 1, j, 0));
        mesh.add_face(vertex(i, j, n), vertex(i + 1, j, n), vertex(i + 1, j + 1, n), vertex(i, j + 1, n));
        mesh.add_face(vertex(i, 0, j), vertex(i + 1, 0, j), vertex(i + 1, 0, j + 1), vertex(i, 0, j + 1));
        mesh.add_face(vertex(i, n, j), vertex(i, n, j + 1), vertex(i + 1, n, j + 1), vertex(i + 1, n, j));
        mesh.add_face(vertex(0, i, j), vertex(0, i, j + 1), vertex(0, i + 1, j + 1), vertex(0, i + 1, j));
        mesh.add_face(vertex(n, i, j), vertex(n, i + 1, j), vertex(n, i + 1, j + 1), vertex(n, i, j + 1));
      }
    for(const Mesh::Edge_index e : mesh.edges())
    {
      const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
      int number_of_sides = 0; // of the cube that both ends are on
      for(int k = 0; k < 3; ++k)
        number_of_sides += p[k] == q[k] && (p[k] == 0 || p[k] == side);
      features[e] = number_of_sides == 2;
    }
  }
};

TEST(Quad_mesh_quality, cube_with_and_without_its_features)
{
  for(const double side : { 1., 1e-200, 1e200 })
  {
    const Cube cube(4, side);
    FF::Quad_quality quality;
    ASSERT_TRUE(FF::quad_mesh_quality(cube.mesh, FF::parameters::quality(std::ref(quality))));
    EXPECT_EQ(quality.number_of_quads, 96u);
    EXPECT_EQ(quality.number_of_other_faces, 0u);
    EXPECT_NEAR(quality.minimum_scaled_jacobian, 1, 1e-15);
    EXPECT_NEAR(quality.mean_scaled_jacobian, 1, 1e-15);
    EXPECT_EQ(quality.number_of_irregular_vertices, 8u); // the corners
    EXPECT_EQ(quality.number_of_irregular_sectors, 0u);
    EXPECT_NEAR(quality.minimum_edge_length, side / 4, 1e-15 * side);
    EXPECT_NEAR(quality.mean_edge_length, side / 4, 1e-15 * side);
    EXPECT_NEAR(quality.maximum_edge_length, side / 4, 1e-15 * side);
    ASSERT_TRUE(FF::quad_mesh_quality(
      cube.mesh, FF::parameters::edge_is_constrained_map(cube.features).quality(std::ref(quality))));
    EXPECT_EQ(quality.number_of_irregular_vertices, 0u);
    EXPECT_EQ(quality.number_of_irregular_sectors, 0u);
  }
}

// A pyramid over a square that is cut off at the border: four triangles and one quad that is not convex.
TEST(Quad_mesh_quality, bad_quads_and_other_faces)
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(2, 0, 0));
  const auto c = mesh.add_vertex(Point(0.5, 0.5, 0)), d = mesh.add_vertex(Point(0, 2, 0));
  const auto e = mesh.add_vertex(Point(2, 2, 0));
  mesh.add_face(a, b, c, d);
  mesh.add_face(b, e, c);
  mesh.add_face(c, e, d);
  FF::Quad_quality quality;
  ASSERT_TRUE(FF::quad_mesh_quality(mesh, FF::parameters::quality(std::ref(quality))));
  EXPECT_EQ(quality.number_of_quads, 1u);
  EXPECT_EQ(quality.number_of_other_faces, 2u);
  EXPECT_EQ(quality.number_of_inverted_quads, 1u);
  EXPECT_EQ(quality.number_of_bad_quads, 1u);
  EXPECT_NEAR(quality.minimum_scaled_jacobian, (0.25 - 2.25) / 2.5, 1e-15);
  EXPECT_EQ(quality.number_of_irregular_vertices, 1u); // c
  EXPECT_NEAR(quality.minimum_edge_length, std::sqrt(2.5), 1e-15);
}

TEST(Quad_mesh_quality, what_is_not_finite_is_refused)
{
  Cube cube(2, 1);
  cube.mesh.point(*cube.mesh.vertices().begin()) = Point(0, std::numeric_limits<double>::infinity(), 0);
  FF::Quad_quality quality;
  quality.number_of_quads = 7;
  EXPECT_EQ(FF::quad_mesh_quality(cube.mesh, FF::parameters::quality(std::ref(quality))).error_code,
            FF::ERROR_NON_FINITE_COORDINATE);
  EXPECT_EQ(quality.number_of_quads, 7u);
  ASSERT_TRUE(FF::quad_mesh_quality(Mesh(), FF::parameters::quality(std::ref(quality))));
  EXPECT_EQ(quality.number_of_quads, 0u);
  EXPECT_EQ(quality.maximum_edge_length, 0);
}

// ---------------------------------------------------------------- blocks

typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Property_map<Edge, bool> Edge_flags;

struct Blocks
{
  std::map<Face, int> block;
  std::set<Edge> border;
  std::vector<FF::Quad_block<Halfedge> > list;
};

Blocks blocks_of(const Mesh& mesh, const Edge_flags is_constrained, const FF::T_junctions t_junctions)
{
  Mesh copy = mesh;
  const auto block = copy.add_property_map<Face, int>("f:block", -7).first;
  const auto is_border = copy.add_property_map<Edge, bool>("e:border", false).first;
  Blocks result;
  std::size_t number_of_blocks = 0;
  const FF::Result success = FF::quad_mesh_blocks(
    mesh, block, FF::parameters::edge_is_constrained_map(is_constrained)
                   .t_junctions(t_junctions)
                   .edge_is_on_block_border_map(is_border)
                   .block_output_iterator(std::back_inserter(result.list))
                   .number_of_blocks(std::ref(number_of_blocks)));
  EXPECT_TRUE(success) << success.message;
  EXPECT_EQ(number_of_blocks, result.list.size());
  for(const Face f : mesh.faces())
    result.block[f] = block[f];
  for(const Edge e : mesh.edges())
    if(is_border[e])
      result.border.insert(e);
  return result;
}

// Walks through all blocks as their documentation says. They must be grids with all of their faces, and the edges on
// the border those around them.
void expect_grids(const Mesh& mesh, const Edge_flags is_constrained, const Blocks& blocks)
{
  std::vector<std::size_t> number_of_faces(blocks.list.size(), 0);
  int greatest = -1;
  for(const Face f : mesh.faces())
  {
    ASSERT_LE(blocks.block.at(f), greatest + 1); // numbered in the order of first faces
    greatest = (std::max)(greatest, blocks.block.at(f));
    ++number_of_faces.at(blocks.block.at(f));
  }
  for(std::size_t b = 0; b < blocks.list.size(); ++b)
  {
    const FF::Quad_block<Halfedge>& block = blocks.list[b];
    std::set<Face> walked;
    Halfedge first = block.halfedge;
    for(int row = 0; row < block.number_of_rows; ++row)
    {
      Halfedge h = first;
      for(int column = 0; column < block.number_of_columns; ++column)
      {
        ASSERT_EQ(blocks.block.at(mesh.face(h)), static_cast<int>(b));
        ASSERT_TRUE(walked.insert(mesh.face(h)).second);
        const bool is_outside[4] = { row == 0, column + 1 == block.number_of_columns, row + 1 == block.number_of_rows,
                                     column == 0 };
        for(const bool is_side_outside : is_outside)
        {
          ASSERT_EQ(blocks.border.count(mesh.edge(h)), std::size_t(is_side_outside));
          h = mesh.next(h);
        }
        if(column + 1 < block.number_of_columns)
          h = mesh.next(mesh.opposite(mesh.next(h)));
      }
      if(row + 1 < block.number_of_rows)
        first = mesh.opposite(mesh.next(mesh.next(first)));
    }
    ASSERT_EQ(walked.size(), number_of_faces[b]);
  }
  for(const Edge e : mesh.edges())
    if(is_constrained[e] || mesh.is_border(e))
    {
      ASSERT_TRUE(blocks.border.count(e));
    }
}

// The sectors around a vertex: for each the halfedges to it between two quads of the sector.
std::vector<std::vector<Halfedge> > inner_halfedges_of_sectors(const Mesh& mesh, const Edge_flags is_constrained,
                                                               const Vertex v)
{
  std::vector<std::vector<Halfedge> > result;
  for(const Halfedge first : CGAL::halfedges_around_target(v, mesh))
    if((is_constrained[mesh.edge(first)] || mesh.is_border(mesh.edge(first))) && !mesh.is_border(first))
    {
      result.emplace_back();
      for(Halfedge h = mesh.opposite(mesh.next(first)); !is_constrained[mesh.edge(h)] && !mesh.is_border(mesh.edge(h));
          h = mesh.opposite(mesh.next(h)))
        result.back().push_back(h);
    }
  return result;
}

// The least set of edges with those given, the border and constrained edges in which lines end at constrained edges
// only; or, if they go on there, only where lines go on in all directions. Looks at all vertices until nothing changes.
std::set<Edge> closed_under_lines(const Mesh& mesh, const Edge_flags is_constrained, std::set<Edge> lines,
                                  const bool go_on_at_constrained_edges)
{
  for(const Edge e : mesh.edges())
    if(is_constrained[e] || mesh.is_border(e))
      lines.insert(e);
  for(std::size_t number = 0; number != lines.size();)
  {
    number = lines.size();
    for(const Vertex v : mesh.vertices())
    {
      const auto around = CGAL::halfedges_around_target(v, mesh);
      const std::vector<Halfedge> h(around.begin(), around.end());
      const std::vector<std::vector<Halfedge> > sectors = inner_halfedges_of_sectors(mesh, is_constrained, v);
      const auto number_of_lines = std::count_if(h.begin(), h.end(), [&](const Halfedge g)
                                                 { return lines.count(mesh.edge(g)); });
      if(sectors.empty() && h.size() == 4)
      {
        for(int i = 0; i < 4; ++i)
          if(lines.count(mesh.edge(h[i])))
            lines.insert(mesh.edge(h[(i + 2) % 4]));
      }
      else if(sectors.empty() || go_on_at_constrained_edges)
      {
        // Two constrained edges, two quads or the outside between them, and no other line.
        const bool has_border = std::any_of(h.begin(), h.end(), [&](const Halfedge g) { return mesh.is_border(g); });
        const bool is_straight = number_of_lines == 2 && sectors.size() == (has_border ? 1 : 2)
                              && sectors.front().size() == 1 && sectors.back().size() == 1;
        if(!is_straight)
          for(const Halfedge g : h)
            lines.insert(mesh.edge(g));
      }
      else
        for(const std::vector<Halfedge>& sector : sectors)
          if(sector.size() > 1)
            for(const Halfedge g : sector)
              lines.insert(mesh.edge(g));
    }
  }
  return lines;
}

// Whether each component between lines has a face with lines along two sides that follow each other.
bool all_have_corners(const Mesh& mesh, const std::set<Edge>& lines)
{
  std::set<Face> seen;
  for(const Face first : mesh.faces())
  {
    if(!seen.insert(first).second)
      continue;
    bool has_corner = false;
    std::vector<Face> component(1, first);
    for(std::size_t i = 0; i < component.size(); ++i)
      for(const Halfedge h : CGAL::halfedges_around_face(mesh.halfedge(component[i]), mesh))
      {
        has_corner = has_corner || (lines.count(mesh.edge(h)) && lines.count(mesh.edge(mesh.next(h))));
        if(!lines.count(mesh.edge(h)) && seen.insert(mesh.face(mesh.opposite(h))).second)
          component.push_back(mesh.face(mesh.opposite(h)));
      }
    if(!has_corner)
      return false;
  }
  return true;
}

typedef std::array<std::size_t, 3> Counts; // of blocks, by where there may be T-junctions

bool includes(const std::set<Edge>& edges, const std::set<Edge>& part)
{
  return std::includes(edges.begin(), edges.end(), part.begin(), part.end());
}

// Checks all kinds of blocks of a mesh, and returns their numbers.
Counts checked_blocks(const Mesh& mesh, const Edge_flags is_constrained)
{
  std::array<Blocks, 3> blocks;
  Counts counts;
  for(const FF::T_junctions where :
      { FF::T_junctions::NONE, FF::T_junctions::ON_CONSTRAINED_EDGES, FF::T_junctions::EVERYWHERE })
  {
    const int i = static_cast<int>(where);
    blocks[i] = blocks_of(mesh, is_constrained, where);
    expect_grids(mesh, is_constrained, blocks[i]);
    counts[i] = blocks[i].list.size();
    if(where == FF::T_junctions::EVERYWHERE)
      continue;
    const bool go_on = where == FF::T_junctions::NONE;
    EXPECT_EQ(closed_under_lines(mesh, is_constrained, blocks[i].border, go_on), blocks[i].border);
    const std::set<Edge> least = closed_under_lines(mesh, is_constrained, {}, go_on);
    if(all_have_corners(mesh, least))
      EXPECT_EQ(blocks[i].border, least);
    else
      EXPECT_TRUE(includes(blocks[i].border, least));
  }
  if(all_have_corners(mesh, closed_under_lines(mesh, is_constrained, {}, false)))
  {
    EXPECT_TRUE(includes(blocks[0].border, blocks[1].border));
    EXPECT_TRUE(includes(blocks[1].border, blocks[2].border));
  }
  return counts;
}

// A surface of columns x rows quads, closed in one or both directions; the second one after so many steps in the first.
struct Sheet
{
  Mesh mesh;
  Edge_flags is_constrained = mesh.add_property_map<Edge, bool>("e:constrained", false).first;
  std::vector<Vertex> vertex;
  int columns, rows;

  Sheet(const int columns, const int rows, const bool is_ring, const bool is_torus, const int shift = 0,
        const std::function<bool(int, int)>& is_hole = [](int, int) { return false; })
    : columns(columns), rows(rows)
  {
    const int width = columns + !is_ring, height = rows + !is_torus;
    for(int i = 0; i < width * height; ++i)
      vertex.push_back(mesh.add_vertex(Point(i % width, i / width, 0)));
    const auto at = [&](const int i, const int j)
    {
      return vertex[(j % height) * width + (i + (j == height ? shift : 0)) % width];
    };
    for(int j = 0; j < rows; ++j)
      for(int i = 0; i < columns; ++i)
        if(!is_hole(i, j))
          mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }

  void constrain(const int v, const int w)
  {
    is_constrained[mesh.edge(mesh.halfedge(vertex[v], vertex[w]))] = true;
  }
};

TEST(Quad_mesh_blocks, cube)
{
  for(const int n : { 1, 5 })
  {
    Cube cube(n, 1);
    EXPECT_EQ(checked_blocks(cube.mesh, cube.features), (Counts{ 6, 6, 6 }));
    for(const Edge e : cube.mesh.edges())
      cube.features[e] = false;
    EXPECT_EQ(checked_blocks(cube.mesh, cube.features), (Counts{ 6, 6, 6 })); // lines run along its edges
  }
}

// Grids, and what has no corner: it is cut once, or twice in the case of a torus.
TEST(Quad_mesh_blocks, sheets)
{
  const auto counts = [](const Sheet& sheet) { return checked_blocks(sheet.mesh, sheet.is_constrained); };
  EXPECT_EQ(counts(Sheet(7, 4, false, false)), (Counts{ 1, 1, 1 }));
  EXPECT_EQ(counts(Sheet(7, 4, true, false)), (Counts{ 1, 1, 1 }));
  EXPECT_EQ(counts(Sheet(7, 4, true, true)), (Counts{ 1, 1, 1 }));
  // Lines that close after three turns.
  EXPECT_EQ(counts(Sheet(9, 4, true, true, 3))[0], 3u);
  // Rings between constrained circles: a line across one goes on across the others.
  Sheet rings(6, 5, true, false);
  for(int i = 0; i < 6; ++i)
    for(const int j : { 1, 3 })
      rings.constrain(6 * j + i, 6 * j + (i + 1) % 6);
  EXPECT_EQ(counts(rings), (Counts{ 3, 3, 3 }));
  // A ring beside a notched one, from which lines go on only if blocks meet along whole sides.
  Sheet notched(6, 4, true, false, 0, [](const int i, const int j) { return i == 3 && j == 0; });
  for(int i = 0; i < 6; ++i)
    notched.constrain(6 * 2 + i, 6 * 2 + (i + 1) % 6);
  EXPECT_EQ(counts(notched), (Counts{ 5, 4, 4 }));
  const auto is_in_middle = [](const int i, const int j) { return i >= 2 && i < 5 && j >= 2 && j < 4; };
  EXPECT_EQ(counts(Sheet(7, 6, false, false, 0, is_in_middle)), (Counts{ 8, 8, 8 }));
  // The lines of two corners cross twice. With T-junctions, one of them ends each time.
  const auto is_outside = [](const int i, const int j) { return (i < 2 && j < 2) || (i >= 4 && j >= 4); };
  EXPECT_EQ(counts(Sheet(6, 6, false, false, 0, is_outside)), (Counts{ 7, 7, 5 }));
  // A feature that ends inside.
  Sheet loose(6, 6, false, false);
  loose.constrain(3, 3 + 7);
  loose.constrain(3 + 7, 3 + 14);
  EXPECT_EQ(counts(loose), (Counts{ 4, 4, 4 }));
  Mesh none;
  EXPECT_EQ(checked_blocks(none, none.add_property_map<Edge, bool>("e:constrained", false).first), (Counts{ 0, 0, 0 }));
}

// Vertices that are no nodes but for the number of their sectors: with T-junctions, no lines start there.
TEST(Quad_mesh_blocks, sectors_of_two_quads)
{
  for(const int sectors : { 1, 2, 3 })
  {
    Mesh mesh;
    const int n = 2 * sectors; // quads around a vertex
    std::vector<Vertex> v;
    for(int i = 0; i <= 2 * n; ++i)
      v.push_back(mesh.add_vertex(Point(i, 0, 0)));
    for(int i = 0; i < n; ++i)
      mesh.add_face(v[0], v[1 + 2 * i], v[2 + 2 * i], v[1 + 2 * (i + 1) % (2 * n)]);
    const Edge_flags is_constrained = mesh.add_property_map<Edge, bool>("e:constrained", false).first;
    for(int i = 0; i < n; i += 2)
      is_constrained[mesh.edge(mesh.halfedge(v[0], v[1 + 2 * i]))] = true;
    const std::size_t number = sectors;
    EXPECT_EQ(checked_blocks(mesh, is_constrained),
              (Counts{ sectors == 2 ? number : 2 * number, number, number }));
  }
}

// Sheets with random holes, of which many touch in a vertex, and random features, many with loose ends. Some of their
// faces are divided into three or four quads each, around new irregular vertices.
TEST(Quad_mesh_blocks, of_random_sheets)
{
  Counts sums{ 0, 0, 0 };
  for(int seed = 0; seed < 300; ++seed)
  {
    std::mt19937 random(seed);
    const auto below = [&](const int n) { return static_cast<int>(random() % n); };
    const int columns = 3 + below(6), rows = 3 + below(6), shape = below(3), shift = below(3);
    const int hole = below(2) ? 0 : 1 + below(8), feature = below(3) ? 1 + below(12) : 0;
    Sheet sheet(columns, rows, shape > 0, shape > 1, shift, [&](int, int) { return below(40) < hole; });
    Mesh mesh = sheet.mesh;
    const Edge_flags is_constrained = mesh.add_property_map<Edge, bool>("e:constrained", false).first;
    if(below(2))
    {
      // Triangulates some faces, then divides all faces from their middles to the middles of their sides.
      Mesh polygons;
      for(const Vertex v : mesh.vertices())
        polygons.add_vertex(mesh.point(v));
      for(const Face f : mesh.faces())
      {
        std::vector<Vertex> v;
        for(const Vertex w : mesh.vertices_around_face(mesh.halfedge(f)))
          v.push_back(w);
        if(below(4))
          polygons.add_face(v);
        else
        {
          polygons.add_face(v[0], v[1], v[2]);
          polygons.add_face(v[0], v[2], v[3]);
        }
      }
      mesh.clear_without_removing_property_maps();
      for(std::size_t i = 0; i < polygons.number_of_vertices() + polygons.number_of_edges(); ++i)
        mesh.add_vertex(Point(0, 0, 0));
      const auto middle = [&](const Halfedge h)
      {
        return Vertex(static_cast<Mesh::size_type>(polygons.number_of_vertices() + polygons.edge(h).idx()));
      };
      for(const Face f : polygons.faces())
      {
        const Vertex center = mesh.add_vertex(Point(0, 0, 0));
        for(const Halfedge h : CGAL::halfedges_around_face(polygons.halfedge(f), polygons))
          mesh.add_face(middle(h), polygons.target(h), middle(polygons.next(h)), center);
      }
    }
    for(const Edge e : mesh.edges())
      is_constrained[e] = below(60) < feature;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Counts counts = checked_blocks(mesh, is_constrained);
    for(int i = 0; i < 3; ++i)
      sums[i] += counts[i];
    if(HasFatalFailure() || HasNonfatalFailure())
      return;
  }
  EXPECT_LT(sums[1], sums[0]);
  EXPECT_LT(sums[2], sums[1]);
}

TEST(Quad_mesh_blocks, of_a_polyhedron_and_without_optional_outputs)
{
  CGAL::Polyhedron_3<CGAL::Simple_cartesian<double> > mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 1, 1), Point(0, 0, 1),
                        Point(1, 0, 1), Point(1, 1, 1), mesh);
  const auto block = get(CGAL::dynamic_face_property_t<int>(), mesh);
  ASSERT_TRUE(FF::quad_mesh_blocks(mesh, block));
  int number = 0;
  for(const auto f : faces(mesh))
    EXPECT_EQ(get(block, f), number++);
}

TEST(Quad_mesh_blocks, refuse_other_faces_and_write_nothing)
{
  Sheet sheet(2, 1, false, false);
  const Vertex v = sheet.mesh.add_vertex(Point(3, 1, 0));
  sheet.mesh.add_face(sheet.vertex[2], v, sheet.vertex[5]);
  const auto block = sheet.mesh.add_property_map<Face, int>("f:block", -7).first;
  const Edge_flags is_border = sheet.mesh.add_property_map<Edge, bool>("e:border", true).first;
  std::vector<FF::Quad_block<Halfedge> > list;
  std::size_t number = 77;
  const FF::Result result = FF::quad_mesh_blocks(
    sheet.mesh, block, FF::parameters::edge_is_on_block_border_map(is_border)
                         .block_output_iterator(std::back_inserter(list)).number_of_blocks(std::ref(number)));
  EXPECT_EQ(result.error_code, FF::ERROR_NON_QUADRANGULAR_MESH);
  EXPECT_NE(result.message.find("face 2 of faces(qm), which has a vertex at (2, "), std::string::npos)
    << result.message;
  for(const Face f : sheet.mesh.faces())
    EXPECT_EQ(block[f], -7);
  for(const Edge e : sheet.mesh.edges())
    EXPECT_TRUE(is_border[e]);
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(number, 77u);
}

} // namespace
