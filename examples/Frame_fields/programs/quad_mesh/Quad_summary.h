#ifndef FRAME_FIELDS_PROGRAMS_QUAD_SUMMARY_H
#define FRAME_FIELDS_PROGRAMS_QUAD_SUMMARY_H

#include "../shared/Mesh.h"
#include "../shared/Mesh_counts.h"

#include <CGAL/Frame_fields/Quad_statistics.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// The numbers that the program prints and reports.
struct Quad_summary
{
  Mesh_counts counts; // of the model
  std::size_t feature_edges = 0;
  std::vector<Vertex> dangling_ends;                      // of its features
  std::size_t quad_vertices = 0, quad_feature_edges = 0;
  std::optional<std::size_t> number_of_blocks;            // nothing if they were not asked for
  CGAL::Frame_fields::Quad_statistics statistics;
  double seconds_reading = 0, seconds_writing = 0;
  std::vector<std::string> warnings;
};

#endif // FRAME_FIELDS_PROGRAMS_QUAD_SUMMARY_H
