// What each stage claims to compute, on arrays made by hand and against other ways to compute it.

#include <CGAL/Frame_fields/Eigen_frame_field_solver_traits.h>
#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/No_index_target.h>
#include <CGAL/Frame_fields/frame_field_from_vectors.h>
#include <CGAL/Frame_fields/internal/field/Hub_rings.h>
#include <CGAL/Frame_fields/internal/field/local_feature_length.h>
#include <CGAL/Frame_fields/internal/field/relaxation.h>
#include <CGAL/Frame_fields/internal/field/rotation_demand.h>
#include <CGAL/Frame_fields/internal/field/stages.h>
#include <CGAL/Frame_fields/internal/field/vanishing_values.h>
#include <CGAL/Frame_fields/internal/linear/assemble.h>
#include <CGAL/Frame_fields/internal/linear/smallest_eigenvector.h>
#include <CGAL/Frame_fields/internal/named_parameters/options.h>
#include <CGAL/Frame_fields/internal/streamlines/Branch_directions.h>
#include <CGAL/Frame_fields/internal/streamlines/Face_neighborhood.h>
#include <CGAL/Frame_fields/internal/streamlines/Streamline_distances.h>
#include <CGAL/Frame_fields/internal/streamlines/evenly_spaced_streamlines.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Face_charts.h>
#include <CGAL/Frame_fields/internal/surface/Geodesic_ball.h>
#include <CGAL/Frame_fields/internal/surface/Geodesic_distances.h>
#include <CGAL/Frame_fields/internal/surface/Sector_rings.h>
#include <CGAL/Frame_fields/internal/surface/collect_dual_edges.h>
#include <CGAL/Frame_fields/internal/surface/collect_sectors.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>
#include <CGAL/Frame_fields/internal/surface/weights.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace FF = CGAL::Frame_fields;
using namespace FF::internal;

typedef std::vector<Coordinates> Points;
typedef std::vector<std::array<int, 3> > Triangles;

// A surface whose borders are its constrained edges, in one patch. Halfedge k of a face ends at its vertex k.
struct Test_surface : Cut_surface
{
  std::vector<int> vertex; // per halfedge: at its target

  // The edge between the vertices 0 and 1 is constrained, too, if `is_slit`.
  Test_surface(const Points& points, const Triangles& triangles,
               const FF::Edge_weighting weighting = FF::Edge_weighting::UNIFORM, const bool is_slit = false)
  {
    std::map<std::pair<int, int>, int> halfedge_between;
    for(const std::array<int, 3>& t : triangles)
      for(int k = 0; k < 3; ++k)
      {
        halfedge_between[{ t[(k + 2) % 3], t[k] }] = static_cast<int>(vertex.size());
        vertex.push_back(t[k]);
      }
    for(std::size_t h = 0; h < vertex.size(); ++h)
    {
      const auto other = halfedge_between.find({ vertex[h], vertex[previous_of(static_cast<int>(h))] });
      const bool is_in_slit = is_slit && vertex[h] + vertex[previous_of(static_cast<int>(h))] == 1;
      opposite.push_back(other == halfedge_between.end() || is_in_slit ? -1 : other->second);
    }
    for(const std::array<int, 3>& t : triangles)
    {
      const std::array<Coordinates, 3> p{ points[t[0]], points[t[1]], points[t[2]] };
      for(const double a : corner_angles(p))
        angle.push_back(a);
      for(int k = 0; k < 3; ++k)
        length.push_back(distance(p[(k + 2) % 3], p[k]));
    }
    patches = { Patch{ { 0, static_cast<int>(triangles.size()) }, { 0, 0 }, { 0, 0 } } };
    collect_sectors<CGAL::Sequential_tag>(*this);
    collect_dual_edges<CGAL::Sequential_tag>(*this, weighting);
    align_with_constrained_edges(*this);
  }

  int sector_of(const int v) const
  {
    return sector[std::find(vertex.begin(), vertex.end(), v) - vertex.begin()];
  }
};

// The image of a grid of m x n cells; vertex i + j (m + 1) is at (i, j).
template <typename Position>
Test_surface grid(const int m, const int n, const Position& position,
                  const FF::Edge_weighting weighting = FF::Edge_weighting::UNIFORM)
{
  Points points;
  Triangles triangles;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= m; ++i)
      points.push_back(position(i, j));
  const auto at = [m](const int i, const int j) { return i + j * (m + 1); };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < m; ++i)
      if((i < m / 2) == (j < n / 2)) // no corner has two constrained edges in one triangle
      {
        triangles.push_back({ { at(i, j), at(i + 1, j), at(i + 1, j + 1) } });
        triangles.push_back({ { at(i, j), at(i + 1, j + 1), at(i, j + 1) } });
      }
      else
      {
        triangles.push_back({ { at(i, j), at(i + 1, j), at(i, j + 1) } });
        triangles.push_back({ { at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) } });
      }
  return Test_surface(points, triangles, weighting);
}

