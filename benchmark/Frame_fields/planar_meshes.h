#ifndef BENCHMARK_FRAME_FIELDS_PLANAR_MESHES_H
#define BENCHMARK_FRAME_FIELDS_PLANAR_MESHES_H

// Planar domains and the meshes of them that study_mesh_dependence.cpp compares.

#include <CGAL/Frame_fields/split_overconstrained_faces.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

typedef std::vector<Point_2> Polyline; // closed: its last point is joined to its first one

typedef CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                             CGAL::Delaunay_mesh_face_base_2<Kernel> > Triangulation_structure;
typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Triangulation_structure> Triangulation;
typedef CGAL::Delaunay_mesher_2<Triangulation, CGAL::Delaunay_mesh_size_criteria_2<Triangulation> > Delaunay_mesher;

// A point moves to (x factor, y / factor) before it is triangulated and back afterwards: factors below 1 make triangles
// that are long in the direction of x.
inline Point_2 stretched(const Point_2& p, const double factor) { return Point_2(p.x() * factor, p.y() / factor); }

inline std::vector<Point_2> stretched(std::vector<Point_2> points, const double factor)
{
  for(Point_2& p : points)
    p = stretched(p, factor);
  return points;
}

// Copies the marked faces and makes them ready for the frame field.
inline Mesh mesh_of_marked_faces(const Triangulation& triangulation, const double stretch)
{
  Mesh mesh;
  std::map<Triangulation::Vertex_handle, Mesh::Vertex_index> vertices;
  const auto vertex = [&](const Triangulation::Vertex_handle v)
  {
    const auto [place, is_new] = vertices.insert({ v, Mesh::Vertex_index() });
    if(is_new)
    {
      const Point_2 p = stretched(v->point(), 1 / stretch);
      place->second = mesh.add_vertex(Point_3(p.x(), p.y(), 0));
    }
    return place->second;
  };
  for(const auto f : triangulation.finite_face_handles())
    if(f->is_in_domain())
      mesh.add_face(vertex(f->vertex(0)), vertex(f->vertex(1)), vertex(f->vertex(2)));
  if(const CGAL::Frame_fields::Result result = CGAL::Frame_fields::split_overconstrained_faces(mesh); !result)
    throw std::runtime_error(result.message);
  return mesh;
}

inline Triangulation triangulation_of(const std::vector<Polyline>& borders, const double stretch)
{
  Triangulation triangulation;
  for(const Polyline& border : borders)
  {
    const Polyline points = stretched(border, stretch);
    triangulation.insert_constraint(points.begin(), points.end(), true);
  }
  return triangulation;
}

// The constrained Delaunay mesh of the points inside the first border and outside the others.
inline Mesh delaunay_mesh(const std::vector<Polyline>& borders, const std::vector<Point_2>& points_in_holes,
                          const std::vector<Point_2>& interior_points, const double stretch = 1)
{
  Triangulation triangulation = triangulation_of(borders, stretch);
  const std::vector<Point_2> points = stretched(interior_points, stretch), seeds = stretched(points_in_holes, stretch);
  triangulation.insert(points.begin(), points.end());
  Delaunay_mesher::mark_facets(triangulation, seeds.begin(), seeds.end());
  return mesh_of_marked_faces(triangulation, stretch);
}

// The Delaunay refinement of the borders to edges of length `size`.
inline Mesh refined_delaunay_mesh(const std::vector<Polyline>& borders, const std::vector<Point_2>& points_in_holes,
                                  const double size)
{
  Triangulation triangulation = triangulation_of(borders, 1);
  Delaunay_mesher mesher(triangulation, CGAL::Delaunay_mesh_size_criteria_2<Triangulation>(0.125, size));
  mesher.set_seeds(points_in_holes.begin(), points_in_holes.end());
  mesher.refine_mesh();
  return mesh_of_marked_faces(triangulation, 1);
}

// ------------------------------------------------------------------------------------------------------------- wedges

enum Wedge_kind
{
  REGULAR,   // rows across the wedge, as far apart as the points in each
  IRREGULAR, // random points
  GRADED,    // the distances of the rows from the tip are squares
  NEEDLES    // rows with points four times as dense, at least four triangles wide
};

// Both sides start at the origin and have length 1; the third one is straight.
struct Wedge
{
  double angle;
  int edges_per_side;
  Wedge_kind kind;
  int seed, number_of_seeds; // shifts the rows by a part of their distance, or seeds the random points
};

inline Point_2 point_of_wedge(const Wedge& wedge, const double distance, const double part)
{
  return Point_2(distance * std::cos(part * wedge.angle), distance * std::sin(part * wedge.angle));
}

