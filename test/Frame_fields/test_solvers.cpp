#include "test_cad_mesh.h"
#include "test_solver_traits.h"

#include <CGAL/Frame_fields/Automatic_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/Linear_algebra_frame_field_solver_traits.h>
#ifdef CGAL_AMGCL_ENABLED
#include <CGAL/Frame_fields/Amgcl_frame_field_solver_traits.h>
#endif
#ifdef CGAL_CHOLMOD_ENABLED
#include <CGAL/Frame_fields/Cholmod_frame_field_solver_traits.h>
#endif

#include <CGAL/Eigen_solver_traits.h>

#include <numeric>
#include <vector>

namespace {

using namespace test;

constexpr double tolerance = 1e-8;

typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType> > Cgal_traits;

// A traits class that splits the patches of small models between two solvers.
struct Automatic_traits : FF::Automatic_frame_field_solver_traits<Dense_solver_traits>
{
  Automatic_traits() : FF::Automatic_frame_field_solver_traits<Dense_solver_traits>(100) {}
};

template <typename SolverTraits>
class Solver : public testing::Test
{
protected:
  static void expect_default_field(const Model& model, const double field_tolerance)
  {
    on_each_mesh_class(model, [=](const auto& cad_mesh)
    {
      const Field expected = frame_field(cad_mesh);
      const Field field = frame_field(cad_mesh, parameters::sparse_linear_solver(SolverTraits()));
      EXPECT_LT(largest_branch_distance(expected.branches, field.branches), field_tolerance);
      EXPECT_LT(largest_branch_distance(field.branches, expected.branches), field_tolerance);
      EXPECT_LT(largest_difference(field.omega, expected.omega), tolerance);
      EXPECT_EQ(expected.index, field.index);
    });
  }
};

template <typename SolverTraits>
class Direct_solver : public Solver<SolverTraits> {};

typedef testing::Types<Dense_solver_traits, Cgal_traits,
                       CGAL::Frame_fields::Linear_algebra_frame_field_solver_traits<Cgal_traits>
#ifdef CGAL_CHOLMOD_ENABLED
                       , FF::Cholmod_frame_field_solver_traits
#endif
                       , Automatic_traits> Direct_solver_traits;
typedef testing::Types<Dense_solver_traits, Cgal_traits,
                       CGAL::Frame_fields::Linear_algebra_frame_field_solver_traits<Cgal_traits>
#ifdef CGAL_CHOLMOD_ENABLED
                       , FF::Cholmod_frame_field_solver_traits
#endif
#ifdef CGAL_AMGCL_ENABLED
                       , FF::Amgcl_frame_field_solver_traits
#endif
                       , Iterative_solver_traits, Automatic_traits> Solver_traits;
TYPED_TEST_SUITE(Solver, Solver_traits);
TYPED_TEST_SUITE(Direct_solver, Direct_solver_traits);

TYPED_TEST(Solver, gives_the_field_of_the_default_one)
{
  for(const Model& model : { quilt(), star({ 5, 21, 43, 10 }), wedge(33) })
    this->expect_default_field(model, tolerance);
}

// The smallest eigenvector is unique up to a factor, which the same start vector settles.
TYPED_TEST(Direct_solver, gives_the_field_of_the_default_one_without_constraints)
{
  this->expect_default_field(sphere(), tolerance);
}

TYPED_TEST(Solver, may_be_asked_for_parallel_solution)
{
  const Cad_mesh<Surface_mesh> cad_mesh(quilt());
  const auto np = parameters::sparse_linear_solver(TypeParam());
  EXPECT_EQ(frame_field(cad_mesh, np).alpha,
            frame_field(cad_mesh, np.concurrency_tag(CGAL::Parallel_if_available_tag())).alpha);
}

std::vector<int> sorted(std::vector<int> values)
{
  std::sort(values.begin(), values.end());
  return values;
}

TEST(Automatic_solver, gives_systems_from_the_threshold_on_to_the_large_solver)
{
  typedef FF::Automatic_frame_field_solver_traits<Recording_solver_traits, Recording_solver_traits> Traits;
  const Cad_mesh<Surface_mesh> cad_mesh(quilt());
  std::vector<int> sizes;
  frame_field(cad_mesh, parameters::sparse_linear_solver(Recording_solver_traits(sizes)));
  sizes = sorted(sizes);

  for(const std::size_t k : { std::size_t(0), sizes.size() / 2, sizes.size() - 1 })
  {
    const auto first_large = std::lower_bound(sizes.begin(), sizes.end(), sizes[k]);
    std::vector<int> small_sizes, large_sizes;
    frame_field(cad_mesh, parameters::sparse_linear_solver(Traits(
      sizes[k], Recording_solver_traits(large_sizes), Recording_solver_traits(small_sizes))));
    EXPECT_EQ(std::vector<int>(sizes.begin(), first_large), sorted(small_sizes));
    EXPECT_EQ(std::vector<int>(first_large, sizes.end()), sorted(large_sizes));
  }
}

struct Reversing_solver_traits : FF::Eigen_frame_field_solver_traits
{
  std::vector<int> elimination_order(const FF::Hermitian_matrix<float>& pattern) const
  {
    std::vector<int> order(pattern.size());
    std::iota(order.rbegin(), order.rend(), 0);
    return order;
  }
};

TEST(Automatic_solver, takes_the_order_of_the_solver_for_the_size)
{
  const FF::Hermitian_matrix<float> path{ { 0, 2, 4, 5 }, { 0, 1, 1, 2, 2 }, { 1, 1, 1, 1, 1 } };
  const std::vector<int> natural{ 0, 1, 2 }, reversed{ 2, 1, 0 };
  typedef FF::Automatic_frame_field_solver_traits<Dense_solver_traits, Reversing_solver_traits> Small_reverses;
  EXPECT_EQ(reversed, Small_reverses(4).elimination_order(path));
  EXPECT_EQ(natural, Small_reverses(3).elimination_order(path));
  typedef FF::Automatic_frame_field_solver_traits<Reversing_solver_traits> Large_reverses;
  EXPECT_EQ(reversed, Large_reverses(3).elimination_order(path));
}

// On a long rough tube |z| falls by tens of powers of ten. Where it is less than what an iterative solver leaves of a
// residual, its first solution is noise.
class Iterative_solver_on_tube : public testing::Test
{
protected:
  template <typename SolverTraits>
  static void expect_default_field(const SolverTraits& solver_traits)
  {
    const Cad_mesh<Surface_mesh> cad_mesh(rough_tube(400));
    const Field expected = frame_field(cad_mesh);
    const Field field = frame_field(cad_mesh, parameters::sparse_linear_solver(solver_traits));
    EXPECT_LT(largest_branch_distance(expected.branches, field.branches), 1e-6);
    EXPECT_EQ(expected.index, field.index);
  }
};

TEST_F(Iterative_solver_on_tube, gives_the_field_of_the_default_one)
{
  expect_default_field(Iterative_solver_traits());
}

#ifdef CGAL_AMGCL_ENABLED
TEST_F(Iterative_solver_on_tube, gives_the_field_of_the_default_one_by_multigrid)
{
  expect_default_field(FF::Amgcl_frame_field_solver_traits());
}
#endif

// A solver that is off by a factor in one place at every call, although it says that it has succeeded.
template <typename Scalar>
struct Wrong_solver : FF::Eigen_positive_definite_solver<Scalar>
{
  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution) const
  {
    const bool is_solved = FF::Eigen_positive_definite_solver<Scalar>::solve(right_hand_side, solution);
    solution[solution.size() / 2] *= 3;
    return is_solved;
  }
};

