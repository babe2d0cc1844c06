#include "sentinels.h"
#include "test_cad_mesh.h"
#include "test_solver_traits.h"

#include <CGAL/Frame_fields.h>

#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <new>
#include <regex>
#include <set>
#include <stdexcept>

namespace {

using namespace test;
using CGAL::Frame_fields::Support_strategy;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A mesh, and maps that hold a sentinel everywhere.
template <typename Mesh_>
struct Case
{
  typedef Mesh_ Mesh;

  Mesh mesh;
  Maps<Mesh> maps;
  std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor> corners;

  explicit Case(const Model& model, const bool splits = true) : Case(Cad_mesh<Mesh>(model, splits).mesh) {}
  explicit Case(const Mesh& mesh_) : mesh(mesh_), maps(mesh) { put_sentinels(mesh, maps); }

  Case(const Case&) = delete;

  void expect_untouched() const
  {
    EXPECT_TRUE(hold_sentinels(mesh, maps));
    EXPECT_TRUE(corners.empty());
  }

  template <typename NamedParameters>
  FF::Result cad_frame_field(const NamedParameters& np)
  {
    return FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
                               parameters::join(np, parameters::matching_map(maps.matching)
                                 .prescribed_rotation_map(maps.omega)
                                 .sharp_corner_output_iterator(std::back_inserter(corners))));
  }

  FF::Result sharp_corners() { return FF::sharp_corners(mesh, std::back_inserter(corners)); }

  // All functions but `sharp_corners()`, which accepts more.
  std::vector<FF::Result> results_of_all_functions()
  {
    const auto with_matching = parameters::matching_map(maps.matching);
    return { FF::prescribe_rotation(mesh, maps.omega), FF::orthogonal_frame_field(mesh, maps.alpha, with_matching),
             FF::relax_frame_field(mesh, maps.alpha, maps.rho, with_matching),
             FF::singularity_indices(mesh, maps.alpha, maps.matching, maps.index),
             cad_frame_field(parameters::relax_orthogonality(true)) };
  }
};

void expect_failure(const FF::Error_code expected, const FF::Result& result)
{
  EXPECT_EQ(expected, result.error_code) << result.message;
  EXPECT_FALSE(result);
  EXPECT_EQ(0u, result.message.find(FF::get_error_message(expected))) << result.message;
}

// The number in "face 12 of faces(tm)".
std::size_t face_named_in(const std::string& message)
{
  std::smatch match;
  EXPECT_TRUE(std::regex_search(message, match, std::regex("face ([0-9]+) of faces\\(tm\\)"))) << message;
  return match.empty() ? 0 : std::stoul(match[1]);
}

std::set<std::size_t> faces_at(const Model& model, const std::size_t point)
{
  std::set<std::size_t> result;
  for(std::size_t f = 0; f < model.triangles.size(); ++f)
    if(std::count(model.triangles[f].begin(), model.triangles[f].end(), point) > 0)
      result.insert(f);
  return result;
}

template <typename Mesh>
class Errors : public testing::Test
{
protected:
  // Expects all functions to name one of the faces.
  static void expect_failure_at(const FF::Error_code expected, Case<Mesh>&& wrong, const std::set<std::size_t>& at)
  {
    std::vector<FF::Result> results = wrong.results_of_all_functions();
    if(expected != FF::ERROR_OVERCONSTRAINED_FACE)
      results.push_back(wrong.sharp_corners());
    for(const FF::Result& result : results)
    {
      expect_failure(expected, result);
      EXPECT_EQ(1u, at.count(face_named_in(result.message))) << result.message;
    }
    wrong.expect_untouched();
  }
};

TYPED_TEST_SUITE(Errors, Mesh_classes, Mesh_class_names);

TYPED_TEST(Errors, empty_mesh)
{
  Case<TypeParam> empty{ TypeParam() };
  for(const FF::Result& result : empty.results_of_all_functions())
    expect_failure(FF::ERROR_EMPTY_MESH, result);
  expect_failure(FF::ERROR_EMPTY_MESH, empty.sharp_corners());
  empty.expect_untouched();
}

