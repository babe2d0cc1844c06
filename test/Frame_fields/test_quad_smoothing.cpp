#include "test_quad_surface.h"

#include <CGAL/Frame_fields/internal/quads/measure_quads.h>
#include <CGAL/Frame_fields/internal/quads/rechoose_bend_vertices.h>
#include <CGAL/Frame_fields/internal/quads/smooth_quads.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Measures of quads, walks on the surface, and smoothing.
namespace {

using namespace test;

typedef std::vector<std::array<int, 4> > Quads;

// The sine of each corner's angle, seen along the quad's principal axes; written down apart from the library.
double scaled_jacobian(const std::array<Coordinates, 4>& p)
{
  std::array<double, 3> x, y;
  for(int i = 0; i < 3; ++i)
  {
    x[i] = (p[1][i] + p[2][i]) / 2 - (p[0][i] + p[3][i]) / 2;
    y[i] = (p[2][i] + p[3][i]) / 2 - (p[0][i] + p[1][i]) / 2;
  }
  const auto determinant = [](const std::array<double, 3>& a, const std::array<double, 3>& b,
                              const std::array<double, 3>& c)
  {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  std::array<double, 3> n{ x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0] };
  const double norm = std::hypot(n[0], n[1], n[2]);
  double least = 1;
  for(int k = 0; k < 4; ++k)
  {
    std::array<double, 3> a, b;
    for(int i = 0; i < 3; ++i)
    {
      a[i] = p[(k + 1) % 4][i] - p[k][i];
      b[i] = p[(k + 3) % 4][i] - p[k][i];
    }
    const double lengths = std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
    least = (std::min)(least, norm > 0 && lengths > 0 ? determinant(a, b, n) / (lengths * norm) : 0);
  }
  return least;
}

std::array<Coordinates, 4> corners(const std::vector<Coordinates>& points, const std::array<int, 4>& quad)
{
  return { points[quad[0]], points[quad[1]], points[quad[2]], points[quad[3]] };
}

// The least one of all quads; negative for one that lies on its face, where `normal` tells what is up.
double worst(const Quad_surface& s, const Quad_complex& complex,
             const std::function<Coordinates(const Coordinates&)>& normal)
{
  const std::vector<Coordinates> points = s.points(complex);
  double result = 1;
  for(const std::array<int, 4>& quad : complex.quads)
  {
    const std::array<Coordinates, 4> p = corners(points, quad);
    Coordinates middle;
    for(int i = 0; i < 3; ++i)
      middle[i] = (p[0][i] + p[1][i] + p[2][i] + p[3][i]) / 4;
    Coordinates diagonal, other;
    for(int i = 0; i < 3; ++i)
    {
      diagonal[i] = p[2][i] - p[0][i];
      other[i] = p[3][i] - p[1][i];
    }
    const double jacobian = scaled_jacobian(p);
    const bool is_upside_down = dot(cross(diagonal, other), normal(middle)) < 0;
    result = (std::min)(result, is_upside_down ? (std::min)(jacobian, -jacobian) : jacobian);
  }
  return result;
}

Quads grid_quads(const int m, const int n)
{
  Quads result;
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < m; ++i)
    {
      const int a = j * (m + 1) + i;
      result.push_back({ a, a + 1, a + m + 2, a + m + 1 });
    }
  return result;
}

Quads ring_quads(const int n, const int number_of_rings)
{
  Quads result;
  for(int r = 0; r < number_of_rings; ++r)
    for(int i = 0; i < n; ++i)
      result.push_back({ r * n + i, (r + 1) * n + i, (r + 1) * n + (i + 1) % n, r * n + (i + 1) % n });
  return result;
}

// A vertex of the quads at each vertex of the surface, moved at random: along its arc by up to `shift` (below 1/2) of
// an edge, else on its patch by up to `shift` in each direction.
Quad_complex scattered(const Quad_surface& s, const Quads& quads, const double shift, const unsigned seed)
{
  std::mt19937 generator(seed);
  const auto random = [&] { return shift * (2 * (generator() / 4294967296.) - 1); };
  const Surface_walker walker(s.surface, s.embedding);
  std::vector<int> corner(s.embedding.point.size(), -1);
  for(int h = 0; h < s.surface.number_of_halfedges(); ++h)
    if(corner[s.target(h)] < 0 || s.surface.is_constrained(h))
      corner[s.target(h)] = h;
  Quad_complex complex;
  for(std::size_t i = 0; i < s.embedding.point.size(); ++i)
  {
    const int h = corner[i];
    Quad_vertex v;
    v.location.face = face_of(h);
    v.location.barycentric = { 0, 0, 0 };
    v.location.barycentric[h % 3] = 1;
    const double dx = random(), dy = random(), dz = random();
    if(s.network.is_node[i])
      v.vertex = static_cast<int>(i);
    else if(s.surface.is_constrained(h))
    {
      v.arc = s.network.arc[h];
      const Feature_arc& arc = s.network.arcs[v.arc];
      const double n = static_cast<double>(arc.halfedges.size());
      const int end = s.network.place[h] + (arc.halfedges[s.network.place[h]] == h);
      v.position = end + 0.9 * (std::min)(1., 0.5 / shift) * dx;
      v.position += v.position < 0 ? n : v.position >= n && arc.is_loop ? -n : 0;
      v.location = s.location_on_arc(v.arc, v.position);
    }
    else
    {
      v.patch = s.patch_of(v.location.face);
      walker.walk(v.location, { dx, dy, dz });
    }
    complex.vertices.push_back(v);
  }
  complex.quads = quads;
  for(const std::array<int, 4>& quad : quads)
  {
    complex.patch.push_back(0);
    for(const int v : quad)
      complex.patch.back() = (std::max)(complex.patch.back(), complex.vertices[v].patch);
  }
  return complex;
}

