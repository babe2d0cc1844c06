#include "../../examples/Frame_fields/programs/shared/soup/Near_borders.h"
#include "../../examples/Frame_fields/programs/shared/soup/Polygon_triangulator.h"
#include "../../examples/Frame_fields/programs/shared/soup/Triangle_surface.h"
#include "../../examples/Frame_fields/programs/shared/soup/build_mesh.h"
#include "../../examples/Frame_fields/programs/shared/soup/close_cracks.h"
#include "../../examples/Frame_fields/programs/shared/soup/first_at_each_place.h"
#include "../../examples/Frame_fields/programs/shared/soup/is_triangle_manifold.h"
#include "../../examples/Frame_fields/programs/shared/soup/remove_duplicates.h"
#include "../../examples/Frame_fields/programs/shared/soup/triangulate_soup.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// What the programs do between the polygons of a file and the mesh.
namespace {

typedef std::vector<std::size_t> Ring;
typedef std::array<long long, 2> Place_in_plane; // integers, so that products of differences are exact
typedef std::vector<Place_in_plane> Places_in_plane;

long long area_of(const Place_in_plane& a, const Place_in_plane& b, const Place_in_plane& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// A plane in space with integer coordinates, which is not upright to the one or other pair of axes.
struct Plane
{
  std::array<long long, 3> u, v;

  std::vector<Point> points(const Places_in_plane& places) const
  {
    std::vector<Point> result;
    for(const Place_in_plane& p : places)
      result.emplace_back(p[0] * u[0] + p[1] * v[0], p[0] * u[1] + p[1] * v[1], p[0] * u[2] + p[1] * v[2]);
    return result;
  }
};

const std::vector<Plane> planes = { { { 1, 0, 0 }, { 0, 1, 0 } },  { { 0, 1, 0 }, { 1, 0, 0 } },
                                    { { 0, 1, 0 }, { 0, 0, 1 } },  { { 3, 0, 0 }, { 0, 0, 2 } },
                                    { { 1, 2, -3 }, { 4, 0, 1 } }, { { 1, 0, 1 }, { 0, 1, -7 } } };

typedef std::map<std::pair<std::size_t, std::size_t>, int> Chain;

void add_passes(const Ring& ring, Chain& chain)
{
  for(std::size_t k = 0; k < ring.size(); ++k)
  {
    const std::size_t a = ring[k], b = ring[(k + 1) % ring.size()];
    if(a != b)
      chain[std::minmax(a, b)] += a < b ? 1 : -1;
  }
}

// Triangles that are all oriented like the polygon, with the ring as their boundary, cover what it winds around once.
void expect_triangulation(const Places_in_plane& places, const Ring& ring, const std::vector<Triangle>& triangles)
{
  Chain expected, found;
  add_passes(ring, expected);
  long long area = 0, total = 0;
  for(std::size_t k = 1; k + 1 < ring.size(); ++k)
    area += area_of(places[ring[0]], places[ring[k]], places[ring[k + 1]]);
  for(const Triangle& t : triangles)
  {
    add_passes(Ring(t.begin(), t.end()), found);
    const long long part = area_of(places[t[0]], places[t[1]], places[t[2]]);
    EXPECT_GT(area > 0 ? part : -part, 0);
    total += part;
  }
  EXPECT_EQ(total, area);
  for(const auto& [edge, number] : expected)
    EXPECT_EQ(found[edge], number) << edge.first << " " << edge.second;
  for(const auto& [edge, number] : found)
    EXPECT_EQ(expected[edge], number) << edge.first << " " << edge.second;
}

// A triangulation in each plane, of the ring from other vertices on and backwards.
void expect_polygon(const Places_in_plane& places, Ring ring)
{
  for(const Plane& plane : planes)
  {
    const std::vector<Point> points = plane.points(places);
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    std::vector<Triangle> triangles;
    ASSERT_EQ(Polygon_triangulator(points)(ring, triangles), nullptr);
    expect_triangulation(places, ring, triangles);
    const Ring reversed(ring.rbegin(), ring.rend());
    triangles.clear();
    ASSERT_EQ(Polygon_triangulator(points)(reversed, triangles), nullptr);
    expect_triangulation(places, reversed, triangles);
  }
}

std::string fault_of(const Places_in_plane& places, const Ring& ring)
{
  std::set<std::string> faults;
  for(const Plane& plane : planes)
  {
    std::vector<Triangle> triangles;
    const std::vector<Point> points = plane.points(places);
    const char* const fault = Polygon_triangulator(points)(ring, triangles);
    faults.insert(fault == nullptr ? "none" : fault);
    EXPECT_TRUE(fault == nullptr || triangles.empty());
  }
  EXPECT_EQ(faults.size(), 1u) << *faults.rbegin();
  return *faults.begin();
}

TEST(Polygon_triangulator, holes_slits_and_vertices_that_come_twice)
{
  const Places_in_plane places = { { 0, 0 }, { 8, 0 }, { 8, 8 }, { 0, 8 }, { 2, 2 }, { 2, 4 }, { 4, 4 }, { 4, 2 },
                                   { 5, 5 }, { 5, 7 }, { 7, 7 }, { 7, 5 }, { 4, 0 }, { 4, 8 } };
  expect_polygon(places, { 0, 1, 2, 3 });
  expect_polygon(places, { 0, 0, 1, 2, 2, 2, 3, 0 });                                     // repeated vertices
  expect_polygon(places, { 0, 12, 1, 2, 13, 3 });                                         // collinear ones
  expect_polygon(places, { 0, 1, 2, 3, 0, 4, 5, 6, 7, 4 });                               // a hole
  expect_polygon(places, { 0, 1, 2, 3, 0, 4, 5, 6, 8, 9, 10, 11, 8, 6, 7, 4 });           // a hole behind another one
  expect_polygon(places, { 0, 1, 2, 10, 11, 8, 9, 10, 2, 3, 0, 4, 5, 6, 7, 4 });          // two bridges
  expect_polygon(places, { 0, 12, 7, 12, 1, 2, 3 });                                      // a slit
  expect_polygon(places, { 0, 12, 7, 6, 8, 6, 7, 12, 1, 2, 3 });                          // a slit with a bend
  expect_polygon(places, { 4, 7, 6, 5, 4, 0 });                                           // an edge outside
  expect_polygon(places, { 4, 7, 6, 5, 4, 3, 0, 1, 4 + 0 });                              // two parts at a vertex
}

TEST(Polygon_triangulator, names_what_is_wrong)
{
  const Places_in_plane places = { { 0, 0 }, { 8, 0 }, { 8, 8 }, { 0, 8 }, { 4, 0 }, { 4, 4 }, { 2, 2 }, { 2, 6 } };
  EXPECT_EQ(fault_of(places, { 0, 1, 2, 3 }), "none");
  EXPECT_EQ(fault_of(places, { 0, 2, 1, 3 }), "crosses itself");
  EXPECT_NE(fault_of(places, { 0, 1, 2, 4, 3 }).find("touches itself"), std::string::npos);
  EXPECT_EQ(fault_of(places, { 0, 1, 5, 3, 2, 5 }), "crosses itself"); // in a vertex
  EXPECT_EQ(fault_of(places, { 0, 1, 2, 0, 1, 2 }), "crosses itself"); // twice around
  EXPECT_EQ(fault_of(places, { 0, 1, 2, 3, 0, 6, 5, 7, 6 }), "crosses itself"); // a hole the same way around
}

TEST(Polygon_triangulator, degenerate_rings_have_no_triangles_or_flat_ones)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 }, { 0, 0, 9 } };
  const auto number = [&](const Ring& ring)
  {
    std::vector<Triangle> triangles;
    EXPECT_EQ(Polygon_triangulator(points)(ring, triangles), nullptr);
    return triangles.size();
  };
  for(const Ring& ring : { Ring{}, Ring{ 0 }, Ring{ 0, 1 }, Ring{ 0, 0, 1 }, Ring{ 2, 2, 2, 2 }, Ring{ 0, 1, 0, 1 },
                           Ring{ 0, 4, 1, 4 }, Ring{ 0, 1, 2, 3, 2, 1 } })
    EXPECT_EQ(number(ring), 0u);
  EXPECT_EQ(number({ 0, 1, 3, 2 }), 2u); // which join the faces on both sides
}

