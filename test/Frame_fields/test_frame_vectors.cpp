#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/comb_frame_field.h>

#include <cmath>
#include <vector>

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

// What `comb_frame_field()` makes of the orthogonal field of a model.
struct Combed_field
{
  explicit Combed_field(const Model& model) : cad_mesh(model), cut(cad_mesh.cut())
  {
    const Maps<Surface_mesh> maps(cad_mesh.mesh);
    const auto np = cad_mesh.features().matching_map(maps.matching).relax_orthogonality(false);
    EXPECT_TRUE(FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index, np));
    const auto first_branch_map = get(CGAL::dynamic_face_property_t<int>(), cad_mesh.mesh);
    const auto quarter_turn_map = get(CGAL::dynamic_halfedge_property_t<int>(), cad_mesh.mesh);
    EXPECT_TRUE(FF::comb_frame_field(cad_mesh.mesh, maps.matching, first_branch_map, quarter_turn_map,
                                     cad_mesh.features()));
    field = to_field(cad_mesh, maps);
    for(const auto f : faces(cad_mesh.mesh))
      first_branch.push_back(get(first_branch_map, f));
    for_each_halfedge(cad_mesh.mesh, [&](const auto h) { quarter_turns.push_back(get(quarter_turn_map, h)); });
  }

  Cad_mesh<Surface_mesh> cad_mesh;
  Cut cut;
  Field field;
  std::vector<int> first_branch, quarter_turns;
};

class Combing : public testing::TestWithParam<Named_model> {};

// Direction k of face i is turned by r_ij onto direction k + q of face j.
TEST_P(Combing, numbers_directions_by_the_matching)
{
  const Combed_field combed(GetParam().make());
  const auto angle = [&](const int f) { return combed.field.alpha[f] + combed.first_branch[f] * CGAL_PI / 2; };
  for(int h = 0; h < combed.cut.number_of_halfedges(); ++h)
  {
    ASSERT_EQ(combed.first_branch[face_of(h)] & 3, combed.first_branch[face_of(h)]);
    if(combed.cut.is_constrained(h))
    {
      EXPECT_EQ(0, combed.quarter_turns[h]);
      continue;
    }
    const int opposite = combed.cut.opposite[h];
    EXPECT_EQ(-combed.quarter_turns[opposite], combed.quarter_turns[h]);
    const double rotation = -angle(face_of(h)) + angle(face_of(opposite)) + combed.cut.transport[h]
                          + combed.quarter_turns[h] * CGAL_PI / 2;
    EXPECT_NEAR(0, std::remainder(rotation - combed.cut.rotation(combed.field.alpha, combed.field.matching, h),
                                  2 * CGAL_PI), 1e-9);
  }
}

// So seams end at singular sectors and at constrained edges only.
TEST_P(Combing, has_quarter_turns_that_sum_to_the_index_around_each_closed_sector)
{
  const Combed_field combed(GetParam().make());
  const std::vector<double> turns(combed.quarter_turns.begin(), combed.quarter_turns.end());
  const std::vector<double> sums = combed.cut.sums_around_sectors(turns);
  const std::vector<int> index = index_of_sectors(combed.cut, combed.field.index);
  for(int s = 0; s < combed.cut.number_of_sectors(); ++s)
  {
    if(!combed.cut.is_constrained_sector[s])
    {
      EXPECT_EQ(0, std::remainder(sums[s] - index[s], 4)) << s;
    }
  }
}

TEST_P(Combing, leaves_each_patch_connected_off_the_seams)
{
  const Combed_field combed(GetParam().make());
  std::vector<char> is_reached(combed.cut.number_of_faces(), false);
  int number_of_pieces = 0;
  for(int seed = 0; seed < combed.cut.number_of_faces(); ++seed)
  {
    number_of_pieces += !is_reached[seed];
    for(std::vector<int> stack{ seed }; !stack.empty();)
    {
      const int f = stack.back();
      stack.pop_back();
      if(is_reached[f])
        continue;
      is_reached[f] = true;
      for(int h = 3 * f; h < 3 * f + 3; ++h)
        if(!combed.cut.is_constrained(h) && combed.quarter_turns[h] == 0)
          stack.push_back(face_of(combed.cut.opposite[h]));
    }
  }
  EXPECT_EQ(combed.cut.number_of_patches, number_of_pieces);
}

INSTANTIATE_TEST_SUITE_P(Generated, Combing, testing::ValuesIn(generated_models()), Model_name());

TEST(Combing_of_a_wrong_matching, is_an_error)
{
  const Cad_mesh<Surface_mesh> cad_mesh(quilt());
  const Maps<Surface_mesh> maps(cad_mesh.mesh);
  for_each_halfedge(cad_mesh.mesh, [&](const auto h) { put(maps.matching, h, 1); });
  EXPECT_EQ(FF::ERROR_WRONG_FIELD,
            FF::comb_frame_field(cad_mesh.mesh, maps.matching, get(CGAL::dynamic_face_property_t<int>(), cad_mesh.mesh),
                                 maps.index, cad_mesh.features()).error_code);
}

} // namespace
