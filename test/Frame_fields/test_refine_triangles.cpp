#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/internal/surface/coordinate_rounding.h>
#include <CGAL/Frame_fields/internal/surface/split_edges_longest_first.h>
#include <CGAL/Frame_fields/refine_triangles.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// refine_triangles() leaves no edge longer than the bound, moves nothing, and takes needles in planes apart.
namespace {

using namespace test;

// A box of the sizes 1, 2 and 10 whose sides are fans around one corner each.
Model long_box()
{
  Model model = cube();
  for(Point& p : model.points)
    p = Point(p.x(), 2 * p.y(), 10 * p.z());
  for(auto& feature : model.features)
    feature = segment(Point(feature.first.x(), 2 * feature.first.y(), 10 * feature.first.z()),
                      Point(feature.second.x(), 2 * feature.second.y(), 10 * feature.second.z()));
  return model;
}

// A closed cylinder as CAD programs write it: needles from end to end, and caps that are fans of needles.
Model can(const int n, const double height)
{
  Model model;
  for(int k = 0; k < 2 * n; ++k)
    model.points.emplace_back(std::cos(k / 2 * 2 * CGAL_PI / n), std::sin(k / 2 * 2 * CGAL_PI / n), height * (k % 2));
  const auto low = [n](const int k) { return std::size_t(2 * (k % n)); };
  const auto high = [n](const int k) { return std::size_t(2 * (k % n) + 1); };
  for(int k = 0; k < n; ++k)
  {
    model.triangles.push_back({ low(k), low(k + 1), high(k) });
    model.triangles.push_back({ high(k), low(k + 1), high(k + 1) });
    model.features.push_back(segment(model.points[low(k)], model.points[low(k + 1)]));
    model.features.push_back(segment(model.points[high(k)], model.points[high(k + 1)]));
    if(k > 0 && k < n - 1)
    {
      model.triangles.push_back({ low(0), low(k + 1), low(k) });
      model.triangles.push_back({ high(0), high(k), high(k + 1) });
    }
  }
  return model;
}

// A fan of needles over a convex polygon in a plane.
Model fan(const int n)
{
  Model model;
  for(int k = 0; k < n; ++k)
  {
    const double angle = (k + 0.3 * std::sin(k)) * 2 * CGAL_PI / n;
    model.points.emplace_back(3 * std::cos(angle), std::sin(angle), 0);
  }
  for(std::size_t k = 2; k < model.points.size(); ++k)
    model.triangles.push_back({ 0, k - 1, k });
  return model;
}

template <typename Mesh>
double largest_edge(const Cad_mesh<Mesh>& cad_mesh)
{
  double result = 0;
  for(const auto e : edges(cad_mesh.mesh))
    result = (std::max)(result, std::sqrt(CGAL::squared_distance(cad_mesh.point(source(e, cad_mesh.mesh)),
                                                                 cad_mesh.point(target(e, cad_mesh.mesh)))));
  return result;
}

double least_angle(const Model& model) // degrees
{
  double result = 180;
  for(const Triangle& t : model.triangles)
    for(int k = 0; k < 3; ++k)
      result = (std::min)(result, CGAL::approximate_angle(model.points[t[k]], model.points[t[(k + 1) % 3]],
                                                          model.points[t[(k + 2) % 3]]));
  return result;
}

double area(const Model& model)
{
  double result = 0;
  for(const Triangle& t : model.triangles)
    result += std::sqrt(CGAL::squared_area(model.points[t[0]], model.points[t[1]], model.points[t[2]]));
  return result;
}

double feature_length(const Model& model)
{
  double result = 0;
  for(const auto& feature : model.features)
    result += std::sqrt(CGAL::squared_distance(feature.first, feature.second));
  return result;
}

// The distance of a point from the triangles of a model, or from a part of them that is far enough.
double distance_from(const Model& model, const Point& p)
{
  double result = (std::numeric_limits<double>::infinity)();
  for(const Triangle& t : model.triangles)
  {
    const Point a = model.points[t[0]], b = model.points[t[1]], c = model.points[t[2]];
    const Vector normal = CGAL::cross_product(b - a, c - a);
    const Point corners[] = { a, b, c };
    bool is_inside = true;
    double distance = (std::numeric_limits<double>::infinity)();
    for(int k = 0; k < 3; ++k)
    {
      const Point from = corners[k], to = corners[(k + 1) % 3];
      const double place = (std::min)((std::max)((p - from) * (to - from) / ((to - from) * (to - from)), 0.), 1.);
      distance = (std::min)(distance, std::sqrt((p - (from + place * (to - from))).squared_length()));
      is_inside = is_inside && CGAL::cross_product(to - from, p - from) * normal > 0;
    }
    if(is_inside)
      distance = (std::min)(distance, std::abs((p - a) * normal) / std::sqrt(normal.squared_length()));
    result = (std::min)(result, distance);
    if(result == 0)
      break;
  }
  return result;
}

double size_of(const Model& model)
{
  double result = 0;
  for(const Point& p : model.points)
    result = (std::max)({ result, std::abs(p.x()), std::abs(p.y()), std::abs(p.z()) });
  return result;
}

template <typename Mesh>
class Refine_triangles : public testing::Test
{
public:
  // Refines a model and checks all that must hold. Returns the refined model.
  static Model refine(const Model& model, const double length, FF::Refinement_statistics& statistics)
  {
    Cad_mesh<Mesh> cad_mesh(model, false);
    const Model before = cad_mesh.model();
    const FF::Result result =
      FF::refine_triangles(cad_mesh.mesh, length, cad_mesh.features().statistics(std::ref(statistics)));
    EXPECT_TRUE(result) << result.message;
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cad_mesh.mesh));
    EXPECT_LE(largest_edge(cad_mesh), length);
    const Model after = cad_mesh.model();
    EXPECT_EQ(after.triangles.size(), num_faces(cad_mesh.mesh));
    check_surface(before, after, statistics);
    return after;
  }

  static void check_surface(const Model& before, const Model& after, const FF::Refinement_statistics& statistics)
  {
    EXPECT_EQ(after.points.size(), before.points.size() + statistics.number_of_splits);
    EXPECT_TRUE(std::equal(before.points.begin(), before.points.end(), after.points.begin()));
    const double rounding = 1e-14 * size_of(before), moved = 2 * statistics.flip_tolerance + rounding;
    for(std::size_t k = before.points.size(); k < after.points.size(); k += 3)
      EXPECT_LE(distance_from(before, after.points[k]), moved);
    for(std::size_t k = 0; k < after.triangles.size(); k += 5)
    {
      const Triangle& t = after.triangles[k];
      EXPECT_LE(distance_from(before, CGAL::centroid(after.points[t[0]], after.points[t[1]], after.points[t[2]])),
                moved);
    }
    EXPECT_NEAR(area(after) / area(before), 1, 1e-6);
    EXPECT_NEAR(feature_length(after), feature_length(before), 1e-12 * feature_length(before));
    for(const auto& feature : after.features)
      EXPECT_TRUE(std::any_of(before.features.begin(), before.features.end(), [&](const auto& old)
      {
        const auto is_on_old = [&](const Point& p)
        {
          return std::sqrt(CGAL::squared_distance(p, old.first)) + std::sqrt(CGAL::squared_distance(p, old.second))
                 <= std::sqrt(CGAL::squared_distance(old.first, old.second)) + rounding;
        };
        return is_on_old(feature.first) && is_on_old(feature.second);
      }));
  }
};
TYPED_TEST_SUITE(Refine_triangles, Mesh_classes, Mesh_class_names);