void expect_valid_location(const Surface_location& location)
{
  double sum = 0;
  for(const double w : location.barycentric)
  {
    EXPECT_GE(w, 0);
    sum += w;
  }
  EXPECT_NEAR(sum, 1, 1e-14);
}

// Every vertex is where it may be, and the quads are the same.
void expect_same_but_for_slides(const Quad_surface& s, const Quad_complex& before, const Quad_complex& after)
{
  EXPECT_EQ(before.quads, after.quads);
  EXPECT_EQ(before.patch, after.patch);
  ASSERT_EQ(before.vertices.size(), after.vertices.size());
  std::map<int, std::vector<std::pair<double, double> > > positions; // per arc: before and after
  for(std::size_t i = 0; i < before.vertices.size(); ++i)
  {
    const Quad_vertex& v = before.vertices[i];
    const Quad_vertex& w = after.vertices[i];
    EXPECT_EQ(v.vertex, w.vertex);
    EXPECT_EQ(v.arc, w.arc);
    EXPECT_EQ(v.patch, w.patch);
    expect_valid_location(w.location);
    if(v.vertex >= 0)
    {
      EXPECT_EQ(v.location.face, w.location.face);
      EXPECT_EQ(v.location.barycentric, w.location.barycentric);
    }
    else if(v.arc >= 0)
    {
      EXPECT_GE(w.position, 0);
      EXPECT_LE(w.position, static_cast<double>(s.network.arcs[v.arc].halfedges.size()));
      positions[v.arc].push_back({ v.position, w.position });
      EXPECT_LT(distance(s.point(w.location), s.point(s.location_on_arc(v.arc, w.position))), 1e-12);
    }
    else
      EXPECT_EQ(v.patch, s.patch_of(w.location.face));
  }
  for(auto& [arc, list] : positions)
  {
    std::sort(list.begin(), list.end());
    int number_of_descents = 0; // once around a loop there is one, unless the least is the first one still
    for(std::size_t i = 0; i < list.size(); ++i)
      number_of_descents += list[i].second >= list[(i + 1) % list.size()].second;
    EXPECT_EQ(number_of_descents, 1) << arc;
    if(!s.network.arcs[arc].is_loop)
    {
      EXPECT_LT(list.front().second, list.back().second + (list.size() == 1));
    }
  }
}

struct Smoothing_case
{
  std::string name;
  Quad_surface surface;
  Quads quads;
  std::function<Coordinates(const Coordinates&)> normal;
};

Coordinates up(const Coordinates&) { return { 0, 0, 1 }; }

// A square with features on two lines, a half cylinder, an annulus.
std::vector<Smoothing_case> smoothing_cases()
{
  std::vector<Smoothing_case> result;
  const int n = 12;
  const Soup square = grid(n, n, 0.15);
  std::set<Vertex_pair> lines;
  for(int i = 0; i < n; ++i)
  {
    lines.insert({ i * (n + 1) + 5, (i + 1) * (n + 1) + 5 });
    if(i < 7)
      lines.insert({ 5 * (n + 1) + i, 5 * (n + 1) + i + 1 }); // ends inside: a slit from the crossing
  }
  result.push_back({ "square", make_surface(square.points, square.triangles, lines), grid_quads(n, n), up });
  const Soup cylinder = bent(grid(n, n), n, CGAL_PI);
  result.push_back({ "half_cylinder", make_surface(cylinder.points, cylinder.triangles), grid_quads(n, n),
                     [](const Coordinates& p) { return Coordinates{ p[0], 0, p[2] }; } });
  const Soup annulus = rings(24, 5, 4, 9);
  result.push_back({ "annulus", make_surface(annulus.points, annulus.triangles), ring_quads(24, 5), up });
  return result;
}

TEST(Quad_smoothing, surfaces_of_the_tests_are_what_they_should_be)
{
  const std::vector<Smoothing_case> cases = smoothing_cases();
  EXPECT_EQ(cases[0].surface.surface.patches.size(), 3u); // the slit separates only to the left of the crossing
  EXPECT_EQ(cases[0].surface.network.arcs.size(), 11u);
  EXPECT_EQ(cases[1].surface.network.arcs.size(), 4u);
  ASSERT_EQ(cases[2].surface.network.arcs.size(), 2u);
  EXPECT_TRUE(cases[2].surface.network.arcs[0].is_loop);
}

