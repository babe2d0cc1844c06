#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/trace_streamlines.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

// Streamlines of fields that are known, and of computed ones.
namespace {

using namespace test;

constexpr double pi = 180 * degree;

// A vector of the plane that a surface of no curvature is rolled out to.
struct Flat
{
  double x, y;
};

double angle_of(const Flat& v) { return std::atan2(v.y, v.x); }

// A mesh of no curvature with a field that is constant in the plane. The branches of its faces are numbered at random.
template <typename Mesh>
struct Flat_case
{
  typedef boost::graph_traits<Mesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef typename Graph_traits::face_descriptor Face;
  typedef FF::Streamline<Point, Face> Streamline;
  typedef std::function<Flat(const Point&, std::size_t)> Roll_out; // of a vertex and its number

  Cad_mesh<Mesh> cad_mesh;
  Maps<Mesh> maps;
  double direction, skewness;

  // Coordinates of the plane that differ by a period are the same.
  Flat_case(const Model& model, const double direction_in_degrees, const double skewness_in_degrees = 0,
            const Roll_out& roll_out = [](const Point& p, std::size_t) { return Flat{ p.x(), p.y() }; },
            const Flat& period = { infinity(), infinity() })
    : cad_mesh(model, false), maps(cad_mesh.mesh), direction(direction_in_degrees * degree)
    , skewness(skewness_in_degrees * degree)
  {
    const Mesh& mesh = cad_mesh.mesh;
    std::map<typename Graph_traits::vertex_descriptor, Flat> flat;
    for(const auto v : vertices(mesh))
    {
      const std::size_t number = flat.size();
      flat[v] = roll_out(cad_mesh.point(v), number);
    }
    const auto along = [&](const Halfedge h)
    {
      const Flat p = flat[source(h, mesh)], q = flat[target(h, mesh)];
      return angle_of({ shortest(q.x - p.x, period.x), shortest(q.y - p.y, period.y) });
    };
    std::minstd_rand random(1);
    for(const auto f : faces(mesh))
    {
      // A turn by a quarter exchanges the pairs, which only an orthogonal frame allows.
      const int turns = (skewness == 0 ? 1 : 2) * static_cast<int>(random() % 4);
      put(maps.alpha, f, direction + turns * pi / 2 - along(halfedge(f, mesh)));
      put(maps.rho, f, skewness);
    }
    for(const Halfedge h : halfedges(mesh))
    {
      put(maps.matching, h, 0);
      if(is_border(h, mesh) || is_border(opposite(h, mesh), mesh))
        continue;
      const Face i = face(h, mesh), j = face(opposite(h, mesh), mesh);
      const double transport = std::remainder(along(halfedge(j, mesh)) - along(halfedge(i, mesh)), 2 * pi);
      put(maps.matching, h, std::lround((get(maps.alpha, i) - get(maps.alpha, j) - transport) / (pi / 2)));
    }
  }

  static double infinity() { return std::numeric_limits<double>::infinity(); }
  static double shortest(const double d, const double period)
  {
    return std::isfinite(period) ? std::remainder(d, period) : d;
  }

