#include "map_contract.h"
#include "test_cad_mesh.h"

#include <CGAL/Frame_fields.h>

namespace {

using namespace test;
using CGAL::Frame_fields::Support_strategy;

// Calls the functions of the stages one after the other, for a mesh or for one that is cut.
template <typename TriangleMesh, typename Mesh, typename NamedParameters>
void call_stages(const TriangleMesh& mesh, const Maps<Mesh>& maps, const NamedParameters& np)
{
  EXPECT_TRUE(FF::prescribe_rotation(mesh, maps.omega, np));
  EXPECT_TRUE(FF::orthogonal_frame_field(
    mesh, maps.alpha, np.prescribed_rotation_map(maps.omega).matching_map(maps.matching)));
  EXPECT_TRUE(FF::singularity_indices(mesh, maps.alpha, maps.matching, maps.index, np));
  EXPECT_TRUE(FF::relax_frame_field(mesh, maps.alpha, maps.rho, np.matching_map(maps.matching)));
}

template <typename Mesh, typename NamedParameters>
Field frame_field_by_stages(const Cad_mesh<Mesh>& cad_mesh, const NamedParameters& options)
{
  const Maps<Mesh> maps(cad_mesh.mesh);
  call_stages(cad_mesh.mesh, maps, parameters::join(options, cad_mesh.features()));
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

// All that the functions behind a field give, as one list of numbers.
template <typename TriangleMesh, typename Mesh, typename NamedParameters>
std::vector<double> readings(const TriangleMesh& mesh, const Cad_mesh<Mesh>& cad_mesh, const Maps<Mesh>& maps,
                             const NamedParameters& np)
{
  typedef boost::graph_traits<Mesh> Graph_traits;
  std::vector<double> result;
  std::vector<typename Graph_traits::halfedge_descriptor> corners;
  EXPECT_TRUE(FF::sharp_corners(mesh, std::back_inserter(corners), np));
  result.push_back(static_cast<double>(corners.size()));
  std::vector<FF::Singularity<typename Graph_traits::halfedge_descriptor> > singularities;
  EXPECT_TRUE(FF::singularities(mesh, maps.index, std::back_inserter(singularities), np));
  for(const auto& singularity : singularities)
    result.insert(result.end(), { singularity.angle, singularity.distance_to_features });
  FF::Field_quality quality;
  EXPECT_TRUE(FF::frame_field_quality(mesh, maps.alpha, maps.rho, maps.matching, np.quality(std::ref(quality))));
  result.insert(result.end(), { quality.energy, quality.curl, quality.mean_skewness });
  std::vector<FF::Streamline<Point, typename Graph_traits::face_descriptor> > streamlines;
  EXPECT_TRUE(FF::trace_streamlines(mesh, maps.alpha, maps.rho, maps.matching, std::back_inserter(streamlines), np));
  for(const auto& streamline : streamlines)
    result.insert(result.end(), { streamline.points.back().x(), streamline.points.back().y() });
  const Face_map<Mesh, int> first_branch = get(CGAL::dynamic_face_property_t<int>(), cad_mesh.mesh);
  const Halfedge_map<Mesh, int> quarter_turn = get(CGAL::dynamic_halfedge_property_t<int>(), cad_mesh.mesh);
  EXPECT_TRUE(FF::comb_frame_field(mesh, maps.matching, first_branch, quarter_turn, np));
  const Halfedge_map<Mesh, Point_2> uv = get(CGAL::dynamic_halfedge_property_t<Point_2>(), cad_mesh.mesh);
  EXPECT_TRUE(FF::seamless_parameterization(mesh, maps.alpha, maps.rho, maps.matching, maps.index, uv, np));
  for_each_halfedge(cad_mesh.mesh, [&](const auto h)
  {
    result.insert(result.end(), { get(uv, h).x(), get(uv, h).y(), static_cast<double>(get(quarter_turn, h)) });
  });
  return result;
}

class Mesh_cut_once : public On_models {};

TEST_P(Mesh_cut_once, gives_bitwise_the_same)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh)
  {
    typedef typename std::decay_t<decltype(cad_mesh)>::Mesh Mesh;
    const Mesh& mesh = cad_mesh.mesh;
    const auto defaults = parameters::sharp_corner_bound(0.75 * CGAL_PI);
    const Maps<Mesh> expected(mesh), maps(mesh);
    call_stages(mesh, expected, parameters::join(defaults, cad_mesh.features()));

    int number_of_reads = 0;
    typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
    const auto points = boost::make_function_property_map<vertex_descriptor, Point>([&](const vertex_descriptor v)
    {
      ++number_of_reads;
      return cad_mesh.point(v);
    });
    const FF::Cut_triangle_mesh cut(mesh, cad_mesh.features().vertex_point_map(points));
    ASSERT_TRUE(cut.result()) << cut.result().message;
    const int number_of_reads_of_cut = number_of_reads;
    EXPECT_GT(number_of_reads_of_cut, 0);
    call_stages(cut, maps, defaults);
    EXPECT_EQ(number_of_reads_of_cut, number_of_reads);
    expect_identical(to_field(cad_mesh, expected), to_field(cad_mesh, maps));
    EXPECT_EQ(readings(mesh, cad_mesh, expected, cad_mesh.features()), readings(cut, cad_mesh, maps, defaults));

    // The whole pipeline as well; what guides it leaves the cut as it was.
    const auto n = get(CGAL::dynamic_face_property_t<Kernel::Vector_3>(), mesh);
    for(const auto f : faces(mesh))
      put(n, f, Kernel::Vector_3(1, 2, 3));
    const auto guided = parameters::guiding_direction_map(n);
    for(const bool is_guided : { true, false })
    {
      const auto field_of = [&](const auto& any_mesh, const auto& np)
      {
        const Maps<Mesh> of_pipeline(mesh);
        const FF::Result result = FF::cad_frame_field(any_mesh, of_pipeline.alpha, of_pipeline.rho, of_pipeline.index,
                                                      np.matching_map(of_pipeline.matching));
        EXPECT_TRUE(result) << result.message;
        return to_field(cad_mesh, of_pipeline);
      };
      if(is_guided)
        expect_identical(field_of(mesh, parameters::join(guided, cad_mesh.features())), field_of(cut, guided));
      else
        expect_identical(field_of(mesh, cad_mesh.features()), field_of(cut, defaults));
    }
  });
}

