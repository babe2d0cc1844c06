// What holds on every mesh, on models drawn at random. The environment variable FRAME_FIELDS_RANDOM_MODELS sets how
// many of each kind, FRAME_FIELDS_SEED the first seed, and FRAME_FIELDS_FAILURES a folder into which models that fail
// are written, for check_model and shrink_failing_model.py.

#include "field_contract.h"
#include "random_models.h"
#include "test_covariance.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace {

using namespace test;

// The transformation that turns by 90 degrees about z and scales by a power of two: neither rounds, nor does anything
// that is computed from the coordinates then.
Model turned_and_scaled(const Model& model, const int exponent)
{
  return transformed(model, [exponent](const Point& p)
  {
    return Point(std::scalbn(-p.y(), exponent), std::scalbn(p.x(), exponent), std::scalbn(p.z(), exponent));
  });
}

Transformation rigid_motion(const unsigned int seed)
{
  CGAL::Random random(seed);
  const double a = random.get_double(0, 6), b = random.get_double(0, 6);
  const Transformation about_z(std::cos(a), -std::sin(a), 0, 3, std::sin(a), std::cos(a), 0, -5, 0, 0, 1, 11);
  const Transformation about_x(1, 0, 0, 0.5, 0, std::cos(b), -std::sin(b), 2, 0, std::sin(b), std::cos(b), -1);
  return about_x * about_z;
}

// Where several paths of the repair cost the same, rounding errors decide.
const auto without_repair = parameters::repair_matching(false);

// The least distance of an r_ij from being as near to omega_ij with one matching as with the next one. Where it is 0,
// as it is by necessity in some patches all of whose faces are aligned, rounding errors decide.
double distance_from_tie(const Cad_mesh<Surface_mesh>& cad_mesh)
{
  const Cut cut = cad_mesh.cut();
  const Field field = frame_field(cad_mesh, without_repair.relax_orthogonality(false));
  double result = CGAL_PI;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(!cut.is_constrained(h))
    {
      const double difference = cut.rotation(field.alpha, field.matching, h) - field.omega[h];
      result = (std::min)(result, std::abs(CGAL_PI / 4 - std::abs(std::remainder(difference, 2 * CGAL_PI))));
    }
  return result;
}

class Random_model : public testing::TestWithParam<Random_models>
{
protected:
  // Calls `check(model, seed)` for all seeds; the models have no overconstrained face.
  template <typename Check>
  static void for_each_model(const Check& check)
  {
    const int number_of_models = number_from_environment("FRAME_FIELDS_RANDOM_MODELS", 120);
    const int first_seed = number_from_environment("FRAME_FIELDS_SEED", 1);
    std::cout << number_of_models << " " << GetParam() << " from seed " << first_seed << std::endl;
    for(int seed = first_seed; seed < first_seed + number_of_models; ++seed)
    {
      SCOPED_TRACE("FRAME_FIELDS_SEED=" + std::to_string(seed));
      const bool failed_before = HasFailure();
      const Model model = Cad_mesh<Surface_mesh>(GetParam().draw(seed)).model();
      check(model, seed);
      const char* const folder = std::getenv("FRAME_FIELDS_FAILURES");
      if(HasFailure() && !failed_before && folder)
        write_model(model, std::string(folder) + "/" + GetParam().name + "_" + std::to_string(seed));
    }
  }
};

TEST_P(Random_model, has_a_field_with_all_facts_of_the_contract)
{
  for_each_model([](const Model& model, int)
  {
    const Cad_mesh<Surface_mesh> cad_mesh(model);
    EXPECT_EQ("", broken_facts(cad_mesh.cut(), frame_field(cad_mesh)));
  });
}

TEST_P(Random_model, has_the_same_angles_bit_for_bit_when_it_is_turned_and_scaled_without_rounding)
{
  for_each_model([](const Model& model, const int seed)
  {
    const Field before = frame_field(Cad_mesh<Surface_mesh>(model));
    const Field after = frame_field(Cad_mesh<Surface_mesh>(turned_and_scaled(model, seed % 41 - 20)));
    EXPECT_EQ(before.alpha, after.alpha);
    EXPECT_EQ(before.rho, after.rho);
    EXPECT_EQ(before.omega, after.omega);
    EXPECT_EQ(before.matching, after.matching);
    EXPECT_EQ(before.index, after.index);
  });
}

TEST_P(Random_model, takes_its_field_along_when_it_is_moved_and_renumbered)
{
  int number_of_ties = 0;
  for_each_model([&](const Model& model, const int seed)
  {
    const Cad_mesh<Surface_mesh> cad_mesh(model);
    if(model.features.empty())
      return;
    if(distance_from_tie(cad_mesh) < 1e-9)
    {
      ++number_of_ties;
      return;
    }
    const Transformation motion = rigid_motion(seed);
    const std::vector<std::size_t> new_face = random_permutation(model.triangles.size(), seed);
    const Model moved = transformed(renumbered(model, random_permutation(model.points.size(), seed), new_face),
                                    [&](const Point& p) { return motion.transform(p); });
    expect_moved(Framed_mesh(cad_mesh, without_repair), Framed_mesh(Cad_mesh<Surface_mesh>(moved), without_repair),
                 new_face, motion);
  });
  std::cout << number_of_ties << " left out, in which the matching of an edge is a tie" << std::endl;
}

INSTANTIATE_TEST_SUITE_P(, Random_model, testing::ValuesIn(kinds_of_random_models()),
                         [](const auto& info) { return info.param.name; });

} // namespace
