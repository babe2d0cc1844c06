#ifndef FRAME_FIELDS_PROGRAMS_POLYGON_TRIANGULATOR_H
#define FRAME_FIELDS_PROGRAMS_POLYGON_TRIANGULATOR_H

#include "../Mesh.h"
#include "Triangle.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

// Triangulates polygons, which may be concave, have holes that a bridge joins to the outer ring (an edge that the ring
// runs along in both directions), slits and vertices where they touch themselves. A polygon is a ring of points at
// distinct places, each of which may come more than once.
//
// The points lose one coordinate, which is exact and keeps what lies on which side in any plane that is not upright.
// The triangles are those of the Delaunay triangulation constrained by the ring around which it winds once.
class Polygon_triangulator
{
public:
  explicit Polygon_triangulator(const std::vector<Point>& points) : m_points(&points) {}

  // Appends the triangles, none if there is no area inside the ring. Returns what is wrong with the polygon, or
  // nullptr.
  const char* operator()(std::vector<std::size_t> ring, std::vector<Triangle>& triangles)
  {
    drop_repetitions(ring);
    if(ring.size() == 3)
      triangles.push_back({ ring[0], ring[1], ring[2] });
    if(ring.size() <= 3)
      return nullptr;
    if(is_in_a_line(ring))
    {
      if(is_without_repetition(ring)) // it joins its neighbors, as triangles without area do
        for(std::size_t k = 1; k + 1 < ring.size(); ++k)
          triangles.push_back({ ring[0], ring[k], ring[k + 1] });
      return nullptr;
    }
    const char* result = places_coincide;
    for(const int axis : axes_by_size_of_normal(ring))
    {
      const char* const fault = triangulate_along(axis, ring, triangles);
      if(fault == nullptr)
        return nullptr;
      if(result == places_coincide) // which need not be so in another projection
        result = fault;
    }
    return result;
  }

private:
  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel> Vertex_base;
  typedef CGAL::Triangulation_face_base_with_info_2<int, Kernel> Face_base;
  typedef CGAL::Constrained_triangulation_face_base_2<Kernel, Face_base> Constrained_face_base;
  typedef CGAL::Triangulation_data_structure_2<Vertex_base, Constrained_face_base> Data_structure;
  typedef CGAL::No_constraint_intersection_requiring_constructions_tag Intersection_tag;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data_structure, Intersection_tag> Triangulation;
  typedef Triangulation::Vertex_handle Vertex_handle;
  typedef Triangulation::Face_handle Face_handle;
  typedef std::pair<std::size_t, std::size_t> Directed_edge;

  static constexpr const char* places_coincide = "is folded so that vertices lie on one another";

  const Point& point(const std::size_t vertex) const { return (*m_points)[vertex]; }

  static void drop_repetitions(std::vector<std::size_t>& ring)
  {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while(ring.size() > 1 && ring.front() == ring.back())
      ring.pop_back();
  }

  static bool is_without_repetition(std::vector<std::size_t> ring)
  {
    std::sort(ring.begin(), ring.end());
    return std::adjacent_find(ring.begin(), ring.end()) == ring.end();
  }

  bool is_in_a_line(const std::vector<std::size_t>& ring) const
  {
    return std::all_of(ring.begin(), ring.end(), [&](const std::size_t vertex)
                       { return CGAL::collinear(point(ring[0]), point(ring[1]), point(vertex)); });
  }

  // The axes to look along, the one nearest to the normal first: the projections of the area onto the other two are
  // summed up over the edges.
  std::array<int, 3> axes_by_size_of_normal(const std::vector<std::size_t>& ring) const
  {
    std::array<double, 3> normal = { 0, 0, 0 };
    double size = 0;
    const auto offset = [&](const std::size_t vertex, const int axis)
    {
      return 0.5 * point(vertex)[axis] - 0.5 * point(ring[0])[axis]; // which cannot overflow
    };
    for(const std::size_t vertex : ring)
      for(int axis = 0; axis < 3; ++axis)
        size = (std::max)(size, std::abs(offset(vertex, axis)));
    for(std::size_t k = 0; k < ring.size(); ++k)
      for(int axis = 0; axis < 3; ++axis)
      {
        const int x = (axis + 1) % 3, y = (axis + 2) % 3;
        const std::size_t a = ring[k], b = ring[(k + 1) % ring.size()];
        normal[axis] += (offset(a, x) / size) * (offset(b, y) / size) - (offset(a, y) / size) * (offset(b, x) / size);
      }
    std::array<int, 3> axes = { 0, 1, 2 };
    std::stable_sort(axes.begin(), axes.end(),
                     [&](const int i, const int j) { return std::abs(normal[i]) > std::abs(normal[j]); });
    return axes;
  }

  Kernel::Point_2 projected(const std::size_t vertex, const int axis) const
  {
    return { point(vertex)[(axis + 1) % 3], point(vertex)[(axis + 2) % 3] };
  }

  const char* triangulate_along(const int axis, const std::vector<std::size_t>& ring, std::vector<Triangle>& triangles)
  {
    if(ring.size() == 4 && is_convex_quadrangle(axis, ring))
    {
      divide_quadrangle(ring, triangles);
      return nullptr;
    }
    Triangulation triangulation;
    const std::vector<Vertex_handle> vertices = insert_points(axis, ring, triangulation);
    if(vertices.empty())
      return places_coincide;
    if(const char* const fault = insert_edges(vertices, triangulation))
      return fault;
    return collect_triangles(ring, triangulation, triangles);
  }

