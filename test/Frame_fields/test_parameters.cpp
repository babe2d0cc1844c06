#include "test_cad_mesh.h"
#include "test_solver_traits.h"

#include <CGAL/Frame_fields.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <vector>

namespace {

using namespace test;
using CGAL::Frame_fields::Support_strategy;

template <typename Mesh>
class Parameters : public testing::Test
{
protected:
  Cad_mesh<Mesh> cad_mesh{ quilt() };

  template <typename NamedParameters>
  void expect_default(const NamedParameters& np)
  {
    const Field expected = frame_field(cad_mesh), field = frame_field(cad_mesh, np);
    EXPECT_EQ(expected.alpha, field.alpha);
    EXPECT_EQ(expected.rho, field.rho);
    EXPECT_EQ(expected.omega, field.omega);
  }

  template <typename NamedParameters>
  void expect_effect(const NamedParameters& np)
  {
    const Field expected = frame_field(cad_mesh), field = frame_field(cad_mesh, np);
    EXPECT_TRUE(expected.alpha != field.alpha || expected.rho != field.rho);
  }
};

TYPED_TEST_SUITE(Parameters, Mesh_classes, Mesh_class_names);

TYPED_TEST(Parameters, have_documented_defaults)
{
  this->expect_default(parameters::sharp_corner_bound(0.75 * CGAL_PI));
  this->expect_default(parameters::support_strategy(Support_strategy::rings(4)));
  this->expect_default(parameters::repair_matching(true));
  this->expect_default(parameters::orthogonality_weight(1e-2));
  this->expect_default(parameters::maximum_skewness(0.45 * CGAL_PI));
  this->expect_default(parameters::relax_orthogonality(true));
  this->expect_default(parameters::sparse_linear_solver(FF::Eigen_frame_field_solver_traits()));
  this->expect_default(parameters::concurrency_tag(CGAL::Sequential_tag()));
  this->expect_default(parameters::visitor(FF::Default_frame_field_visitor()));
  this->expect_default(parameters::geom_traits(Kernel()));
  this->expect_default(parameters::vertex_point_map(get(CGAL::vertex_point, std::as_const(this->cad_mesh.mesh))));
}

TYPED_TEST(Parameters, have_an_effect)
{
  this->expect_effect(parameters::sharp_corner_bound(0));
  this->expect_effect(parameters::support_strategy(Support_strategy::rings(1)));
  this->expect_effect(parameters::support_strategy(Support_strategy::component()));
  this->expect_effect(parameters::support_strategy(Support_strategy::local()));
  this->expect_effect(parameters::support_strategy(Support_strategy::none()));
  this->expect_effect(parameters::orthogonality_weight(1));
  this->expect_effect(parameters::maximum_skewness(0.01));
  this->expect_effect(parameters::relax_orthogonality(false));
}

TYPED_TEST(Parameters, include_the_repair_of_the_matching)
{
  const Cad_mesh<TypeParam> cad_mesh(wedge(30));
  const auto none = parameters::support_strategy(Support_strategy::none());
  const Field unrepaired = frame_field(cad_mesh, none.repair_matching(false));
  const Field repaired = frame_field(cad_mesh, none);
  EXPECT_EQ(1, number_of_unmeshable_sectors(cad_mesh.cut(), unrepaired.index));
  EXPECT_EQ(0, number_of_unmeshable_sectors(cad_mesh.cut(), repaired.index));
  EXPECT_EQ(0u, unrepaired.statistics.number_of_repaired_sectors);
  EXPECT_EQ(1u, repaired.statistics.number_of_repaired_sectors);
}

// The sectors of the halfedges that an output iterator got, each of which must be another one.
template <typename Mesh, typename Halfedges>
std::set<int> sectors_of(const Cad_mesh<Mesh>& cad_mesh, const Cut& cut, const Halfedges& halfedges)
{
  std::set<int> sectors;
  int number = 0;
  for_each_halfedge(cad_mesh.mesh, [&](const auto h)
  {
    if(std::count(halfedges.begin(), halfedges.end(), h) > 0)
      sectors.insert(cut.sector[number]);
    ++number;
  });
  EXPECT_EQ(halfedges.size(), sectors.size());
  return sectors;
}

TYPED_TEST(Parameters, list_the_sectors_that_the_repair_changed)
{
  typedef std::vector<typename boost::graph_traits<TypeParam>::halfedge_descriptor> Halfedges;
  for(const Model& model : { wedge(30), star({ 12, 44, 27 }) })
    for(const Support_strategy& strategy : { Support_strategy::none(), Support_strategy::rings(4) })
    {
      const Cad_mesh<TypeParam> cad_mesh(model);
      const Cut cut = cad_mesh.cut();
      Halfedges unmeshable_before, unmeshable, changed, unchanged;
      const auto np = parameters::support_strategy(strategy);
      const std::vector<int> before = index_of_sectors(cut, frame_field(
        cad_mesh, np.repair_matching(false)
                    .repaired_sector_output_iterator(std::back_inserter(unchanged))
                    .unmeshable_sector_output_iterator(std::back_inserter(unmeshable_before))).index);
      const std::vector<int> after = index_of_sectors(cut, frame_field(
        cad_mesh, np.repaired_sector_output_iterator(std::back_inserter(changed))
                    .unmeshable_sector_output_iterator(std::back_inserter(unmeshable))).index);

      std::set<int> expected_unmeshable, expected_changed;
      for(int s = 0; s < cut.number_of_sectors(); ++s)
      {
        if(cut.is_constrained_sector[s] && before[s] >= 2)
          expected_unmeshable.insert(s);
        if(before[s] != after[s])
          expected_changed.insert(s);
      }
      EXPECT_EQ(strategy.kind() != Support_strategy::NONE, expected_unmeshable.empty());
      EXPECT_EQ(expected_unmeshable, sectors_of(cad_mesh, cut, unmeshable_before));
      EXPECT_EQ(expected_changed, sectors_of(cad_mesh, cut, changed));
      EXPECT_TRUE(unmeshable.empty());
      EXPECT_TRUE(unchanged.empty());
    }
}

// Such a patch has three sectors, and index 1 in all: too few for a quarter each.
TYPED_TEST(Parameters, include_the_repair_of_two_triangles_back_to_back)
{
  for(double x = 0.1; x < 1; x += 0.1)
    for(double y = 0.05; y < 1; y += 0.1)
    {
      Model model;
      for(const Point& point : { Point(0, 0, 0), Point(1, 0, 0), Point(x, y, 0) })
        model.points.push_back(point);
      model.triangles = { { 0, 1, 2 }, { 0, 2, 1 } };
      model.features = { segment(model.points[0], model.points[1]) };
      const Cad_mesh<TypeParam> cad_mesh(model);
      const Field field = frame_field(cad_mesh, Support_strategy::none());
      EXPECT_EQ(0, number_of_unmeshable_sectors(cad_mesh.cut(), field.index));
      EXPECT_EQ(std::vector<int>{ 0 }, poincare_hopf_defects(cad_mesh.cut(), field.index));
    }
}

TYPED_TEST(Parameters, include_the_features)
{
  const TypeParam& mesh = this->cad_mesh.mesh;
  const Maps<TypeParam> without(mesh);
  ASSERT_TRUE(FF::cad_frame_field(mesh, without.alpha, without.rho, without.index));
  EXPECT_NE(frame_field(this->cad_mesh).alpha, to_field(this->cad_mesh, without).alpha);
}

TYPED_TEST(Parameters, may_be_numbers_of_any_type)
{
  const Field expected = frame_field(this->cad_mesh, parameters::sharp_corner_bound(2.).orthogonality_weight(1.));
  EXPECT_EQ(expected.alpha,
            frame_field(this->cad_mesh, parameters::sharp_corner_bound(2).orthogonality_weight(1.f)).alpha);
}

TYPED_TEST(Parameters, chain_in_any_order)
{
  const TypeParam& mesh = this->cad_mesh.mesh;
  const auto features = this->cad_mesh.is_feature;
  const auto points = get(CGAL::vertex_point, mesh);
  const auto alpha_of = [&](const auto& np)
  {
    const Maps<TypeParam> maps(mesh);
    EXPECT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index, np));
    return to_field(this->cad_mesh, maps).alpha;
  };
  const auto expected = alpha_of(parameters::edge_is_constrained_map(features).maximum_skewness(0.1)
                                            .vertex_point_map(points).sharp_corner_bound(1.));
  EXPECT_EQ(expected, alpha_of(parameters::sharp_corner_bound(1.).maximum_skewness(0.1).vertex_point_map(points)
                                          .edge_is_constrained_map(features)));
  EXPECT_EQ(expected, alpha_of(parameters::geom_traits(Kernel()).edge_is_constrained_map(features)
                                          .sharp_corner_bound(1.).maximum_skewness(0.1)));
  EXPECT_EQ(expected, alpha_of(parameters::join(CGAL::parameters::edge_is_constrained_map(features),
                                                parameters::maximum_skewness(0.1).sharp_corner_bound(1.))));
  EXPECT_EQ(expected, alpha_of(parameters::join(parameters::maximum_skewness(0.1).sharp_corner_bound(1.),
                                                CGAL::parameters::vertex_point_map(points)
                                                                 .edge_is_constrained_map(features))));
}

