// Needles, caps and faces without area.

#include "field_contract.h"
#include "random_models.h"
#include "test_cad_mesh.h"

#include <CGAL/Frame_fields.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>

namespace {

using namespace test;
using CGAL::Frame_fields::Support_strategy;

// Splits a triangle in three at a point near the middle of its first edge: a cap, or a face without area for 0.
void split_off_cap(Model& model, const std::size_t triangle, const double relative_height)
{
  const auto [a, b, c] = model.triangles[triangle];
  const Point middle = CGAL::midpoint(model.points[a], model.points[b]);
  const std::size_t p = model.points.size();
  model.points.push_back(middle + relative_height * (model.points[c] - middle));
  model.triangles[triangle] = { a, b, p };
  model.triangles.push_back({ b, c, p });
  model.triangles.push_back({ c, a, p });
}

// Splits a triangle in three at a point near its first vertex: two needles.
void split_off_needles(Model& model, const std::size_t triangle, const double relative_length)
{
  const auto [a, b, c] = model.triangles[triangle];
  const Point center = CGAL::centroid(model.points[a], model.points[b], model.points[c]);
  const std::size_t p = model.points.size();
  model.points.push_back(model.points[a] + relative_length * (center - model.points[a]));
  model.triangles[triangle] = { a, b, p };
  model.triangles.push_back({ b, c, p });
  model.triangles.push_back({ c, a, p });
}

// Does the same to every third triangle of a model.
template <typename Split>
Model with_bad_triangles(Model model, const Split& split, const double size)
{
  const std::size_t number_of_triangles = model.triangles.size();
  for(std::size_t t = 0; t < number_of_triangles; t += 3)
    split(model, t, size);
  return model;
}

std::vector<Model> well_meshed_models()
{
  std::vector<Model> result;
  for(const Model& model : { wedge(20), wedge(60), star({ 10, 30, 40 }), regular_polygon(5), quilt() })
    result.push_back(Cad_mesh<Surface_mesh>(model).model());
  return result;
}

// All combinations of weights and strategies.
template <typename Check>
void for_each_way(const Check& check)
{
  for(const FF::Edge_weighting weighting : { FF::Edge_weighting::UNIFORM, FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH })
    for(const Support_strategy& strategy : { Support_strategy::rings(4), Support_strategy::component(),
                                             Support_strategy::radius() })
    {
      SCOPED_TRACE(testing::Message() << "weighting " << static_cast<int>(weighting)
                                      << ", strategy " << strategy.kind());
      check(parameters::edge_weighting(weighting).support_strategy(strategy));
    }
}

void expect_all_facts(const Model& model)
{
  const Cad_mesh<Surface_mesh> cad_mesh(model);
  for_each_way([&](const auto& np) { EXPECT_EQ("", broken_facts(cad_mesh.cut(), frame_field(cad_mesh, np))); });
}

TEST(Degenerate_faces, that_are_needles_and_caps_of_aspect_ratios_up_to_1e8_leave_all_facts)
{
  for(const double size : { 1e-2, 1e-4, 1e-6, 1e-8 })
    for(const Model& model : well_meshed_models())
    {
      SCOPED_TRACE(size);
      expect_all_facts(with_bad_triangles(model, split_off_cap, size));
      expect_all_facts(with_bad_triangles(model, split_off_needles, size));
    }
}

TEST(Degenerate_faces, of_whole_models_stretched_by_1e8_leave_all_facts)
{
  for(const double factor : { 1e3, 1e8 })
    for(const Random_models& models : kinds_of_random_models())
      for(unsigned int seed = 1; seed <= 3; ++seed)
      {
        SCOPED_TRACE(testing::Message() << models << " " << seed << " stretched by " << factor);
        expect_all_facts(transformed(models.draw(seed), [&](const Point& p)
        {
          return Point(factor * p.x(), p.y(), p.z());
        }));
      }
}

TEST(Degenerate_faces, that_are_collinear_leave_all_facts)
{
  for(const Model& model : well_meshed_models())
    expect_all_facts(with_bad_triangles(model, split_off_cap, 0));
}

// A vertex of such a face is at the midpoint of the opposite edge.
TEST(Degenerate_faces, that_are_collinear_get_no_edges_of_length_zero_by_splits)
{
  const auto expect_lengths = [](const Cad_mesh<Surface_mesh>& cad_mesh)
  {
    for(const auto e : edges(cad_mesh.mesh))
      EXPECT_NE(cad_mesh.point(source(e, cad_mesh.mesh)), cad_mesh.point(target(e, cad_mesh.mesh)));
  };
  for(const Model& model : well_meshed_models())
  {
    const Model with_caps = with_bad_triangles(model, split_off_cap, 0);
    const bool splits_overconstrained_faces = false;
    Cad_mesh<Surface_mesh> refined(with_caps, splits_overconstrained_faces);
    ASSERT_TRUE(FF::refine_triangles(refined.mesh, 0.1, refined.features()));
    expect_lengths(refined);

    Cad_mesh<Surface_mesh> split(with_caps, splits_overconstrained_faces);
    for(const auto e : edges(split.mesh))
      put(split.is_feature, e, e.idx() % 5 == 0);
    const std::size_t number_of_faces = num_faces(split.mesh);
    ASSERT_TRUE(FF::split_chords(split.mesh, split.features()));
    EXPECT_GT(num_faces(split.mesh), number_of_faces);
    expect_lengths(split);
  }
}

// Two squares that share an edge between two consecutive values of `double`.
TEST(Degenerate_faces, at_a_chord_without_a_point_between_its_ends_leave_it_whole)
{
  const double next_to_1 = std::nextafter(1., 2.);
  const Model model = { { Point(1, 0, 0), Point(next_to_1, 0, 0), Point(1, 1, 0), Point(1, -1, 0) },
                        { { 0, 1, 2 }, { 1, 0, 3 } }, {} };
  const bool splits_overconstrained_faces = false;
  const Cad_mesh<Surface_mesh> cad_mesh(model, splits_overconstrained_faces);
  Surface_mesh& mesh = const_cast<Surface_mesh&>(cad_mesh.mesh);
  FF::Refinement_statistics statistics;
  ASSERT_TRUE(FF::split_chords(mesh, cad_mesh.features().statistics(std::ref(statistics))));
  EXPECT_EQ(0u, statistics.number_of_splits);
  EXPECT_EQ(2u, num_faces(mesh));

  ASSERT_TRUE(FF::prepare_for_frame_field(mesh, cad_mesh.features().statistics(std::ref(statistics))));
  EXPECT_EQ(2u, statistics.number_of_split_faces);
  for(const auto e : edges(mesh))
    EXPECT_NE(mesh.point(source(e, mesh)), mesh.point(target(e, mesh)));
  EXPECT_EQ("", broken_facts(cad_mesh.cut(), frame_field(cad_mesh)));
}

// Edges keep a length, since no two points of the grid fall onto one another.
TEST(Degenerate_faces, may_be_all_faces_of_a_patch)
{
  for(const int n : { 1, 2, 5 })
  {
    const Model flat = transformed(square(n), [](const Point& p) { return Point(p.x() + 0.3 * p.y(), 0, 0); });
    expect_all_facts(flat);
  }
  Model model = with_sharp_edges(cube()); // one side of a cube is folded onto a line
  model.points[2] = Point(0, 0.4, 0);
  model.points[3] = Point(0, 0.7, 0);
  model.points[1] = Point(0, 1, 0);
  model.features.clear();
  expect_all_facts(model);
}

TEST(Degenerate_faces, of_zero_edge_length_are_named)
{
  for_each_way([](const auto& np)
  {
    Model model = square(4);
    Cad_mesh<Surface_mesh> cad_mesh(model);
    const auto f = *std::next(faces(cad_mesh.mesh).begin(), 7);
    const auto h = halfedge(f, cad_mesh.mesh);
    cad_mesh.mesh.point(target(h, cad_mesh.mesh)) = cad_mesh.mesh.point(source(h, cad_mesh.mesh));
    const Maps<Surface_mesh> maps(cad_mesh.mesh);
    EXPECT_EQ(FF::ERROR_ZERO_LENGTH_EDGE,
              FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index, np).error_code);
  });
}

