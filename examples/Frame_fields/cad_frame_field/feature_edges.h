#ifndef CAD_FRAME_FIELD_FEATURE_EDGES_H
#define CAD_FRAME_FIELD_FEATURE_EDGES_H

#include "Console.h"
#include "Failure.h"
#include "Mesh.h"
#include "Model.h"
#include "input_file.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// A line of a feature file: the indices of two vertices of the model.
struct Vertex_pair
{
  std::size_t first, second, line_number;
};

inline Vertex_pair parse_vertex_pair(const std::string& path, const std::size_t line_number, const std::string& text,
                                     const std::size_t number_of_vertices)
{
  const auto fail = [&](const std::string& reason)
  {
    throw Failure(BAD_FILE, path + ":" + std::to_string(line_number) + ": " + reason);
  };
  std::istringstream words(text);
  long long first, second; // signed, since a stream reads -1 as a large unsigned number without complaint
  if(!(words >> first >> second) || !(words >> std::ws).eof())
    fail("a line must hold two vertex indices");
  const long long end = static_cast<long long>(number_of_vertices);
  for(const long long vertex : { first, second })
    if(vertex < 0 || vertex >= end)
      fail("the model has no vertex " + std::to_string(vertex) + ", its last one is " + std::to_string(end - 1));
  return { static_cast<std::size_t>(first), static_cast<std::size_t>(second), line_number };
}

inline std::vector<Vertex_pair> read_vertex_pairs(const std::string& path, const std::size_t number_of_vertices)
{
  std::vector<Vertex_pair> pairs;
  for_each_line(path, [&](const std::size_t line_number, const std::string& content)
  {
    pairs.push_back(parse_vertex_pair(path, line_number, content, number_of_vertices));
  });
  return pairs;
}

// Marks the edges whose ends are at the places of a pair; a repair may have made several of them.
inline void mark_vertex_pairs(const std::string& path, const std::vector<Vertex_pair>& pairs, const Model& model,
                              Feature_map is_feature, Console& console)
{
  typedef std::pair<std::size_t, std::size_t> Places;
  const auto places_of = [&](const Vertex_pair& pair) -> Places
  {
    return std::minmax({ model.place_in_file[pair.first], model.place_in_file[pair.second] });
  };
  std::set<Places> wanted, found;
  for(const Vertex_pair& pair : pairs)
    wanted.insert(places_of(pair));
  for(const Edge e : model.mesh.edges())
  {
    const Places places = std::minmax({ model.place_in_mesh[model.mesh.vertex(e, 0)],
                                        model.place_in_mesh[model.mesh.vertex(e, 1)] });
    if(!wanted.count(places))
      continue;
    is_feature[e] = true;
    found.insert(places);
  }

  const auto is_missing = [&](const Vertex_pair& pair) { return !found.count(places_of(pair)); };
  const auto first_missing = std::find_if(pairs.begin(), pairs.end(), is_missing);
  if(first_missing == pairs.end())
    return;
  if(found.empty())
    throw Failure(BAD_FILE, path + ": no line names an edge of the model; it seems to belong to another one");
  console.warn(path + ": lines that name no edge of the model: "
               + std::to_string(std::count_if(first_missing, pairs.end(), is_missing)) + ", the first is line "
               + std::to_string(first_missing->line_number) + ", '" + std::to_string(first_missing->first) + " "
               + std::to_string(first_missing->second) + "'");
}

inline void mark_border_edges(const Mesh& mesh, Feature_map is_feature)
{
  for(const Edge e : mesh.edges())
    if(mesh.is_border(e))
      is_feature[e] = true;
}

inline Feature_map mark_listed_features(const std::string& path, Model& model, Console& console)
{
  const Feature_map is_feature = model.mesh.add_property_map<Edge, bool>("e:is_feature", false).first;
  mark_vertex_pairs(path, read_vertex_pairs(path, model.place_in_file.size()), model, is_feature, console);
  mark_border_edges(model.mesh, is_feature);
  return is_feature;
}

inline Feature_map mark_sharp_features(const double angle_in_degrees, Model& model)
{
  const Feature_map is_feature = model.mesh.add_property_map<Edge, bool>("e:is_feature", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(model.mesh, angle_in_degrees, is_feature);
  mark_border_edges(model.mesh, is_feature);
  return is_feature;
}

#endif // CAD_FRAME_FIELD_FEATURE_EDGES_H