  template <typename NamedParameters>
  std::vector<Streamline> trace(const NamedParameters& np) const
  {
    std::vector<Streamline> result;
    const FF::Result r = FF::trace_streamlines(cad_mesh.mesh, maps.alpha, maps.rho, maps.matching,
                                               std::back_inserter(result), parameters::join(np, cad_mesh.features()));
    EXPECT_TRUE(r) << r.message;
    EXPECT_FALSE(result.empty());
    return result;
  }
};

template <typename Streamline>
double length(const Streamline& line)
{
  double sum = 0;
  for(std::size_t k = 0; k + 1 < line.points.size(); ++k)
    sum += std::sqrt(CGAL::squared_distance(line.points[k], line.points[k + 1]));
  return sum;
}

// The angle of a line in the plane z = 0 modulo a half turn, and its distance from the origin, to the left.
struct Line_place
{
  double angle, offset;
};

template <typename Streamline>
Line_place place_of(const Streamline& line)
{
  const Vector v = line.points.back() - line.points.front();
  double angle = std::atan2(v.y(), v.x());
  angle -= angle < -1e-9 ? pi : angle > pi - 1e-9 ? pi : 0;
  angle += angle < -1e-9 ? 2 * pi : 0;
  return { angle, std::cos(angle) * line.points[0].y() - std::sin(angle) * line.points[0].x() };
}

// Expects all lines to be straight, along one of the two directions, and to end on the border.
template <typename Case>
void expect_chords(const Case& flat_case, const std::vector<typename Case::Streamline>& lines, const double tolerance)
{
  const auto& mesh = flat_case.cad_mesh.mesh;
  const auto distance_from_border = [&](const Point& p)
  {
    double result = std::numeric_limits<double>::infinity();
    for(const auto e : edges(mesh))
      if(is_border(e, mesh))
        result = (std::min)(result, CGAL::squared_distance(p, Kernel::Segment_3(
          flat_case.cad_mesh.point(source(e, mesh)), flat_case.cad_mesh.point(target(e, mesh)))));
    return std::sqrt(result);
  };
  for(const auto& line : lines)
  {
    const Kernel::Line_3 chord(line.points.front(), line.points.back());
    for(const Point& p : line.points)
      EXPECT_LT(std::sqrt(CGAL::squared_distance(p, chord)), tolerance);
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(line.points.front(), line.points.back())), length(line), tolerance);
    const double angle = place_of(line).angle, other = flat_case.direction + pi / 2 + flat_case.skewness;
    EXPECT_LT((std::min)(std::abs(std::remainder(angle - flat_case.direction, pi)),
                         std::abs(std::remainder(angle - other, pi))), 1e-6);
    EXPECT_LT(distance_from_border(line.points.front()), tolerance);
    EXPECT_LT(distance_from_border(line.points.back()), tolerance);
    EXPECT_FALSE(line.is_closed);
  }
}

template <typename Mesh>
class Streamlines : public testing::Test
{};

TYPED_TEST_SUITE(Streamlines, Mesh_classes, Mesh_class_names);

TYPED_TEST(Streamlines, of_a_constant_field_are_chords)
{
  for(const double direction : { 20., 77. })
    for(const double skewness : { 0., 35., -60. })
    {
      const Flat_case<TypeParam> flat_case(regular_polygon(7, 0.2), direction, skewness);
      expect_chords(flat_case, flat_case.trace(parameters::streamline_spacing(0.1)), 1e-12);
    }
}

// In a grid, lines through vertices and along edges are the rule.
TYPED_TEST(Streamlines, go_through_vertices_and_along_edges)
{
  for(const double direction : { 0., 45., 135. })
    for(const double spacing : { 0.125, 0.25 / std::sqrt(2.) })
    {
      const Flat_case<TypeParam> flat_case(square(8), direction);
      expect_chords(flat_case, flat_case.trace(parameters::streamline_spacing(spacing)), 1e-8);
    }
}

TYPED_TEST(Streamlines, are_as_far_apart_as_asked)
{
  const Flat_case<TypeParam> flat_case(square(7), 0);
  std::vector<double> offsets[2];
  for(const auto& line : flat_case.trace(parameters::streamline_spacing(0.125)))
  {
    const Line_place place = place_of(line);
    EXPECT_NEAR(1, length(line), 1e-12);
    offsets[std::lround(place.angle / (pi / 2)) % 2].push_back(std::abs(place.offset));
  }
  for(std::vector<double>& of_pair : offsets)
  {
    std::sort(of_pair.begin(), of_pair.end());
    ASSERT_EQ(7u, of_pair.size());
    for(int k = 0; k < 7; ++k)
      EXPECT_NEAR((k + 1) * 0.125, of_pair[k], 1e-9);
  }
}

TYPED_TEST(Streamlines, have_the_pair_of_their_direction)
{
  const Flat_case<TypeParam> flat_case(regular_polygon(5, 0.2), 30);
  std::map<long, int> pair_of_direction;
  for(const auto& line : flat_case.trace(parameters::streamline_spacing(0.1)))
    EXPECT_EQ(line.branch_pair,
              pair_of_direction.emplace(std::lround(place_of(line).angle / degree), line.branch_pair).first->second);
  ASSERT_EQ(2u, pair_of_direction.size());
  EXPECT_NE(pair_of_direction.begin()->second, pair_of_direction.rbegin()->second);
}

