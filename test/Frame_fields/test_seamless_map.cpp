#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/internal/field/frame_field.h>
#include <CGAL/Frame_fields/internal/parameterization/Barrier_energy.h>
#include <CGAL/Frame_fields/internal/parameterization/Integer_relations.h>
#include <CGAL/Frame_fields/internal/parameterization/compute_seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/propose_index_targets.h>
#include <CGAL/Frame_fields/internal/parameterization/repair_field.h>
#include <CGAL/Frame_fields/internal/parameterization/sign_of_determinant.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/collect_dual_edges.h>
#include <CGAL/Frame_fields/internal/surface/collect_sectors.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Frame_fields::internal;
using CGAL::Frame_fields::Eigen_frame_field_solver_traits;

typedef std::pair<int, int> Edge; // two vertices
typedef std::complex<long double> Number;

// Triangles with feature edges, and the indices that vertices must get.
struct Soup
{
  std::vector<Coordinates> points;
  std::vector<std::array<int, 3> > triangles;
  std::set<Edge> features;
  std::map<int, int> index_of_vertex;

  int add(const double x, const double y, const double z = 0)
  {
    points.push_back({ x, y, z });
    return static_cast<int>(points.size()) - 1;
  }

  void add_quad(const int a, const int b, const int c, const int d, const bool other_diagonal = false)
  {
    if(other_diagonal)
      triangles.insert(triangles.end(), { { a, b, d }, { b, c, d } });
    else
      triangles.insert(triangles.end(), { { a, b, c }, { a, c, d } });
  }

  void add_feature(const int a, const int b) { features.insert({ std::min(a, b), std::max(a, b) }); }
};

// Splits each triangle with two constrained edges, and each edge that cuts a patch between two of its sides, so that a
// map has room: here simply each triangle into three.
Soup refined(const Soup& soup)
{
  Soup result = soup;
  result.triangles.clear();
  for(const std::array<int, 3>& t : soup.triangles)
  {
    Coordinates center{ 0, 0, 0 };
    for(const int v : t)
      for(int k = 0; k < 3; ++k)
        center[k] += soup.points[v][k] / 3;
    const int c = result.add(center[0], center[1], center[2]);
    for(int k = 0; k < 3; ++k)
      result.triangles.push_back({ t[k], t[(k + 1) % 3], c });
  }
  return result;
}

// The plane grid cells that `holds_cell(i, j)` keeps.
template <typename HoldsCell>
Soup grid(const int width, const int height, const HoldsCell& holds_cell)
{
  Soup soup;
  std::map<Edge, int> number;
  const auto vertex = [&](const int i, const int j)
  {
    const auto found = number.insert({ { i, j }, static_cast<int>(soup.points.size()) });
    return found.second ? soup.add(i, j) : found.first->second;
  };
  for(int j = 0; j < height; ++j)
    for(int i = 0; i < width; ++i)
      if(holds_cell(i, j))
      {
        const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
        soup.add_quad(a, b, c, d, (i + j) % 2 == 1);
      }
  return refined(soup);
}

Soup square() { return grid(5, 4, [](int, int) { return true; }); }
Soup l_shape() { return grid(6, 6, [](const int i, const int j) { return i < 3 || j < 2; }); }
Soup plate_with_hole() { return grid(6, 6, [](const int i, const int j) { return i < 2 || i > 3 || j < 2 || j > 3; }); }

Soup plate_with_three_holes()
{
  return grid(14, 6, [](const int i, const int j) { return i % 4 < 2 || j < 2 || j > 3; });
}

Soup plate_with_slit()
{
  Soup soup = grid(6, 6, [](int, int) { return true; });
  for(std::size_t a = 0; a < soup.points.size(); ++a)
    for(std::size_t b = 0; b < soup.points.size(); ++b)
    {
      const Coordinates &p = soup.points[a], &q = soup.points[b];
      if(p[1] == 3 && q[1] == 3 && q[0] == p[0] + 1 && p[0] >= 2 && p[0] < 4)
        soup.add_feature(static_cast<int>(a), static_cast<int>(b));
    }
  return soup;
}

// A sector of a disk. Its tip holds one quad, or as many as its angle asks for.
Soup wedge(const double degrees)
{
  Soup soup;
  const int slices = 4, rings = 5, tip = soup.add(0, 0);
  const auto vertex = [&](const int ring, const int slice) { return 1 + (ring - 1) * (slices + 1) + slice; };
  for(int ring = 1; ring <= rings; ++ring)
    for(int slice = 0; slice <= slices; ++slice)
    {
      const double angle = degrees * CGAL_PI / 180 * slice / slices;
      soup.add(ring * std::cos(angle), ring * std::sin(angle));
    }
  for(int slice = 0; slice < slices; ++slice)
  {
    soup.triangles.push_back({ tip, vertex(1, slice), vertex(1, slice + 1) });
    for(int ring = 1; ring < rings; ++ring)
      soup.add_quad(vertex(ring, slice), vertex(ring + 1, slice), vertex(ring + 1, slice + 1), vertex(ring, slice + 1));
  }
  return refined(soup);
}

