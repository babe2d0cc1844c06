#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/detect_feature_edges.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace {

using namespace test;
using parameters::strong_angle_in_degrees;

typedef std::set<std::pair<Point, Point> > Segments;

template <typename Mesh>
std::pair<Point, Point> segment_of(const Mesh& mesh, const typename boost::graph_traits<Mesh>::edge_descriptor e)
{
  const auto points = get(CGAL::vertex_point, mesh);
  return segment(get(points, source(e, mesh)), get(points, target(e, mesh)));
}

template <typename Mesh>
bool is_on_border(const Mesh& mesh, const typename boost::graph_traits<Mesh>::edge_descriptor e)
{
  return is_border(halfedge(e, mesh), mesh) || is_border(opposite(halfedge(e, mesh), mesh), mesh);
}

// The features inside the surface.
template <typename Mesh, typename NamedParameters>
Segments detected(const Cad_mesh<Mesh>& cad_mesh, const NamedParameters& np)
{
  const auto is_feature = get(CGAL::dynamic_edge_property_t<bool>(), cad_mesh.mesh);
  EXPECT_TRUE(FF::detect_feature_edges(cad_mesh.mesh, is_feature, np));
  Segments result;
  for(const auto e : edges(cad_mesh.mesh))
  {
    EXPECT_TRUE(get(is_feature, e) || !is_on_border(cad_mesh.mesh, e));
    if(get(is_feature, e) && !is_on_border(cad_mesh.mesh, e))
      result.insert(segment_of(cad_mesh.mesh, e));
  }
  return result;
}

// The angle between the normals at an edge in degrees, by CGAL.
template <typename Mesh>
double angle_at(const Mesh& mesh, const typename boost::graph_traits<Mesh>::edge_descriptor e)
{
  if(is_on_border(mesh, e))
    return 0;
  const auto points = get(CGAL::vertex_point, mesh);
  const auto h = halfedge(e, mesh);
  return 180 - std::abs(CGAL::approximate_dihedral_angle(
    get(points, source(h, mesh)), get(points, target(h, mesh)), get(points, target(next(h, mesh), mesh)),
    get(points, target(next(opposite(h, mesh), mesh), mesh))));
}

// A long roof with its ridge at x = 0. It has these angles at the vertices of the ridge, where rows of length 100
// begin, and their means at the edges between them.
Model roof(const std::vector<double>& angles_in_degrees)
{
  Model result;
  for(const double angle : angles_in_degrees)
  {
    const double y = 100. * static_cast<double>(result.points.size() / 3), z = -std::tan(angle / 2 * degree);
    const std::size_t p = result.points.size();
    result.points.insert(result.points.end(), { Point(-1, y, z), Point(0, y, 0), Point(1, y, z) });
    if(p > 0)
      for(const std::size_t q : { p - 3, p - 2 })
        result.triangles.insert(result.triangles.end(), { Triangle{ q, q + 1, q + 4 }, Triangle{ q, q + 4, q + 3 } });
  }
  return result;
}

// The piece of the ridge of a roof from one vertex to another.
Segments ridge(const int begin, const int end)
{
  Segments result;
  for(int k = begin; k < end; ++k)
    result.insert(segment(Point(0, 100 * k, 0), Point(0, 100 * (k + 1), 0)));
  return result;
}

Segments join(Segments a, const Segments& b)
{
  a.insert(b.begin(), b.end());
  return a;
}

template <typename Mesh>
class Feature_detection : public testing::Test {};
TYPED_TEST_SUITE(Feature_detection, Mesh_classes, Mesh_class_names);

TYPED_TEST(Feature_detection, follows_a_crease_that_fades_out)
{
  const Cad_mesh<TypeParam> cad_mesh(roof({ 80, 70, 60, 50, 40, 30, 20, 10, 0 }), false);
  EXPECT_EQ(ridge(0, 4), detected(cad_mesh, strong_angle_in_degrees(40)));
  EXPECT_EQ(ridge(0, 6), detected(cad_mesh, strong_angle_in_degrees(40).weak_angle_in_degrees(20)));
}