TYPED_TEST(Streamlines, end_at_the_maximum_length)
{
  const Flat_case<TypeParam> flat_case(square(7), 30);
  bool is_reached = false;
  for(const auto& line : flat_case.trace(parameters::streamline_spacing(0.1).maximum_streamline_length(0.5)))
  {
    EXPECT_LE(length(line), 0.5 + 1e-12);
    is_reached = is_reached || length(line) > 0.5 - 1e-12;
  }
  EXPECT_TRUE(is_reached);
}

// A torus without curvature, folded up into the plane like a paper bag.
struct Folded_torus
{
  static constexpr int m = 12, n = 8;
  static Model model()
  {
    const auto fold = [](const double t) { return t < 0.5 ? t : 1 - t; };
    return grid(m, n, true, true, [&](const double u, const double v) { return Point(fold(u), fold(v), 0); });
  }
  static Flat roll_out(const Point&, const std::size_t number)
  {
    return { static_cast<double>(number % m) / m, static_cast<double>(number / m) / n };
  }
};

TYPED_TEST(Streamlines, of_a_flat_torus_close_after_a_rational_slope)
{
  for(const auto& [x, y] : { std::pair<int, int>(1, 0), { 1, 1 }, { 2, 1 }, { 1, -3 } })
  {
    const Flat_case<TypeParam> flat_case(Folded_torus::model(), std::atan2(y, x) / degree, 0, Folded_torus::roll_out,
                                         { 1, 1 });
    for(const auto& line : flat_case.trace(parameters::streamline_spacing(0.05)))
    {
      EXPECT_TRUE(line.is_closed);
      EXPECT_EQ(line.points.front(), line.points.back());
      EXPECT_NEAR(std::hypot(x, y), length(line), 1e-9);
    }
  }
}

// With an irrational slope a line comes back to where it was for ever, and nearer and nearer.
TYPED_TEST(Streamlines, of_a_flat_torus_end_beside_themselves_otherwise)
{
  const double spacing = 0.05, slope = std::atan(std::sqrt(5.) / 2 - 0.5) / degree;
  const Flat_case<TypeParam> flat_case(Folded_torus::model(), slope, 0, Folded_torus::roll_out, { 1, 1 });
  double sum = 0;
  for(const auto& line : flat_case.trace(parameters::streamline_spacing(spacing)))
  {
    EXPECT_FALSE(line.is_closed);
    sum += length(line);
  }
  // Two pairs of lines at half the spacing at least cover the area of 1 each.
  EXPECT_LE(sum, 2 / (spacing / 2));
  EXPECT_GE(sum, 1 / spacing);
}

TYPED_TEST(Streamlines, of_a_cylinder_are_helices)
{
  const int m = 16;
  const double side = 2 * std::sin(pi / m), height = 3;
  const Model cylinder = grid(m, 5, true, false, [&](const double u, const double v)
                              { return Point(std::cos(2 * pi * u), std::sin(2 * pi * u), height * v); });
  for(const double direction : { 0., 25., 70. })
  {
    const Flat_case<TypeParam> flat_case(cylinder, direction, 0, [&](const Point& p, const std::size_t number)
                                         { return Flat{ side * static_cast<double>(number % m), p.z() }; },
                                         { m * side, std::numeric_limits<double>::infinity() });
    for(const auto& line : flat_case.trace(parameters::streamline_spacing(0.2)))
    {
      const double rise = std::abs(line.points[1].z() - line.points[0].z())
                          / std::sqrt(CGAL::squared_distance(line.points[0], line.points[1]));
      EXPECT_LT((std::min)(std::abs(rise - std::sin(direction * degree)),
                           std::abs(rise - std::cos(direction * degree))), 1e-9);
      EXPECT_EQ(rise < 1e-9, line.is_closed);
      const double expected_length = line.is_closed ? m * side : height / rise;
      EXPECT_NEAR(expected_length, length(line), 1e-9);
    }
  }
}

