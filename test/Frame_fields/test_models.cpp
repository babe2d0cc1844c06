#include "test_models.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <ostream>
#include <random>
#include <sstream>
#include <stdexcept>

namespace test {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Exact_predicates;
typedef CGAL::Triangulation_vertex_base_2<Exact_predicates> Vertex_base;
typedef CGAL::Delaunay_mesh_face_base_2<Exact_predicates> Face_base;
typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base> Triangulation_structure;
typedef CGAL::Constrained_Delaunay_triangulation_2<Exact_predicates, Triangulation_structure> Triangulation;
typedef CGAL::Delaunay_mesh_size_criteria_2<Triangulation> Size_criteria;
typedef CGAL::Surface_mesh<Point> Mesh;

constexpr double turn = 360 * degree;

void insert(const Polyline& polyline, const bool is_closed, Triangulation& triangulation)
{
  std::vector<Exact_predicates::Point_2> points;
  for(const auto& [x, y] : polyline)
    points.emplace_back(x, y);
  triangulation.insert_constraint(points.begin(), points.end(), is_closed);
}

Exact_predicates::Point_2 inside(const Polyline& hole)
{
  double x = 0, y = 0;
  for(const auto& point : hole)
  {
    x += point.first / static_cast<double>(hole.size());
    y += point.second / static_cast<double>(hole.size());
  }
  return { x, y };
}

Polyline circle(const int n, const double radius)
{
  Polyline result;
  for(int k = 0; k < n; ++k)
    result.emplace_back(radius * std::cos(k * turn / n), radius * std::sin(k * turn / n));
  return result;
}

Mesh to_mesh(const Model& model)
{
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(model.points, model.triangles, mesh);
  return mesh;
}

} // namespace

std::pair<Point, Point> segment(const Point& p, const Point& q)
{
  return p < q ? std::make_pair(p, q) : std::make_pair(q, p);
}

