#include "test_cad_mesh.h"

namespace {

using namespace test;

typedef std::array<Vector, 4> Branches;

double angle_between(const Vector& u, const Vector& v)
{
  return std::atan2(std::sqrt(CGAL::cross_product(u, v).squared_length()), u * v);
}

template <typename Mesh>
class Frame_vectors : public testing::Test
{
protected:
  // Calls `check(b, n, branches)` with the first edge of each face and the normal.
  template <typename Check>
  static void for_each_frame(const Model& model, const double alpha, const double rho, const Check& check)
  {
    const Cad_mesh<Mesh> cad_mesh(model);
    const Cut cut = cad_mesh.cut();
    int h = 0;
    for(const auto f : faces(cad_mesh.mesh))
    {
      const Vector b = cut.points[h] - cut.points[h + 2];
      check(b, CGAL::cross_product(b, cut.points[h + 1] - cut.points[h]),
            FF::frame_vectors(cad_mesh.mesh, f, alpha, rho));
      h += 3;
    }
  }
};

TYPED_TEST_SUITE(Frame_vectors, Mesh_classes, Mesh_class_names);

TYPED_TEST(Frame_vectors, are_tangent_unit_vectors_and_opposite_in_pairs)
{
  for(const double rho : { -1., 0., 0.7 })
    this->for_each_frame(quilt(), 0.3, rho, [](const Vector&, const Vector& normal, const Branches& branches)
    {
      for(const Vector& branch : branches)
      {
        EXPECT_NEAR(1, branch.squared_length(), 1e-14);
        EXPECT_NEAR(0, normal * branch / std::sqrt(normal.squared_length()), 1e-14);
      }
      EXPECT_EQ(-branches[0], branches[2]);
      EXPECT_EQ(-branches[1], branches[3]);
    });
}

TYPED_TEST(Frame_vectors, stand_at_their_angles_from_the_first_edge_counterclockwise)
{
  for(const double alpha : { -2., 0., 0.3, 1.5 })
    for(const double rho : { -1., 0., 0.7 })
      this->for_each_frame(quilt(), alpha, rho, [=](const Vector& b, const Vector& normal, const Branches& branches)
      {
        const Vector across = CGAL::cross_product(normal, b) / std::sqrt(normal.squared_length());
        const double angles[4] = { alpha, alpha + CGAL_PI / 2 + rho, alpha + CGAL_PI, alpha + 3 * CGAL_PI / 2 + rho };
        for(int k = 0; k < 4; ++k)
          EXPECT_LT(angle_between(std::cos(angles[k]) * b + std::sin(angles[k]) * across, branches[k]), 1e-12);
      });
}

TYPED_TEST(Frame_vectors, are_unit_vectors_in_the_plane_of_any_needle)
{
  for(const double distance : { 1e-4, 1e-8, 1e-15, 0. })
    for(const Model& model : { with_flat_triangle(square(8), 54, distance),
                               with_short_edge(square(8), 60, distance + 1e-9) })
      this->for_each_frame(model, 0, 0, [](const Vector& b, const Vector&, const Branches& branches)
      {
        for(const Vector& branch : branches)
          EXPECT_NEAR(1, branch.squared_length(), 1e-14);
        EXPECT_LT(angle_between(b, branches[0]), 1e-12);
        EXPECT_NEAR(0, branches[0] * branches[1], 1e-14);
      });
}

TYPED_TEST(Frame_vectors, do_not_depend_on_scale)
{
  const auto branches_of = [](const double scale)
  {
    std::vector<Branches> result;
    Frame_vectors<TypeParam>::for_each_frame(
      transformed(quilt(), [=](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); }), 0.3, 0.1,
      [&](const Vector&, const Vector&, const Branches& branches) { result.push_back(branches); });
    return result;
  };
  for(const double scale : { 1e-200, 1e-6, 1e6, 1e150 })
    EXPECT_LT(largest_branch_distance(branches_of(1), branches_of(scale)), 1e-12);
}

} // namespace