// Around the center of a regular polygon cut into triangles the frames point to it: index 1.
TYPED_TEST(Streamlines, end_at_singular_sectors)
{
  Model model;
  const std::size_t n = 7;
  model.points.emplace_back(0, 0, 0);
  for(std::size_t k = 0; k < n; ++k)
    model.points.emplace_back(std::cos(2 * pi * k / n), std::sin(2 * pi * k / n), 0);
  for(std::size_t k = 0; k < n; ++k)
    model.triangles.push_back({ 0, 1 + k, 1 + (k + 1) % n });
  const Cad_mesh<TypeParam> cad_mesh(model, false);
  const TypeParam& mesh = cad_mesh.mesh;
  const Maps<TypeParam> maps(mesh);
  for(const auto h : halfedges(mesh))
  {
    put(maps.matching, h, 0);
    if(is_border(h, mesh) || !is_border(opposite(h, mesh), mesh))
      continue;
    const auto first = halfedge(face(h, mesh), mesh);
    const double angle = first == h ? 0 : first == next(h, mesh) ? pi / 2 + pi / n : -pi / 2 - pi / n; // from h to it
    put(maps.alpha, face(h, mesh), pi / 2 - angle);
    put(maps.rho, face(h, mesh), 0);
  }
  std::vector<FF::Streamline<Point, typename boost::graph_traits<TypeParam>::face_descriptor> > lines;
  // r = 0 in the polar frame: the transport is the turn between the frames up to whole turns
  const double theta = 2 * pi / n;
  for(const auto h : halfedges(mesh))
    if(!is_border(h, mesh) && !is_border(opposite(h, mesh), mesh))
    {
      const auto position = [&](const auto g) // phi of g
      {
        const auto first = halfedge(face(g, mesh), mesh);
        const Vector a = cad_mesh.point(target(first, mesh)) - cad_mesh.point(source(first, mesh));
        const Vector b = cad_mesh.point(target(g, mesh)) - cad_mesh.point(source(g, mesh));
        return std::atan2(a.x() * b.y() - a.y() * b.x(), a * b);
      };
      const double transport = std::remainder(position(h) - position(opposite(h, mesh)) - pi, 2 * pi);
      const double turn = target(h, mesh) == *vertices(mesh).begin() ? theta : -theta;
      put(maps.matching, h, std::lround((turn + get(maps.alpha, face(h, mesh))
                                         - get(maps.alpha, face(opposite(h, mesh), mesh)) - transport) / (pi / 2)));
    }
  ASSERT_TRUE(FF::trace_streamlines(mesh, maps.alpha, maps.rho, maps.matching, std::back_inserter(lines),
                                    parameters::streamline_spacing(0.3).streamline_separation(0)));
  const auto is_center = [](const Point& p) { return CGAL::squared_distance(p, Point(0, 0, 0)) < 1e-18; };
  std::size_t number_of_radii = 0;
  for(const auto& line : lines)
  {
    EXPECT_TRUE(std::none_of(line.points.begin() + 1, line.points.end() - 1, is_center));
    // One pair ends there, the other one goes around.
    const bool is_radius = is_center(line.points.front()) || is_center(line.points.back());
    EXPECT_NE(is_radius, line.is_closed);
    number_of_radii += is_radius;
  }
  EXPECT_GE(number_of_radii, n);
}

// Three right angles around the corner of a cube: index 1/4. Lines that run at it would find a way on.
TYPED_TEST(Streamlines, end_at_a_singular_vertex_that_has_a_way_on)
{
  typedef typename boost::graph_traits<TypeParam>::face_descriptor Face;
  const Model model{ { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1) },
                     { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 } }, {} };
  const Cad_mesh<TypeParam> cad_mesh(model, false);
  const Maps<TypeParam> maps(cad_mesh.mesh);
  ASSERT_TRUE(FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
                                  parameters::join(parameters::matching_map(maps.matching), cad_mesh.features())));
  const auto is_corner = [](const Point& p) { return CGAL::squared_distance(p, Point(0, 0, 0)) < 1e-18; };
  for(const int n : { 3, 4, 7 })
  {
    std::vector<FF::Streamline<Point, Face> > lines; // some of them at 1 / sqrt(2) from a border edge
    ASSERT_TRUE(FF::trace_streamlines(cad_mesh.mesh, maps.alpha, maps.rho, maps.matching, std::back_inserter(lines),
                                      parameters::streamline_spacing(std::sqrt(0.5) / n)));
    std::size_t number_of_ends = 0;
    for(const auto& line : lines)
    {
      EXPECT_TRUE(std::none_of(line.points.begin() + 1, line.points.end() - 1, is_corner));
      number_of_ends += is_corner(line.points.front()) + is_corner(line.points.back());
    }
    EXPECT_GE(number_of_ends, 1u);
  }
}

