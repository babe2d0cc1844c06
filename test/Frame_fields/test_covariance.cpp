#include "test_covariance.h"

#include <utility>

namespace {

using namespace test;

template <typename Mesh>
class Covariance : public testing::Test
{
protected:
  // Models with constraints, and without ties that rounding errors could break this way or that.
  static std::vector<Model> models()
  {
    std::vector<Model> result;
    for(const Model& model : { quilt(), star({ 5, 21, 43, 10 }), wedge(33) })
      result.push_back(Cad_mesh<Surface_mesh>(model).model()); // split once for all
    return result;
  }

  static void expect_covariant(const Transformation& map, const double scale = 1)
  {
    for(const Model& model : models())
    {
      const Model moved = transformed(model, [&](const Point& p) { return map.transform(p); });
      expect_moved(Framed_mesh(Cad_mesh<Mesh>(model)), Framed_mesh(Cad_mesh<Mesh>(moved)),
                   identity_permutation(model.triangles.size()), map, scale);
    }
  }
};

TYPED_TEST_SUITE(Covariance, Mesh_classes, Mesh_class_names);

TYPED_TEST(Covariance, under_rigid_motions)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Transformation about_z(c, -s, 0, 3, s, c, 0, -5, 0, 0, 1, 11);
  const Transformation about_x(1, 0, 0, 0.5, 0, s, -c, 2, 0, c, s, -1);
  this->expect_covariant(about_x * about_z);
}

TYPED_TEST(Covariance, under_uniform_scaling)
{
  for(const double scale : { 1e-6, 3e-3, 7., 1e6 })
    this->expect_covariant(Transformation(CGAL::SCALING, scale), scale);
}

TYPED_TEST(Covariance, under_renumbering)
{
  for(const Model& model : this->models())
  {
    const std::vector<std::size_t> new_point = random_permutation(model.points.size());
    const std::vector<std::size_t> new_face = random_permutation(model.triangles.size());
    const Model same = renumbered(model, new_point, new_face);
    expect_moved(Framed_mesh(Cad_mesh<TypeParam>(model)), Framed_mesh(Cad_mesh<TypeParam>(same)), new_face);
  }
}

TYPED_TEST(Covariance, under_a_change_of_the_halfedge_of_a_face)
{
  for(const Model& model : this->models())
  {
    Cad_mesh<TypeParam> cad_mesh(model);
    const Framed_mesh before(cad_mesh);
    std::size_t number = 0;
    for(const auto f : faces(cad_mesh.mesh))
      for(std::size_t k = number++ % 3; k > 0; --k)
        set_halfedge(f, next(halfedge(f, cad_mesh.mesh), cad_mesh.mesh), cad_mesh.mesh);
    expect_moved(before, Framed_mesh(cad_mesh), identity_permutation(number));
  }
}

TYPED_TEST(Covariance, under_orientation_reversal)
{
  for(const Model& model : this->models())
  {
    Model reversed = model;
    for(Triangle& triangle : reversed.triangles)
      std::swap(triangle[1], triangle[2]);
    expect_moved(Framed_mesh(Cad_mesh<TypeParam>(model)), Framed_mesh(Cad_mesh<TypeParam>(reversed)),
                 identity_permutation(model.triangles.size()));
  }
}

// An equilateral triangle whose faces are those of a grid, so that z is 0 in the middle: a third of a turn takes the
// faces and the border to themselves, but z to z exp(4i 2 pi / 3). The vertices inside are moved to break the symmetry.
Model triangle_with_vanishing_value()
{
  const int n = 5;
  Model result;
  std::vector<std::vector<std::size_t> > number(n + 1);
  CGAL::Random random(1);
  for(int row = 0; row <= n; ++row)
    for(int column = 0; column <= n - row; ++column)
    {
      number[row].push_back(result.points.size());
      const double size = row == 0 || column == 0 || row + column == n ? 0 : 0.2;
      result.points.emplace_back(column + row / 2. + size * random.get_double(-1, 1),
                                 row * std::sqrt(0.75) + size * random.get_double(-1, 1), 0);
    }
  for(int row = 0; row < n; ++row)
    for(int column = 0; column < n - row; ++column)
    {
      result.triangles.push_back({ number[row][column], number[row][column + 1], number[row + 1][column] });
      if(column > 0)
        result.triangles.push_back({ number[row][column], number[row + 1][column], number[row + 1][column - 1] });
    }
  return Cad_mesh<Surface_mesh>(result).model();
}

TYPED_TEST(Covariance, where_the_values_around_a_face_cancel_out)
{
  const Model model = triangle_with_vanishing_value();
  const Framed_mesh before{ Cad_mesh<TypeParam>(model) };
  for(int seed = 1; seed <= 10; ++seed)
  {
    const std::vector<std::size_t> new_face = random_permutation(model.triangles.size(), seed);
    const Transformation turn(std::cos(seed), -std::sin(seed), 0, 3, std::sin(seed), std::cos(seed), 0, -5, 0, 0, 1, 2);
    const Model moved = transformed(renumbered(model, random_permutation(model.points.size(), seed), new_face),
                                    [&](const Point& p) { return turn.transform(p); });
    expect_moved(before, Framed_mesh(Cad_mesh<TypeParam>(moved)), new_face, turn);
  }
}

} // namespace
