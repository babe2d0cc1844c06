#include "test_quad_surface.h"

#include <CGAL/Frame_fields/internal/layout/arc_breakpoints.h>
#include <CGAL/Frame_fields/internal/quads/Arc_points.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/quads/fill_patch.h>
#include <CGAL/Frame_fields/internal/quads/make_arc_vertices.h>
#include <CGAL/Frame_fields/internal/quads/measure_quads.h>
#include <CGAL/Frame_fields/internal/quads/smooth_quads.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Filling patches with quads where nothing but the numbers of edges of their arcs is given.
namespace {

using namespace test;

struct Filling_case
{
  std::string name;
  Quad_surface surface;
};

Soup octahedron(const int number_of_refinements)
{
  Soup soup;
  soup.points = { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  for(int k = 0; k < 4; ++k)
    soup.triangles.insert(soup.triangles.end(), { Triangle{ k, (k + 1) % 4, 4 }, Triangle{ (k + 1) % 4, k, 5 } });
  for(int i = 0; i < number_of_refinements; ++i)
  {
    std::map<Vertex_pair, int> middles;
    const auto middle = [&](const int a, const int b)
    {
      const auto found = middles.emplace(std::make_pair((std::min)(a, b), (std::max)(a, b)),
                                         static_cast<int>(soup.points.size()));
      if(found.second)
      {
        Coordinates p;
        for(int k = 0; k < 3; ++k)
          p[k] = soup.points[a][k] + soup.points[b][k];
        const double norm = length(p);
        soup.points.push_back({ p[0] / norm, p[1] / norm, p[2] / norm });
      }
      return found.first->second;
    };
    std::vector<Triangle> finer;
    for(const Triangle& t : soup.triangles)
    {
      const int a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      finer.insert(finer.end(), { Triangle{ t[0], a, c }, Triangle{ a, t[1], b }, Triangle{ c, b, t[2] },
                                  Triangle{ a, b, c } });
    }
    soup.triangles = finer;
  }
  return soup;
}

std::vector<Filling_case> filling_cases()
{
  std::vector<Filling_case> result;
  const auto add = [&](const std::string& name, const Soup& soup, const std::set<Vertex_pair>& features = {})
  {
    result.push_back({ name, make_surface(soup.points, soup.triangles, features) });
  };
  std::set<Vertex_pair> lines;
  for(int i = 0; i < 12; ++i)
  {
    lines.insert({ i * 13 + 5, (i + 1) * 13 + 5 });
    if(i < 7)
      lines.insert({ 5 * 13 + i, 5 * 13 + i + 1 });
  }
  add("square_with_slit", grid(12, 12, 0.15), lines);
  add("half_cylinder", bent(grid(12, 12), 12, CGAL_PI));
  add("annulus", rings(24, 5, 4, 9));
  add("disk", rings(24, 5, 0, 9));
  add("square_of_two_triangles", grid(1, 1));
  add("triangle", { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { Triangle{ 0, 1, 2 } } });
  add("coarse_annulus", rings(3, 1, 1, 3));
  add("long_strip", grid(40, 1));
  add("sphere", octahedron(3));
  add("sphere_with_equator", octahedron(2), [&]
  {
    const Soup soup = octahedron(2);
    std::set<Vertex_pair> equator;
    for(const Triangle& t : soup.triangles)
      for(int k = 0; k < 3; ++k)
        if(soup.points[t[k]][2] == 0 && soup.points[t[(k + 1) % 3]][2] == 0)
          equator.insert({ t[k], t[(k + 1) % 3] });
    return equator;
  }());
  return result;
}

// Vertices on all arcs: nodes, and others at random positions or at equal distances.
Arc_vertices add_arc_vertices(const Quad_surface& s, const std::vector<int>& counts, const bool is_random,
                              std::mt19937& generator, Quad_complex& complex)
{
  std::map<int, int> node;
  Arc_vertices result(counts.size());
  for(std::size_t arc = 0; arc < counts.size(); ++arc)
  {
    const Feature_arc& a = s.network.arcs[arc];
    const double n = static_cast<double>(a.halfedges.size());
    const auto add_node = [&](const int v, const double position)
    {
      const auto found = node.emplace(v, static_cast<int>(complex.vertices.size()));
      if(found.second)
      {
        Quad_vertex vertex;
        vertex.vertex = v;
        vertex.location = s.location_on_arc(static_cast<int>(arc), position);
        complex.vertices.push_back(vertex);
      }
      return found.first->second;
    };
    std::vector<double> positions;
    for(int i = a.is_loop ? 0 : 1; i < counts[arc]; ++i)
      positions.push_back(n * (is_random ? generator() / 4294967296. : i / double(counts[arc])));
    std::sort(positions.begin(), positions.end());
    if(!a.is_loop)
      result[arc].push_back(add_node(s.source(a.halfedges.front()), 0));
    for(const double position : positions)
    {
      Quad_vertex vertex;
      vertex.arc = static_cast<int>(arc);
      vertex.position = position;
      vertex.location = s.location_on_arc(vertex.arc, position);
      result[arc].push_back(static_cast<int>(complex.vertices.size()));
      complex.vertices.push_back(vertex);
    }
    if(!a.is_loop)
      result[arc].push_back(add_node(s.target(a.halfedges.back()), n));
    else if(is_random) // a loop may begin anywhere
      std::rotate(result[arc].begin(), result[arc].begin() + generator() % counts[arc], result[arc].end());
  }
  return result;
}

bool fill_all(const Quad_surface& s, const Arc_vertices& arc_vertices, const double edge_length, Quad_complex& complex)
{
  const Surface_walker walker(s.surface, s.embedding);
  bool is_filled = true;
  for(std::size_t patch = 0; patch < s.surface.patches.size(); ++patch)
    is_filled &= fill_patch(walker, s.surface, s.embedding, s.network, static_cast<int>(patch), arc_vertices,
                            edge_length, complex);
  return is_filled;
}

int euler_characteristic_of_surface(const Quad_surface& s)
{
  std::set<int> vertices(s.embedding.vertex.begin(), s.embedding.vertex.end());
  int number_of_edges = 0;
  for(int h = 0; h < s.surface.number_of_halfedges(); ++h)
    number_of_edges += s.embedding.twin[h] < h;
  return static_cast<int>(vertices.size()) - number_of_edges + s.surface.number_of_faces();
}

// What every filling must fulfil, whatever the surface.
void expect_valid(const Quad_surface& s, const Arc_vertices& arc_vertices, const Quad_complex& complex)
{
  ASSERT_EQ(complex.quads.size(), complex.patch.size());
  std::map<Vertex_pair, std::size_t> quad_of_side;
  std::map<int, std::map<int, int> > next_around; // per vertex: from neighbour to neighbour through each quad
  std::set<int> used;
  for(std::size_t q = 0; q < complex.quads.size(); ++q)
    for(int k = 0; k < 4; ++k)
    {
      const int v = complex.quads[q][k], next = complex.quads[q][(k + 1) % 4], previous = complex.quads[q][(k + 3) % 4];
      used.insert(v);
      EXPECT_NE(v, complex.quads[q][(k + 2) % 4]);
      EXPECT_NE(v, next);
      EXPECT_TRUE(quad_of_side.emplace(Vertex_pair(v, next), q).second) << "a side is there twice";
      EXPECT_TRUE(next_around[v].emplace(next, previous).second);
    }
  EXPECT_EQ(used.size(), complex.vertices.size());

  // The quads around each vertex are one fan: following neighbours from the one that is nobody's next passes all.
  for(const auto& [v, next] : next_around)
  {
    std::set<int> targets;
    for(const auto& step : next)
      targets.insert(step.second);
    EXPECT_EQ(targets.size(), next.size());
    int first = next.begin()->first;
    for(const auto& step : next)
      if(targets.count(step.first) == 0)
        first = step.first;
    std::size_t number_of_steps = 0;
    for(int w = first; next.count(w) != 0 && number_of_steps <= next.size() && (number_of_steps == 0 || w != first);
        w = next.at(w))
      ++number_of_steps;
    EXPECT_EQ(number_of_steps, next.size()) << v;
  }

  int edges = 0;
  for(const auto& side : quad_of_side)
    edges += quad_of_side.count({ side.first.second, side.first.first }) == 0
                       || side.first.first < side.first.second;
  EXPECT_EQ(static_cast<int>(used.size()) - edges + static_cast<int>(complex.quads.size()),
            euler_characteristic_of_surface(s));

  // Each edge of an arc is a side of a quad of the patch on each of its sides, and no other side is without neighbour
  // or between patches.
  std::set<Vertex_pair> on_arcs;
  for(std::size_t arc = 0; arc < arc_vertices.size(); ++arc)
    for(int i = 0; i < number_of_edges(arc_vertices, s.network, static_cast<int>(arc)); ++i)
    {
      const int v = arc_vertices[arc][i], w = arc_vertices[arc][(i + 1) % arc_vertices[arc].size()];
      const int h = s.network.arcs[arc].halfedges[0], twin = s.embedding.twin[h];
      ASSERT_EQ(quad_of_side.count(Vertex_pair(v, w)), 1u);
      EXPECT_EQ(complex.patch[quad_of_side.at(Vertex_pair(v, w))], s.patch_of(face_of(h)));
      EXPECT_EQ(quad_of_side.count(Vertex_pair(w, v)), twin < 0 ? 0u : 1u);
      if(twin >= 0)
      {
        EXPECT_EQ(complex.patch[quad_of_side.at(Vertex_pair(w, v))], s.patch_of(face_of(twin)));
      }
      on_arcs.insert({ v, w });
      on_arcs.insert({ w, v });
    }
  for(const auto& side : quad_of_side)
  {
    const auto other = quad_of_side.find({ side.first.second, side.first.first });
    if(other == quad_of_side.end() || complex.patch[other->second] != complex.patch[side.second])
    {
      EXPECT_EQ(on_arcs.count(side.first), 1u);
    }
  }

  for(const Quad_vertex& v : complex.vertices)
  {
    double sum = 0;
    for(const double w : v.location.barycentric)
    {
      EXPECT_GE(w, 0);
      sum += w;
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    if(v.vertex < 0 && v.arc < 0)
    {
      EXPECT_EQ(v.patch, s.patch_of(v.location.face));
    }
  }
}

TEST(Quad_filling, even_counts_of_any_size_at_any_positions)
{
  for(const Filling_case& c : filling_cases())
    for(unsigned seed = 0; seed < 20; ++seed)
    {
      SCOPED_TRACE(c.name + " " + std::to_string(seed));
      std::mt19937 generator(seed);
      std::vector<int> counts;
      for(const Feature_arc& arc : c.surface.network.arcs)
        counts.push_back(smallest_even_count(c.surface.embedding, arc) + 2 * (generator() % (1 + 2 * seed)));
      Quad_complex complex;
      const Arc_vertices arc_vertices = add_arc_vertices(c.surface, counts, seed % 2 == 1, generator, complex);
      const Quad_complex before = complex;
      ASSERT_TRUE(fill_all(c.surface, arc_vertices, 0.2 + 0.1 * seed, complex));
      expect_valid(c.surface, arc_vertices, complex);
      for(std::size_t v = 0; v < before.vertices.size(); ++v)
        EXPECT_EQ(before.vertices[v].position, complex.vertices[v].position);
    }
}

// Per arc of the network: the even number of edges at which they are about as long as `edge_length`; 0 for arcs that
// are not on the patch. Any other even numbers that are not below the smallest one will do as well.
std::vector<int> even_counts_of_patch(const Cut_surface& surface, const Surface_embedding& embedding,
                                      const Feature_network& network, const Patch& patch, const double edge_length)
{
  std::vector<int> counts(network.arcs.size(), 0);
  const Arc_points arc_points(embedding, network);
  const double largest = 1 << 24;
  for(int h = 3 * patch.faces.begin_index; h < 3 * patch.faces.end_index; ++h)
  {
    const int arc = surface.is_constrained(h) ? network.arc[h] : -1;
    if(arc >= 0 && counts[arc] == 0)
      counts[arc] = (std::max)(smallest_even_count(embedding, network.arcs[arc]),
                               2 * static_cast<int>((std::min)(largest, std::round(arc_points.length(arc)
                                                                                   / (2 * edge_length)))));
  }
  return counts;
}

TEST(Quad_filling, quads_of_the_wanted_size_are_good_after_smoothing)
{
  for(const Filling_case& c : filling_cases())
    for(const double edge_length : { 0.5, 1., 2. })
    {
      const bool is_unit = c.name.find("sphere") == 0 || c.name == "triangle" || c.name == "square_of_two_triangles";
      const double h = is_unit ? edge_length / 5 : edge_length;
      SCOPED_TRACE(c.name + " " + std::to_string(h));
      std::vector<int> counts(c.surface.network.arcs.size(), 0);
      for(const Patch& patch : c.surface.surface.patches)
      {
        const std::vector<int> of_patch =
          even_counts_of_patch(c.surface.surface, c.surface.embedding, c.surface.network, patch, h);
        for(std::size_t arc = 0; arc < counts.size(); ++arc)
          counts[arc] = (std::max)(counts[arc], of_patch[arc]);
      }
      Quad_complex complex;
      std::mt19937 generator(1);
      const Arc_vertices arc_vertices = add_arc_vertices(c.surface, counts, false, generator, complex);
      ASSERT_TRUE(fill_all(c.surface, arc_vertices, h, complex));
      expect_valid(c.surface, arc_vertices, complex);
      const Smoothing_report report = smooth(complex, c.surface.surface, c.surface.embedding, c.surface.network);
      const auto quality = measure_quads(polygon_mesh(complex, c.surface.points(complex)));
      EXPECT_EQ(report.inverted_quads.size(), 0u);
      EXPECT_GT(quality.minimum_scaled_jacobian, 0.2);
      EXPECT_GT(quality.mean_edge_length, 0.5 * h);
      EXPECT_LT(quality.mean_edge_length, 1.5 * h);
    }
}

TEST(Quad_filling, odd_or_too_small_counts_are_refused_without_a_change)
{
  const Soup soup = rings(24, 5, 4, 9);
  const Quad_surface s = make_surface(soup.points, soup.triangles);
  for(const std::vector<int>& counts : { std::vector<int>{ 5, 8 }, { 8, 5 }, { 2, 8 }, { 8, 2 } })
  {
    Quad_complex complex;
    std::mt19937 generator(1);
    const Arc_vertices arc_vertices = add_arc_vertices(s, counts, false, generator, complex);
    const std::size_t old_size = complex.vertices.size();
    EXPECT_FALSE(fill_all(s, arc_vertices, 1, complex));
    EXPECT_EQ(complex.vertices.size(), old_size);
    EXPECT_TRUE(complex.quads.empty());
  }
}

// An inner vertex that the user marked is a vertex of the quads.
TEST(Quad_filling, marked_vertices_inside_stay)
{
  const Soup soup = grid(12, 12, 0.2);
  Quad_surface s = make_surface(soup.points, soup.triangles);
  const int marked = 6 * 13 + 7;
  s.network.is_node[marked] = true;
  Quad_complex complex;
  std::mt19937 generator(1);
  const Arc_vertices arc_vertices = add_arc_vertices(s, { 4, 4, 4, 4 }, false, generator, complex);
  ASSERT_TRUE(fill_all(s, arc_vertices, 3, complex));
  smooth(complex, s.surface, s.embedding, s.network);
  int count = 0;
  for(const Quad_vertex& v : complex.vertices)
    if(v.vertex == marked)
    {
      ++count;
      EXPECT_LT(distance(s.point(v.location), soup.points[marked]), 1e-14);
    }
  EXPECT_EQ(count, 1);
}

// Of all ways to give each goal a different point in their order, the one with the least sum of squared distances.
TEST(Arc_vertices, points_for_bends_are_the_nearest_in_all)
{
  std::mt19937 generator(1);
  for(int round = 0; round < 300; ++round)
  {
    const int m = 1 + static_cast<int>(generator() % 4), n = m + static_cast<int>(generator() % 5);
    std::vector<double> places;
    for(int g = 0; g < m; ++g)
      places.push_back((n + 1) * std::pow(generator() / 4294967296., 1 + round % 3) - 1);
    std::sort(places.begin(), places.end());
    const auto cost = [&](const std::vector<int>& points)
    {
      double sum = 0;
      for(int g = 0; g < m; ++g)
        sum += (points[g] - places[g]) * (points[g] - places[g]);
      return sum;
    };
    double least = std::numeric_limits<double>::infinity();
    for(int subset = 0; subset < 1 << n; ++subset)
    {
      std::vector<int> points;
      for(int i = 0; i < n; ++i)
        if(subset >> i & 1)
          points.push_back(i);
      if(static_cast<int>(points.size()) == m)
        least = (std::min)(least, cost(points));
    }
    const std::vector<int> points = points_near_places(places, n);
    ASSERT_EQ(static_cast<int>(points.size()), m);
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end()));
    EXPECT_EQ(std::set<int>(points.begin(), points.end()).size(), points.size());
    EXPECT_GE(points.front(), 0);
    EXPECT_LT(points.back(), n);
    EXPECT_NEAR(cost(points), least, 1e-12);
  }
}

// A helix whose first two turns have 12 edges each and the other two 300 each: the breakpoints are 30 and 22.5 degrees
// apart there. As many points, evenly spaced, would go by up to two edges to reach them.
TEST(Arc_vertices, go_to_bends_but_not_far_along_a_smooth_arc)
{
  const double pi = std::acos(-1.), tolerance = 0.05;
  Surface_embedding embedding;
  Feature_network network;
  network.arcs.push_back({ {}, false });
  const auto add_edges = [&](const int number, const double begin, const double end)
  {
    for(int i = embedding.point.empty() ? 0 : 1; i <= number; ++i)
    {
      const double angle = begin + (end - begin) * i / number;
      embedding.point.push_back({ std::cos(angle), std::sin(angle), 0.05 * angle });
    }
  };
  const auto follow = [&](const bool has_corner)
  {
    network.arcs[0].halfedges.clear();
    embedding.vertex.clear();
    std::vector<int> sources;
    for(int v = 0; v + 1 < static_cast<int>(embedding.point.size()); ++v)
    {
      network.arcs[0].halfedges.push_back(3 * v);
      embedding.vertex.insert(embedding.vertex.end(), { v + 1, -1, v });
      sources.push_back(v);
    }
    const Arc_points arc_points(embedding, network);
    const std::vector<std::vector<int> > breakpoints{ arc_breakpoints(embedding, network.arcs[0], sources, tolerance) };
    const std::vector<double> arc_tolerance{ tolerance };
    const Cut_surface surface;
    const Quad_layout layout{ surface, embedding, network, {}, {}, {}, {}, {}, {}, breakpoints, arc_tolerance };
    const int number_of_edges = static_cast<int>(breakpoints[0].size()) + 1;
    const std::vector<double> even = evenly_spaced_points(arc_points.length(0), number_of_edges, false);
    Placed_arc placed{ even, {} };
    follow_bends(layout, arc_points, 0, placed);
    if(has_corner)
      return std::make_pair(placed.has_free_bends, arc_points.length_at(0, 7, 0) - placed.length[6]);
    double farthest = 0;
    for(std::size_t i = 0; i < even.size(); ++i)
      farthest = (std::max)(farthest, std::abs(placed.length[i] - even[i]));
    EXPECT_LE(deviation_of_points(arc_points, 0, false, placed.length), tolerance);
    return std::make_pair(placed.has_free_bends, farthest * number_of_edges / arc_points.length(0));
  };

  add_edges(24, 0, 4 * pi);
  add_edges(600, 4 * pi, 8 * pi);
  const auto [has_free_bends, moved_edges] = follow(false);
  EXPECT_TRUE(has_free_bends);
  EXPECT_LE(moved_edges, 1);

  embedding.point.clear(); // an even helix with one corner
  add_edges(24, 0, 4 * pi);
  embedding.point[7] = { 3, 0, 1 };
  const auto [has_free_bends_beside_corner, distance_from_corner] = follow(true);
  EXPECT_FALSE(has_free_bends_beside_corner);
  EXPECT_EQ(distance_from_corner, 0);
}

} // namespace
