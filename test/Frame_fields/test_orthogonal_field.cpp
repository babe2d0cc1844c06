#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/orthogonal_frame_field.h>

#include <CGAL/Random.h>

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

INSTANTIATE_TEST_SUITE_P(Generated, Orthogonal_field, testing::ValuesIn(generated_models()), Model_name());

} // namespace