int sign(const long long x)
{
  return (x > 0) - (x < 0);
}

bool is_between(const long long a, const long long x, const long long b)
{
  return (std::min)(a, b) <= x && x <= (std::max)(a, b);
}

bool is_on_segment(const Place_in_plane& a, const Place_in_plane& b, const Place_in_plane& p)
{
  return area_of(a, b, p) == 0 && is_between(a[0], p[0], b[0]) && is_between(a[1], p[1], b[1]);
}

bool meet(const Place_in_plane& a, const Place_in_plane& b, const Place_in_plane& c, const Place_in_plane& d)
{
  return is_on_segment(a, b, c) || is_on_segment(a, b, d) || is_on_segment(c, d, a) || is_on_segment(c, d, b)
         || (sign(area_of(a, b, c)) * sign(area_of(a, b, d)) < 0
             && sign(area_of(c, d, a)) * sign(area_of(c, d, b)) < 0);
}

// Compares all edges with one another.
bool is_simple(const Places_in_plane& places)
{
  const std::size_t n = places.size();
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = i + 1; j < n; ++j)
    {
      const Place_in_plane &a = places[i], &b = places[(i + 1) % n], &c = places[j], &d = places[(j + 1) % n];
      if(j == i + 1 ? is_on_segment(a, b, d) || is_on_segment(c, d, a)
                    : (j + 1) % n == i ? is_on_segment(a, b, c) || is_on_segment(c, d, b) : meet(a, b, c, d))
        return false;
    }
  return true;
}

