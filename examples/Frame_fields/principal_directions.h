#ifndef FRAME_FIELDS_EXAMPLES_PRINCIPAL_DIRECTIONS_H
#define FRAME_FIELDS_EXAMPLES_PRINCIPAL_DIRECTIONS_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

// The points of a face of a `CGAL::Surface_mesh` and of the vertices at most two edges away, those of the face first.
template <typename Mesh>
std::vector<typename Mesh::Point> neighborhood(const typename Mesh::Face_index f, const Mesh& mesh)
{
  const auto on_face = vertices_around_face(mesh.halfedge(f), mesh);
  std::vector<typename Mesh::Vertex_index> neighbors(on_face.begin(), on_face.end());
  std::set<typename Mesh::Vertex_index> found(neighbors.begin(), neighbors.end());
  for(int ring = 0; ring < 2; ++ring)
    for(std::size_t k = 0, end = neighbors.size(); k < end; ++k)
      for(const auto v : vertices_around_target(mesh.halfedge(neighbors[k]), mesh))
        if(v != Mesh::null_vertex() && found.insert(v).second)
          neighbors.push_back(v);
  std::vector<typename Mesh::Point> points;
  for(const auto v : neighbors)
    points.push_back(mesh.point(v));
  return points;
}

// Writes a principal direction of curvature on each face, and the difference of the principal curvatures as weight; the
// weight is 0 where there are too few points to fit a quadric to.
template <typename Mesh, typename DirectionMap, typename WeightMap>
void principal_directions(const Mesh& mesh, const DirectionMap direction, const WeightMap weight)
{
  typedef CGAL::Monge_via_jet_fitting<typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel> Monge_via_jet_fitting;
  const std::size_t degree = 2, least_number_of_points = 6;
  for(const auto f : mesh.faces())
  {
    std::vector<typename Mesh::Point> points = neighborhood(f, mesh);
    if(points.size() < least_number_of_points)
    {
      put(weight, f, 0);
      continue;
    }
    Monge_via_jet_fitting fitting;
    const auto form = fitting(points.begin(), points.end(), degree, degree);
    put(direction, f, form.maximal_principal_direction());
    put(weight, f, std::abs(form.principal_curvatures(0) - form.principal_curvatures(1)));
  }
}

#endif // FRAME_FIELDS_EXAMPLES_PRINCIPAL_DIRECTIONS_H