TYPED_TEST(Feature_detection, does_not_take_a_crease_that_is_weak_all_along)
{
  const Cad_mesh<TypeParam> cad_mesh(roof(std::vector<double>(9, 30)), false);
  EXPECT_EQ(Segments(), detected(cad_mesh, strong_angle_in_degrees(40).weak_angle_in_degrees(20)));
  EXPECT_EQ(ridge(0, 8), detected(cad_mesh, strong_angle_in_degrees(29)));
}

TYPED_TEST(Feature_detection, closes_gaps_of_one_edge_only)
{
  const double high = 24, low = 14; // degrees, and 19 between them
  const Cad_mesh<TypeParam> gap_of_one(roof({ high, high, high, low, low, high, high, high }), false);
  EXPECT_EQ(join(ridge(0, 3), ridge(4, 7)), detected(gap_of_one, strong_angle_in_degrees(18)));
  EXPECT_EQ(ridge(0, 7), detected(gap_of_one, strong_angle_in_degrees(18).close_gaps(true)));

  const Cad_mesh<TypeParam> gap_of_two(roof({ high, high, high, low, low, low, high, high, high }), false);
  EXPECT_EQ(join(ridge(0, 3), ridge(5, 8)),
            detected(gap_of_two, strong_angle_in_degrees(18).close_gaps(true)));
}

TYPED_TEST(Feature_detection, removes_a_dangling_chain_shorter_than_the_minimum)
{
  const double high = 24, low = 14; // degrees, and 19 between them
  const Cad_mesh<TypeParam> cad_mesh(roof({ high, high, high, low, low, low, low, high, low, low, low }), false);
  const Segments from_border = ridge(0, 3), island = ridge(6, 8);
  EXPECT_EQ(join(from_border, island), detected(cad_mesh, strong_angle_in_degrees(18)));
  EXPECT_EQ(join(from_border, island), detected(cad_mesh, strong_angle_in_degrees(18).minimum_chain_length(199)));
  EXPECT_EQ(from_border, detected(cad_mesh, strong_angle_in_degrees(18).minimum_chain_length(201)));
  EXPECT_EQ(Segments(), detected(cad_mesh, strong_angle_in_degrees(18).minimum_chain_length(301)));
}

TYPED_TEST(Feature_detection, keeps_the_long_chain_and_removes_the_spur_on_it)
{
  // A ridge along x = 0, and one across it from the third of ten rows that ends after two columns.
  const Model model = grid(10, 10, false, false, [](const double u, const double v)
  {
    const double x = u - 0.5, y = v - 0.3;
    const bool is_on_spur = x > 0 && x < 0.25 && std::abs(y) < 0.05;
    return Point(x, v, -std::abs(x) + (is_on_spur ? 0.15 : 0));
  });
  const Cad_mesh<TypeParam> cad_mesh(model, false);
  const auto is_on_ridge = [](const std::pair<Point, Point>& s) { return s.first.x() == 0 && s.second.x() == 0; };
  const Segments with_spur = detected(cad_mesh, strong_angle_in_degrees(40));
  const Segments without = detected(cad_mesh, strong_angle_in_degrees(40).minimum_chain_length(0.9));
  EXPECT_FALSE(std::all_of(with_spur.begin(), with_spur.end(), is_on_ridge));
  EXPECT_EQ(10u, std::count_if(without.begin(), without.end(), is_on_ridge));
}

TYPED_TEST(Feature_detection, removes_no_boundary_of_a_patch)
{
  const Cad_mesh<TypeParam> cad_mesh(cube(), false);
  const Segments all_edges = detected(cad_mesh, strong_angle_in_degrees(40));
  EXPECT_EQ(12u, all_edges.size());
  EXPECT_EQ(all_edges, detected(cad_mesh, parameters::minimum_chain_length(std::numeric_limits<double>::infinity())));
}

