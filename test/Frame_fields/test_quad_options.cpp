// What callers ask of single elements of a quad mesh, and quads of given fields.

#include "random_models.h"
#include "test_cad_mesh.h"
#include "test_solver_traits.h"

#include <CGAL/Frame_fields/No_index_target.h>
#include <CGAL/Frame_fields/cad_quad_mesh.h>
#include <CGAL/Frame_fields/compute_quad_sizes.h>
#include <CGAL/Frame_fields/prepare_for_frame_field.h>
#include <CGAL/Frame_fields/quad_mesh.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test;

typedef boost::graph_traits<Surface_mesh> Graph_traits;
typedef std::pair<Graph_traits::face_descriptor, std::array<double, 3> > Location;

// By points, so that they serve a mesh and its refinements.
struct Wishes
{
  std::function<double(const Point&)> length = [](const Point&) { return 0.25; };
  std::function<int(const Point&)> number = [](const Point&) { return 0; }; // of a curve, by the middles of edges
  std::function<bool(const Point&)> is_node = [](const Point&) { return false; };
  bool repairs = true, refines = true, field_follows_sizes = false;
  // By the middles of faces.
  std::function<Vector(const Point&)> direction = [](const Point&) { return Vector(0, 0, 0); };
  std::function<double(const Point&)> weight = [](const Point&) { return 0; };
  std::function<int(const Point&)> index = [](const Point&) { return FF::NO_INDEX_TARGET; };
};

struct Quads
{
  FF::Result result;
  FF::Quad_statistics statistics;
  Surface_mesh mesh;
  std::vector<bool> is_on_feature;   // per edge
  std::vector<Location> locations;   // per vertex
  std::vector<int> fallback_patches;
};

Point middle(const Surface_mesh& mesh, const Graph_traits::edge_descriptor e)
{
  return CGAL::midpoint(mesh.point(source(e, mesh)), mesh.point(target(e, mesh)));
}

Point middle(const Surface_mesh& mesh, const Graph_traits::face_descriptor f)
{
  const auto h = halfedge(f, mesh);
  return CGAL::centroid(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                        mesh.point(target(next(h, mesh), mesh)));
}

auto with_guidance(const Cad_mesh<Surface_mesh>& cad_mesh, const Wishes& wishes)
{
  const Surface_mesh& mesh = cad_mesh.mesh;
  return cad_mesh.features().guiding_direction_map(
      boost::make_function_property_map<Graph_traits::face_descriptor, Vector>(
        [&](const auto f) { return wishes.direction(middle(mesh, f)); }))
    .guiding_weight_map(boost::make_function_property_map<Graph_traits::face_descriptor, double>(
        [&](const auto f) { return wishes.weight(middle(mesh, f)); }))
    .index_target_map(boost::make_function_property_map<Graph_traits::halfedge_descriptor, int>(
        [&](const auto h) { return wishes.index(mesh.point(target(h, mesh))); }));
}

// `make(quad_mesh, np)` is called with all named parameters that the two functions have.
template <typename Make>
Quads quads_with(const Cad_mesh<Surface_mesh>& cad_mesh, const Wishes& wishes, const Make& make)
{
  const Surface_mesh& mesh = cad_mesh.mesh;
  const auto length = boost::make_function_property_map<Graph_traits::vertex_descriptor, double>(
    [&](const auto v) { return wishes.length(mesh.point(v)); });
  const auto is_node = boost::make_function_property_map<Graph_traits::vertex_descriptor, bool>(
    [&](const auto v) { return wishes.is_node(mesh.point(v)); });
  const auto number = boost::make_function_property_map<Graph_traits::edge_descriptor, int>(
    [&](const auto e) { return wishes.number(middle(mesh, e)); });
  Quads quads;
  const auto is_on_feature = get(CGAL::dynamic_edge_property_t<bool>(), quads.mesh);
  const auto location = get(CGAL::dynamic_vertex_property_t<Location>(), quads.mesh);
  quads.result = make(quads.mesh, with_guidance(cad_mesh, wishes)
                                    .sizing_map(length).vertex_is_constrained_map(is_node)
                                    .number_of_edges_map(number).repair_matching(wishes.repairs)
                                    .refine_long_triangles(wishes.refines)
                                    .field_follows_sizes(wishes.field_follows_sizes)
                                    .output_edge_is_constrained_map(is_on_feature)
                                    .vertex_to_face_location_map(location)
                                    .fallback_patch_output_iterator(std::back_inserter(quads.fallback_patches))
                                    .statistics(std::ref(quads.statistics)));
  for(const auto e : edges(quads.mesh))
    quads.is_on_feature.push_back(get(is_on_feature, e));
  for(const auto v : vertices(quads.mesh))
    quads.locations.push_back(get(location, v));
  return quads;
}

Quads quads_of(const Cad_mesh<Surface_mesh>& cad_mesh, const Wishes& wishes = Wishes())
{
  const Quads quads = quads_with(cad_mesh, wishes, [&](Surface_mesh& quad_mesh, const auto& np)
                                 { return FF::cad_quad_mesh(cad_mesh.mesh, quad_mesh, np); });
  EXPECT_TRUE(!quads.result || CGAL::is_valid_polygon_mesh(quads.mesh));
  return quads;
}

template <typename Maps>
Quads quads_of_field(const Cad_mesh<Surface_mesh>& cad_mesh, const Maps& maps, const Wishes& wishes = Wishes())
{
  return quads_with(cad_mesh, wishes, [&](Surface_mesh& quad_mesh, const auto& np)
                    { return FF::quad_mesh(cad_mesh.mesh, maps.alpha, maps.rho, maps.matching, maps.index, quad_mesh,
                                           np); });
}

void expect_same(const Surface_mesh& expected, const Surface_mesh& actual)
{
  ASSERT_EQ(num_vertices(expected), num_vertices(actual));
  ASSERT_EQ(num_faces(expected), num_faces(actual));
  for(const auto v : vertices(expected))
    ASSERT_EQ(expected.point(v), actual.point(v));
  for(const auto h : halfedges(expected))
    ASSERT_EQ(target(h, expected), target(h, actual));
}

// Around the hole, the outer border rises by a step that no map can have.
Model ring_with_step()
{
  Polyline border, hole;
  for(int i = 0; i <= 24; ++i)
  {
    const double angle = 15 * degree * i, radius = 2 + 0.6 * i / 24;
    border.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    if(i < 24)
      hole.push_back({ std::cos(angle), std::sin(angle) });
  }
  return planar(border, 0.3, {}, { hole });
}