TEST(Quad_smoothing, worst_quad_never_gets_worse_and_vertices_stay_where_they_may_be)
{
  for(const Smoothing_case& c : smoothing_cases())
    for(unsigned seed = 0; seed < 12; ++seed)
    {
      SCOPED_TRACE(c.name + " " + std::to_string(seed));
      const Quad_complex before = scattered(c.surface, c.quads, 0.1 + 0.08 * seed, seed);
      Quad_complex after = before;
      const Smoothing_report report = smooth(after, c.surface.surface, c.surface.embedding, c.surface.network);
      const double old_worst = worst(c.surface, before, c.normal), new_worst = worst(c.surface, after, c.normal);
      expect_same_but_for_slides(c.surface, before, after);
      EXPECT_GE(new_worst, old_worst);
      EXPECT_NEAR(report.worst_after, new_worst, 1e-9);
      EXPECT_EQ(report.inverted_quads.size(), 0u);
      EXPECT_GT(new_worst, 0.5);
    }
}

// Sweeps, improves or untangles all of one patch.
void run_step(const int step, Sliding_quads& quads)
{
  std::vector<int> vertices(quads.number_of_vertices());
  std::iota(vertices.begin(), vertices.end(), 0);
  if(step % 3 == 0)
    Distortion_sweeps<CGAL::Sequential_tag>(quads, vertices).run(1, 0.6);
  else if(step % 3 == 1)
  {
    std::vector<std::int64_t> tried(quads.number_of_vertices(), -1);
    improve_worst_quads(quads, vertices, 0.5, tried);
  }
  else
    untangle_quads(quads, { 0 });
}

TEST(Quad_smoothing, no_step_alone_makes_the_worst_quad_worse)
{
  for(const Smoothing_case& c : smoothing_cases())
    for(unsigned seed = 0; seed < 12; ++seed)
    {
      SCOPED_TRACE(c.name + " " + std::to_string(seed));
      Quad_complex complex = scattered(c.surface, c.quads, 0.1 + 0.08 * seed, seed);
      for(int step = 0; step < 6; ++step)
      {
        const double old_worst = worst(c.surface, complex, c.normal);
        Sliding_quads quads(complex, c.surface.surface, c.surface.embedding, c.surface.network);
        run_step(step, quads);
        EXPECT_GE(worst(c.surface, complex, c.normal), old_worst - 1e-14) << step;
      }
    }
}

std::vector<char> valid_quads(const Sliding_quads& quads, const std::size_t number_of_quads)
{
  std::vector<char> result;
  for(std::size_t q = 0; q < number_of_quads; ++q)
    result.push_back(quads.shape(static_cast<int>(q)).scaled_jacobian > 0);
  return result;
}

// Also where many quads are inverted. To untangle a part may invert quads, but not more than it turns back. Only if it
// turns back more, the worst quad may get worse.
TEST(Quad_smoothing, no_step_inverts_quads)
{
  for(const Smoothing_case& c : smoothing_cases())
    for(unsigned seed = 0; seed < 8; ++seed)
    {
      SCOPED_TRACE(c.name + " " + std::to_string(seed));
      Quad_complex complex = scattered(c.surface, c.quads, 0.6 + 0.3 * seed, seed);
      for(int step = 0; step < 6; ++step)
      {
        Sliding_quads quads(complex, c.surface.surface, c.surface.embedding, c.surface.network);
        const std::vector<char> before = valid_quads(quads, complex.quads.size());
        const double old_worst = quads.worst();
        run_step(step, quads);
        const std::vector<char> after = valid_quads(quads, complex.quads.size());
        for(std::size_t q = 0; q < before.size() && step % 3 != 2; ++q)
          EXPECT_GE(after[q], before[q]) << step;
        const auto valid_before = std::count(before.begin(), before.end(), 1);
        const auto valid_after = std::count(after.begin(), after.end(), 1);
        EXPECT_GE(valid_after, valid_before) << step;
        const bool may_get_worse = step % 3 == 2 && valid_after > valid_before;
        EXPECT_TRUE(may_get_worse || quads.worst() >= old_worst - 1e-14) << step;
      }
    }
}

TEST(Quad_smoothing, sides_do_not_vanish_where_the_worst_quad_gets_better)
{
  for(const Smoothing_case& c : smoothing_cases())
    for(unsigned seed = 0; seed < 8; ++seed)
    {
      Quad_complex complex = scattered(c.surface, c.quads, 0.1 + 0.3 * seed, seed);
      Sliding_quads quads(complex, c.surface.surface, c.surface.embedding, c.surface.network);
      for(int v = 0; v < quads.number_of_vertices(); ++v)
      {
        if(quads.freedom(v) == Sliding_quads::FIXED)
          continue;
        const double least = (std::min)(0.2 * mean_length_of_sides(quads, v), shortest_side(quads, v, quads.point(v)));
        raise_worst_quad_of_vertex(quads, v);
        EXPECT_GE(shortest_side(quads, v, quads.point(v)), least * (1 - 1e-9));
      }
    }
}

// A part that stays tangled is as it was, or better: fewer quads are inverted, or as many and the worst one is better.
TEST(Quad_smoothing, untangling_in_vain_makes_nothing_worse)
{
  const Smoothing_case square = smoothing_cases().front();
  for(unsigned seed = 0; seed < 24; ++seed)
  {
    SCOPED_TRACE(seed);
    Quad_complex complex = scattered(square.surface, square.quads, 0.1 + 0.03 * seed, seed);
    std::array<int, 4>& quad = complex.quads[6 * seed];
    std::swap(quad[1], quad[3]); // clockwise
    Sliding_quads quads(complex, square.surface.surface, square.surface.embedding, square.surface.network);
    const std::size_t number = inverted_quads(quads).size();
    const double old_worst = quads.worst();
    untangle_quads(quads, { 0 });
    EXPECT_LE(inverted_quads(quads).size(), number);
    if(inverted_quads(quads).size() == number)
    {
      EXPECT_GE(quads.worst(), old_worst);
    }
  }
}

