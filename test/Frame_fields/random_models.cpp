#include "random_models.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <random>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace test {

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Planar_kernel;
typedef CGAL::Triangulation_vertex_base_2<Planar_kernel> Vertex_base;
typedef CGAL::Constrained_triangulation_face_base_2<Planar_kernel> Face_base;
typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base> Data_structure;
typedef CGAL::Constrained_Delaunay_triangulation_2<Planar_kernel, Data_structure, CGAL::Exact_predicates_tag>
  Triangulation;

constexpr double turn = 360 * degree;

class Random
{
public:
  explicit Random(const unsigned int seed) : m_generator(seed) {}

  int integer(const int from, const int to) { return std::uniform_int_distribution<int>(from, to)(m_generator); }
  double number(const double from, const double to)
  {
    return std::uniform_real_distribution<double>(from, to)(m_generator);
  }

private:
  std::mt19937 m_generator;
};

class Spiked_domain
{
public:
  explicit Spiked_domain(const unsigned int seed) : m_random(seed)
  {
    do
      draw();
    while(!CGAL::is_simple_2(m_boundary.begin(), m_boundary.end())); // long spikes may meet
  }

  Model model() const
  {
    Triangulation triangulation;
    triangulation.insert_constraint(m_boundary.begin(), m_boundary.end(), true);
    triangulation.insert(m_inner_points.begin(), m_inner_points.end());
    const std::unordered_set<Triangulation::Face_handle> outside = faces_outside(triangulation);
    std::unordered_map<Triangulation::Vertex_handle, std::size_t> number;
    Model model;
    for(const auto f : triangulation.finite_face_handles())
    {
      if(outside.count(f))
        continue;
      Triangle triangle;
      for(int k = 0; k < 3; ++k)
      {
        const auto [place, is_new] = number.insert({ f->vertex(k), model.points.size() });
        if(is_new)
          model.points.emplace_back(f->vertex(k)->point().x(), f->vertex(k)->point().y(), 0);
        triangle[k] = place->second;
      }
      model.triangles.push_back(triangle);
    }
    return model;
  }

private:
  // The faces that are reached from infinity without crossing the boundary.
  static std::unordered_set<Triangulation::Face_handle> faces_outside(const Triangulation& triangulation)
  {
    std::unordered_set<Triangulation::Face_handle> outside{ triangulation.infinite_face() };
    std::vector<Triangulation::Face_handle> stack(outside.begin(), outside.end());
    while(!stack.empty())
    {
      const Triangulation::Face_handle f = stack.back();
      stack.pop_back();
      for(int k = 0; k < 3; ++k)
        if(!f->is_constrained(k) && outside.insert(f->neighbor(k)).second)
          stack.push_back(f->neighbor(k));
    }
    return outside;
  }