TYPED_TEST(Errors, face_that_is_no_triangle)
{
  TypeParam mesh;
  CGAL::make_tetrahedron(Point(9, 0, 0), Point(8, 1, 0), Point(8, 0, 1), Point(8, 0, 0), mesh);
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), mesh);
  this->expect_failure_at(FF::ERROR_NON_TRIANGULAR_MESH, Case<TypeParam>(mesh), { 4 });
}

TYPED_TEST(Errors, coordinate_that_is_not_finite)
{
  for(const double wrong : { nan, infinity, -infinity })
    for(const int axis : { 0, 1, 2 })
    {
      Model model = Cad_mesh<Surface_mesh>(square(3)).model();
      double coordinates[3] = { 0, 0, 0 };
      coordinates[axis] = wrong;
      model.points[5] = Point(coordinates[0], coordinates[1], coordinates[2]);
      this->expect_failure_at(FF::ERROR_NON_FINITE_COORDINATE, Case<TypeParam>(model, false), faces_at(model, 5));
    }
}

TYPED_TEST(Errors, edge_of_length_zero)
{
  Model model = Cad_mesh<Surface_mesh>(square(3)).model();
  const auto [p, q, r] = model.triangles[8];
  model.points[p] = model.points[q];
  this->expect_failure_at(FF::ERROR_ZERO_LENGTH_EDGE, Case<TypeParam>(model, false), faces_at(model, p));
}

TYPED_TEST(Errors, face_with_several_constrained_edges)
{
  const Model model = single_triangle();
  this->expect_failure_at(FF::ERROR_OVERCONSTRAINED_FACE, Case<TypeParam>(model, false), { 0 });

  const Cad_mesh<TypeParam> all_features(tetrahedron(), false);
  const Maps<TypeParam> maps(all_features.mesh);
  const FF::Result result =
    FF::cad_frame_field(all_features.mesh, maps.alpha, maps.rho, maps.index, all_features.features());
  expect_failure(FF::ERROR_OVERCONSTRAINED_FACE, result);
  EXPECT_NE(std::string::npos, result.message.find("split_overconstrained_faces()")) << result.message;
}

TYPED_TEST(Errors, parameter_out_of_range)
{
  Case<TypeParam> good(wedge(30));
  const auto expect_wrong = [&](const std::string& name, const FF::Result& result)
  {
    expect_failure(FF::ERROR_WRONG_PARAMETER, result);
    EXPECT_NE(std::string::npos, result.message.find(name)) << result.message;
    good.expect_untouched();
  };
  for(const double bound : { -0.1, nan, infinity })
  {
    const auto np = parameters::sharp_corner_bound(bound);
    expect_wrong("sharp_corner_bound", good.cad_frame_field(np));
    expect_wrong("sharp_corner_bound", FF::prescribe_rotation(good.mesh, good.maps.omega, np));
    expect_wrong("sharp_corner_bound", FF::sharp_corners(good.mesh, std::back_inserter(good.corners), np));
  }
  for(const double skewness : { -0.1, CGAL_PI / 2, nan })
  {
    const auto np = parameters::maximum_skewness(skewness);
    expect_wrong("maximum_skewness", good.cad_frame_field(np));
    expect_wrong("maximum_skewness", FF::relax_frame_field(good.mesh, good.maps.alpha, good.maps.rho, np));
  }
  for(const double weight : { -0.1, nan, infinity })
  {
    const auto np = parameters::orthogonality_weight(weight);
    expect_wrong("orthogonality_weight", good.cad_frame_field(np));
    expect_wrong("orthogonality_weight", FF::relax_frame_field(good.mesh, good.maps.alpha, good.maps.rho, np));
  }
  for(const double length : { 0., -1., nan, infinity })
  {
    const auto np = parameters::orthogonality_length(length);
    expect_wrong("orthogonality_length", good.cad_frame_field(np));
    expect_wrong("orthogonality_length", FF::relax_frame_field(good.mesh, good.maps.alpha, good.maps.rho, np));
  }
  for(const double radius : { 0., -1., nan })
  {
    const auto np = parameters::support_strategy(Support_strategy::radius(radius));
    expect_wrong("support_strategy", good.cad_frame_field(np));
    expect_wrong("support_strategy", FF::prescribe_rotation(good.mesh, good.maps.omega, np));
  }
}

