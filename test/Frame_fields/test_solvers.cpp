#include "test_cad_mesh.h"
#include "test_solver_traits.h"

#include <CGAL/Frame_fields/Linear_algebra_frame_field_solver_traits.h>

#include <CGAL/Eigen_solver_traits.h>

namespace {

using namespace test;

constexpr double tolerance = 1e-8;

typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType> > Cgal_traits;

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

typedef testing::Types<Dense_solver_traits, Cgal_traits,
                       CGAL::Frame_fields::Linear_algebra_frame_field_solver_traits<Cgal_traits> > Solver_traits;
TYPED_TEST_SUITE(Solver, Solver_traits);

TYPED_TEST(Solver, gives_the_field_of_the_default_one)
{
  for(const Model& model : { quilt(), star({ 5, 21, 43, 10 }), wedge(33) })
    this->expect_default_field(model, tolerance);
}

// The smallest eigenvector is unique up to a factor, which the same start vector settles.
TYPED_TEST(Solver, gives_the_field_of_the_default_one_without_constraints)
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

} // namespace
