// The time of the whole method, of the plain orthogonal field and of each stage, on shapes of 8 thousand to 2 million
// faces, for each solver traits and number of threads.

#include "benchmark_models.h"
#include "benchmark_solver_traits.h"

#include <CGAL/Frame_fields.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <benchmark/benchmark.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <oneapi/tbb/global_control.h>
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace Frame_fields = CGAL::Frame_fields;
namespace params = CGAL::Frame_fields::parameters;

// From these sizes on one run is long enough, and one repetition all that there is time for.
const int refinements_for_one_iteration = 2, refinements_for_one_repetition = 3;

// A model with what the stages take from the ones before.
struct Staged_model : Benchmark_model
{
  Mesh::Property_map<Mesh::Face_index, double> orthogonal_alpha, relaxed_alpha, skewness, zero;
  Mesh::Property_map<Mesh::Halfedge_index, int> matching, orthogonal_index;
  Mesh::Property_map<Mesh::Halfedge_index, double> omega;
  Mesh::Property_map<Mesh::Halfedge_index, Point_2> uv;
  bool has_orthogonal_field = false, has_relaxed_field = false;

  explicit Staged_model(const Featured_soup& soup) : Benchmark_model(soup)
  {
    orthogonal_alpha = mesh.add_property_map<Mesh::Face_index, double>("f:orthogonal_alpha").first;
    relaxed_alpha = mesh.add_property_map<Mesh::Face_index, double>("f:relaxed_alpha").first;
    skewness = mesh.add_property_map<Mesh::Face_index, double>("f:skewness").first;
    uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
    zero = mesh.add_property_map<Mesh::Face_index, double>("f:zero", 0.).first;
    matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
    orthogonal_index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:orthogonal_index").first;
    omega = mesh.add_property_map<Mesh::Halfedge_index, double>("h:omega").first;
  }

  void provide_orthogonal_field()
  {
    if(!has_orthogonal_field)
      has_orthogonal_field = bool(Frame_fields::cad_frame_field(
        mesh, orthogonal_alpha, rho, orthogonal_index,
        params::edge_is_constrained_map(is_feature).relax_orthogonality(false).matching_map(matching)
          .prescribed_rotation_map(omega)));
  }

  void provide_relaxed_field()
  {
    if(has_relaxed_field)
      return;
    for(const Mesh::Face_index f : mesh.faces())
      relaxed_alpha[f] = orthogonal_alpha[f];
    has_relaxed_field = bool(Frame_fields::relax_frame_field(
      mesh, relaxed_alpha, skewness, params::edge_is_constrained_map(is_feature).matching_map(matching)));
  }
};

// Large models do not fit beside each other, so only the last one is kept.
Staged_model& model(const Shape& shape, const int number_of_refinements)
{
  static std::unique_ptr<Staged_model> last;
  static std::string name_of_last;
  const std::string name = shape.name + shape.sizes[number_of_refinements];
  if(name != name_of_last)
  {
    last.reset();
    last = std::make_unique<Staged_model>(refined_shape(shape, number_of_refinements));
    name_of_last = name;
  }
  return *last;
}

struct Whole_pipeline
{
  static constexpr const char* name = "whole_pipeline";
  static constexpr bool is_stage = false;

  template <typename NamedParameters>
  Frame_fields::Result operator()(Staged_model& m, const NamedParameters& np) const
  {
    return Frame_fields::cad_frame_field(m.mesh, m.alpha, m.rho, m.index, np);
  }
};

// What every method pays: no prescribed rotation, no relaxation.
struct Plain_orthogonal_field
{
  static constexpr const char* name = "plain_orthogonal_field";
  static constexpr bool is_stage = false;

  template <typename NamedParameters>
  Frame_fields::Result operator()(Staged_model& m, const NamedParameters& np) const
  {
    return Frame_fields::cad_frame_field(
      m.mesh, m.alpha, m.rho, m.index,
      np.relax_orthogonality(false).support_strategy(Frame_fields::Support_strategy::none()));
  }
};

struct Prescribe_rotation
{
  static constexpr const char* name = "prescribe_rotation";
  static constexpr bool is_stage = true;

  template <typename NamedParameters>
  Frame_fields::Result operator()(Staged_model& m, const NamedParameters& np) const
  {
    return Frame_fields::prescribe_rotation(m.mesh, m.omega, np);
  }
};