// The weights of the edges are those of the cut.
TEST(Cut_triangle_mesh, keeps_the_weights_of_the_edges)
{
  const Cad_mesh<Surface_mesh> cad_mesh(generated_models().front().make());
  const Surface_mesh& mesh = cad_mesh.mesh;
  const Maps<Surface_mesh> expected(mesh), maps(mesh);
  const auto np = cad_mesh.features().edge_weighting(FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH);
  call_stages(mesh, expected, np);
  call_stages(FF::Cut_triangle_mesh(mesh, np), maps, parameters::maximum_skewness(0.45 * CGAL_PI));
  expect_identical(to_field(cad_mesh, expected), to_field(cad_mesh, maps));
}

TEST(Cut_triangle_mesh, is_refused_if_it_failed_or_the_mesh_has_changed)
{
  Surface_mesh mesh;
  const FF::Cut_triangle_mesh<Surface_mesh> empty(mesh);
  EXPECT_EQ(FF::ERROR_EMPTY_MESH, empty.result().error_code);
  EXPECT_EQ(0u, empty.number_of_patches());
  const Maps<Surface_mesh> maps(mesh);
  EXPECT_EQ(FF::ERROR_EMPTY_MESH, FF::prescribe_rotation(empty, maps.omega).error_code);

  const auto a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0));
  mesh.add_face(a, b, mesh.add_vertex(Point(0, 1, 0)));
  const FF::Cut_triangle_mesh<Surface_mesh> triangle(mesh); // overconstrained, which these functions refuse or accept
  EXPECT_TRUE(triangle.result());
  EXPECT_EQ(1u, triangle.number_of_patches());
  EXPECT_EQ(&mesh, &triangle.triangle_mesh());
  const auto omega = get(CGAL::dynamic_halfedge_property_t<double>(), static_cast<const Surface_mesh&>(mesh));
  EXPECT_EQ(FF::ERROR_OVERCONSTRAINED_FACE, FF::prescribe_rotation(triangle, omega).error_code);
  std::vector<Surface_mesh::Halfedge_index> corners;
  EXPECT_TRUE(FF::sharp_corners(triangle, std::back_inserter(corners)));
  EXPECT_EQ(3u, corners.size());

  mesh.add_face(b, a, mesh.add_vertex(Point(1, -1, 0)));
  const FF::Result result = FF::sharp_corners(triangle, std::back_inserter(corners));
  EXPECT_EQ(FF::ERROR_MESH_CHANGED, result.error_code);
  EXPECT_NE(std::string::npos, result.message.find("1 faces then, 2 now")) << result.message;
  EXPECT_EQ(3u, corners.size());
}

