#include "test_cut.h"

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <queue>

namespace test {

namespace {

constexpr double pi = 180 * degree;

// Replaces the sets' representatives by the numbers 0, 1, ...; returns how many there are.
int number_sets(boost::disjoint_sets_with_storage<>& sets, std::vector<int>& number)
{
  int count = 0;
  std::vector<int> number_of_representative(number.size(), -1);
  for(std::size_t i = 0; i < number.size(); ++i)
  {
    int& n = number_of_representative[sets.find_set(i)];
    if(n < 0)
      n = count++;
    number[i] = n;
  }
  return count;
}

// Long doubles, since the angles of needles lose digits.
double angle_at(const Point& p, const Point& q, const Point& r)
{
  typedef std::array<long double, 3> Coordinates;
  const auto difference = [&](const Point& a)
  {
    return Coordinates{ static_cast<long double>(a.x()) - q.x(), static_cast<long double>(a.y()) - q.y(),
                        static_cast<long double>(a.z()) - q.z() };
  };
  const Coordinates u = difference(p), v = difference(r);
  const long double cross = std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  return static_cast<double>(std::atan2(cross, u[0] * v[0] + u[1] * v[1] + u[2] * v[2]));
}

std::vector<std::vector<int> > neighbors_of_sectors(const Cut& cut)
{
  std::vector<std::vector<int> > result(cut.number_of_sectors());
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
  {
    result[cut.sector[h]].push_back(cut.sector[previous_of(h)]);
    result[cut.sector[previous_of(h)]].push_back(cut.sector[h]);
  }
  return result;
}

std::map<int, int> distances_from(const int corner, const std::vector<std::vector<int> >& neighbors)
{
  std::map<int, int> distance = { { corner, 0 } };
  std::queue<int> queue({ corner });
  for(; !queue.empty(); queue.pop())
    for(const int s : neighbors[queue.front()])
      if(distance.emplace(s, distance[queue.front()] + 1).second)
        queue.push(s);
  return distance;
}

double rotation_demand(const double theta)
{
  const double quarters = (std::max)(1., std::floor(2 * (theta + angle_tolerance) / pi + 0.5));
  return theta - quarters * pi / 2;
}

// 0 or 1: the branch pair that lies along a constrained edge.
int aligned_branch(const Cut& cut, const std::vector<double>& alpha, const int h)
{
  return std::abs(std::sin(cut.phi[h] - alpha[face_of(h)])) < 0.5 ? 0 : 1;
}

} // namespace

Cut::Cut(std::vector<Point> points_, std::vector<int> opposite_)
  : points(std::move(points_)), opposite(std::move(opposite_)), sector(points.size()), patch(points.size() / 3)
{
  boost::disjoint_sets_with_storage<> corners(points.size()), faces(patch.size());
  for(int h = 0; h < number_of_halfedges(); ++h)
  {
    angle.push_back(angle_at(points[previous_of(h)], points[h], points[next_of(h)]));
    if(!is_constrained(h))
    {
      corners.union_set(h, previous_of(opposite[h]));
      faces.union_set(face_of(h), face_of(opposite[h]));
    }
  }
  theta.assign(number_sets(corners, sector), 0);
  number_of_patches = number_sets(faces, patch);

  is_constrained_sector.assign(theta.size(), false);
  for(int h = 0; h < number_of_halfedges(); ++h)
  {
    theta[sector[h]] += angle[h];
    is_constrained_sector[sector[h]] |= is_constrained(h) || is_constrained(next_of(h));
    phi.push_back(h % 3 == 0 ? 0 : phi.back() + pi - angle[h - 1]);
  }
  for(int h = 0; h < number_of_halfedges(); ++h)
    transport.push_back(is_constrained(h) ? 0 : std::remainder(phi[h] - phi[opposite[h]] - pi, 2 * pi));
}

double Cut::rotation(const std::vector<double>& alpha, const std::vector<int>& matching, const int h) const
{
  const double r = -alpha[face_of(h)] + alpha[face_of(opposite[h])] + transport[h] + matching[h] * pi / 2;
  const bool is_half_turn = std::abs(transport[h]) > pi - 1e-9; // which is the same in both directions
  return is_half_turn ? std::remainder(r, 2 * pi) : r;
}

std::vector<double> Cut::sums_around_sectors(const std::vector<double>& values) const
{
  std::vector<double> result(number_of_sectors(), 0);
  for(int h = 0; h < number_of_halfedges(); ++h)
    if(!is_constrained(h))
      result[sector[h]] += values[h];
  return result;
}

double largest(const std::vector<double>& values)
{
  double result = 0;
  for(const double value : values)
    result = std::isnan(value) ? std::numeric_limits<double>::infinity() : (std::max)(result, std::abs(value));
  return result;
}

double largest_difference(const std::vector<double>& values, const std::vector<double>& expected)
{
  if(values.size() != expected.size())
    return std::numeric_limits<double>::infinity();
  std::vector<double> difference;
  std::transform(values.begin(), values.end(), expected.begin(), std::back_inserter(difference), std::minus<double>());
  return largest(difference);
}

std::vector<int> index_of_sectors(const Cut& cut, const std::vector<int>& index)
{
  std::vector<int> result(cut.number_of_sectors(), std::numeric_limits<int>::min());
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
  {
    int& of_sector = result[cut.sector[h]];
    if(of_sector == std::numeric_limits<int>::min())
      of_sector = index[h];
    EXPECT_EQ(of_sector, index[h]) << "two corners of a sector at " << cut.points[h];
  }
  return result;
}

std::vector<int> poincare_hopf_defects(const Cut& cut, const std::vector<int>& index)
{
  std::vector<int> euler_characteristic(cut.number_of_patches, 0), sum(cut.number_of_patches, 0);
  const std::vector<int> sector_index = index_of_sectors(cut, index);
  std::vector<char> is_counted(cut.number_of_sectors(), false);
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
  {
    const int patch = cut.patch[face_of(h)];
    euler_characteristic[patch] += h % 3 == 0;
    euler_characteristic[patch] -= cut.is_constrained(h) || h < cut.opposite[h];
    if(!is_counted[cut.sector[h]])
    {
      is_counted[cut.sector[h]] = true;
      ++euler_characteristic[patch];
      sum[patch] += sector_index[cut.sector[h]];
    }
  }
  for(int patch = 0; patch < cut.number_of_patches; ++patch)
    sum[patch] -= 4 * euler_characteristic[patch];
  return sum;
}

double largest_index_error(const Cut& cut, const std::vector<double>& alpha, const std::vector<int>& matching,
                           const std::vector<int>& index)
{
  std::vector<double> r(cut.number_of_halfedges(), 0);
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(!cut.is_constrained(h))
      r[h] = cut.rotation(alpha, matching, h);
  const std::vector<double> sum = cut.sums_around_sectors(r);
  std::vector<double> error;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
  {
    const int s = cut.sector[h];
    const double turns = (sum[s] - cut.theta[s]) / (2 * pi) + 1 - (cut.is_constrained_sector[s] ? 0.5 : 0);
    error.push_back(4 * turns - index[h]);
  }
  return largest(error);
}

std::vector<int> index_after_change(const Cut& cut, const Field& field, const std::vector<int>& new_matching)
{
  std::vector<double> change;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    change.push_back(new_matching[h] - field.matching[h]);
  const std::vector<double> change_of_sectors = cut.sums_around_sectors(change);
  std::vector<int> result;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    result.push_back(field.index[h] + static_cast<int>(change_of_sectors[cut.sector[h]]));
  return result;
}

double largest_misalignment(const Cut& cut, const Field& field)
{
  std::vector<double> angles;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(cut.is_constrained(h))
    {
      const double to_first = cut.phi[h] - field.alpha[face_of(h)];
      const double to_second = to_first - pi / 2 - field.rho[face_of(h)];
      angles.push_back((std::min)(std::abs(std::remainder(to_first, pi)), std::abs(std::remainder(to_second, pi))));
    }
  return largest(angles);
}

double largest_misalignment_in_space(const Cut& cut, const Field& field)
{
  const double smallest_angle = 1e-3;
  std::vector<double> angles;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
  {
    if(!cut.is_constrained(h)
       || (std::min)({ cut.angle[h], cut.angle[next_of(h)], cut.angle[previous_of(h)] }) < smallest_angle)
      continue;
    const Vector edge = cut.points[h] - cut.points[previous_of(h)];
    double nearest = pi;
    for(const Vector& branch : field.branches[face_of(h)])
      nearest = (std::min)(nearest, std::atan2(std::sqrt(CGAL::cross_product(edge, branch).squared_length()),
                                               edge * branch));
    angles.push_back(nearest);
  }
  return largest(angles);
}

std::vector<char> prescribed_corners(const Cut& cut, const Corner_bounds& bounds)
{
  std::vector<char> is_sharp, is_blunt, patch_has_receiver(cut.number_of_patches, false);
  for(int s = 0; s < cut.number_of_sectors(); ++s)
  {
    is_sharp.push_back(cut.is_sharp(s, bounds.sharp));
    is_blunt.push_back(cut.is_constrained_sector[s] && cut.theta[s] >= 135 * degree - angle_tolerance
                       && std::abs(cut.theta[s] - 180 * degree) > bounds.blunt);
  }
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(!is_sharp[cut.sector[h]] && !is_blunt[cut.sector[h]])
      patch_has_receiver[cut.patch[face_of(h)]] = true;
  std::vector<char> is_corner = is_sharp;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(is_blunt[cut.sector[h]] && patch_has_receiver[cut.patch[face_of(h)]])
      is_corner[cut.sector[h]] = true;
  return is_corner;
}

std::vector<double> rotation_demand_of_rings(const Cut& cut, const int number_of_rings, const Corner_bounds& bounds)
{
  const std::vector<std::vector<int> > neighbors = neighbors_of_sectors(cut);
  const std::vector<char> is_corner = prescribed_corners(cut, bounds);
  std::vector<double> demand(cut.number_of_sectors(), 0);
  for(int corner = 0; corner < cut.number_of_sectors(); ++corner)
  {
    if(!is_corner[corner])
      continue;
    const std::map<int, int> distance = distances_from(corner, neighbors);
    int reach = std::numeric_limits<int>::max();
    for(const auto& [s, d] : distance)
      if(!is_corner[s])
        reach = (std::min)(reach, d);
    reach = (std::max)(reach, number_of_rings);
    std::vector<int> receivers;
    for(const auto& [s, d] : distance)
      if(!is_corner[s] && d <= reach)
        receivers.push_back(s);

    const double wanted = rotation_demand(cut.theta[corner]);
    demand[corner] += wanted;
    for(const int s : receivers)
      demand[s] -= wanted / static_cast<double>(receivers.size());
  }
  return demand;
}

std::vector<double> rotation_demand_of_component(const Cut& cut, const Corner_bounds& bounds)
{
  const std::vector<char> is_corner = prescribed_corners(cut, bounds);
  std::vector<int> patch_of_sector(cut.number_of_sectors());
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    patch_of_sector[cut.sector[h]] = cut.patch[face_of(h)];
  std::vector<double> total(cut.number_of_patches, 0), number_of_receivers(cut.number_of_patches, 0);
  for(int s = 0; s < cut.number_of_sectors(); ++s)
    if(is_corner[s])
      total[patch_of_sector[s]] += rotation_demand(cut.theta[s]);
    else
      ++number_of_receivers[patch_of_sector[s]];
  std::vector<double> demand;
  for(int s = 0; s < cut.number_of_sectors(); ++s)
    demand.push_back(is_corner[s] ? rotation_demand(cut.theta[s])
                                               : -total[patch_of_sector[s]] / number_of_receivers[patch_of_sector[s]]);
  return demand;
}

double largest_deviation_from_gradient(const Cut& cut, const std::vector<double>& omega)
{
  std::vector<std::vector<int> > halfedges_to(cut.number_of_sectors());
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(!cut.is_constrained(h))
      halfedges_to[cut.sector[h]].push_back(h);
  std::vector<double> lambda(cut.number_of_sectors(), 0), deviation;
  std::vector<char> is_reached(cut.number_of_sectors(), false);
  for(int root = 0; root < cut.number_of_sectors(); ++root)
  {
    std::queue<int> queue;
    if(!is_reached[root])
      queue.push(root);
    is_reached[root] = true;
    for(; !queue.empty(); queue.pop())
      for(const int h : halfedges_to[queue.front()])
      {
        const int s = cut.sector[cut.opposite[h]];
        if(!is_reached[s])
        {
          is_reached[s] = true;
          lambda[s] = lambda[queue.front()] - omega[h];
          queue.push(s);
        }
      }
  }
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    deviation.push_back(cut.is_constrained(h)
                        ? omega[h] : omega[h] - (lambda[cut.sector[h]] - lambda[cut.sector[cut.opposite[h]]]));
  return largest(deviation);
}

std::vector<int> constrained_sectors_below(const Cut& cut, const double angle)
{
  std::vector<int> result;
  for(int s = 0; s < cut.number_of_sectors(); ++s)
    if(cut.is_sharp(s, angle))
      result.push_back(s);
  return result;
}

int number_of_unmeshable_sectors(const Cut& cut, const std::vector<int>& index)
{
  const std::vector<int> sector_index = index_of_sectors(cut, index);
  int count = 0;
  for(int s = 0; s < cut.number_of_sectors(); ++s)
    count += cut.is_constrained_sector[s] && sector_index[s] >= 2;
  return count;
}

Relaxation relaxation(const Cut& cut, const Field& orthogonal, const Field& relaxed, const double weight)
{
  std::vector<std::array<double, 2> > gamma, gradient(cut.number_of_faces(), { 0, 0 });
  Relaxation result = { 0, 0, 0, 0 };
  for(int f = 0; f < cut.number_of_faces(); ++f)
  {
    const double gamma0 = relaxed.alpha[f] - orthogonal.alpha[f];
    gamma.push_back({ gamma0, gamma0 + relaxed.rho[f] });
    result.energy_after += weight * relaxed.rho[f] * relaxed.rho[f];
    gradient[f] = { -2 * weight * relaxed.rho[f], 2 * weight * relaxed.rho[f] };
  }
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
  {
    if(cut.is_constrained(h) || cut.opposite[h] < h)
      continue;
    const int i = face_of(h), j = face_of(cut.opposite[h]), p = orthogonal.matching[h];
    const int q = ((p % 2) + 2) % 2;
    const double r = cut.rotation(orthogonal.alpha, orthogonal.matching, h);
    const double r0 = r - gamma[i][0] + gamma[j][q], r1 = r - gamma[i][1] + gamma[j][1 - q];
    result.energy_before += 2 * r * r;
    result.energy_after += r0 * r0 + r1 * r1;
    gradient[i][0] -= 2 * r0;
    gradient[i][1] -= 2 * r1;
    gradient[j][q] += 2 * r0;
    gradient[j][1 - q] += 2 * r1;
  }
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(cut.is_constrained(h))
    {
      const int b = aligned_branch(cut, orthogonal.alpha, h);
      gradient[face_of(h)][b] = 0;
      result.largest_fixed_gamma = (std::max)(result.largest_fixed_gamma, std::abs(gamma[face_of(h)][b]));
    }
  for(const std::array<double, 2>& g : gradient)
    result.largest_gradient = (std::max)(result.largest_gradient, largest({ g[0], g[1] }));
  return result;
}

double largest_branch_distance(const std::vector<std::array<Vector, 4> >& before,
                               const std::vector<std::array<Vector, 4> >& after)
{
  double result = before.size() == after.size() ? 0 : std::numeric_limits<double>::infinity();
  for(std::size_t f = 0; f < (std::min)(before.size(), after.size()); ++f)
    for(const Vector& u : after[f])
    {
      double nearest = std::numeric_limits<double>::infinity();
      for(const Vector& v : before[f])
        nearest = (std::min)(nearest, std::sqrt((u - v).squared_length()));
      result = (std::max)(result, nearest);
    }
  return result;
}

void expect_valid_field(const Cut& cut, const Field& field)
{
  EXPECT_EQ(std::vector<int>(cut.number_of_patches, 0), poincare_hopf_defects(cut, field.index));
  EXPECT_EQ(static_cast<std::size_t>(cut.number_of_patches), field.statistics.number_of_patches);
  EXPECT_EQ(constrained_sectors_below(cut, sharp_corner_bound).size(), field.statistics.number_of_sharp_corners);
  EXPECT_LT(largest_misalignment(cut, field), 1e-9);
  EXPECT_LT(largest_misalignment_in_space(cut, field), 1e-9);
  EXPECT_LE(largest(field.rho), 0.45 * pi + 1e-12);
}

} // namespace test