// Every vertex of a strip is on the border, so above 180 degrees all of them are sharp corners.
TYPED_TEST(Errors, sharp_corner_without_receiver)
{
  Case<TypeParam> strip(annulus(12, 1));
  for(const Support_strategy& strategy : { Support_strategy::rings(4), Support_strategy::component() })
  {
    const auto np = parameters::sharp_corner_bound(2 * CGAL_PI).support_strategy(strategy);
    for(const FF::Result& result :
        { strip.cad_frame_field(np), FF::prescribe_rotation(strip.mesh, strip.maps.omega, np) })
    {
      expect_failure(FF::ERROR_NO_RECEIVING_SECTOR, result);
      EXPECT_NE(std::string::npos, result.message.find("vertex at (")) << result.message;
    }
  }
  strip.expect_untouched();
}

TYPED_TEST(Errors, solver_that_fails)
{
  for(const Model& model : { wedge(30), sphere(), quilt() })
  {
    Case<TypeParam> good(model);
    for(const Solver_behavior behavior : { FAILS_TO_FACTOR, FAILS_TO_SOLVE, RETURNS_NAN })
      expect_failure(FF::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,
                     good.cad_frame_field(parameters::sparse_linear_solver(Failing_solver_traits{ behavior })));
    good.expect_untouched();
  }
}

TYPED_TEST(Errors, solver_that_fails_in_a_single_stage)
{
  const auto failing = parameters::sparse_linear_solver(Failing_solver_traits{ FAILS_TO_FACTOR });
  Case<TypeParam> good(wedge(30));
  expect_failure(FF::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, FF::prescribe_rotation(good.mesh, good.maps.omega, failing));
  expect_failure(FF::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,
                 FF::orthogonal_frame_field(good.mesh, good.maps.alpha, failing.matching_map(good.maps.matching)));
  good.expect_untouched();
  ASSERT_TRUE(FF::orthogonal_frame_field(good.mesh, good.maps.alpha));
  expect_failure(FF::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,
                 FF::relax_frame_field(good.mesh, good.maps.alpha, good.maps.rho, failing));
  EXPECT_EQ(sentinel, get(good.maps.rho, *faces(good.mesh).begin()));
}

TYPED_TEST(Errors, exhausted_memory_passes_through)
{
  Case<TypeParam> good(wedge(30));
  const auto np = parameters::sparse_linear_solver(Failing_solver_traits{ RUNS_OUT_OF_MEMORY });
  EXPECT_THROW(static_cast<void>(good.cad_frame_field(np)), std::bad_alloc);
  good.expect_untouched();
}

// A valid field on a mesh, of which the tests spoil one value.
template <typename Mesh>
class Wrong_field : public testing::Test
{
protected:
  Cad_mesh<Mesh> cad_mesh{ quilt() };
  Maps<Mesh> maps{ cad_mesh.mesh };

  void SetUp() override
  {
    ASSERT_TRUE(FF::prescribe_rotation(cad_mesh.mesh, maps.omega, cad_mesh.features()));
    ASSERT_TRUE(FF::orthogonal_frame_field(
      cad_mesh.mesh, maps.alpha, cad_mesh.features().prescribed_rotation_map(maps.omega).matching_map(maps.matching)));
    for(const auto f : faces(cad_mesh.mesh))
      put(maps.rho, f, sentinel);
    for(const auto h : halfedges(cad_mesh.mesh))
      put(maps.index, h, sentinel);
  }