// 4I of the sectors on constrained edges by the points they are at, in any order there.
std::map<Point, std::multiset<int> > constrained_indices(const Model& model)
{
  const Cad_mesh<Surface_mesh> cad_mesh(model);
  const Cut cut = cad_mesh.cut();
  const Field field = frame_field(cad_mesh, parameters::edge_weighting(FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH)
                                                       .support_strategy(Support_strategy::radius()));
  std::map<Point, std::multiset<int> > result;
  std::vector<char> is_seen(cut.number_of_sectors(), false);
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(cut.is_constrained_sector[cut.sector[h]] && !is_seen[cut.sector[h]])
    {
      is_seen[cut.sector[h]] = true;
      result[cut.points[h]].insert(field.index[h]);
    }
  return result;
}

TEST(Degenerate_faces, leave_the_indices_at_constrained_sectors_with_geometric_weights)
{
  for(const Model& model : well_meshed_models())
  {
    const auto expected = constrained_indices(model);
    for(const double size : { 1e-2, 1e-4, 1e-6, 1e-8 })
    {
      SCOPED_TRACE(size);
      EXPECT_EQ(expected, constrained_indices(with_bad_triangles(model, split_off_cap, size)));
      EXPECT_EQ(expected, constrained_indices(with_bad_triangles(model, split_off_needles, size)));
    }
    EXPECT_EQ(expected, constrained_indices(with_bad_triangles(model, split_off_cap, 0)));
  }
}

} // namespace
