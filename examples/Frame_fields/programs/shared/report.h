#ifndef FRAME_FIELDS_PROGRAMS_REPORT_H
#define FRAME_FIELDS_PROGRAMS_REPORT_H

#include "Mesh.h"
#include "Shared_options.h"

#include <CGAL/Frame_fields/Statistics.h>

#include <nlohmann/json.hpp>

#include <ostream>
#include <vector>

typedef nlohmann::ordered_json Json;

inline Json json_of_shared(const Shared_options& options)
{
  return { { "merge", options.merges_vertices },
           { "close_cracks", options.crack_tolerance },
           { "features", options.features ? Json(*options.features) : Json() },
           { "feature_angle", options.features ? Json() : Json(options.feature_angle) },
           { "weak_angle", options.features ? Json() : Json(options.weak_angle) },
           { "close_gaps", options.features ? Json() : Json(options.closes_gaps) },
           { "min_chain_length", options.features ? Json() : Json(options.minimum_chain_length) },
           { "support", options.support },
           { "index_targets", options.index_targets ? Json(*options.index_targets) : Json() },
           { "sharp_corner_bound", options.sharp_corner_bound },
           { "blunt_corner_bound", options.blunt_corner_bound },
           { "edge_weights",
             options.edge_weighting == CGAL::Frame_fields::Edge_weighting::UNIFORM ? "uniform" : "geometric" },
           { "curvature_weight", options.curvature_weight },
           { "repair", options.repairs_matching },
           { "relaxation", options.relaxes_orthogonality } };
}

inline Json json_of(const CGAL::Frame_fields::Stage_seconds& seconds)
{
  return { { "cut_surface", seconds.cut_surface },
           { "prescribed_rotation", seconds.prescribed_rotation },
           { "orthogonal", seconds.orthogonal_field },
           { "matching_and_indices", seconds.matching_and_indices },
           { "relaxation", seconds.relaxation },
           { "total", seconds.total } };
}

inline Json json_of(const std::vector<Vertex>& vertices)
{
  Json json = Json::array();
  for(const Vertex v : vertices)
    json.push_back(v.idx());
  return json;
}

inline void print_json(std::ostream& out, const Json& report)
{
  // File names may hold any bytes, but JSON must be UTF-8.
  out << report.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

#endif // FRAME_FIELDS_PROGRAMS_REPORT_H
