#ifndef FRAME_FIELDS_PROGRAMS_SUMMARY_H
#define FRAME_FIELDS_PROGRAMS_SUMMARY_H

#include "Field.h"

#include "../shared/Mesh.h"
#include "../shared/Mesh_counts.h"
#include "../shared/sectors.h"

#include <CGAL/Frame_fields/Statistics.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

// The number of sectors for each 4 I.
typedef std::map<int, std::size_t> Index_histogram;

// A sector as the report lists it.
struct Reported_sector
{
  Vertex vertex;
  double angle; // degrees
  int index;    // 4 I
};

// What is told of a field of another program.
struct Compared_figures
{
  double maximum_misalignment; // radians
  Index_histogram interior_indices, constrained_indices;
  std::size_t number_of_unmeshable_sectors;
  CGAL::Frame_fields::Field_quality quality;
};

// The numbers that the program prints and reports.
struct Summary
{
  Mesh_counts counts; // before faces are split
  std::size_t feature_edges = 0;
  std::vector<Vertex> dangling_ends;                      // of features
  std::size_t split_faces = 0, faces_after_split = 0;
  Index_histogram interior_indices, constrained_indices;
  std::optional<std::size_t> unmeshable_before; // nothing without the baseline
  std::vector<Reported_sector> unmeshable_sectors; // on feature edges with index 1/2 or more: none can be meshed
  std::vector<Reported_sector> changed_sectors;    // whose index the repair changed
  CGAL::Frame_fields::Statistics statistics;
  CGAL::Frame_fields::Field_quality quality; // with --verbose
  std::optional<Compared_figures> compared;
  double seconds_reading = 0, seconds_baseline = 0, seconds_writing = 0;
  std::vector<std::string> warnings;
};

template <typename IndexMap>
Reported_sector reported_sector(const Mesh& mesh, const Feature_map is_feature, const Halfedge sector,
                                const IndexMap index)
{
  return { mesh.target(sector), angle_in_degrees(mesh, is_feature, sector), get(index, sector) };
}

template <typename IndexMap>
std::vector<Reported_sector> find_unmeshable_sectors(const Mesh& mesh, const Feature_map is_feature,
                                                     const std::vector<Sector>& sectors, const IndexMap index)
{
  std::vector<Reported_sector> result;
  for(const Sector& sector : sectors)
    if(sector.is_constrained && get(index, sector.halfedge) >= 2)
      result.push_back(reported_sector(mesh, is_feature, sector.halfedge, index));
  return result;
}

template <typename IndexMap>
void count_indices(const std::vector<Sector>& sectors, const IndexMap index, Index_histogram& interior,
                   Index_histogram& constrained)
{
  for(const Sector& sector : sectors)
    ++(sector.is_constrained ? constrained : interior)[get(index, sector.halfedge)];
}

inline void summarize_field(const Mesh& mesh, const Feature_map is_feature, const std::vector<Sector>& sectors,
                            const Field& field, Summary& summary)
{
  count_indices(sectors, field.index, summary.interior_indices, summary.constrained_indices);
  summary.unmeshable_sectors = find_unmeshable_sectors(mesh, is_feature, sectors, field.index);
  for(const Halfedge h : field.repaired_sectors)
    summary.changed_sectors.push_back(reported_sector(mesh, is_feature, h, field.index));
  summary.statistics = field.statistics;
  summary.quality = field.quality;
}

#endif // FRAME_FIELDS_PROGRAMS_SUMMARY_H