// A closed prism over a regular polygon as CAD programs write it: sides of two needles, ends that are fans of needles.
Model raw_prism(const std::size_t n, const double height)
{
  Model model;
  for(std::size_t k = 0; k < 2 * n; ++k)
  {
    const double angle = static_cast<double>(k / 2) * 2 * CGAL_PI / static_cast<double>(n);
    model.points.emplace_back(std::cos(angle), std::sin(angle), height * static_cast<double>(k % 2));
  }
  for(std::size_t k = 0; k < n; ++k)
  {
    const std::size_t low = 2 * k, next = 2 * ((k + 1) % n);
    model.triangles.push_back({ low, next, low + 1 });
    model.triangles.push_back({ low + 1, next, next + 1 });
    for(const std::size_t side : { 0, 1 })
      model.features.push_back(segment(model.points[low + side], model.points[next + side]));
    if(k > 0 && k + 1 < n)
    {
      model.triangles.push_back({ 0, next, low });
      model.triangles.push_back({ 1, low + 1, next + 1 });
    }
  }
  return model;
}

// A pipe of the same kind.
Model raw_pipe(const std::size_t n, const double height)
{
  Model model;
  for(const double radius : { 1., 0.5 })
    for(std::size_t k = 0; k < 2 * n; ++k)
    {
      const double angle = static_cast<double>(k / 2) * 2 * CGAL_PI / static_cast<double>(n);
      model.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                height * static_cast<double>(k % 2));
    }
  for(std::size_t k = 0; k < n; ++k)
  {
    const std::size_t a = 2 * k, b = 2 * ((k + 1) % n), c = a + 2 * n, d = b + 2 * n;
    const Triangle triangles[] = { { a, b, a + 1 }, { a + 1, b, b + 1 }, { c, c + 1, d }, { c + 1, d + 1, d },
                                   { a, c, b }, { b, c, d }, { a + 1, b + 1, c + 1 }, { b + 1, d + 1, c + 1 } };
    model.triangles.insert(model.triangles.end(), std::begin(triangles), std::end(triangles));
    const std::size_t ends[][2] = { { a, b }, { a + 1, b + 1 }, { c, d }, { c + 1, d + 1 } };
    for(const auto& [from, to] : ends)
      model.features.push_back(segment(model.points[from], model.points[to]));
  }
  return model;
}

// A long plate with a hole, the corners of which have fans of needles.
Model raw_plate(const double half_length)
{
  const std::size_t n = 16;
  Model model;
  model.points = { Point(half_length, 1, 0), Point(-half_length, 1, 0), Point(-half_length, -1, 0),
                   Point(half_length, -1, 0) };
  for(std::size_t k = 0; k < n; ++k)
  {
    const double angle = static_cast<double>(k) * 2 * CGAL_PI / n;
    model.points.emplace_back(std::cos(angle) / 2, std::sin(angle) / 2, 0);
    const std::size_t corner = k / 4, from = 4 + k, to = 4 + (k + 1) % n;
    model.triangles.push_back({ from, corner, to });
    if(k % 4 == 0)
      model.triangles.push_back({ from, (corner + 3) % 4, corner });
  }
  return model;
}

Model square_of_side_4() { return planar({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } }, 0.5); }

struct Prepared_field
{
  explicit Prepared_field(const Model& model, const Wishes& wishes = Wishes())
    : cad_mesh(model, false), prepared(prepare(cad_mesh)), maps(cad_mesh.mesh)
  {
    EXPECT_TRUE(FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
                                    with_guidance(cad_mesh, wishes).matching_map(maps.matching)));
  }

  static bool prepare(Cad_mesh<Surface_mesh>& cad_mesh)
  {
    EXPECT_TRUE(FF::prepare_for_frame_field(cad_mesh.mesh, cad_mesh.features()));
    return true;
  }

  Cad_mesh<Surface_mesh> cad_mesh;
  bool prepared;
  Maps<Surface_mesh> maps;
};

TEST(Quads_of_a_field, are_those_of_the_whole_pipeline_on_a_prepared_mesh)
{
  for(const Model& model : { cube(), quilt(), torus(), random_gear(1), ring_with_step() })
  {
    const Prepared_field field(model);
    for(const bool repairs : { true, false })
    {
      Wishes wishes;
      wishes.repairs = repairs;
      wishes.refines = false;
      const Quads expected = quads_of(field.cad_mesh, wishes);
      const Quads quads = quads_of_field(field.cad_mesh, field.maps, wishes);
      ASSERT_TRUE(expected.result && quads.result) << quads.result.message;
      expect_same(expected.mesh, quads.mesh);
      EXPECT_EQ(expected.locations, quads.locations);
      EXPECT_EQ(expected.fallback_patches, quads.fallback_patches);
      EXPECT_EQ(expected.statistics.number_of_repaired_patches, quads.statistics.number_of_repaired_patches);
    }
  }
}

TEST(Quads_of_a_field, are_not_made_of_a_wrong_one)
{
  const Prepared_field field(cube());
  const Surface_mesh& mesh = field.cad_mesh.mesh;
  const auto expect_error = [&](const FF::Error_code error_code)
  {
    const Quads quads = quads_of_field(field.cad_mesh, field.maps);
    EXPECT_EQ(error_code, quads.result.error_code) << quads.result.message;
    EXPECT_EQ(error_code == FF::OK, num_vertices(quads.mesh) > 0);
  };
  const auto h = *halfedges(mesh).begin();
  const auto f = *faces(mesh).begin();
  expect_error(FF::OK);
  put(field.maps.index, h, get(field.maps.index, h) + 4);
  for(const auto other : halfedges(mesh))
    put(field.maps.index, other, get(field.maps.index, h));
  expect_error(FF::ERROR_WRONG_FIELD);
  const double alpha = get(field.maps.alpha, f);
  put(field.maps.alpha, f, std::nan(""));
  expect_error(FF::ERROR_WRONG_FIELD);
  put(field.maps.alpha, f, alpha);
  put(field.maps.rho, f, 2.);
  expect_error(FF::ERROR_WRONG_FIELD);
}

// The point of a location by the corners of its face.
Point point_of(const Surface_mesh& mesh, const Location& location)
{
  const auto h = halfedge(location.first, mesh);
  return CGAL::barycenter(mesh.point(source(h, mesh)), location.second[0], mesh.point(target(h, mesh)),
                          location.second[1], mesh.point(target(next(h, mesh), mesh)), location.second[2]);
}