// The distances of the rows from the tip, the last one 1.
inline std::vector<double> rows_of_wedge(const Wedge& wedge)
{
  const int n = wedge.edges_per_side;
  const double shift = wedge.kind == IRREGULAR ? 0 : (wedge.seed + 0.5) / wedge.number_of_seeds - 0.5;
  std::vector<double> result;
  for(int i = 1; i < n; ++i)
    result.push_back(std::pow((i + shift) / n, wedge.kind == GRADED ? 2 : 1));
  result.push_back(1);
  return result;
}

inline Polyline border_of_wedge(const Wedge& wedge, const std::vector<double>& rows)
{
  Polyline border(1, Point_2(0, 0));
  for(const double row : rows)
    border.push_back(point_of_wedge(wedge, row, 0));
  const Point_2 first = point_of_wedge(wedge, 1, 0), last = point_of_wedge(wedge, 1, 1);
  const int n = (std::max)(2, static_cast<int>(std::lround(wedge.edges_per_side * wedge.angle)));
  for(int i = 1; i < n; ++i)
    border.push_back(first + (last - first) * (static_cast<double>(i) / n));
  for(auto row = rows.rbegin(); row != rows.rend(); ++row)
    border.push_back(point_of_wedge(wedge, *row, 1));
  return border;
}

inline std::vector<Point_2> points_in_rows(const Wedge& wedge, const std::vector<double>& rows)
{
  std::vector<Point_2> result;
  for(std::size_t i = 0; i + 1 < rows.size(); ++i)
  {
    const double width = rows[i] * wedge.angle, spacing = rows[i + 1] - rows[i];
    int n = (std::max)(1, static_cast<int>(std::lround(width / spacing)));
    if(wedge.kind == NEEDLES)
      n *= 4;
    for(int j = 1; j < n; ++j)
      result.push_back(point_of_wedge(wedge, rows[i], static_cast<double>(j) / n));
  }
  return result;
}

// As many as a regular mesh has, none nearer to the border than 0.3 edges.
inline std::vector<Point_2> random_points_in_wedge(const Wedge& wedge)
{
  std::mt19937 generator(wedge.seed + 1000 * wedge.edges_per_side);
  std::uniform_real_distribution<double> uniform(0, 1);
  const double length = 1. / wedge.edges_per_side, margin = 0.3 * length;
  const int n = static_cast<int>(1.15 * wedge.angle / 2 / (length * length));
  std::vector<Point_2> result;
  for(int i = 0; i < n; ++i)
  {
    const double distance = std::sqrt(uniform(generator)), part = uniform(generator);
    const double width = distance * wedge.angle * (std::min)(part, 1 - part);
    if(width >= margin && distance <= std::cos(wedge.angle / 2) - margin)
      result.push_back(point_of_wedge(wedge, distance, part));
  }
  return result;
}

inline Mesh mesh_of(const Wedge& wedge)
{
  const std::vector<double> rows = rows_of_wedge(wedge);
  return delaunay_mesh({ border_of_wedge(wedge, rows) }, {},
                       wedge.kind == IRREGULAR ? random_points_in_wedge(wedge) : points_in_rows(wedge, rows));
}

// ------------------------------------------------------------------------------------------------------------ domains

// A smooth piece of a border, by a parameter from 0 to 1.
typedef std::function<Point_2(double)> Curve;

struct Domain
{
  std::vector<std::vector<Curve> > loops; // the outer border counter-clockwise, then the holes
  std::vector<Point_2> points_in_holes;
  std::vector<Point_2> corners;           // where curves meet at an angle
  double diameter;
};

typedef std::function<double(const Point_2&)> Size; // the length of the edges near a point

inline Curve segment(const Point_2& p, const Point_2& q)
{
  return [=](const double t) { return p + (q - p) * t; };
}

// The circular arc from p to q that bulges to the right by `sagitta`, to the left if it is negative.
inline Curve arc(const Point_2& p, const Point_2& q, const double sagitta)
{
  const Kernel::Vector_2 half = (q - p) / 2;
  const double half_length = std::sqrt(half.squared_length());
  const double half_angle = 2 * std::atan(sagitta / half_length);
  const Kernel::Vector_2 to_right = Kernel::Vector_2(half.y(), -half.x()) / half_length;
  const double radius = half_length / std::sin(half_angle);
  const Point_2 center = p + half - to_right * (radius * std::cos(half_angle));
  return [=](const double t)
  {
    const double angle = (2 * t - 1) * half_angle;
    return center + to_right * (radius * std::cos(angle)) + half * (radius * std::sin(angle) / half_length);
  };
}