Model planar(const Polyline& polygon, const double size, const std::vector<Polyline>& features,
             const std::vector<Polyline>& holes)
{
  Triangulation triangulation;
  insert(polygon, true, triangulation);
  for(const Polyline& feature : features)
    insert(feature, false, triangulation);
  std::vector<Exact_predicates::Point_2> seeds;
  for(const Polyline& hole : holes)
  {
    insert(hole, true, triangulation);
    seeds.push_back(inside(hole));
  }
  CGAL::Delaunay_mesher_2<Triangulation, Size_criteria> mesher(triangulation, Size_criteria(0.125, size));
  mesher.set_seeds(seeds.begin(), seeds.end());
  mesher.refine_mesh();

  Model result;
  std::map<Triangulation::Vertex_handle, std::size_t> number;
  const auto number_of = [&](const Triangulation::Vertex_handle v)
  {
    const auto [place, is_new] = number.emplace(v, result.points.size());
    if(is_new)
      result.points.emplace_back(v->point().x(), v->point().y(), 0);
    return place->second;
  };
  for(auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
  {
    if(!f->is_in_domain())
      continue;
    result.triangles.push_back({ number_of(f->vertex(0)), number_of(f->vertex(1)), number_of(f->vertex(2)) });
    for(int k = 0; k < 3; ++k)
      if(f->is_constrained(k) && f->neighbor(k)->is_in_domain())
        result.features.push_back(segment(result.points[number_of(f->vertex(Triangulation::cw(k)))],
                                          result.points[number_of(f->vertex(Triangulation::ccw(k)))]));
  }
  return result;
}

Model regular_polygon(const int n, const double size) { return planar(circle(n, 1), size); }

Model wedge(const double angle_in_degrees, const double size)
{
  const double angle = angle_in_degrees * degree;
  const int number_of_steps = static_cast<int>(std::ceil(angle / size));
  Polyline polygon = { { 0, 0 } };
  for(int k = 0; k <= number_of_steps; ++k)
    polygon.emplace_back(std::cos(k * angle / number_of_steps), std::sin(k * angle / number_of_steps));
  return planar(polygon, size);
}

Model star(const std::vector<double>& tip_angles_in_degrees, const double size)
{
  const int n = static_cast<int>(tip_angles_in_degrees.size());
  const double half_step = turn / (2 * n);
  Polyline polygon;
  for(int k = 0; k < n; ++k)
  {
    const double radius = std::cos(half_step) + std::sin(half_step) / std::tan(tip_angles_in_degrees[k] * degree / 2);
    polygon.emplace_back(radius * std::cos(2 * k * half_step), radius * std::sin(2 * k * half_step));
    polygon.emplace_back(std::cos((2 * k + 1) * half_step), std::sin((2 * k + 1) * half_step));
  }
  return planar(polygon, size);
}

Model wedge_with_fan(const double angle_in_degrees, const int fan)
{
  const std::size_t number_of_rings = 6;
  const std::size_t row = static_cast<std::size_t>(fan) + 1;
  Model result;
  result.points.emplace_back(0, 0, 0);
  for(std::size_t i = 1; i <= number_of_rings; ++i)
    for(int k = 0; k <= fan; ++k)
    {
      const double angle = k * angle_in_degrees * degree / fan;
      result.points.emplace_back(i * std::cos(angle), i * std::sin(angle), 0);
    }
  for(std::size_t k = 1; k < row; ++k)
  {
    result.triangles.push_back({ 0, k, k + 1 });
    for(std::size_t p = k; p + row + 1 < result.points.size(); p += row)
    {
      result.triangles.push_back({ p, p + row, p + row + 1 });
      result.triangles.push_back({ p, p + row + 1, p + 1 });
    }
  }
  return result;
}

Model grid(const int m, const int n, const bool is_closed_in_u, const bool is_closed_in_v,
           const std::function<Point(double, double)>& position)
{
  const int columns = is_closed_in_u ? m : m + 1, rows = is_closed_in_v ? n : n + 1;
  Model result;
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i)
      result.points.push_back(position(static_cast<double>(i) / m, static_cast<double>(j) / n));
  const auto number = [&](const int i, const int j)
  {
    return static_cast<std::size_t>(j % rows) * columns + i % columns;
  };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < m; ++i)
    {
      const std::size_t p = number(i, j), q = number(i + 1, j), r = number(i + 1, j + 1), s = number(i, j + 1);
      if((i + j) % 2 == 0)
        result.triangles.insert(result.triangles.end(), { Triangle{ p, q, r }, Triangle{ p, r, s } });
      else
        result.triangles.insert(result.triangles.end(), { Triangle{ p, q, s }, Triangle{ q, r, s } });
    }
  return result;
}

Model square(const int n)
{
  return grid(n, n, false, false, [](const double u, const double v) { return Point(u, v, 0); });
}

Model annulus(const int m, const int n)
{
  return grid(m, n, true, false, [](const double u, const double v)
  {
    return Point((2 - v) * std::cos(turn * u), (2 - v) * std::sin(turn * u), 0);
  });
}

Model open_cylinder()
{
  return grid(16, 8, true, false, [](const double u, const double v)
  {
    return Point(std::cos(turn * u), std::sin(turn * u), 3 * v);
  });
}

Model rough_tube(const int number_of_rings)
{
  std::mt19937 generator;
  const auto noise = [&generator] { return 0.3 * (generator() / 2147483648. - 1); };
  return grid(8, number_of_rings, true, false, [&](const double u, const double v)
  {
    const double x = 1.3 + noise(), y = 1.3 + noise(), z = noise();
    if(v == 0 || v == 1)
      return Point(1.3 * std::cos(360 * degree * u), 1.3 * std::sin(360 * degree * u), v * number_of_rings);
    return Point(x * std::cos(360 * degree * u), y * std::sin(360 * degree * u), v * number_of_rings + z);
  });
}

Model torus()
{
  return grid(24, 12, true, true, [](const double u, const double v)
  {
    const double radius = 3 + std::cos(turn * v);
    return Point(radius * std::cos(turn * u), radius * std::sin(turn * u), std::sin(turn * v));
  });
}