// The cube and the polyhedron have faces that are split, the prism and the pipe edges that are flipped, too, and the
// domain a map that needs more triangles.
TEST(Locations, are_on_the_mesh_of_the_caller)
{
  for(const Model& model : { cube(), quilt(), tetrahedron(), random_gear(1), random_star_shaped_polyhedron(2),
                             raw_prism(24, 4), raw_pipe(16, 5), random_planar_domain(672) })
  {
    const Cad_mesh<Surface_mesh> cad_mesh(model, false);
    const Quads quads = quads_of(cad_mesh);
    ASSERT_TRUE(quads.result) << quads.result.message;
    for(const auto v : vertices(quads.mesh))
    {
      const Location& location = quads.locations[v];
      for(const double coordinate : location.second)
        EXPECT_GE(coordinate, -1e-12);
      EXPECT_NEAR(1, location.second[0] + location.second[1] + location.second[2], 1e-12);
      EXPECT_LT(CGAL::squared_distance(quads.mesh.point(v), point_of(cad_mesh.mesh, location)), 1e-20);
    }
  }
}

double area(const Surface_mesh& mesh)
{
  double result = 0;
  for(const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    result += std::sqrt(CGAL::squared_area(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                                           mesh.point(target(next(h, mesh), mesh))));
  }
  return result;
}

// Without refinement the plate has three times as many quads as its area asks for, with a mean scaled Jacobian of 0.77.
TEST(Long_triangles, do_not_harm_the_quads)
{
  for(const Model& model : { raw_prism(24, 16), raw_pipe(16, 16), raw_plate(16) })
  {
    const Cad_mesh<Surface_mesh> cad_mesh(model, false);
    const Quads quads = quads_of(cad_mesh);
    ASSERT_TRUE(quads.result) << quads.result.message;
    EXPECT_EQ(0u, quads.statistics.number_of_filled_patches);
    EXPECT_GT(quads.statistics.quality.mean_scaled_jacobian, 0.95);
    EXPECT_GT(quads.statistics.quality.minimum_scaled_jacobian, 0.5);
    EXPECT_NEAR(area(cad_mesh.mesh) / (0.25 * 0.25) / static_cast<double>(num_faces(quads.mesh)), 1, 0.15);
  }
}

TEST(Long_triangles, are_kept_on_demand)
{
  const Cad_mesh<Surface_mesh> cad_mesh(raw_prism(24, 4), false);
  std::size_t number_of_faces[] = { 0, 0 };
  Wishes wishes;
  for(const bool refines : { false, true })
  {
    wishes.refines = refines;
    for(const FF::Patch_quad_statistics& patch : quads_of(cad_mesh, wishes).statistics.patches)
      number_of_faces[refines] += patch.number_of_faces;
  }
  EXPECT_LT(number_of_faces[0], 4 * num_faces(cad_mesh.mesh));
  EXPECT_GT(number_of_faces[1], 6 * num_faces(cad_mesh.mesh));
}

// The numbers of edges of the result on the features whose middles fulfil a predicate.
template <typename Predicate>
int number_of_edges_where(const Quads& quads, const Predicate& predicate)
{
  int result = 0;
  for(const auto e : edges(quads.mesh))
    result += quads.is_on_feature[e.idx()] && predicate(middle(quads.mesh, e));
  return result;
}

TEST(Sizes, of_the_same_length_are_that_length)
{
  const Cad_mesh<Surface_mesh> cad_mesh(quilt(), false);
  Surface_mesh expected;
  ASSERT_TRUE(FF::cad_quad_mesh(cad_mesh.mesh, expected, cad_mesh.features().target_edge_length(0.25)));
  const Quads quads = quads_of(cad_mesh);
  expect_same(expected, quads.mesh);
  EXPECT_EQ(0.25, quads.statistics.target_edge_length);
}

// Ten times as fine on the left as on the right, where opposite sides must have the same numbers.
TEST(Sizes, are_followed)
{
  const Cad_mesh<Surface_mesh> cad_mesh(square_of_side_4(), false);
  Wishes wishes;
  wishes.length = [](const Point& p) { return 0.05 + 0.45 * p.x() / 4; };
  const Quads quads = quads_of(cad_mesh, wishes);
  ASSERT_TRUE(quads.result) << quads.result.message;
  EXPECT_EQ(1u, quads.statistics.number_of_certified_patches);

  const auto is_bottom = [](const Point& p) { return std::abs(p.y()) < 1e-9; };
  const double integral = std::log(10.) / (0.45 / 4); // of 1 / length along the bottom
  EXPECT_NEAR(integral, number_of_edges_where(quads, is_bottom), 1);
  for(const auto e : edges(quads.mesh))
    if(is_bottom(middle(quads.mesh, e)))
    {
      const double length = std::abs(quads.mesh.point(source(e, quads.mesh)).x()
                                     - quads.mesh.point(target(e, quads.mesh)).x());
      const double ratio = length / wishes.length(middle(quads.mesh, e));
      EXPECT_GT(ratio, 0.5);
      EXPECT_LT(ratio, 2);
    }
  for(const auto f : faces(quads.mesh))
  {
    double area = 0;
    Point center(0, 0, 0);
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, quads.mesh), quads.mesh))
    {
      const Point p = quads.mesh.point(source(h, quads.mesh)), q = quads.mesh.point(target(h, quads.mesh));
      area += (p.x() * q.y() - p.y() * q.x()) / 2;
      center = center + (p - CGAL::ORIGIN) / 4;
    }
    EXPECT_GT(std::sqrt(area), wishes.length(center) / 3);
    EXPECT_LT(std::sqrt(area), wishes.length(center) * 2);
  }
}