TYPED_TEST(Feature_detection, removes_a_closed_chain_that_meets_no_other)
{
  const Model round_roof = grid(24, 4, true, false, [](const double u, const double v)
  {
    return Point((1 + v) * std::cos(360 * degree * u), (1 + v) * std::sin(360 * degree * u), -std::abs(v - 0.5));
  });
  const Cad_mesh<TypeParam> cad_mesh(round_roof, false);
  const Segments ridge = detected(cad_mesh, strong_angle_in_degrees(40));
  EXPECT_EQ(24u, ridge.size());
  const double length = 24 * 2 * 1.5 * std::sin(7.5 * degree);
  EXPECT_EQ(ridge, detected(cad_mesh, strong_angle_in_degrees(40).minimum_chain_length(0.999 * length)));
  EXPECT_EQ(Segments(), detected(cad_mesh, strong_angle_in_degrees(40).minimum_chain_length(1.001 * length)));
}

// A graph of edges in the plane, the first ones of which are features.
struct Drawn_features
{
  FF::internal::Feature_graph graph;

  typedef std::vector<std::array<int, 2> > Pairs;

  Drawn_features(const std::vector<Point>& points, const Pairs& features, const Pairs& others = {})
  {
    for(const Point& p : points)
      graph.points.push_back({ p.x(), p.y(), p.z() });
    graph.ends = features;
    graph.ends.insert(graph.ends.end(), others.begin(), others.end());
    for(const auto& [a, b] : graph.ends)
      graph.length.push_back(FF::internal::distance(graph.points[a], graph.points[b]));
    graph.is_border.assign(graph.ends.size(), false);
    graph.is_feature.assign(features.size(), true);
    graph.is_feature.resize(graph.ends.size(), false);
  }

  std::vector<int> features() const
  {
    std::vector<int> result;
    for(int e = 0; e < graph.number_of_edges(); ++e)
      if(graph.is_feature[e])
        result.push_back(e);
    return result;
  }
};

TEST(Gap, is_not_closed_around_a_right_angle)
{
  const std::vector<Point> square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  Drawn_features opposite_sides(square, { { 0, 1 }, { 2, 3 } }, { { 1, 2 } });
  FF::internal::join_dangling_ends(opposite_sides.graph);
  EXPECT_EQ((std::vector<int>{ 0, 1 }), opposite_sides.features());
}

TEST(Gap, is_closed_where_the_features_turn_the_least)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0.5, 0 }, { 3, 1, 0 }, { 2, 0.1, 0 },
                                      { 3, 0.2, 0 } };
  Drawn_features fork(points, { { 0, 1 }, { 2, 3 }, { 4, 5 } }, { { 1, 2 }, { 1, 4 } });
  FF::internal::join_dangling_ends(fork.graph);
  EXPECT_EQ((std::vector<int>{ 0, 1, 2, 4 }), fork.features());
}

TEST(Chain, that_has_become_longer_as_its_neighbor_went_is_measured_anew)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 5, 0, 0 }, { 6, 1, 0 }, { 6.5, -1, 0 } };
  Drawn_features fork(points, { { 0, 1 }, { 1, 2 }, { 1, 3 } });
  FF::internal::remove_short_chains(fork.graph, 3);
  EXPECT_EQ((std::vector<int>{ 0, 2 }), fork.features());
}

// Removes the shortest chain again and again.
std::vector<char> without_short_chains(FF::internal::Feature_graph graph, const double minimum_length)
{
  for(auto chains = FF::internal::removable_chains(graph, minimum_length); !chains.empty();
      chains = FF::internal::removable_chains(graph, minimum_length))
    for(const int e : chains.begin()->edges)
      graph.is_feature[e] = false;
  return graph.is_feature;
}

