#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/Support_strategy.h>
#include <CGAL/Frame_fields/sharp_corners.h>

#include <iterator>

namespace {

using namespace test;
using CGAL::Frame_fields::Support_strategy;

// The indices of the sectors on constrained edges with angles below the bound.
template <typename Mesh, typename NamedParameters>
std::vector<int> indices_of_corners_below(const double bound, const Cad_mesh<Mesh>& cad_mesh, const NamedParameters& np)
{
  const Cut cut = cad_mesh.cut();
  const std::vector<int> index = index_of_sectors(cut, frame_field(cad_mesh, np).index);
  std::vector<int> result;
  for(const int s : constrained_sectors_below(cut, bound))
    result.push_back(index[s]);
  return result;
}

class Domain_with_sharp_corners : public On_models
{
protected:
  static std::size_t number_of_corners_below_45_degrees(const Cut& cut)
  {
    return constrained_sectors_below(cut, 45 * degree).size();
  }
};

TEST_P(Domain_with_sharp_corners, has_index_1_4_at_each_corner_below_45_degrees)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const std::vector<int> all_quarters(number_of_corners_below_45_degrees(cad_mesh.cut()), 1);
    ASSERT_FALSE(all_quarters.empty());
    for(const bool repairs_matching : { false, true })
      for(const Support_strategy& strategy : { Support_strategy::rings(4), Support_strategy::component() })
        EXPECT_EQ(all_quarters, indices_of_corners_below(
          45 * degree, cad_mesh, parameters::support_strategy(strategy).repair_matching(repairs_matching)));
  });
}

TEST_P(Domain_with_sharp_corners, has_no_unmeshable_sector)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    EXPECT_EQ(0, number_of_unmeshable_sectors(cad_mesh.cut(), frame_field(cad_mesh).index));
  });
}

TEST_P(Domain_with_sharp_corners, has_index_1_2_at_each_corner_below_45_degrees_without_prescribed_rotation)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    for(const int index : indices_of_corners_below(
          45 * degree, cad_mesh, parameters::support_strategy(Support_strategy::none()).repair_matching(false)))
      EXPECT_GE(index, 2);
  });
}

std::vector<Named_model> domains_with_sharp_corners()
{
  std::vector<Named_model> result;
  for(int angle = 1; angle <= 44; ++angle)
    result.push_back({ "wedge_" + std::to_string(angle), [angle] { return wedge(angle); }, "" });
  result.push_back({ "star_with_3_tips", [] { return star({ 12, 44, 27 }); }, "" });
  result.push_back({ "star_with_5_tips", [] { return star({ 5, 20, 44, 10, 30 }); }, "" });
  result.push_back({ "star_with_8_tips", [] { return star({ 40, 15, 33, 8, 25, 44, 19, 11 }); }, "" });
  return result;
}

INSTANTIATE_TEST_SUITE_P(Planar, Domain_with_sharp_corners, testing::ValuesIn(domains_with_sharp_corners()),
                         Model_name());

TEST(Wedge, has_a_valid_field_at_any_angle)
{
  for(int angle = 1; angle <= 170; ++angle)
    on_each_mesh_class(wedge(angle), [angle](const auto& cad_mesh)
    {
      SCOPED_TRACE(angle);
      const Cut cut = cad_mesh.cut();
      const Field field = frame_field(cad_mesh);
      EXPECT_EQ(std::vector<int>{ 0 }, poincare_hopf_defects(cut, field.index));
      EXPECT_LT(largest_misalignment(cut, field), 1e-9);
    });
}

TEST(Wedge, has_index_1_4_at_its_tip_whatever_the_number_of_triangles_there)
{
  for(const int fan : { 2, 3, 4, 5, 8 })
    for(const double angle : { 0.1, 3., 20., 40. })
      on_each_mesh_class(wedge_with_fan(angle, fan), [=](const auto& cad_mesh)
      {
        SCOPED_TRACE(testing::Message() << fan << " triangles in " << angle << " degrees");
        EXPECT_EQ(std::vector<int>{ 1 },
                  indices_of_corners_below(45 * degree, cad_mesh, parameters::repair_matching(true)));
      });
}

template <typename Mesh>
class Sharp_corners : public testing::Test
{
protected:
  // The sectors of the listed halfedges.
  static std::vector<int> sharp_sectors(const Cad_mesh<Mesh>& cad_mesh, const Cut& cut, const double bound)
  {
    std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor> corners;
    const FF::Result result = FF::sharp_corners(cad_mesh.mesh, std::back_inserter(corners),
                                                cad_mesh.features().sharp_corner_bound(bound));
    EXPECT_EQ(FF::OK, result.error_code);
    std::vector<int> sectors;
    int number = 0;
    for_each_halfedge(cad_mesh.mesh, [&](const auto h)
    {
      if(std::count(corners.begin(), corners.end(), h) > 0)
      {
        EXPECT_TRUE(cut.is_constrained(next_of(number))) << "the corner is not the clockwise-most of its sector";
        sectors.push_back(cut.sector[number]);
      }
      ++number;
    });
    std::sort(sectors.begin(), sectors.end());
    EXPECT_EQ(corners.size(), sectors.size());
    return sectors;
  }
};

TYPED_TEST_SUITE(Sharp_corners, Mesh_classes, Mesh_class_names);

TYPED_TEST(Sharp_corners, are_the_sectors_on_constrained_edges_below_the_bound)
{
  for(const Model& model : { quilt(), star({ 5, 50, 100 }), sphere() })
  {
    const Cad_mesh<TypeParam> cad_mesh(model);
    const Cut cut = cad_mesh.cut();
    for(const double bound : { 0., 30., 75., 135., 200., 361. })
      EXPECT_EQ(constrained_sectors_below(cut, bound * degree - angle_tolerance),
                this->sharp_sectors(cad_mesh, cut, bound * degree));
  }
}

TYPED_TEST(Sharp_corners, may_lie_in_faces_with_several_constrained_edges)
{
  const Cad_mesh<TypeParam> cad_mesh(tetrahedron(), false);
  EXPECT_EQ(12u, this->sharp_sectors(cad_mesh, cad_mesh.cut(), 135 * degree).size());
}

} // namespace
