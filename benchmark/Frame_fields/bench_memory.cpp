// Prints the peak of the memory of one field above that of the mesh and its maps, in bytes a face:
//     bench_frame_fields_memory SHAPE REFINEMENTS SOLVER
// The solver "none" solves nothing, which leaves the memory of all else. For Linux, which can reset the peak.

#include "benchmark_models.h"
#include "benchmark_solver_traits.h"

#include <CGAL/Frame_fields.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <malloc.h>

namespace {

namespace Frame_fields = CGAL::Frame_fields;
namespace params = CGAL::Frame_fields::parameters;

// The value of a key of the process's status, such as VmRSS or VmHWM, its peak.
double kibibytes(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for(std::string line; std::getline(status, line);)
    if(line.compare(0, key.size() + 1, key + ":") == 0)
      return std::stod(line.substr(key.size() + 1));
  throw std::runtime_error("/proc/self/status has no " + key);
}

// Building the mesh took more memory than it has; neither that memory nor that peak must count.
double forget_peak()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
  return kibibytes("VmRSS");
}

Shape shape_named(const std::string& name)
{
  for(const Shape& shape : benchmark_shapes())
    if(shape.name == name)
      return shape;
  throw std::runtime_error("there is no shape " + name);
}

template <typename NamedParameters>
void print_memory(Benchmark_model& m, const NamedParameters& np)
{
  const double before = forget_peak();
  const Frame_fields::Result result = Frame_fields::cad_frame_field(m.mesh, m.alpha, m.rho, m.index, np);
  if(!result)
    throw std::runtime_error(result.message);
  const double used = 1024 * (kibibytes("VmHWM") - before);
  std::cout << static_cast<std::size_t>(num_faces(m.mesh)) << " faces, " << used / num_faces(m.mesh)
            << " bytes a face, " << kibibytes("VmHWM") / (1 << 20) << " GiB in all" << std::endl;
}

void run(const std::string& shape, const int number_of_refinements, const std::string& solver)
{
  Benchmark_model m(refined_shape(shape_named(shape), number_of_refinements));
  const auto np = params::edge_is_constrained_map(m.is_feature);
  bool is_known = solver == "none";
  if(is_known)
    print_memory(m, np.repair_matching(false).sparse_linear_solver(Idle_solver_traits()));
  for_each_solver_traits([&](const std::string& name, const auto& solver_traits)
  {
    if(name != solver)
      return;
    is_known = true;
    print_memory(m, np.sparse_linear_solver(solver_traits));
  });
  if(!is_known)
    throw std::runtime_error("there is no solver " + solver);
}

} // namespace

int main(int argc, char** argv)
{
  if(argc != 4)
  {
    std::cerr << "usage: " << argv[0] << " SHAPE REFINEMENTS SOLVER" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    run(argv[1], std::stoi(argv[2]), argv[3]);
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
