#ifndef TEST_FRAME_FIELDS_FUZZ_CHECK_QUADS_H
#define TEST_FRAME_FIELDS_FUZZ_CHECK_QUADS_H

#include "../quad_contract.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// What holds of quads whatever the coordinates are: nothing here looks at distances.
namespace test {

// Marked edges between numbered vertices, and their chains from one vertex without exactly two of them to the next.
class Marked_graph
{
public:
  void add_edge(const std::size_t v, const std::size_t w)
  {
    m_neighbors[v].push_back(w);
    m_neighbors[w].push_back(v);
  }

  std::size_t degree(const std::size_t v) const
  {
    const auto found = m_neighbors.find(v);
    return found == m_neighbors.end() ? 0 : found->second.size();
  }

  const std::map<std::size_t, std::vector<std::size_t> >& neighbors() const { return m_neighbors; }

  // The names of the two ends of each chain, sorted, and the number of closed chains without end. There are no two
  // edges between the same two vertices.
  template <typename Name>
  std::vector<std::pair<long, long> > chains(const Name& name, std::size_t& number_of_loops) const
  {
    std::vector<std::pair<long, long> > result;
    std::set<std::size_t> is_seen;
    for(const auto& [v, around] : m_neighbors)
    {
      if(around.size() == 2)
        continue;
      for(std::size_t last = 0, i = 0; i < around.size(); ++i)
      {
        std::size_t before = v;
        last = around[i];
        while(degree(last) == 2)
        {
          is_seen.insert(last);
          const std::vector<std::size_t>& both = m_neighbors.at(last);
          const std::size_t after = both[0] == before ? both[1] : both[0];
          before = last;
          last = after;
        }
        result.emplace_back(std::minmax(name(v), name(last)));
      }
    }
    std::sort(result.begin(), result.end());
    number_of_loops = 0;
    for(const auto& [v, around] : m_neighbors)
      if(around.size() == 2 && is_seen.insert(v).second)
      {
        ++number_of_loops;
        for(std::size_t at = around[0]; is_seen.insert(at).second; )
        {
          const std::vector<std::size_t>& both = m_neighbors.at(at);
          at = is_seen.count(both[0]) == 0 ? both[0] : both[1];
        }
      }
    return result;
  }

private:
  std::map<std::size_t, std::vector<std::size_t> > m_neighbors;
};

// The facts that do not hold of the quads of a mesh, one a line.
template <typename Mesh, typename Is_feature, typename Quad_mesh, typename Is_marked, typename Location_map>
std::string broken_facts_of_quads(const Mesh& mesh, const Is_feature& is_feature, const Quad_mesh& quads,
                                  const Is_marked& is_marked, const Location_map location)
{
  std::ostringstream broken;
  if(!CGAL::is_valid_polygon_mesh(quads))
    return "the quads are no valid mesh\n";

  const auto surface_of = [](const auto& polygons)
  {
    Marked_surface result;
    for(const auto v : vertices(polygons))
      result.points.resize((std::max)(result.points.size(), static_cast<std::size_t>(v) + 1), polygons.point(v));
    for(const auto f : faces(polygons))
    {
      result.faces.emplace_back();
      for(const auto v : CGAL::vertices_around_face(halfedge(f, polygons), polygons))
        result.faces.back().push_back(v);
    }
    return result;
  };
  const Marked_surface triangles = surface_of(mesh), quad_surface = surface_of(quads);
  for(const std::vector<std::size_t>& face : quad_surface.faces)
    if(face.size() != 4)
      broken << "a face has " << face.size() << " vertices\n";
  for(const Point& p : quad_surface.points)
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      broken << "a point is " << text(p) << "\n";
  const Corner_table corners(triangles), quad_corners(quad_surface);
  if(!quad_corners.is_manifold)
    broken << "an edge is no edge of a manifold\n";
  if(!(topology(quad_surface, quad_corners) == topology(triangles, corners)))
    broken << "the topology is another one\n";

  Marked_graph features, marked;
  for(const auto e : edges(mesh))
    if(is_border(e, mesh) || get(is_feature, e))
      features.add_edge(source(e, mesh), target(e, mesh));
  for(const auto e : edges(quads))
  {
    if(get(is_marked, e))
      marked.add_edge(source(e, quads), target(e, quads));
    else if(is_border(e, quads))
      broken << "a border edge is not marked\n";
  }
  // The vertex of the triangle mesh at which a vertex of the quads is, or -1.
  std::vector<long> vertex_at(quad_surface.points.size(), -1);
  std::map<long, int> number_at;
  for(const auto q : vertices(quads))
  {
    const auto [f, weights] = get(location, q);
    const auto h = halfedge(f, mesh);
    const std::array<std::size_t, 3> corner{ source(h, mesh), target(h, mesh), target(next(h, mesh), mesh) };
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      sum += weights[k];
      if(!(weights[k] >= 0))
        broken << "a barycentric coordinate is " << weights[k] << "\n";
      if(weights[k] == 1)
        vertex_at[q] = static_cast<long>(corner[k]);
    }
    if(!(std::abs(sum - 1) < 1e-9))
      broken << "barycentric coordinates have the sum " << sum << "\n";
    const std::size_t degree = marked.degree(q);
    if(degree == 0) // beside a needle's side of 1e8 widths, rounding may put it at a node as well
      continue;
    ++number_at[vertex_at[q]];
    bool is_on_feature = false;
    for(const auto side : CGAL::halfedges_around_face(h, mesh))
      for(int k = 0; k < 3; ++k)
        is_on_feature |= weights[k] == 0 && (get(is_feature, edge(side, mesh)) || is_border(edge(side, mesh), mesh))
                      && static_cast<std::size_t>(source(side, mesh)) == corner[(k + 1) % 3];
    if(vertex_at[q] < 0 ? degree != 2 || !is_on_feature
                        : degree != features.degree(static_cast<std::size_t>(vertex_at[q])))
      broken << "vertex " << q << " with " << degree << " marked edges is at vertex " << vertex_at[q] << "\n";
  }
  for(const auto& [v, around] : features.neighbors())
    if(around.size() != 2 && number_at[static_cast<long>(v)] != 1)
      broken << "node " << v << " is " << number_at[static_cast<long>(v)] << " times a vertex\n";
  if(broken.tellp() > 0)
    return broken.str();
  std::size_t loops = 0, marked_loops = 0;
  const auto chains = features.chains([](const std::size_t v) { return static_cast<long>(v); }, loops);
  const auto marked_chains = marked.chains([&](const std::size_t q) { return vertex_at[q]; }, marked_loops);
  if(chains != marked_chains || loops != marked_loops)
    broken << "features have " << chains.size() << " chain ends and " << loops << " loops, marked edges "
           << marked_chains.size() << " and " << marked_loops << "\n";
  return broken.str();
}

} // namespace test

#endif // TEST_FRAME_FIELDS_FUZZ_CHECK_QUADS_H