// A star of random tips with rough inner rings around vertex 0.
Test_surface random_star(std::mt19937& generator, const int number_of_tips, const FF::Edge_weighting weighting)
{
  std::uniform_real_distribution<double> unit(0, 1);
  const int rings = 3, per_side = 3, n = 2 * number_of_tips * per_side;
  std::vector<double> radius;
  for(int i = 0; i < 2 * number_of_tips; ++i)
    radius.push_back(i % 2 == 1 ? 0.8 + 0.3 * unit(generator) : 1 + 6 * unit(generator) * unit(generator));
  Points points{ { 0, 0, 0 } };
  for(int k = 1; k <= rings; ++k)
    for(int t = 0; t < n; ++t)
    {
      const int side = t / per_side;
      const double f = static_cast<double>(t % per_side) / per_side, s = static_cast<double>(k) / rings;
      const double a = CGAL_PI * side / number_of_tips, b = CGAL_PI * (side + 1) / number_of_tips;
      const double r = radius[side], q = radius[(side + 1) % (2 * number_of_tips)];
      points.push_back({ s * ((1 - f) * r * std::cos(a) + f * q * std::cos(b)),
                         s * ((1 - f) * r * std::sin(a) + f * q * std::sin(b)),
                         k < rings ? 0.15 * unit(generator) : 0 });
    }
  const auto at = [n](const int ring, const int t) { return 1 + (ring - 1) * n + t % n; };
  Triangles triangles;
  for(int t = 0; t < n; ++t)
  {
    triangles.push_back({ { 0, at(1, t), at(1, t + 1) } });
    for(int k = 1; k < rings; ++k)
    {
      triangles.push_back({ { at(k, t), at(k + 1, t), at(k + 1, t + 1) } });
      triangles.push_back({ { at(k, t), at(k + 1, t + 1), at(k, t + 1) } });
    }
  }
  return Test_surface(points, triangles, weighting);
}

std::vector<double> random_aligned_field(const Cut_surface& surface, std::mt19937& generator)
{
  std::uniform_real_distribution<double> angle(-CGAL_PI / 4, CGAL_PI / 4);
  std::vector<double> alpha;
  for(int f = 0; f < surface.number_of_faces(); ++f)
    alpha.push_back(surface.is_aligned(f) ? std::remainder(surface.alignment[f], CGAL_PI / 2) : angle(generator));
  return alpha;
}

Options options_with(const FF::Edge_weighting weighting)
{
  Options options = options_from(CGAL::parameters::default_values());
  options.edge_weighting = weighting;
  return options;
}

// By how much sum w (r - omega)^2 falls if an index of 1/4 goes around a cycle of sectors, by the algorithm of Bellman
// and Ford; 0 if there is no such cycle.
double gain_of_a_cycle(const Cut_surface& surface, const std::vector<double>& alpha, const std::vector<int>& matching)
{
  std::vector<double> distance(surface.number_of_sectors(), 0);
  double change = 0;
  for(int round = 0; round <= surface.number_of_sectors(); ++round)
  {
    change = 0;
    for(int e = 0; e < surface.number_of_dual_edges(); ++e)
    {
      const Dual_edge& d = surface.dual_edges[e];
      const double r = alpha[face_of(d.opposite)] - alpha[face_of(d.halfedge)] + surface.transport[e]
                     + matching[e] * CGAL_PI / 2;
      const auto relax = [&](const int from, const int to, const double new_r)
      {
        const double cost = surface.weight[e] * (new_r * new_r - r * r);
        if(distance[from] + cost < distance[to] - 1e-9)
        {
          change = (std::max)(change, distance[to] - distance[from] - cost);
          distance[to] = distance[from] + cost;
        }
      };
      const int i = surface.sector[d.halfedge], j = surface.sector[d.opposite];
      relax(i, j, r - CGAL_PI / 2);
      relax(j, i, r + CGAL_PI / 2);
    }
    if(change == 0)
      return 0;
  }
  return change;
}

