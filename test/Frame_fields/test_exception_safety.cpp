// An allocation fails in each place at which it can: nothing leaks, and mesh and maps stay as they were.

#include "sentinels.h"
#include "test_cad_mesh.h"

#include <CGAL/Frame_fields.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <new>
#include <vector>

namespace {

// Counted while they are watched; the tests are single-threaded.
bool is_watching = false;
long number_of_live_allocations = 0;
long number_of_allocations_until_failure = -1; // -1: none fails
bool has_failed_optionally = false; // for a caller that goes on without the memory, such as std::stable_sort()

bool must_fail()
{
  return is_watching && number_of_allocations_until_failure >= 0 && number_of_allocations_until_failure-- == 0;
}

void* counted(void* const pointer)
{
  if(is_watching && pointer != nullptr)
    ++number_of_live_allocations;
  return pointer;
}

} // namespace

// The linker puts these in place of malloc() and free(), which Eigen calls; the operators below call them, too.
extern "C"
{
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* pointer, std::size_t size);
void __real_free(void* pointer);

void* __wrap_malloc(const std::size_t size) { return must_fail() ? nullptr : counted(__real_malloc(size)); }

void* __wrap_calloc(const std::size_t count, const std::size_t size)
{
  return must_fail() ? nullptr : counted(__real_calloc(count, size));
}

void* __wrap_realloc(void* const pointer, const std::size_t size)
{
  if(must_fail())
    return nullptr;
  return pointer == nullptr ? counted(__real_realloc(pointer, size)) : __real_realloc(pointer, size);
}

void __wrap_free(void* const pointer)
{
  if(is_watching && pointer != nullptr)
    --number_of_live_allocations;
  __real_free(pointer);
}
}

namespace {

void* allocate_or_throw(const std::size_t size)
{
  if(void* const pointer = std::malloc(size > 0 ? size : 1))
    return pointer;
  throw std::bad_alloc();
}

void* allocate_optionally(const std::size_t size)
{
  void* const pointer = std::malloc(size > 0 ? size : 1);
  has_failed_optionally |= pointer == nullptr;
  return pointer;
}

} // namespace

void* operator new(const std::size_t size) { return allocate_or_throw(size); }
void* operator new[](const std::size_t size) { return allocate_or_throw(size); }
void* operator new(const std::size_t size, const std::nothrow_t&) noexcept { return allocate_optionally(size); }
void* operator new[](const std::size_t size, const std::nothrow_t&) noexcept { return allocate_optionally(size); }
void operator delete(void* const pointer) noexcept { std::free(pointer); }
void operator delete[](void* const pointer) noexcept { std::free(pointer); }
void operator delete(void* const pointer, std::size_t) noexcept { std::free(pointer); }
void operator delete[](void* const pointer, std::size_t) noexcept { std::free(pointer); }
void operator delete(void* const pointer, const std::nothrow_t&) noexcept { std::free(pointer); }
void operator delete[](void* const pointer, const std::nothrow_t&) noexcept { std::free(pointer); }

namespace {

using namespace test;

typedef Surface_mesh::Halfedge_index Halfedge;

// A mesh, and maps that hold a sentinel everywhere, in memory that is there before any call.
class Exception_safety : public testing::Test
{
protected:
  Cad_mesh<Surface_mesh> cad_mesh{ model() };
  Surface_mesh& mesh = cad_mesh.mesh;
  Maps<Surface_mesh> maps{ mesh }, field{ mesh };
  std::vector<Halfedge> corners;

  // Several patches, sharp corners, one patch without constraint and an unmeshable corner to repair.
  static Model model()
  {
    const Model flat = planar({ { 0, 0 }, { 3, 0.1 }, { 3, 3 }, { 0, 3 } }, 1.5,
                              { { { 0, 0 }, { 3, 3 } }, { { 0, 0 }, { 3, 1 } } });
    return side_by_side(flat, torus_of_few_faces());
  }

  static Model torus_of_few_faces()
  {
    return grid(4, 3, true, true, [](const double u, const double v)
    {
      const double radius = 3 + std::cos(360 * degree * v);
      return Point(radius * std::cos(360 * degree * u), radius * std::sin(360 * degree * u),
                   std::sin(360 * degree * v));
    });
  }

