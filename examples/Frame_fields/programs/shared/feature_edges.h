#ifndef FRAME_FIELDS_PROGRAMS_FEATURE_EDGES_H
#define FRAME_FIELDS_PROGRAMS_FEATURE_EDGES_H

#include "Console.h"
#include "Failure.h"
#include "Mesh.h"
#include "Model.h"
#include "Shared_options.h"
#include "mark_listed_edges.h"
#include "read_feature_lines.h"

#include <CGAL/Frame_fields/detect_feature_edges.h>
#include <CGAL/Frame_fields/parameters.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

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
  Listed_edge_marker(path, pairs, model).mark(is_feature, console);
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
