#include "test_cad_mesh.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <numeric>

namespace {

using namespace test;

typedef CGAL::Aff_transformation_3<Kernel> Transformation;
typedef std::vector<std::array<Vector, 4> > Frames;

constexpr double tolerance = 1e-7;

// A field with what identifies its faces and corners.
struct Framed_mesh
{
  Cut cut;
  Field field;

  template <typename Mesh>
  explicit Framed_mesh(const Cad_mesh<Mesh>& cad_mesh) : cut(cad_mesh.cut()), field(frame_field(cad_mesh)) {}
};

int corner_at(const Cut& cut, const int face, const Point& p)
{
  for(int h = 3 * face; h < 3 * face + 3; ++h)
    if(cut.points[h] == p)
      return h;
  ADD_FAILURE() << "face " << face << " has no vertex at " << p;
  return 3 * face;
}

// Expects the field `after` to be the field `before` moved by `map`, where face f has become face `new_face[f]`.
void expect_moved(const Framed_mesh& before, const Framed_mesh& after, const std::vector<std::size_t>& new_face,
                  const Transformation& map = CGAL::IDENTITY, const double scale = 1)
{
  Frames frames_before, frames_after;
  for(int f = 0; f < before.cut.number_of_faces(); ++f)
  {
    frames_before.push_back(before.field.branches[f]);
    for(Vector& branch : frames_before.back())
      branch = map.transform(branch) / scale;
    frames_after.push_back(after.field.branches[new_face[f]]);
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      EXPECT_EQ(before.field.index[h], after.field.index[corner_at(after.cut, static_cast<int>(new_face[f]),
                                                                   map.transform(before.cut.points[h]))]);
  }
  EXPECT_LT(largest_branch_distance(frames_before, frames_after), tolerance);
  EXPECT_LT(largest_branch_distance(frames_after, frames_before), tolerance);
}

std::vector<std::size_t> identity_permutation(const std::size_t size)
{
  std::vector<std::size_t> result(size);
  std::iota(result.begin(), result.end(), 0);
  return result;
}

std::vector<std::size_t> random_permutation(const std::size_t size)
{
  std::vector<std::size_t> result = identity_permutation(size);
  CGAL::Random random(7);
  CGAL::cpp98::random_shuffle(result.begin(), result.end(), random);
  return result;
}

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
    Model renumbered = model;
    for(std::size_t i = 0; i < new_point.size(); ++i)
      renumbered.points[new_point[i]] = model.points[i];
    for(std::size_t f = 0; f < new_face.size(); ++f)
    {
      Triangle& triangle = renumbered.triangles[new_face[f]];
      for(int k = 0; k < 3; ++k)
        triangle[k] = new_point[model.triangles[f][(k + f) % 3]];
    }
    expect_moved(Framed_mesh(Cad_mesh<TypeParam>(model)), Framed_mesh(Cad_mesh<TypeParam>(renumbered)), new_face);
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

} // namespace