TEST(Chain, removals_at_stars_are_those_one_by_one)
{
  std::mt19937 generator(7);
  std::set<std::size_t> numbers_of_features_left;
  for(int star = 0; star < 300; ++star)
  {
    const int number_of_rays = 2 + static_cast<int>(generator() % 6);
    std::vector<Point> points = { { 0, 0, 0 } };
    Drawn_features::Pairs rays;
    for(int ray = 1; ray <= number_of_rays; ++ray)
    {
      const double angle = ray, length = 0.1 + 1e-3 * static_cast<double>(generator() % 1000);
      points.emplace_back(length * std::cos(angle), length * std::sin(angle), 0);
      rays.push_back({ 0, ray });
    }
    Drawn_features drawn(points, rays);
    const std::vector<char> expected = without_short_chains(drawn.graph, 1);
    FF::internal::remove_short_chains(drawn.graph, 1);
    EXPECT_EQ(expected, drawn.graph.is_feature);
    numbers_of_features_left.insert(drawn.features().size());
  }
  EXPECT_LT(2u, numbers_of_features_left.size());
}

TEST(Chain, removals_at_a_vertex_with_many_take_little_time)
{
  std::vector<Point> points = { { 0, 0, 0 } };
  Drawn_features::Pairs rays;
  for(int ray = 1; ray <= 30000; ++ray) // one round each would take minutes
  {
    points.emplace_back(std::cos(ray), std::sin(ray), 1e-6 * ray);
    rays.push_back({ 0, ray });
  }
  Drawn_features star(points, rays);
  FF::internal::remove_short_chains(star.graph, 3);
  EXPECT_TRUE(star.features().empty());
}

TYPED_TEST(Feature_detection, does_not_depend_on_the_unit_of_length)
{
  for(const double scale : { 1e-300, 1e-150, 1e150, 1e300 })
  {
    const Cad_mesh<TypeParam> cad_mesh(transformed(cube(), [&](const Point& p)
      { return Point(scale * p.x(), scale * p.y(), scale * p.z()); }), false);
    EXPECT_EQ(12u, detected(cad_mesh, strong_angle_in_degrees(40)).size()) << scale;
  }
}

TYPED_TEST(Feature_detection, sees_a_crease_through_a_face_without_area)
{
  const Point a(0, 0, 0), b(0, 2, 0), middle(0, 1, 0), left(-1, 1, -1), right(1, 1, -1);
  const Model model{ { a, b, middle, left, right },
                     { { { 0, 1, 3 } }, { { 0, 2, 1 } }, { { 0, 4, 2 } }, { { 2, 4, 1 } } }, {} };
  const Cad_mesh<TypeParam> cad_mesh(model, false);
  EXPECT_EQ((Segments{ segment(a, middle), segment(middle, b) }), detected(cad_mesh, strong_angle_in_degrees(40)));
}

// A plate of size 100 and thickness 5 with a hole of many facets, from whose rims needles run to the corners; turned,
// so that its planes are not along the axes, shifted, and rounded as in a file of `float`.
Model rounded_plate_with_hole(const double radius, const int number_of_facets, const double shift)
{
  Model model;
  const auto add = [&](const double x, const double y, const double z)
  {
    const auto rounded = [shift](const double u) { return static_cast<double>(static_cast<float>(u + shift)); };
    model.points.push_back(Point(rounded((2 * x - 2 * y + z) / 3), rounded((x + 2 * y + 2 * z) / 3),
                                 rounded((-2 * x - y + 2 * z) / 3)));
  };
  const int n = number_of_facets, layer = 4 + n;
  for(const double z : { 0., 5. })
  {
    for(int k = 0; k < 4; ++k)
      add(k == 0 || k == 3 ? 50 : -50, k < 2 ? 50 : -50, z);
    for(int k = 0; k < n; ++k)
      add(radius * std::cos(2 * CGAL_PI * k / n), radius * std::sin(2 * CGAL_PI * k / n), z);
  }
  const auto rim = [&](const int k) { return static_cast<std::size_t>(4 + k % n); };
  const auto corner = [](const int k) { return static_cast<std::size_t>(k % 4); };
  const auto add_both = [&](const std::size_t a, const std::size_t b, const std::size_t c)
  {
    model.triangles.push_back({ { layer + a, layer + b, layer + c } });
    model.triangles.push_back({ { c, b, a } });
  };
  const auto add_wall = [&](const std::size_t a, const std::size_t b)
  {
    model.triangles.push_back({ { a, b, layer + b } });
    model.triangles.push_back({ { a, layer + b, layer + a } });
  };
  for(int k = 0; k < 4; ++k)
  {
    add_both(corner(k), corner(k + 1), rim((k + 1) * n / 4));
    add_wall(corner(k), corner(k + 1));
  }
  for(int k = 0; k < n; ++k)
  {
    add_both(corner(4 * k / n), rim(k + 1), rim(k));
    add_wall(rim(k + 1), rim(k));
  }
  return model;
}