// Also the first one and the last one of a closed arc.
TEST(Quad_smoothing, vertices_of_arcs_have_room_on_both_sides)
{
  for(const Smoothing_case& c : smoothing_cases())
  {
    Quad_complex complex = scattered(c.surface, c.quads, 0.3, 3);
    const Sliding_quads quads(complex, c.surface.surface, c.surface.embedding, c.surface.network);
    int number_on_arcs = 0;
    for(int v = 0; v < quads.number_of_vertices(); ++v)
      if(quads.freedom(v) == Sliding_quads::ON_ARC)
      {
        const std::pair<double, double> range = quads.arc_order().range(v, quads.vertex(v).arc);
        EXPECT_LT(range.first, quads.arc_order().length(v));
        EXPECT_GT(range.second, quads.arc_order().length(v));
        ++number_on_arcs;
      }
    EXPECT_GT(number_on_arcs, 40);
  }
}

// Squares are the least distorted quads, and here they fit.
TEST(Quad_smoothing, squares_come_back)
{
  const Soup soup = grid(12, 12, 0.25);
  const Quad_surface s = make_surface(soup.points, soup.triangles);
  Quad_complex complex = scattered(s, grid_quads(12, 12), 0.4, 7);
  smooth(complex, s.surface, s.embedding, s.network);
  const std::vector<Coordinates> points = s.points(complex);
  for(int j = 0; j <= 12; ++j)
    for(int i = 0; i <= 12; ++i)
      EXPECT_LT(distance(points[j * 13 + i], { double(i), double(j), 0 }), 0.05) << i << " " << j;
}

TEST(Quad_smoothing, thin_rows_become_wider)
{
  const Soup soup = grid(12, 12);
  const Quad_surface s = make_surface(soup.points, soup.triangles);
  Quad_complex complex = scattered(s, grid_quads(12, 12), 0.01, 7);
  const Surface_walker walker(s.surface, s.embedding);
  for(int j = 1; j < 12; ++j)
    walker.walk(complex.vertices[j * 13 + 1].location, { -0.85, 0, 0 }); // the first column is thin
  smooth(complex, s.surface, s.embedding, s.network);
  EXPECT_GT(s.points(complex)[6 * 13 + 1][0], 0.9);
}

void expect_same_places(const Quad_complex& first, const Quad_complex& second)
{
  for(std::size_t v = 0; v < first.vertices.size(); ++v)
  {
    EXPECT_EQ(first.vertices[v].location.face, second.vertices[v].location.face);
    EXPECT_EQ(first.vertices[v].location.barycentric, second.vertices[v].location.barycentric);
  }
}

TEST(Quad_smoothing, result_is_the_same_every_time)
{
  const Smoothing_case c = smoothing_cases()[0];
  Quad_complex first = scattered(c.surface, c.quads, 0.7, 5), second = first;
  smooth(first, c.surface.surface, c.surface.embedding, c.surface.network);
  smooth(second, c.surface.surface, c.surface.embedding, c.surface.network);
  expect_same_places(first, second);
}

// Between sweeps, vertices that were tried in vain are left out until their quads change. That changes no result.
TEST(Quad_smoothing, vertices_tried_in_vain_would_not_move)
{
  for(const Smoothing_case& c : smoothing_cases())
    for(unsigned seed = 0; seed < 4; ++seed)
    {
      SCOPED_TRACE(c.name + " " + std::to_string(seed));
      Quad_complex first = scattered(c.surface, c.quads, 0.3 + 0.2 * seed, seed), second = first;
      Sliding_quads remembers(first, c.surface.surface, c.surface.embedding, c.surface.network);
      Sliding_quads forgets(second, c.surface.surface, c.surface.embedding, c.surface.network);
      std::vector<int> vertices(remembers.number_of_vertices());
      std::iota(vertices.begin(), vertices.end(), 0);
      const std::vector<std::int64_t> no_changes(vertices.size(), -1);
      std::vector<std::int64_t> tried = no_changes;
      for(int round = 0; round < 4; ++round)
      {
        std::vector<std::int64_t> untried = no_changes;
        EXPECT_EQ(improve_worst_quads(remembers, vertices, 0.9, tried),
                  improve_worst_quads(forgets, vertices, 0.9, untried));
        expect_same_places(first, second);
        run_step(0, remembers);
        run_step(0, forgets);
      }
      EXPECT_NE(tried, no_changes);
    }
}

