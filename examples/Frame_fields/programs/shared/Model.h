#ifndef FRAME_FIELDS_PROGRAMS_MODEL_H
#define FRAME_FIELDS_PROGRAMS_MODEL_H

#include "Console.h"
#include "Failure.h"
#include "Mesh.h"
#include "Shared_options.h"
#include "Soup.h"
#include "repair_soup.h"
#include "soup/Disjoint_sets.h"
#include "soup/Triangle_surface.h"
#include "soup/build_mesh.h"
#include "soup/first_at_each_place.h"
#include "soup/is_triangle_manifold.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

// The triangle mesh of a file. Vertices of the file and of the mesh belong together if their parts are the same: a
// repair may make one vertex of several ones, or several of one.
struct Model
{
  Mesh mesh;
  std::vector<std::size_t> part_in_file; // by vertex of the file
  std::vector<std::size_t> part_in_mesh; // by vertex of the mesh
  bool has_faces_of_file;                // in the same order
};

// Whether each vertex of the file is one vertex of the surface, or none.
inline bool keeps_vertices(const Triangle_surface& surface, const std::size_t number_of_file_vertices)
{
  const std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> vertex_of(number_of_file_vertices, none), file_vertex_of(surface.number_of_sides(), none);
  for(std::size_t corner = 0; corner < surface.number_of_sides(); ++corner)
  {
    const std::size_t file_vertex = surface.file_vertex(corner), vertex = surface.vertex_at(corner);
    std::size_t& known_vertex = vertex_of[file_vertex];
    std::size_t& known_file_vertex = file_vertex_of[vertex];
    if((known_vertex != none && known_vertex != vertex)
       || (known_file_vertex != none && known_file_vertex != file_vertex))
      return false;
    known_vertex = vertex;
    known_file_vertex = file_vertex;
  }
  return true;
}

// Compares at each place the number of vertices of the file with that of the surface.
inline void warn_of_vertices(const Triangle_surface& surface, const std::vector<std::size_t>& place,
                             const bool keeps_unused, const Repair_log& log)
{
  std::vector<std::size_t> in_file(place.size(), 0), in_surface(place.size(), 0);
  for(const std::size_t p : place)
    ++in_file[p];
  for(std::size_t corner = 0; corner < surface.number_of_sides(); ++corner)
    in_surface[surface.place_at(corner)] += surface.vertex_at(corner) == corner;
  std::size_t number_of_merged = 0, number_of_unused = 0, number_of_added = 0;
  for(std::size_t p = 0; p < place.size(); ++p)
    if(in_surface[p] == 0)
      number_of_unused += keeps_unused ? 0 : in_file[p];
    else if(in_surface[p] < in_file[p])
      number_of_merged += keeps_unused ? 0 : in_file[p] - in_surface[p];
    else
      number_of_added += in_surface[p] - in_file[p];
  log.warn("duplicate vertices merged", number_of_merged);
  log.warn("vertices without faces removed", number_of_unused);
  log.warn("vertices duplicated where the surface is not a manifold", number_of_added);
}

inline void number_parts(const Triangle_surface& surface, const Vertex_numbers& vertices,
                         const std::vector<std::size_t>& place, Model& model)
{
  Disjoint_sets parts(place.size());
  std::vector<bool> is_used(place.size(), false);
  std::vector<std::size_t> used_at(place); // by place: a vertex of the file with a face
  for(std::size_t corner = 0; corner < surface.number_of_sides(); ++corner)
  {
    const std::size_t file_vertex = surface.file_vertex(corner);
    parts.unite(file_vertex, vertices.file_vertex_of[vertices.at_corner[corner]]);
    is_used[file_vertex] = true;
    used_at[place[file_vertex]] = file_vertex;
  }
  for(std::size_t file_vertex = 0; file_vertex < place.size(); ++file_vertex)
    if(!is_used[file_vertex])
      parts.unite(file_vertex, used_at[place[file_vertex]]);
  for(std::size_t file_vertex = 0; file_vertex < place.size(); ++file_vertex)
    model.part_in_file.push_back(parts.find(file_vertex));
  for(const std::size_t file_vertex : vertices.file_vertex_of)
    model.part_in_mesh.push_back(parts.find(file_vertex));
}

inline void check_mesh(const std::string& path, const Mesh& mesh, const Triangle_surface& surface)
{
  if(mesh.number_of_faces() != surface.triangles().size() || !is_triangle_manifold(mesh))
    throw Failure(BAD_FILE, path + ": its faces cannot be made an oriented manifold mesh");
}

// Keeps the vertices and faces of the file as they are if they make an oriented manifold mesh.
inline Model make_model(const Shared_options& options, const Soup& soup, Console& console)
{
  std::vector<std::size_t> place(soup.points.size());
  if(options.merges_vertices)
    place = first_at_each_place(soup.points);
  else
    std::iota(place.begin(), place.end(), std::size_t(0));

  Repair_log log{ options.model, console };
  const Triangle_surface surface = repaired_surface(soup, options, place, log);
  log.warn_of_faces("faces turned around for a consistent orientation", surface.number_of_turned_triangles());
  log.warn("edges cut where the surface has one side only", surface.number_of_cut_edges());
  const bool keeps_unused = log.has_all_faces && keeps_vertices(surface, soup.points.size());
  warn_of_vertices(surface, place, keeps_unused, log);
  warn_of_cracks(soup.points, surface, log);

  Model model;
  const Vertex_numbers vertices(surface, soup.points.size(), keeps_unused);
  number_parts(surface, vertices, place, model);
  build_mesh(soup.points, surface, vertices, model.mesh);
  check_mesh(options.model, model.mesh, surface);
  model.has_faces_of_file = log.has_all_faces;
  return model;
}

#endif // FRAME_FIELDS_PROGRAMS_MODEL_H