// The ratios of the lengths of edges inside the patches to those wanted, in order.
std::vector<double> ratios_of_lengths(const Quads& quads, const Wishes& wishes)
{
  std::vector<double> ratios;
  for(const auto e : edges(quads.mesh))
    if(!quads.is_on_feature[e.idx()])
    {
      const Point p = quads.mesh.point(source(e, quads.mesh)), q = quads.mesh.point(target(e, quads.mesh));
      ratios.push_back(std::sqrt(CGAL::squared_distance(p, q)) / wishes.length(CGAL::midpoint(p, q)));
    }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

double mean_error(const std::vector<double>& ratios)
{
  double sum = 0;
  for(const double ratio : ratios)
    sum += std::log(ratio) * std::log(ratio);
  return std::sqrt(sum / static_cast<double>(ratios.size()));
}

// Four times as long at one end of a patch with an irregular vertex as at the other.
TEST(Sizes, are_followed_inside_a_patch)
{
  const Cad_mesh<Surface_mesh> cad_mesh(regular_polygon(5, 0.05), false);
  Wishes wishes;
  wishes.length = [](const Point& p) { return 0.03 + 0.09 * (p.x() + 1) / 2; };
  const Quads quads = quads_of(cad_mesh, wishes);
  ASSERT_TRUE(quads.result) << quads.result.message;
  const std::vector<double> ratios = ratios_of_lengths(quads, wishes);
  ASSERT_GT(ratios.size(), 200u);
  EXPECT_LT(mean_error(ratios), 0.3); // that of equal lengths is 0.36
  EXPECT_NEAR(1, ratios[ratios.size() / 2], 0.25);
  EXPECT_GT(ratios[ratios.size() / 20], 0.6);
  EXPECT_LT(ratios[ratios.size() - ratios.size() / 20], 1.8);
}

// A square that is four times as fine at one side as at the other. In a grid, only the columns can be.
TEST(Sizes, get_irregular_vertices_on_demand)
{
  const Cad_mesh<Surface_mesh> cad_mesh(planar({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } }, 0.12), false);
  Wishes wishes;
  wishes.length = [](const Point& p) { return 0.06 + 0.18 * p.x() / 4; };
  const Quads grid = quads_of(cad_mesh, wishes);
  wishes.field_follows_sizes = true;
  const Quads quads = quads_of(cad_mesh, wishes);
  ASSERT_TRUE(grid.result && quads.result) << quads.result.message;
  EXPECT_EQ(0u, grid.statistics.quality.number_of_irregular_vertices);
  EXPECT_GT(mean_error(ratios_of_lengths(grid, wishes)), 0.25);
  EXPECT_LT(mean_error(ratios_of_lengths(quads, wishes)), 0.22);
  EXPECT_EQ(1u, quads.statistics.number_of_certified_patches);
  EXPECT_GT(quads.statistics.quality.number_of_irregular_vertices, 1u);
  EXPECT_LT(quads.statistics.quality.number_of_irregular_vertices, 12u);
  EXPECT_EQ(0u, quads.statistics.quality.number_of_irregular_sectors);
  EXPECT_GT(quads.statistics.quality.minimum_scaled_jacobian, 0.6);
}

// Without different lengths the field stays as it is.
TEST(Sizes, of_the_same_length_do_not_turn_the_field)
{
  const Cad_mesh<Surface_mesh> cad_mesh(quilt(), false);
  Wishes wishes;
  const Quads expected = quads_of(cad_mesh, wishes);
  wishes.field_follows_sizes = true;
  expect_same(expected.mesh, quads_of(cad_mesh, wishes).mesh);
}

TEST(Sizes, must_be_positive)
{
  const Cad_mesh<Surface_mesh> cad_mesh(cube(), false);
  for(const double wrong : { 0., -1., std::nan(""), std::numeric_limits<double>::infinity(), 1e-320 })
  {
    Wishes wishes;
    wishes.length = [&](const Point& p) { return p.x() > 0.5 ? wrong : 1; };
    const Quads quads = quads_of(cad_mesh, wishes);
    EXPECT_EQ(FF::ERROR_WRONG_PARAMETER, quads.result.error_code);
    EXPECT_NE(std::string::npos, quads.result.message.find("sizing_map")) << quads.result.message;
  }
}

template <typename NamedParameters>
std::vector<double> sizes_of(const Cad_mesh<Surface_mesh>& cad_mesh, const NamedParameters& np)
{
  const auto map = get(CGAL::dynamic_vertex_property_t<double>(), cad_mesh.mesh);
  const FF::Result result =
    FF::compute_quad_sizes(cad_mesh.mesh, map, parameters::join(cad_mesh.features(), np));
  EXPECT_TRUE(result) << result.message;
  std::vector<double> sizes;
  for(const auto v : vertices(cad_mesh.mesh))
    sizes.push_back(get(map, v));
  return sizes;
}

const double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 180 * degree;

// Two vertices on the circle at the ends of this chord have the height between chord and circle.
double chord_of(const double radius, const double height)
{
  return 2 * radius * std::sin(std::acos(1 - height / radius));
}

// Of radius 2 around the z-axis, needles from end to end; an angle of 2 pi closes it.
Model raw_cylinder(const int n, const double height, const double angle)
{
  return grid(n, 1, angle == 2 * pi, false, [=](const double u, const double v)
              { return Point(2 * std::cos(angle * u), 2 * std::sin(angle * u), height * v); });
}

TEST(Computed_sizes, are_chords_of_cylinders)
{
  for(const double height : { 0.1, 30. })
    for(const Model& model : { raw_cylinder(24, height, 2 * pi), raw_cylinder(2, height, pi / 4),
                               raw_cylinder(5, height, pi / 2) })
      for(const double length : sizes_of(Cad_mesh<Surface_mesh>(model, false),
                                         parameters::target_edge_length(100).chord_height(0.01).gradation(infinity)))
        EXPECT_NEAR(chord_of(2, 0.01), length, 1e-9);
}

TEST(Computed_sizes, are_chords_of_spheres_and_tori)
{
  const auto np = parameters::target_edge_length(100).chord_height(0.01).gradation(infinity);
  for(const double length : sizes_of(Cad_mesh<Surface_mesh>(sphere(), false), np))
    EXPECT_NEAR(chord_of(1, 0.01), length, 1e-9);
  // Of 3 and 1 radius; the curvature across the tube is the greater one everywhere.
  const Model model = grid(60, 20, true, true, [](const double u, const double v)
  {
    const double r = 3 + std::cos(2 * pi * v);
    return Point(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), std::sin(2 * pi * v));
  });
  for(const double length : sizes_of(Cad_mesh<Surface_mesh>(model, false), np))
    EXPECT_NEAR(chord_of(1, 0.01), length, 0.002);
}