  FF::Result relax()
  {
    return FF::relax_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, cad_mesh.features().matching_map(maps.matching));
  }
  FF::Result indices()
  {
    return FF::singularity_indices(cad_mesh.mesh, maps.alpha, maps.matching, maps.index, cad_mesh.features());
  }

  bool is_constrained(const typename boost::graph_traits<Mesh>::halfedge_descriptor h) const
  {
    return is_border_edge(h, cad_mesh.mesh) || get(cad_mesh.is_feature, edge(h, cad_mesh.mesh));
  }

  template <typename Predicate>
  auto first_halfedge(const Predicate& predicate) const
  {
    const auto range = halfedges(cad_mesh.mesh);
    return *std::find_if(range.begin(), range.end(), [&](const auto h)
    {
      return !is_border(h, cad_mesh.mesh) && predicate(h);
    });
  }

  // Expects both functions that read a field to refuse it and to name the face.
  void expect_refused(const typename boost::graph_traits<Mesh>::face_descriptor f)
  {
    for(const FF::Result& result : { relax(), indices() })
    {
      expect_failure(FF::ERROR_WRONG_FIELD, result);
      const auto range = faces(cad_mesh.mesh);
      EXPECT_EQ(f, *std::next(range.begin(), face_named_in(result.message))) << result.message;
    }
    expect_untouched();
  }

  void expect_untouched() const
  {
    for(const auto f : faces(cad_mesh.mesh))
      EXPECT_EQ(sentinel, get(maps.rho, f));
    for(const auto h : halfedges(cad_mesh.mesh))
      EXPECT_EQ(sentinel, get(maps.index, h));
  }
};

TYPED_TEST_SUITE(Wrong_field, Mesh_classes, Mesh_class_names);

TYPED_TEST(Wrong_field, with_an_angle_that_is_not_finite_or_has_no_digits_after_the_point)
{
  for(const double wrong : { nan, infinity, 1e19, -1e300, 1000001. })
  {
    const auto f = *std::next(faces(this->cad_mesh.mesh).begin(), 13);
    put(this->maps.alpha, f, wrong);
    this->expect_refused(f);
  }
}

TYPED_TEST(Wrong_field, with_a_frame_that_is_not_aligned)
{
  const auto h = this->first_halfedge([&](const auto h) { return this->is_constrained(h); });
  const auto f = face(h, this->cad_mesh.mesh);
  put(this->maps.alpha, f, get(this->maps.alpha, f) + 0.1);
  this->expect_refused(f);
}

TYPED_TEST(Wrong_field, with_a_matching_that_is_not_opposite)
{
  const auto h = this->first_halfedge([&](const auto h) { return !this->is_constrained(h); });
  put(this->maps.matching, h, get(this->maps.matching, h) + 1);
  for(const FF::Result& result : { this->relax(), this->indices() })
    expect_failure(FF::ERROR_WRONG_FIELD, result);
  this->expect_untouched();
}

// A matching changes the indices at the two ends of its edge by as much as it changes itself.
TYPED_TEST(Wrong_field, with_an_index_beyond_a_thousand_million)
{
  const auto& mesh = this->cad_mesh.mesh;
  const auto h = this->first_halfedge([&](const auto h) { return !this->is_constrained(h); });
  const auto add_turns = [&](const int turns)
  {
    put(this->maps.matching, h, get(this->maps.matching, h) + turns);
    put(this->maps.matching, opposite(h, mesh), get(this->maps.matching, opposite(h, mesh)) - turns);
  };
  add_turns(1500000000);
  expect_failure(FF::ERROR_WRONG_FIELD, this->indices());
  this->expect_untouched();

  add_turns(-1500000000);
  ASSERT_TRUE(this->indices());
  const int at_target = get(this->maps.index, h), at_source = get(this->maps.index, opposite(h, mesh));
  add_turns(100000000);
  ASSERT_TRUE(this->indices());
  EXPECT_EQ(at_target + 100000000, get(this->maps.index, h));
  EXPECT_EQ(at_source - 100000000, get(this->maps.index, opposite(h, mesh)));
}

