#ifndef BENCHMARK_FRAME_FIELDS_BENCHMARK_MODELS_H
#define BENCHMARK_FRAME_FIELDS_BENCHMARK_MODELS_H

// The CAD shapes of the benchmarks, in any size.

#include "planar_meshes.h"

#include <CGAL/Frame_fields/parameters.h>
#include <CGAL/Frame_fields/split_overconstrained_faces.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
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

typedef std::pair<std::size_t, std::size_t> Point_pair;
typedef std::vector<Kernel::Segment_2> Line_graph;

// A triangle soup with feature edges; the smaller index of each pair comes first.
struct Featured_soup
{
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::set<Point_pair> features;
};

inline Featured_soup read_soup(const std::string& name)
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
inline Featured_soup refined(const Featured_soup& soup)
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

// The Delaunay refinement of a straight line graph, whose segments become feature edges, to edges of length `size`.
inline Featured_soup planar_soup(const Line_graph& segments, const double size)
{
  Triangulation triangulation;
  for(const Kernel::Segment_2& segment : segments)
    triangulation.insert_constraint(segment.source(), segment.target());
  Delaunay_mesher(triangulation, CGAL::Delaunay_mesh_size_criteria_2<Triangulation>(0.125, size)).refine_mesh();

  Featured_soup soup;
  std::map<Triangulation::Vertex_handle, std::size_t> number;
  for(const auto v : triangulation.finite_vertex_handles())
  {
    number[v] = soup.points.size();
    soup.points.push_back(Point_3(v->point().x(), v->point().y(), 0));
  }
  for(const auto f : triangulation.finite_face_handles())
    if(f->is_in_domain())
      soup.triangles.push_back({ number[f->vertex(0)], number[f->vertex(1)], number[f->vertex(2)] });
  for(const auto& [f, k] : triangulation.constrained_edges())
    soup.features.insert(std::minmax(number[f->vertex(Triangulation::cw(k))],
                                     number[f->vertex(Triangulation::ccw(k))]));
  return soup;
}

// The point at a distance from the origin in a direction given in degrees.
inline Point_2 polar_point(const double distance, const double degrees)
{
  const double angle = degrees * CGAL_PI / 180;
  return Point_2(distance * std::cos(angle), distance * std::sin(angle));
}

// 6 x 6 rhombi cut along their long diagonals: 72 patches with corners of 30, 30 and 120 degrees.
inline Line_graph quilt()
{
  const int n = 6;
  const Kernel::Vector_2 u = polar_point(1, 0) - CGAL::ORIGIN, v = polar_point(1, 60) - CGAL::ORIGIN;
  const auto knot = [&](const int i, const int j) { return CGAL::ORIGIN + i * u + j * v; };
  Line_graph result;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
    {
      if(i < n)
        result.push_back({ knot(i, j), knot(i + 1, j) });
      if(j < n)
        result.push_back({ knot(i, j), knot(i, j + 1) });
      if(i < n && j < n)
        result.push_back({ knot(i, j), knot(i + 1, j + 1) });
    }
  return result;
}

// Five wedges of 30 degrees around a point.
inline Line_graph fan()
{
  Line_graph result;
  for(int k = 0; k <= 5; ++k)
  {
    result.push_back({ Point_2(0, 0), polar_point(1, 30 * k) });
    if(k > 0)
      result.push_back({ polar_point(1, 30 * (k - 1)), polar_point(1, 30 * k) });
  }
  return result;
}

// A single patch with eight tips of 30 degrees.
inline Line_graph star()
{
  const int number_of_tips = 8;
  const double half_step = 180. / number_of_tips;
  const Point_2 dent = polar_point(1, half_step);
  const double tip_distance = dent.x() + dent.y() / std::tan(15 * CGAL_PI / 180);
  const auto corner = [&](const int k) { return polar_point(k % 2 == 0 ? tip_distance : 1, half_step * k); };
  Line_graph result;
  for(int k = 0; k < 2 * number_of_tips; ++k)
    result.push_back({ corner(k), corner((k + 1) % (2 * number_of_tips)) });
  return result;
}

// Moves the points of a planar soup onto a wavy surface.
inline void lift(Featured_soup& soup)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
  const double wave_number = 3 * CGAL_PI / (box.xmax() - box.xmin()), height = 0.3 / wave_number;
  for(Point_3& p : soup.points)
    p = Point_3(p.x(), p.y(), height * std::sin(wave_number * p.x()) * std::cos(wave_number * p.y()));
}

struct Shape
{
  std::string name;
  std::vector<std::string> sizes; // the number of faces after 0, 1, ... refinements
  std::function<Featured_soup()> base;
  bool is_planar;
};

// The lengths in the planar ones give 8,000 faces.
inline std::vector<Shape> benchmark_shapes()
{
  const std::vector<std::string> sizes{ "8K", "33K", "131K", "524K", "2M" };
  return { { "quilt", sizes, [] { return planar_soup(quilt(), 0.138); }, true },
           { "fan", sizes, [] { return planar_soup(fan(), 0.028); }, true },
           { "star", sizes, [] { return planar_soup(star(), 0.067); }, true },
           { "flange", { "16K", "65K", "260K" }, [] { return read_soup(FRAME_FIELDS_FLANGE); }, false } };
}

inline Featured_soup refined_shape(const Shape& shape, const int number_of_refinements)
{
  Featured_soup soup = shape.base();
  for(int k = 0; k < number_of_refinements; ++k)
    soup = refined(soup);
  if(shape.is_planar)
    lift(soup);
  return soup;
}

// A mesh and the maps of its field.
struct Benchmark_model
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;
  Mesh::Property_map<Mesh::Face_index, double> alpha, rho;
  Mesh::Property_map<Mesh::Halfedge_index, int> index;

  explicit Benchmark_model(const Featured_soup& soup)
  {
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
    is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
    for(const auto& [first, second] : soup.features)
      is_feature[mesh.edge(mesh.halfedge(Mesh::Vertex_index(Mesh::size_type(first)),
                                         Mesh::Vertex_index(Mesh::size_type(second))))] = true;
    const CGAL::Frame_fields::Result result = CGAL::Frame_fields::split_overconstrained_faces(
      mesh, CGAL::Frame_fields::parameters::edge_is_constrained_map(is_feature));
    if(!result)
      throw std::runtime_error(result.message);
    alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
    rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
    index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
  }
};

#endif // BENCHMARK_FRAME_FIELDS_BENCHMARK_MODELS_H
