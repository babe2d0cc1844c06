#ifndef FRAME_FIELDS_PROGRAMS_WRITE_REPORT_H
#define FRAME_FIELDS_PROGRAMS_WRITE_REPORT_H

#include "Options.h"
#include "Summary.h"

#include "../shared/peak_memory.h"
#include "../shared/report.h"

#include <ostream>
#include <string>
#include <vector>

inline Json json_of(const Options& options)
{
  Json json = json_of_shared(options);
  json["compare"] = options.compared_field ? Json(*options.compared_field) : Json();
  return json;
}

inline Json json_of(const Index_histogram& histogram)
{
  Json json = Json::object();
  for(const auto& [index, number] : histogram)
    json[std::to_string(index)] = number;
  return json;
}

inline Json json_of(const std::vector<Reported_sector>& sectors)
{
  Json json = Json::array();
  for(const Reported_sector& sector : sectors)
    json.push_back({ { "vertex", sector.vertex.idx() }, { "angle", sector.angle }, { "index", sector.index } });
  return json;
}

inline Json json_of(const CGAL::Frame_fields::Field_quality& quality)
{
  return { { "energy", quality.energy },
           { "mean_rotation", quality.mean_rotation },
           { "maximum_rotation", quality.maximum_rotation },
           { "curl", quality.curl },
           { "mean_skewness", quality.mean_skewness },
           { "maximum_skewness", quality.maximum_skewness },
           { "maximum_misalignment", quality.maximum_misalignment } };
}

inline Json json_of(const Index_histogram& interior, const Index_histogram& constrained)
{
  return { { "interior", json_of(interior) }, { "constrained", json_of(constrained) } };
}

inline Json json_of(const Compared_figures& compared)
{
  return { { "unmeshable", compared.number_of_unmeshable_sectors },
           { "index_histogram", json_of(compared.interior_indices, compared.constrained_indices) },
           { "maximum_misalignment", compared.maximum_misalignment },
           { "quality", json_of(compared.quality) } };
}

inline void write_report(std::ostream& out, const Options& options, const Summary& summary)
{
  const CGAL::Frame_fields::Statistics& statistics = summary.statistics;
  const Json report = {
    { "model", options.model },
    { "options", json_of(options) },
    { "faces", summary.counts.faces },
    { "vertices", summary.counts.vertices },
    { "components", summary.counts.components },
    { "border_edges", summary.counts.border_edges },
    { "border_loops", summary.counts.border_loops },
    { "patches", statistics.number_of_patches },
    { "feature_edges", summary.feature_edges },
    { "dangling_ends", json_of(summary.dangling_ends) },
    { "split_faces", summary.split_faces },
    { "faces_after_split", summary.faces_after_split },
    { "sharp_corners", statistics.number_of_sharp_corners },
    { "unmeshable_before", summary.unmeshable_before ? Json(*summary.unmeshable_before) : Json() },
    { "unmeshable_after", summary.unmeshable_sectors.size() },
    { "repaired_sectors", statistics.number_of_repaired_sectors },
    { "unnatural_corners", statistics.number_of_unnatural_corners },
    { "unnatural_sectors", statistics.number_of_unnatural_sectors },
    { "unmeshable_inner_sectors", statistics.number_of_unmeshable_inner_sectors },
    { "index_histogram", json_of(summary.interior_indices, summary.constrained_indices) },
    { "energy_orthogonal", statistics.energy_orthogonal },
    { "energy_relaxed", statistics.energy_relaxed },
    { "clamped_faces", statistics.number_of_clamped_faces },
    { "quality", options.is_verbose ? json_of(summary.quality) : Json() },
    { "compared", summary.compared ? json_of(*summary.compared) : Json() },
    { "seconds", json_of(statistics.seconds) },
    { "seconds_reading", summary.seconds_reading },
    { "seconds_baseline", summary.seconds_baseline },
    { "seconds_writing", summary.seconds_writing },
    { "unmeshable_sectors", json_of(summary.unmeshable_sectors) },
    { "changed_sectors", json_of(summary.changed_sectors) },
    { "peak_memory_mib", peak_memory_mib() },
    { "warnings", summary.warnings } };
  print_json(out, report);
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_REPORT_H