TYPED_TEST(Wrong_field, with_a_prescribed_rotation_that_is_not_opposite_or_not_finite)
{
  const auto h = this->first_halfedge([&](const auto h) { return !this->is_constrained(h); });
  for(const double wrong : { 0.1, nan, 1e19 })
  {
    put(this->maps.omega, h, wrong);
    if(wrong == 1e19)
      put(this->maps.omega, opposite(h, this->cad_mesh.mesh), -wrong);
    Maps<TypeParam> output(this->cad_mesh.mesh);
    expect_failure(FF::ERROR_WRONG_FIELD,
                   FF::orthogonal_frame_field(this->cad_mesh.mesh, output.alpha,
                                              this->cad_mesh.features().prescribed_rotation_map(this->maps.omega)));
    EXPECT_EQ(0, get(output.alpha, face(h, this->cad_mesh.mesh)));
  }
}

TYPED_TEST(Wrong_field, with_a_skewness_that_is_not_finite)
{
  put(this->maps.rho, *faces(this->cad_mesh.mesh).begin(), nan);
  expect_failure(FF::ERROR_WRONG_FIELD,
                 FF::singularity_indices(this->cad_mesh.mesh, this->maps.alpha, this->maps.matching, this->maps.index,
                                         this->cad_mesh.features().skewness_map(this->maps.rho)));
}

TYPED_TEST(Errors, quadrangle_cannot_be_split)
{
  TypeParam mesh;
  CGAL::make_triangle(Point(9, 0, 0), Point(8, 1, 0), Point(8, 0, 1), mesh);
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), mesh);
  for(const FF::Result& result : { FF::split_overconstrained_faces(mesh), FF::split_chords(mesh) })
  {
    expect_failure(FF::ERROR_NON_TRIANGULAR_MESH, result);
    EXPECT_NE(std::string::npos, result.message.find("face 1 of faces(tm)")) << result.message;
  }
  EXPECT_EQ(2u, num_faces(mesh));
}

// A halfedge says that it is in another face, where a third one is taken for it.
TEST(Inconsistent_halfedges, are_named)
{
  CGAL::Surface_mesh<Point> mesh;
  const auto a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0)),
             c = mesh.add_vertex(Point(0, 1, 0)), d = mesh.add_vertex(Point(1, 1, 0));
  const auto f = mesh.add_face(a, b, c), g = mesh.add_face(c, b, d);
  mesh.set_halfedge(f, mesh.halfedge(b, c));
  mesh.set_face(mesh.halfedge(c, b), f); // in the cycle of g
  const Maps<CGAL::Surface_mesh<Point> > maps(mesh);
  const FF::Result result = FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index);
  expect_failure(FF::ERROR_INCONSISTENT_HALFEDGES, result);
  EXPECT_NE(std::string::npos, result.message.find("of faces(tm)")) << result.message << f << g;
}

TEST(Error_message, exists_for_each_error_code)
{
  std::set<std::string> messages;
  for(int code = FF::OK; code <= FF::ERROR_NON_QUADRANGULAR_MESH; ++code)
    messages.insert(FF::get_error_message(code));
  EXPECT_EQ(static_cast<std::size_t>(FF::ERROR_NON_QUADRANGULAR_MESH) + 1, messages.size());
  EXPECT_EQ(0u, messages.count(FF::get_error_message(-1)));
  EXPECT_STREQ(FF::get_error_message(-1), FF::get_error_message(1000));
}

TEST(Error_message, is_empty_on_success)
{
  const FF::Result result;
  EXPECT_TRUE(result);
  EXPECT_EQ("", result.message);
}

} // namespace
