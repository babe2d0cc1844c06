// Random planar domains with many very sharp corners a few edges apart: whatever the mesh, no corner may be left
// unmeshable. The environment variable FRAME_FIELDS_RANDOM_DOMAINS sets their number, FRAME_FIELDS_SEED the first seed.

#include <CGAL/Frame_fields.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace Frame_fields = CGAL::Frame_fields;
namespace params = CGAL::Frame_fields::parameters;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Triangulation_vertex_base_2<Kernel> Vertex_base;
typedef CGAL::Constrained_triangulation_face_base_2<Kernel> Face_base;
typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base> Data_structure;
typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data_structure, CGAL::Exact_predicates_tag> Triangulation;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace {

int number_from_environment(const char* const name, const int default_value)
{
  const char* const text = std::getenv(name);
  return text ? std::atoi(text) : default_value;
}

// A regular polygon, most sides of which carry a spike of a random apex angle between 0.5 and 44 degrees. Every side is
// cut into a few edges, most apexes have a fan of several triangles, and the inside has a few random points.
class Spiked_domain
{
public:
  explicit Spiked_domain(const unsigned int seed) : m_random(seed)
  {
    do
      draw();
    while(!CGAL::is_simple_2(m_boundary.begin(), m_boundary.end())); // long spikes may meet
  }

  Mesh mesh() const
  {
    Triangulation triangulation;
    triangulation.insert_constraint(m_boundary.begin(), m_boundary.end(), true);
    triangulation.insert(m_inner_points.begin(), m_inner_points.end());
    const std::unordered_set<Triangulation::Face_handle> outside = faces_outside(triangulation);
    std::unordered_map<Triangulation::Vertex_handle, std::size_t> number;
    std::vector<Kernel::Point_3> points;
    std::vector<std::array<std::size_t, 3> > triangles;
    for(const auto f : triangulation.finite_face_handles())
    {
      if(outside.count(f))
        continue;
      std::array<std::size_t, 3> triangle;
      for(int k = 0; k < 3; ++k)
      {
        const auto [place, is_new] = number.insert({ f->vertex(k), points.size() });
        if(is_new)
          points.emplace_back(f->vertex(k)->point().x(), f->vertex(k)->point().y(), 0);
        triangle[k] = place->second;
      }
      triangles.push_back(triangle);
    }
    Mesh mesh;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
    return mesh;
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
    const int number_of_sides = integer(3, 12);
    const double radius = 1;
    const auto corner = [&](const int k)
    {
      const double angle = 2 * CGAL_PI * k / number_of_sides;
      return Kernel::Point_2(radius * std::cos(angle), radius * std::sin(angle));
    };
    for(int k = 0; k < number_of_sides; ++k)
      add_side(corner(k), corner(k + 1));
    for(int k = integer(0, 40); k > 0; --k)
    {
      const double r = radius * std::sqrt(number(0, 1)), angle = number(0, 2 * CGAL_PI);
      m_inner_points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  }

  int integer(const int from, const int to) { return std::uniform_int_distribution<int>(from, to)(m_random); }
  double number(const double from, const double to)
  {
    return std::uniform_real_distribution<double>(from, to)(m_random);
  }

  void add_side(const Kernel::Point_2& from, const Kernel::Point_2& to)
  {
    if(integer(0, 4) == 0)
    {
      add_segment(from, to);
      return;
    }
    const double apex_angle = number(0.5, 44) * CGAL_PI / 180;
    const Kernel::Vector_2 side = to - from;
    const Kernel::Vector_2 outward(side.y(), -side.x());
    const Kernel::Point_2 apex = from + 0.5 * side + outward * (0.5 / std::tan(apex_angle / 2));
    add_segment(from, apex);
    add_segment(apex, to);
    add_fan(apex, -outward, apex_angle);
  }

  // Points at one distance from the apex, so that it gets a fan of several triangles.
  void add_fan(const Kernel::Point_2& apex, const Kernel::Vector_2& inward, const double apex_angle)
  {
    const double distance = number(0.02, 0.9) * 0.5 / std::tan(apex_angle / 2);
    const int number_of_points = integer(0, 5);
    for(int k = 1; k <= number_of_points; ++k)
    {
      const double angle = apex_angle * ((k + number(-0.3, 0.3)) / (number_of_points + 1) - 0.5);
      const double c = distance * std::cos(angle), s = distance * std::sin(angle);
      m_inner_points.emplace_back(apex.x() + c * inward.x() - s * inward.y(),
                                  apex.y() + s * inward.x() + c * inward.y());
    }
  }

  void add_segment(const Kernel::Point_2& from, const Kernel::Point_2& to)
  {
    const int number_of_edges = integer(1, 5);
    for(int k = 0; k < number_of_edges; ++k)
      m_boundary.push_back(from + (to - from) * (static_cast<double>(k) / number_of_edges));
  }

  std::mt19937 m_random;
  std::vector<Kernel::Point_2> m_boundary, m_inner_points;
};

struct Count
{
  int unmeshable = 0;
  std::size_t repaired = 0, unnatural = 0, corners = 0;
};

// Computes the field of a domain and counts its unmeshable sectors.
Count count(const Mesh& mesh, const Frame_fields::Support_strategy& strategy, const bool repairs)
{
  typedef boost::property_map<Mesh, CGAL::dynamic_face_property_t<double> >::const_type Face_map;
  const Face_map alpha = get(CGAL::dynamic_face_property_t<double>(), mesh);
  const Face_map rho = get(CGAL::dynamic_face_property_t<double>(), mesh);
  const auto index = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
  Frame_fields::Statistics statistics;
  const Frame_fields::Result result = Frame_fields::cad_frame_field(
    mesh, alpha, rho, index,
    params::statistics(std::ref(statistics)).support_strategy(strategy).repair_matching(repairs));
  EXPECT_TRUE(result) << result.message;

  Count total;
  total.repaired = statistics.number_of_repaired_sectors;
  total.unnatural = statistics.number_of_unnatural_corners;
  total.corners = statistics.number_of_sharp_corners;
  for(const auto h : halfedges(mesh)) // the first corner of each sector on the border
    if(!is_border(h, mesh) && is_border(opposite(next(h, mesh), mesh), mesh) && get(index, h) > 1)
      ++total.unmeshable;
  return total;
}

} // namespace

class Random_planar_domains : public testing::TestWithParam<std::pair<const char*, Frame_fields::Support_strategy> >
{};

TEST_P(Random_planar_domains, no_corner_is_unmeshable)
{
  const int number_of_domains = number_from_environment("FRAME_FIELDS_RANDOM_DOMAINS", 500);
  const int first_seed = number_from_environment("FRAME_FIELDS_SEED", 1);
  const Frame_fields::Support_strategy strategy = GetParam().second;
  Count without_repair, with_repair;
  for(int seed = first_seed; seed < first_seed + number_of_domains; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = Spiked_domain(seed).mesh();
    Frame_fields::split_overconstrained_faces(mesh);
    const Count before = count(mesh, strategy, false), after = count(mesh, strategy, true);
    EXPECT_EQ(after.unmeshable, 0);
    EXPECT_LE(after.unnatural, before.unnatural);
    EXPECT_EQ(after.repaired, static_cast<std::size_t>(before.unmeshable));
    without_repair.unmeshable += before.unmeshable;
    without_repair.unnatural += before.unnatural;
    with_repair.unmeshable += after.unmeshable;
    with_repair.unnatural += after.unnatural;
    with_repair.corners += after.corners;
  }
  std::cout << number_of_domains << " domains with " << with_repair.corners << " sharp corners; unmeshable: "
            << without_repair.unmeshable << " without and " << with_repair.unmeshable << " with the repair; without "
            << "their quarter: " << without_repair.unnatural << " and " << with_repair.unnatural << std::endl;
}

INSTANTIATE_TEST_SUITE_P(, Random_planar_domains,
                         testing::Values(std::make_pair("none", Frame_fields::Support_strategy::none()),
                                         std::make_pair("local", Frame_fields::Support_strategy::local()),
                                         std::make_pair("rings", Frame_fields::Support_strategy::rings(4)),
                                         std::make_pair("component", Frame_fields::Support_strategy::component())),
                         [](const auto& info) { return info.param.first; });
