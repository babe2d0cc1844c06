#include <CGAL/Frame_fields.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Frame_fields = CGAL::Frame_fields;
namespace params = CGAL::Frame_fields::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef std::pair<std::size_t, std::size_t> Point_pair;

// A triangle soup with feature edges; the smaller index of each pair comes first.
struct Featured_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::set<Point_pair> features;
};

Featured_soup read_soup(const std::string& name)
{
  Featured_soup soup;
  if(!CGAL::IO::read_polygon_soup(name + ".off", soup.points, soup.triangles))
    throw std::runtime_error("cannot read " + name + ".off");
  std::ifstream features(name + ".feat");
  for(std::string line; std::getline(features, line);)
  {
    std::istringstream words(line);
    std::size_t first, second;
    if(words >> first >> second)
      soup.features.insert(std::minmax(first, second));
  }
  return soup;
}

// Splits each triangle into four at the midpoints of its edges.
Featured_soup refined(const Featured_soup& soup)
{
  Featured_soup result;
  result.points = soup.points;
  std::map<Point_pair, std::size_t> midpoints;
  const auto midpoint = [&](const std::size_t first, const std::size_t second)
  {
    const auto [place, is_new] = midpoints.insert({ std::minmax(first, second), result.points.size() });
    if(is_new)
      result.points.push_back(CGAL::midpoint(soup.points[first], soup.points[second]));
    return place->second;
  };
  for(const auto& [a, b, c] : soup.triangles)
  {
    const std::size_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    for(const std::array<std::size_t, 3>& triangle :
        { std::array{ a, ab, ca }, std::array{ ab, b, bc }, std::array{ ca, bc, c }, std::array{ ab, bc, ca } })
      result.triangles.push_back(triangle);
  }
  for(const auto& [first, second] : soup.features)
    for(const std::size_t end : { first, second })
      result.features.insert({ end, midpoint(first, second) });
  return result;
}

// The flange that ships with the examples, refined, and the maps of its field.
struct Model
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;
  Mesh::Property_map<Mesh::Face_index, double> alpha, rho;
  Mesh::Property_map<Mesh::Halfedge_index, int> matching, index;
  Mesh::Property_map<Mesh::Halfedge_index, double> omega;

  explicit Model(const int number_of_refinements)
  {
    Featured_soup soup = read_soup(FRAME_FIELDS_FLANGE);
    for(int k = 0; k < number_of_refinements; ++k)
      soup = refined(soup);
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
    is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
    for(const auto& [first, second] : soup.features)
      is_feature[mesh.edge(mesh.halfedge(Mesh::Vertex_index(Mesh::size_type(first)),
                                         Mesh::Vertex_index(Mesh::size_type(second))))] = true;
    Frame_fields::split_overconstrained_faces(mesh, params::edge_is_constrained_map(is_feature));
    alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
    rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
    matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
    index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
    omega = mesh.add_property_map<Mesh::Halfedge_index, double>("h:omega").first;
  }
};

Model& model(const int number_of_refinements)
{
  static std::map<int, Model> models;
  return models.try_emplace(number_of_refinements, number_of_refinements).first->second;
}

// Runs `compute(model)` and reports the faces a second.
template <typename Compute>
void measure(benchmark::State& state, const Compute& compute)
{
  Model& m = model(static_cast<int>(state.range(0)));
  for(auto _ : state)
  {
    const Frame_fields::Result result = compute(m);
    if(!result)
      state.SkipWithError(result.message.c_str());
  }
  state.counters["faces"] = static_cast<double>(num_faces(m.mesh));
  state.counters["faces_per_second"] =
    benchmark::Counter(static_cast<double>(num_faces(m.mesh)), benchmark::Counter::kIsIterationInvariantRate);
}

void whole_pipeline(benchmark::State& state)
{
  measure(state, [](Model& m)
  {
    return Frame_fields::cad_frame_field(m.mesh, m.alpha, m.rho, m.index,
                                         params::edge_is_constrained_map(m.is_feature));
  });
}

// What every method pays: no prescribed rotation, no relaxation.
void plain_orthogonal_field(benchmark::State& state)
{
  measure(state, [](Model& m)
  {
    return Frame_fields::cad_frame_field(m.mesh, m.alpha, m.rho, m.index,
                                         params::edge_is_constrained_map(m.is_feature).relax_orthogonality(false)
                                           .support_strategy(Frame_fields::Support_strategy::none()));
  });
}

void prescribe_rotation(benchmark::State& state)
{
  measure(state, [](Model& m)
  {
    return Frame_fields::prescribe_rotation(m.mesh, m.omega, params::edge_is_constrained_map(m.is_feature));
  });
}

void orthogonal_frame_field(benchmark::State& state)
{
  measure(state, [](Model& m)
  {
    return Frame_fields::orthogonal_frame_field(m.mesh, m.alpha, params::edge_is_constrained_map(m.is_feature)
                                                                   .prescribed_rotation_map(m.omega)
                                                                   .matching_map(m.matching));
  });
}

void singularity_indices(benchmark::State& state)
{
  measure(state, [](Model& m)
  {
    return Frame_fields::singularity_indices(m.mesh, m.alpha, m.matching, m.index,
                                             params::edge_is_constrained_map(m.is_feature));
  });
}

// `alpha` changes, so each run starts from the orthogonal field again, outside the measured time.
void relax_frame_field(benchmark::State& state)
{
  Model& m = model(static_cast<int>(state.range(0)));
  const auto np = params::edge_is_constrained_map(m.is_feature).matching_map(m.matching);
  for(auto _ : state)
  {
    state.PauseTiming();
    Frame_fields::orthogonal_frame_field(m.mesh, m.alpha, np.prescribed_rotation_map(m.omega));
    state.ResumeTiming();
    const Frame_fields::Result result = Frame_fields::relax_frame_field(m.mesh, m.alpha, m.rho, np);
    if(!result)
      state.SkipWithError(result.message.c_str());
  }
}

// Refinements: 16 K, 66 K and 260 K faces. The order matters: the stages take their input from the ones before.
#define FRAME_FIELDS_BENCHMARK(function) BENCHMARK(function)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)
FRAME_FIELDS_BENCHMARK(whole_pipeline);
FRAME_FIELDS_BENCHMARK(plain_orthogonal_field);
FRAME_FIELDS_BENCHMARK(prescribe_rotation);
FRAME_FIELDS_BENCHMARK(orthogonal_frame_field);
FRAME_FIELDS_BENCHMARK(singularity_indices);
FRAME_FIELDS_BENCHMARK(relax_frame_field);

BENCHMARK_MAIN();