// Every certified patch is mapped exactly, the others are listed and mapped to the origin.
TEST_P(Stages, map_patches_seamlessly)
{
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
    std::vector<int> index;
    for_each_halfedge(mesh, [&](const auto h)
    {
      uv.push_back(get(uv_map, h));
      index.push_back(get(maps.index, h));
    });
    EXPECT_EQ("", broken_facts_of_map(cut, index_of_sectors(cut, index), uv, uncertified.size()));
  });
}

// An integer-grid map is a seamless map with integers: those of the translations, of irregular vertices and of feature
// edges are tested on the maps of the quads.
TEST_P(Stages, map_patches_to_integer_grids)
{
  const Cad_mesh<Surface_mesh> cad_mesh(GetParam().make());
  const Surface_mesh& mesh = cad_mesh.mesh;
  const Maps<Surface_mesh> maps(mesh);
  ASSERT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
                                  cad_mesh.features().matching_map(maps.matching)));
  const Halfedge_map<Surface_mesh, Point_2> uv_map = get(CGAL::dynamic_halfedge_property_t<Point_2>(), mesh);
  std::vector<FF::Uncertified_patch<Surface_mesh::Face_index> > uncertified;
  const FF::Result result = FF::integer_grid_parameterization(
    mesh, maps.alpha, maps.rho, maps.matching, maps.index, uv_map,
    cad_mesh.features().uncertified_patch_output_iterator(std::back_inserter(uncertified)));
  ASSERT_TRUE(result) << result.message;

  const Cut cut = cad_mesh.cut();
  std::vector<Point_2> uv;
  std::vector<int> index;
  for_each_halfedge(mesh, [&](const auto h)
  {
    uv.push_back(get(uv_map, h));
    index.push_back(get(maps.index, h));
  });
  EXPECT_EQ("", broken_facts_of_map(cut, index_of_sectors(cut, index), uv, uncertified.size()));
}

// The grid has as many unit squares as there are quads, and both sides of a curve have its number of edges.
TEST(Integer_grid_parameterization, has_the_quads_of_quad_mesh)
{
  const Cad_mesh<Surface_mesh> cad_mesh(generated_models().front().make());
  const Surface_mesh& mesh = cad_mesh.mesh;
  const Maps<Surface_mesh> maps(mesh);
  ASSERT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
                                  cad_mesh.features().matching_map(maps.matching)));
  const auto uv_map = get(CGAL::dynamic_halfedge_property_t<Kernel::Point_2>(), mesh);
  for(const double number_of_quads : { 40., 300., 2000. })
  {
    const auto np = cad_mesh.features().number_of_quads(number_of_quads);
    Surface_mesh quad_mesh;
    ASSERT_TRUE(FF::quad_mesh(mesh, maps.alpha, maps.rho, maps.matching, maps.index, quad_mesh, np));
    ASSERT_TRUE(FF::integer_grid_parameterization(mesh, maps.alpha, maps.rho, maps.matching, maps.index, uv_map, np));
    double area = 0;
    for(const auto f : faces(mesh))
    {
      const auto h = halfedge(f, mesh);
      area += CGAL::area(get(uv_map, prev(h, mesh)), get(uv_map, h), get(uv_map, next(h, mesh)));
    }
    EXPECT_NEAR(static_cast<double>(num_faces(quad_mesh)), area, 1e-6);
  }
  EXPECT_EQ(FF::ERROR_WRONG_PARAMETER,
            FF::integer_grid_parameterization(mesh, maps.alpha, maps.rho, maps.matching, maps.index, uv_map,
                                              cad_mesh.features().target_edge_length(-1.)).error_code);
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