  void SetUp() override
  {
    ASSERT_TRUE(FF::prescribe_rotation(mesh, field.omega, cad_mesh.features()));
    ASSERT_TRUE(FF::orthogonal_frame_field(mesh, field.alpha, cad_mesh.features().prescribed_rotation_map(field.omega)
                                                                         .matching_map(field.matching)));
    ASSERT_TRUE(FF::singularity_indices(mesh, field.alpha, field.matching, field.index, cad_mesh.features()));
    corners.reserve(mesh.number_of_halfedges());
    put_sentinels();
  }

  void put_sentinels()
  {
    test::put_sentinels(mesh, maps);
    corners.clear();
  }

  bool are_maps_untouched() const { return hold_sentinels(mesh, maps) && corners.empty(); }

  // Calls `run()` with the n-th allocation failing, for n = 0, 1, ... until it succeeds. `is_unchanged()` must hold
  // after each failure, and nothing may be allocated that was not before.
  template <typename Run, typename IsUnchanged>
  static void expect_safe(const char* const function, const Run& run, const IsUnchanged& is_unchanged)
  {
    SCOPED_TRACE(function);
    long number_of_failures = 0, number_of_exceptions = 0;
    for(bool has_succeeded = false; !has_succeeded && !HasFailure(); number_of_failures += !has_succeeded)
    {
      bool has_thrown = false;
      has_failed_optionally = false;
      FF::Error_code code = FF::OK;
      number_of_live_allocations = 0;
      number_of_allocations_until_failure = number_of_failures;
      is_watching = true;
      try
      {
        code = run();
      }
      catch(const std::bad_alloc&)
      {
        has_thrown = true;
      }
      is_watching = false;
      const bool has_injected = number_of_allocations_until_failure < 0;
      number_of_allocations_until_failure = -1;
      has_succeeded = !has_injected;
      EXPECT_EQ(0, number_of_live_allocations) << "allocation " << number_of_failures;
      EXPECT_EQ(FF::OK, code) << "allocation " << number_of_failures;
      EXPECT_EQ(has_injected && !has_failed_optionally, has_thrown) << "allocation " << number_of_failures;
      EXPECT_TRUE(!has_thrown || is_unchanged()) << "allocation " << number_of_failures;
      number_of_exceptions += has_thrown;
    }
    std::cout << function << ": " << number_of_failures << " failures injected, " << number_of_exceptions
              << " exceptions" << std::endl;
    EXPECT_GT(number_of_failures, 0);
  }

  template <typename Run>
  void expect_maps_safe(const char* const function, const Run& run)
  {
    expect_safe(function, run, [this] { return are_maps_untouched(); });
    put_sentinels();
  }
};

TEST_F(Exception_safety, of_the_field_in_one_call)
{
  FF::Statistics statistics;
  expect_maps_safe("cad_frame_field", [&]
  {
    return FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
      cad_mesh.features().matching_map(maps.matching).prescribed_rotation_map(maps.omega)
        .sharp_corner_output_iterator(std::back_inserter(corners)).statistics(std::ref(statistics))).error_code;
  });
  for(const FF::Support_strategy& strategy : { FF::Support_strategy::none(), FF::Support_strategy::local(),
                                               FF::Support_strategy::component(), FF::Support_strategy::radius() })
    expect_maps_safe("cad_frame_field with geometric weights", [&]
    {
      return FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
        cad_mesh.features().support_strategy(strategy)
                                           .edge_weighting(FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH)).error_code;
    });
}

TEST_F(Exception_safety, of_each_stage)
{
  const auto features = cad_mesh.features();
  expect_maps_safe("prescribe_rotation", [&]
  {
    return FF::prescribe_rotation(mesh, maps.omega, features).error_code;
  });
  expect_maps_safe("orthogonal_frame_field", [&]
  {
    return FF::orthogonal_frame_field(mesh, maps.alpha, features.prescribed_rotation_map(field.omega)
                                                                .matching_map(maps.matching)).error_code;
  });
  expect_maps_safe("singularity_indices", [&]
  {
    return FF::singularity_indices(mesh, field.alpha, field.matching, maps.index, features).error_code;
  });
  expect_safe("relax_frame_field", [&]
  {
    return FF::relax_frame_field(mesh, field.alpha, maps.rho, features.matching_map(field.matching)).error_code;
  }, [this] { return are_maps_untouched(); });
}