struct Orthogonal_frame_field
{
  static constexpr const char* name = "orthogonal_frame_field";
  static constexpr bool is_stage = true;

  template <typename NamedParameters>
  Frame_fields::Result operator()(Staged_model& m, const NamedParameters& np) const
  {
    return Frame_fields::orthogonal_frame_field(m.mesh, m.alpha,
                                                np.prescribed_rotation_map(m.omega).matching_map(m.matching));
  }
};

struct Singularity_indices
{
  static constexpr const char* name = "singularity_indices";
  static constexpr bool is_stage = true;

  template <typename NamedParameters>
  Frame_fields::Result operator()(Staged_model& m, const NamedParameters& np) const
  {
    return Frame_fields::singularity_indices(m.mesh, m.orthogonal_alpha, m.matching, m.index, np);
  }
};

struct Relax_frame_field
{
  static constexpr const char* name = "relax_frame_field";
  static constexpr bool is_stage = true;

  template <typename NamedParameters>
  Frame_fields::Result operator()(Staged_model& m, const NamedParameters& np) const
  {
    for(const Mesh::Face_index f : m.mesh.faces()) // it overwrites what it is given
      m.alpha[f] = m.orthogonal_alpha[f];
    return Frame_fields::relax_frame_field(m.mesh, m.alpha, m.rho, np.matching_map(m.matching));
  }
};

struct Seamless_parameterization
{
  static constexpr const char* name = "seamless_parameterization";
  static constexpr bool is_stage = true;

  template <typename NamedParameters>
  Frame_fields::Result operator()(Staged_model& m, const NamedParameters& np) const
  {
    return Frame_fields::seamless_parameterization(m.mesh, m.relaxed_alpha, m.skewness, m.matching,
                                                   m.orthogonal_index, m.uv, np);
  }
};

// Beside the pipeline: places of singularities, and streamlines at the default spacing.
struct Singularities
{
  static constexpr const char* name = "singularities";
  static constexpr bool is_stage = true;

  template <typename NamedParameters>
  Frame_fields::Result operator()(Staged_model& m, const NamedParameters& np) const
  {
    std::vector<Frame_fields::Singularity<Mesh::Halfedge_index> > found;
    return Frame_fields::singularities(m.mesh, m.orthogonal_index, std::back_inserter(found), np);
  }
};

struct Trace_streamlines
{
  static constexpr const char* name = "trace_streamlines";
  static constexpr bool is_stage = true;

  template <typename NamedParameters>
  Frame_fields::Result operator()(Staged_model& m, const NamedParameters& np) const
  {
    std::vector<Frame_fields::Streamline<Mesh::Point, Mesh::Face_index> > lines;
    return Frame_fields::trace_streamlines(m.mesh, m.orthogonal_alpha, m.zero, m.matching, std::back_inserter(lines),
                                           np);
  }
};

// Reports the faces a second, and the part of the processor time that is not the solvers'.
template <typename ConcurrencyTag, typename SolverTraits, typename Compute>
void measure(benchmark::State& state, Staged_model& m, const Compute& compute)
{
  std::atomic<std::int64_t> in_solvers(0);
  const auto np = params::edge_is_constrained_map(m.is_feature)
                    .sparse_linear_solver(Timed_solver_traits<SolverTraits>(in_solvers))
                    .concurrency_tag(ConcurrencyTag());
  const std::int64_t start = nanoseconds_of(CLOCK_PROCESS_CPUTIME_ID);
  for(auto _ : state)
  {
    const Frame_fields::Result result = compute(m, np);
    if(!result)
    {
      state.SkipWithError(result.message.c_str());
      break;
    }
  }
  const std::int64_t total = nanoseconds_of(CLOCK_PROCESS_CPUTIME_ID) - start;
  const double faces = static_cast<double>(num_faces(m.mesh));
  state.counters["faces"] = faces;
  state.counters["faces_per_second"] = benchmark::Counter(faces, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["share_outside_solvers"] = 1 - static_cast<double>(in_solvers) / static_cast<double>(total);
}

template <typename SolverTraits, typename Compute>
void run(benchmark::State& state, const Shape& shape, const int number_of_refinements, const int number_of_threads,
         const Compute& compute)
{
  Staged_model& m = model(shape, number_of_refinements);
  if(Compute::is_stage)
    m.provide_orthogonal_field();
  if(std::is_same<Compute, Seamless_parameterization>::value)
    m.provide_relaxed_field();
#ifdef CGAL_LINKED_WITH_TBB
  if(number_of_threads > 1)
  {
    namespace tbb = oneapi::tbb;
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(number_of_threads));
    return measure<CGAL::Parallel_tag, SolverTraits>(state, m, compute);
  }
#endif
  (void)number_of_threads;
  measure<CGAL::Sequential_tag, SolverTraits>(state, m, compute);
}