// Matches a random field on a random star and expects that no cycle is left along which it could be improved. Returns
// the number of sectors whose index was changed.
std::size_t expect_cheapest_matching(const Cut_surface& surface, const FF::Edge_weighting weighting,
                                     std::mt19937& generator, std::vector<int>& index)
{
  const std::vector<double> alpha = random_aligned_field(surface, generator);
  const std::vector<double> omega(surface.number_of_dual_edges(), 0);
  std::vector<int> matching, index_of_matching;
  std::vector<Repaired_sector> repaired;
  EXPECT_EQ(FF::OK, compute_matching_and_indices<CGAL::Sequential_tag>(surface, omega, alpha, options_with(weighting),
                                                                       matching, index, repaired).error_code);
  EXPECT_EQ(0, gain_of_a_cycle(surface, alpha, matching));
  EXPECT_EQ(FF::OK,
            compute_indices<CGAL::Sequential_tag>(surface, alpha, matching, index_of_matching).error_code);
  EXPECT_EQ(index_of_matching, index);
  return repaired.size();
}

TEST(Repair, moves_indices_at_least_cost_and_makes_sharp_corners_natural)
{
  std::mt19937 generator(11);
  std::size_t number_of_changes = 0;
  for(int i = 0; i < 40; ++i)
  {
    const auto weighting = i % 2 == 0 ? FF::Edge_weighting::UNIFORM : FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH;
    const Test_surface surface = random_star(generator, 3 + i % 9, weighting);
    std::vector<int> index;
    number_of_changes += expect_cheapest_matching(surface, weighting, generator, index);
    for(int s = 0; s < surface.number_of_sectors(); ++s)
    {
      if(surface.is_constrained_sector(s) && surface.total_angle[s] < 0.749 * CGAL_PI)
      {
        EXPECT_EQ(1, index[s]) << i;
      }
    }
  }
  EXPECT_LT(200u, number_of_changes);
}

// A polygon of n corners around m vertices inside, which are corners of a polygon, too, or of a hole. Every second
// corner of the outer one has the given angle.
Test_surface polygon_around(const int m, const int n, const double tip_angle, const bool has_hole = false)
{
  const double tangent = std::tan(tip_angle / 2), turn = 2 * CGAL_PI / n;
  const double radius_between_tips = tangent / (std::sin(turn) + tangent * std::cos(turn));
  Points points;
  Triangles triangles;
  for(int j = 0; j < m; ++j)
    points.push_back({ 0.4 * std::cos(2 * CGAL_PI * (j + 0.5) / m), 0.4 * std::sin(2 * CGAL_PI * (j + 0.5) / m), 0 });
  for(int i = 0; i < n; ++i)
  {
    const double radius = i % 2 == 0 ? 1 : radius_between_tips;
    points.push_back({ radius * std::cos(turn * i), radius * std::sin(turn * i), 0 });
    triangles.push_back({ { i * m / n, m + i, m + (i + 1) % n } });
  }
  for(int j = 0; j < m; ++j)
    triangles.push_back({ { j, m + (j + 1) * (n / m) % n, (j + 1) % m } });
  for(int j = 2; j < m && !has_hole; ++j)
    triangles.push_back({ { 0, j - 1, j } });
  return Test_surface(points, triangles);
}

struct Repair_of_polygon
{
  std::vector<int> rounded_index, index;
};

Repair_of_polygon repair_of_polygon(const Test_surface& surface, const double largest_omega, std::mt19937& generator)
{
  std::uniform_real_distribution<double> any(-largest_omega, largest_omega);
  std::vector<double> omega;
  for(int e = 0; e < surface.number_of_dual_edges(); ++e)
    omega.push_back(any(generator));
  std::vector<int> matching;
  std::vector<Repaired_sector> repaired;
  Repair_of_polygon result;
  EXPECT_EQ(FF::OK, compute_matching_and_indices<CGAL::Sequential_tag>(
                      surface, omega, random_aligned_field(surface, generator),
                      options_with(FF::Edge_weighting::UNIFORM), matching, result.index, repaired).error_code);
  result.rounded_index = result.index;
  for(const Repaired_sector& sector : repaired)
    result.rounded_index[sector.sector] = sector.rounded_index;
  return result;
}

// Between a regular polygon and a triangular hole there are three quarters too much for natural sectors and no sectors
// inside: the corners of the polygon take one each.
TEST(Repair, leaves_no_corner_unmeshable_where_there_is_no_room_inside)
{
  std::mt19937 generator(17);
  const Test_surface surface = polygon_around(3, 12, 150 * CGAL_PI / 180, true);
  int number_of_unmeshable_ones = 0;
  for(int i = 0; i < 100; ++i)
  {
    const Repair_of_polygon repair = repair_of_polygon(surface, 2, generator);
    for(int s = 0; s < surface.number_of_sectors(); ++s)
    {
      number_of_unmeshable_ones += repair.rounded_index[s] > 1;
      EXPECT_LE(repair.index[s], 1) << i;
    }
  }
  EXPECT_GT(number_of_unmeshable_ones, 20);
}

