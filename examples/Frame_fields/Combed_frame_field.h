#ifndef FRAME_FIELDS_EXAMPLES_COMBED_FRAME_FIELD_H
#define FRAME_FIELDS_EXAMPLES_COMBED_FRAME_FIELD_H

#include <CGAL/Frame_fields/frame_vectors.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <vector>

// The directions of a frame field, numbered such that direction k of a face goes on as direction k of its neighbor
// across all unconstrained edges but the seams. Seams end at singularities and at constrained edges.
template <typename Point>
class Combed_frame_field
{
public:
  typedef CGAL::Surface_mesh<Point> Mesh;
  typedef typename Mesh::Face_index Face;
  typedef typename Mesh::Halfedge_index Halfedge;
  typedef typename CGAL::Kernel_traits<Point>::Kernel::Vector_3 Vector;
  template <typename Key, typename Value> using Map = typename Mesh::template Property_map<Key, Value>;

  Combed_frame_field(const Mesh& mesh, const Map<typename Mesh::Edge_index, bool> is_feature,
                     const Map<Face, double> alpha, const Map<Face, double> rho, const Map<Halfedge, int> matching)
    : m_mesh(mesh), m_is_feature(is_feature), m_alpha(alpha), m_rho(rho), m_matching(matching)
    , m_turn(mesh.num_faces(), -1)
  {
    for(const Face f : mesh.faces())
      if(m_turn[f] == -1)
        comb_patch(f);
  }

  bool is_constrained(const Halfedge h) const
  {
    return m_is_feature[m_mesh.edge(h)] || m_mesh.is_border(m_mesh.edge(h));
  }

  std::array<Vector, 4> directions(const Face f) const
  {
    std::array<Vector, 4> result = CGAL::Frame_fields::frame_vectors(m_mesh, f, m_alpha[f], m_rho[f]);
    std::rotate(result.begin(), result.begin() + m_turn[f], result.end());
    return result;
  }

  // Direction k of the face of `h`, which is not constrained, goes on as direction k + jump of the neighbor.
  int jump(const Halfedge h) const
  {
    return modulo_4(m_turn[m_mesh.face(h)] + m_matching[h] - m_turn[m_mesh.face(m_mesh.opposite(h))]);
  }

  // The number of the direction that runs along the constrained halfedge `h` in its face, or -1 if it has none.
  int direction_along(const Halfedge h) const
  {
    if(m_mesh.is_border(h))
      return -1;
    const Vector along(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)));
    const auto all = directions(m_mesh.face(h));
    const auto is_less = [&](const Vector& a, const Vector& b) { return a * along < b * along; };
    return static_cast<int>(std::max_element(all.begin(), all.end(), is_less) - all.begin());
  }

private:
  static int modulo_4(const int k) { return (k % 4 + 4) % 4; }

  // A branch keeps its number wherever the search comes through.
  void comb_patch(const Face start)
  {
    m_turn[start] = 0;
    for(std::vector<Face> stack{ start }; !stack.empty();)
    {
      const Face f = stack.back();
      stack.pop_back();
      for(const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
      {
        const Face neighbor = m_mesh.face(m_mesh.opposite(h));
        if(is_constrained(h) || m_turn[neighbor] != -1)
          continue;
        m_turn[neighbor] = modulo_4(m_turn[f] + m_matching[h]);
        stack.push_back(neighbor);
      }
    }
  }

  const Mesh& m_mesh;
  Map<typename Mesh::Edge_index, bool> m_is_feature;
  Map<Face, double> m_alpha, m_rho;
  Map<Halfedge, int> m_matching;
  std::vector<int> m_turn; // direction k of a face is branch k + turn
};

#endif // FRAME_FIELDS_EXAMPLES_COMBED_FRAME_FIELD_H