struct Wrong_solver_traits : FF::Eigen_frame_field_solver_traits
{
  typedef Wrong_solver<std::complex<double> > Complex_solver;
  Complex_solver complex_solver_object() const { return Complex_solver(); }
};

TEST(Wrong_solver, is_an_error_and_no_field)
{
  const Cad_mesh<Surface_mesh> cad_mesh(quilt());
  const Maps<Surface_mesh> maps(cad_mesh.mesh);
  const auto np = cad_mesh.features().sparse_linear_solver(Wrong_solver_traits());
  EXPECT_EQ(FF::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,
            FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index, np).error_code);
}

#ifdef CGAL_CHOLMOD_ENABLED
TEST(Cholmod_solver, refuses_a_matrix_that_is_not_positive_definite)
{
  FF::Cholmod_positive_definite_solver<double> solver;
  EXPECT_FALSE(solver.factor({ { 0, 2, 3 }, { 0, 1, 1 }, { 1, 2, 1 } }));
}
#endif

#ifdef CGAL_AMGCL_ENABLED
// Rounding errors keep the residual from being 0.
TEST(Amgcl_solver, refuses_when_the_tolerance_is_not_reached)
{
  const Cad_mesh<Surface_mesh> cad_mesh(wedge(33));
  const Maps<Surface_mesh> maps(cad_mesh.mesh);
  const auto np = cad_mesh.features().sparse_linear_solver(FF::Amgcl_frame_field_solver_traits(0, 1));
  EXPECT_EQ(FF::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,
            FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index, np).error_code);
}
#endif

// The topology of a field is its singularity indices; the matching may differ by the choice of branch 0 in each face.
class Topology : public On_models {};

TEST_P(Topology, is_the_same_for_all_solvers)
{
  const Cad_mesh<Surface_mesh> cad_mesh(GetParam().make());
  const Cut cut = cad_mesh.cut();
  const std::vector<int> expected = frame_field(cad_mesh).index;
  const auto expect_same = [&](const auto& solver_traits)
  {
    const Field field = frame_field(cad_mesh, parameters::sparse_linear_solver(solver_traits));
    expect_valid_field(cut, field);
    EXPECT_EQ(expected, field.index);
  };
#ifdef CGAL_CHOLMOD_ENABLED
  {
    SCOPED_TRACE("CHOLMOD");
    expect_same(FF::Cholmod_frame_field_solver_traits());
  }
  {
    SCOPED_TRACE("automatic");
    expect_same(FF::Automatic_frame_field_solver_traits<FF::Cholmod_frame_field_solver_traits>(1000));
  }
#endif
#ifdef CGAL_AMGCL_ENABLED
  {
    SCOPED_TRACE("AMGCL");
    expect_same(FF::Amgcl_frame_field_solver_traits());
  }
#endif
  static_cast<void>(expect_same);
}

INSTANTIATE_TEST_SUITE_P(Generated, Topology, testing::ValuesIn(generated_models()), Model_name());
INSTANTIATE_TEST_SUITE_P(CGAL, Topology, testing::ValuesIn(cgal_models()), Model_name());
INSTANTIATE_TEST_SUITE_P(CAD, Topology, testing::ValuesIn(cad_models()), Model_name());

} // namespace
