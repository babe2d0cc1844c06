#ifndef FRAME_FIELDS_PROGRAMS_MODEL_H
#define FRAME_FIELDS_PROGRAMS_MODEL_H

#include "Console.h"
#include "Failure.h"
#include "Mesh.h"
#include "Soup.h"
#include "repair_soup.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

// The triangle mesh of a file. A place is what a vertex keeps through a repair: vertices of the file and of the mesh
// belong together if their places are the same.
struct Model
{
  Mesh mesh;
  std::vector<std::size_t> place_in_file; // by vertex of the file
  std::vector<std::size_t> place_in_mesh; // by vertex of the mesh
  bool has_faces_of_file;                 // in the same order
};

// Numbers places by their coordinates, which no repair changes.
class Place_numbers
{
public:
  std::vector<std::size_t> operator()(const std::vector<Point>& points)
  {
    std::vector<std::size_t> places;
    for(const Point& point : points)
      places.push_back(m_numbers.try_emplace(point, m_numbers.size()).first->second);
    return places;
  }

private:
  std::map<Point, std::size_t> m_numbers;
};

// Tells whether there was nothing to do.
inline bool triangulate(const std::string& path, Mesh& mesh, Console& console)
{
  std::size_t number_of_polygons = 0;
  for(const Face f : mesh.faces())
    number_of_polygons += !CGAL::is_triangle(mesh.halfedge(f), mesh);
  if(number_of_polygons == 0)
    return true;

  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  mesh.collect_garbage();
  for(const Face f : mesh.faces())
    if(!CGAL::is_triangle(mesh.halfedge(f), mesh))
      throw Failure(BAD_FILE, path + ": the face at vertex " + std::to_string(mesh.target(mesh.halfedge(f)).idx())
                              + " (counted from 0) cannot be triangulated; triangulate it before");
  console.warn(path + ": faces of more than three vertices triangulated: " + std::to_string(number_of_polygons));
  return false;
}

// A soup of triangles that share no vertices is a mesh, too, but hardly what the user means.
inline void warn_of_touching_borders(const std::string& path, const Mesh& mesh, Console& console)
{
  std::set<Point> points;
  std::size_t number_of_border_vertices = 0;
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h))
    {
      ++number_of_border_vertices;
      points.insert(mesh.point(mesh.target(h)));
    }
  if(points.size() < number_of_border_vertices)
    console.warn(path + ": border vertices that lie on others but are not the same: "
                 + std::to_string(number_of_border_vertices - points.size())
                 + "; merge them if the surface is meant to go on there");
}

// Keeps the vertices and faces of the file as they are if they make an oriented manifold mesh.
inline Model make_model(const std::string& path, Soup soup, Console& console)
{
  Model model;
  const bool keeps_soup = is_mesh(soup);
  if(keeps_soup)
  {
    model.place_in_file.resize(soup.points.size());
    std::iota(model.place_in_file.begin(), model.place_in_file.end(), std::size_t(0));
    model.place_in_mesh = model.place_in_file;
  }
  else
  {
    Place_numbers place_numbers;
    model.place_in_file = place_numbers(soup.points);
    repair_soup(path, soup, console);
    model.place_in_mesh = place_numbers(soup.points);
  }
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, model.mesh);
  if(keeps_soup)
    warn_of_touching_borders(path, model.mesh, console);
  model.has_faces_of_file = triangulate(path, model.mesh, console) && keeps_soup;
  return model;
}

#endif // FRAME_FIELDS_PROGRAMS_MODEL_H
