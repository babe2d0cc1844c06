#ifndef TEST_FRAME_FIELDS_QUAD_CONTRACT_H
#define TEST_FRAME_FIELDS_QUAD_CONTRACT_H

#include "test_models.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// What must hold of each quad mesh of a CAD model, checked on lists of faces without any code of the library.
namespace test {

typedef std::pair<std::size_t, std::size_t> Vertex_pair;
inline Vertex_pair vertex_pair(const std::size_t v, const std::size_t w) { return std::minmax(v, w); }

// An oriented surface of polygons and its marked edges: those of features, and those of the border.
struct Marked_surface
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > faces;
  std::set<Vertex_pair> marked_edges;
  std::vector<int> patch;              // per face
  std::vector<char> is_certified;      // per patch
};

// A walk of marked edges between two vertices that do not have exactly two of them, or a closed one.
struct Marked_chain
{
  std::vector<Point> points; // the first one again at the end of a closed one
  bool is_loop = false;
};

// The corners of a surface, numbered face by face. A side goes from its corner to the next one of its face.
class Corner_table
{
public:
  explicit Corner_table(const Marked_surface& surface)
  {
    for(std::size_t f = 0; f < surface.faces.size(); ++f)
    {
      const std::size_t first = vertex.size(), size = surface.faces[f].size();
      for(std::size_t k = 0; k < size; ++k)
      {
        vertex.push_back(surface.faces[f][k]);
        face.push_back(f);
        next.push_back(first + (k + 1) % size);
        previous.push_back(first + (k + size - 1) % size);
      }
    }
    std::map<Vertex_pair, std::size_t> side_of;
    for(std::size_t c = 0; c < vertex.size(); ++c)
      is_manifold = side_of.emplace(Vertex_pair(vertex[c], vertex[next[c]]), c).second
                 && vertex[c] != vertex[next[c]] && is_manifold;
    opposite.assign(vertex.size(), none);
    for(std::size_t c = 0; c < vertex.size(); ++c)
    {
      const auto other = side_of.find(Vertex_pair(vertex[next[c]], vertex[c]));
      if(other != side_of.end())
        opposite[c] = other->second;
    }
    make_fans();
  }

  bool is_border(const std::size_t side) const { return opposite[side] == none; }
  // The corner of the same vertex in the next face counter-clockwise, if there is one.
  std::size_t turned(const std::size_t corner) const { return opposite[previous[corner]]; }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> vertex, face, next, previous, opposite;
  std::vector<std::vector<std::size_t> > fans; // corners counter-clockwise; one fan per vertex of a manifold
  bool is_manifold = true;                     // as far as edges are concerned

private:
  void make_fans()
  {
    std::vector<char> is_visited(vertex.size(), 0);
    const auto add_fan = [&](const std::size_t first)
    {
      fans.emplace_back();
      for(std::size_t c = first; c != none && !is_visited[c]; c = turned(c))
      {
        is_visited[c] = 1;
        fans.back().push_back(c);
      }
    };
    for(std::size_t c = 0; c < vertex.size(); ++c)
      if(is_border(c))
        add_fan(c);
    for(std::size_t c = 0; c < vertex.size(); ++c)
      if(!is_visited[c])
        add_fan(c);
  }
};

// The numbers that tell closed surfaces apart, and most others.
struct Topology
{
  long euler_characteristic = 0;
  std::size_t number_of_components = 0, number_of_border_loops = 0;

  bool operator==(const Topology& other) const
  {
    return euler_characteristic == other.euler_characteristic && number_of_components == other.number_of_components
        && number_of_border_loops == other.number_of_border_loops;
  }
};

