#ifndef FRAME_FIELDS_PROGRAMS_BUILD_MESH_H
#define FRAME_FIELDS_PROGRAMS_BUILD_MESH_H

#include "../Mesh.h"
#include "Triangle_surface.h"

#include <algorithm>
#include <cstddef>
#include <vector>

// Numbers of the vertices of a surface, by corner, in the order of the vertices of the file; those that a vertex of the
// file has beside its first one follow at the end. Vertices of the file without a corner can be kept.
struct Vertex_numbers
{
  Vertex_numbers(const Triangle_surface& surface, const std::size_t number_of_file_vertices, const bool keeps_unused)
    : at_corner(surface.number_of_sides(), none)
  {
    std::vector<std::size_t> first_vertex(number_of_file_vertices, none), least_file_vertex(at_corner.size(), none);
    for(std::size_t corner = 0; corner < at_corner.size(); ++corner)
    {
      std::size_t& least = least_file_vertex[surface.vertex_at(corner)];
      least = (std::min)(least, surface.file_vertex(corner));
    }
    std::vector<std::size_t> others;
    for(std::size_t corner = 0; corner < at_corner.size(); ++corner)
      if(surface.vertex_at(corner) == corner)
      {
        std::size_t& first = first_vertex[least_file_vertex[corner]];
        if(first == none)
          first = corner;
        else
          others.push_back(corner);
      }
    for(std::size_t file_vertex = 0; file_vertex < number_of_file_vertices; ++file_vertex)
      if(first_vertex[file_vertex] != none)
        add(first_vertex[file_vertex], file_vertex);
      else if(keeps_unused)
        file_vertex_of.push_back(file_vertex);
    for(const std::size_t corner : others)
      add(corner, least_file_vertex[corner]);
    for(std::size_t corner = 0; corner < at_corner.size(); ++corner)
      at_corner[corner] = at_corner[surface.vertex_at(corner)];
  }

  std::vector<std::size_t> at_corner;
  std::vector<std::size_t> file_vertex_of; // by number

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  void add(const std::size_t corner, const std::size_t file_vertex)
  {
    at_corner[corner] = file_vertex_of.size();
    file_vertex_of.push_back(file_vertex);
  }
};

// The halfedge that follows that of a border side on the other side, where the border goes on.
inline Halfedge next_on_border(const Mesh& mesh, const Halfedge inner)
{
  Halfedge h = inner;
  do
    h = mesh.opposite(mesh.prev(h));
  while(!mesh.is_border(h));
  return h;
}

// Builds the mesh without a walk around any vertex but once along borders, so that fans of any size take linear time.
inline void build_mesh(const std::vector<Point>& points, const Triangle_surface& surface,
                       const Vertex_numbers& vertices, Mesh& mesh)
{
  const std::size_t number_of_sides = surface.number_of_sides();
  std::size_t number_of_edges = 0;
  for(std::size_t side = 0; side < number_of_sides; ++side)
    number_of_edges += surface.is_border(side) || surface.opposite(side) < side;
  const auto vertex = [&](const std::size_t corner)
  {
    return Vertex(static_cast<Mesh::size_type>(vertices.at_corner[corner]));
  };
  mesh.reserve(static_cast<Mesh::size_type>(vertices.file_vertex_of.size()),
               static_cast<Mesh::size_type>(number_of_edges), static_cast<Mesh::size_type>(number_of_sides / 3));
  for(const std::size_t file_vertex : vertices.file_vertex_of)
    mesh.add_vertex(points[file_vertex]);

  std::vector<Halfedge> halfedge(number_of_sides);
  for(std::size_t side = 0; side < number_of_sides; ++side)
    halfedge[side] = !surface.is_border(side) && surface.opposite(side) < side
      ? mesh.opposite(halfedge[surface.opposite(side)])
      : mesh.add_edge(vertex(side), vertex(next_side(side)));
  for(std::size_t t = 0; t < number_of_sides / 3; ++t)
  {
    const Face f = mesh.add_face();
    mesh.set_halfedge(f, halfedge[3 * t + 2]); // as add_face() of a list of vertices does
    for(std::size_t side = 3 * t; side < 3 * t + 3; ++side)
    {
      mesh.set_face(halfedge[side], f);
      mesh.set_next(halfedge[side], halfedge[next_side(side)]);
      mesh.set_halfedge(mesh.target(halfedge[side]), halfedge[side]);
    }
  }
  for(std::size_t side = 0; side < number_of_sides; ++side)
    if(surface.is_border(side))
    {
      const Halfedge border = mesh.opposite(halfedge[side]);
      mesh.set_next(border, next_on_border(mesh, halfedge[side]));
      mesh.set_halfedge(mesh.target(border), border);
    }
}

#endif // FRAME_FIELDS_PROGRAMS_BUILD_MESH_H
