#ifndef TEST_FRAME_FIELDS_TEST_COVARIANCE_H
#define TEST_FRAME_FIELDS_TEST_COVARIANCE_H

#include "test_cad_mesh.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <numeric>
#include <vector>

// Models that are moved or renumbered take their fields along.
namespace test {

typedef CGAL::Aff_transformation_3<Kernel> Transformation;

// A field with what identifies its faces and corners.
struct Framed_mesh
{
  Cut cut;
  Field field;

  template <typename Mesh>
  explicit Framed_mesh(const Cad_mesh<Mesh>& cad_mesh) : Framed_mesh(cad_mesh, cad_mesh.features()) {}
  template <typename Mesh, typename NamedParameters>
  Framed_mesh(const Cad_mesh<Mesh>& cad_mesh, const NamedParameters& np)
    : cut(cad_mesh.cut()), field(frame_field(cad_mesh, np))
  {}
};

inline int corner_at(const Cut& cut, const int face, const Point& p)
{
  for(int h = 3 * face; h < 3 * face + 3; ++h)
    if(cut.points[h] == p)
      return h;
  ADD_FAILURE() << "face " << face << " has no vertex at " << p;
  return 3 * face;
}

// Expects the field `after` to be the field `before` moved by `map`, where face f has become face `new_face[f]`.
inline void expect_moved(const Framed_mesh& before, const Framed_mesh& after, const std::vector<std::size_t>& new_face,
                  const Transformation& map = CGAL::IDENTITY, const double scale = 1)
{
  const double tolerance = 1e-7;
  std::vector<std::array<Vector, 4> > frames_before, frames_after;
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

inline std::vector<std::size_t> identity_permutation(const std::size_t size)
{
  std::vector<std::size_t> result(size);
  std::iota(result.begin(), result.end(), 0);
  return result;
}

inline std::vector<std::size_t> random_permutation(const std::size_t size, const int seed = 7)
{
  std::vector<std::size_t> result = identity_permutation(size);
  CGAL::Random random(seed);
  CGAL::cpp98::random_shuffle(result.begin(), result.end(), random);
  return result;
}

// The model with point p as point `new_point[p]`, face f as face `new_face[f]`, and the points of the faces cyclically
// shifted.
inline Model renumbered(const Model& model, const std::vector<std::size_t>& new_point,
                        const std::vector<std::size_t>& new_face)
{
  Model result = model;
  for(std::size_t i = 0; i < new_point.size(); ++i)
    result.points[new_point[i]] = model.points[i];
  for(std::size_t f = 0; f < new_face.size(); ++f)
  {
    Triangle& triangle = result.triangles[new_face[f]];
    for(int k = 0; k < 3; ++k)
      triangle[k] = new_point[model.triangles[f][(k + f) % 3]];
  }
  return result;
}

} // namespace test

#endif // TEST_FRAME_FIELDS_TEST_COVARIANCE_H