// Two triangles glued along two sides: a pillow whose third side is constrained, with one sector inside. Together they
// have 4, and the sector inside takes 1 as long as there is room elsewhere.
TEST(Repair, keeps_sectors_on_constrained_edges_natural_where_there_is_no_room_for_all)
{
  std::mt19937 generator(19);
  int number_of_unnatural_ones = 0, number_of_large_ones = 0;
  for(const double height : { 0.3, 0.9, 3. })
  {
    const Test_surface surface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, height, 0 } }, { { { 0, 1, 2 } }, { { 1, 0, 2 } } },
                               FF::Edge_weighting::UNIFORM, true);
    for(int i = 0; i < 100; ++i)
    {
      const Repair_of_polygon repair = repair_of_polygon(surface, 5, generator);
      int too_much = 0, room = 0, left = 0;
      for(int s = 0; s < surface.number_of_sectors(); ++s)
      {
        const int rounded = repair.rounded_index[s];
        if(!surface.is_constrained_sector(s))
        {
          room += (std::max)(0, 1 - rounded);
          number_of_large_ones += rounded > 1;
          continue;
        }
        EXPECT_LE(repair.index[s], 1) << height;
        too_much += (std::max)(0, rounded - natural_index(surface, s));
        room += (std::max)(0, natural_index(surface, s) - rounded);
        left += (std::max)(0, repair.index[s] - natural_index(surface, s));
      }
      EXPECT_LE(left, (std::max)(0, too_much - room)) << height;
      number_of_unnatural_ones += too_much > 0;
    }
  }
  EXPECT_GT(number_of_unnatural_ones, 50);
  EXPECT_GT(number_of_large_ones, 50);
}

// The tips take one quarter each, and what they take is missing inside, the same everywhere but for one quarter.
TEST(Repair, takes_evenly_from_the_sectors_inside)
{
  std::mt19937 generator(18);
  int number_of_cases = 0;
  for(const int n : { 16, 20, 24 })
    for(int i = 0; i < 40; ++i)
    {
      const Test_surface surface = polygon_around(4, n, 112 * CGAL_PI / 180);
      const Repair_of_polygon repair = repair_of_polygon(surface, 0.3, generator);
      int least = 9, largest = -9, least_rounded = 0;
      for(int s = 0; s < surface.number_of_sectors(); ++s)
        if(surface.is_constrained_sector(s))
        {
          EXPECT_EQ(natural_index(surface, s), repair.index[s]) << n;
        }
        else
        {
          least = (std::min)(least, repair.index[s]);
          largest = (std::max)(largest, repair.index[s]);
          least_rounded = (std::min)(least_rounded, repair.rounded_index[s]);
        }
      if(least_rounded < -1)
        continue; // that stays there
      ++number_of_cases;
      EXPECT_LE(largest - least, n == 20 ? 1 : 0) << n; // n / 2 - 4 quarters for 4 sectors
    }
  EXPECT_GT(number_of_cases, 30);
}

// Many paths run across each other here: every singularity of a random field goes to the middle.
TEST(Index_targets, are_met_at_least_cost)
{
  std::mt19937 generator(16);
  for(int i = 0; i < 20; ++i)
  {
    const auto weighting = i % 2 == 0 ? FF::Edge_weighting::UNIFORM : FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH;
    Test_surface surface = random_star(generator, 3 + i % 9, weighting);
    surface.index_target.assign(surface.number_of_sectors(), FF::NO_INDEX_TARGET);
    int& target = surface.index_target[surface.sector_of(0)];
    target = 0;
    target = static_cast<int>(missing_index(surface, surface.patches[0]));
    std::vector<int> index;
    EXPECT_LT(10u, expect_cheapest_matching(surface, weighting, generator, index));
    for(int s = 0; s < surface.number_of_sectors(); ++s)
      EXPECT_EQ(target_of_sector(surface, s), index[s]);
  }
}

TEST(Opposite_halfedges, are_checked)
{
  EXPECT_EQ(-1, inconsistent_halfedge({ -1, 3, -1, 1, -1, -1 }));
  EXPECT_EQ(0, inconsistent_halfedge({ 0, -1, -1 }));
  EXPECT_EQ(1, inconsistent_halfedge({ -1, 3, -1, 2, -1, -1 }));
  EXPECT_EQ(0, inconsistent_halfedge({ 3, 3, -1, 1, -1, -1 }));
}

TEST(Edge_weight, is_1_between_equilateral_triangles)
{
  const double h = std::sqrt(3.) / 2;
  const Test_surface surface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, h, 0 }, { 0.5, -h, 0 } },
                             { { { 0, 1, 2 } }, { { 1, 0, 3 } } }, FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH);
  ASSERT_EQ(1u, surface.weight.size());
  EXPECT_NEAR(1, surface.weight[0], 1e-12);
}