// All faces are flat, and all edges between them are features, which may be rounded.
TEST(Computed_sizes, are_not_bounded_by_creases)
{
  Model model = transformed(cube(), [](const Point& p) { return Point(p.x() / 3, p.y() / 7, p.z() + p.x() / 9); });
  for(Point& p : model.points)
    p = Point(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  for(auto& feature : model.features)
    for(Point* const p : { &feature.first, &feature.second })
      *p = Point(static_cast<float>(p->x()), static_cast<float>(p->y()), static_cast<float>(p->z()));
  for(const double length : sizes_of(Cad_mesh<Surface_mesh>(model, false),
                                     parameters::target_edge_length(100).chord_height(1e-3).gradation(infinity)))
    EXPECT_EQ(100, length);
}

TEST(Computed_sizes, follow_the_bends_of_curves_in_a_plane)
{
  const Cad_mesh<Surface_mesh> disk(regular_polygon(40, 0.3), false);
  const std::vector<double> sizes =
    sizes_of(disk, parameters::target_edge_length(1).chord_height(1e-3).gradation(infinity));
  int number_on_border = 0;
  for(const auto v : vertices(disk.mesh))
  {
    const bool is_on_border(CGAL::is_border(v, disk.mesh));
    number_on_border += is_on_border;
    EXPECT_EQ(!is_on_border, sizes[v] == 1);
    EXPECT_LE(sizes[v], is_on_border ? chord_of(1, 1e-3) * (1 + 1e-9) : 1);
  }
  EXPECT_GE(number_on_border, 40);
}

TEST(Computed_sizes, divide_gaps)
{
  // A strip of width 1, also a curved one, of raw triangles.
  const auto np = parameters::target_edge_length(3).edges_across_gap(4).gradation(infinity);
  const Model strip = grid(3, 1, false, false, [](const double u, const double v) { return Point(30 * u, v, 0); });
  for(const Model& model : { strip, raw_cylinder(24, 1, 2 * pi), raw_cylinder(1, 1, pi / 2) })
    for(const double length : sizes_of(Cad_mesh<Surface_mesh>(model, false), np))
      EXPECT_NEAR(0.25, length, 1e-9);
  // Edges that meet at a corner do not count as a gap.
  for(const double length : sizes_of(Cad_mesh<Surface_mesh>(wedge(20), false),
                                     parameters::target_edge_length(0.01).edges_across_gap(4)))
    EXPECT_EQ(0.01, length);
}

// A hole of radius 1/2 is 1/10 from one side of a square.
TEST(Computed_sizes, are_small_between_a_hole_and_the_border)
{
  Polyline hole;
  for(int i = 0; i < 40; ++i)
    hole.push_back({ 0.6 + 0.5 * std::cos(9 * degree * i), 2 + 0.5 * std::sin(9 * degree * i) });
  const Cad_mesh<Surface_mesh> cad_mesh(planar({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } }, 0.1, {}, { hole }), false);
  const std::vector<double> sizes =
    sizes_of(cad_mesh, parameters::target_edge_length(0.3).edges_across_gap(3).gradation(infinity));
  int number_in_gap = 0;
  for(const auto v : vertices(cad_mesh.mesh))
  {
    const Point& p = cad_mesh.mesh.point(v);
    if(p.x() < 0.1 && std::abs(p.y() - 2) < 0.05)
    {
      ++number_in_gap;
      EXPECT_NEAR(0.1 / 3, sizes[v], 0.003);
    }
    EXPECT_LE(p.x() > 2 ? 0.3 : 0.1 / 3 - 1e-3, sizes[v]);
  }
  EXPECT_GT(number_in_gap, 1);
}

TEST(Computed_sizes, grow_as_the_gradation_says)
{
  const Cad_mesh<Surface_mesh> cad_mesh(quilt(), false);
  const auto np = parameters::target_edge_length(1).chord_height(1e-3).edges_across_gap(3).minimum_edge_length(0.02);
  const std::vector<double> bounds = sizes_of(cad_mesh, np.gradation(infinity));
  const std::vector<double> sizes = sizes_of(cad_mesh, np.gradation(1.2));
  ASSERT_LT(*std::min_element(bounds.begin(), bounds.end()), 0.1);
  EXPECT_GE(*std::min_element(bounds.begin(), bounds.end()), 0.02);

  // The greatest lengths that grow so slowly, by relaxation until nothing changes.
  std::vector<double> expected = bounds;
  for(bool has_changed = true; has_changed;)
  {
    has_changed = false;
    for(const auto h : halfedges(cad_mesh.mesh))
    {
      const auto v = source(h, cad_mesh.mesh), w = target(h, cad_mesh.mesh);
      const double distance = std::sqrt(CGAL::squared_distance(cad_mesh.mesh.point(v), cad_mesh.mesh.point(w)));
      const double bound = expected[v] + std::log(1.2) * distance;
      if(expected[w] > bound + 1e-12)
      {
        expected[w] = bound;
        has_changed = true;
      }
    }
  }
  bool is_any_smaller = false;
  for(std::size_t v = 0; v < sizes.size(); ++v)
  {
    EXPECT_NEAR(expected[v], sizes[v], 1e-9);
    is_any_smaller |= sizes[v] < bounds[v] - 1e-3;
  }
  EXPECT_TRUE(is_any_smaller);
}

// In the order of the vertices, which is the same for all classes.
TEST(Computed_sizes, do_not_depend_on_the_class_or_the_unit_of_the_mesh)
{
  const Cad_mesh<Surface_mesh> cad_mesh(quilt(), false);
  const auto np = [](const double unit)
  {
    return parameters::target_edge_length(unit).chord_height(1e-3 * unit).edges_across_gap(3)
             .minimum_edge_length(0.02 * unit);
  };
  const std::vector<double> expected = sizes_of(cad_mesh, np(1));

  const FF::Cut_triangle_mesh<Surface_mesh> cut(cad_mesh.mesh, cad_mesh.features());
  const auto map = get(CGAL::dynamic_vertex_property_t<double>(), cad_mesh.mesh);
  ASSERT_TRUE(FF::compute_quad_sizes(cut, map, np(1)));
  for(const auto v : vertices(cad_mesh.mesh))
    EXPECT_EQ(expected[v], get(map, v));

  const Cad_mesh<Polyhedron> polyhedron(quilt(), false);
  const auto polyhedron_map = get(CGAL::dynamic_vertex_property_t<double>(), polyhedron.mesh);
  ASSERT_TRUE(FF::compute_quad_sizes(polyhedron.mesh, polyhedron_map, parameters::join(polyhedron.features(), np(1))));
  std::size_t i = 0;
  for(const auto v : vertices(polyhedron.mesh))
    EXPECT_NEAR(expected[i++], get(polyhedron_map, v), 1e-9);

  const double unit = 1e-4;
  const std::vector<double> scaled = sizes_of(
    Cad_mesh<Surface_mesh>(transformed(quilt(), [&](const Point& p)
                                       { return Point(unit * p.x(), unit * p.y(), unit * p.z()); }), false), np(unit));
  for(std::size_t v = 0; v < expected.size(); ++v)
    EXPECT_NEAR(expected[v], scaled[v] / unit, 1e-7);
}

