#ifndef TEST_QUAD_SURFACE_H
#define TEST_QUAD_SURFACE_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_location.h>
#include <CGAL/Frame_fields/internal/surface/collect_dual_edges.h>
#include <CGAL/Frame_fields/internal/surface/collect_sectors.h>
#include <CGAL/Frame_fields/internal/surface/corner_angles.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Small surfaces as arrays, for the stages that make quads.
namespace test {

using namespace CGAL::Frame_fields::internal;

typedef std::pair<int, int> Vertex_pair;
typedef std::array<int, 3> Triangle;

struct Quad_surface
{
  Cut_surface surface;
  Surface_embedding embedding;
  Feature_network network;

  Coordinates point(const Surface_location& location) const
  {
    Coordinates result{ 0, 0, 0 };
    for(int k = 0; k < 3; ++k)
      for(int i = 0; i < 3; ++i)
        result[i] += location.barycentric[k] * embedding.point[embedding.vertex[3 * location.face + k]][i];
    return result;
  }

  std::vector<Coordinates> points(const Quad_complex& complex) const
  {
    std::vector<Coordinates> result;
    for(const Quad_vertex& v : complex.vertices)
      result.push_back(point(v.location));
    return result;
  }

  int patch_of(const int face) const
  {
    for(std::size_t p = 0; p < surface.patches.size(); ++p)
      if(face >= surface.patches[p].faces.begin_index && face < surface.patches[p].faces.end_index)
        return static_cast<int>(p);
    return -1;
  }

  int source(const int halfedge) const { return embedding.vertex[previous_of(halfedge)]; }
  int target(const int halfedge) const { return embedding.vertex[halfedge]; }

  int place(const int arc, const double position) const
  {
    return (std::min)(static_cast<int>(network.arcs[arc].halfedges.size()) - 1, static_cast<int>(position));
  }

  Surface_location location_on_arc(const int arc, const double position) const
  {
    const int h = network.arcs[arc].halfedges[place(arc, position)];
    Surface_location result;
    result.face = face_of(h);
    result.barycentric = { 0, 0, 0 };
    result.barycentric[h % 3] = position - place(arc, position);
    result.barycentric[previous_of(h) % 3] = 1 - result.barycentric[h % 3];
    return result;
  }

  // A location by search, for points of plane surfaces only (z is not looked at).
  Surface_location locate(const double x, const double y) const
  {
    Surface_location best;
    double best_score = -std::numeric_limits<double>::infinity();
    for(int f = 0; f < surface.number_of_faces(); ++f)
    {
      std::array<Coordinates, 3> p;
      for(int k = 0; k < 3; ++k)
        p[k] = embedding.point[embedding.vertex[3 * f + k]];
      const auto area = [](const Coordinates& a, const Coordinates& b, const double u, const double v)
      { return (b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0]); };
      std::array<double, 3> w{ area(p[1], p[2], x, y), area(p[2], p[0], x, y), area(p[0], p[1], x, y) };
      const double sum = w[0] + w[1] + w[2], score = *std::min_element(w.begin(), w.end()) / sum;
      if(score <= best_score)
        continue;
      best_score = score;
      best.face = f;
      double rest = 0;
      for(double& weight : w)
        rest += weight = (std::max)(0., weight / sum);
      for(int k = 0; k < 3; ++k)
        best.barycentric[k] = w[k] / rest;
    }
    return best;
  }
};

inline int quads_of_sector(const Cut_surface& surface, const int sector)
{
  return (std::max)(1, static_cast<int>(std::round(2 * surface.total_angle[sector] / CGAL_PI)));
}

inline void find_nodes(Quad_surface& s)
{
  std::vector<int> number_of_constrained(s.embedding.point.size(), 0);
  for(int h = 0; h < s.surface.number_of_halfedges(); ++h)
    if(s.surface.is_constrained(h) && s.embedding.twin[h] < h) // once per edge
    {
      ++number_of_constrained[s.source(h)];
      ++number_of_constrained[s.target(h)];
    }
  s.network.is_node.assign(s.embedding.point.size(), false);
  for(std::size_t v = 0; v < s.embedding.point.size(); ++v)
    s.network.is_node[v] = number_of_constrained[v] != 0 && number_of_constrained[v] != 2;
  for(int h = 0; h < s.surface.number_of_halfedges(); ++h)
    if(s.surface.is_constrained_sector(s.surface.sector[h]) && quads_of_sector(s.surface, s.surface.sector[h]) != 2)
      s.network.is_node[s.target(h)] = true;
}

// The halfedge that continues a chain at the target of `halfedge`, on the same side; -1 if there is a node.
inline int continued(const Quad_surface& s, const int halfedge)
{
  if(s.network.is_node[s.target(halfedge)])
    return -1;
  int h = next_of(halfedge);
  while(s.surface.opposite[h] >= 0)
    h = next_of(s.surface.opposite[h]);
  return h;
}

inline void collect_arcs(Quad_surface& s)
{
  s.network.arc.assign(s.surface.number_of_halfedges(), -1);
  s.network.place.assign(s.surface.number_of_halfedges(), -1);
  const auto add_arc = [&](const int first)
  {
    Feature_arc arc{ {}, !s.network.is_node[s.source(first)] };
    for(int h = first; h >= 0 && s.network.arc[h] < 0; h = continued(s, h))
    {
      for(const int side : { h, s.embedding.twin[h] })
        if(side >= 0)
        {
          s.network.arc[side] = static_cast<int>(s.network.arcs.size());
          s.network.place[side] = static_cast<int>(arc.halfedges.size());
        }
      arc.halfedges.push_back(h);
    }
    s.network.arcs.push_back(arc);
  };
  for(const bool starts_at_node : { true, false })
    for(int h = 0; h < s.surface.number_of_halfedges(); ++h)
      if(s.surface.is_constrained(h) && s.network.arc[h] < 0 && (!starts_at_node || s.network.is_node[s.source(h)]))
        add_arc(h);
}