Model with_sorted_elements(const Model& model)
{
  Model result = model;
  std::sort(result.points.begin(), result.points.end());
  const auto number = [&](const std::size_t p)
  {
    return std::lower_bound(result.points.begin(), result.points.end(), model.points[p]) - result.points.begin();
  };
  for(Triangle& triangle : result.triangles)
  {
    std::transform(triangle.begin(), triangle.end(), triangle.begin(), number);
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  return result;
}

// With rounded predicates the hull may crash, and the order of its vertices and faces varies from run to run.
Model convex_hull(const std::vector<Point>& points)
{
  std::vector<Exact_predicates::Point_3> exact_points;
  for(const Point& p : points)
    exact_points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Surface_mesh<Exact_predicates::Point_3> hull;
  CGAL::convex_hull_3(exact_points.begin(), exact_points.end(), hull);
  Mesh result;
  CGAL::copy_face_graph(hull, result);
  return with_sorted_elements(to_model(result));
}

Model sphere()
{
  CGAL::Random random(1);
  std::vector<Point> points;
  std::copy_n(CGAL::Random_points_on_sphere_3<Point>(1, random), 500, std::back_inserter(points));
  return convex_hull(points);
}

Model tetrahedron()
{
  Model result{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
                { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } }, {} };
  return with_sharp_edges(std::move(result));
}

Model cube()
{
  Model result;
  for(int k = 0; k < 8; ++k)
    result.points.emplace_back(k & 1, (k >> 1) & 1, k >> 2);
  const auto add_square = [&](const std::size_t p, const std::size_t q, const std::size_t r, const std::size_t s)
  {
    result.triangles.insert(result.triangles.end(), { Triangle{ p, q, r }, Triangle{ p, r, s } });
  };
  add_square(0, 2, 3, 1);
  add_square(4, 5, 7, 6);
  add_square(0, 1, 5, 4);
  add_square(2, 6, 7, 3);
  add_square(0, 4, 6, 2);
  add_square(1, 3, 7, 5);
  return with_sharp_edges(std::move(result));
}

Model single_triangle() { return { { { 0, 0, 0 }, { 4, 0, 0 }, { 1, 3, 0 } }, { { 0, 1, 2 } }, {} }; }

Model quilt()
{
  const Polyline border = { { 0, 0 }, { 4.1, -0.3 }, { 5.2, 1.7 }, { 4.6, 4.1 }, { 1.9, 3.4 }, { -0.7, 4.3 } };
  const std::vector<Polyline> features = { { { 0, 0 }, { 1.3, 1.2 }, { 1.9, 3.4 } },
                                           { { 2.6, 0.7 }, { 3.7, 0.9 }, { 3.3, 1.8 }, { 2.6, 0.7 } },
                                           { { 2.2, 2.6 }, { 3.9, 2.9 } },
                                           { { 1.3, 1.2 }, { 0.3, 2.3 } } };
  return transformed(planar(border, 0.33, features), [](const Point& p)
  {
    return Point(p.x(), p.y(), 0.3 * std::sin(p.x()) + 0.1 * p.x() * p.y() - 0.05 * p.y() * p.y());
  });
}

Model with_flat_triangle(Model model, const std::size_t triangle, const double distance)
{
  const auto [a, b, c] = model.triangles[triangle];
  const Point middle = CGAL::midpoint(model.points[a], model.points[b]);
  model.points[c] = middle + distance * (model.points[c] - middle);
  return model;
}

Model with_short_edge(Model model, const std::size_t triangle, const double length)
{
  const Point& first = model.points[model.triangles[triangle][0]];
  Point& second = model.points[model.triangles[triangle][1]];
  second = first + length * (second - first) / std::sqrt(CGAL::squared_distance(first, second));
  return model;
}

