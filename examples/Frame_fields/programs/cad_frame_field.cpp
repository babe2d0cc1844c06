#include "frame_field/Compared_field.h"
#include "frame_field/Field.h"
#include "frame_field/Options.h"
#include "frame_field/Summary.h"
#include "frame_field/option_descriptions.h"
#include "frame_field/print_table.h"
#include "frame_field/read_field.h"
#include "frame_field/streamlines.h"
#include "frame_field/write_field.h"
#include "frame_field/write_ply.h"
#include "frame_field/write_report.h"
#include "frame_field/write_vtp.h"

#include "shared/Console.h"
#include "shared/Input.h"
#include "shared/Mesh.h"
#include "shared/Mesh_counts.h"
#include "shared/program_name.h"
#include "shared/run_program.h"
#include "shared/seconds_of.h"
#include "shared/sectors.h"
#include "shared/write_features.h"
#include "shared/write_file.h"

#include <CGAL/Frame_fields.h>

#include <boost/program_options.hpp>

#include <iterator>
#include <ostream>
#include <string>
#include <vector>

const char* const program_name = "cad_frame_field";

void split_faces(Mesh& mesh, const Feature_map is_feature, Summary& summary)
{
  summary.counts = counts_of(mesh);
  summary.feature_edges = count_features(mesh, is_feature);
  CGAL::Frame_fields::dangling_feature_ends(mesh, is_feature, std::back_inserter(summary.dangling_ends));
  CGAL::Frame_fields::Refinement_statistics statistics;
  const CGAL::Frame_fields::Result result = CGAL::Frame_fields::split_overconstrained_faces(
    mesh, CGAL::Frame_fields::parameters::edge_is_constrained_map(is_feature).statistics(std::ref(statistics)));
  if(!result)
    throw Failure(BAD_FILE, result.message);
  summary.split_faces = statistics.number_of_split_faces;
  summary.faces_after_split = mesh.number_of_faces();
}

void summarize_baseline(const Options& options, const Mesh& mesh, const Feature_map is_feature,
                        const std::vector<Sector>& all_sectors, Console& console, Summary& summary)
{
  console.show_progress("computing the field without correction, for comparison");
  const Baseline_index_map index = compute_baseline_index(mesh, is_feature, options);
  summary.unmeshable_before = find_unmeshable_sectors(mesh, is_feature, all_sectors, index).size();
}

void write_meshes(const Options& options, Mesh& mesh, const Feature_map is_feature,
                  const std::vector<Sector>& all_sectors, const Field& field, Console& console)
{
  console.show_progress("writing");
  if(options.ply)
    write_file(*options.ply, [&](std::ostream& out)
               { write_ply(out, mesh, is_feature, field, options.writes_ascii); });
  if(options.vtp)
    write_file(*options.vtp, [&](std::ostream& out)
               { write_vtp(out, vtp_content(mesh, is_feature, all_sectors, field,
                                            streamlines(mesh, is_feature, field, options))); });
  for(const std::string& path : options.fields)
  {
    write_file(path, [&](std::ostream& out)
               { write_field(out, field_format_of(path), mesh, is_feature, field); });
    if(field_format_of(path) == ROSY)
      console.warn(path + ": crosses hold neither skew frames nor the matching, so corners may be unmeshable to a "
                          "reader; .rawfield and .ffield keep the frames, .ply the matching, too");
  }
  if(options.written_features)
    write_file(*options.written_features, [&](std::ostream& out)
               { write_features(out, feature_format_of(*options.written_features), mesh, is_feature); });
}

Summary run(const Options& options)
{
  Console console(options.is_quiet);
  Summary summary;

  Input input;
  std::vector<Directions> compared_field;
  const auto read_field = [&](const Model& model)
  {
    if(options.compared_field)
      compared_field = read_compared_field(*options.compared_field, model);
  };
  summary.seconds_reading = seconds_of([&] { input = read_input(options, console, read_field); });
  Mesh& mesh = input.model.mesh;
  const Feature_map is_feature = mark_features(options, input, console);
  split_faces(mesh, is_feature, summary);
  const std::vector<Sector> all_sectors = sectors(mesh, is_feature);

  if(options.computes_baseline)
    summary.seconds_baseline = seconds_of([&]
      { summarize_baseline(options, mesh, is_feature, all_sectors, console, summary); });
  const Field field = compute_field(input.model, is_feature, options, console);
  summarize_field(mesh, is_feature, all_sectors, field, summary);
  if(options.compared_field)
    summary.compared =
      compare_field(options, compared_field, mesh, summary.counts.vertices, is_feature, all_sectors);

  summary.seconds_writing = seconds_of([&]
    { write_meshes(options, mesh, is_feature, all_sectors, field, console); });
  summary.warnings = console.warnings();
  if(options.report)
    write_file(*options.report, [&](std::ostream& out) { write_report(out, options, summary); });
  return summary;
}

struct Frame_field_program
{
  typedef ::Options Options;

  static auto option_descriptions() { return ::option_descriptions(); }
  static void print_help(std::ostream& out) { ::print_help(out); }
  static Options options_from(const boost::program_options::variables_map& variables)
  {
    return ::options_from(variables);
  }
  static Summary run(const Options& options) { return ::run(options); }
  static void print_table(const Summary& summary, const Options& options)
  {
    ::print_table(summary, options.is_verbose);
  }
};

int main(const int argc, char** const argv)
{
  return run_program<Frame_field_program>(argc, argv);
}