TYPED_TEST(Parameters, given_twice_take_the_later_value)
{
  const Field expected = frame_field(this->cad_mesh, parameters::maximum_skewness(0.1));
  EXPECT_EQ(expected.rho, frame_field(this->cad_mesh, parameters::maximum_skewness(0.2).maximum_skewness(0.1)).rho);
  EXPECT_EQ(expected.rho, frame_field(this->cad_mesh, parameters::join(parameters::maximum_skewness(0.2),
                                                                       parameters::maximum_skewness(0.1))).rho);
}

TYPED_TEST(Parameters, may_be_a_pack_of_cgal)
{
  const TypeParam& mesh = this->cad_mesh.mesh;
  const Maps<TypeParam> maps(mesh);
  ASSERT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
                                  CGAL::parameters::edge_is_constrained_map(this->cad_mesh.is_feature)));
  EXPECT_EQ(frame_field(this->cad_mesh).alpha, to_field(this->cad_mesh, maps).alpha);
}

TYPED_TEST(Parameters, output_sharp_corners)
{
  std::vector<typename boost::graph_traits<TypeParam>::halfedge_descriptor> corners, expected;
  frame_field(this->cad_mesh, parameters::sharp_corner_output_iterator(std::back_inserter(corners)));
  ASSERT_TRUE(FF::sharp_corners(this->cad_mesh.mesh, std::back_inserter(expected), this->cad_mesh.features()));
  EXPECT_FALSE(corners.empty());
  EXPECT_EQ(expected, corners);
}