TEST_F(Exception_safety, of_the_functions_that_look_at_a_field)
{
  const auto features = cad_mesh.features();
  expect_maps_safe("sharp_corners", [&]
  {
    return FF::sharp_corners(mesh, std::back_inserter(corners), features).error_code;
  });
  std::vector<FF::Singularity<Halfedge> > singularities;
  singularities.reserve(mesh.number_of_halfedges());
  expect_safe("singularities", [&]
  {
    return FF::singularities(mesh, field.index, std::back_inserter(singularities), features).error_code;
  }, [&] { return singularities.empty(); });
  EXPECT_FALSE(singularities.empty());
  for(const auto f : faces(mesh))
    put(maps.rho, f, 0);
  FF::Field_quality quality;
  quality.energy = sentinel;
  expect_safe("frame_field_quality", [&]
  {
    return FF::frame_field_quality(mesh, field.alpha, maps.rho, field.matching,
                                   features.quality(std::ref(quality))).error_code;
  }, [&] { return quality.energy == sentinel; });
}

TEST_F(Exception_safety, of_the_streamlines)
{
  for(const auto f : faces(mesh))
    put(maps.rho, f, 0);
  std::vector<FF::Streamline<Point, Surface_mesh::Face_index> > lines;
  lines.reserve(1000);
  std::size_t number_of_lines = 0;
  expect_safe("trace_streamlines", [&]
  {
    const FF::Error_code code =
      FF::trace_streamlines(mesh, field.alpha, maps.rho, field.matching, std::back_inserter(lines),
                            cad_mesh.features().streamline_spacing(1)).error_code;
    number_of_lines = lines.size();
    lines.clear(); // what they hold is the caller's
    return code;
  }, [&] { return lines.empty(); });
  EXPECT_GT(number_of_lines, 1u);
}

TEST_F(Exception_safety, of_the_maps)
{
  for(const auto f : faces(mesh))
    put(maps.rho, f, 0);
  const Kernel::Point_2 untouched(sentinel, sentinel);
  std::vector<Kernel::Point_2> uv(mesh.number_of_halfedges(), untouched);
  std::vector<FF::Uncertified_patch<Surface_mesh::Face_index> > uncertified;
  uncertified.reserve(num_faces(mesh));
  // `map(uv_map, np)` calls the function.
  const auto expect_safe_map = [&](const char* const function, const auto& map)
  {
    expect_safe(function, [&]
    {
      std::fill(uv.begin(), uv.end(), untouched); // std::stable_sort() goes on without its memory
      uncertified.clear();
      return map(CGAL::make_property_map(uv), cad_mesh.features().uncertified_patch_output_iterator(
                                                std::back_inserter(uncertified))).error_code;
    }, [&]
    {
      return uncertified.empty()
          && std::count(uv.begin(), uv.end(), untouched) == std::ptrdiff_t(mesh.number_of_halfedges());
    });
    EXPECT_LT(uncertified.size(), 4u) << "some patches have a map";
  };
  expect_safe_map("seamless_parameterization", [&](const auto uv_map, const auto& np)
                  { return FF::seamless_parameterization(mesh, field.alpha, maps.rho, field.matching, field.index,
                                                         uv_map, np); });
  expect_safe_map("integer_grid_parameterization", [&](const auto uv_map, const auto& np)
                  { return FF::integer_grid_parameterization(mesh, field.alpha, maps.rho, field.matching, field.index,
                                                             uv_map, np); });
}

TEST_F(Exception_safety, of_a_field_from_vectors)
{
  std::vector<Vector> u, v;
  for(const auto f : faces(mesh))
  {
    const auto vectors = FF::frame_vectors(mesh, f, get(field.alpha, f), 0);
    u.push_back(vectors[0]);
    v.push_back(vectors[1]);
  }
  double misalignment = sentinel;
  const auto vector_of = [](const std::vector<Vector>& vectors)
  {
    return boost::make_function_property_map<Surface_mesh::Face_index, Vector>(
      [&vectors](const Surface_mesh::Face_index f) { return vectors[f]; });
  };
  expect_safe("frame_field_from_vectors", [&]
  {
    return FF::frame_field_from_vectors(mesh, vector_of(u), vector_of(v), maps.alpha, maps.rho, maps.matching,
                                        cad_mesh.features().maximum_misalignment(std::ref(misalignment))).error_code;
  }, [&] { return are_maps_untouched() && misalignment == sentinel; });
}