  bool is_convex_quadrangle(const int axis, const std::vector<std::size_t>& ring) const
  {
    std::array<CGAL::Orientation, 4> turns;
    for(std::size_t k = 0; k < 4; ++k)
      turns[k] = CGAL::orientation(projected(ring[k], axis), projected(ring[(k + 1) % 4], axis),
                                   projected(ring[(k + 2) % 4], axis));
    return turns[0] != CGAL::COLLINEAR && std::count(turns.begin(), turns.end(), turns[0]) == 4;
  }

  // Takes the shorter diagonal.
  void divide_quadrangle(const std::vector<std::size_t>& ring, std::vector<Triangle>& triangles) const
  {
    const auto length = [&](const std::size_t a, const std::size_t b)
    {
      return std::hypot(point(a).x() - point(b).x(), point(a).y() - point(b).y(), point(a).z() - point(b).z());
    };
    const std::size_t start = length(ring[1], ring[3]) < length(ring[0], ring[2]) ? 1 : 0;
    triangles.push_back({ ring[start], ring[start + 1], ring[start + 2] });
    triangles.push_back({ ring[start], ring[start + 2], ring[(start + 3) % 4] });
  }

  // The vertices in the order of the ring, or none if two places are the same in the projection, or all in a line.
  std::vector<Vertex_handle> insert_points(const int axis, const std::vector<std::size_t>& ring,
                                           Triangulation& triangulation) const
  {
    std::vector<std::size_t> distinct = ring;
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    std::vector<std::pair<Kernel::Point_2, std::size_t> > points;
    for(std::size_t k = 0; k < distinct.size(); ++k)
      points.emplace_back(projected(distinct[k], axis), k);
    triangulation.insert(points.begin(), points.end());
    if(triangulation.number_of_vertices() != distinct.size() || triangulation.dimension() < 2)
      return {};

    std::vector<Vertex_handle> vertex_of(distinct.size()), result;
    for(const Vertex_handle v : triangulation.finite_vertex_handles())
    {
      vertex_of[v->info()] = v;
      v->info() = distinct[v->info()];
    }
    for(const std::size_t vertex : ring)
      result.push_back(vertex_of[std::lower_bound(distinct.begin(), distinct.end(), vertex) - distinct.begin()]);
    return result;
  }

  static const char* insert_edges(const std::vector<Vertex_handle>& vertices, Triangulation& triangulation)
  {
    try
    {
      for(std::size_t k = 0; k < vertices.size(); ++k)
      {
        const Vertex_handle a = vertices[k], b = vertices[(k + 1) % vertices.size()];
        triangulation.insert_constraint(a, b);
        if(!triangulation.is_edge(a, b))
          return "touches itself: a vertex of it lies on one of its edges";
      }
    }
    catch(const Triangulation::Intersection_of_constraints_exception&)
    {
      return "crosses itself";
    }
    return nullptr;
  }

  // How often the ring winds around a face changes at each of its edges, from nothing outside.
  const char* collect_triangles(const std::vector<std::size_t>& ring, const Triangulation& triangulation,
                                std::vector<Triangle>& triangles) const
  {
    std::map<Directed_edge, int> passes;
    for(std::size_t k = 0; k < ring.size(); ++k)
    {
      const std::size_t a = ring[k], b = ring[(k + 1) % ring.size()];
      ++passes[{ a, b }];
      --passes[{ b, a }];
    }
    const int unknown = (std::numeric_limits<int>::max)();
    for(const Face_handle f : triangulation.all_face_handles())
      f->info() = unknown;
    std::vector<Face_handle> faces = { triangulation.infinite_face() };
    faces.front()->info() = 0;
    for(std::size_t i = 0; i < faces.size(); ++i)
      for(int k = 0; k < 3; ++k)
      {
        const Face_handle f = faces[i], g = f->neighbor(k);
        if(g->info() != unknown)
          continue;
        const auto found = f->is_constrained(k)
          ? passes.find({ f->vertex(Triangulation::ccw(k))->info(), f->vertex(Triangulation::cw(k))->info() })
          : passes.end();
        g->info() = f->info() - (found == passes.end() ? 0 : found->second); // f is on the left of the edge
        faces.push_back(g);
      }
    return append_inner_faces(triangulation, triangles);
  }

  static const char* append_inner_faces(const Triangulation& triangulation, std::vector<Triangle>& triangles)
  {
    const std::size_t number_before = triangles.size();
    int winding_number = 0;
    for(const Face_handle f : triangulation.finite_face_handles())
    {
      if(f->info() == 0)
        continue;
      if(winding_number == 0)
        winding_number = f->info();
      if(std::abs(f->info()) != 1 || f->info() != winding_number)
      {
        triangles.resize(number_before);
        return "crosses itself";
      }
      triangles.push_back({ f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() });
      if(winding_number < 0)
        std::swap(triangles.back()[1], triangles.back()[2]);
    }
    return nullptr;
  }

  const std::vector<Point>* m_points;
};

#endif // FRAME_FIELDS_PROGRAMS_POLYGON_TRIANGULATOR_H