TEST(Guide_weight, is_an_integral_with_geometric_weights)
{
  for(const double size : { 1., 3. })
  {
    Test_surface surface({ { 0, 0, 0 }, { size, 0, 0 }, { 0, size, 0 } }, { { { 0, 1, 2 } } },
                         FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH);
    surface.guide_weight = { 0.7 };
    EXPECT_NEAR(0.7 * size * size / 2 / std::sqrt(3.), guide_weight(surface, 0), 1e-12);
    surface.edge_weighting = FF::Edge_weighting::UNIFORM;
    EXPECT_EQ(0.7, guide_weight(surface, 0));
  }
}

TEST(Orthogonality_length, is_a_quarter_of_the_square_root_of_the_area_by_default)
{
  const Test_surface surface = grid(2, 2, [](const int i, const int j) -> Coordinates { return { 3. * i, 2. * j, 0 }; },
                                    FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH);
  const Options options = options_with(FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH);
  const double length = std::sqrt(24.) / 4, face_area = 3;
  EXPECT_NEAR(face_area / (std::sqrt(3.) * length * length),
              Orthogonality(surface, surface.patches[0], options).weight(0), 1e-12);
}

// The integrals of the hat functions over the polygon that is left of a triangle of area 1.
std::array<double, 3> clipped_hat_integrals(const std::array<double, 3>& values, const double bound)
{
  std::vector<std::array<double, 3> > polygon; // barycentric coordinates
  for(int k = 0; k < 3; ++k)
  {
    const int n = (k + 1) % 3;
    std::array<double, 3> corner{ 0, 0, 0 };
    corner[k] = 1;
    if(values[k] <= bound)
      polygon.push_back(corner);
    if((values[k] <= bound) != (values[n] <= bound))
    {
      std::array<double, 3> crossing{ 0, 0, 0 };
      crossing[n] = (bound - values[k]) / (values[n] - values[k]);
      crossing[k] = 1 - crossing[n];
      polygon.push_back(crossing);
    }
  }
  std::array<double, 3> result{ 0, 0, 0 };
  for(std::size_t i = 2; i < polygon.size(); ++i)
  {
    const auto &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const double area = std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    for(int k = 0; k < 3; ++k)
      result[k] += area * (a[k] + b[k] + c[k]) / 3;
  }
  return result;
}

TEST(Hat_integrals, are_those_over_the_clipped_triangle)
{
  std::mt19937 generator(12);
  std::uniform_real_distribution<double> unit(0, 1);
  for(int i = 0; i < 1000; ++i)
  {
    const std::array<double, 3> values{ unit(generator), unit(generator), unit(generator) };
    const double bound = unit(generator);
    const std::array<double, 3> expected = clipped_hat_integrals(values, bound);
    const std::array<double, 3> integrals = hat_integrals_below(values, bound);
    for(int k = 0; k < 3; ++k)
      EXPECT_NEAR(expected[k], integrals[k], 1e-12);
  }
}

// Where all angles are acute, no distance is lowered after the visit.
TEST(Geodesic_front, visits_sectors_of_a_flat_patch_at_their_distances)
{
  std::mt19937 generator(13);
  std::uniform_real_distribution<double> shift(-0.08, 0.08);
  const int n = 12;
  Points points;
  Triangles triangles;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
    {
      const double x = i + (i % n != 0 && j % n != 0 ? shift(generator) : 0);
      const double y = j + (i % n != 0 && j % n != 0 ? shift(generator) : 0);
      points.push_back({ x + y / 2, y * std::sqrt(3.) / 2, 0 });
      const int here = i + j * (n + 1);
      if(i < n && j < n)
        triangles.push_back({ { here, here + 1, here + n + 1 } });
      if(i > 0 && j > 0)
        triangles.push_back({ { here, here - 1, here - n - 1 } });
    }
  const Test_surface surface(points, triangles);
  for(const int source : { 0, n / 2 + n / 2 * (n + 1), n })
  {
    std::map<int, double> reported;
    Geodesic_distances distances(surface, surface.patches[0]);
    distances.walk_from(surface.sector_of(source), [&](const int sector, const double d)
    {
      reported[sector] = d;
      return true;
    });
    for(std::size_t v = 0; v < points.size(); ++v)
      EXPECT_NEAR(distance(points[source], points[v]), reported[surface.sector_of(static_cast<int>(v))], 1e-9)
        << source << ' ' << v;
  }
}