// The surface of counter-clockwise triangles with features.
inline Quad_surface make_surface(const std::vector<Coordinates>& points, const std::vector<Triangle>& triangles,
                                 const std::set<Vertex_pair>& features = {})
{
  std::map<Vertex_pair, int> halfedge_of;
  for(std::size_t f = 0; f < triangles.size(); ++f)
    for(int k = 0; k < 3; ++k) // halfedge 3f + k has the target k
      halfedge_of[{ triangles[f][(k + 2) % 3], triangles[f][k] }] = static_cast<int>(3 * f) + k;
  std::vector<int> opposite(3 * triangles.size(), -1);
  for(const auto& [ends, h] : halfedge_of)
  {
    const auto twin = halfedge_of.find({ ends.second, ends.first });
    if(twin != halfedge_of.end() && features.count(ends) == 0 && features.count(twin->first) == 0)
      opposite[h] = twin->second;
  }

  Quad_surface s;
  std::vector<int> patch_of_face;
  const int number_of_patches = number_patches(opposite, patch_of_face);
  const std::vector<int> order = face_order_by_patches(patch_of_face, number_of_patches, s.surface.patches);
  s.surface.opposite = reorder_opposites(opposite, order);
  std::vector<int> new_halfedge(3 * triangles.size());
  for(std::size_t f = 0; f < order.size(); ++f)
    for(int k = 0; k < 3; ++k)
      new_halfedge[3 * order[f] + k] = static_cast<int>(3 * f) + k;
  s.embedding.point = points;
  s.embedding.vertex.resize(3 * triangles.size());
  s.embedding.twin.assign(3 * triangles.size(), -1);
  for(const auto& [ends, h] : halfedge_of)
  {
    s.embedding.vertex[new_halfedge[h]] = ends.second;
    const auto twin = halfedge_of.find({ ends.second, ends.first });
    if(twin != halfedge_of.end())
      s.embedding.twin[new_halfedge[h]] = new_halfedge[twin->second];
  }
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    std::array<Coordinates, 3> p;
    for(int k = 0; k < 3; ++k)
      p[k] = points[s.embedding.vertex[3 * f + k]];
    const std::array<double, 3> angle = corner_angles(p);
    s.surface.angle.insert(s.surface.angle.end(), angle.begin(), angle.end());
    for(int k = 0; k < 3; ++k)
      s.surface.length.push_back(distance(p[(k + 2) % 3], p[k]));
  }
  collect_sectors<CGAL::Sequential_tag>(s.surface);
  collect_dual_edges<CGAL::Sequential_tag>(s.surface, CGAL::Frame_fields::Edge_weighting::UNIFORM);
  find_nodes(s);
  collect_arcs(s);
  return s;
}

struct Soup
{
  std::vector<Coordinates> points;
  std::vector<Triangle> triangles;
};

// m x n squares of side 1, cut alternately, with inner vertices moved by up to `shift`. Vertex (i, j) is j (m + 1) + i.
inline Soup grid(const int m, const int n, const double shift = 0, const unsigned seed = 1)
{
  Soup soup;
  std::mt19937 generator(seed);
  const auto random = [&] { return shift * (2 * (generator() / 4294967296.) - 1); };
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= m; ++i)
    {
      const bool is_inside = i > 0 && i < m && j > 0 && j < n;
      const double dx = is_inside ? random() : 0, dy = is_inside ? random() : 0;
      soup.points.push_back({ i + dx, j + dy, 0 });
    }
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < m; ++i)
    {
      const int a = j * (m + 1) + i, b = a + 1, c = b + m + 1, d = a + m + 1;
      if((i + j) % 2 == 0)
        soup.triangles.insert(soup.triangles.end(), { Triangle{ a, b, c }, Triangle{ a, c, d } });
      else
        soup.triangles.insert(soup.triangles.end(), { Triangle{ a, b, d }, Triangle{ b, c, d } });
    }
  return soup;
}

// A grid bent round the y axis by `angle`; with 2 pi its ends are one.
inline Soup bent(Soup soup, const double width, const double angle)
{
  const double radius = width / angle;
  for(Coordinates& p : soup.points)
    p = { radius * std::sin(p[0] / radius), p[1], radius * std::cos(p[0] / radius) };
  return soup;
}

// Rings of `n` vertices with radii from `inner` to `outer`; a fan round the middle if `inner` is 0.
inline Soup rings(const int n, const int number_of_rings, const double inner, const double outer)
{
  Soup soup;
  for(int r = 0; r <= number_of_rings; ++r)
    for(int i = 0; i < n; ++i)
    {
      const double radius = inner + (outer - inner) * r / number_of_rings, angle = 2 * CGAL_PI * i / n;
      if(radius > 0 || i == 0)
        soup.points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0 });
    }
  const int first = inner > 0 ? 0 : 1 - n; // of the innermost ring
  for(int r = 0; r < number_of_rings; ++r)
    for(int i = 0; i < n; ++i)
    {
      const int a = first + r * n + i, b = first + r * n + (i + 1) % n, c = b + n, d = a + n;
      if(inner == 0 && r == 0)
        soup.triangles.push_back({ 0, d, c });
      else
        soup.triangles.insert(soup.triangles.end(), { Triangle{ a, d, c }, Triangle{ a, c, b } });
    }
  return soup;
}

} // namespace test

#endif // TEST_QUAD_SURFACE_H
