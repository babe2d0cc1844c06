#ifndef FRAME_FIELDS_PROGRAMS_IS_TRIANGLE_MANIFOLD_H
#define FRAME_FIELDS_PROGRAMS_IS_TRIANGLE_MANIFOLD_H

#include "../Mesh.h"

#include <algorithm>
#include <cstddef>
#include <vector>

// Whether halfedges agree with one another, faces are triangles, and borders have more than two edges.
inline bool has_consistent_halfedges(const Mesh& mesh)
{
  return std::all_of(mesh.halfedges().begin(), mesh.halfedges().end(), [&](const Halfedge h)
  {
    const Halfedge next = mesh.next(h), after_next = mesh.next(next);
    return mesh.prev(next) == h && mesh.target(h) == mesh.source(next) && mesh.source(h) != mesh.target(h)
           && mesh.face(h) == mesh.face(next) && mesh.face(h) != mesh.face(mesh.opposite(h)) && after_next != h
           && (mesh.is_border(h) || mesh.next(after_next) == h);
  });
}

// Whether a walk around each vertex meets all of its halfedges, and no more.
inline bool has_one_fan_at_each_vertex(const Mesh& mesh)
{
  std::vector<std::size_t> degree(mesh.num_vertices(), 0);
  for(const Halfedge h : mesh.halfedges())
    ++degree[mesh.target(h)];
  return std::all_of(mesh.vertices().begin(), mesh.vertices().end(), [&](const Vertex v)
  {
    if(degree[v] == 0)
      return true;
    std::size_t number = 0;
    Halfedge h = mesh.halfedge(v);
    do
    {
      if(mesh.target(h) != v)
        return false;
      h = mesh.opposite(mesh.next(h));
    } while(++number < degree[v] && h != mesh.halfedge(v));
    return number == degree[v] && h == mesh.halfedge(v);
  });
}

// What CGAL::is_valid_polygon_mesh() tells of triangle meshes, but vertices may have no faces, and every loop ends.
inline bool is_triangle_manifold(const Mesh& mesh)
{
  return has_consistent_halfedges(mesh) && has_one_fan_at_each_vertex(mesh);
}

#endif // FRAME_FIELDS_PROGRAMS_IS_TRIANGLE_MANIFOLD_H
