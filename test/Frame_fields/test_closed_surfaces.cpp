#include "test_cad_mesh.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

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

// A torus of radii 3 and 1, its vertices moved on it at random by `noise` of an edge.
Model round_torus(const int m, const int n, const double noise)
{
  std::mt19937 generator;
  const auto moved = [&](const double u, const int cells)
  {
    return u + noise * (generator() / 2147483648. - 1) / cells;
  };
  return grid(m, n, true, true, [&](double u, double v)
  {
    u = turn * moved(u, m);
    v = turn * moved(v, n);
    const double radius = 3 + std::cos(v);
    return Point(radius * std::cos(u), radius * std::sin(u), std::sin(v));
  });
}

// A part of a torus of radii 3 and 1, open at its ends.
Model bent_pipe(const double bend_degrees)
{
  const int n = 16;
  const double bend = bend_degrees * degree;
  return grid(static_cast<int>(3 * bend / turn * n), n, false, true, [bend](const double u, const double v)
  {
    const double radius = 3 + std::cos(turn * v);
    return Point(radius * std::cos(bend * u), radius * std::sin(bend * u), std::sin(turn * v));
  });
}

// The sum of squared rotations of the field along the parallels of a torus around the z axis.
double energy_of_parallels(const Cut& cut)
{
  std::vector<double> alpha;
  for(int f = 0; f < cut.number_of_faces(); ++f)
  {
    const Point &a = cut.points[3 * f + 2], &b = cut.points[3 * f], &c = cut.points[3 * f + 1];
    const Vector edge = b - a, normal = CGAL::cross_product(edge, c - a), along(-a.y(), a.x(), 0);
    alpha.push_back(std::atan2(CGAL::cross_product(edge, along) * normal / std::sqrt(normal.squared_length()),
                               edge * along));
  }
  double energy = 0;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    energy += std::pow(std::remainder(-alpha[face_of(h)] + alpha[face_of(cut.opposite[h])] + cut.transport[h],
                                      CGAL_PI / 2), 2) / 2;
  return energy;
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

// The smoothest field of unit norm has up to six pairs of singularities on these.
TYPED_TEST(Closed_surface, torus_has_no_singularities)
{
  for(const double noise : { 0., 0.3 })
    for(const int n : { 10, 20 })
    {
      const Cad_mesh<TypeParam> cad_mesh(round_torus(3 * n, n, noise));
      const Cut cut = cad_mesh.cut();
      const Field field = frame_field(cad_mesh);
      EXPECT_EQ(std::vector<int>(field.index.size(), 0), field.index);
      EXPECT_LT(field.statistics.energy_orthogonal, energy_of_parallels(cut));
    }
}

// On coarse meshes, and on meshes much finer in one direction, six and four pairs would flatten the field around them.
TYPED_TEST(Closed_surface, torus_of_long_or_coarse_faces_has_no_singularities)
{
  EXPECT_EQ(std::vector<int>(), this->sorted_singular_indices(round_torus(12, 6, 0)));
  EXPECT_EQ(std::vector<int>(), this->sorted_singular_indices(round_torus(24, 24, 0)));
}

// The solution of the linear system has two and four pairs on these.
TYPED_TEST(Closed_surface, bent_pipe_with_open_ends_has_no_singularities)
{
  for(const double bend : { 90., 270. })
  {
    const Cad_mesh<TypeParam> cad_mesh(bent_pipe(bend));
    const Field field = frame_field(cad_mesh);
    EXPECT_EQ(std::vector<int>(field.index.size(), 0), field.index);
    EXPECT_LT(largest_misalignment(cad_mesh.cut(), field), 1e-9);
  }
}

TYPED_TEST(Closed_surface, ellipsoid_has_eight_singularities_of_a_quarter)
{
  const Model ellipsoid = transformed(sphere(), [](const Point& p) { return Point(p.x(), 2 * p.y(), 3 * p.z()); });
  EXPECT_EQ(std::vector<int>(8, 1), this->sorted_singular_indices(ellipsoid));
}

TYPED_TEST(Closed_surface, components_do_not_see_each_other)
{
  EXPECT_EQ(std::vector<int>(16, 1),
            this->sorted_singular_indices(together(sphere(), sphere(), Vector(5, 0, 0))));
  EXPECT_EQ(std::vector<int>(8, 1),
            this->sorted_singular_indices(together(sphere(), flat_torus(), Vector(5, 0, 0))));
}

} // namespace