TEST(Local_feature_length, is_half_the_shorter_curve)
{
  for(const bool swaps : { false, true })
  {
    const Test_surface surface = grid(4, 4, [&](const int i, const int j) -> Coordinates
      { return { (swaps ? 1. : 3.) * i / 4, (swaps ? 3. : 1.) * j / 4, 0 }; });
    EXPECT_NEAR(0.5, local_feature_length(surface, surface.sector_of(0)), 1e-12);
  }
}

// A strip of width 1 with a tapered end: it fills four fifths of the wedge of its tip up to 1.809 / angle.
TEST(Ball_in_wedge, ends_where_the_patch_fills_less_than_four_fifths)
{
  const double angle = 0.1;
  const int n = 400, m = 4;
  const Test_surface surface = grid(n, m, [&](const int i, const int j) -> Coordinates
  {
    const double x = 1e-3 + 60. * i / n;
    return { x, (std::min)(1., angle * x) * (static_cast<double>(j) / m - 0.5), 0 };
  });
  Geodesic_distances distances(surface, surface.patches[0]);
  Geodesic_ball ball(surface, distances);
  Cut_surface& cut = const_cast<Test_surface&>(surface);
  const int tip = surface.sector_of(m / 2 * (n + 1));
  cut.total_angle[tip] = angle; // the tip is cut off by a thousandth
  double area = 0;
  for(const Sector_share& share : ball.shares_in_wedge(tip, 55))
    area += share.area;
  const double radius = 1.809 / angle;
  EXPECT_NEAR(0.8 * angle * radius * radius / 2, area, 0.05 * area);
}

TEST(Smallest_eigenvector, is_found_on_a_long_ring)
{
  typedef std::complex<double> Complex;
  const int n = 200;
  const double twist = 2; // less than pi: the smallest eigenvector turns evenly
  const FF::Hermitian_matrix<Complex> matrix = assemble<Complex>(n, [&](const auto& add)
  {
    for(int i = 0; i < n; ++i)
    {
      add(i, i, Complex(2));
      add(i, (i + 1) % n, -std::polar(1., twist / n));
    }
  });
  std::mt19937 generator(14);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Complex> start, z;
  for(int i = 0; i < n; ++i)
    start.push_back({ unit(generator), unit(generator) });
  auto solver = FF::Eigen_frame_field_solver_traits().complex_solver_object();
  ASSERT_TRUE(smallest_eigenvector(solver, matrix, start, z));
  for(int i = 0; i < n; ++i)
    EXPECT_NEAR(1 / std::sqrt(1. * n), std::abs(z[i]), 1e-6);
}

// A field of which only the values of two neighbors vanish.
struct Field_without_anchor
{
  const Cut_surface& surface;

  bool is_anchored() const { return false; }
  int unknown(const int face) const { return face; }
  Complex transport(const int e) const { return std::polar(1., 4 * surface.transport[e]); }
};

// The sum of the fourth powers of the sides of a triangle as complex numbers, divided by those of its circumdiameter.
Complex mean_of_sides(const Cut_surface& surface, const int face)
{
  Complex sum = 0;
  for(int h = 3 * face; h < 3 * face + 3; ++h)
    sum += std::pow(std::polar(std::sin(surface.angle[next_of(h)]), halfedge_angle(surface, h)), 4);
  return sum;
}

TEST(Vanishing_values, of_neighbors_get_the_mean_direction_of_their_sides)
{
  std::mt19937 generator(20);
  const Test_surface surface = random_star(generator, 7, FF::Edge_weighting::UNIFORM);
  for(int e = 0; e < surface.number_of_dual_edges(); ++e)
  {
    const int i = face_of(surface.dual_edges[e].halfedge), j = face_of(surface.dual_edges[e].opposite);
    std::vector<Complex> z(surface.number_of_faces(), 1);
    z[i] = z[j] = 0;
    const Field_without_anchor field{ surface };
    Field_without_zeros<Field_without_anchor>(surface, surface.patches[0], field, {}, z).replace_vanishing_values();
    const Complex mean = mean_of_sides(surface, i) + field.transport(e) * mean_of_sides(surface, j);
    EXPECT_LT(std::abs(z[i] - mean), 1e-12) << e;
    EXPECT_LT(std::abs(field.transport(e) * z[j] - mean), 1e-12) << e;
  }
}

TEST(Nearest_matching, turns_the_branches_least)
{
  std::mt19937 generator(15);
  std::uniform_real_distribution<double> turn(-8, 8), skewness(-CGAL_PI / 2, CGAL_PI / 2);
  for(int i = 0; i < 20000; ++i)
  {
    const double r = turn(generator), rho_i = skewness(generator), rho_j = skewness(generator);
    const auto energy = [&](const int p) // branch b of i goes to branch b + p of j
    {
      const double r0 = r + p * CGAL_PI / 2 + (p % 2 != 0 ? rho_j : 0);
      const double r1 = r + p * CGAL_PI / 2 - rho_i + (p % 2 == 0 ? rho_j : 0);
      return r0 * r0 + r1 * r1;
    };
    int best = -12;
    for(int p = best; p <= 12; ++p)
      if(energy(p) < energy(best))
        best = p;
    EXPECT_NEAR(energy(best), energy(nearest_matching(r, rho_i, rho_j)), 1e-9);
  }
}