Model with_sharp_edges(Model model)
{
  Mesh mesh = to_mesh(model);
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, 40, is_sharp);
  for(const Mesh::Edge_index e : mesh.edges())
    if(get(is_sharp, e))
      model.features.push_back(segment(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return model;
}

Model transformed(Model model, const std::function<Point(const Point&)>& map)
{
  for(Point& p : model.points)
    p = map(p);
  for(auto& [p, q] : model.features)
    std::tie(p, q) = segment(map(p), map(q));
  return model;
}

Model side_by_side(Model model, const Model& other)
{
  const std::size_t offset = model.points.size();
  for(const Point& p : other.points)
    model.points.push_back(p + Vector(100, 0, 0));
  for(const auto& [p, q, r] : other.triangles)
    model.triangles.push_back({ p + offset, q + offset, r + offset });
  return model;
}

Model repaired(Model model)
{
  if(!PMP::is_polygon_soup_a_polygon_mesh(model.triangles))
  {
    PMP::repair_polygon_soup(model.points, model.triangles);
    PMP::orient_polygon_soup(model.points, model.triangles);
  }
  return model;
}

Model read_model(const std::string& model_file, const std::string& feature_file)
{
  Model result;
  if(!CGAL::IO::read_OFF(model_file, result.points, result.triangles))
    throw std::runtime_error("cannot read " + model_file);
  if(!feature_file.empty())
  {
    std::ifstream in(feature_file);
    for(std::size_t i, j; in >> i >> j;)
      result.features.push_back(segment(result.points.at(i), result.points.at(j)));
  }
  result = repaired(std::move(result));
  return feature_file.empty() ? with_sharp_edges(std::move(result)) : result;
}

void write_model(const Model& model, const std::string& stem)
{
  std::ofstream mesh_file(stem + ".off");
  mesh_file.precision(17);
  CGAL::IO::write_OFF(mesh_file, model.points, model.triangles,
                      CGAL::parameters::stream_precision(17));
  std::map<Point, std::size_t> number;
  for(std::size_t p = 0; p < model.points.size(); ++p)
    number[model.points[p]] = p;
  std::ofstream feature_file(stem + ".feat");
  for(const auto& [p, q] : model.features)
    feature_file << number.at(p) << " " << number.at(q) << "\n";
}

Model to_model(const Mesh& mesh)
{
  Model result;
  std::map<Mesh::Vertex_index, std::size_t> number;
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    number[v] = result.points.size();
    result.points.push_back(mesh.point(v));
  }
  for(const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    result.triangles.push_back({ number[mesh.source(h)], number[mesh.target(h)],
                                 number[mesh.target(mesh.next(h))] });
  }
  return result;
}

bool Named_model::is_available() const { return file.empty() || std::ifstream(file).good(); }

std::ostream& operator<<(std::ostream& out, const Named_model& model) { return out << model.name; }

std::vector<Named_model> generated_models()
{
  const Polyline frame = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 } };
  const auto framed = [frame](const Polyline& feature) { return [=] { return planar(frame, 0.4, { feature }); }; };
  std::vector<Named_model> result = {
    { "annulus", [] { return annulus(20, 4); }, "" },
    { "annulus_without_inner_vertex", [] { return annulus(12, 1); }, "" },
    { "square_with_hole",
      [=] { return planar(frame, 0.4, {}, { { { 1, 1 }, { 2.2, 1.1 }, { 1.4, 1.9 } } }); }, "" },
    { "torus", torus, "" },
    { "sphere", sphere, "" },
    { "open_cylinder", open_cylinder, "" },
    { "dangling_feature", framed({ { 1, 1 }, { 1.5, 2 }, { 2, 1.7 } }), "" },
    { "closed_feature", framed({ { 1, 1 }, { 2, 1.2 }, { 1.4, 2.1 }, { 1, 1 } }), "" },
    { "feature_from_border", framed({ { 0, 1 }, { 1.2, 1.4 }, { 1.8, 2.2 } }), "" },
    { "feature_from_border_to_border", framed({ { 0, 1 }, { 1.2, 1.4 }, { 3, 0 } }), "" },
    { "patches_touching_in_a_vertex",
      framed({ { 1.5, 1.5 }, { 0.7, 1.9 }, { 0.6, 1 }, { 1.5, 1.5 }, { 2.3, 2 }, { 2.4, 1.1 }, { 1.5, 1.5 } }), "" },
    { "single_triangle", single_triangle, "" },
    { "tetrahedron", tetrahedron, "" },
    { "cube", cube, "" },
    { "quilt", quilt, "" },
    { "needles", [] { return with_short_edge(square(8), 60, 1e-8); }, "" },
    { "cap", [] { return with_flat_triangle(square(8), 54, 1e-8); }, "" },
    { "face_without_area", [] { return with_flat_triangle(square(8), 54, 0); }, "" } };
  for(const int n : { 3, 4, 5, 6, 7, 9, 10, 11, 12 }) // the angles of an octagon are the default bound itself
    result.push_back({ "polygon_" + std::to_string(n), [n] { return regular_polygon(n); }, "" });
  for(const int angle : { 1, 3, 10, 30, 44, 46, 60, 89, 90, 91, 120, 134, 136, 150, 170 })
    result.push_back({ "wedge_" + std::to_string(angle), [angle] { return wedge(angle); }, "" });
  result.push_back({ "star", [] { return star({ 5, 20, 44, 10, 30 }); }, "" });
  return result;
}

