#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/Support_strategy.h>

#include <limits>

// What holds on every mesh: generated ones, those of CGAL and real CAD models.
namespace {

using namespace test;
using CGAL::Frame_fields::Support_strategy;

class Every_model : public On_models {};
class Every_small_model : public On_models {};

TEST_P(Every_model, has_an_aligned_field_with_exact_indices)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const Cut cut = cad_mesh.cut();
    const Field field = frame_field(cad_mesh);
    expect_valid_field(cut, field);
    EXPECT_EQ(0, number_of_unmeshable_sectors(cut, field.index));
    EXPECT_LT(largest_difference(cut.sums_around_sectors(field.omega),
                                 rotation_demand_of_rings(cut, 4, corner_bounds)), 1e-10);
    EXPECT_LT(largest_deviation_from_gradient(cut, field.omega), 1e-10);

    const Field unrepaired = frame_field(cad_mesh, parameters::repair_matching(false));
    EXPECT_EQ(std::vector<int>(cut.number_of_patches, 0), poincare_hopf_defects(cut, unrepaired.index));
    const Field without_blunt_corners = frame_field(cad_mesh, parameters::repair_matching(false).blunt_corner_bound(
      std::numeric_limits<double>::infinity()));
    EXPECT_LE(number_of_unmeshable_sectors(cut, without_blunt_corners.index),
              reference_number_of_unmeshable_sectors(GetParam()).value_or(cut.number_of_sectors()));

    const Field orthogonal = orthogonal_field(cad_mesh);
    EXPECT_EQ(std::vector<double>(cut.number_of_faces(), 0), orthogonal.rho);
    EXPECT_EQ(field.matching, orthogonal.matching);
    EXPECT_EQ(field.index, orthogonal.index);
    EXPECT_LT(largest_index_error(cut, orthogonal.alpha, unrepaired.matching, unrepaired.index), 1e-6);
    EXPECT_EQ(index_after_change(cut, unrepaired, orthogonal.matching), orthogonal.index);
  });
}

TEST_P(Every_small_model, has_an_aligned_field_with_exact_indices_for_each_strategy)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const Cut cut = cad_mesh.cut();
    for(const Support_strategy& strategy : { Support_strategy::none(), Support_strategy::local(),
                                             Support_strategy::rings(1), Support_strategy::component() })
    {
      SCOPED_TRACE(strategy.kind());
      expect_valid_field(cut, frame_field(cad_mesh, strategy));
    }
  });
}

TEST_P(Every_small_model, gets_the_rotation_that_the_strategy_prescribes)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const Cut cut = cad_mesh.cut();
    for(const int k : { 0, 1, 2, 7 })
    {
      SCOPED_TRACE(k);
      const std::vector<double> omega = frame_field(cad_mesh, Support_strategy::rings(k)).omega;
      EXPECT_LT(largest_difference(cut.sums_around_sectors(omega),
                                   rotation_demand_of_rings(cut, k, corner_bounds)), 1e-10);
      EXPECT_LT(largest_deviation_from_gradient(cut, omega), 1e-10);
    }
    const std::vector<double> omega = frame_field(cad_mesh, Support_strategy::component()).omega;
    EXPECT_LT(largest_difference(cut.sums_around_sectors(omega),
                                 rotation_demand_of_component(cut, corner_bounds)), 1e-10);
    EXPECT_LT(largest_deviation_from_gradient(cut, omega), 1e-10);
  });
}

TEST_P(Every_small_model, has_no_prescribed_rotation_with_strategy_none)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const std::vector<double> omega = frame_field(cad_mesh, Support_strategy::none()).omega;
    EXPECT_EQ(std::vector<double>(omega.size(), 0), omega);
  });
}

TEST_P(Every_small_model, shares_the_rotation_of_each_sharp_corner_evenly_with_strategy_local)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const Cut cut = cad_mesh.cut();
    std::vector<double> number_of_dual_edges(cut.number_of_sectors(), 0), share(cut.number_of_sectors(), 0);
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      number_of_dual_edges[cut.sector[h]] += !cut.is_constrained(h);
    for(const int s : constrained_sectors_below(cut, sharp_corner_bound))
      share[s] = (cut.theta[s] - CGAL_PI / 2) / number_of_dual_edges[s];
    std::vector<double> expected;
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      expected.push_back(cut.is_constrained(h) ? 0 : share[cut.sector[h]] - share[cut.sector[cut.opposite[h]]]);
    const auto np = parameters::support_strategy(Support_strategy::local())
                               .blunt_corner_bound(std::numeric_limits<double>::infinity());
    EXPECT_LT(largest_difference(frame_field(cad_mesh, np).omega, expected), 1e-12);
  });
}

INSTANTIATE_TEST_SUITE_P(Generated, Every_model, testing::ValuesIn(generated_models()), Model_name());
INSTANTIATE_TEST_SUITE_P(Generated, Every_small_model, testing::ValuesIn(generated_models()), Model_name());
INSTANTIATE_TEST_SUITE_P(CGAL, Every_model, testing::ValuesIn(cgal_models()), Model_name());
INSTANTIATE_TEST_SUITE_P(CAD, Every_model, testing::ValuesIn(cad_models()), Model_name());

} // namespace