  void draw()
  {
    m_boundary.clear();
    m_inner_points.clear();
    const int number_of_sides = m_random.integer(3, 12);
    const double radius = 1;
    const auto corner = [&](const int k)
    {
      const double angle = turn * k / number_of_sides;
      return Planar_kernel::Point_2(radius * std::cos(angle), radius * std::sin(angle));
    };
    for(int k = 0; k < number_of_sides; ++k)
      add_side(corner(k), corner(k + 1));
    for(int k = m_random.integer(0, 40); k > 0; --k)
    {
      const double r = radius * std::sqrt(m_random.number(0, 1)), angle = m_random.number(0, turn);
      m_inner_points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  }

  void add_side(const Planar_kernel::Point_2& from, const Planar_kernel::Point_2& to)
  {
    if(m_random.integer(0, 4) == 0)
    {
      add_segment(from, to);
      return;
    }
    const double apex_angle = m_random.number(0.5, 44) * degree;
    const Planar_kernel::Vector_2 side = to - from;
    const Planar_kernel::Vector_2 outward(side.y(), -side.x());
    const Planar_kernel::Point_2 apex = from + 0.5 * side + outward * (0.5 / std::tan(apex_angle / 2));
    add_segment(from, apex);
    add_segment(apex, to);
    add_fan(apex, -outward, apex_angle);
  }

  // Points at one distance from the apex, so that it gets a fan of several triangles.
  void add_fan(const Planar_kernel::Point_2& apex, const Planar_kernel::Vector_2& inward, const double apex_angle)
  {
    const double distance = m_random.number(0.02, 0.9) * 0.5 / std::tan(apex_angle / 2);
    const int number_of_points = m_random.integer(0, 5);
    for(int k = 1; k <= number_of_points; ++k)
    {
      const double angle = apex_angle * ((k + m_random.number(-0.3, 0.3)) / (number_of_points + 1) - 0.5);
      const double c = distance * std::cos(angle), s = distance * std::sin(angle);
      m_inner_points.emplace_back(apex.x() + c * inward.x() - s * inward.y(),
                                  apex.y() + s * inward.x() + c * inward.y());
    }
  }

  void add_segment(const Planar_kernel::Point_2& from, const Planar_kernel::Point_2& to)
  {
    const int number_of_edges = m_random.integer(1, 5);
    for(int k = 0; k < number_of_edges; ++k)
      m_boundary.push_back(from + (to - from) * (static_cast<double>(k) / number_of_edges));
  }

  Random m_random;
  std::vector<Planar_kernel::Point_2> m_boundary, m_inner_points;
};

Model with_random_features(Model model, const int number_of_walks, Random& random)
{
  std::vector<std::vector<std::size_t> > neighbors(model.points.size());
  for(const Triangle& triangle : model.triangles)
    for(int k = 0; k < 3; ++k)
    {
      neighbors[triangle[k]].push_back(triangle[(k + 1) % 3]);
      neighbors[triangle[k]].push_back(triangle[(k + 2) % 3]);
    }
  for(int walk = 0; walk < number_of_walks; ++walk)
  {
    std::size_t at = model.triangles[random.integer(0, static_cast<int>(model.triangles.size()) - 1)][0];
    for(int step = random.integer(1, 12); step > 0; --step)
    {
      const std::size_t next = neighbors[at][random.integer(0, static_cast<int>(neighbors[at].size()) - 1)];
      model.features.push_back(segment(model.points[at], model.points[next]));
      at = next;
    }
  }
  return model;
}

std::vector<Point> random_points_on_ellipsoid(Random& random)
{
  const Vector half_axes(random.number(0.3, 1), random.number(0.3, 1), random.number(0.3, 1));
  std::vector<Point> points;
  for(int k = random.integer(6, 150); k > 0; --k)
  {
    const double z = random.number(-1, 1), angle = random.number(0, turn), r = std::sqrt(1 - z * z);
    points.emplace_back(half_axes.x() * r * std::cos(angle), half_axes.y() * r * std::sin(angle), half_axes.z() * z);
  }
  return points;
}

// The profile of a gear: each tooth has a foot, two flanks and a head of random widths.
Polyline gear_profile(Random& random)
{
  const int number_of_teeth = random.integer(4, 14);
  const double height = random.number(0.05, 0.6);
  const double flank = random.number(0.1, 0.45), head = random.number(0.05, 0.95 - 2 * flank);
  Polyline result;
  const auto add = [&](const double place, const double radius)
  {
    const double angle = turn * place / number_of_teeth;
    result.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  };
  for(int tooth = 0; tooth < number_of_teeth; ++tooth)
  {
    add(tooth, 1);
    add(tooth + flank, 1 + height);
    add(tooth + flank + head, 1 + height);
    add(tooth + 2 * flank + head, 1);
  }
  return result;
}

// The solid between a model in the plane z = 0 and its copy at z = height, its walls cut into layers.
Model extruded(const Model& base, const double height, const int number_of_layers)
{
  typedef std::pair<std::size_t, std::size_t> Side;
  std::set<Side> sides;
  for(const Triangle& triangle : base.triangles)
    for(int k = 0; k < 3; ++k)
      sides.emplace(triangle[k], triangle[(k + 1) % 3]);

  Model result;
  std::vector<std::vector<std::size_t> > number(number_of_layers + 1, std::vector<std::size_t>(base.points.size()));
  const auto add_point = [&](const int layer, const std::size_t p)
  {
    number[layer][p] = result.points.size();
    result.points.emplace_back(base.points[p].x(), base.points[p].y(), height * layer / number_of_layers);
  };
  for(const int layer : { 0, number_of_layers })
    for(std::size_t p = 0; p < base.points.size(); ++p)
      add_point(layer, p);
  for(const Triangle& triangle : base.triangles)
  {
    const auto [p, q, r] = triangle;
    const std::vector<std::size_t>& bottom = number.front();
    const std::vector<std::size_t>& top = number.back();
    result.triangles.push_back({ bottom[p], bottom[r], bottom[q] });
    result.triangles.push_back({ top[p], top[q], top[r] });
  }
  std::vector<Side> border;
  std::copy_if(sides.begin(), sides.end(), std::back_inserter(border),
               [&](const Side& side) { return sides.count({ side.second, side.first }) == 0; });
  for(int layer = 1; layer < number_of_layers; ++layer)
    for(const Side& side : border)
      add_point(layer, side.first); // each vertex of the border starts one side
  for(int layer = 0; layer < number_of_layers; ++layer)
    for(const auto& [p, q] : border)
    {
      result.triangles.push_back({ number[layer][p], number[layer][q], number[layer + 1][q] });
      result.triangles.push_back({ number[layer][p], number[layer + 1][q], number[layer + 1][p] });
    }
  return result;
}

} // namespace

