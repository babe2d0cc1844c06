#ifndef FRAME_FIELDS_PROGRAMS_WRITE_QUAD_REPORT_H
#define FRAME_FIELDS_PROGRAMS_WRITE_QUAD_REPORT_H

#include "Quad_options.h"
#include "Quad_summary.h"

#include "../shared/peak_memory.h"
#include "../shared/report.h"

#include <CGAL/Frame_fields/Quad_statistics.h>

#include <ostream>

inline Json json_of(const Quad_options& options)
{
  Json json = json_of_shared(options);
  json["edge_length"] = options.edge_length ? Json(*options.edge_length) : Json();
  json["quads"] = options.number_of_quads ? Json(*options.number_of_quads) : Json();
  json["chord_height"] = options.chord_height ? Json(*options.chord_height) : Json();
  json["edges_across_gap"] = options.edges_across_gap ? Json(*options.edges_across_gap) : Json();
  json["gradation"] = options.gradation ? Json(*options.gradation) : Json();
  json["min_edge_length"] = options.minimum_edge_length ? Json(*options.minimum_edge_length) : Json();
  json["field_follows_sizes"] = options.field_follows_sizes;
  json["refinement"] = options.refines;
  json["blocks"] = options.blocks ? Json(*options.blocks) : Json();
  return json;
}

inline Json json_of(const CGAL::Frame_fields::Quad_stage_seconds& seconds)
{
  return { { "preparation", seconds.preparation },
           { "field", seconds.field },
           { "seamless_map", seconds.seamless_map },
           { "t_mesh", seconds.t_mesh },
           { "quantization", seconds.quantization },
           { "assembly", seconds.assembly },
           { "smoothing", seconds.smoothing },
           { "total", seconds.total } };
}

inline Json json_of(const CGAL::Frame_fields::Quad_quality& quality)
{
  return { { "minimum_scaled_jacobian", quality.minimum_scaled_jacobian },
           { "mean_scaled_jacobian", quality.mean_scaled_jacobian },
           { "non_positive_quads", quality.number_of_inverted_quads },
           { "irregular_vertices", quality.number_of_irregular_vertices },
           { "irregular_feature_sectors", quality.number_of_irregular_sectors } };
}

inline Json json_of(const CGAL::Frame_fields::Patch_quad_statistics& patch)
{
  const bool is_certified = patch.way == CGAL::Frame_fields::Patch_way::CERTIFIED_MAP;
  return { { "faces", patch.number_of_faces },
           { "quads", patch.number_of_quads },
           { "way", is_certified ? "certified_map" : "filling" },
           { "reason", patch.reason.empty() ? Json() : Json(patch.reason) } };
}

inline Json json_of_patches(const CGAL::Frame_fields::Quad_statistics& statistics)
{
  Json json = Json::array();
  for(const CGAL::Frame_fields::Patch_quad_statistics& patch : statistics.patches)
    json.push_back(json_of(patch));
  return json;
}

inline Json json_of_field(const CGAL::Frame_fields::Statistics& field)
{
  return { { "sharp_corners", field.number_of_sharp_corners },
           { "repaired_sectors", field.number_of_repaired_sectors },
           { "unmeshable_sectors", field.number_of_unmeshable_sectors },
           { "unnatural_corners", field.number_of_unnatural_corners },
           { "energy_orthogonal", field.energy_orthogonal },
           { "energy_relaxed", field.energy_relaxed },
           { "clamped_faces", field.number_of_clamped_faces },
           { "seconds", json_of(field.seconds) } };
}

inline void write_quad_report(std::ostream& out, const Quad_options& options, const Quad_summary& summary)
{
  const CGAL::Frame_fields::Quad_statistics& statistics = summary.statistics;
  const Json report = {
    { "model", options.model },
    { "options", json_of(options) },
    { "faces", summary.counts.faces },
    { "vertices", summary.counts.vertices },
    { "components", summary.counts.components },
    { "border_edges", summary.counts.border_edges },
    { "border_loops", summary.counts.border_loops },
    { "feature_edges", summary.feature_edges },
    { "dangling_ends", json_of(summary.dangling_ends) },
    { "target_edge_length", statistics.target_edge_length },
    { "minimum_target_edge_length", statistics.minimum_target_edge_length },
    { "maximum_target_edge_length", statistics.maximum_target_edge_length },
    { "nodes", statistics.number_of_nodes },
    { "arcs", statistics.number_of_arcs },
    { "patches", statistics.number_of_patches },
    { "certified_patches", statistics.number_of_certified_patches },
    { "filled_patches", statistics.number_of_filled_patches },
    { "repaired_patches", statistics.number_of_repaired_patches },
    { "quads", statistics.number_of_quads },
    { "quad_vertices", summary.quad_vertices },
    { "quad_feature_edges", summary.quad_feature_edges },
    { "blocks", summary.number_of_blocks ? Json(*summary.number_of_blocks) : Json() },
    { "quality", json_of(statistics.quality) },
    { "patch_list", json_of_patches(statistics) },
    { "field", json_of_field(statistics.field) },
    { "seconds", json_of(statistics.seconds) },
    { "seconds_reading", summary.seconds_reading },
    { "seconds_writing", summary.seconds_writing },
    { "peak_memory_mib", peak_memory_mib() },
    { "warnings", summary.warnings } };
  print_json(out, report);
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_QUAD_REPORT_H