TEST(Flat_face, makes_no_feature_where_coordinates_are_rounded)
{
  for(const double radius : { 5., 10. })
    for(const double shift : { 0., 1e4, 1e5 })
    {
      const Cad_mesh<Surface_mesh> cad_mesh(rounded_plate_with_hole(radius, 2000, shift), false);
      EXPECT_EQ(12u + 2 * 2000, detected(cad_mesh, strong_angle_in_degrees(40)).size()) << radius << ' ' << shift;
    }
  // Otherwise the needles would count, and this test would tell nothing.
  const Cad_mesh<Surface_mesh> noisy(rounded_plate_with_hole(5, 2000, 1e5), false);
  EXPECT_LT(12u + 2 * 2000, detected(noisy, parameters::coordinate_error(0)).size());
}

TEST(Flat_face, has_a_normal_if_coordinates_are_exact)
{
  const auto crease = [](const double height)
  {
    const Point a(0, 0, 0), b(1, 0, 0), below(0.5, -1, 0), above(0.5, 1, 0);
    return Cad_mesh<Surface_mesh>(
      Model{ { a, b, below, above, Point(0.3, 0, height) },
             { { { 0, 1, 4 } }, { { 1, 0, 2 } }, { { 0, 4, 3 } }, { { 4, 1, 3 } } }, {} }, false);
  };
  EXPECT_EQ(0u, detected(crease(1e-17), parameters::coordinate_error(0)).size());
  EXPECT_EQ(3u, detected(crease(1e-9), parameters::coordinate_error(0)).size());
  EXPECT_EQ(0u, detected(crease(1e-9), strong_angle_in_degrees(40)).size());
  EXPECT_EQ(3u, detected(crease(1e-3), strong_angle_in_degrees(40)).size());
  EXPECT_EQ(0u, detected(crease(1e-3), parameters::coordinate_error(1e-3)).size());
}

TYPED_TEST(Feature_detection, does_not_read_isolated_vertices)
{
  Cad_mesh<TypeParam> cad_mesh(cube(), false);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  put(get(CGAL::vertex_point, cad_mesh.mesh), add_vertex(cad_mesh.mesh), Point(0, nan, 0));
  EXPECT_EQ(12u, detected(cad_mesh, strong_angle_in_degrees(40)).size());
  TypeParam empty;
  EXPECT_EQ(FF::ERROR_EMPTY_MESH,
            FF::detect_feature_edges(empty, get(CGAL::dynamic_edge_property_t<bool>(), empty)).error_code);
}

TYPED_TEST(Feature_detection, refuses_what_it_cannot_read_and_writes_nothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_error = [](const FF::Error_code error_code, const auto& mesh, const auto& np)
  {
    const auto is_feature = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
    for(const auto e : edges(mesh))
      put(is_feature, e, true);
    EXPECT_EQ(error_code, FF::detect_feature_edges(mesh, is_feature, np).error_code);
    for(const auto e : edges(mesh))
      EXPECT_TRUE(get(is_feature, e));
  };
  Cad_mesh<TypeParam> cad_mesh(square(2), false);
  for(const double angle : { nan, -1., 181. })
    expect_error(FF::ERROR_WRONG_PARAMETER, cad_mesh.mesh, strong_angle_in_degrees(angle));
  for(const double angle : { nan, -1., 41. })
    expect_error(FF::ERROR_WRONG_PARAMETER, cad_mesh.mesh, strong_angle_in_degrees(40).weak_angle_in_degrees(angle));
  for(const double length : { nan, -1. })
    expect_error(FF::ERROR_WRONG_PARAMETER, cad_mesh.mesh, parameters::minimum_chain_length(length));
  expect_error(FF::ERROR_WRONG_PARAMETER, cad_mesh.mesh, parameters::coordinate_error(-1e-9));

  put(get(CGAL::vertex_point, cad_mesh.mesh), *vertices(cad_mesh.mesh).begin(), Point(0, nan, 0));
  expect_error(FF::ERROR_NON_FINITE_COORDINATE, cad_mesh.mesh, strong_angle_in_degrees(40));

  TypeParam quadrangle;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), quadrangle);
  expect_error(FF::ERROR_NON_TRIANGULAR_MESH, quadrangle, strong_angle_in_degrees(40));
}