int number_from_environment(const char* const name, const int default_value)
{
  const char* const text = std::getenv(name);
  return text ? std::atoi(text) : default_value;
}

Model spiked_domain(const unsigned int seed) { return Spiked_domain(seed).model(); }

Model random_planar_domain(const unsigned int seed)
{
  Random random(seed);
  const double squeeze = random.number(0.7, 0.99); // the angles of an octagon are the default bound for sharp corners
  const Model domain =
    transformed(spiked_domain(seed), [&](const Point& p) { return Point(p.x(), squeeze * p.y(), 0); });
  return with_random_features(domain, random.integer(0, 8), random);
}

Model random_convex_polyhedron(const unsigned int seed)
{
  Random random(seed);
  const Model hull = with_sharp_edges(convex_hull(random_points_on_ellipsoid(random)));
  return with_random_features(hull, random.integer(1, 8), random);
}

Model random_star_shaped_polyhedron(const unsigned int seed)
{
  Random random(seed);
  Model model = convex_hull(random_points_on_ellipsoid(random));
  for(Point& p : model.points)
    p = CGAL::ORIGIN + random.number(0.4, 1) * (p - CGAL::ORIGIN);
  return with_random_features(with_sharp_edges(model), random.integer(1, 8), random);
}

Model random_gear(const unsigned int seed)
{
  Random random(seed);
  const Polyline profile = gear_profile(random);
  std::vector<Polyline> holes;
  if(random.integer(0, 1) == 1)
    holes.push_back({ { -0.3, 0.1 }, { 0.1, -0.4 }, { 0.5, 0.1 }, { 0.2, 0.5 } });
  const Model gear = planar(profile, random.number(0.3, 1), {}, holes);
  Model solid = extruded(gear, random.number(0.1, 1.5), random.integer(1, 4));
  for(Point& p : solid.points) // where a wall is a perfect grid, rounding errors choose between equally good fields
    p = p + Vector(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1)) / 500;
  return with_random_features(with_sharp_edges(solid), random.integer(0, 4), random);
}

Model random_torus(const unsigned int seed)
{
  Random random(seed);
  const double thickness = random.number(0.2, 0.8), bump = random.number(0, 0.4);
  const int number_of_bumps = random.integer(1, 3);
  const Model coarse = grid(random.integer(3, 9), random.integer(3, 7), true, true, [&](const double u, const double v)
  {
    const double tube = thickness * (1 + bump * std::sin(number_of_bumps * turn * u));
    const double radius = 1.5 + tube * std::cos(turn * v);
    return Point(radius * std::cos(turn * u) + random.number(-0.05, 0.05),
                 radius * std::sin(turn * u) + random.number(-0.05, 0.05), tube * std::sin(turn * v));
  });
  CGAL::Surface_mesh<Point> mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(coarse.points, coarse.triangles, mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  return with_random_features(to_model(mesh), seed % 4 == 0 ? 0 : random.integer(1, 8), random);
}

std::ostream& operator<<(std::ostream& out, const Random_models& models) { return out << models.name; }

std::vector<Random_models> kinds_of_random_models()
{
  return { { "planar_domains", random_planar_domain },
           { "convex_polyhedra", random_convex_polyhedron },
           { "star_shaped_polyhedra", random_star_shaped_polyhedron },
           { "gears", random_gear },
           { "tori", random_torus } };
}

} // namespace test