TEST_F(Exception_safety, of_the_detection_of_feature_edges)
{
  std::vector<signed char> is_feature(num_edges(mesh), sentinel);
  const auto is_feature_map = boost::make_iterator_property_map(is_feature.begin(), get(boost::edge_index, mesh));
  expect_safe("detect_feature_edges", [&]
  {
    return FF::detect_feature_edges(mesh, is_feature_map,
                                    parameters::strong_angle_in_degrees(30).weak_angle_in_degrees(10)
                                               .close_gaps(true).minimum_chain_length(0.5)).error_code;
  }, [&] { return std::count(is_feature.begin(), is_feature.end(), sentinel) == std::ptrdiff_t(num_edges(mesh)); });
  std::vector<Surface_mesh::Vertex_index> ends;
  ends.reserve(num_vertices(mesh));
  expect_safe("dangling_feature_ends", [&]
  {
    FF::dangling_feature_ends(mesh, cad_mesh.is_feature, std::back_inserter(ends));
    return FF::OK;
  }, [&] { return ends.empty(); });
}

TEST_F(Exception_safety, of_the_functions_that_refine_a_mesh)
{
  const auto expect_mesh_safe = [](const char* const function, const auto& refine)
  {
    Cad_mesh<Surface_mesh> coarse(side_by_side(cube(), wedge(20)), false);
    const Model before = coarse.model();
    const std::size_t number_of_vertices = num_vertices(coarse.mesh);
    expect_safe(function, [&] { return refine(coarse).error_code; }, [&]
    {
      const Model after = coarse.model();
      return CGAL::is_valid_polygon_mesh(coarse.mesh) && after.points == before.points
          && after.triangles == before.triangles && after.features == before.features;
    });
    EXPECT_GT(num_vertices(coarse.mesh), number_of_vertices);
  };
  expect_mesh_safe("split_overconstrained_faces", [](auto& coarse)
  {
    return FF::split_overconstrained_faces(coarse.mesh, coarse.features());
  });
  expect_mesh_safe("split_chords", [](auto& coarse) { return FF::split_chords(coarse.mesh, coarse.features()); });
}

TEST_F(Exception_safety, of_the_quads)
{
  Cad_mesh<Surface_mesh> coarse(wedge_with_fan(150, 2), false);
  Surface_mesh quads; // has room for the quads of all calls that succeed, so that it holds no more memory afterwards
  quads.reserve(100000, 200000, 100000);
  CGAL::make_quad(Point(9, 0, 0), Point(9, 1, 0), Point(8, 1, 0), Point(8, 0, 0), quads);
  bool is_untouched = true;
  expect_safe("cad_quad_mesh", [&]
  {
    const std::size_t vertices_before = num_vertices(quads), faces_before = num_faces(quads);
    FF::Quad_statistics statistics;
    statistics.number_of_quads = 77;
    try
    {
      return FF::cad_quad_mesh(coarse.mesh, quads, coarse.features().statistics(std::ref(statistics))).error_code;
    }
    catch(...)
    {
      is_untouched = num_vertices(quads) == vertices_before && num_faces(quads) == faces_before
                  && CGAL::is_valid_polygon_mesh(quads) && statistics.number_of_quads == 77;
      throw;
    }
  }, [&] { return is_untouched; });
  EXPECT_GT(num_faces(quads), 1u);
}

// The message is built of allocations, too.
TEST_F(Exception_safety, of_a_failure_that_is_reported)
{
  expect_maps_safe("failing cad_frame_field", [&]
  {
    const FF::Result result = FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
                                                  cad_mesh.features().maximum_skewness(-1));
    return result.error_code == FF::ERROR_WRONG_PARAMETER && !result.message.empty() ? FF::OK : FF::ERROR_WRONG_FIELD;
  });
}

} // namespace