// A name is function/shape/faces/solver/threads.
template <typename SolverTraits, typename Compute>
void add_benchmark(const Shape& shape, const int number_of_refinements, const std::string& solver,
                   const int number_of_threads, const Compute& compute)
{
  const std::string name = std::string(Compute::name) + "/" + shape.name + "/" + shape.sizes[number_of_refinements]
                         + "/" + solver + "/threads:" + std::to_string(number_of_threads);
  benchmark::internal::Benchmark* const result =
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state)
    {
      run<SolverTraits>(state, shape, number_of_refinements, number_of_threads, compute);
    });
  result->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
  if(number_of_refinements >= refinements_for_one_iteration)
    result->Iterations(1);
  if(number_of_refinements >= refinements_for_one_repetition)
    result->Repetitions(1);
}

// A disk of 4000 teeth around one vertex: each tooth is a sharp corner beside a hub.
Featured_soup toothed_disk()
{
  const std::size_t number_of_rim_points = 8000;
  Featured_soup soup;
  for(std::size_t k = 0; k < number_of_rim_points; ++k)
  {
    const double radius = k % 2 == 0 ? 1.002 : 1, angle = 2 * CGAL_PI * static_cast<double>(k) / number_of_rim_points;
    soup.points.push_back(Point_3(radius * std::cos(angle), radius * std::sin(angle), 0));
    soup.triangles.push_back({ { number_of_rim_points, k, (k + 1) % number_of_rim_points } });
  }
  soup.points.push_back(Point_3(0, 0, 0));
  return soup;
}

// A torus without features, so rough that it has a singularity for every ten faces.
Featured_soup rough_torus()
{
  const std::size_t n = 64;
  std::mt19937 generator;
  Featured_soup soup;
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double u = 2 * CGAL_PI * static_cast<double>(i) / n, v = 2 * CGAL_PI * static_cast<double>(j) / n;
      const double radius = 1 + 9. / n * (generator() / 2147483648. - 1);
      soup.points.push_back(Point_3((3 + radius * std::cos(v)) * std::cos(u), (3 + radius * std::cos(v)) * std::sin(u),
                                    radius * std::sin(v)));
      const std::size_t here = j * n + i, right = j * n + (i + 1) % n, up = (j + 1) % n * n + i;
      soup.triangles.push_back({ { here, right, up } });
      soup.triangles.push_back({ { right, (j + 1) % n * n + (i + 1) % n, up } });
    }
  return soup;
}

// What took time in the square of its size once.
std::vector<Shape> hard_shapes()
{
  return { { "toothed_disk", { "8K" }, toothed_disk, false }, { "rough_torus", { "8K" }, rough_torus, false } };
}

void add_benchmarks(const Shape& shape, const int number_of_refinements)
{
#ifdef CGAL_LINKED_WITH_TBB
  const int maximum_number_of_threads = 2;
#else
  const int maximum_number_of_threads = 1;
#endif
  for_each_solver_traits([&](const std::string& solver, const auto& solver_traits)
  {
    typedef typename std::decay<decltype(solver_traits)>::type Solver_traits;
    for(int threads = 1; threads <= maximum_number_of_threads; ++threads)
    {
      const auto add = [&](const auto& compute)
      {
        add_benchmark<Solver_traits>(shape, number_of_refinements, solver, threads, compute);
      };
      add(Whole_pipeline());
      add(Plain_orthogonal_field());
      add(Prescribe_rotation());
      add(Orthogonal_frame_field());
      add(Singularity_indices());
      add(Relax_frame_field());
      add(Seamless_parameterization());
      add(Singularities());
      add(Trace_streamlines());
    }
  });
}

} // namespace

int main(int argc, char** argv)
{
  for(const Shape& shape : benchmark_shapes())
    for(std::size_t k = 0; k < shape.sizes.size(); ++k)
      add_benchmarks(shape, static_cast<int>(k));
  for(const Shape& shape : hard_shapes())
    add_benchmarks(shape, 0);
  benchmark::Initialize(&argc, argv);
  if(benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
