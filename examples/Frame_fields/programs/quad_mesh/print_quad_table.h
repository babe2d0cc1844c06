#ifndef FRAME_FIELDS_PROGRAMS_PRINT_QUAD_TABLE_H
#define FRAME_FIELDS_PROGRAMS_PRINT_QUAD_TABLE_H

#include "Quad_summary.h"

#include "../shared/print_row.h"

#include <CGAL/Frame_fields/Quad_statistics.h>

#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>

inline void print_seconds(const CGAL::Frame_fields::Quad_stage_seconds& seconds)
{
  std::cout << std::fixed << std::setprecision(3);
  print_row("seconds", seconds.total);
  print_row("  preparation", seconds.preparation);
  print_row("  frame field", seconds.field);
  print_row("  seamless map", seconds.seamless_map);
  print_row("  T-mesh", seconds.t_mesh);
  print_row("  quantization", seconds.quantization);
  print_row("  assembly", seconds.assembly);
  print_row("  smoothing", seconds.smoothing);
}

inline void print_filled_patches(const CGAL::Frame_fields::Quad_statistics& statistics)
{
  for(std::size_t k = 0; k < statistics.patches.size(); ++k)
  {
    const CGAL::Frame_fields::Patch_quad_statistics& patch = statistics.patches[k];
    if(patch.way == CGAL::Frame_fields::Patch_way::FILLING)
      print_row("    patch " + std::to_string(k),
                std::to_string(patch.number_of_quads) + " quadrangles; " + patch.reason);
  }
}

inline void print_quad_table(const Quad_summary& summary, const bool is_verbose)
{
  const CGAL::Frame_fields::Quad_statistics& statistics = summary.statistics;
  const CGAL::Frame_fields::Quad_quality& quality = statistics.quality;
  print_row("faces", summary.counts.faces);
  print_row("vertices", summary.counts.vertices);
  print_row("components", summary.counts.components);
  print_row("border edges", summary.counts.border_edges);
  print_row("border loops", summary.counts.border_loops);
  print_row("feature edges", summary.feature_edges);
  print_row("dangling ends", summary.dangling_ends.size());
  print_row("nodes", statistics.number_of_nodes);
  print_row("arcs", statistics.number_of_arcs);
  print_row("patches", statistics.number_of_patches);
  print_row("  from certified maps", statistics.number_of_certified_patches);
  print_row("  filled", statistics.number_of_filled_patches);
  if(is_verbose)
    print_filled_patches(statistics);
  print_row("edge length", statistics.target_edge_length);
  if(statistics.minimum_target_edge_length < statistics.maximum_target_edge_length)
  {
    print_row("  shortest", statistics.minimum_target_edge_length);
    print_row("  longest", statistics.maximum_target_edge_length);
  }
  print_row("quadrangles", statistics.number_of_quads);
  if(summary.number_of_blocks)
    print_row("blocks", *summary.number_of_blocks);
  print_row("irregular inside", quality.number_of_irregular_vertices);
  print_row("irregular on features", quality.number_of_irregular_sectors);
  print_row("inverted quadrangles", quality.number_of_inverted_quads);
  print_row("least scaled Jacobian", quality.minimum_scaled_jacobian);
  print_row("mean scaled Jacobian", quality.mean_scaled_jacobian);
  print_seconds(statistics.seconds);
}

#endif // FRAME_FIELDS_PROGRAMS_PRINT_QUAD_TABLE_H
