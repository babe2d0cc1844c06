#include "test_cad_mesh.h"

#include <CGAL/Frame_fields.h>

namespace {

using namespace test;
using CGAL::Frame_fields::Support_strategy;

// Calls the functions of the stages one after the other.
template <typename Mesh, typename NamedParameters>
Field frame_field_by_stages(const Cad_mesh<Mesh>& cad_mesh, const NamedParameters& options)
{
  const Mesh& mesh = cad_mesh.mesh;
  const Maps<Mesh> maps(mesh);
  const auto np = parameters::join(options, cad_mesh.features());
  EXPECT_TRUE(FF::prescribe_rotation(mesh, maps.omega, np));
  EXPECT_TRUE(FF::orthogonal_frame_field(
    mesh, maps.alpha, np.prescribed_rotation_map(maps.omega).matching_map(maps.matching)));
  EXPECT_TRUE(FF::singularity_indices(mesh, maps.alpha, maps.matching, maps.index, np));
  EXPECT_TRUE(FF::relax_frame_field(mesh, maps.alpha, maps.rho, np.matching_map(maps.matching)));
  return to_field(cad_mesh, maps);
}

void expect_identical(const Field& expected, const Field& field)
{
  EXPECT_EQ(expected.omega, field.omega);
  EXPECT_EQ(expected.alpha, field.alpha);
  EXPECT_EQ(expected.rho, field.rho);
  EXPECT_EQ(expected.matching, field.matching);
  EXPECT_EQ(expected.index, field.index);
}

class Stages : public On_models {};

TEST_P(Stages, give_bitwise_the_field_of_the_whole_pipeline)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const auto defaults = parameters::sharp_corner_bound(0.75 * CGAL_PI);
    expect_identical(frame_field(cad_mesh), frame_field_by_stages(cad_mesh, defaults));
    const auto options = parameters::support_strategy(Support_strategy::component()).maximum_skewness(0.1)
                                    .orthogonality_weight(0.5).repair_matching(false);
    expect_identical(frame_field(cad_mesh, options), frame_field_by_stages(cad_mesh, options));
  });
}

TEST_P(Stages, give_bitwise_the_same_field_in_parallel)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const auto parallel = parameters::concurrency_tag(CGAL::Parallel_if_available_tag());
    expect_identical(frame_field(cad_mesh), frame_field(cad_mesh, parallel));
    expect_identical(frame_field(cad_mesh), frame_field_by_stages(cad_mesh, parallel));
  });
}

TEST_P(Stages, give_the_same_indices_before_and_after_relaxation)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const auto& mesh = cad_mesh.mesh;
    const Maps<typename std::decay_t<decltype(cad_mesh)>::Mesh> maps(mesh), again(mesh);
    ASSERT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
                                    cad_mesh.features().matching_map(maps.matching)));
    ASSERT_TRUE(FF::singularity_indices(mesh, maps.alpha, maps.matching, again.index,
                                        cad_mesh.features().skewness_map(maps.rho)));
    EXPECT_EQ(to_field(cad_mesh, maps).index, to_field(cad_mesh, again).index);
  });
}

// Without a matching, the relaxation finds the one of the pipeline from the prescribed rotation.
TEST_P(Stages, find_the_matching_again)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    const auto& mesh = cad_mesh.mesh;
    const Maps<typename std::decay_t<decltype(cad_mesh)>::Mesh> maps(mesh);
    ASSERT_TRUE(FF::prescribe_rotation(mesh, maps.omega, cad_mesh.features()));
    const auto np = cad_mesh.features().prescribed_rotation_map(maps.omega);
    ASSERT_TRUE(FF::orthogonal_frame_field(mesh, maps.alpha, np));
    ASSERT_TRUE(FF::relax_frame_field(mesh, maps.alpha, maps.rho, np));
    const Field expected = frame_field(cad_mesh), field = to_field(cad_mesh, maps);
    EXPECT_EQ(expected.alpha, field.alpha);
    EXPECT_EQ(expected.rho, field.rho);
  });
}