inline std::size_t number_of_classes(std::vector<std::size_t>& parent, const std::vector<Vertex_pair>& joined)
{
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&](std::size_t i)
  {
    while(parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  std::size_t result = parent.size();
  for(const Vertex_pair& pair : joined)
    if(root(pair.first) != root(pair.second))
    {
      parent[root(pair.first)] = root(pair.second);
      --result;
    }
  return result;
}

inline Topology topology(const Marked_surface& surface, const Corner_table& corners)
{
  Topology result;
  std::size_t number_of_edges = 0;
  std::vector<Vertex_pair> joined_faces, joined_sides;
  std::vector<std::size_t> border;
  for(std::size_t c = 0; c < corners.vertex.size(); ++c)
  {
    number_of_edges += corners.is_border(c) || corners.opposite[c] > c;
    if(!corners.is_border(c))
    {
      joined_faces.emplace_back(corners.face[c], corners.face[corners.opposite[c]]);
      continue;
    }
    std::size_t before = corners.previous[c];
    while(!corners.is_border(before))
      before = corners.previous[corners.opposite[before]];
    border.push_back(c);
    joined_sides.emplace_back(c, before);
  }
  result.euler_characteristic = static_cast<long>(corners.fans.size()) - static_cast<long>(number_of_edges)
                              + static_cast<long>(surface.faces.size());
  std::vector<std::size_t> parent(surface.faces.size());
  result.number_of_components = number_of_classes(parent, joined_faces);
  parent.resize(corners.vertex.size());
  result.number_of_border_loops =
    number_of_classes(parent, joined_sides) - (corners.vertex.size() - border.size());
  return result;
}

// The angles of a fan between its marked edges, or its numbers of faces.
struct Fan_sector
{
  double angle = 0;
  int number_of_faces = 0;
  std::set<int> patches;
};

inline double angle_at(const Marked_surface& surface, const Corner_table& corners, const std::size_t c)
{
  const Point p = surface.points[corners.vertex[c]];
  const Vector a = surface.points[corners.vertex[corners.next[c]]] - p,
               b = surface.points[corners.vertex[corners.previous[c]]] - p;
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
}

// Empty for a vertex without marked edges.
inline std::vector<Fan_sector> sectors_of_fan(const Marked_surface& surface, const Corner_table& corners,
                                              std::vector<std::size_t> fan)
{
  const auto starts_sector = [&](const std::size_t c)
  { return surface.marked_edges.count(vertex_pair(corners.vertex[c], corners.vertex[corners.next[c]])) > 0; };
  const auto first = std::find_if(fan.begin(), fan.end(), starts_sector);
  std::vector<Fan_sector> result;
  if(first == fan.end())
    return result;
  std::rotate(fan.begin(), first, fan.end());
  for(const std::size_t c : fan)
  {
    if(starts_sector(c))
      result.emplace_back();
    result.back().angle += angle_at(surface, corners, c);
    ++result.back().number_of_faces;
    if(!surface.patch.empty())
      result.back().patches.insert(surface.patch[corners.face[c]]);
  }
  return result;
}

// Chains of marked edges. Vertices of the same coordinates count as one.
inline std::vector<Marked_chain> marked_chains(const Marked_surface& surface)
{
  std::map<Point, std::vector<Point> > neighbors;
  for(const Vertex_pair& edge : surface.marked_edges)
  {
    neighbors[surface.points[edge.first]].push_back(surface.points[edge.second]);
    neighbors[surface.points[edge.second]].push_back(surface.points[edge.first]);
  }
  std::set<std::pair<Point, Point> > is_walked;
  std::vector<Marked_chain> result;
  const auto walk = [&](const Point& start, const Point& second, const bool is_loop)
  {
    if(is_walked.count({ start, second }) > 0)
      return;
    Marked_chain chain{ { start, second }, is_loop };
    is_walked.insert({ start, second });
    is_walked.insert({ second, start });
    while(chain.points.back() != start && neighbors[chain.points.back()].size() == 2)
    {
      const Point before = chain.points[chain.points.size() - 2], last = chain.points.back();
      const std::vector<Point>& both = neighbors[last];
      const Point after = both[0] == before ? both[1] : both[0];
      is_walked.insert({ last, after });
      is_walked.insert({ after, last });
      chain.points.push_back(after);
    }
    result.push_back(chain);
  };
  for(const bool is_loop : { false, true })
    for(const auto& [point, others] : neighbors)
      if((others.size() == 2) == is_loop)
        for(const Point& other : others)
          walk(point, other, is_loop);
  return result;
}

// The length from the start of a chain to a point on it; negative if the point is not on it.
inline double place_on(const Marked_chain& chain, const Point& p, const double tolerance, const double at_least)
{
  double length = 0;
  for(std::size_t i = 0; i + 1 < chain.points.size(); ++i)
  {
    const Vector direction = chain.points[i + 1] - chain.points[i];
    const double square = direction.squared_length(), size = std::sqrt(square);
    const double t = (std::min)((std::max)(((p - chain.points[i]) * direction) / square, 0.), 1.);
    if((p - (chain.points[i] + t * direction)).squared_length() <= tolerance * tolerance
       && length + t * size >= at_least - tolerance)
      return length + t * size;
    length += size;
  }
  return -1;
}

// Whether the vertices of a chain are on another one, in its order and from one end to the other.
inline bool covers(const Marked_chain& chain, Marked_chain other, const double tolerance)
{
  if(chain.is_loop != other.is_loop)
    return false;
  if(chain.is_loop)
  { // A loop of the other one that starts at a vertex of this one.
    const Point start = chain.points.front();
    for(std::size_t i = 0; i + 1 < other.points.size(); ++i)
    {
      const Marked_chain edge{ { other.points[i], other.points[i + 1] } };
      if(place_on(edge, start, tolerance, 0) < 0)
        continue;
      other.points.pop_back();
      std::rotate(other.points.begin(), other.points.begin() + static_cast<std::ptrdiff_t>(i) + 1, other.points.end());
      if(other.points.front() != start)
        other.points.insert(other.points.begin(), start);
      other.points.push_back(start);
      break;
    }
  }
  for(int way = 0; way < 2; ++way)
  {
    bool is_covered = chain.points.front() == other.points.front() && chain.points.back() == other.points.back();
    double place = 0;
    for(std::size_t i = 0; i + 1 < chain.points.size() && is_covered; ++i)
    {
      place = place_on(other, chain.points[i], tolerance, place);
      is_covered = place >= 0;
    }
    if(is_covered)
      return true;
    std::reverse(other.points.begin(), other.points.end());
  }
  return false;
}

inline std::string text(const Point& p)
{
  std::ostringstream out;
  out.precision(17);
  out << "(" << p << ")";
  return out.str();
}

// The least cosine-like product of the quad's normal and those of its corners, all of length one.
inline double least_scaled_jacobian(const Marked_surface& quads, const std::size_t f)
{
  const std::vector<std::size_t>& face = quads.faces[f];
  std::array<Vector, 4> sides;
  for(std::size_t k = 0; k < 4; ++k)
    sides[k] = quads.points[face[(k + 1) % 4]] - quads.points[face[k]];
  const Vector normal = CGAL::cross_product(quads.points[face[2]] - quads.points[face[0]],
                                            quads.points[face[3]] - quads.points[face[1]]);
  double least = 1;
  for(std::size_t k = 0; k < 4; ++k)
  {
    const Vector& before = sides[(k + 3) % 4];
    const double lengths = std::sqrt(normal.squared_length())
                         * std::sqrt(sides[k].squared_length()) * std::sqrt(before.squared_length());
    const double product = CGAL::cross_product(before, sides[k]) * normal;
    least = (std::min)(least, lengths > 0 ? product / lengths : -1.);
  }
  return least;
}

inline std::size_t number_of_inverted_quads(const Marked_surface& quads)
{
  std::size_t result = 0;
  for(std::size_t f = 0; f < quads.faces.size(); ++f)
    result += !(least_scaled_jacobian(quads, f) > 0);
  return result;
}

// The valences other than 4 of vertices without marked edges in certified patches, sorted.
inline std::vector<int> irregular_valences(const Marked_surface& quads)
{
  const Corner_table corners(quads);
  std::vector<int> result;
  for(const std::vector<std::size_t>& fan : corners.fans)
    if(sectors_of_fan(quads, corners, fan).empty() && fan.size() != 4
       && quads.is_certified[quads.patch[corners.face[fan.front()]]])
      result.push_back(static_cast<int>(fan.size()));
  std::sort(result.begin(), result.end());
  return result;
}

// One line for each fact of the contract that does not hold, but for those of single quads.
class Quad_contract
{
public:
  Quad_contract(const Marked_surface& triangles, const Marked_surface& quads)
    : m_triangles(triangles), m_quads(quads), m_corners(triangles), m_quad_corners(quads)
  {
    double largest = 0, smallest = 0;
    for(const Point& p : triangles.points)
      for(int k = 0; k < 3; ++k)
      {
        largest = (std::max)(largest, p[k]);
        smallest = (std::min)(smallest, p[k]);
      }
    m_tolerance = 1e-12 * (largest - smallest);
    check_manifold();
    if(m_faults.tellp() > 0)
      return; // the others rely on it
    check_features();
    check_sectors();
  }

  std::string broken_facts() const { return m_faults.str(); }

private:
  void check_manifold()
  {
    std::vector<int> number_of_fans(m_quads.points.size(), 0);
    for(const std::vector<std::size_t>& fan : m_quad_corners.fans)
      ++number_of_fans[m_quad_corners.vertex[fan.front()]];
    std::map<Point, int> allowed; // a vertex of a border may have more, if it has them in the triangle mesh
    for(const std::vector<std::size_t>& fan : m_corners.fans)
      ++allowed[m_triangles.points[m_corners.vertex[fan.front()]]];
    for(std::size_t v = 0; v < number_of_fans.size(); ++v)
      if(number_of_fans[v] != 1
         && (allowed.count(m_quads.points[v]) == 0 || number_of_fans[v] != allowed[m_quads.points[v]]))
        m_faults << "vertex " << v << " has " << number_of_fans[v] << " fans\n";
    if(!m_quad_corners.is_manifold)
      m_faults << "an edge is no edge of a manifold\n";
    for(std::size_t f = 0; f < m_quads.faces.size(); ++f)
      if(m_quads.faces[f].size() != 4)
        m_faults << "face " << f << " has " << m_quads.faces[f].size() << " vertices\n";
    for(const Point& p : m_quads.points)
      if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
        m_faults << "point " << p << "\n";
    const Topology expected = topology(m_triangles, m_corners), actual = topology(m_quads, m_quad_corners);
    if(!(actual == expected))
      m_faults << "Euler characteristic " << actual.euler_characteristic << " for " << expected.euler_characteristic
               << ", components " << actual.number_of_components << " for " << expected.number_of_components
               << ", border loops " << actual.number_of_border_loops << " for " << expected.number_of_border_loops
               << "\n";
    for(std::size_t c = 0; c < m_quad_corners.vertex.size(); ++c)
      if(m_quad_corners.is_border(c)
         && m_quads.marked_edges.count(vertex_pair(m_quad_corners.vertex[c],
                                                   m_quad_corners.vertex[m_quad_corners.next[c]])) == 0)
        m_faults << "border edge " << m_quad_corners.vertex[c] << " is not marked\n";
  }

  void check_features()
  {
    std::vector<Marked_chain> chains = marked_chains(m_quads);
    std::vector<Marked_chain> expected = marked_chains(m_triangles);
    // A chain of one edge covers any feature between its ends, so it must not choose first.
    std::stable_sort(chains.begin(), chains.end(), [](const Marked_chain& a, const Marked_chain& b)
                     { return a.points.size() > b.points.size(); });
    for(const Marked_chain& chain : chains)
    {
      const auto covered = std::find_if(expected.begin(), expected.end(),
                                        [&](const Marked_chain& other) { return covers(chain, other, m_tolerance); });
      if(covered == expected.end())
        m_faults << "marked edges from " << text(chain.points.front()) << " to " << text(chain.points.back())
                 << (chain.is_loop ? " (loop)" : "") << " cover no feature\n";
      else
        expected.erase(covered);
    }
    for(const Marked_chain& chain : expected)
      m_faults << "the feature from " << text(chain.points.front()) << " to " << text(chain.points.back())
               << (chain.is_loop ? " (loop)" : "") << " is not covered\n";
  }

  // Numbers of quads at nodes, and two on each side of other points of features.
  void check_sectors()
  {
    std::map<Point, std::vector<int> > expected;
    std::set<Point> undecided;
    for(const std::vector<std::size_t>& fan : m_corners.fans)
    {
      const Point p = m_triangles.points[m_corners.vertex[fan.front()]];
      const std::vector<Fan_sector> sectors = sectors_of_fan(m_triangles, m_corners, fan);
      for(const Fan_sector& sector : sectors)
      {
        const double quarters = 2 * sector.angle / CGAL_PI;
        if(quarters > 1 && std::abs(quarters - std::floor(quarters) - 0.5) < 0.02)
          undecided.insert(p);
        expected[p].push_back((std::max)(1, static_cast<int>(std::lround(quarters))));
      }
    }
    std::map<Point, std::vector<int> > numbers;
    for(const std::vector<std::size_t>& fan : m_quad_corners.fans)
    {
      const Point p = m_quads.points[m_quad_corners.vertex[fan.front()]];
      for(const Fan_sector& sector : sectors_of_fan(m_quads, m_quad_corners, fan))
      {
        const bool is_certified = m_quads.is_certified[*sector.patches.begin()];
        if(sector.patches.size() != 1)
          m_faults << "no feature parts the patches at " << text(p) << "\n";
        if(expected.count(p) > 0)
          numbers[p].push_back(is_certified ? sector.number_of_faces : 0);
        else if(is_certified && sector.number_of_faces != 2)
          m_faults << sector.number_of_faces << " quads in a straight sector at " << text(p) << "\n";
      }
    }
    for(auto& [p, numbers_expected] : expected)
      if(undecided.count(p) == 0)
        check_node(p, numbers_expected, numbers[p]);
  }

  void check_node(const Point& p, std::vector<int>& expected, std::vector<int>& numbers)
  {
    if(numbers.empty())
    {
      if(expected != std::vector<int>(expected.size(), 2) || expected.size() > 2)
        m_faults << "the node " << text(p) << " is no vertex\n";
      return;
    }
    for(const int number : numbers) // those of certified patches are among the expected ones
    {
      const auto place = std::find(expected.begin(), expected.end(), number);
      if(number != 0 && place == expected.end())
        m_faults << number << " quads in a sector at the node " << text(p) << " for " << expected.front() << "\n";
      else if(number != 0)
        expected.erase(place);
    }
  }

  const Marked_surface& m_triangles;
  const Marked_surface& m_quads;
  Corner_table m_corners, m_quad_corners;
  double m_tolerance = 0;
  std::ostringstream m_faults;
};

} // namespace test

#endif // TEST_FRAME_FIELDS_QUAD_CONTRACT_H