inline Curve circle(const Point_2& center, const double radius)
{
  return [=](const double t)
  {
    return center + Kernel::Vector_2(std::cos(2 * CGAL_PI * t), std::sin(2 * CGAL_PI * t)) * radius;
  };
}

inline std::vector<Curve> polygon(const std::vector<Point_2>& corners)
{
  std::vector<Curve> result;
  for(std::size_t i = 0; i < corners.size(); ++i)
    result.push_back(segment(corners[i], corners[(i + 1) % corners.size()]));
  return result;
}

// A plate with sharp corners of 23, 43 and 50 degrees, one of 83 and one of 242, an arc that bulges inwards, a round
// and a square hole.
inline Domain plate()
{
  const Point_2 a(0, 0), b(3, 0), c(2.8, 1.6), d(1.3, 1.5), e(1.2, 0.5);
  const std::vector<Point_2> square = { { 1.45, 0.35 }, { 1.5, 0.6 }, { 1.75, 0.55 }, { 1.7, 0.3 } };
  Domain result;
  result.loops = { { segment(a, b), segment(b, c), arc(c, d, -0.35), segment(d, e), segment(e, a) },
                   { circle(Point_2(2.35, 0.6), 0.22) }, polygon(square) };
  result.points_in_holes = { Point_2(2.35, 0.6), Point_2(1.6, 0.45) };
  result.corners = { a, b, c, d, e };
  result.corners.insert(result.corners.end(), square.begin(), square.end());
  result.diameter = std::hypot(2.8, 1.6);
  return result;
}

// Corners of 50 and 130 degrees between two straight and two bent sides: the field should be skew in all of it.
inline Domain bent_parallelogram()
{
  const double angle = 50 * CGAL_PI / 180;
  const Point_2 a(0, 0), b(2, 0), c(2 + std::cos(angle), std::sin(angle)), d(std::cos(angle), std::sin(angle));
  Domain result;
  result.loops = { { arc(a, b, 0.15), segment(b, c), arc(c, d, -0.15), segment(d, a) } };
  result.corners = { a, b, c, d };
  result.diameter = std::sqrt(CGAL::squared_distance(a, c));
  return result;
}

// Points of a curve, without its last one, at distances given by `size` in the stretched domain.
inline void sample(const Curve& curve, const Size& size, const double stretch, Polyline& points)
{
  const int steps = 4000;
  const auto point = [&](const int i) { return stretched(curve(static_cast<double>(i) / steps), stretch); };
  std::vector<double> number_of_edges(1, 0);
  for(int i = 0; i < steps; ++i)
    number_of_edges.push_back(number_of_edges.back() + std::sqrt(CGAL::squared_distance(point(i), point(i + 1)))
                                                         / size(curve((i + 0.5) / steps)));
  const int n = (std::max)(3, static_cast<int>(std::lround(number_of_edges.back())));
  for(int k = 0; k < n; ++k)
  {
    const auto place = std::lower_bound(number_of_edges.begin(), number_of_edges.end(),
                                        k * number_of_edges.back() / n);
    points.push_back(curve(static_cast<double>(place - number_of_edges.begin()) / steps));
  }
}

inline std::vector<Polyline> sampled_borders(const Domain& domain, const Size& size, const double stretch = 1)
{
  std::vector<Polyline> result;
  for(const std::vector<Curve>& loop : domain.loops)
  {
    result.emplace_back();
    for(const Curve& curve : loop)
      sample(curve, size, stretch, result.back());
  }
  return result;
}

inline bool is_inside(const std::vector<Polyline>& borders, const Point_2& p)
{
  for(std::size_t i = 0; i < borders.size(); ++i)
  {
    const CGAL::Bounded_side side = CGAL::bounded_side_2(borders[i].begin(), borders[i].end(), p, Kernel());
    if(side != (i == 0 ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE))
      return false;
  }
  return true;
}

// Random points of the domain, or those of a lattice.
class Point_source
{
public:
  explicit Point_source(const std::vector<Polyline>& borders)
    : m_borders(borders), m_box(CGAL::bbox_2(borders[0].begin(), borders[0].end())), m_generator(1)
  {}

  Point_2 random_point()
  {
    while(true)
    {
      std::uniform_real_distribution<double> x(m_box.xmin(), m_box.xmax()), y(m_box.ymin(), m_box.ymax());
      const double px = x(m_generator), py = y(m_generator);
      if(is_inside(m_borders, Point_2(px, py)))
        return Point_2(px, py);
    }
  }

