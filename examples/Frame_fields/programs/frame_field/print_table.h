#ifndef FRAME_FIELDS_PROGRAMS_PRINT_TABLE_H
#define FRAME_FIELDS_PROGRAMS_PRINT_TABLE_H

#include "Summary.h"

#include "../shared/print_row.h"

#include <CGAL/number_type_config.h>

#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

inline std::string text_of_index(const int four_times_index)
{
  const int denominator = (four_times_index % 4 == 0) ? 1 : (four_times_index % 2 == 0) ? 2 : 4;
  const std::string numerator = std::to_string(four_times_index * denominator / 4);
  return denominator == 1 ? numerator : numerator + "/" + std::to_string(denominator);
}

inline std::string text_of(const Index_histogram& histogram)
{
  std::ostringstream text;
  for(const auto& [index, number] : histogram)
    text << (text.tellp() == 0 ? "" : ",  ") << number << " of index " << text_of_index(index);
  return text.str();
}

inline void print_seconds(const CGAL::Frame_fields::Stage_seconds& seconds)
{
  std::cout << std::fixed << std::setprecision(3);
  print_row("seconds", seconds.total);
  print_row("  cut surface", seconds.cut_surface);
  print_row("  prescribed rotation", seconds.prescribed_rotation);
  print_row("  orthogonal field", seconds.orthogonal_field);
  print_row("  matching, indices", seconds.matching_and_indices);
  print_row("  relaxation", seconds.relaxation);
}

inline void print_quality(const CGAL::Frame_fields::Field_quality& quality)
{
  const double degrees = 180 / CGAL_PI;
  print_row("mean rotation", degrees * quality.mean_rotation);
  print_row("largest rotation", degrees * quality.maximum_rotation);
  print_row("curl", quality.curl);
  print_row("mean skewness", degrees * quality.mean_skewness);
  print_row("largest skewness", degrees * quality.maximum_skewness);
  print_row("largest misalignment", degrees * quality.maximum_misalignment);
}

inline void print_compared(const Compared_figures& compared)
{
  std::cout << "compared field\n";
  print_row("  interior sectors", text_of(compared.interior_indices));
  print_row("  sectors on features", text_of(compared.constrained_indices));
  print_row("  unmeshable corners", compared.number_of_unmeshable_sectors);
  print_row("  energy", compared.quality.energy);
  print_row("  misalignment", compared.maximum_misalignment * 180 / CGAL_PI);
}

inline void print_table(const Summary& summary, const bool is_verbose)
{
  const CGAL::Frame_fields::Statistics& statistics = summary.statistics;
  print_row("faces", summary.counts.faces);
  print_row("vertices", summary.counts.vertices);
  print_row("components", summary.counts.components);
  print_row("border edges", summary.counts.border_edges);
  print_row("border loops", summary.counts.border_loops);
  print_row("patches", statistics.number_of_patches);
  print_row("feature edges", summary.feature_edges);
  print_row("dangling ends", summary.dangling_ends.size());
  print_row("split faces", summary.split_faces);
  print_row("sharp corners", statistics.number_of_sharp_corners);
  print_row("interior sectors", text_of(summary.interior_indices));
  print_row("sectors on features", text_of(summary.constrained_indices));
  print_row("unmeshable corners", (summary.unmeshable_before ? std::to_string(*summary.unmeshable_before) + " -> " : "")
                                    + std::to_string(summary.unmeshable_sectors.size()));
  print_row("repaired corners", statistics.number_of_repaired_sectors);
  print_row("unnatural corners", statistics.number_of_unnatural_corners);
  print_row("unnatural sectors", statistics.number_of_unnatural_sectors);
  print_row("unmeshable inside", statistics.number_of_unmeshable_inner_sectors);
  print_row("orthogonal energy", statistics.energy_orthogonal);
  print_row("relaxed energy", statistics.energy_relaxed);
  print_row("clamped faces", statistics.number_of_clamped_faces);
  if(is_verbose)
    print_quality(summary.quality);
  if(summary.compared)
    print_compared(*summary.compared);
  print_seconds(statistics.seconds);
}

#endif // FRAME_FIELDS_PROGRAMS_PRINT_TABLE_H