// A square with n by n squares of two faces each, without feature.
Surface_mesh square_grid(const int n)
{
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> grid;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      grid.push_back(mesh.add_vertex(Point(double(j) / n, double(i) / n, 0)));
  const auto corner = [&](const int i, const int j) { return grid[i * (n + 1) + j]; };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      mesh.add_face(corner(i, j), corner(i, j + 1), corner(i + 1, j + 1));
      mesh.add_face(corner(i, j), corner(i + 1, j + 1), corner(i + 1, j));
    }
  return mesh;
}

TEST(Seamless_parameterization, has_the_sizes_asked_for)
{
  Surface_mesh mesh = square_grid(20);
  ASSERT_TRUE(FF::prepare_for_frame_field(mesh));
  const Maps<Surface_mesh> maps(mesh);
  ASSERT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index, parameters::matching_map(maps.matching)));
  const auto uv_map = get(CGAL::dynamic_halfedge_property_t<Kernel::Point_2>(), mesh);
  const auto result_with = [&](const auto& np)
  {
    return FF::seamless_parameterization(mesh, maps.alpha, maps.rho, maps.matching, maps.index, uv_map, np);
  };
  const auto area_in_plane = [&](const auto f)
  {
    const auto h = halfedge(f, mesh);
    return CGAL::area(get(uv_map, prev(h, mesh)), get(uv_map, h), get(uv_map, next(h, mesh)));
  };
  const auto whole_area = [&]
  {
    double sum = 0;
    for(const auto f : faces(mesh))
      sum += area_in_plane(f);
    return sum;
  };
  const auto size = [&](const double left, const double right)
  {
    return parameters::sizing_map(boost::make_function_property_map<Surface_mesh::Vertex_index>(
      [&mesh, left, right](const auto v) { return left + (right - left) * mesh.point(v).x(); }));
  };
  ASSERT_TRUE(result_with(parameters::target_edge_length(0.1)));
  EXPECT_NEAR(100, whole_area(), 1e-6);
  ASSERT_TRUE(result_with(parameters::number_of_quads(1600)));
  EXPECT_NEAR(1600, whole_area(), 1e-5);
  ASSERT_TRUE(result_with(size(0.2, 0.2)));
  EXPECT_NEAR(25, whole_area(), 1e-6);

  // Faces become larger where edges should be shorter; what is asked for without `number_of_quads` has its own unit.
  ASSERT_TRUE(result_with(size(0.2, 0.05)));
  const double number = whole_area();
  double left = 0, right = 0;
  for(const auto f : faces(mesh))
  {
    const double x = mesh.point(target(halfedge(f, mesh), mesh)).x();
    if(x < 0.3)
      left += area_in_plane(f);
    if(x > 0.7)
      right += area_in_plane(f);
  }
  EXPECT_GT(right, 1.5 * left);
  // As v is the same everywhere, it can follow the sizes only on average: the area is the squared mean of 1 / size,
  // over its mean square.
  ASSERT_TRUE(result_with(size(20, 5).number_of_quads(1600)));
  const double mean = std::log(4) / 15, mean_square = 1. / 100;
  EXPECT_NEAR(1600 * mean * mean / mean_square, whole_area(), 0.01 * 1600);
  ASSERT_TRUE(result_with(size(20, 5)));
  EXPECT_NEAR(number / 1e4, whole_area(), 1e-6 * number);

  EXPECT_EQ(FF::ERROR_WRONG_PARAMETER, result_with(parameters::number_of_quads(0.5)).error_code);
  EXPECT_EQ(FF::ERROR_WRONG_PARAMETER, result_with(size(0, 1)).error_code);
  EXPECT_EQ(FF::ERROR_WRONG_PARAMETER, result_with(size(1, std::numeric_limits<double>::infinity())).error_code);
}

INSTANTIATE_TEST_SUITE_P(Generated, Stages, testing::ValuesIn(generated_models()), Model_name());
INSTANTIATE_TEST_SUITE_P(Generated, Mesh_cut_once, testing::ValuesIn(generated_models()), Model_name());

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