// Every certified patch is mapped exactly, the others are listed and mapped to the origin.
TEST_P(Stages, map_patches_seamlessly)
{
  typedef Kernel::Point_2 Point_2;
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    typedef typename std::decay_t<decltype(cad_mesh)>::Mesh Mesh;
    const Mesh& mesh = cad_mesh.mesh;
    const Maps<Mesh> maps(mesh);
    ASSERT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
                                    cad_mesh.features().matching_map(maps.matching)));
    const Halfedge_map<Mesh, Point_2> uv_map = get(CGAL::dynamic_halfedge_property_t<Point_2>(), mesh);
    std::vector<FF::Uncertified_patch<typename boost::graph_traits<Mesh>::face_descriptor> > uncertified;
    const FF::Result result = FF::seamless_parameterization(
      mesh, maps.alpha, maps.rho, maps.matching, maps.index, uv_map,
      cad_mesh.features().uncertified_patch_output_iterator(std::back_inserter(uncertified)));
    ASSERT_TRUE(result) << result.message;

    const Cut cut = cad_mesh.cut();
    std::vector<Point_2> uv;
    for_each_halfedge(mesh, [&](const auto h) { uv.push_back(get(uv_map, h)); });
    const auto along = [&](const int h) { return uv[h] - uv[h % 3 == 0 ? h + 2 : h - 1]; };
    std::set<int> uncertified_patches;
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
    {
      const auto d = along(h);
      const int next = h % 3 == 2 ? h - 2 : h + 1;
      if(CGAL::determinant(d, along(next)) <= 0)
      {
        EXPECT_EQ(Point_2(0, 0), uv[h]);
        uncertified_patches.insert(cut.patch[h / 3]);
        continue;
      }
      if(cut.is_constrained(h))
        EXPECT_NE(d.x() == 0, d.y() == 0);
      else
      {
        const auto e = along(cut.opposite[h]);
        EXPECT_TRUE(e == -d || e == d || e == Kernel::Vector_2(-d.y(), d.x()) || e == Kernel::Vector_2(d.y(), -d.x()));
      }
    }
    EXPECT_EQ(uncertified_patches.size(), uncertified.size());
  });
}

TEST(Seamless_parameterization, reads_its_parameters)
{
  const Cad_mesh<Surface_mesh> cad_mesh(generated_models().front().make());
  const Maps<Surface_mesh> maps(cad_mesh.mesh);
  ASSERT_TRUE(FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
                                  cad_mesh.features().matching_map(maps.matching)));
  const auto uv_map = get(CGAL::dynamic_halfedge_property_t<Kernel::Point_2>(), cad_mesh.mesh);
  const auto map_with = [&](const double target_edge_length)
  {
    return FF::seamless_parameterization(cad_mesh.mesh, maps.alpha, maps.rho, maps.matching, maps.index, uv_map,
                                         cad_mesh.features().target_edge_length(target_edge_length)).error_code;
  };
  const auto square_of_some_side = [&]
  {
    const auto h = *halfedges(cad_mesh.mesh).first;
    return CGAL::squared_distance(get(uv_map, h), get(uv_map, prev(h, cad_mesh.mesh)));
  };
  EXPECT_EQ(FF::OK, map_with(1));
  const double square = square_of_some_side();
  EXPECT_GT(square, 0);
  EXPECT_EQ(FF::OK, map_with(0.5));
  EXPECT_NEAR(4 * square, square_of_some_side(), 1e-6 * square);
  EXPECT_EQ(FF::ERROR_WRONG_PARAMETER, map_with(0));
  for(const auto h : halfedges(cad_mesh.mesh))
    put(maps.index, h, 7);
  EXPECT_EQ(FF::ERROR_WRONG_FIELD, map_with(1));
}

INSTANTIATE_TEST_SUITE_P(Generated, Stages, testing::ValuesIn(generated_models()), Model_name());

std::vector<Named_model> models_of_cgal()
{
  std::vector<Named_model> result;
  for(const Named_model& model : cgal_models())
    if(model.name == "fandisk" || model.name == "joint" || model.name == "pinion" || model.name == "blade")
      result.push_back(model);
  return result;
}

INSTANTIATE_TEST_SUITE_P(CGAL, Stages, testing::ValuesIn(models_of_cgal()), Model_name());

} // namespace