// Both branches point to the edge from (0, 0) to (0, 1): of their mixtures the one without a part across it counts.
TEST(Streamline_tracer, slides_along_an_edge_the_way_that_the_mixture_of_both_sides_goes)
{
  const Test_surface surface({ { 0, 0, 0 }, { 0, 1, 0 }, { -1, 0.5, 0 }, { 1, 0.5, 0 } },
                             { { { 0, 1, 2 } }, { { 1, 0, 3 } } });
  const Face_charts charts(surface);
  const auto angle_in_chart = [&](const int face, const double x, const double y)
  {
    const int h = 3 * face + 1; // between the two vertices at x = 0
    const double along = face == 0 ? y : -y, inward = face == 0 ? -x : x;
    return halfedge_angle(surface, h) + std::atan2(inward, along);
  };
  // From the left a little up and steeply to the edge; from the right down, and hardly to the edge.
  for(const bool is_mirrored : { false, true })
  {
    const double up = is_mirrored ? -1 : 1;
    const std::vector<double> alpha{ angle_in_chart(0, 1, 0.3 * up), angle_in_chart(1, -0.1, -0.9 * up) };
    const Branch_directions directions(surface, alpha, { 0, 0 }, { 0 });
    const Streamline_tracer tracer(charts, directions);
    ASSERT_EQ(0, directions.branch_across(1, 0));
    Streamline_head head{ Streamline_head::INSIDE, -1, 0, 0, { 1. / 3, 1. / 3, 1. / 3 } };
    Streamline_piece piece;
    tracer.advance(head, piece);
    ASSERT_EQ(Streamline_head::TOWARDS_CORNER, head.kind);
    EXPECT_EQ(is_mirrored ? 1 : 0, surface.vertex[head.element]); // 0.1 * 0.3 - 1 * 0.9 < 0
  }
}

TEST(Streamlines, begin_at_nine_tenths_of_the_spacing_from_others)
{
  Points points;
  const Test_surface surface = grid(4, 4, [&](const int i, const int j) -> Coordinates
  {
    points.push_back({ i / 4., j / 4., 0 });
    return points.back();
  });
  const auto place = [&](const int face, const Corner_weights& weights, const int axis)
  {
    double sum = 0;
    for(int k = 0; k < 3; ++k)
      sum += weights[k] * points[surface.vertex[3 * face + k]][axis];
    return sum;
  };
  const Face_charts charts(surface);
  std::vector<double> alpha, rho(surface.number_of_faces(), 0);
  const std::vector<int> matching = [&]
  {
    std::vector<int> result(surface.number_of_dual_edges(), 0);
    for(int f = 0; f < surface.number_of_faces(); ++f) // along the axes
    {
      double axis = 0;
      for(int h = 3 * f; h < 3 * f + 3; ++h)
        if(std::abs(charts.length(h) * charts.unit() - 0.25) < 1e-9)
          axis = halfedge_angle(surface, h);
      alpha.push_back(axis);
    }
    const std::vector<double> omega(surface.number_of_dual_edges(), 0);
    match_patch(surface, surface.patches[0], omega, alpha, result);
    return result;
  }();
  const Branch_directions directions(surface, alpha, rho, matching);
  for(double spacing = 0.05; spacing < 0.2; spacing *= 1.03)
  {
    const Streamline_options options{ spacing / charts.unit(), 0.5 * spacing / charts.unit(), 1e9 };
    std::array<std::vector<double>, 2> places{ { { 0, 1 }, { 0, 1 } } }; // where lines along y and along x are
    for(const Traced_streamline& line :
        Evenly_spaced_streamlines(charts, directions, surface.patches[0], options).trace())
    {
      const Streamline_piece& piece = line.pieces.front();
      const int axis = std::abs(place(piece.face, piece.from, 0) - place(piece.face, piece.to, 0)) < 1e-9 ? 0 : 1;
      places[axis].push_back(place(piece.face, piece.from, axis));
    }
    for(std::vector<double>& places_of_lines : places)
    {
      std::sort(places_of_lines.begin(), places_of_lines.end());
      EXPECT_LT(5u, places_of_lines.size());
      for(std::size_t i = 1; i < places_of_lines.size(); ++i)
      {
        EXPECT_LT(0.9 * spacing - 1e-9, places_of_lines[i] - places_of_lines[i - 1]) << spacing;
        EXPECT_GT(2 * spacing, places_of_lines[i] - places_of_lines[i - 1]) << spacing;
      }
    }
  }
}