TEST(Computed_sizes, must_have_bounds_in_their_ranges)
{
  const Cad_mesh<Surface_mesh> cad_mesh(cube(), false);
  const auto expect_error = [&](const auto& np, const std::string& name)
  {
    const auto map = get(CGAL::dynamic_vertex_property_t<double>(), cad_mesh.mesh);
    const FF::Result result = FF::compute_quad_sizes(cad_mesh.mesh, map, np);
    EXPECT_EQ(FF::ERROR_WRONG_PARAMETER, result.error_code);
    EXPECT_NE(std::string::npos, result.message.find(name)) << result.message;
  };
  for(const double wrong : { 0., -1., std::nan("") })
  {
    expect_error(parameters::chord_height(wrong), "chord_height");
    expect_error(parameters::gradation(wrong), "gradation");
    expect_error(parameters::target_edge_length(wrong), "target_edge_length");
    if(wrong != 0)
      expect_error(parameters::minimum_edge_length(wrong), "minimum_edge_length");
  }
  expect_error(parameters::edges_across_gap(-1), "edges_across_gap");
  expect_error(parameters::gradation(1.), "gradation");
  expect_error(parameters::minimum_edge_length(infinity), "minimum_edge_length");
}

// The quads of a model with bounds of sizes.
template <typename NamedParameters>
Quads bounded_quads(const Model& model, const NamedParameters& np)
{
  const Cad_mesh<Surface_mesh> cad_mesh(model, false);
  Quads quads;
  const auto is_on_feature = get(CGAL::dynamic_edge_property_t<bool>(), quads.mesh);
  quads.result = FF::cad_quad_mesh(cad_mesh.mesh, quads.mesh,
                                   parameters::join(cad_mesh.features(), np)
                                     .output_edge_is_constrained_map(is_on_feature)
                                     .statistics(std::ref(quads.statistics)));
  EXPECT_TRUE(quads.result) << quads.result.message;
  for(const auto e : edges(quads.mesh))
    quads.is_on_feature.push_back(get(is_on_feature, e));
  return quads;
}

TEST(Bounded_sizes, make_as_many_quads_as_chords_say)
{
  const double height = 4, chord = chord_of(2, 0.01);
  const Quads quads = bounded_quads(raw_cylinder(24, height, 2 * pi), parameters::target_edge_length(3)
                                                                         .chord_height(0.01));
  EXPECT_NEAR(chord, quads.statistics.maximum_target_edge_length, 1e-6);
  EXPECT_NEAR(std::round(4 * pi / chord) * std::round(height / chord), quads.statistics.number_of_quads, 12);
  EXPECT_EQ(0u, quads.statistics.quality.number_of_irregular_vertices);
}

// Two walls of length 5 and a fillet of radius 1/2 between them, in strips as long as the model.
Model walls_with_fillet(const int number_of_strips)
{
  std::vector<Point> profile = { Point(0, 5.5, 0) };
  for(int i = 0; i <= number_of_strips; ++i)
  {
    const double angle = pi / 2 * i / number_of_strips;
    profile.push_back(Point(0.5 - 0.5 * std::cos(angle), 0.5 - 0.5 * std::sin(angle), 0));
  }
  profile.push_back(Point(5.5, 0, 0));
  const int n = static_cast<int>(profile.size()) - 1;
  Model model = grid(n, 1, false, false, [&](const double u, const double v)
                     { return profile[std::lround(u * n)] + Vector(0, 0, 5 * v); });
  for(const int i : { 1, n - 1 })
    model.features.push_back(segment(profile[i], profile[i] + Vector(0, 0, 5)));
  return model;
}

TEST(Bounded_sizes, divide_fillets)
{
  for(const int number : { 7, 10 })
  {
    const Quads quads = bounded_quads(walls_with_fillet(6), parameters::target_edge_length(0.5)
                                                              .edges_across_gap(number).gradation(1.3));
    // On the border at the end of the fillet.
    EXPECT_EQ(number, number_of_edges_where(quads, [](const Point& p)
                                            { return p.z() == 0 && p.x() < 0.5 && p.y() < 0.5; }));
    EXPECT_NEAR(0.5, quads.statistics.maximum_target_edge_length, 1e-9);
    EXPECT_NEAR(pi / 4 / number, quads.statistics.minimum_target_edge_length, 0.01);
    EXPECT_GT(quads.statistics.quality.minimum_scaled_jacobian, 0.5);
    // Edges along a border grow away from the fillet, each one little more than the one before.
    std::vector<double> heights;
    for(const auto v : vertices(quads.mesh))
      if(quads.mesh.point(v).z() == 0 && quads.mesh.point(v).x() == 0 && quads.mesh.point(v).y() >= 0.5 - 1e-9)
        heights.push_back(quads.mesh.point(v).y());
    std::sort(heights.begin(), heights.end());
    ASSERT_GT(heights.size(), 3u);
    for(std::size_t i = 2; i < heights.size(); ++i)
      EXPECT_LT(heights[i] - heights[i - 1], 1.6 * (heights[i - 1] - heights[i - 2]));
  }
}

// A hole is 1/10 from a side of a plate of two long triangles.
TEST(Bounded_sizes, divide_gaps_of_raw_triangles)
{
  Polyline hole;
  for(int i = 0; i < 12; ++i)
    hole.push_back({ 0.6 + 0.5 * std::cos(30 * degree * i), 4 + 0.5 * std::sin(30 * degree * i) });
  const Quads quads = bounded_quads(planar({ { 0, 0 }, { 8, 0 }, { 8, 8 }, { 0, 8 } }, 100, {}, { hole }),
                                    parameters::target_edge_length(0.5).edges_across_gap(5));
  EXPECT_NEAR(0.1 / 5, quads.statistics.minimum_target_edge_length, 0.003);
  EXPECT_NEAR(0.5, quads.statistics.maximum_target_edge_length, 1e-9);
  // Edges on and across the shortest line to the hole, without the border of the hole. Rows of quads go on around the
  // hole, where fewer are wanted.
  int number = 0;
  for(const auto e : edges(quads.mesh))
  {
    const bool is_low = quads.mesh.point(source(e, quads.mesh)).y() < 4 + 1e-6;
    const bool is_other_low = quads.mesh.point(target(e, quads.mesh)).y() < 4 + 1e-6;
    number += middle(quads.mesh, e).x() < 0.1 + 1e-9 && is_low != is_other_low;
  }
  EXPECT_GE(number, 4);
  EXPECT_LE(number, 6);
}

TEST(Bounded_sizes, that_bound_nothing_change_nothing)
{
  const Cad_mesh<Surface_mesh> cad_mesh(quilt(), false);
  Surface_mesh expected, actual;
  const auto np = cad_mesh.features().target_edge_length(0.25);
  ASSERT_TRUE(FF::cad_quad_mesh(cad_mesh.mesh, expected, np));
  ASSERT_TRUE(FF::cad_quad_mesh(cad_mesh.mesh, actual, np.chord_height(infinity).edges_across_gap(0).gradation(1.2)
                                                         .minimum_edge_length(0.1)));
  expect_same(expected, actual);
}