// A line arrives at the center of a hexagon in the direction of 30 degrees. The field leads away from there on one
// side by 20 degrees and on the other side by 40.
TYPED_TEST(Streamlines, take_the_straightest_of_several_ways_on)
{
  Model model;
  model.points.emplace_back(0, 0, 0);
  for(int k = 0; k < 6; ++k)
  {
    const double radius = (k == 3 || k == 4) ? 1.2 : 1; // lines begin in the largest face, here the first one
    model.points.emplace_back(radius * std::cos(pi / 3 * k), radius * std::sin(pi / 3 * k), 0);
  }
  for(std::size_t k = 0; k < 6; ++k)
    model.triangles.push_back({ 0, 1 + (k + 3) % 6, 1 + (k + 4) % 6 });

  const double nearer_way_is_left[6] = { 0, -10, -40, 20, 20, 20 };
  const double nearer_way_is_right[6] = { 0, -20, -20, -20, 40, 10 };
  for(const auto& turn_of_face : { nearer_way_is_left, nearer_way_is_right })
  {
    Flat_case<TypeParam> flat_case(model, 30);
    std::size_t k = 0;
    for(const auto f : faces(flat_case.cad_mesh.mesh))
      put(flat_case.maps.alpha, f, get(flat_case.maps.alpha, f) + turn_of_face[k++] * degree);

    std::size_t number_of_lines = 0;
    for(auto line : flat_case.trace(parameters::streamline_spacing(10)))
    {
      if(line.points.front().x() > line.points.back().x())
        std::reverse(line.points.begin(), line.points.end());
      const auto center = std::find_if(line.points.begin(), line.points.end(), [](const Point& p)
                                       { return CGAL::squared_distance(p, Point(0, 0, 0)) < 1e-18; });
      if(center == line.points.end())
        continue;
      ASSERT_NE(line.points.end() - 1, center);
      ++number_of_lines;
      const Vector onward = *(center + 1) - *center;
      EXPECT_NEAR((30 + turn_of_face[3]) * degree, std::atan2(onward.y(), onward.x()), 1e-9);
    }
    EXPECT_EQ(1u, number_of_lines);
  }
}

TYPED_TEST(Streamlines, do_not_depend_on_numbering_or_position)
{
  const Model model = regular_polygon(7, 0.3);
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto move = [&](const Point& p) { return Point(c * p.x() - s * p.y() + 2, s * p.x() + c * p.y() - 1, p.z()); };
  Model moved = transformed(model, move);
  std::reverse(moved.triangles.begin(), moved.triangles.end());
  for(Triangle& t : moved.triangles)
    std::rotate(t.begin(), t.begin() + 1, t.end());

  const auto np = parameters::streamline_spacing(0.11);
  const auto lines = Flat_case<TypeParam>(model, 20).trace(np);
  const auto moved_lines = Flat_case<TypeParam>(moved, 20 + 0.7 / degree).trace(np);
  EXPECT_EQ(lines.size(), moved_lines.size());
  for(const auto& line : lines)
  {
    const Point p = move(line.points.front()), q = move(line.points.back());
    EXPECT_TRUE(std::any_of(moved_lines.begin(), moved_lines.end(), [&](const auto& other)
    {
      const auto is_same = [](const Point& a, const Point& b) { return CGAL::squared_distance(a, b) < 1e-18; };
      return (is_same(p, other.points.front()) && is_same(q, other.points.back()))
             || (is_same(q, other.points.front()) && is_same(p, other.points.back()));
    }));
  }
}

TYPED_TEST(Streamlines, are_straight_through_flat_triangles)
{
  for(const double distance : { 1e-3, 1e-9, 0. })
  {
    Model model = regular_polygon(6, 0.3);
    for(const std::size_t triangle : { 3, 11, 20 })
      model = with_flat_triangle(model, triangle, distance);
    const Flat_case<TypeParam> flat_case(model, 33);
    expect_chords(flat_case, flat_case.trace(parameters::streamline_spacing(0.05)), 1e-8);
  }
}