// The shapes that slides leave are those of the quads where they are.
TEST(Quad_smoothing, shapes_keep_up_with_slides)
{
  for(const Smoothing_case& c : smoothing_cases())
  {
    Quad_complex complex = scattered(c.surface, c.quads, 0.5, 3);
    Sliding_quads quads(complex, c.surface.surface, c.surface.embedding, c.surface.network);
    for(int step = 0; step < 6; ++step)
      run_step(step, quads);
    const Sliding_quads fresh(complex, c.surface.surface, c.surface.embedding, c.surface.network);
    for(int q = 0; q < quads.number_of_quads(); ++q)
    {
      EXPECT_NEAR(quads.shape(q).scaled_jacobian, fresh.shape(q).scaled_jacobian, 1e-9) << c.name;
      EXPECT_NEAR(quads.shape(q).distortion, fresh.shape(q).distortion, 1e-6) << c.name;
    }
  }
}

// Smoothing stops before the first round in which a quarter more quads are inverted than in that of a rival.
TEST(Quad_smoothing, stops_once_a_rival_has_beaten_it)
{
  const Smoothing_case square = smoothing_cases().front();
  const Quad_surface& s = square.surface;
  Quad_complex twisted = scattered(s, square.quads, 0.7, 5);
  for(const int q : { 0, 10 })
    std::swap(twisted.quads[q][1], twisted.quads[q][3]); // clockwise, the one in the corner for good
  const auto smoothed = [&](const int number_of_rounds, const Inverted_quads& rival, Quad_complex& complex)
  {
    complex = twisted;
    Smoothing_options options;
    options.number_of_rounds = number_of_rounds;
    options.untangles = false;
    return smooth_inverted_quads<CGAL::Sequential_tag>(complex, s.surface, s.embedding, s.network, { 0 }, options,
                                                       rival);
  };
  Quad_complex whole, without_rounds, complex;
  const Inverted_quads reference = smoothed(3, Inverted_quads(), whole);
  ASSERT_GT(reference.number_before_round.size(), 1u);
  ASSERT_GT(reference.number_before_round[0], 0u);
  EXPECT_EQ(smoothed(0, Inverted_quads(), without_rounds).number_before_round.size(), 0u);

  const Inverted_quads as_good = smoothed(3, reference, complex);
  EXPECT_EQ(as_good.number_before_round, reference.number_before_round);
  EXPECT_FALSE(as_good.is_beaten);
  expect_same_places(complex, whole);
  Inverted_quads rival = reference;
  rival.number_before_round[0] = 0;
  const Inverted_quads beaten = smoothed(3, rival, complex);
  EXPECT_EQ(beaten.number_before_round.size(), 1u);
  EXPECT_TRUE(beaten.is_beaten);
  expect_same_places(complex, without_rounds);
}

// A ring of quads between the two circles of an annulus, all of whose vertices are kept. If the outer ones are turned
// so far that the quads are inverted, they slide as far as the sides may leave the circles.
TEST(Quad_smoothing, kept_vertices_slide_within_the_tolerance_where_quads_are_inverted)
{
  const int n = 24, outer = 5 * n;
  const double wide = 0.5;
  const Smoothing_case annulus = smoothing_cases().back();
  const Quad_surface& s = annulus.surface;
  for(const int turn : { 0, 5 })
    for(const double tolerance : { 0., wide })
    {
      const Quad_complex flat = scattered(s, {}, 1e-9, 1);
      Quad_complex complex = flat;
      for(int i = 0; i < n; ++i)
      {
        complex.vertices[outer + i] = flat.vertices[outer + (i + turn) % n];
        complex.vertices[outer + i].vertex = outer + (i + turn) % n;
        complex.vertices[i].vertex = i;
        complex.quads.push_back({ i, outer + i, outer + (i + 1) % n, (i + 1) % n });
        complex.patch.push_back(0);
      }
      const std::vector<Coordinates> before = s.points(complex);
      Smoothing_options options;
      options.arc_tolerance = tolerance;
      const Smoothing_report report = smooth(complex, s.surface, s.embedding, s.network, options);
      const bool may_slide = turn != 0 && tolerance == wide;
      EXPECT_EQ(report.inverted_before, turn == 0 ? 0 : n);
      EXPECT_EQ(static_cast<int>(report.inverted_quads.size()), turn == 0 || may_slide ? 0 : n);
      EXPECT_EQ(worst(s, complex, up) > 0, report.inverted_quads.empty());
      const std::vector<Coordinates> after = s.points(complex);
      double largest = 0, least_radius = 9;
      for(int i = 0; i < n; ++i)
      {
        largest = (std::max)(largest, distance(before[outer + i], after[outer + i]));
        const Coordinates& p = after[outer + i];
        const Coordinates& q = after[outer + (i + 1) % n];
        least_radius = (std::min)(least_radius, std::hypot(p[0] + q[0], p[1] + q[1]) / 2);
      }
      EXPECT_EQ(largest > 1e-3, may_slide);
      EXPECT_GE(least_radius, 9 - 2 * tolerance - 0.08); // the sagitta of the circle's own edges is 0.077
    }
}