TEST(Polygon_triangulator, takes_a_random_polygon_exactly_if_it_is_simple)
{
  std::mt19937 random(1);
  std::map<bool, int> numbers;
  for(int trial = 0; trial < 3000; ++trial)
  {
    std::uniform_int_distribution<long long> coordinate(0, trial % 2 == 0 ? 5 : 1000);
    std::set<Place_in_plane> distinct;
    const std::size_t number = 4 + random() % 4;
    while(distinct.size() < number)
      distinct.insert({ coordinate(random), coordinate(random) });
    Places_in_plane places(distinct.begin(), distinct.end());
    std::shuffle(places.begin(), places.end(), random);
    bool is_in_a_line = true;
    for(const Place_in_plane& p : places)
      is_in_a_line = is_in_a_line && area_of(places[0], places[1], p) == 0;
    if(is_in_a_line)
      continue;
    Ring ring(number);
    std::iota(ring.begin(), ring.end(), std::size_t(0));
    const bool simple = is_simple(places);
    ++numbers[simple];
    std::vector<Triangle> triangles;
    const std::vector<Point> points = planes[trial % planes.size()].points(places);
    const char* const fault = Polygon_triangulator(points)(ring, triangles);
    EXPECT_EQ(fault == nullptr, simple);
    if(simple)
      expect_triangulation(places, ring, triangles);
  }
  EXPECT_GT((std::min)(numbers[false], numbers[true]), 100);
}

TEST(Polygon_triangulator, any_ring_in_space)
{
  std::mt19937 random(2);
  std::map<bool, int> numbers;
  for(int trial = 0; trial < 20000; ++trial)
  {
    std::vector<Point> points;
    for(int k = 0; k < 8; ++k)
      points.emplace_back(k % 3, random() % 3, random() % (1 + trial % 3));
    Ring ring(3 + random() % 6);
    for(std::size_t& vertex : ring)
      vertex = random() % points.size();
    const std::vector<std::size_t> place = first_at_each_place(points);
    for(std::size_t& vertex : ring)
      vertex = place[vertex];
    std::vector<Triangle> triangles;
    const char* const fault = Polygon_triangulator(points)(ring, triangles);
    ++numbers[fault == nullptr];
    if(fault != nullptr || triangles.empty())
      continue;
    Chain expected, found;
    add_passes(ring, expected);
    for(const Triangle& t : triangles)
      add_passes(Ring(t.begin(), t.end()), found);
    for(const auto& [edge, number] : found)
      EXPECT_EQ(expected[edge], number);
    for(const auto& [edge, number] : expected)
      EXPECT_EQ(found[edge], number);
  }
  EXPECT_GT((std::min)(numbers[false], numbers[true]), 1000);
}

TEST(Polygon_triangulator, large_concave_polygons)
{
  const long long n = 5000;
  Places_in_plane places;
  for(long long k = 0; k < n; ++k)
    places.push_back({ k, k % 2 == 0 ? k % 7 : 1000 + k * k % 11 });
  places.insert(places.end(), { { n, -5 }, { -1, -5 } });
  Ring ring(places.size());
  std::iota(ring.begin(), ring.end(), std::size_t(0));
  expect_polygon(places, ring);
}