// What holds for each field: lines stay in their faces and patches, and keep their distances.
template <typename Mesh>
void expect_valid_lines(const Cad_mesh<Mesh>& cad_mesh, const double separation)
{
  const Mesh& mesh = cad_mesh.mesh;
  const Maps<Mesh> maps(mesh);
  ASSERT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index,
                                  cad_mesh.features().matching_map(maps.matching)));
  double area = 0;
  for(const auto f : faces(mesh))
    area += std::sqrt(Kernel::Triangle_3(cad_mesh.point(source(halfedge(f, mesh), mesh)),
                                         cad_mesh.point(target(halfedge(f, mesh), mesh)),
                                         cad_mesh.point(target(next(halfedge(f, mesh), mesh), mesh))).squared_area());
  const double spacing = std::sqrt(area) / 30;
  typedef typename boost::graph_traits<Mesh>::face_descriptor Face;
  std::vector<FF::Streamline<Point, Face> > lines;
  ASSERT_TRUE(FF::trace_streamlines(mesh, maps.alpha, maps.rho, maps.matching, std::back_inserter(lines),
                                    cad_mesh.features().streamline_spacing(spacing).streamline_separation(separation)));

  std::map<Face, int> patch; // flood fill across unconstrained edges
  int number_of_patches = 0;
  for(const auto seed : faces(mesh))
  {
    std::vector<Face> stack{ seed };
    while(!stack.empty())
    {
      const Face f = stack.back();
      stack.pop_back();
      if(!patch.emplace(f, number_of_patches).second)
        continue;
      for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
        if(!is_border(opposite(h, mesh), mesh) && !get(cad_mesh.is_feature, edge(h, mesh)))
          stack.push_back(face(opposite(h, mesh), mesh));
    }
    ++number_of_patches;
  }

  struct Segment_of_line { std::size_t line; Kernel::Segment_3 segment; };
  std::map<std::pair<Face, int>, std::vector<Segment_of_line> > segments;
  std::size_t number_of_good_pieces = 0, number_of_pieces = 0;
  for(std::size_t i = 0; i < lines.size(); ++i)
  {
    const auto& line = lines[i];
    ASSERT_EQ(line.faces.size() + 1, line.points.size());
    ASSERT_EQ(line.faces.size(), line.branches.size());
    for(std::size_t k = 0; k < line.faces.size(); ++k)
    {
      ++number_of_pieces;
      const Face f = line.faces[k];
      const auto h = halfedge(f, mesh);
      const Kernel::Triangle_3 triangle(cad_mesh.point(source(h, mesh)), cad_mesh.point(target(h, mesh)),
                                        cad_mesh.point(target(next(h, mesh), mesh)));
      ASSERT_EQ(patch[line.faces.front()], patch[f]);
      const Kernel::Segment_3 segment(line.points[k], line.points[k + 1]);
      if(!triangle.is_degenerate() && !segment.is_degenerate())
      {
        ASSERT_LT(CGAL::squared_distance(segment.source(), triangle), 1e-16 * area);
        ASSERT_LT(CGAL::squared_distance(segment.target(), triangle), 1e-16 * area);
        const Vector branch = FF::frame_vectors(mesh, f, get(maps.alpha, f), get(maps.rho, f))[line.branches[k]];
        const Vector way = segment.to_vector();
        number_of_good_pieces += way * branch > (1 - 1e-6) * std::sqrt(way.squared_length());
        segments[{ f, line.branches[k] % 2 }].push_back({ i, segment });
      }
    }
  }
  // The others slide along an edge or are too short to have a direction.
  EXPECT_GE(static_cast<double>(number_of_good_pieces), 0.9 * static_cast<double>(number_of_pieces));
  for(const auto& of_face : segments)
    for(const Segment_of_line& a : of_face.second)
      for(const Segment_of_line& b : of_face.second)
        if(a.line < b.line)
        {
          // Samples are a quarter of the separation apart.
          const double least_distance = (1 - 0.25 / 2) * separation * spacing;
          ASSERT_GT(std::sqrt(CGAL::squared_distance(a.segment, b.segment)), least_distance - 1e-9);
        }
}

