#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/orthogonal_frame_field.h>

#include <CGAL/Random.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace {

using namespace test;

class Orthogonal_field : public On_models
{
protected:
  // Random angles, but aligned with the constrained edges.
  static std::vector<double> random_aligned_field(const Cut& cut)
  {
    CGAL::Random random(3);
    std::vector<double> alpha;
    for(int f = 0; f < cut.number_of_faces(); ++f)
      alpha.push_back(random.get_double(0, CGAL_PI));
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      if(cut.is_constrained(h))
        alpha[face_of(h)] = cut.phi[h];
    return alpha;
  }

  // The rotations of a field, with some quarter turns added.
  static std::vector<double> rotations(const Cut& cut, const std::vector<double>& alpha)
  {
    std::vector<double> omega(cut.number_of_halfedges(), 0);
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      if(h < cut.opposite[h])
      {
        omega[h] = -alpha[face_of(h)] + alpha[face_of(cut.opposite[h])] + cut.transport[h] + (h % 3) * CGAL_PI / 2;
        omega[cut.opposite[h]] = -omega[h];
      }
    return omega;
  }

  // The field with the smallest |r - omega|.
  template <typename Mesh>
  static Field field_nearest_to(const std::vector<double>& omega, const Cad_mesh<Mesh>& cad_mesh)
  {
    const Maps<Mesh> maps(cad_mesh.mesh);
    int h = 0;
    for_each_halfedge(cad_mesh.mesh, [&](const auto halfedge) { put(maps.omega, halfedge, omega[h++]); });
    const FF::Result result = FF::orthogonal_frame_field(
      cad_mesh.mesh, maps.alpha, cad_mesh.features().prescribed_rotation_map(maps.omega).matching_map(maps.matching)
                                                    .repair_matching(false));
    EXPECT_TRUE(result) << result.message;
    return to_field(cad_mesh, maps);
  }

  static double largest_rotation_error(const Cut& cut, const Field& field, const std::vector<double>& omega)
  {
    std::vector<double> error;
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      if(!cut.is_constrained(h))
        error.push_back(std::remainder(cut.rotation(field.alpha, field.matching, h) - omega[h], 2 * CGAL_PI));
    return largest(error);
  }
};

// A field with exactly the prescribed rotations has the least energy, which is zero. Without constraint it is
// determined up to a common rotation.
TEST_P(Orthogonal_field, has_the_prescribed_rotations_if_any_field_has_them)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const Cut cut = cad_mesh.cut();
    const std::vector<double> alpha = random_aligned_field(cut), omega = rotations(cut, alpha);
    const Field field = field_nearest_to(omega, cad_mesh);
    EXPECT_LT(largest_rotation_error(cut, field, omega), 1e-9);
    EXPECT_LT(largest_misalignment(cut, field), 1e-9);
  });
}

TEST_P(Orthogonal_field, has_the_matching_that_is_nearest_to_the_prescribed_rotations)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const Cut cut = cad_mesh.cut();
    const Field field = frame_field(cad_mesh, parameters::relax_orthogonality(false).repair_matching(false));
    EXPECT_LE(largest_rotation_error(cut, field, field.omega), CGAL_PI / 4 + 1e-12);
  });
}

// The values z of the orthogonal field, solved for in a wider range of exponents than that of `double`.
std::vector<std::complex<long double> > values_in_wide_range(const Cut& cut, const Field& field)
{
  typedef std::complex<long double> Value;
  const auto unit = [](const double angle) { return Value(std::cos(angle), std::sin(angle)); };
  const int size = cut.number_of_faces();
  std::vector<Value> aligned(size, 0);
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(cut.is_constrained(h))
      aligned[face_of(h)] = unit(4 * cut.phi[h]);
  std::vector<Eigen::Triplet<Value> > entries;
  Eigen::Matrix<Value, Eigen::Dynamic, 1> right_hand_side(size), z(size);
  for(int f = 0; f < size; ++f)
  {
    right_hand_side[f] = aligned[f];
    entries.emplace_back(f, f, aligned[f] != Value(0) ? 1 : 3);
  }
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
  {
    const int i = face_of(h), j = face_of(cut.opposite[h]);
    if(cut.is_constrained(h) || aligned[i] != Value(0))
      continue;
    const Value transport = unit(4 * (cut.transport[h] - field.omega[h]));
    if(aligned[j] != Value(0))
      right_hand_side[i] += transport * aligned[j];
    else
      entries.emplace_back(i, j, -transport);
  }
  Eigen::SparseMatrix<Value> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  z = Eigen::SimplicialLDLT<Eigen::SparseMatrix<Value> >(matrix).solve(right_hand_side);
  return std::vector<Value>(z.data(), z.data() + size);
}

// On a rough surface |z| falls exponentially with the distance from the constraints.
TEST(Orthogonal_field_of_a_long_tube, is_that_of_unbounded_exponents)
{
  if(std::numeric_limits<long double>::min_exponent10 > -4000)
    GTEST_SKIP() << "long double has no wider range than double";
  const Cad_mesh<Surface_mesh> cad_mesh(rough_tube(5000));
  const Cut cut = cad_mesh.cut();
  const Field field = orthogonal_field(cad_mesh);
  const std::vector<std::complex<long double> > z = values_in_wide_range(cut, field);
  long double smallest = 1, largest_error = 0;
  for(int f = 0; f < cut.number_of_faces(); ++f)
  {
    smallest = (std::min)(smallest, std::abs(z[f]));
    largest_error = (std::max)(largest_error,
                               std::abs(std::remainder(std::arg(z[f]) / 4 - field.alpha[f], CGAL_PI / 2)));
  }
  EXPECT_LT(smallest, 1e-500L); // so this is about values that no double can hold
  EXPECT_LT(largest_error, 1e-9L);
}

TEST(Orthogonal_field_of_a_long_tube, has_singularities_in_proportion_to_its_length)
{
  const auto number_of_singularities = [](const int number_of_rings)
  {
    const Cad_mesh<Surface_mesh> cad_mesh(rough_tube(number_of_rings));
    const std::vector<int> index = index_of_sectors(cad_mesh.cut(), orthogonal_field(cad_mesh).index);
    return index.size() - std::count(index.begin(), index.end(), 0);
  };
  const double expected = 10. * number_of_singularities(1000); // where no value leaves the range of double
  EXPECT_NEAR(expected, number_of_singularities(10000), 4 * std::sqrt(expected));
}

INSTANTIATE_TEST_SUITE_P(Generated, Orthogonal_field, testing::ValuesIn(generated_models()), Model_name());

} // namespace