// A ring of quads between the two circles of an annulus, all of whose vertices are at bends. If the outer ones are
// turned by some edges, others come to the bends, and the quads are straight, unless no turn makes them valid.
TEST(Quad_smoothing, bends_get_the_vertices_that_come_next_to_them)
{
  const int n = 24, outer = 5 * n;
  const Smoothing_case annulus = smoothing_cases().back();
  const Quad_surface& s = annulus.surface;
  for(const int turn : { 0, 1, 3, -3, 5 })
  {
    SCOPED_TRACE(turn);
    const Quad_complex flat = scattered(s, {}, 1e-9, 1);
    Quad_complex complex = flat;
    complex.arcs.resize(2);
    complex.is_loop.assign(2, true);
    complex.has_free_bends.assign(2, false);
    for(int i = 0; i < n; ++i)
    {
      complex.vertices[outer + i] = flat.vertices[outer + (i + turn + n) % n];
      complex.vertices[outer + i].vertex = outer + (i + turn + n) % n;
      complex.vertices[i].vertex = i;
      for(Quad_vertex* const v : { &complex.vertices[i], &complex.vertices[outer + i] })
      {
        v->position = std::fmod(std::round(v->position), n);
        v->location = s.location_on_arc(v->arc, v->position);
      }
      complex.quads.push_back({ i, outer + i, outer + (i + 1) % n, (i + 1) % n });
      complex.patch.push_back(0);
    }
    for(const int first : { 0, outer })
    {
      std::vector<int>& arc = complex.arcs[complex.vertices[first].arc];
      for(int i = 0; i < n; ++i)
        arc.push_back(first + i);
      const bool is_reversed = std::fmod(complex.vertices[arc[1]].position - complex.vertices[arc[0]].position + n, n)
                             > 0.5 * n;
      if(is_reversed)
        std::reverse(arc.begin(), arc.end());
    }
    const double before = worst(s, complex, up);
    const std::vector<Quad_vertex> old_vertices = complex.vertices;
    rechoose_bend_vertices<CGAL::Sequential_tag>(complex, s.surface, s.embedding, s.network, Smoothing_options());
    std::set<int> at_bends;
    for(const Quad_vertex& v : complex.vertices)
      if(v.arc >= 0)
      {
        at_bends.insert(v.vertex);
        EXPECT_EQ(v.position, std::floor(v.position));
        EXPECT_LT(distance(s.point(v.location), s.point(s.location_on_arc(v.arc, v.position))), 1e-12);
      }
    EXPECT_EQ(at_bends.size(), 2u * n);
    EXPECT_EQ(at_bends.count(-1), 0u);
    EXPECT_EQ(before > 0, turn != 5);
    if(before > 0)
    {
      EXPECT_GT(worst(s, complex, up), 0.98);
    }
    else
      for(std::size_t v = 0; v < old_vertices.size(); ++v)
        EXPECT_EQ(complex.vertices[v].vertex, old_vertices[v].vertex);
  }
}

// Whoever slides vertices after a release has to keep the arc as well.
TEST(Quad_smoothing, released_arcs_are_kept_afterward)
{
  const int n = 24, outer = 5 * n;
  const Smoothing_case annulus = smoothing_cases().back();
  const Quad_surface& s = annulus.surface;
  Quad_complex complex = scattered(s, {}, 1e-9, 1);
  for(int i = 0; i < n; ++i)
  {
    complex.vertices[outer + i].vertex = outer + i;
    complex.quads.push_back({ i, outer + i, outer + (i + 1) % n, (i + 1) % n });
    complex.patch.push_back(0);
  }
  ASSERT_TRUE(Sliding_quads(complex, s.surface, s.embedding, s.network, 0.01).release(outer + 1));
  const Sliding_quads quads(complex, s.surface, s.embedding, s.network, 0.01);
  const double length = quads.arc_order().length(outer + 1);
  Slide slide;
  EXPECT_TRUE(quads.slide_on_arc(outer + 1, length + 1e-3, slide));
  EXPECT_FALSE(quads.slide_on_arc(outer + 1, length + 1, slide)); // whose sides are 0.06 from the arc
}

// Rings of quads between two circles, each turned so far against the one inside it that all quads are inverted. To turn
// one vertex after the other hardly helps: its neighbours hold it.
TEST(Quad_smoothing, twisted_rings_are_untwisted)
{
  const int n = 24, number_of_rings = 5;
  const Smoothing_case annulus = smoothing_cases().back();
  const Quad_surface& s = annulus.surface;
  for(const int turn : { -5, 5 })
  {
    SCOPED_TRACE(turn);
    const Quad_complex flat = scattered(s, annulus.quads, 1e-9, 1);
    Quad_complex complex = flat;
    for(int r = 0; r <= number_of_rings; ++r)
      for(int i = 0; i < n; ++i)
        complex.vertices[r * n + i] = flat.vertices[r * n + (i + (turn + n) * r) % n];
    const Quad_complex before = complex;
    const Smoothing_report report = smooth(complex, s.surface, s.embedding, s.network);
    expect_same_but_for_slides(s, before, complex);
    EXPECT_EQ(report.inverted_before, number_of_rings * n);
    EXPECT_EQ(report.inverted_quads.size(), 0u);
    EXPECT_GT(worst(s, complex, up), 0);
  }
}