Soup disk()
{
  Soup soup;
  const int slices = 16, rings = 6, center = soup.add(0, 0);
  const auto vertex = [&](const int ring, const int slice) { return 1 + (ring - 1) * slices + slice % slices; };
  for(int ring = 1; ring <= rings; ++ring)
    for(int slice = 0; slice < slices; ++slice)
      soup.add(ring * std::cos(2 * CGAL_PI * slice / slices), ring * std::sin(2 * CGAL_PI * slice / slices));
  for(int slice = 0; slice < slices; ++slice)
  {
    soup.triangles.push_back({ center, vertex(1, slice), vertex(1, slice + 1) });
    for(int ring = 1; ring < rings; ++ring)
      soup.add_quad(vertex(ring, slice), vertex(ring + 1, slice), vertex(ring + 1, slice + 1), vertex(ring, slice + 1));
  }
  for(const int slice : { 2, 6, 10, 14 })
    soup.index_of_vertex[vertex(3, slice)] = 1;
  return refined(soup);
}

// A tube whose rows close up after some steps. Then its lower end has a step, and its upper end has one or not.
Soup tube(const int steps, const bool has_upper_step)
{
  Soup soup;
  const int columns = 12, rows = 4;
  std::map<Edge, int> number;
  const auto vertex = [&](int i, int j)
  {
    if(i == columns)
    {
      i = 0;
      j += steps;
    }
    const auto found = number.insert({ { i, j }, static_cast<int>(soup.points.size()) });
    if(!found.second)
      return found.first->second;
    const bool is_flat = steps == 0 || (!has_upper_step && j >= rows);
    const double place = is_flat && j > rows ? (rows - j) / (steps + 1.) : i, angle = 2 * CGAL_PI * place / columns;
    const double rise = has_upper_step ? steps : steps * (1 - j / double(rows));
    return soup.add(2 * std::cos(angle), 2 * std::sin(angle),
                    is_flat ? std::min(j, rows) : j + rise * i / double(columns));
  };
  for(int i = 0; i < columns; ++i)
    for(int j = 0; j < rows; ++j)
      soup.add_quad(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  return refined(soup);
}

Soup torus()
{
  Soup soup;
  const int n = 16, m = 8;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
    {
      const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * j / m, radius = 3 + std::cos(b);
      soup.add(radius * std::cos(a), radius * std::sin(a), std::sin(b));
    }
  const auto vertex = [&](const int i, const int j) { return i % n * m + j % m; };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
      soup.add_quad(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  return soup;
}

Soup torus_with_one_pair()
{
  Soup soup = torus();
  soup.index_of_vertex = { { 0, 1 }, { 5, -1 } };
  return soup;
}

// The surface of a cube, with its edges as features or with its corners as cones.
Soup cube(const bool has_features)
{
  Soup soup;
  const int n = 4;
  std::map<std::array<int, 3>, int> number;
  const auto vertex = [&](const std::array<int, 3>& p)
  {
    const auto found = number.insert({ p, static_cast<int>(soup.points.size()) });
    return found.second ? soup.add(p[0], p[1], p[2]) : found.first->second;
  };
  for(int axis = 0; axis < 3; ++axis)
    for(const int level : { 0, n })
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j)
        {
          const auto corner = [&](const int a, const int b)
          {
            std::array<int, 3> p;
            p[axis] = level;
            p[(axis + 1) % 3] = level > 0 ? i + a : i + b;
            p[(axis + 2) % 3] = level > 0 ? j + b : j + a;
            return vertex(p);
          };
          soup.add_quad(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
        }
  const auto is_at_edge = [&](const Coordinates& p, const Coordinates& q)
  {
    int shared = 0;
    for(int k = 0; k < 3; ++k)
      shared += p[k] == q[k] && (p[k] == 0 || p[k] == n);
    return shared == 2;
  };
  if(has_features)
    for(const std::array<int, 3>& t : soup.triangles)
      for(int k = 0; k < 3; ++k)
        if(is_at_edge(soup.points[t[k]], soup.points[t[(k + 1) % 3]]))
          soup.add_feature(t[k], t[(k + 1) % 3]);
  return refined(soup);
}

// The arrays of a soup with its field.
struct Case
{
  Cut_surface surface;
  std::vector<double> alpha, rho, target_length;
  std::vector<int> matching, index;
};

struct No_clock
{
  void start(CGAL::Frame_fields::Stage) {}
};

Cut_surface cut_surface(const Soup& soup)
{
  std::map<Edge, int> halfedge; // from source and target
  const int n = static_cast<int>(soup.triangles.size());
  const auto source = [&](const std::vector<int>& order, const int h)
  { return soup.triangles[order[h / 3]][h % 3]; };
  const auto target = [&](const std::vector<int>& order, const int h)
  { return soup.triangles[order[h / 3]][(h % 3 + 1) % 3]; };
  const auto opposites = [&](const std::vector<int>& order)
  {
    halfedge.clear();
    for(int h = 0; h < 3 * n; ++h)
      EXPECT_TRUE(halfedge.insert({ { source(order, h), target(order, h) }, h }).second);
    std::vector<int> result(3 * n, -1);
    for(int h = 0; h < 3 * n; ++h)
    {
      const int a = source(order, h), b = target(order, h);
      const auto found = halfedge.find({ b, a });
      if(found != halfedge.end() && !soup.features.count({ std::min(a, b), std::max(a, b) }))
        result[h] = found->second;
    }
    return result;
  };

  std::vector<int> order(n), patch_of_face;
  std::iota(order.begin(), order.end(), 0);
  Cut_surface surface;
  const std::vector<int> unordered = opposites(order);
  const int number_of_patches = number_patches(unordered, patch_of_face);
  order = face_order_by_patches(patch_of_face, number_of_patches, surface.patches);
  surface.opposite = opposites(order);
  for(int f = 0; f < n; ++f)
  {
    std::array<Coordinates, 3> points;
    for(int k = 0; k < 3; ++k)
      points[k] = soup.points[target(order, 3 * f + k)];
    for(const double angle : corner_angles(points))
      surface.angle.push_back(angle);
    for(int k = 0; k < 3; ++k)
      surface.length.push_back(distance(points[k], points[(k + 2) % 3]));
  }
  collect_sectors<CGAL::Sequential_tag>(surface);
  collect_dual_edges<CGAL::Sequential_tag>(surface, CGAL::Frame_fields::Edge_weighting::UNIFORM);
  align_with_constrained_edges(surface);
  if(!soup.index_of_vertex.empty())
  {
    surface.index_target.assign(surface.number_of_sectors(), CGAL::Frame_fields::NO_INDEX_TARGET);
    for(int h = 0; h < 3 * n; ++h)
      if(soup.index_of_vertex.count(target(order, h)))
        surface.index_target[surface.sector[h]] = soup.index_of_vertex.at(target(order, h));
  }
  return surface;
}

Case make_case(const Soup& soup, const std::vector<int>& index_target = {})
{
  Case result;
  result.surface = cut_surface(soup);
  if(!index_target.empty())
    result.surface.index_target = index_target;
  const Options options = options_from(CGAL::parameters::default_values());
  No_clock clock;
  Frame_field field;
  EXPECT_EQ(CGAL::Frame_fields::OK, compute_frame_field<CGAL::Sequential_tag>(
    result.surface, options, Eigen_frame_field_solver_traits(), clock, field).error_code);
  for(int f = 0; f < result.surface.number_of_faces(); ++f)
  {
    result.alpha.push_back(field.alpha[f] + field.gamma[f][0]);
    result.rho.push_back(field.gamma[f][1] - field.gamma[f][0]);
  }
  result.matching = field.matching;
  result.index = field.index;
  result.target_length.assign(result.surface.number_of_faces(), 0.5);
  return result;
}

Seamless_map map_of(const Case& c)
{
  Seamless_map map;
  compute_seamless_map<CGAL::Sequential_tag>(c.surface, c.alpha, c.rho, c.matching, c.index, c.target_length,
                                             Eigen_frame_field_solver_traits(), map);
  return map;
}

Number along(const Seamless_map& map, const int h)
{
  return Number(static_cast<long double>(map.u[h] - map.u[previous_of(h)]),
                static_cast<long double>(map.v[h] - map.v[previous_of(h)]));
}

Number quarter_turn(const int turns)
{
  const Number i(0, 1);
  Number result = 1;
  for(int k = 0; k < ((turns % 4) + 4) % 4; ++k)
    result *= i;
  return result;
}

// What a certified map must fulfil, from its numbers and the field, in complex numbers and with angles.
void expect_valid(const Case& c, const Seamless_map& map)
{
  const Cut_surface& s = c.surface;
  for(const Dual_edge& e : s.dual_edges)
    ASSERT_EQ(quarter_turn(map.quarter_turns[e.halfedge]) * along(map, e.halfedge), -along(map, e.opposite));

  std::vector<long double> turn_of_sector(s.number_of_sectors(), 0);
  for(int h = 0; h < s.number_of_halfedges(); ++h)
  {
    const Number ratio = -along(map, h) / along(map, next_of(h));
    ASSERT_GT(std::arg(ratio), 0) << "corner " << h;
    turn_of_sector[s.sector[h]] += std::arg(ratio);
  }
  for(int sector = 0; sector < s.number_of_sectors(); ++sector)
    ASSERT_NEAR((s.is_constrained_sector(sector) ? 2 : 4) - c.index[sector],
                static_cast<double>(turn_of_sector[sector] / (CGAL_PI / 2)), 1e-6);

  // The turn of each chart against the field follows from the matching; then constrained edges must run as the field
  // says, all with the same turn of their patch.
  for(const Patch& patch : s.patches)
  {
    std::map<int, int> turn{ { patch.faces.begin_index, 0 } };
    for(bool grows = true; grows; )
    {
      grows = false;
      for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
      {
        const int h = s.dual_edges[e].halfedge, i = face_of(h), j = face_of(s.dual_edges[e].opposite);
        if(turn.count(i) && !turn.count(j))
        {
          turn[j] = turn[i] + c.matching[e] - map.quarter_turns[h];
          grows = true;
        }
        else if(turn.count(j) && !turn.count(i))
        {
          turn[i] = turn[j] - c.matching[e] + map.quarter_turns[h];
          grows = true;
        }
        else if(turn.count(i))
        {
          ASSERT_EQ(0, (turn[i] + c.matching[e] - map.quarter_turns[h] - turn[j]) % 4);
        }
      }
    }
    Number turn_of_patch = 0;
    for(int h = 3 * patch.faces.begin_index; h < 3 * patch.faces.end_index; ++h)
    {
      if(!s.is_constrained(h))
        continue;
      int branch = -1;
      for(int k = 0; k < 4; ++k)
        if(std::abs(std::remainder(c.alpha[face_of(h)] + k * CGAL_PI / 2 + (k % 2) * c.rho[face_of(h)]
                                   - halfedge_angle(s, h), 2 * CGAL_PI)) < 1e-6)
          branch = k;
      ASSERT_GE(branch, 0);
      const Number axis = along(map, h) / std::abs(along(map, h));
      const Number rest = axis * quarter_turn(turn[face_of(h)] - branch);
      if(turn_of_patch == Number(0))
        turn_of_patch = rest;
      ASSERT_EQ(rest, turn_of_patch) << "halfedge " << h;
    }
  }
}

struct Known_map
{
  std::string name;
  std::function<Soup()> soup;
};

void PrintTo(const Known_map& known_map, std::ostream* out) { *out << known_map.name; }

class Seamless_maps : public testing::TestWithParam<Known_map> {};

TEST_P(Seamless_maps, are_certified)
{
  const Case c = make_case(GetParam().soup());
  const Seamless_map map = map_of(c);
  for(std::size_t patch = 0; patch < map.status.size(); ++patch)
  {
    ASSERT_EQ(Map_status::CERTIFIED, map.status[patch]) << "patch " << patch;
    EXPECT_GE(map.fraction_bits[patch], 32);
  }
  expect_valid(c, map);
}

TEST_P(Seamless_maps, are_the_same_when_computed_again)
{
  const Case c = make_case(GetParam().soup());
  const Seamless_map first = map_of(c), second = map_of(c);
  EXPECT_EQ(first.u, second.u);
  EXPECT_EQ(first.v, second.v);
  EXPECT_EQ(first.quarter_turns, second.quarter_turns);
}

// Where the least squares are the map, it does not depend on where the charts begin.
TEST_P(Seamless_maps, turn_with_the_chart_of_the_root)
{
  const Case c = make_case(GetParam().soup());
  const Seamless_map map = map_of(c);
  for(std::size_t number = 0; number < c.surface.patches.size(); ++number)
  {
    const Patch& patch = c.surface.patches[number];
    Seamless_map other = map;
    int fraction_bits = 0;
    std::vector<int> faulty_faces;
    const int root = patch.faces.begin_index + patch.faces.size() / 2;
    ASSERT_EQ(Map_status::CERTIFIED,
              Patch_parameterization(c.surface, patch, c.alpha, c.rho, c.matching, c.index, c.target_length, root)
                .compute(Eigen_frame_field_solver_traits(), other, fraction_bits, faulty_faces));
    EXPECT_TRUE(faulty_faces.empty());
    const double unit = std::ldexp(1., map.fraction_bits[number]), other_unit = std::ldexp(1., fraction_bits);
    for(int h = 3 * patch.faces.begin_index; h < 3 * patch.faces.end_index; ++h)
      ASSERT_NEAR(static_cast<double>(std::abs(along(map, h))) / unit,
                  static_cast<double>(std::abs(along(other, h))) / other_unit, 1e-6);
  }
}

// Whatever integers the free unknowns get, the map is seamless and aligned.
TEST_P(Seamless_maps, are_seamless_for_all_integers)
{
  const Case c = make_case(GetParam().soup());
  std::mt19937 generator(7);
  for(const Patch& patch : c.surface.patches)
  {
    const Combing combing = comb(c.surface, patch, c.matching, patch.faces.begin_index);
    const Cut_graph graph = Patch_cutter(c.surface, patch, c.index, combing).cut();
    const Combed_field field(c.surface, patch, c.alpha, c.rho, combing);
    const Map_basis basis(c.surface, patch, c.index, graph, field);
    ASSERT_FALSE(basis.has_overflow());
    std::vector<std::int64_t> z(basis.size()), x;
    for(std::int64_t& z_i : z)
      z_i = static_cast<std::int64_t>(generator() % 2000001) - 1000000;
    basis.multiply(z, x);
    const int first = 3 * patch.faces.begin_index;
    const auto value = [&](const int h)
    {
      const int vertex = graph.vertex[h - first];
      return Number(static_cast<long double>(x[2 * vertex]), static_cast<long double>(x[2 * vertex + 1]));
    };
    const auto edge = [&](const int h) { return value(h) - value(previous_of(h)); };
    for(int h = first; h < 3 * patch.faces.end_index; ++h)
    {
      const int turns = combing.quarter_turns[h - first];
      if(!c.surface.is_constrained(h))
      {
        ASSERT_EQ(quarter_turn(turns) * edge(h), -edge(c.surface.opposite[h]));
      }
      else
      {
        ASSERT_EQ(0, edge(h).real() * edge(h).imag());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Seamless_maps, testing::Values(
  Known_map{ "square", square }, Known_map{ "l_shape", l_shape }, Known_map{ "plate_with_hole", plate_with_hole },
  Known_map{ "plate_with_three_holes", plate_with_three_holes }, Known_map{ "plate_with_slit", plate_with_slit },
  Known_map{ "wedge_of_5_degrees", [] { return wedge(5); } },
  Known_map{ "wedge_of_40_degrees", [] { return wedge(40); } },
  Known_map{ "wedge_of_110_degrees", [] { return wedge(110); } },
  Known_map{ "wedge_of_170_degrees", [] { return wedge(170); } }, Known_map{ "disk", disk },
  Known_map{ "ring", [] { return tube(0, false); } },
  Known_map{ "helix", [] { return tube(1, true); } }, Known_map{ "torus", torus },
  Known_map{ "cube_with_features", [] { return cube(true); } },
  Known_map{ "cube_with_cones", [] { return cube(false); } }),
  [](const auto& info) { return info.param.name; });

TEST(Seamless_map, measures_lengths_in_target_lengths)
{
  const Case c = make_case(square());
  const Seamless_map map = map_of(c);
  for(int h = 0; h < c.surface.number_of_halfedges(); ++h)
    EXPECT_NEAR(2 * c.surface.length[h],
                std::ldexp(static_cast<double>(std::abs(along(map, h))), -map.fraction_bits[0]), 1e-9);
}

// Around a ring the lower end comes back to its height: the step must vanish, of one edge or of two that may be long.
TEST(Seamless_map, finds_the_step_on_a_ring)
{
  for(const int steps : { 1, 2 })
  {
    const Case c = make_case(tube(steps, false));
    const std::multiset<int> indices(c.index.begin(), c.index.end());
    ASSERT_EQ(1u, indices.count(1));
    ASSERT_EQ(1u, indices.count(-1));
    EXPECT_EQ(std::vector<Map_status>{ Map_status::FORCED_ZERO_SIDE }, map_of(c).status);
  }
}

TEST(Seamless_map, makes_a_slope_of_the_step)
{
  const Soup step = tube(2, false);
  Case c = make_case(step);
  std::vector<int> index_target(c.index.size());
  ASSERT_TRUE(propose_index_targets(c.surface, c.surface.patches[0], c.alpha, c.rho, c.matching, c.index,
                                    index_target));
  EXPECT_EQ(0, *std::max_element(index_target.begin(), index_target.end()));
  EXPECT_EQ(0, *std::min_element(index_target.begin(), index_target.end()));
  c = make_case(step, index_target);
  EXPECT_EQ(index_target, c.index);
  const Seamless_map map = map_of(c);
  EXPECT_EQ(std::vector<Map_status>{ Map_status::CERTIFIED }, map.status);
  expect_valid(c, map);
  EXPECT_FALSE(propose_index_targets(c.surface, c.surface.patches[0], c.alpha, c.rho, c.matching, c.index,
                                     index_target));
}

TEST(Seamless_map, knows_that_a_torus_with_one_pair_has_none)
{
  Case c = make_case(torus_with_one_pair());
  EXPECT_EQ(Map_status::ONE_PAIR_ON_TORUS, map_of(c).status[0]);
  // With any other indices it may have one: this test is of the knowledge alone.
  const int first = static_cast<int>(std::find(c.index.begin(), c.index.end(), 1) - c.index.begin());
  ++c.index[first];
  EXPECT_EQ(-1, one_pair_on_torus(c.surface, c.surface.patches[0], c.index)[0]);
  --c.index[first];
  ++c.index[first == 0 ? 1 : 0];
  EXPECT_EQ(-1, one_pair_on_torus(c.surface, c.surface.patches[0], c.index)[0]);
  EXPECT_EQ(-1, one_pair_on_torus(c.surface, c.surface.patches[0], make_case(torus()).index)[0]);
}

struct Repaired_case
{
  Case c;
  Seamless_map map;
  std::vector<int> cancelled_pairs;
};

// Of the field that the soup asks for, but the repair is free.
Repaired_case repaired_case(const Soup& soup, const bool is_allowed)
{
  Repaired_case result;
  result.c = make_case(soup);
  Cut_surface& surface = result.c.surface;
  Options options = options_from(CGAL::parameters::default_values());
  No_clock clock;
  Frame_field field;
  const Eigen_frame_field_solver_traits solver_traits;
  EXPECT_EQ(CGAL::Frame_fields::OK,
            compute_frame_field<CGAL::Sequential_tag>(surface, options, solver_traits, clock, field).error_code);
  surface.index_target.clear();
  options.repair_matching = is_allowed;
  result.cancelled_pairs = compute_seamless_map_and_repair_field<CGAL::Sequential_tag>(
    surface, options, result.c.target_length, solver_traits, field, result.map);
  const Leaning_frames frames = leaning_frames(field);
  result.c.alpha = frames.alpha;
  result.c.rho = frames.rho;
  result.c.matching = field.matching;
  result.c.index = field.index;
  return result;
}

TEST(Seamless_map, cancels_pairs_that_exclude_it)
{
  for(const Soup& soup : { tube(1, false), tube(2, false), torus_with_one_pair() })
  {
    const Repaired_case repaired = repaired_case(soup, true);
    EXPECT_EQ(std::vector<int>{ 1 }, repaired.cancelled_pairs);
    ASSERT_EQ(std::vector<Map_status>{ Map_status::CERTIFIED }, repaired.map.status);
    expect_valid(repaired.c, repaired.map);
    EXPECT_EQ(std::vector<int>(repaired.c.index.size(), 0), repaired.c.index);

    const Repaired_case kept = repaired_case(soup, false);
    EXPECT_EQ(std::vector<int>{ 0 }, kept.cancelled_pairs);
    EXPECT_NE(Map_status::CERTIFIED, kept.map.status[0]);
    EXPECT_EQ(1, std::count(kept.c.index.begin(), kept.c.index.end(), 1));
  }
}

// Beside one another.
Soup both(Soup first, const Soup& second)
{
  const int shift = static_cast<int>(first.points.size());
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for(const std::array<int, 3>& t : second.triangles)
    first.triangles.push_back({ { t[0] + shift, t[1] + shift, t[2] + shift } });
  for(const Edge& e : second.features)
    first.features.insert({ e.first + shift, e.second + shift });
  for(const auto& [vertex, index] : second.index_of_vertex)
    first.index_of_vertex[vertex + shift] = index;
  return first;
}

TEST(Seamless_map, cancels_pairs_in_one_patch_of_many)
{
  const Repaired_case repaired = repaired_case(both(cube(false), both(tube(1, false), cube(true))), true);
  EXPECT_EQ(1, std::count(repaired.cancelled_pairs.begin(), repaired.cancelled_pairs.end(), 1));
  EXPECT_EQ(std::vector<Map_status>(repaired.cancelled_pairs.size(), Map_status::CERTIFIED), repaired.map.status);
  expect_valid(repaired.c, repaired.map);
}

TEST(Seamless_map, leaves_fields_alone_that_have_one)
{
  const Repaired_case repaired = repaired_case(cube(false), true);
  EXPECT_EQ(std::vector<int>{ 0 }, repaired.cancelled_pairs);
  EXPECT_EQ(make_case(cube(false)).index, repaired.c.index);
}

// The distances along edges by relaxing all of them until nothing changes.
std::vector<double> distances_from(const Case& c, const int start)
{
  std::vector<double> result(c.index.size(), 1e9);
  result[start] = 0;
  for(bool has_changed = true; has_changed; )
  {
    has_changed = false;
    for(int h = 0; h < c.surface.number_of_halfedges(); ++h)
      for(const bool is_forward : { true, false })
      {
        const int from = c.surface.sector[is_forward ? previous_of(h) : h];
        const int to = c.surface.sector[is_forward ? h : previous_of(h)];
        if(result[from] + c.surface.length[h] < result[to])
        {
          result[to] = result[from] + c.surface.length[h];
          has_changed = true;
        }
      }
  }
  return result;
}

// Between two convex corners of an L, it is the nearer one that goes with the reflex corner.
TEST(Seamless_map, finds_the_nearest_pair)
{
  const Case c = make_case(l_shape());
  const int reflex = static_cast<int>(std::find(c.index.begin(), c.index.end(), -1) - c.index.begin());
  const std::vector<double> distance = distances_from(c, reflex);
  int number_of_pairs = 0;
  for(int a = 0; a < c.surface.number_of_sectors(); ++a)
    for(int b = 0; b < c.surface.number_of_sectors(); ++b)
      if(c.index[a] == 1 && c.index[b] == 1 && std::abs(distance[a] - distance[b]) > 1e-9)
      {
        const std::array<int, 2> pair = pair_at_side(c.surface, c.surface.patches[0], c.index, { { a, b } });
        EXPECT_EQ(distance[a] < distance[b] ? a : b, pair[0]);
        EXPECT_EQ(reflex, pair[1]);
        ++number_of_pairs;
      }
  EXPECT_GT(number_of_pairs, 5);
}

TEST(Seamless_map, needs_room_for_a_quad_in_each_sector)
{
  Case c = make_case(square());
  c.index[0] = 4;
  EXPECT_EQ(Map_status::WRONG_CONE, map_of(c).status[0]);
}

class Certificate : public testing::Test
{
protected:
  Certificate() : c(make_case(disk())), map(map_of(c)) {}

  Map_status status() const
  {
    const Patch& patch = c.surface.patches[0];
    const Combing combing = comb(c.surface, patch, c.matching, patch.faces.begin_index);
    const Combed_field field(c.surface, patch, c.alpha, c.rho, combing);
    return Map_certificate(c.surface, patch, c.index, [&](const int h) { return field.branch_along(h); }, map).status();
  }

  // The corners of a regular sector, for all of which one chart is valid, with a given number of faces (0: any).
  std::vector<int> corners_in_one_chart(const bool is_constrained, const std::size_t number_of_faces) const
  {
    for(int s = 0; s < c.surface.number_of_sectors(); ++s)
    {
      std::vector<int> corners;
      bool is_one_chart = true;
      for_each_corner(c.surface.opposite, c.surface.first_corner[s], [&](const int h)
      {
        corners.push_back(h);
        is_one_chart = is_one_chart && map.quarter_turns[h] == 0 && map.u[h] == map.u[corners[0]]
                    && map.v[h] == map.v[corners[0]];
      });
      if(is_one_chart && c.index[s] == 0 && c.surface.is_constrained_sector(s) == is_constrained
         && (number_of_faces == 0 || corners.size() == number_of_faces))
        return corners;
    }
    ADD_FAILURE() << "no such sector";
    return {};
  }

  Case c;
  Seamless_map map;
};

TEST_F(Certificate, holds_for_the_map) { EXPECT_EQ(Map_status::CERTIFIED, status()); }

// Two faces vanish, none is inverted.
TEST_F(Certificate, refuses_faces_without_area)
{
  const std::vector<int> corners = corners_in_one_chart(false, 3);
  const std::int64_t u = map.u[next_of(corners[0])], v = map.v[next_of(corners[0])];
  for(const int h : corners)
  {
    map.u[h] = u;
    map.v[h] = v;
  }
  EXPECT_EQ(Map_status::INVERTED_FACE, status());
}

TEST_F(Certificate, refuses_constrained_edges_off_the_axes)
{
  for(const int h : corners_in_one_chart(true, 0))
  {
    ++map.u[h];
    ++map.v[h];
  }
  EXPECT_EQ(Map_status::REVERSED_EDGE, status());
}

TEST_F(Certificate, refuses_an_inverted_face)
{
  for(std::int64_t& u : map.u)
    u = -u;
  EXPECT_EQ(Map_status::INVERTED_FACE, status());
}

TEST_F(Certificate, refuses_one_step_of_the_grid_across_an_edge)
{
  for(std::vector<std::int64_t>* const coordinate : { &map.u, &map.v })
  {
    std::int64_t& value = (*coordinate)[c.surface.dual_edges[5].halfedge];
    ++value;
    EXPECT_EQ(Map_status::REVERSED_EDGE, status());
    --value;
  }
}

// A half turn of all charts is a map as good, but of the field turned by a half turn.
TEST_F(Certificate, refuses_edges_against_their_branches)
{
  for(std::int64_t& u : map.u)
    u = -u;
  for(std::int64_t& v : map.v)
    v = -v;
  EXPECT_EQ(Map_status::REVERSED_EDGE, status());
}

TEST_F(Certificate, refuses_other_indices)
{
  ++c.index[3];
  EXPECT_EQ(Map_status::WRONG_CONE, status());
}

// By central differences, also where faces are inverted.
TEST(Barrier_energy, has_the_gradient_of_its_value)
{
  const Case c = make_case(square());
  const Patch& patch = c.surface.patches[0];
  const Combing combing = comb(c.surface, patch, c.matching, patch.faces.begin_index);
  const Cut_graph graph = Patch_cutter(c.surface, patch, c.index, combing).cut();
  const Combed_field field(c.surface, patch, c.alpha, c.rho, combing);
  const Map_basis basis(c.surface, patch, c.index, graph, field);
  const Map_elements elements(c.surface, patch, field, graph, c.target_length, basis.side_edges());
  Barrier_energy energy(elements);
  energy.set_epsilon(0.5);
  std::mt19937 generator(5);
  std::vector<double> x(2 * (1 + *std::max_element(graph.vertex.begin(), graph.vertex.end()))), gradient, other;
  for(double& coordinate : x)
    coordinate = 4 * (generator() / 4294967296.);
  energy(x, gradient);
  EXPECT_LT(energy.least(), 0);
  for(std::size_t i = 0; i < x.size(); ++i)
  {
    const double here = x[i], step = 1e-5;
    x[i] = here + step;
    const double ahead = energy(x, other);
    x[i] = here - step;
    const double behind = energy(x, other);
    x[i] = here;
    EXPECT_NEAR((ahead - behind) / (2 * step), gradient[i], 1e-4 * (1 + std::abs(gradient[i]))) << i;
  }
}

TEST(Sign_of_determinant, is_exact)
{
  std::mt19937_64 generator(3);
  for(int i = 0; i < 1000; ++i)
  {
    const auto number = [&] { return static_cast<std::int64_t>(generator() % (1ull << 55)) - (1ll << 54); };
    const std::int64_t a = number(), b = number(), k = static_cast<std::int64_t>(generator() % 63) - 31;
    const int sign = a > 0 ? 1 : a < 0 ? -1 : 0;
    EXPECT_EQ(0, sign_of_determinant(a, b, k * a, k * b));
    EXPECT_EQ(sign, sign_of_determinant(a, b, k * a, k * b + 1));
    EXPECT_EQ(-sign, sign_of_determinant(a, b, k * a, k * b - 1));
    const std::int64_t c = number(), d = number();
    const long double determinant = static_cast<long double>(a) * d - static_cast<long double>(b) * c;
    if(std::abs(determinant) > 1e18L)
    {
      EXPECT_EQ(determinant > 0 ? 1 : -1, sign_of_determinant(a, b, c, d));
    }
  }
}

std::int64_t minor_of(const std::vector<std::vector<std::int64_t> >& rows, const std::vector<int>& chosen)
{
  const std::size_t n = chosen.size();
  std::vector<int> permutation(n);
  std::iota(permutation.begin(), permutation.end(), 0);
  std::int64_t sum = 0;
  do
  {
    std::int64_t product = 1;
    for(std::size_t i = 0; i < n; ++i)
    {
      product *= rows[chosen[i]][permutation[i]];
      for(std::size_t j = 0; j < i; ++j)
        product *= permutation[j] > permutation[i] ? -1 : 1;
    }
    sum += product;
  } while(std::next_permutation(permutation.begin(), permutation.end()));
  return sum;
}

// The integer solutions of a system are exactly the integer combinations of the columns of B if its rows solve the
// system, and its largest minors have no common factor.
TEST(Integer_relations, give_all_integer_solutions)
{
  std::mt19937 generator(11);
  for(int trial = 0; trial < 500; ++trial)
  {
    const int number_of_variables = 5, number_of_rows = 1 + trial % 3;
    std::vector<Integer_row> system;
    Integer_relations relations(std::vector<int>(number_of_variables, 1));
    for(int r = 0; r < number_of_rows; ++r)
    {
      Integer_row row;
      for(int variable = 0; variable < number_of_variables; ++variable)
        row.push_back({ variable, static_cast<std::int64_t>(generator() % 13) - 6 });
      system.push_back(row);
      relations.add(row);
    }
    ASSERT_FALSE(relations.has_overflow());

    std::map<int, int> column;
    std::vector<Integer_row> reduced;
    for(int variable = 0; variable < number_of_variables; ++variable)
    {
      reduced.push_back(relations.reduced({ { variable, 1 } }));
      for(const Integer_term& term : reduced.back())
      {
        EXPECT_TRUE(relations.is_free(term.variable));
        column.insert({ term.variable, static_cast<int>(column.size()) });
      }
    }
    const int dimension = static_cast<int>(column.size());
    std::vector<std::vector<std::int64_t> > b(number_of_variables, std::vector<std::int64_t>(dimension, 0));
    for(int variable = 0; variable < number_of_variables; ++variable)
      for(const Integer_term& term : reduced[variable])
        b[variable][column[term.variable]] = term.coefficient;

    for(const Integer_row& row : system)
      for(int k = 0; k < dimension; ++k)
      {
        std::int64_t sum = 0;
        for(const Integer_term& term : row)
          sum += term.coefficient * b[term.variable][k];
        ASSERT_EQ(0, sum);
      }
    ASSERT_GE(dimension, number_of_variables - number_of_rows);
    std::int64_t common_factor = 0;
    for(int subset = 0; subset < 1 << number_of_variables; ++subset)
    {
      std::vector<int> chosen;
      for(int variable = 0; variable < number_of_variables; ++variable)
        if(subset >> variable & 1)
          chosen.push_back(variable);
      if(static_cast<int>(chosen.size()) == dimension)
        common_factor = std::gcd(common_factor, minor_of(b, chosen));
    }
    ASSERT_EQ(1, common_factor);
  }
}

} // namespace