// ---------------------------------------------------------------- surfaces

struct Test_soup
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;

  void add(const Test_soup& other, const Vector& shift = Vector(0, 0, 0))
  {
    const std::size_t first = points.size();
    for(const Point& p : other.points)
      points.push_back(p + shift);
    for(const Triangle& t : other.triangles)
      triangles.push_back({ first + t[0], first + t[1], first + t[2] });
  }

  // Three vertices of its own for each triangle, as in STL files.
  Test_soup apart() const
  {
    Test_soup result;
    for(const Triangle& t : triangles)
    {
      result.triangles.push_back({ result.points.size(), result.points.size() + 1, result.points.size() + 2 });
      for(const std::size_t vertex : t)
        result.points.push_back(points[vertex]);
    }
    return result;
  }

  // One vertex at each place.
  Test_soup merged() const
  {
    Test_soup result = *this;
    const std::vector<std::size_t> place = first_at_each_place(points);
    for(Triangle& t : result.triangles)
      for(std::size_t& vertex : t)
        vertex = place[vertex];
    return result;
  }

  Test_soup inside_out() const
  {
    Test_soup result = *this;
    for(Triangle& t : result.triangles)
      std::swap(t[1], t[2]);
    return result;
  }

  Test_soup shuffled(const bool turns, std::mt19937& random) const
  {
    Test_soup result = *this;
    std::shuffle(result.triangles.begin(), result.triangles.end(), random);
    for(Triangle& t : result.triangles)
    {
      std::rotate(t.begin(), t.begin() + random() % 3, t.end());
      if(turns && random() % 3 == 0)
        std::swap(t[1], t[2]);
    }
    return result;
  }
};

// A box of n by n by n unit cubes, so that its coordinates are exact.
Test_soup box(const std::size_t n)
{
  Test_soup result;
  const auto add_side = [&](const Point& corner, const Vector& u, const Vector& v)
  {
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; j < n; ++j)
      {
        const std::size_t first = result.points.size();
        const Point p = corner + i * u + j * v;
        result.points.insert(result.points.end(), { p, p + u, p + u + v, p + v });
        result.triangles.insert(result.triangles.end(), { { first, first + 1, first + 2 },
                                                          { first, first + 2, first + 3 } });
      }
  };
  const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const Point low(0, 0, 0), high(n, n, n);
  add_side(low, y, x);
  add_side(low, x, z);
  add_side(low, z, y);
  add_side(high, -x, -y);
  add_side(high, -z, -x);
  add_side(high, -y, -z);
  return result.merged();
}

struct Built
{
  Mesh mesh;
  std::size_t components, border_edges, turned, cut;
};

// Checks that halfedges are consistent, and that each vertex has one fan.
void expect_manifold(const Mesh& mesh, const std::size_t number_of_faces)
{
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(is_triangle_manifold(mesh));
  EXPECT_EQ(mesh.number_of_faces(), number_of_faces);
  std::vector<std::size_t> degree(mesh.num_vertices(), 0);
  std::set<std::pair<Vertex, Vertex> > border;
  for(const Halfedge h : mesh.halfedges())
  {
    ++degree[mesh.target(h)];
    EXPECT_EQ(mesh.prev(mesh.next(h)), h);
    EXPECT_EQ(mesh.target(h), mesh.source(mesh.next(h)));
    EXPECT_EQ(mesh.face(h), mesh.face(mesh.next(h)));
    if(!mesh.is_border(h))
      EXPECT_EQ(mesh.next(mesh.next(mesh.next(h))), h);
    else
      EXPECT_TRUE(border.emplace(mesh.source(h), mesh.target(h)).second);
  }
  for(const Vertex v : mesh.vertices())
  {
    if(degree[v] == 0)
      continue;
    std::size_t number = 0, number_of_borders = 0;
    Halfedge h = mesh.halfedge(v);
    do
    {
      ASSERT_EQ(mesh.target(h), v);
      number_of_borders += mesh.is_border(h);
      h = mesh.opposite(mesh.next(h));
    } while(h != mesh.halfedge(v) && ++number <= degree[v]);
    EXPECT_EQ(number + 1, degree[v]);
    EXPECT_LE(number_of_borders, 1u);
    EXPECT_EQ(number_of_borders == 1, mesh.is_border(mesh.halfedge(v)));
  }
  for(const auto& [a, b] : border)
    EXPECT_FALSE(border.count({ b, a })) << "a hole of two edges";
}