// A quad whose four vertices are fixed in the wrong order stays inverted, and is counted.
TEST(Quad_smoothing, what_cannot_be_untangled_is_counted)
{
  const Soup soup = grid(2, 1);
  const Quad_surface s = make_surface(soup.points, soup.triangles);
  Quad_complex complex = scattered(s, grid_quads(2, 1), 0.1, 1);
  complex.quads[0] = { 0, 3, 4, 1 }; // clockwise
  Smoothing_report report = smooth(complex, s.surface, s.embedding, s.network);
  EXPECT_EQ(report.inverted_before, 1);
  EXPECT_EQ(report.inverted_quads.size(), 1u);
  EXPECT_LT(report.worst_after, 0);
  complex.quads.clear();
  complex.patch.clear();
  report = smooth(complex, s.surface, s.embedding, s.network);
  EXPECT_EQ(report.inverted_quads.size(), 0u);
}

TEST(Surface_walker, walks_straight_in_a_plane)
{
  const Soup soup = grid(12, 12, 0.3);
  const Quad_surface s = make_surface(soup.points, soup.triangles);
  const Surface_walker walker(s.surface, s.embedding);
  std::mt19937 generator(1);
  const auto random = [&] { return generator() / 4294967296.; };
  for(int i = 0; i < 1000; ++i)
  {
    // From points inside faces, on edges, and at vertices.
    Surface_location location = s.locate(2 + 8 * random(), 2 + 8 * random());
    if(i % 3 == 1)
      location.barycentric = { 0.5, 0.5, 0 };
    if(i % 3 == 2)
      location.barycentric = { 0, 1, 0 };
    const Coordinates p = s.point(location);
    const Coordinates goal{ 0.5 + 11 * random(), 0.5 + 11 * random(), 0 };
    EXPECT_TRUE(walker.walk(location, { goal[0] - p[0], goal[1] - p[1], 5 })); // what is not tangential is left out
    expect_valid_location(location);
    EXPECT_LT(distance(s.point(location), goal), 1e-12);
  }
}

// Unfolding a developable surface gives the plane.
TEST(Surface_walker, walks_on_a_cylinder_as_in_the_plane)
{
  const Soup plane = grid(12, 12), cylinder = bent(plane, 12, CGAL_PI);
  const Quad_surface flat = make_surface(plane.points, plane.triangles);
  const Quad_surface round = make_surface(cylinder.points, cylinder.triangles);
  const Surface_walker flat_walker(flat.surface, flat.embedding), round_walker(round.surface, round.embedding);
  const double chord = distance(cylinder.points[0], cylinder.points[1]); // a strip is narrower than in the plane
  std::mt19937 generator(1);
  const auto random = [&] { return 2 * (generator() / 4294967296.) - 1; };
  for(int i = 0; i < 1000; ++i)
  {
    Surface_location on_flat = flat.locate(6 + 3 * random(), 6 + 3 * random());
    Surface_location on_round = on_flat;
    const double dx = 3 * random(), dy = 3 * random();
    const int h = 3 * on_flat.face;
    const Coordinates& n = round_walker.normal(on_flat.face);
    EXPECT_TRUE(flat_walker.walk(on_flat, { dx, dy, 0 }));
    EXPECT_TRUE(round_walker.walk(on_round, { chord * dx * n[2], dy, -chord * dx * n[0] }));
    EXPECT_EQ(on_flat.face, on_round.face) << h;
    for(int k = 0; k < 3; ++k)
      EXPECT_NEAR(on_flat.barycentric[k], on_round.barycentric[k], 1e-9);
  }
}

TEST(Surface_walker, stops_at_constrained_edges)
{
  const Smoothing_case c = smoothing_cases()[0];
  const Surface_walker walker(c.surface.surface, c.surface.embedding);
  std::mt19937 generator(1);
  const auto random = [&] { return generator() / 4294967296.; };
  int number_of_stops = 0;
  for(int i = 0; i < 1000; ++i)
  {
    Surface_location location = c.surface.locate(12 * random(), 12 * random());
    const int patch = c.surface.patch_of(location.face);
    number_of_stops += !walker.walk(location, { 20 * random() - 10, 20 * random() - 10, 0 });
    expect_valid_location(location);
    EXPECT_EQ(patch, c.surface.patch_of(location.face));
  }
  EXPECT_GT(number_of_stops, 300);
  EXPECT_LT(number_of_stops, 1000);
}

TEST(Quad_measures, scaled_jacobian_is_that_of_the_definition)
{
  std::mt19937 generator(1);
  const auto random = [&] { return generator() / 4294967296.; };
  for(int i = 0; i < 1000; ++i)
  {
    std::array<Coordinates, 4> p;
    for(Coordinates& point : p)
      point = { random(), random(), random() / 4 };
    const Quad_shape shape = quad_shape(p);
    EXPECT_NEAR(shape.scaled_jacobian, scaled_jacobian(p), 1e-12);
    const bool is_inverted = shape.scaled_jacobian <= 0;
    EXPECT_EQ(is_inverted, shape.distortion == std::numeric_limits<double>::infinity());
    EXPECT_GE(shape.distortion, is_inverted ? 4 : 3 + 1 / shape.scaled_jacobian);
  }
  const double tangent = 0.75; // of a parallelogram with a sine of 0.8
  EXPECT_NEAR(quad_shape({ { { 0, 0, 0 }, { 3, 0, 0 }, { 3 + tangent, 1, 0 }, { tangent, 1, 0 } } }).scaled_jacobian,
              0.8, 1e-15);
  const Quad_shape square = quad_shape({ { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } } }, { 0, 0, -1 });
  EXPECT_EQ(square.scaled_jacobian, -1);
  EXPECT_EQ(quad_shape({ { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } } }).distortion, 4);
  EXPECT_NEAR(quad_shape({ { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 0, 1, 0 } } }).distortion,
              4 * (1 + weight_of_side_ratio * 2 / 3), 1e-14);
  EXPECT_EQ(quad_shape({ { { 0, 0, 0 }, { 0, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } } }).scaled_jacobian, 0);
}

