#include "test_cad_mesh.h"

#include <algorithm>
#include <cmath>

// The smoothest fields of surfaces without any constraint, which are eigenvectors, against what is known of them.
namespace {

using namespace test;

constexpr double turn = 360 * degree;

// A cylinder folded back onto itself at both ends: a torus in which all angles sum to 360 degrees.
Model flat_torus()
{
  return grid(20, 12, true, true, [](const double u, const double v)
  {
    return Point(std::cos(turn * u), std::sin(turn * u), std::abs(2 * v - 1));
  });
}

Model together(Model model, const Model& other, const Vector& offset)
{
  const std::size_t number_of_points = model.points.size();
  for(const Point& p : other.points)
    model.points.push_back(p + offset);
  for(const Triangle& t : other.triangles)
    model.triangles.push_back({ t[0] + number_of_points, t[1] + number_of_points, t[2] + number_of_points });
  return model;
}

template <typename Mesh>
class Closed_surface : public testing::Test
{
protected:
  static std::vector<int> sorted_singular_indices(const Model& model)
  {
    const Cad_mesh<Mesh> cad_mesh(model);
    const Field field = frame_field(cad_mesh);
    std::vector<int> indices = index_of_sectors(cad_mesh.cut(), field.index);
    indices.erase(std::remove(indices.begin(), indices.end(), 0), indices.end());
    std::sort(indices.begin(), indices.end());
    return indices;
  }
};

TYPED_TEST_SUITE(Closed_surface, Mesh_classes, Mesh_class_names);

TYPED_TEST(Closed_surface, sphere_has_eight_singularities_of_a_quarter)
{
  EXPECT_EQ(std::vector<int>(8, 1), this->sorted_singular_indices(sphere()));
}

TYPED_TEST(Closed_surface, flat_torus_has_a_parallel_field)
{
  const Cad_mesh<TypeParam> cad_mesh(flat_torus());
  const Cut cut = cad_mesh.cut();
  for(const double theta : cut.theta)
    ASSERT_NEAR(turn, theta, 1e-12);
  const Field field = frame_field(cad_mesh);
  EXPECT_EQ(std::vector<int>(field.index.size(), 0), field.index);
  EXPECT_LT(field.statistics.energy_orthogonal, 1e-12);
}

TYPED_TEST(Closed_surface, components_do_not_see_each_other)
{
  EXPECT_EQ(std::vector<int>(16, 1),
            this->sorted_singular_indices(together(sphere(), sphere(), Vector(5, 0, 0))));
  EXPECT_EQ(std::vector<int>(8, 1),
            this->sorted_singular_indices(together(sphere(), flat_torus(), Vector(5, 0, 0))));
}

} // namespace
