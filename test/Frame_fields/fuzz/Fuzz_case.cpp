#include "Fuzz_case.h"

#include <CGAL/number_type_config.h>

#include <cstring>
#include <iterator>
#include <limits>

namespace test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <std::size_t n>
double one_of(const double (&values)[n], Byte_reader& bytes)
{
  return values[bytes.below(n)];
}

FF::Support_strategy read_support_strategy(Byte_reader& bytes)
{
  switch(bytes.below(8))
  {
    case 0: return FF::Support_strategy::rings(4);
    case 1: return FF::Support_strategy::none();
    case 2: return FF::Support_strategy::local();
    case 3: return FF::Support_strategy::component();
    case 4: return FF::Support_strategy::radius();
    case 5: return FF::Support_strategy::radius(2);
    case 6: return FF::Support_strategy::rings(1);
    default: return FF::Support_strategy::rings(std::numeric_limits<unsigned int>::max());
  }
}

enum Coordinate_kind { SMALL_INTEGER, FRACTION, SPECIAL, ANY_DOUBLE, number_of_coordinate_kinds };

double read_coordinate(const int kind, Byte_reader& bytes)
{
  switch(kind)
  {
    case SMALL_INTEGER: return static_cast<std::int8_t>(bytes.byte());
    case FRACTION: return static_cast<std::int8_t>(bytes.byte()) + bytes.byte() / 256.;
    case SPECIAL:
      return one_of({ 0, 1, -1, 2, -2, 0.5, 1e-8, 1e8, 1 + 1e-15, 1e150, -1e150, 1e-150, 1e300, -1e300, 1e-300,
                      -1e-300, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(),
                      -std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), infinity, -infinity,
                      nan, -0. }, bytes);
    default:
    {
      std::uint8_t raw[sizeof(double)];
      for(std::uint8_t& byte : raw)
        byte = static_cast<std::uint8_t>(bytes.byte());
      double result;
      std::memcpy(&result, raw, sizeof(double));
      return result;
    }
  }
}

} // namespace

Fuzz_parameters read_parameters(Byte_reader& bytes)
{
  Fuzz_parameters result;
  result.support_strategy = read_support_strategy(bytes);
  const unsigned int flags = bytes.byte();
  result.edge_weighting = (flags & 1) ? FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH : FF::Edge_weighting::UNIFORM;
  result.relaxes = !(flags & 2);
  result.repairs = !(flags & 4);
  result.splits_chords = flags & 8;
  result.is_guided = flags & 16;
  result.has_index_targets = flags & 32;
  result.splits_overconstrained_faces = !(flags & 64);
  result.makes_quads = flags & 128;
  result.sharp_corner_bound = one_of({ 0.75 * CGAL_PI, 0, CGAL_PI / 4, CGAL_PI / 2, CGAL_PI, 2 * CGAL_PI, 1e300, -1,
                                       nan, infinity }, bytes);
  result.maximum_skewness = one_of({ 0.45 * CGAL_PI, 0, 0.1, 1.57, CGAL_PI / 2, -1, nan }, bytes);
  result.orthogonality_weight = one_of({ 1e-2, 0, 1, 1e6, 1e300, 1e-300, -1, nan, infinity }, bytes);
  result.orthogonality_length = one_of({ 0, 1, 1e-3, 1e3, 1e-300, 1e300, -1, nan, infinity }, bytes);
  return result;
}

Feature_parameters read_feature_parameters(Byte_reader& bytes)
{
  Feature_parameters result;
  result.strong_angle = one_of({ 40, 0, 10, 90, 180, 1e-300, -1, 181, nan }, bytes);
  result.weak_angle = one_of({ 40, 0, 10, 90, 180, 1e-300, -1, 181, nan }, bytes);
  result.minimum_chain_length = one_of({ 0, 1, 10, 1e-300, 1e300, infinity, -1, nan }, bytes);
  result.closes_gaps = bytes.byte() % 2;
  return result;
}

Streamline_parameters read_streamline_parameters(Byte_reader& bytes)
{
  Streamline_parameters result;
  result.spacing = one_of({ 1, 0.2, 0, 1e300, infinity, -1, 1e-300, nan }, bytes);
  result.separation = one_of({ 0.5, 1, 0.2, -1, 1.1, nan }, bytes);
  result.maximum_length = one_of({ infinity, 1, 1e-300, 1e300, 100, 0, -1, nan }, bytes);
  return result;
}

double read_relative_edge_length(Byte_reader& bytes)
{
  return one_of({ 1, 0.2, 0.5, 2, 1000, 1e300, -1, nan }, bytes);
}

std::vector<Point> read_points(Byte_reader& bytes)
{
  const int kind = static_cast<int>(bytes.below(number_of_coordinate_kinds));
  std::vector<Point> points(bytes.below(65));
  for(Point& point : points)
  {
    const double x = read_coordinate(kind, bytes), y = read_coordinate(kind, bytes);
    point = Point(x, y, read_coordinate(kind, bytes));
  }
  return points;
}

Model read_combinatorics(Byte_reader& bytes, const std::size_t number_of_points)
{
  Model model;
  if(number_of_points == 0)
    return model;
  for(std::size_t p = 0; p < number_of_points; ++p)
    model.points.emplace_back(static_cast<double>(p), 0, 0);
  const auto read_point = [&] { return bytes.below(static_cast<unsigned int>(number_of_points)); };
  for(unsigned int n = bytes.below(129); n > 0; --n)
  {
    const std::size_t p = read_point(), q = read_point(), r = read_point();
    if(p != q && q != r && r != p) // CGAL's repair asserts it
      model.triangles.push_back({ p, q, r });
  }
  for(unsigned int n = bytes.below(129); n > 0; --n)
  {
    const std::size_t p = read_point();
    model.features.push_back(segment(model.points[p], model.points[read_point()]));
  }
  return repaired(std::move(model));
}

} // namespace test