TEST(Quad_measures, figures_of_a_grid_with_a_hole)
{
  const Soup soup = grid(12, 12);
  const Quad_surface s = make_surface(soup.points, soup.triangles);
  Quad_complex complex = scattered(s, grid_quads(12, 12), 0, 1);
  CGAL::Frame_fields::Quad_quality quality = measure_quads(polygon_mesh(complex, soup.points));
  EXPECT_EQ(quality.number_of_quads, 144u);
  EXPECT_EQ(quality.minimum_scaled_jacobian, 1);
  EXPECT_EQ(quality.mean_scaled_jacobian, 1);
  EXPECT_EQ(quality.number_of_inverted_quads + quality.number_of_bad_quads, 0u);
  EXPECT_EQ(quality.number_of_irregular_vertices + quality.number_of_irregular_sectors, 0u);
  EXPECT_EQ(quality.minimum_edge_length, 1);
  EXPECT_EQ(quality.maximum_edge_length, 1);
  EXPECT_NEAR(quality.mean_edge_length, 1, 1e-15);

  // Without quad 60 its corners have a sector of 270 degrees with three quads.
  complex.quads.erase(complex.quads.begin() + 60);
  complex.patch.pop_back();
  std::vector<Coordinates> points = soup.points;
  quality = measure_quads(polygon_mesh(complex, points));
  EXPECT_EQ(quality.number_of_irregular_vertices + quality.number_of_irregular_sectors, 0u);
  // A vertex that is moved over its neighbour inverts two quads.
  points[14 * 2] = { points[14 * 2][0] + 1.5, points[14 * 2][1], 0 };
  quality = measure_quads(polygon_mesh(complex, points));
  EXPECT_EQ(quality.number_of_inverted_quads, 2u);
  EXPECT_EQ(quality.number_of_bad_quads, 2u);
  EXPECT_EQ(quality.minimum_edge_length, 0.5);

  // Of three cubes' faces around a vertex it is irregular, and so are sectors that are cut at other places.
  std::vector<char> is_on_arc(4 * complex.quads.size(), false);
  is_on_arc[0] = true; // at the border: no change
  EXPECT_EQ(measure_quads(polygon_mesh(complex, soup.points, is_on_arc)).number_of_irregular_sectors, 0u);
}

TEST(Quad_measures, flat_corners_count_as_inverted_and_small_sines_as_bad)
{
  const auto quality_of_one = [](const std::vector<Coordinates>& points)
  {
    Quad_complex complex;
    complex.quads = { { 0, 1, 2, 3 } };
    complex.patch = { 0 };
    return measure_quads(polygon_mesh(complex, points));
  };
  EXPECT_EQ(quality_of_one({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 2, 0 } }).number_of_inverted_quads, 1u);
  for(const double sine : { 0.19, 0.21, 0.39 })
  {
    const double cosine = std::sqrt(1 - sine * sine);
    const CGAL::Frame_fields::Quad_quality quality =
      quality_of_one({ { 0, 0, 0 }, { 1, 0, 0 }, { 1 + cosine, sine, 0 }, { cosine, sine, 0 } });
    EXPECT_EQ(quality.number_of_inverted_quads, 0u);
    EXPECT_EQ(quality.number_of_bad_quads, sine < 0.2 ? 1u : 0u);
  }
}

TEST(Quad_measures, corner_of_a_cube_and_cut_sectors)
{
  Quad_complex complex;
  complex.quads = { { 0, 1, 4, 2 }, { 0, 2, 5, 3 }, { 0, 3, 6, 1 } };
  complex.patch = { 0, 0, 0 };
  complex.vertices.resize(7);
  const std::vector<Coordinates> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 }, { 0, 1, 1 },
                                         { 1, 0, 1 } };
  EXPECT_EQ(measure_quads(polygon_mesh(complex, points)).number_of_irregular_vertices, 1u);
  EXPECT_EQ(measure_quads(polygon_mesh(complex, points)).number_of_irregular_sectors, 0u);
  complex.patch = { 0, 1, 2 }; // its edges are features: three sectors of 90 degrees, and two at each end of an edge
  EXPECT_EQ(measure_quads(polygon_mesh(complex, points)).number_of_irregular_vertices, 0u);
  EXPECT_EQ(measure_quads(polygon_mesh(complex, points)).number_of_irregular_sectors, 0u);
  const std::vector<Coordinates> flat{ { 0, 0, 0 }, { 1, 0, 0 }, { -0.2, 0.9, 0 }, { -1, -1, 0 }, { 1, 1, 0 },
                                       { -1.5, 0.3, 0 }, { 0.5, -1, 0 } };
  EXPECT_EQ(measure_quads(polygon_mesh(complex, flat)).number_of_irregular_sectors, 1u); // of more than 135 degrees
}

} // namespace