TYPED_TEST(Refine_triangles, of_a_box)
{
  FF::Refinement_statistics statistics;
  const Model refined = this->refine(long_box(), 0.5, statistics);
  EXPECT_GE(refined.triangles.size(), 64 / (0.5 * 0.5 * std::sqrt(3.) / 4));
  EXPECT_GT(least_angle(refined), 20);
}

TYPED_TEST(Refine_triangles, of_a_cylinder_with_needles)
{
  const Model before = can(24, 7);
  EXPECT_LT(least_angle(before), 2.2);
  FF::Refinement_statistics statistics;
  const Model refined = this->refine(before, 0.35, statistics);
  EXPECT_GT(least_angle(refined), 7.49); // two sides of the regular polygon and their chord have 180 / 24
  EXPECT_GT(statistics.number_of_flips, 0u);
}

// Only parts of the same triangle are in a plane there.
TYPED_TEST(Refine_triangles, of_a_curved_sheet_keeps_half_of_the_smallest_angle)
{
  const Model before = quilt();
  FF::Refinement_statistics statistics;
  const Model refined = this->refine(before, 0.1, statistics);
  EXPECT_GT(statistics.number_of_splits, 100u);
  EXPECT_GE(least_angle(refined), least_angle(before) / 2);
}

TYPED_TEST(Refine_triangles, in_four_each_keeps_half_of_the_smallest_angle)
{
  for(const Model& model : { quilt(), can(24, 7) })
  {
    Cad_mesh<TypeParam> cad_mesh(model, false);
    const auto np = cad_mesh.features();
    const FF::internal::Editable_mesh<TypeParam, typename decltype(np)::Pack> mesh(cad_mesh.mesh, np);
    const Model before = cad_mesh.model();
    const std::size_t number_of_edges = num_edges(cad_mesh.mesh);
    const auto all = halfedges(cad_mesh.mesh); // each edge comes twice
    FF::internal::split_edges_longest_first(
      cad_mesh.mesh, mesh,
      std::vector<typename boost::graph_traits<TypeParam>::halfedge_descriptor>(all.begin(), all.end()));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cad_mesh.mesh));
    const Model after = cad_mesh.model();
    EXPECT_EQ(after.triangles.size(), 4 * before.triangles.size());
    EXPECT_GE(least_angle(after), least_angle(before) / 2);
    FF::Refinement_statistics statistics;
    statistics.number_of_splits = number_of_edges;
    this->check_surface(before, after, statistics);
    EXPECT_EQ(after.features.size(), 2 * before.features.size());
  }
}

