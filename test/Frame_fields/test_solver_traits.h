#ifndef TEST_FRAME_FIELDS_TEST_SOLVER_TRAITS_H
#define TEST_FRAME_FIELDS_TEST_SOLVER_TRAITS_H

#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/Hermitian_matrix.h>

#include <CGAL/tags.h>

#include <Eigen/Cholesky>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <complex>
#include <limits>
#include <new>
#include <vector>

// Models of `FrameFieldSolverTraits`, most with nothing beyond what the concept asks for.
namespace test {

template <typename Scalar_>
class Dense_solver
{
public:
  typedef Scalar_ Scalar;

  bool factor(const CGAL::Frame_fields::Hermitian_matrix<Scalar>& matrix)
  {
    Matrix dense = Matrix::Zero(matrix.size(), matrix.size());
    for(int j = 0; j < matrix.size(); ++j)
      for(int k = matrix.column_begin[j]; k < matrix.column_begin[j + 1]; ++k)
        dense(matrix.row[k], j) = matrix.value[k];
    m_factorization.compute(dense.template selfadjointView<Eigen::Lower>());
    return m_factorization.info() == Eigen::Success;
  }

  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution)
  {
    const Vector x = m_factorization.solve(Eigen::Map<const Vector>(right_hand_side.data(), right_hand_side.size()));
    solution.assign(x.data(), x.data() + x.size());
    return true;
  }

private:
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;

  Eigen::LLT<Matrix> m_factorization;
};

struct Dense_solver_traits
{
  typedef Dense_solver<double> Real_solver;
  typedef Dense_solver<std::complex<double> > Complex_solver;
  typedef CGAL::Tag_true Has_independent_solvers;

  Real_solver real_solver_object() const { return Real_solver(); }
  Complex_solver complex_solver_object() const { return Complex_solver(); }
};

// Conjugate gradients that stop where the residual is `tolerance` times the right-hand side, as iterative solvers do.
template <typename Scalar_>
class Iterative_solver
{
public:
  typedef Scalar_ Scalar;

  explicit Iterative_solver(const double tolerance) : m_tolerance(tolerance) {}

  bool factor(const CGAL::Frame_fields::Hermitian_matrix<Scalar>& matrix)
  {
    m_matrix = Eigen::Map<const Matrix>(matrix.size(), matrix.size(), static_cast<int>(matrix.row.size()),
                                        matrix.column_begin.data(), matrix.row.data(), matrix.value.data());
    return true;
  }

  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution)
  {
    Eigen::ConjugateGradient<Matrix, Eigen::Lower> solver(m_matrix);
    solver.setTolerance(m_tolerance);
    solver.setMaxIterations(20000);
    const Vector x = solver.solve(Eigen::Map<const Vector>(right_hand_side.data(), right_hand_side.size()));
    solution.assign(x.data(), x.data() + x.size());
    return solver.info() == Eigen::Success;
  }

private:
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;

  double m_tolerance;
  Matrix m_matrix;
};

struct Iterative_solver_traits
{
  typedef Iterative_solver<double> Real_solver;
  typedef Iterative_solver<std::complex<double> > Complex_solver;
  typedef CGAL::Tag_true Has_independent_solvers;

  double tolerance = 1e-9;

  Real_solver real_solver_object() const { return Real_solver(tolerance); }
  Complex_solver complex_solver_object() const { return Complex_solver(tolerance); }
};

enum Solver_behavior { FAILS_TO_FACTOR, FAILS_TO_SOLVE, RETURNS_NAN, RUNS_OUT_OF_MEMORY };

template <typename Scalar_>
struct Failing_solver
{
  typedef Scalar_ Scalar;

  Solver_behavior behavior;

  bool factor(const CGAL::Frame_fields::Hermitian_matrix<Scalar>&)
  {
    if(behavior == RUNS_OUT_OF_MEMORY)
      throw std::bad_alloc();
    return behavior != FAILS_TO_FACTOR;
  }

  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution)
  {
    solution.assign(right_hand_side.size(), std::numeric_limits<double>::quiet_NaN());
    return behavior != FAILS_TO_SOLVE;
  }
};

struct Failing_solver_traits
{
  typedef Failing_solver<double> Real_solver;
  typedef Failing_solver<std::complex<double> > Complex_solver;
  typedef CGAL::Tag_true Has_independent_solvers;

  Solver_behavior behavior = FAILS_TO_FACTOR;

  Real_solver real_solver_object() const { return { behavior }; }
  Complex_solver complex_solver_object() const { return { behavior }; }
};

// A solver by Eigen that appends the size of each matrix that it factors to a list.
template <typename Scalar_>
struct Recording_solver : CGAL::Frame_fields::Eigen_positive_definite_solver<Scalar_>
{
  typedef CGAL::Frame_fields::Eigen_positive_definite_solver<Scalar_> Base;

  explicit Recording_solver(std::vector<int>& sizes) : sizes(&sizes) {}

  bool factor(const CGAL::Frame_fields::Hermitian_matrix<Scalar_>& matrix)
  {
    sizes->push_back(matrix.size());
    return Base::factor(matrix);
  }

  std::vector<int>* sizes;
};

struct Recording_solver_traits : CGAL::Frame_fields::Eigen_frame_field_solver_traits
{
  typedef Recording_solver<double> Real_solver;
  typedef Recording_solver<std::complex<double> > Complex_solver;

  explicit Recording_solver_traits(std::vector<int>& sizes) : sizes(&sizes) {}

  Real_solver real_solver_object() const { return Real_solver(*sizes); }
  Complex_solver complex_solver_object() const { return Complex_solver(*sizes); }

  std::vector<int>* sizes;
};

} // namespace test

#endif // TEST_FRAME_FIELDS_TEST_SOLVER_TRAITS_H