Built build(const Test_soup& soup, const std::vector<std::size_t>& place, std::vector<Triangle> triangles)
{
  const Triangle_surface surface(soup.points, place, std::move(triangles));
  Built result;
  build_mesh(soup.points, surface, Vertex_numbers(surface, soup.points.size(), false), result.mesh);
  expect_manifold(result.mesh, surface.triangles().size());
  Disjoint_sets components(surface.triangles().size());
  result.border_edges = 0;
  for(std::size_t side = 0; side < surface.number_of_sides(); ++side)
    if(surface.is_border(side))
      ++result.border_edges;
    else
      components.unite(side / 3, surface.opposite(side) / 3);
  result.components = 0;
  for(std::size_t t = 0; t < surface.triangles().size(); ++t)
    result.components += components.find(t) == t;
  result.turned = surface.number_of_turned_triangles();
  result.cut = surface.number_of_cut_edges();
  return result;
}

Built build(const Test_soup& soup)
{
  const std::vector<std::size_t> place = first_at_each_place(soup.points);
  std::vector<Triangle> triangles = soup.triangles;
  remove_degenerate_triangles(place, triangles);
  remove_duplicate_triangles(place, triangles);
  return build(soup, place, triangles);
}

// The soup with one vertex a place and with three vertices a triangle, as it is and inside out, in any order.
template <typename Check>
void for_each_way(const Test_soup& soup, const bool turns, const Check& check)
{
  std::mt19937 random(7);
  for(const Test_soup& oriented : { soup, soup.inside_out() })
    for(const Test_soup& written : { oriented, oriented.merged(), oriented.apart() })
      for(const Test_soup& ordered : { written, written.shuffled(turns, random), written.shuffled(turns, random) })
        check(build(ordered));
}

TEST(Triangle_surface, box_in_any_way)
{
  for(const std::size_t n : { 1, 2, 5 })
    for_each_way(box(n), true, [&](const Built& built)
    {
      EXPECT_EQ(built.mesh.number_of_faces(), 12 * n * n);
      EXPECT_EQ(built.mesh.number_of_vertices(), 6 * n * n + 2);
      EXPECT_EQ(built.components, 1u);
      EXPECT_EQ(built.border_edges, 0u);
    });
}

TEST(Triangle_surface, turns_the_fewer_triangles)
{
  for(const std::size_t step : { 3, 5, 7 })
  {
    Test_soup soup = box(3);
    for(std::size_t t = 0; t < soup.triangles.size(); t += step)
      std::swap(soup.triangles[t][0], soup.triangles[t][1]);
    EXPECT_EQ(build(soup).turned, (soup.triangles.size() + step - 1) / step);
  }
}

TEST(Triangle_surface, keeps_numbers_of_vertices)
{
  const Test_soup soup = box(3);
  const std::vector<std::size_t> place = first_at_each_place(soup.points);
  const Triangle_surface surface(soup.points, place, soup.triangles);
  const Vertex_numbers numbers(surface, soup.points.size(), true);
  Mesh mesh;
  build_mesh(soup.points, surface, numbers, mesh);
  ASSERT_EQ(mesh.num_vertices(), soup.points.size());
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    EXPECT_EQ(mesh.point(Vertex(static_cast<Mesh::size_type>(v))), soup.points[v]);
  for(std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    const Halfedge h = mesh.halfedge(Face(static_cast<Mesh::size_type>(t)));
    EXPECT_EQ(mesh.target(h).idx(), soup.triangles[t][0]);
    EXPECT_EQ(mesh.source(h).idx(), soup.triangles[t][2]);
  }
}