// 0 on constrained edges and on the border.
TYPED_TEST(Parameters, output_opposite_values_on_opposite_halfedges)
{
  const TypeParam& mesh = this->cad_mesh.mesh;
  const Maps<TypeParam> maps(mesh);
  for(const auto h : halfedges(mesh))
  {
    put(maps.matching, h, 77);
    put(maps.omega, h, 77);
    put(maps.index, h, 77);
  }
  ASSERT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index, this->cad_mesh.features()
    .matching_map(maps.matching).prescribed_rotation_map(maps.omega)));
  for(const auto h : halfedges(mesh))
  {
    EXPECT_EQ(0, get(maps.matching, h) + get(maps.matching, opposite(h, mesh)));
    EXPECT_EQ(0, get(maps.omega, h) + get(maps.omega, opposite(h, mesh)));
    if(is_border_edge(h, mesh) || get(this->cad_mesh.is_feature, edge(h, mesh)))
    {
      EXPECT_EQ(0, get(maps.matching, h));
      EXPECT_EQ(0, get(maps.omega, h));
    }
    if(is_border(h, mesh))
    {
      EXPECT_EQ(0, get(maps.index, h));
    }
  }
}

struct Stage_recorder
{
  std::vector<FF::Stage> stages;

  void start_stage(const FF::Stage stage) { stages.push_back(stage); }
};

TYPED_TEST(Parameters, let_a_visitor_follow_the_stages)
{
  Stage_recorder recorder;
  frame_field(this->cad_mesh, parameters::visitor(std::ref(recorder)));
  EXPECT_EQ((std::vector<FF::Stage>{ FF::Stage::CUT_SURFACE, FF::Stage::PRESCRIBED_ROTATION,
                                     FF::Stage::ORTHOGONAL_FIELD, FF::Stage::MATCHING_AND_INDICES,
                                     FF::Stage::RELAXATION }), recorder.stages);
  recorder.stages.clear();
  frame_field(this->cad_mesh, parameters::visitor(recorder)); // a copy is called
  EXPECT_TRUE(recorder.stages.empty());
}

TYPED_TEST(Parameters, report_statistics_on_success_only)
{
  const FF::Statistics good = frame_field(this->cad_mesh).statistics;
  EXPECT_EQ(3u, good.number_of_patches);
  EXPECT_GT(good.energy_orthogonal, 0);
  EXPECT_GT(good.energy_relaxed, 0);
  const FF::Stage_seconds& seconds = good.seconds;
  for(const double s : { seconds.cut_surface, seconds.prescribed_rotation, seconds.orthogonal_field,
                         seconds.matching_and_indices, seconds.relaxation })
    EXPECT_GE(s, 0);
  EXPECT_GE(seconds.total, seconds.cut_surface + seconds.prescribed_rotation + seconds.orthogonal_field
                           + seconds.matching_and_indices + seconds.relaxation);

  FF::Statistics statistics;
  statistics.number_of_patches = 77;
  const Maps<TypeParam> maps(this->cad_mesh.mesh);
  ASSERT_FALSE(FF::cad_frame_field(this->cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
                                   parameters::statistics(std::ref(statistics)).maximum_skewness(-1)));
  EXPECT_EQ(77u, statistics.number_of_patches);
}

} // namespace