TEST(Numbers_of_edges, are_met)
{
  const Cad_mesh<Surface_mesh> cad_mesh(square_of_side_4(), false);
  const auto is_bottom = [](const Point& p) { return std::abs(p.y()) < 1e-9; };
  const auto is_left = [](const Point& p) { return std::abs(p.x()) < 1e-9; };
  for(const std::array<int, 2>& wanted : { std::array<int, 2>{ 1, 40 }, std::array<int, 2>{ 7, 0 } })
  {
    Wishes wishes;
    wishes.number = [&](const Point& p) { return is_bottom(p) ? wanted[0] : is_left(p) ? wanted[1] : 0; };
    const Quads quads = quads_of(cad_mesh, wishes);
    ASSERT_TRUE(quads.result) << quads.result.message;
    EXPECT_EQ(wanted[0], number_of_edges_where(quads, is_bottom));
    EXPECT_EQ(wanted[1] > 0 ? wanted[1] : 16, number_of_edges_where(quads, is_left));
    EXPECT_EQ(0u, quads.statistics.number_of_unmet_edge_numbers);
    EXPECT_EQ(1u, quads.statistics.number_of_certified_patches);
  }
}

TEST(Numbers_of_edges, hold_for_edges_that_are_split)
{
  const Cad_mesh<Surface_mesh> cad_mesh(cube(), false);
  const auto is_along_x = [](const Point& p) { return std::abs(p.x() - 0.5) < 0.49; };
  Wishes wishes;
  wishes.number = [&](const Point& p) { return p == Point(0.5, 0, 0) ? 7 : 0; };
  const Quads quads = quads_of(cad_mesh, wishes);
  ASSERT_TRUE(quads.result) << quads.result.message;
  EXPECT_EQ(7 * 4, number_of_edges_where(quads, is_along_x));
  EXPECT_EQ(0u, quads.statistics.number_of_unmet_edge_numbers);
}

// Opposite sides of a square have the same number: one of two that differ is given up, the one that is farther from the
// 16 edges that the length asks for.
TEST(Numbers_of_edges, that_contradict_one_another_are_given_up)
{
  const Cad_mesh<Surface_mesh> cad_mesh(square_of_side_4(), false);
  const auto is_bottom = [](const Point& p) { return std::abs(p.y()) < 1e-9; };
  const auto is_top = [](const Point& p) { return std::abs(p.y() - 4) < 1e-9; };
  Wishes wishes;
  wishes.number = [&](const Point& p) { return is_bottom(p) ? 12 : is_top(p) ? 40 : 0; };
  const Quads quads = quads_of(cad_mesh, wishes);
  ASSERT_TRUE(quads.result) << quads.result.message;
  EXPECT_EQ(12, number_of_edges_where(quads, is_bottom));
  EXPECT_EQ(12, number_of_edges_where(quads, is_top));
  EXPECT_EQ(1u, quads.statistics.number_of_unmet_edge_numbers);
  EXPECT_EQ(1u, quads.statistics.number_of_certified_patches);
}

TEST(Numbers_of_edges, that_no_curve_can_have_are_errors)
{
  const Cad_mesh<Surface_mesh> cad_mesh(square_of_side_4(), false), tube(open_cylinder(), false);
  const auto expect_error = [](const Cad_mesh<Surface_mesh>& mesh, const std::function<int(const Point&)>& number,
                               const std::string& text)
  {
    Wishes wishes;
    wishes.number = number;
    const Quads quads = quads_of(mesh, wishes);
    EXPECT_EQ(FF::ERROR_WRONG_PARAMETER, quads.result.error_code);
    EXPECT_NE(std::string::npos, quads.result.message.find(text)) << quads.result.message;
    EXPECT_EQ(0u, num_vertices(quads.mesh));
  };
  expect_error(cad_mesh, [](const Point& p) { return p.y() > 0 ? 0 : p.x() < 1 ? 5 : p.x() > 3 ? 6 : 0; },
               "the edge from (");
  expect_error(cad_mesh, [](const Point&) { return -1; }, "is -1 on the edge from (");
  expect_error(cad_mesh, [](const Point&) { return 1000000000; }, "is 1000000000 on the edge");
  expect_error(tube, [](const Point&) { return 2; }, "is 2 on the edge");
}

// A closed curve of less edges than it has bends.
TEST(Numbers_of_edges, may_be_less_than_the_bends)
{
  const Cad_mesh<Surface_mesh> tube(open_cylinder(), false);
  Wishes wishes;
  wishes.number = [](const Point&) { return 5; };
  const Quads quads = quads_of(tube, wishes);
  ASSERT_TRUE(quads.result) << quads.result.message;
  EXPECT_EQ(0u, quads.statistics.number_of_unmet_edge_numbers);
  EXPECT_EQ(10, number_of_edges_where(quads, [](const Point&) { return true; }));
}

// A filled patch takes even numbers.
TEST(Numbers_of_edges, that_are_odd_are_given_up_at_filled_patches)
{
  const Cad_mesh<Surface_mesh> cad_mesh(ring_with_step(), false);
  const auto is_hole = [](const Point& p) { return (p - CGAL::ORIGIN).squared_length() < 1.5; };
  for(const int wanted : { 29, 30 })
  {
    Wishes wishes;
    wishes.repairs = false;
    wishes.number = [&](const Point& p) { return is_hole(p) ? wanted : 0; };
    const Quads quads = quads_of(cad_mesh, wishes);
    ASSERT_TRUE(quads.result) << quads.result.message;
    EXPECT_EQ(std::vector<int>{ 0 }, quads.fallback_patches);
    EXPECT_EQ(wanted == 30 ? 0u : 1u, quads.statistics.number_of_unmet_edge_numbers);
    EXPECT_EQ(wanted == 30, number_of_edges_where(quads, is_hole) == wanted);
  }
}

Wishes guided()
{
  Wishes wishes;
  wishes.direction = [](const Point&) { return Vector(std::cos(30 * degree), std::sin(30 * degree), 0); };
  wishes.weight = [](const Point& p)
  {
    const double distance = CGAL::squared_distance(p, Point(2, 2, 0));
    return distance < 0.1 ? std::numeric_limits<double>::infinity() : distance < 1 ? 1. : 0.;
  };
  wishes.refines = false;
  return wishes;
}

