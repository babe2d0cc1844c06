#ifndef FRAME_FIELDS_PROGRAMS_MESH_COUNTS_H
#define FRAME_FIELDS_PROGRAMS_MESH_COUNTS_H

#include "Mesh.h"
#include "soup/Disjoint_sets.h"

#include <algorithm>
#include <cstddef>
#include <vector>

// The size of a model and what its surface consists of.
struct Mesh_counts
{
  std::size_t faces = 0, vertices = 0;
  std::size_t components = 0; // parts of the surface that share no edge
  std::size_t border_edges = 0, border_loops = 0;
};

inline std::size_t number_of_border_loops(const Mesh& mesh)
{
  std::size_t number = 0;
  std::vector<bool> is_counted(mesh.num_halfedges(), false);
  for(const Halfedge start : mesh.halfedges())
  {
    if(!mesh.is_border(start) || is_counted[start.idx()])
      continue;
    ++number;
    for(Halfedge h = start; !is_counted[h.idx()]; h = mesh.next(h))
      is_counted[h.idx()] = true;
  }
  return number;
}

inline std::size_t number_of_components(const Mesh& mesh)
{
  Disjoint_sets faces(mesh.num_faces());
  for(const Edge e : mesh.edges())
    if(!mesh.is_border(e))
      faces.unite(mesh.face(mesh.halfedge(e)).idx(), mesh.face(mesh.opposite(mesh.halfedge(e))).idx());
  return std::count_if(mesh.faces().begin(), mesh.faces().end(),
                       [&](const Face f) { return faces.find(f.idx()) == f.idx(); });
}

inline Mesh_counts counts_of(const Mesh& mesh)
{
  Mesh_counts result;
  result.faces = mesh.number_of_faces();
  result.vertices = mesh.number_of_vertices();
  result.components = number_of_components(mesh);
  result.border_edges = std::count_if(mesh.edges().begin(), mesh.edges().end(),
                                      [&](const Edge e) { return mesh.is_border(e); });
  result.border_loops = number_of_border_loops(mesh);
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_MESH_COUNTS_H
