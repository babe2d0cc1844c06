// The same output, bit for bit, from run to run and for any number of threads.

#include "random_models.h"
#include "test_cad_mesh.h"

#include <CGAL/Frame_fields.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using namespace test;

typedef testing::Types<CGAL::Sequential_tag, CGAL::Parallel_if_available_tag> Concurrency_tags;

// Models of many patches, which finish in any order.
std::vector<Model> models()
{
  std::vector<Model> result = { quilt(), cube() };
  for(unsigned int seed = 1; seed <= 4; ++seed)
  {
    result.push_back(random_convex_polyhedron(seed));
    result.push_back(random_star_shaped_polyhedron(seed));
    result.push_back(random_gear(seed));
    result.push_back(random_torus(seed));
  }
  return result;
}

void expect_same_bits(const Field& field, const Field& expected)
{
  EXPECT_EQ(expected.alpha, field.alpha);
  EXPECT_EQ(expected.rho, field.rho);
  EXPECT_EQ(expected.omega, field.omega);
  EXPECT_EQ(expected.index, field.index);
  EXPECT_EQ(expected.matching, field.matching);
  EXPECT_EQ(expected.statistics.energy_orthogonal, field.statistics.energy_orthogonal);
  EXPECT_EQ(expected.statistics.energy_relaxed, field.statistics.energy_relaxed);
}

// The points of all corners in the seamless map and in the integer-grid map.
template <typename ConcurrencyTag>
std::array<std::vector<Kernel::Point_2>, 2> coordinates(const Cad_mesh<Surface_mesh>& cad_mesh)
{
  const Surface_mesh& mesh = cad_mesh.mesh;
  const Maps<Surface_mesh> maps(mesh);
  EXPECT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
                                  cad_mesh.features().matching_map(maps.matching)));
  std::vector<Kernel::Point_2> seamless(mesh.number_of_halfedges()), integer_grid(mesh.number_of_halfedges());
  const auto np = cad_mesh.features().concurrency_tag(ConcurrencyTag());
  EXPECT_TRUE(FF::seamless_parameterization(mesh, maps.alpha, maps.rho, maps.matching, maps.index,
                                            CGAL::make_property_map(seamless), np));
  EXPECT_TRUE(FF::integer_grid_parameterization(mesh, maps.alpha, maps.rho, maps.matching, maps.index,
                                                CGAL::make_property_map(integer_grid), np));
  return { { std::move(seamless), std::move(integer_grid) } };
}

template <typename ConcurrencyTag>
class Determinism : public testing::Test
{
protected:
  static Field field(const Cad_mesh<Surface_mesh>& cad_mesh)
  {
    return frame_field(cad_mesh, parameters::concurrency_tag(ConcurrencyTag()));
  }

  // The stages write the same bits as the one call does.
  static void expect_same_bits_by_stages(const Cad_mesh<Surface_mesh>& cad_mesh, const Field& expected)
  {
    const Surface_mesh& mesh = cad_mesh.mesh;
    const Maps<Surface_mesh> maps(mesh);
    const auto np = cad_mesh.features().concurrency_tag(ConcurrencyTag());
    ASSERT_TRUE(FF::prescribe_rotation(mesh, maps.omega, np));
    ASSERT_TRUE(FF::orthogonal_frame_field(mesh, maps.alpha,
                                           np.prescribed_rotation_map(maps.omega).matching_map(maps.matching)));
    ASSERT_TRUE(FF::relax_frame_field(mesh, maps.alpha, maps.rho, np.matching_map(maps.matching)));
    const Field field = to_field(cad_mesh, maps);
    EXPECT_EQ(expected.alpha, field.alpha);
    EXPECT_EQ(expected.rho, field.rho);
    EXPECT_EQ(expected.omega, field.omega);
    EXPECT_EQ(expected.matching, field.matching);
  }
};

TYPED_TEST_SUITE(Determinism, Concurrency_tags);

// Points, and the vertices of the faces, in the order of both.
template <typename ConcurrencyTag>
std::pair<std::vector<Point>, std::vector<std::size_t> > quads_of(const Cad_mesh<Surface_mesh>& cad_mesh)
{
  Surface_mesh quads;
  EXPECT_TRUE(FF::cad_quad_mesh(cad_mesh.mesh, quads, cad_mesh.features().concurrency_tag(ConcurrencyTag())));
  std::pair<std::vector<Point>, std::vector<std::size_t> > result;
  for(const auto v : vertices(quads))
    result.first.push_back(quads.point(v));
  for(const auto f : faces(quads))
    for(const auto v : vertices_around_face(halfedge(f, quads), quads))
      result.second.push_back(v);
  return result;
}

TYPED_TEST(Determinism, of_quads_for_1_2_and_8_threads)
{
  for(const Model& model : { quilt(), cube(), random_gear(1), random_torus(1) })
  {
    const Cad_mesh<Surface_mesh> cad_mesh(model, false);
    const auto expected = quads_of<CGAL::Sequential_tag>(cad_mesh);
    for(const int number_of_threads : { 1, 2, 8 })
    {
      SCOPED_TRACE(number_of_threads);
#ifdef CGAL_LINKED_WITH_TBB
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
#endif
      EXPECT_EQ(expected, quads_of<TypeParam>(cad_mesh));
    }
  }
}

TYPED_TEST(Determinism, from_run_to_run_and_for_1_2_and_8_threads)
{
  for(const Model& model : models())
  {
    const Cad_mesh<Surface_mesh> cad_mesh(model);
    const Field expected = frame_field(cad_mesh);
    const auto expected_coordinates = coordinates<CGAL::Sequential_tag>(cad_mesh);
    for(const int number_of_threads : { 1, 2, 8 })
    {
      SCOPED_TRACE(number_of_threads);
#ifdef CGAL_LINKED_WITH_TBB
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
#endif
      for(int run = 0; run < 5; ++run)
        expect_same_bits(this->field(cad_mesh), expected);
      this->expect_same_bits_by_stages(cad_mesh, expected);
      EXPECT_EQ(expected_coordinates, coordinates<TypeParam>(cad_mesh));
    }
  }
}

} // namespace