std::vector<Named_model> cgal_models()
{
  std::vector<Named_model> result;
  for(const char* const name :
      { "fandisk", "turbine", "anchor_dense", "rotor_small", "couplingdown", "cube-meshed", "pinion", "pinion_small",
        "spool", "anchor", "oblong", "joint", "part", "dragknob", "pipe", "u", "cross", "patch-01", "patch-20",
        "cylinder", "blade", "mech-holes-shark" })
  {
    const std::string file = std::string(TEST_FRAME_FIELDS_CGAL_DATA_DIRECTORY) + "/meshes/" + name + ".off";
    std::string identifier = name;
    std::replace(identifier.begin(), identifier.end(), '-', '_');
    result.push_back({ identifier, [file] { return read_model(file); }, file });
  }
  return result;
}

namespace {

std::string content_of(const std::string& file)
{
  std::ifstream in(file);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

} // namespace

// A model of which all features are the ones that bound its surfaces counts once, unless there are no files.
std::vector<Named_model> cad_models()
{
  std::vector<Named_model> result;
  for(const char* const name :
      { "gu_bc", "gu_placa2", "gu_torus", "gu_triangle", "lc_gripper_handle", "lc_gripper_static",
        "lc_shoulder_to_elbow", "oc_crankarm", "oc_shell1_sheet", "tm_box_sides", "tm_counter", "tm_fandisk",
        "tm_featuretype", "tm_octagonal_pocket" })
    for(const char* const features : { "feat", "all" })
    {
      const std::string stem = std::string(TEST_FRAME_FIELDS_CAD_DATA_DIRECTORY) + "/" + name + ".";
      if(features == std::string("all") && std::ifstream(stem + "all")
         && content_of(stem + "all") == content_of(stem + "feat"))
        continue;
      result.push_back({ std::string(name) + "_" + features,
                         [stem, features] { return read_model(stem + "off", stem + features); }, stem + "off" });
    }
  return result;
}

std::optional<int> reference_number_of_unmeshable_sectors(const Named_model& model)
{
  const std::string file_name = model.file.substr(model.file.find_last_of('/') + 1);
  const std::string features = model.name.substr(model.name.find_last_of('_') + 1);
  std::ifstream in(std::string(TEST_FRAME_FIELDS_CAD_DATA_DIRECTORY) + "/reference.csv");
  const auto columns_of = [](const std::string& line)
  {
    std::vector<std::string> columns;
    std::istringstream stream(line);
    for(std::string column; std::getline(stream, column, ',');)
      columns.push_back(column);
    return columns;
  };
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = columns_of(line);
  const auto wanted = std::find(header.begin(), header.end(), "unmeshable_rings4") - header.begin();
  while(std::getline(in, line))
  {
    const std::vector<std::string> columns = columns_of(line);
    if((columns[0] == file_name && columns[1] == features)
       || (columns[0] == "libcgal-demo:meshes/" + file_name && columns[1] == "40deg"))
      return std::stoi(columns.at(wanted));
  }
  return std::nullopt;
}

} // namespace test