TYPED_TEST(Refine_triangles, of_raw_tessellations)
{
  std::size_t number = 0;
  for(const Named_model& named : cgal_models())
    for(const char* const name : { "anchor", "joint", "cross", "oblong", "tripod" })
      if(named.name == name && named.is_available())
      {
        SCOPED_TRACE(name);
        const Model before = named.make();
        FF::Refinement_statistics statistics;
        const Model refined = this->refine(before, std::sqrt(area(before)) / 15, statistics);
        EXPECT_GE(least_angle(refined), 0.5 * least_angle(before));
        ++number;
      }
  if(number == 0)
    GTEST_SKIP() << "there are no models of CGAL";
}

TYPED_TEST(Refine_triangles, of_a_fine_mesh_changes_nothing)
{
  FF::Refinement_statistics statistics;
  const Model refined = this->refine(quilt(), 100, statistics);
  EXPECT_EQ(statistics.number_of_splits, 0u);
  EXPECT_EQ(statistics.number_of_flips, 0u);
  EXPECT_EQ(refined.triangles.size(), quilt().triangles.size());
  const Model once = this->refine(long_box(), 0.7, statistics);
  this->refine(once, 0.7, statistics);
  EXPECT_EQ(statistics.number_of_splits, 0u);
}

// No circle around a triangle holds the vertex beyond an inner edge.
TYPED_TEST(Refine_triangles, makes_plane_triangles_Delaunay)
{
  const Model before = fan(30);
  FF::Refinement_statistics statistics;
  const Model refined = this->refine(before, 100, statistics);
  EXPECT_GT(statistics.number_of_flips, 10u);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> third; // by halfedge
  for(const Triangle& t : refined.triangles)
    for(int k = 0; k < 3; ++k)
      third[{ t[k], t[(k + 1) % 3] }] = t[(k + 2) % 3];
  std::size_t number_of_inner_edges = 0;
  for(const auto& [halfedge, r] : third)
  {
    const auto other = third.find({ halfedge.second, halfedge.first });
    if(other == third.end())
      continue;
    ++number_of_inner_edges;
    const Point corners[] = { refined.points[halfedge.first], refined.points[halfedge.second], refined.points[r] };
    const Point center = CGAL::circumcenter(corners[0], corners[1], corners[2]);
    EXPECT_GE(CGAL::squared_distance(center, refined.points[other->second]),
              CGAL::squared_distance(center, corners[0]) * (1 - 1e-6));
  }
  EXPECT_EQ(number_of_inner_edges, 2u * 27);
}

TYPED_TEST(Refine_triangles, flips_no_constrained_edge)
{
  Model before = fan(30);
  for(std::size_t k = 2; k + 1 < before.points.size(); ++k)
    before.features.push_back(segment(before.points[0], before.points[k]));
  FF::Refinement_statistics statistics;
  const Model refined = this->refine(before, 100, statistics);
  EXPECT_EQ(statistics.number_of_flips, 0u);
  EXPECT_EQ(refined.triangles.size(), before.triangles.size());
}