TEST(Triangle_surface, check_finds_what_is_spoilt)
{
  const Test_soup soup = box(2);
  std::mt19937 random(17);
  for(int trial = 0; trial < 500; ++trial)
  {
    Mesh mesh = build(soup).mesh;
    mesh.add_vertex(Point(9, 9, 9));
    EXPECT_TRUE(is_triangle_manifold(mesh)) << "a vertex without faces";
    const auto any = [&] { return Halfedge(static_cast<Mesh::size_type>(random() % mesh.num_halfedges())); };
    const Halfedge h = any(), other = any();
    switch(trial % 4)
    {
      case 0: mesh.set_target(h, mesh.source(h)); break;
      case 1: mesh.set_face(h, mesh.face(mesh.opposite(h))); break;
      case 2: mesh.set_halfedge(mesh.source(h), h); break;
      case 3: // two faces exchange what follows a halfedge
      {
        if(mesh.target(h) == mesh.target(other))
          continue;
        const Halfedge next = mesh.next(h);
        mesh.set_next(h, mesh.next(other));
        mesh.set_next(other, next);
      }
    }
    EXPECT_FALSE(is_triangle_manifold(mesh));
  }
}

TEST(Triangle_surface, solids_that_touch_stay_apart)
{
  for(const std::size_t n : { 1, 2, 4 })
    for(const Vector& shift : { Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, -1), Vector(1, 1, 0), Vector(1, 1, 1) })
    {
      Test_soup soup = box(n);
      soup.add(box(n), static_cast<double>(n) * shift);
      // Where squares lie on one another, their diagonals cross or not.
      for_each_way(soup, false, [&](const Built& built)
      {
        EXPECT_EQ(built.mesh.number_of_faces(), 24 * n * n);
        EXPECT_EQ(built.mesh.number_of_vertices(), 2 * (6 * n * n + 2));
        EXPECT_EQ(built.components, 2u);
        EXPECT_EQ(built.border_edges, 0u);
      });
    }
}

TEST(Triangle_surface, eight_boxes_around_a_point)
{
  Test_soup soup;
  for(int k = 0; k < 8; ++k)
    soup.add(box(2), Vector(2 * (k & 1), k & 2, (k & 4) / 2));
  for_each_way(soup, false, [&](const Built& built)
  {
    EXPECT_EQ(built.mesh.number_of_vertices(), 8u * 26u);
    EXPECT_EQ(built.components, 8u);
    EXPECT_EQ(built.border_edges, 0u);
  });
}

TEST(Triangle_surface, duplicates)
{
  Test_soup soup = box(2);
  const std::size_t number = soup.triangles.size();
  for(std::size_t t = 0; t < number; t += 5)
    soup.triangles.push_back(soup.triangles[t]);
  for(const std::size_t t : { 1, 2, 3, 17 }) // two of them are neighbors
    soup.triangles.push_back({ soup.triangles[t][0], soup.triangles[t][2], soup.triangles[t][1] });
  std::mt19937 random(3);
  for(const Test_soup& written : { soup, soup.apart(), soup.shuffled(false, random).apart() })
  {
    const Built built = build(written);
    EXPECT_EQ(built.mesh.number_of_faces(), number);
    EXPECT_EQ(built.mesh.number_of_vertices(), 26u);
    EXPECT_EQ(built.border_edges, 0u);
  }
}

TEST(Triangle_surface, sheet_with_two_sides_is_closed)
{
  Test_soup sheet;
  const Test_soup all = box(3);
  sheet.points = all.points;
  sheet.triangles.assign(all.triangles.begin(), all.triangles.begin() + 18);
  Test_soup both = sheet;
  both.add(sheet.inside_out());
  for(const Test_soup& written : { both, both.merged(), both.apart() })
  {
    const Built built = build(written);
    EXPECT_EQ(built.mesh.number_of_faces(), 36u);
    EXPECT_EQ(built.components, 1u);
    EXPECT_EQ(built.border_edges, 0u);
    EXPECT_EQ(built.mesh.number_of_vertices(), 2u * 16u - 12u);
  }
}

TEST(Triangle_surface, wall_on_a_box_is_a_part_of_its_own)
{
  Test_soup soup = box(2);
  soup.points.push_back(Point(1, 1, 9));
  const std::size_t top = soup.points.size() - 1;
  const auto vertex_at = [&](const Point& p)
  {
    return static_cast<std::size_t>(std::find(soup.points.begin(), soup.points.end(), p) - soup.points.begin());
  };
  soup.triangles.push_back({ vertex_at({ 1, 1, 2 }), vertex_at({ 2, 2, 2 }), top });
  for(const Test_soup& written : { soup, soup.apart() })
  {
    const Built built = build(written);
    EXPECT_EQ(built.mesh.number_of_faces(), 49u);
    EXPECT_EQ(built.components, 2u);
    EXPECT_EQ(built.border_edges, 3u);
  }
}

