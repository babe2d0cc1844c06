#ifndef FRAME_FIELDS_PROGRAMS_FEATURE_EDGES_H
#define FRAME_FIELDS_PROGRAMS_FEATURE_EDGES_H

#include "Console.h"
#include "Failure.h"
#include "Mesh.h"
#include "Model.h"
#include "Shared_options.h"
#include "read_features.h"

#include <CGAL/Frame_fields/detect_feature_edges.h>
#include <CGAL/Frame_fields/parameters.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

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

inline std::size_t count_features(const Mesh& mesh, const Feature_map is_feature)
{
  return std::count_if(mesh.edges().begin(), mesh.edges().end(), [&](const Edge e) { return is_feature[e]; });
}

inline Feature_map mark_listed_features(const std::string& path, const std::vector<Vertex_pair>& pairs, Model& model,
                                        Console& console)
{
  const Feature_map is_feature = model.mesh.add_property_map<Edge, bool>("e:is_feature", false).first;
  mark_vertex_pairs(path, pairs, model, is_feature, console);
  mark_border_edges(model.mesh, is_feature);
  return is_feature;
}

inline Feature_map detect_features(const Shared_options& options, Model& model)
{
  const Feature_map is_feature = model.mesh.add_property_map<Edge, bool>("e:is_feature", false).first;
  const CGAL::Frame_fields::Result result = CGAL::Frame_fields::detect_feature_edges(
    model.mesh, is_feature,
    CGAL::Frame_fields::parameters::strong_angle_in_degrees(options.feature_angle)
      .weak_angle_in_degrees(options.weak_angle)
      .close_gaps(options.closes_gaps)
      .minimum_chain_length(options.minimum_chain_length));
  if(!result)
    throw Failure(BAD_FILE, options.model + ": " + result.message);
  return is_feature;
}

#endif // FRAME_FIELDS_PROGRAMS_FEATURE_EDGES_H
