#include "test_cad_mesh.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace test;

constexpr double largest_skewness = 0.4999 * CGAL_PI;

class Relaxation : public On_models {};

// The repair turns frames far where a patch has no room for its singularities.
auto without_repair()
{
  return parameters::repair_matching(false);
}

TEST_P(Relaxation, minimizes_its_energy)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const Cut cut = cad_mesh.cut();
    const Field orthogonal = frame_field(cad_mesh, without_repair().relax_orthogonality(false));
    for(const double weight : { 0., 1e-2, 1. })
    {
      SCOPED_TRACE(weight);
      const Field relaxed = frame_field(
        cad_mesh, without_repair().orthogonality_weight(weight).maximum_skewness(largest_skewness));
      ASSERT_EQ(0u, relaxed.statistics.number_of_clamped_faces);
      const test::Relaxation relaxation = test::relaxation(cut, orthogonal, relaxed, weight);
      EXPECT_LE(relaxation.energy_after, relaxation.energy_before + 1e-12);
      EXPECT_LT(relaxation.largest_gradient, 1e-9);
      EXPECT_LT(relaxation.largest_fixed_gamma, 1e-12);
    }
  });
}

TEST_P(Relaxation, keeps_matching_and_indices)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const Field orthogonal = orthogonal_field(cad_mesh), relaxed = frame_field(cad_mesh);
    EXPECT_EQ(orthogonal.matching, relaxed.matching);
    EXPECT_EQ(orthogonal.index, relaxed.index);
  });
}

TEST_P(Relaxation, reports_its_energies)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const Cut cut = cad_mesh.cut();
    const Field orthogonal = frame_field(cad_mesh, without_repair().relax_orthogonality(false));
    const Field relaxed = frame_field(cad_mesh, without_repair());
    double expected = 0;
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      if(h < cut.opposite[h])
        expected += std::pow(cut.rotation(orthogonal.alpha, orthogonal.matching, h) - orthogonal.omega[h], 2);
    EXPECT_NEAR(expected, orthogonal.statistics.energy_orthogonal, 1e-9);
    EXPECT_NEAR(test::relaxation(cut, orthogonal, relaxed, 0).energy_after, relaxed.statistics.energy_relaxed, 1e-9);
  });
}

// A clamped face keeps the mean of its branches, or the branch along its constrained edge.
TEST_P(Relaxation, clamps_the_skewness)
{
  const double maximum_skewness = 0.05;
  on_each_mesh_class(GetParam().make(), [=](const auto& cad_mesh)
  {
    const Cut cut = cad_mesh.cut();
    const Field free = frame_field(cad_mesh, without_repair().maximum_skewness(largest_skewness));
    const Field clamped = frame_field(cad_mesh, without_repair().maximum_skewness(maximum_skewness));
    ASSERT_EQ(0u, free.statistics.number_of_clamped_faces);
    std::size_t number_of_clamped_faces = 0;
    for(int f = 0; f < cut.number_of_faces(); ++f)
      if(std::abs(free.rho[f]) <= maximum_skewness)
      {
        EXPECT_EQ(free.alpha[f], clamped.alpha[f]);
        EXPECT_EQ(free.rho[f], clamped.rho[f]);
      }
      else
      {
        ++number_of_clamped_faces;
        EXPECT_NEAR(std::copysign(maximum_skewness, free.rho[f]), clamped.rho[f], 1e-14);
        if(!cut.is_constrained(3 * f) && !cut.is_constrained(3 * f + 1) && !cut.is_constrained(3 * f + 2))
        {
          EXPECT_NEAR(2 * free.alpha[f] + free.rho[f], 2 * clamped.alpha[f] + clamped.rho[f], 1e-14);
        }
      }
    EXPECT_EQ(number_of_clamped_faces, clamped.statistics.number_of_clamped_faces);
    EXPECT_LT(largest_misalignment(cut, clamped), 1e-9);
  });
}

TEST_P(Relaxation, gives_the_orthogonal_field_if_no_skewness_is_allowed)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    EXPECT_EQ(0, largest(frame_field(cad_mesh, parameters::maximum_skewness(0)).rho));
    EXPECT_LT(largest(frame_field(cad_mesh, parameters::orthogonality_weight(1e9)).rho), 1e-6);
  });
}

INSTANTIATE_TEST_SUITE_P(Generated, Relaxation, testing::ValuesIn(generated_models()), Model_name());

// On `anchor_dense` a face reaches any skewness without orthogonality weight.
std::vector<Named_model> models_of_cgal_without_large_skewness()
{
  std::vector<Named_model> models = cgal_models();
  const auto is_excluded = [](const Named_model& model) { return model.name == "anchor_dense"; };
  models.erase(std::remove_if(models.begin(), models.end(), is_excluded), models.end());
  return models;
}

INSTANTIATE_TEST_SUITE_P(CGAL, Relaxation, testing::ValuesIn(models_of_cgal_without_large_skewness()), Model_name());

} // namespace