TEST(Triangle_surface, moebius_strips_are_cut)
{
  for(const std::size_t n : { 5, 12, 31 })
  {
    Test_soup soup;
    for(std::size_t k = 0; k < n; ++k)
    {
      const double a = 2 * CGAL_PI * static_cast<double>(k) / static_cast<double>(n);
      for(const double w : { -0.5, 0.5 })
        soup.points.emplace_back(std::cos(a) * (2 + w * std::cos(a / 2)), std::sin(a) * (2 + w * std::cos(a / 2)),
                                 w * std::sin(a / 2));
      const std::size_t v = 2 * k, next = k + 1 < n ? v + 2 : 1, above_next = k + 1 < n ? v + 3 : 0;
      soup.triangles.insert(soup.triangles.end(), { { v, v + 1, above_next }, { v, above_next, next } });
    }
    for(const Test_soup& written : { soup, soup.apart() })
    {
      const Built built = build(written);
      EXPECT_EQ(built.cut, 1u);
      EXPECT_EQ(built.components, 1u);
      EXPECT_EQ(built.border_edges, 2 * n + 2);
      EXPECT_EQ(built.mesh.number_of_vertices(), soup.points.size() + 2);
    }
  }
}

TEST(Triangle_surface, any_triangles_make_a_manifold)
{
  std::mt19937 random(11);
  for(int trial = 0; trial < 3000; ++trial)
  {
    Test_soup soup;
    const std::size_t number_of_points = 3 + random() % 8;
    for(std::size_t k = 0; k < number_of_points; ++k)
      soup.points.emplace_back(random() % 3, random() % 3, random() % 2);
    for(std::size_t k = 1 + random() % 30; k > 0; --k)
      soup.triangles.push_back({ random() % number_of_points, random() % number_of_points,
                                 random() % number_of_points });
    const std::vector<std::size_t> place = first_at_each_place(soup.points);
    remove_degenerate_triangles(place, soup.triangles);
    remove_duplicate_triangles(place, soup.triangles);
    build(soup, place, soup.triangles);
  }
}

TEST(Triangle_surface, fans_take_linear_time)
{
  const std::size_t n = 300000; // adding faces one by one, each with a walk around the hub, would take ten minutes
  Test_soup soup;
  soup.points.emplace_back(0, 0, 1);
  for(std::size_t k = 0; k < n; ++k)
  {
    const double a = 2 * CGAL_PI * static_cast<double>(k) / static_cast<double>(n);
    soup.points.emplace_back(std::cos(a), std::sin(a), 0);
    soup.triangles.push_back({ 0, 1 + k, 1 + (k + 1) % n });
  }
  const std::vector<std::size_t> place = first_at_each_place(soup.points);
  const Triangle_surface surface(soup.points, place, soup.triangles);
  Mesh mesh;
  build_mesh(soup.points, surface, Vertex_numbers(surface, soup.points.size(), true), mesh);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(mesh.number_of_edges(), 2 * n);
}

// ---------------------------------------------------------------- cracks

// Two strips of squares that meet at y = 0, apart by a gap; the upper one has `ratio` squares where the lower one has
// one.
Test_soup strips(const std::size_t n, const std::size_t ratio, const double gap)
{
  Test_soup result;
  for(const bool is_upper : { false, true })
  {
    const std::size_t number = is_upper ? n * ratio : n, first = result.points.size();
    for(std::size_t k = 0; k <= number; ++k)
    {
      const double x = static_cast<double>(k * n) / static_cast<double>(number);
      result.points.emplace_back(x, is_upper ? gap : 0, 0.3 * x);
      result.points.emplace_back(x, is_upper ? 1 : -1, 0.3 * x);
    }
    for(std::size_t k = 0; k < number; ++k)
    {
      const std::size_t v = first + 2 * k;
      if(is_upper)
        result.triangles.insert(result.triangles.end(), { { v, v + 2, v + 3 }, { v, v + 3, v + 1 } });
      else
        result.triangles.insert(result.triangles.end(), { { v + 1, v + 3, v + 2 }, { v + 1, v + 2, v } });
    }
  }
  return result;
}