class Streamlines_on_models : public On_models
{};

TEST_P(Streamlines_on_models, stay_in_their_patches_and_apart)
{
  on_each_mesh_class(GetParam().make(), [](const auto& cad_mesh) { expect_valid_lines(cad_mesh, 0.5); });
}

INSTANTIATE_TEST_SUITE_P(Generated, Streamlines_on_models, testing::ValuesIn(generated_models()), Model_name());
INSTANTIATE_TEST_SUITE_P(Cgal, Streamlines_on_models, testing::ValuesIn(cgal_models()), Model_name());
INSTANTIATE_TEST_SUITE_P(Cad, Streamlines_on_models, testing::ValuesIn(cad_models()), Model_name());

// The default spacing is a length even if there is no area, else these would never end.
TEST(Streamlines_of_degenerate_faces, are_found)
{
  for(const double height : { 0., 1e-200, 1e-14, 1e-6 })
  {
    SCOPED_TRACE(height);
    const Model model = transformed(square(2), [&](const Point& p)
    {
      return Point(p.x() + 0.3 * p.y(), height * p.y(), 0);
    });
    const Cad_mesh<Surface_mesh> cad_mesh(model);
    const Maps<Surface_mesh> maps(cad_mesh.mesh);
    ASSERT_TRUE(FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
                                    cad_mesh.features().matching_map(maps.matching)));
    std::vector<FF::Streamline<Point, Surface_mesh::Face_index> > lines;
    const FF::Result result = FF::trace_streamlines(cad_mesh.mesh, maps.alpha, maps.rho, maps.matching,
                                                    std::back_inserter(lines), cad_mesh.features());
    EXPECT_TRUE(result) << result.message;
    for(const auto& line : lines)
      for(const Point& p : line.points)
        EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
  }
}

template <typename Mesh>
class Streamline_errors : public testing::Test
{
protected:
  typedef FF::Streamline<Point, typename boost::graph_traits<Mesh>::face_descriptor> Streamline;

  Flat_case<Mesh> flat_case{ square(3), 30 };

  template <typename NamedParameters>
  FF::Result trace(const NamedParameters& np)
  {
    std::vector<Streamline> lines;
    const FF::Result result = FF::trace_streamlines(flat_case.cad_mesh.mesh, flat_case.maps.alpha, flat_case.maps.rho,
                                                    flat_case.maps.matching, std::back_inserter(lines), np);
    EXPECT_TRUE(result || lines.empty());
    return result;
  }
};

TYPED_TEST_SUITE(Streamline_errors, Mesh_classes, Mesh_class_names);

TYPED_TEST(Streamline_errors, parameter_out_of_range)
{
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect_named = [](const FF::Result& result, const std::string& name)
  {
    EXPECT_EQ(FF::ERROR_WRONG_PARAMETER, result.error_code);
    EXPECT_NE(std::string::npos, result.message.find(name)) << result.message;
  };
  for(const double spacing : { 0., -1., infinity, nan, 1e-7 })
    expect_named(this->trace(parameters::streamline_spacing(spacing)), "streamline_spacing");
  for(const double separation : { -0.1, 1.1, nan })
    expect_named(this->trace(parameters::streamline_separation(separation)), "streamline_separation");
  for(const double length : { 0., -1., nan })
    expect_named(this->trace(parameters::maximum_streamline_length(length)), "maximum_streamline_length");
}

TYPED_TEST(Streamline_errors, wrong_field)
{
  const auto f = *faces(this->flat_case.cad_mesh.mesh).begin();
  const double alpha = get(this->flat_case.maps.alpha, f);
  put(this->flat_case.maps.alpha, f, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(FF::ERROR_WRONG_FIELD, this->trace(parameters::streamline_spacing(0.1)).error_code);
  put(this->flat_case.maps.alpha, f, alpha);
  EXPECT_EQ(FF::OK, this->trace(parameters::streamline_spacing(0.1)).error_code);
  for(const auto h : halfedges(this->flat_case.cad_mesh.mesh))
    put(this->flat_case.maps.matching, h, 1);
  EXPECT_EQ(FF::ERROR_WRONG_FIELD, this->trace(parameters::streamline_spacing(0.1)).error_code);
}

} // namespace