// A plane that does not go along the axes is one up to the rounding of the numbers that a file holds.
TYPED_TEST(Refine_triangles, sees_planes_through_the_rounding_of_the_coordinates)
{
  const auto tilted = [](const Point& p)
  {
    return Point(0.36 * p.x() - 0.8 * p.y() + 1.3, 0.48 * p.x() + 0.6 * p.y(), 0.8 * p.x() + 0.1);
  };
  const std::function<double(double)> roundings[] = {
    [](const double x) { return x; }, [](const double x) { return double(float(x)); },
    [](const double x)
    {
      char text[40];
      std::snprintf(text, sizeof(text), "%.7g", x);
      return std::strtod(text, nullptr);
    } };
  for(const auto& rounded : roundings)
  {
    const Model before = transformed(fan(30), [&](const Point& p)
    {
      const Point q = tilted(p);
      return Point(rounded(q.x()), rounded(q.y()), rounded(q.z()));
    });
    FF::Refinement_statistics statistics;
    this->refine(before, 100, statistics);
    EXPECT_GT(statistics.number_of_flips, 10u);
    EXPECT_LE(statistics.flip_tolerance, 1e-5);

    Cad_mesh<TypeParam> exact(before, false);
    ASSERT_TRUE(FF::refine_triangles(exact.mesh, 100, parameters::flip_tolerance(0).statistics(std::ref(statistics))));
    EXPECT_LE(statistics.number_of_flips, 10u);
  }
}

TYPED_TEST(Refine_triangles, is_the_same_each_time)
{
  FF::Refinement_statistics statistics;
  const Model first = this->refine(can(13, 3), 0.3, statistics), second = this->refine(can(13, 3), 0.3, statistics);
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.triangles, second.triangles);
}

TYPED_TEST(Refine_triangles, fails_without_a_change)
{
  const auto expect_failure = [](const Model& model, const FF::Error_code error_code, const double length,
                                 const double tolerance = 1e-9)
  {
    Cad_mesh<TypeParam> cad_mesh(model, false);
    const FF::Result result = FF::refine_triangles(cad_mesh.mesh, length, parameters::flip_tolerance(tolerance));
    EXPECT_EQ(result.error_code, error_code) << result.message;
    EXPECT_FALSE(result.message.empty());
    EXPECT_EQ(num_vertices(cad_mesh.mesh), model.points.size());
  };
  const double nan = (std::numeric_limits<double>::quiet_NaN)();
  for(const double length : { 0., -1., nan })
    expect_failure(cube(), FF::ERROR_WRONG_PARAMETER, length);
  for(const double tolerance : { -1., nan })
    expect_failure(cube(), FF::ERROR_WRONG_PARAMETER, 1, tolerance);
  expect_failure(cube(), FF::ERROR_MESH_TOO_LARGE, 1e-6);
  Model model = cube();
  model.points[3] = Point(0, nan, 0);
  expect_failure(model, FF::ERROR_NON_FINITE_COORDINATE, 1);

  TypeParam square;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), square);
  EXPECT_EQ(FF::refine_triangles(square, 0.1).error_code, FF::ERROR_NON_TRIANGULAR_MESH);
  EXPECT_EQ(num_vertices(square), 4u);
}

TYPED_TEST(Refine_triangles, takes_coordinates_of_any_size)
{
  for(const double size : { 1e-150, 1e150 })
  {
    Cad_mesh<TypeParam> cad_mesh(transformed(long_box(), [&](const Point& p)
    {
      return Point(size * p.x(), size * p.y(), size * p.z());
    }), false);
    ASSERT_TRUE(FF::refine_triangles(cad_mesh.mesh, 0.5 * size));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cad_mesh.mesh));
    EXPECT_GT(num_faces(cad_mesh.mesh), 500u);
  }
}

TEST(Coordinate_rounding, is_seen_in_the_numbers)
{
  using CGAL::Frame_fields::internal::Coordinates;
  using CGAL::Frame_fields::internal::coordinate_rounding;
  EXPECT_EQ(coordinate_rounding({}), 0);
  EXPECT_EQ(coordinate_rounding({ Coordinates{ 0, 0, 0 } }), 0);
  EXPECT_EQ(coordinate_rounding({ Coordinates{ 1, 2, -4 } }), 4 * 0x1p-24);
  EXPECT_EQ(coordinate_rounding({ Coordinates{ double(0.1f), 2, 1 } }), 2 * 0x1p-24);
  EXPECT_DOUBLE_EQ(coordinate_rounding({ Coordinates{ 0.1, 0.25, 2 } }), 0.5e-5);
  EXPECT_DOUBLE_EQ(coordinate_rounding({ Coordinates{ 0.1, 12.3456789, 2 } }), 0.5e-7);
  EXPECT_EQ(coordinate_rounding({ Coordinates{ 1. / 3, 2, 0 } }), 2 * 0x1p-53);
}

} // namespace