TEST(Guidance, is_that_of_the_field_on_a_prepared_mesh)
{
  const Prepared_field field(square_of_side_4(), guided());
  const Quads expected = quads_of_field(field.cad_mesh, field.maps, guided());
  const Quads quads = quads_of(field.cad_mesh, guided()), unguided = quads_of(field.cad_mesh);
  ASSERT_TRUE(expected.result && quads.result) << expected.result.message << quads.result.message;
  expect_same(expected.mesh, quads.mesh);
  bool is_other = num_vertices(unguided.mesh) != num_vertices(quads.mesh);
  for(const auto v : vertices(quads.mesh))
    is_other = is_other || unguided.mesh.point(v) != quads.mesh.point(v);
  EXPECT_TRUE(is_other);
}

// On a mesh that is not prepared.
TEST(Index_targets, become_valences)
{
  const Cad_mesh<Surface_mesh> cad_mesh(square_of_side_4(), false);
  const auto nearest = [&](const Point& p)
  {
    Point result = cad_mesh.mesh.point(*vertices(cad_mesh.mesh).begin());
    for(const auto v : vertices(cad_mesh.mesh))
      if(CGAL::squared_distance(cad_mesh.mesh.point(v), p) < CGAL::squared_distance(result, p))
        result = cad_mesh.mesh.point(v);
    return result;
  };
  const Point positive = nearest(Point(1, 2, 0)), negative = nearest(Point(3, 2, 0));
  Wishes wishes;
  wishes.index = [&](const Point& p) { return p == positive ? 1 : p == negative ? -1 : FF::NO_INDEX_TARGET; };
  const Quads quads = quads_of(cad_mesh, wishes);
  ASSERT_TRUE(quads.result) << quads.result.message;
  EXPECT_EQ(1u, quads.statistics.number_of_certified_patches);
  std::vector<std::size_t> valences;
  for(const auto v : vertices(quads.mesh))
    if(!quads.mesh.is_border(v) && quads.mesh.degree(v) != 4)
      valences.push_back(quads.mesh.degree(v));
  std::sort(valences.begin(), valences.end());
  EXPECT_EQ((std::vector<std::size_t>{ 3, 5 }), valences);
}

TEST(Nodes, are_vertices)
{
  const Cad_mesh<Surface_mesh> cad_mesh(square_of_side_4(), false);
  std::set<Point> nodes;
  for(const auto v : vertices(cad_mesh.mesh))
    if(cad_mesh.mesh.is_border(v) && cad_mesh.mesh.point(v).y() == 0 && nodes.size() < 5)
      nodes.insert(cad_mesh.mesh.point(v));
  Wishes wishes;
  wishes.length = [](const Point&) { return 1.1; };
  wishes.is_node = [&](const Point& p) { return nodes.count(p) > 0; };
  const Quads quads = quads_of(cad_mesh, wishes);
  ASSERT_TRUE(quads.result) << quads.result.message;
  for(const auto v : vertices(quads.mesh))
    nodes.erase(quads.mesh.point(v));
  EXPECT_TRUE(nodes.empty());
}

TEST(Quad_options, errors_on_the_refined_copy_name_vertices_and_faces_of_the_given_mesh)
{
  const Model model = transformed(cube(), [](const Point& p) { return Point(70 * p.x(), 70 * p.y(), 70 * p.z()); });
  const Cad_mesh<Surface_mesh> cad_mesh(model, true);
  Surface_mesh quad_mesh;
  const FF::Result result = FF::cad_quad_mesh(
    cad_mesh.mesh, quad_mesh, cad_mesh.features().target_edge_length(7)
                                .sparse_linear_solver(Failing_solver_traits{ FAILS_TO_FACTOR }));
  ASSERT_EQ(FF::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, result.error_code);
  EXPECT_TRUE(is_empty(quad_mesh));
  int number = 0, number_of_names = 0;
  for(const auto f : faces(cad_mesh.mesh))
  {
    for(const auto v : vertices_around_face(halfedge(f, cad_mesh.mesh), cad_mesh.mesh))
    {
      const Point& p = cad_mesh.mesh.point(v);
      const std::string name = "the vertex at " + FF::internal::to_text({ p.x(), p.y(), p.z() }) + " in face "
                               + std::to_string(number) + " of faces(tm)";
      number_of_names += result.message.find(name) != std::string::npos;
    }
    ++number;
  }
  EXPECT_EQ(1, number_of_names) << result.message;
}

TEST(Quad_options, faces_without_room_for_a_vertex_are_named)
{
  const double next_to_1 = std::nextafter(1., 2.);
  const Model model = { { Point(1, 1, 0), Point(next_to_1, 1, 0), Point(1, next_to_1, 0) }, { { 0, 1, 2 } }, {} };
  const Cad_mesh<Surface_mesh> cad_mesh(model, false);
  Surface_mesh quad_mesh;
  const FF::Result result = FF::cad_quad_mesh(cad_mesh.mesh, quad_mesh);
  ASSERT_EQ(FF::ERROR_ZERO_LENGTH_EDGE, result.error_code);
  EXPECT_NE(std::string::npos, result.message.find("in face 0 of faces(tm), which has a vertex at (1, 1, 0)"))
    << result.message;
  EXPECT_TRUE(is_empty(quad_mesh));
}

// Squares of such lengths are no numbers.
TEST(Quad_options, edge_lengths_far_beyond_the_model_give_the_coarsest_quads)
{
  const Cad_mesh<Surface_mesh> cad_mesh(quilt(), false);
  Wishes wishes;
  wishes.length = [](const Point&) { return 1e6; };
  const Quads coarsest = quads_of(cad_mesh, wishes);
  ASSERT_TRUE(coarsest.result);
  EXPECT_TRUE(coarsest.fallback_patches.empty());
  for(const double length : { 1e200, 1e300 })
  {
    wishes.length = [=](const Point&) { return length; };
    const Quads quads = quads_of(cad_mesh, wishes);
    expect_same(coarsest.mesh, quads.mesh);
    EXPECT_DOUBLE_EQ(length, quads.statistics.target_edge_length);
  }
}

TEST(Quad_options, number_of_quads_takes_precedence_over_the_edge_length)
{
  const Cad_mesh<Surface_mesh> cad_mesh(cube(), true);
  Surface_mesh expected, quad_mesh;
  const auto number = cad_mesh.features().number_of_quads(300);
  ASSERT_TRUE(FF::cad_quad_mesh(cad_mesh.mesh, expected, number));
  ASSERT_TRUE(FF::cad_quad_mesh(cad_mesh.mesh, quad_mesh, number.target_edge_length(0.02)));
  EXPECT_EQ(num_faces(expected), num_faces(quad_mesh));
  const auto points = expected.points(), other_points = quad_mesh.points();
  EXPECT_TRUE(std::equal(points.begin(), points.end(), other_points.begin(), other_points.end()));
}

} // namespace