  std::vector<Point_2> random_points(const int number_of_points)
  {
    std::vector<Point_2> result(number_of_points);
    std::generate(result.begin(), result.end(), [this]() { return random_point(); });
    return result;
  }

  std::vector<Point_2> lattice(const double step_x, const double step_y) const
  {
    std::vector<Point_2> result;
    for(double x = m_box.xmin() + step_x / 2; x < m_box.xmax(); x += step_x)
      for(double y = m_box.ymin() + step_y / 2; y < m_box.ymax(); y += step_y)
        if(is_inside(m_borders, Point_2(x, y)))
          result.push_back(Point_2(x, y));
    return result;
  }

private:
  const std::vector<Polyline>& m_borders;
  CGAL::Bbox_2 m_box;
  std::mt19937 m_generator;
};

// Those of the candidates that keep 0.75 `size` from the points of the border and from each other, in the stretched
// domain.
inline std::vector<Point_2> spaced_points(const std::vector<Polyline>& borders, const std::vector<Point_2>& candidates,
                                          const Size& size, const double stretch)
{
  CGAL::Delaunay_triangulation_2<Kernel> chosen;
  for(const Polyline& border : borders)
  {
    const Polyline points = stretched(border, stretch);
    chosen.insert(points.begin(), points.end());
  }
  std::vector<Point_2> result;
  for(const Point_2& p : candidates)
  {
    const Point_2 q = stretched(p, stretch);
    if(CGAL::squared_distance(chosen.nearest_vertex(q)->point(), q) < std::pow(0.75 * size(p), 2))
      continue;
    chosen.insert(q);
    result.push_back(p);
  }
  return result;
}

inline Mesh refined_mesh(const Domain& domain, const double size)
{
  return refined_delaunay_mesh(sampled_borders(domain, [=](const Point_2&) { return size; }), domain.points_in_holes,
                               size);
}

// Points at random distances of about `size`, in the stretched domain.
inline Mesh spaced_mesh(const Domain& domain, const Size& size, const double stretch = 1)
{
  const std::vector<Polyline> borders = sampled_borders(domain, size, stretch);
  const std::vector<Point_2> candidates = Point_source(borders).random_points(60000);
  return delaunay_mesh(borders, domain.points_in_holes, spaced_points(borders, candidates, size, stretch), stretch);
}

// Random points, as near to one another as they happen to be.
inline Mesh random_mesh(const Domain& domain, const double border_size, const int number_of_points)
{
  const std::vector<Polyline> borders = sampled_borders(domain, [=](const Point_2&) { return border_size; });
  return delaunay_mesh(borders, domain.points_in_holes, Point_source(borders).random_points(number_of_points));
}

// The points of a lattice, needles if its steps differ.
inline Mesh lattice_mesh(const Domain& domain, const double border_size, const double step_x, const double step_y)
{
  const std::vector<Polyline> borders = sampled_borders(domain, [=](const Point_2&) { return border_size; });
  return delaunay_mesh(borders, domain.points_in_holes, Point_source(borders).lattice(step_x, step_y));
}

struct Named_mesh
{
  std::string name;
  Mesh mesh;
};

// The first one is the reference.
inline std::vector<Named_mesh> ten_meshings(const Domain& domain)
{
  const auto near_corners = [&domain](const Point_2& p)
  {
    double distance = domain.diameter;
    for(const Point_2& corner : domain.corners)
      distance = (std::min)(distance, std::sqrt(CGAL::squared_distance(corner, p)));
    return (std::min)(0.12, 0.012 + 0.2 * distance);
  };
  const auto from_left_to_right = [](const Point_2& p) { return 0.12 - 0.033 * p.x(); };
  const auto even = [](const Point_2&) { return 0.05; };
  return { { "refined to 0.03", refined_mesh(domain, 0.03) },
           { "refined to 0.06", refined_mesh(domain, 0.06) },
           { "refined to 0.12", refined_mesh(domain, 0.12) },
           { "random points", random_mesh(domain, 0.05, 1500) },
           { "fine at the corners", spaced_mesh(domain, near_corners) },
           { "finer to the right", spaced_mesh(domain, from_left_to_right) },
           { "stretched 4:1 along x", spaced_mesh(domain, even, 0.5) },
           { "stretched 4:1 along y", spaced_mesh(domain, even, 2) },
           { "needles", lattice_mesh(domain, 0.04, 0.12, 0.012) },
           { "square lattice", lattice_mesh(domain, 0.05, 0.05, 0.05) } };
}

#endif // BENCHMARK_FRAME_FIELDS_PLANAR_MESHES_H