std::size_t number_along_others(const Test_soup& soup, const double tolerance)
{
  const std::vector<std::size_t> place = first_at_each_place(soup.points);
  const Triangle_surface surface(soup.points, place, soup.triangles);
  return find_cracks(borders_of(soup.points, surface), tolerance).number_of_sides;
}

TEST(Cracks, are_counted)
{
  for(const std::size_t n : { 3, 20 })
    for(const double gap : { 1e-7, 1e-5 })
    {
      EXPECT_EQ(number_along_others(strips(n, 1, gap), 2 * gap), 2 * n);
      EXPECT_EQ(number_along_others(strips(n, 1, gap), gap / 2), 0u);
      EXPECT_EQ(number_along_others(strips(n, 4, gap), 2 * gap), 5 * n);
      EXPECT_EQ(number_along_others(strips(n, 4, 0), gap), 5 * n) << "vertices on edges";
      EXPECT_EQ(number_along_others(strips(n, 1, 0), gap), 0u);
    }
}

TEST(Cracks, are_closed)
{
  for(const std::size_t n : { 3, 20 })
    for(const std::size_t ratio : { 1, 2, 5 })
      for(const double gap : { 0.0, 1e-7, 1e-3 })
      {
        const Test_soup soup = strips(n, ratio, gap);
        std::vector<std::size_t> place = first_at_each_place(soup.points);
        const Triangle_surface surface(soup.points, place, soup.triangles);
        const double tolerance = 2e-3;
        ASSERT_TRUE(unite_near_places(soup.points, borders_of(soup.points, surface), tolerance, place));
        const Triangle_surface united(soup.points, place, soup.triangles);
        std::vector<Triangle> triangles;
        ASSERT_TRUE(split_sides_at_near_places(soup.points, united, tolerance, triangles));
        const Built built = build(soup, place, triangles);
        EXPECT_EQ(built.components, 1u);
        EXPECT_EQ(built.border_edges, n + n * ratio + 4) << "of the outline";
        EXPECT_EQ(built.mesh.number_of_faces(), 2 * n + 2 * n * ratio + n * (ratio - 1));
      }
}

TEST(Cracks, any_triangles_stay_a_manifold)
{
  std::mt19937 random(13);
  std::uniform_real_distribution<double> shift(0, 0.3);
  for(int trial = 0; trial < 3000; ++trial)
  {
    Test_soup soup;
    const std::size_t number_of_points = 3 + random() % 12;
    for(std::size_t k = 0; k < number_of_points; ++k)
      soup.points.emplace_back(random() % 3 + shift(random), random() % 3 + shift(random), random() % 2);
    for(std::size_t k = 1 + random() % 20; k > 0; --k)
      soup.triangles.push_back({ random() % number_of_points, random() % number_of_points,
                                 random() % number_of_points });
    std::vector<std::size_t> place = first_at_each_place(soup.points);
    std::vector<Triangle> triangles = soup.triangles;
    const auto clean = [&]
    {
      remove_degenerate_triangles(place, triangles);
      remove_duplicate_triangles(place, triangles);
    };
    clean();
    const double tolerance = 0.1 + 0.1 * (trial % 5);
    const Triangle_surface surface(soup.points, place, triangles);
    ASSERT_TRUE(unite_near_places(soup.points, borders_of(soup.points, surface), tolerance, place));
    clean();
    const Triangle_surface united(soup.points, place, triangles);
    ASSERT_TRUE(split_sides_at_near_places(soup.points, united, tolerance, triangles));
    clean();
    build(soup, place, triangles);
  }
}

TEST(Cracks, search_gives_up_where_all_borders_are_near_all)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 1);
  Test_soup soup;
  for(std::size_t t = 0; t < 4000; ++t)
  {
    soup.triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
    for(int k = 0; k < 3; ++k)
      soup.points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  }
  std::vector<std::size_t> place = first_at_each_place(soup.points);
  const Triangle_surface surface(soup.points, place, soup.triangles);
  EXPECT_EQ(find_cracks(borders_of(soup.points, surface), 10).number_of_sides, 0u);
  EXPECT_FALSE(unite_near_places(soup.points, borders_of(soup.points, surface), 10, place));
}

} // namespace