TYPED_TEST(Feature_detection, lists_dangling_ends)
{
  const Cad_mesh<TypeParam> cad_mesh(planar({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } }, 1,
                                            { { { 0, 2 }, { 2, 2 } }, { { 1, 1 }, { 3, 1 } } }), false);
  std::vector<typename boost::graph_traits<TypeParam>::vertex_descriptor> ends;
  FF::dangling_feature_ends(cad_mesh.mesh, cad_mesh.is_feature, std::back_inserter(ends));
  std::set<Point> points;
  for(const auto v : ends)
    points.insert(get(get(CGAL::vertex_point, cad_mesh.mesh), v));
  EXPECT_EQ((std::set<Point>{ Point(2, 2, 0), Point(1, 1, 0), Point(3, 1, 0) }), points);
  EXPECT_EQ(3u, ends.size());
}

class Feature_detection_on_models : public On_models {};

TEST_P(Feature_detection_on_models, with_one_angle_is_that_of_cgal)
{
  const Cad_mesh<Surface_mesh> cad_mesh(GetParam().make(), false);
  const auto expected = get(CGAL::dynamic_edge_property_t<bool>(), cad_mesh.mesh);
  CGAL::Polygon_mesh_processing::detect_sharp_edges(cad_mesh.mesh, 40.01, expected);
  const auto is_feature = get(CGAL::dynamic_edge_property_t<bool>(), cad_mesh.mesh);
  ASSERT_TRUE(FF::detect_feature_edges(cad_mesh.mesh, is_feature,
                                       strong_angle_in_degrees(40.01).coordinate_error(0)));
  for(const auto e : edges(cad_mesh.mesh))
    EXPECT_EQ(get(expected, e), get(is_feature, e)) << e;
}

TEST_P(Feature_detection_on_models, with_two_angles_takes_what_is_connected_with_a_strong_edge)
{
  const Cad_mesh<Surface_mesh> cad_mesh(GetParam().make(), false);
  const Surface_mesh& mesh = cad_mesh.mesh;
  const auto is_feature = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  ASSERT_TRUE(FF::detect_feature_edges(
    mesh, is_feature, strong_angle_in_degrees(40.01).weak_angle_in_degrees(20.01).coordinate_error(0)));

  std::map<Surface_mesh::Vertex_index, Surface_mesh::Vertex_index> parent; // of a forest of connected vertices
  const auto root = [&](Surface_mesh::Vertex_index v)
  {
    while(parent.emplace(v, v).first->second != v)
      v = parent[v];
    return v;
  };
  for(const auto e : edges(mesh))
    if(angle_at(mesh, e) >= 20.01)
      parent[root(source(e, mesh))] = root(target(e, mesh));
  std::set<Surface_mesh::Vertex_index> strong_roots;
  for(const auto e : edges(mesh))
    if(angle_at(mesh, e) >= 40.01)
      strong_roots.insert(root(source(e, mesh)));
  for(const auto e : edges(mesh))
  {
    const bool is_connected = angle_at(mesh, e) >= 20.01 && strong_roots.count(root(source(e, mesh))) > 0;
    EXPECT_EQ(is_on_border(mesh, e) || is_connected, get(is_feature, e)) << e;
  }
}

INSTANTIATE_TEST_SUITE_P(Cgal, Feature_detection_on_models, testing::ValuesIn(cgal_models()), Model_name());

} // namespace
