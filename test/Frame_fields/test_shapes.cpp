#include "test_cad_mesh.h"

#include <algorithm>
#include <numeric>

// What is known beforehand of the fields of simple shapes.
namespace {

using namespace test;

template <typename Mesh>
class Shape : public testing::Test
{
protected:
  static std::vector<int> sector_indices(const Cad_mesh<Mesh>& cad_mesh)
  {
    return index_of_sectors(cad_mesh.cut(), frame_field(cad_mesh).index);
  }

  static void expect_regular_and_parallel(const Model& model)
  {
    const Cad_mesh<Mesh> cad_mesh(model);
    const Field field = frame_field(cad_mesh);
    EXPECT_LT(field.statistics.energy_orthogonal, 1e-20);
    EXPECT_LT(field.statistics.energy_relaxed, 1e-20);
    EXPECT_LT(largest(field.rho), 1e-9);
  }
};

TYPED_TEST_SUITE(Shape, Mesh_classes, Mesh_class_names);

TYPED_TEST(Shape, flat_square_has_a_parallel_field_with_four_corners)
{
  this->expect_regular_and_parallel(square(5));
  this->expect_regular_and_parallel(regular_polygon(4));
  const std::vector<int> index = this->sector_indices(Cad_mesh<TypeParam>(square(5)));
  EXPECT_EQ(4, std::count(index.begin(), index.end(), 1));
  EXPECT_EQ(static_cast<long>(index.size()) - 4, std::count(index.begin(), index.end(), 0));
}

TYPED_TEST(Shape, cube_has_parallel_fields_with_four_corners_each)
{
  this->expect_regular_and_parallel(cube());
  const std::vector<int> index = this->sector_indices(Cad_mesh<TypeParam>(cube()));
  EXPECT_EQ(24, std::count(index.begin(), index.end(), 1));
  EXPECT_EQ(static_cast<long>(index.size()) - 24, std::count(index.begin(), index.end(), 0));
}

TYPED_TEST(Shape, open_cylinder_has_a_parallel_field)
{
  this->expect_regular_and_parallel(open_cylinder());
  const std::vector<int> index = this->sector_indices(Cad_mesh<TypeParam>(open_cylinder()));
  EXPECT_EQ(std::vector<int>(index.size(), 0), index);
}

TYPED_TEST(Shape, flat_annulus_has_no_singularity)
{
  for(const int n : { 1, 4 })
  {
    const std::vector<int> index = this->sector_indices(Cad_mesh<TypeParam>(annulus(24, n)));
    EXPECT_EQ(std::vector<int>(index.size(), 0), index);
  }
}

TYPED_TEST(Shape, regular_polygon_has_quarters_at_sharp_corners_and_compensates_them)
{
  for(int n = 3; n <= 12; ++n)
  {
    SCOPED_TRACE(n);
    const Cad_mesh<TypeParam> cad_mesh(regular_polygon(n));
    const Cut cut = cad_mesh.cut();
    const std::vector<int> index = this->sector_indices(cad_mesh);
    int sum = 0;
    for(std::size_t s = 0; s < index.size(); ++s)
    {
      sum += index[s];
      if(cut.is_sharp(static_cast<int>(s), 130 * degree))
      {
        EXPECT_EQ(1, index[s]);
      }
    }
    EXPECT_EQ(4, sum);
    EXPECT_EQ(n <= 7 ? n : 0, static_cast<int>(constrained_sectors_below(cut, 130 * degree).size()));
  }
}

TYPED_TEST(Shape, index_of_closed_surface_sums_to_its_euler_characteristic)
{
  const auto sum_of_indices = [](const Model& model)
  {
    const std::vector<int> index = Shape<TypeParam>::sector_indices(Cad_mesh<TypeParam>(model));
    return std::accumulate(index.begin(), index.end(), 0);
  };
  EXPECT_EQ(8, sum_of_indices(sphere()));
  EXPECT_EQ(0, sum_of_indices(torus()));
}

TYPED_TEST(Shape, is_cut_into_patches_by_features_that_separate_it)
{
  const std::vector<std::pair<std::string, std::size_t> > expected = {
    { "torus", 1 }, { "dangling_feature", 1 }, { "closed_feature", 2 }, { "feature_from_border", 1 },
    { "feature_from_border_to_border", 2 }, { "patches_touching_in_a_vertex", 3 }, { "single_triangle", 1 },
    { "tetrahedron", 4 }, { "cube", 6 }, { "quilt", 3 } };
  const std::vector<Named_model> models = generated_models();
  for(const auto& [name, number_of_patches] : expected)
  {
    SCOPED_TRACE(name);
    const auto model = std::find_if(models.begin(), models.end(),
                                    [wanted = name](const Named_model& m) { return m.name == wanted; });
    ASSERT_NE(models.end(), model);
    const Cad_mesh<TypeParam> cad_mesh(model->make());
    EXPECT_EQ(number_of_patches, frame_field(cad_mesh).statistics.number_of_patches);
  }
}

// The end of a feature is one sector of 360 degrees, with both sides of the same edge.
TYPED_TEST(Shape, end_of_a_dangling_feature_is_one_sector)
{
  const Polyline frame = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 } };
  const Cad_mesh<TypeParam> cad_mesh(planar(frame, 0.4, { { { 1, 1 }, { 2, 2 } } }));
  const Cut cut = cad_mesh.cut();
  int number_of_ends = 0;
  for(int s = 0; s < cut.number_of_sectors(); ++s)
    number_of_ends += cut.is_constrained_sector[s] && std::abs(cut.theta[s] - 2 * CGAL_PI) < 1e-9;
  EXPECT_EQ(2, number_of_ends);
  EXPECT_EQ(std::vector<int>{ 0 }, poincare_hopf_defects(cut, frame_field(cad_mesh).index));
}

TYPED_TEST(Shape, is_split_where_a_face_has_several_features)
{
  const auto number_of_splits = [](const Model& model)
  {
    Cad_mesh<TypeParam> cad_mesh(model, false);
    const std::size_t number_of_faces = num_faces(cad_mesh.mesh);
    const std::size_t result = split_overconstrained_faces(cad_mesh);
    EXPECT_EQ(number_of_faces + 2 * result, static_cast<std::size_t>(cad_mesh.cut().number_of_faces()));
    EXPECT_EQ(0u, split_overconstrained_faces(cad_mesh));
    return result;
  };
  EXPECT_EQ(1u, number_of_splits(single_triangle()));
  EXPECT_EQ(4u, number_of_splits(tetrahedron()));
  EXPECT_EQ(12u, number_of_splits(cube()));
  EXPECT_EQ(0u, number_of_splits(sphere()));
}

TYPED_TEST(Shape, keeps_its_area_and_its_features_when_faces_are_split)
{
  const auto area = [](const Cut& cut)
  {
    double sum = 0;
    for(int h = 0; h < cut.number_of_halfedges(); h += 3)
      sum += std::sqrt(CGAL::squared_area(cut.points[h], cut.points[h + 1], cut.points[h + 2]));
    return sum;
  };
  for(const Model& model : { single_triangle(), tetrahedron(), cube(), wedge(20) })
  {
    const Cut before = Cad_mesh<TypeParam>(model, false).cut(), after = Cad_mesh<TypeParam>(model).cut();
    EXPECT_NEAR(area(before), area(after), 1e-12);
    EXPECT_EQ(std::count(before.opposite.begin(), before.opposite.end(), -1),
              std::count(after.opposite.begin(), after.opposite.end(), -1));
  }
}

} // namespace