// A line is near to another one wherever it is, but to itself only beside what is more than three distances back.
TEST(Streamline_distances, do_not_see_what_was_traced_just_before)
{
  const Test_surface surface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { { 0, 1, 2 } } });
  const Face_charts charts(surface);
  const Branch_directions directions(surface, { 0 }, { 0 }, {});
  Face_neighborhood neighborhood(charts, directions, surface.patches[0]);
  Streamline_distances distances(charts, directions, surface.patches[0], neighborhood);
  const Corner_weights from{ 0.1, 0.3, 0.6 }, middle{ 0.3, 0.3, 0.4 }, to{ 0.5, 0.3, 0.2 }; // along halfedge 0
  const Plane_vector way = charts.place(0, to) - charts.place(0, from);
  const double length = std::hypot(way.x, way.y), distance = length / 20;
  const int line = 7;
  distances.add({ 0, 0, from, to, length }, { line, 100 }, 1, length);

  const Plane_vector along = (1 / length) * way;
  const Chart_point beside{ 0, 0, charts.place(0, middle) + 0.5 * distance * quarter_turn(along) };
  const Chart_point beyond{ 0, 0, charts.place(0, to) + 0.5 * distance * along };
  EXPECT_FALSE(distances.is_line_near(beside, 0.4 * distance, { line + 1, 0 }));
  for(const Chart_point& point : { beside, beyond })
    EXPECT_TRUE(distances.is_line_near(point, distance, { line + 1, 0 }));
  for(const double sign : { -1., 1. })
  {
    EXPECT_FALSE(distances.is_line_near(beside, distance, { line, 100 + length / 2 + sign * 2.9 * distance }));
    EXPECT_TRUE(distances.is_line_near(beside, distance, { line, 100 + length / 2 + sign * 3.1 * distance }));
    EXPECT_FALSE(distances.is_line_near(beyond, distance, { line, 100 + length + sign * 9 * distance }));
  }
}

// Around two fans, against a walk ring by ring from each corner.
TEST(Rings_with_hubs, give_the_same_rotation_as_a_walk_around_each_corner)
{
  const int n = 120;
  Points points{ { 0, 0, 0 }, { 3, 0, 0 } };
  Triangles triangles;
  const auto rim = [n](const int hub, const int k) { return 2 + hub * n + (k + n) % n; };
  for(const int hub : { 0, 1 })
    for(int k = 0; k < n; ++k)
    {
      const double r = k % 2 == 0 ? 1.3 : 1, a = 2 * CGAL_PI * k / n + (hub == 0 ? 0 : CGAL_PI);
      points.push_back({ 3 * hub + r * std::cos(a), r * std::sin(a), 0 });
    }
  for(const int hub : { 0, 1 })
    for(int k = 0; k < n; ++k)
      triangles.push_back({ { hub, rim(hub, k), rim(hub, k + 1) } });
  triangles.push_back({ { rim(0, 0), rim(0, -1), rim(1, 1) } }); // a bridge
  triangles.push_back({ { rim(0, 0), rim(1, 1), rim(1, 0) } });
  const Test_surface surface(points, triangles);
  const Patch& patch = surface.patches[0];
  const Corner_bounds bounds{ 0.75 * CGAL_PI, std::numeric_limits<double>::infinity() };
  const std::vector<int> corners = sharp_corners_of_patch(surface, patch, bounds.sharp);
  ASSERT_LT(40u, corners.size());
  for(const int number_of_rings : { 1, 2, 3, 4, 5, 9 })
  {
    std::vector<double> expected(surface.number_of_sectors(), 0), demand = expected;
    Sector_rings rings(surface, patch);
    Hub_rings hub_rings(surface, patch, number_of_rings, bounds);
    double rotation = 0.5;
    for(const int corner : corners)
    {
      rotation = rotation * 1.01 + 0.001;
      const std::vector<int> receivers = receivers_in_rings(surface, corner, number_of_rings, bounds, rings);
      for(const int s : receivers)
        expected[s] -= rotation / static_cast<double>(receivers.size());
      ASSERT_TRUE(hub_rings.take(corner, rotation, demand));
    }
    hub_rings.take_from_shared_receivers(demand);
    for(int s = 0; s < surface.number_of_sectors(); ++s)
      EXPECT_NEAR(expected[s], demand[s], 1e-9) << number_of_rings << ' ' << s;
  }
}

} // namespace
