#ifndef BENCHMARK_FRAME_FIELDS_BENCHMARK_SOLVER_TRAITS_H
#define BENCHMARK_FRAME_FIELDS_BENCHMARK_SOLVER_TRAITS_H

// The solver traits that the benchmarks compare, and two that measure what is not theirs.

#include <CGAL/Frame_fields/Automatic_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/Hermitian_matrix.h>
#ifdef CGAL_AMGCL_ENABLED
#include <CGAL/Frame_fields/Amgcl_frame_field_solver_traits.h>
#endif
#ifdef CGAL_CHOLMOD_ENABLED
#include <CGAL/Frame_fields/Cholmod_frame_field_solver_traits.h>
#endif

#include <CGAL/tags.h>

#include <atomic>
#include <complex>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <time.h>

inline std::int64_t nanoseconds_of(const clockid_t clock)
{
  timespec time;
  clock_gettime(clock, &time);
  return 1000000000 * static_cast<std::int64_t>(time.tv_sec) + time.tv_nsec;
}

// Adds the processor time of its thread between construction and destruction to `sum`.
class Thread_timer
{
public:
  explicit Thread_timer(std::atomic<std::int64_t>& sum)
    : m_sum(sum), m_start(nanoseconds_of(CLOCK_THREAD_CPUTIME_ID))
  {}
  ~Thread_timer() { m_sum += nanoseconds_of(CLOCK_THREAD_CPUTIME_ID) - m_start; }
  Thread_timer(const Thread_timer&) = delete;
  Thread_timer& operator=(const Thread_timer&) = delete;

private:
  std::atomic<std::int64_t>& m_sum;
  std::int64_t m_start;
};

template <typename Solver>
class Timed_solver
{
public:
  typedef typename Solver::Scalar Scalar;

  Timed_solver(Solver&& solver, std::atomic<std::int64_t>& nanoseconds)
    : m_solver(std::move(solver)), m_nanoseconds(nanoseconds)
  {}

  bool factor(const CGAL::Frame_fields::Hermitian_matrix<Scalar>& matrix)
  {
    const Thread_timer timer(m_nanoseconds);
    return m_solver.factor(matrix);
  }

  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution)
  {
    const Thread_timer timer(m_nanoseconds);
    return m_solver.solve(right_hand_side, solution);
  }

private:
  Solver m_solver;
  std::atomic<std::int64_t>& m_nanoseconds;
};

// The solvers of `SolverTraits`, which add the time of their work to a sum, in all threads. The elimination order is
// part of their work.
template <typename SolverTraits>
class Timed_solver_traits
{
public:
  typedef Timed_solver<typename SolverTraits::Real_solver> Real_solver;
  typedef Timed_solver<typename SolverTraits::Complex_solver> Complex_solver;
  typedef typename SolverTraits::Has_independent_solvers Has_independent_solvers;

  explicit Timed_solver_traits(std::atomic<std::int64_t>& nanoseconds) : m_nanoseconds(&nanoseconds) {}

  Real_solver real_solver_object() const { return { m_solver_traits.real_solver_object(), *m_nanoseconds }; }
  Complex_solver complex_solver_object() const { return { m_solver_traits.complex_solver_object(), *m_nanoseconds }; }

  // There for solver traits that have it only.
  template <typename Pattern, typename Traits = SolverTraits>
  auto elimination_order(const Pattern& pattern) const
    -> decltype(std::declval<const Traits&>().elimination_order(pattern))
  {
    const Thread_timer timer(*m_nanoseconds);
    return m_solver_traits.elimination_order(pattern);
  }

private:
  SolverTraits m_solver_traits;
  std::atomic<std::int64_t>* m_nanoseconds;
};

// Solves nothing, in no time and no memory.
template <typename Scalar_>
struct Idle_solver
{
  typedef Scalar_ Scalar;

  bool factor(const CGAL::Frame_fields::Hermitian_matrix<Scalar>&) { return true; }

  bool solve(const std::vector<Scalar>& right_hand_side, std::vector<Scalar>& solution)
  {
    solution.assign(right_hand_side.size(), Scalar(1));
    return true;
  }
};

struct Idle_solver_traits
{
  typedef Idle_solver<double> Real_solver;
  typedef Idle_solver<std::complex<double> > Complex_solver;
  typedef CGAL::Tag_true Has_independent_solvers;

  Real_solver real_solver_object() const { return {}; }
  Complex_solver complex_solver_object() const { return {}; }
};

// Calls `visit(name, solver_traits)` for each solver traits of the package whose library was found.
template <typename Visit>
void for_each_solver_traits(const Visit& visit)
{
  using namespace CGAL::Frame_fields;
  visit("Eigen", Eigen_frame_field_solver_traits());
#ifdef CGAL_CHOLMOD_ENABLED
  visit("Cholmod", Cholmod_frame_field_solver_traits());
  visit("Automatic_Cholmod", Automatic_frame_field_solver_traits<Cholmod_frame_field_solver_traits>());
#endif
#ifdef CGAL_AMGCL_ENABLED
  visit("Amgcl", Amgcl_frame_field_solver_traits());
  visit("Automatic_Amgcl", Automatic_frame_field_solver_traits<Amgcl_frame_field_solver_traits>());
#endif
}

#endif // BENCHMARK_FRAME_FIELDS_BENCHMARK_SOLVER_TRAITS_H
