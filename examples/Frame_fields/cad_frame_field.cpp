#include "cad_frame_field/Command_line.h"
#include "cad_frame_field/Compared_field.h"
#include "cad_frame_field/Console.h"
#include "cad_frame_field/Failure.h"
#include "cad_frame_field/Field.h"
#include "cad_frame_field/Mesh.h"
#include "cad_frame_field/Model.h"
#include "cad_frame_field/Options.h"
#include "cad_frame_field/Soup.h"
#include "cad_frame_field/Summary.h"
#include "cad_frame_field/Thread_limit.h"
#include "cad_frame_field/Unfinished_file.h"
#include "cad_frame_field/feature_edges.h"
#include "cad_frame_field/print_table.h"
#include "cad_frame_field/run_batch.h"
#include "cad_frame_field/sectors.h"
#include "cad_frame_field/streamlines.h"
#include "cad_frame_field/write_features.h"
#include "cad_frame_field/write_field.h"
#include "cad_frame_field/write_file.h"
#include "cad_frame_field/write_ply.h"
#include "cad_frame_field/write_report.h"
#include "cad_frame_field/write_vtp.h"

#include <CGAL/Frame_fields.h>

#include <CGAL/Real_timer.h>

#include <exception>
#include <iostream>
#include <iterator>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

template <typename Function>
double seconds_of(const Function& function)
{
  CGAL::Real_timer timer;
  timer.start();
  function();
  return timer.time();
}

void check_outputs(const Options& options)
{
  for(const std::string& path : outputs_of(options))
    check_output_path(path);
}

// What the input files hold.
struct Input
{
  std::vector<Vertex_pair> features; // if they are listed
  Model model;
  std::vector<Directions> compared_field;
};

Input read_input(const Options& options, Console& console)
{
  console.show_progress("reading " + options.model);
  try
  {
    Soup soup = read_soup(options.model);
    Input input;
    if(options.features)
      input.features = read_features(*options.features, soup);
    input.model = make_model(options.model, std::move(soup), console);
    if(options.compared_field)
      input.compared_field = read_compared_field(*options.compared_field, input.model);
    return input;
  }
  catch(const std::bad_alloc&)
  {
    throw Failure(BAD_FILE, options.model + ": more memory is needed than there is; a damaged header can be the cause");
  }
}

Feature_map mark_features(const Options& options, Input& input, Console& console)
{
  return options.features ? mark_listed_features(*options.features, input.features, input.model, console)
                          : detect_features(options, input.model);
}

void split_faces(Mesh& mesh, const Feature_map is_feature, Summary& summary)
{
  summary.faces = mesh.number_of_faces();
  summary.vertices = mesh.number_of_vertices();
  summary.feature_edges = count_features(mesh, is_feature);
  CGAL::Frame_fields::dangling_feature_ends(mesh, is_feature, std::back_inserter(summary.dangling_ends));
  summary.split_faces = CGAL::Frame_fields::split_overconstrained_faces(
    mesh, CGAL::Frame_fields::parameters::edge_is_constrained_map(is_feature));
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
  check_outputs(options);
  Console console(options.is_quiet);
  Summary summary;

  Input input;
  summary.seconds_reading = seconds_of([&] { input = read_input(options, console); });
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
      compare_field(options, input.compared_field, mesh, summary.vertices, is_feature, all_sectors);

  summary.seconds_writing = seconds_of([&]
    { write_meshes(options, mesh, is_feature, all_sectors, field, console); });
  summary.warnings = console.warnings();
  if(options.report)
    write_file(*options.report, [&](std::ostream& out) { write_report(out, options, summary); });
  return summary;
}

void check_standard_output()
{
  std::cout.flush();
  if(!std::cout)
    throw Failure(BAD_FILE, "the standard output cannot be written");
}

int fail(const Exit_code exit_code, const char* const message)
{
  std::cerr << "cad_frame_field: error: " << message << std::endl;
  return exit_code;
}

Exit_code run_one(const Options& options)
{
  remove_unfinished_file_at_signals();
  const Thread_limit thread_limit(options.number_of_threads);
  const Summary summary = run(options);
  if(!options.is_quiet)
    print_table(summary, options.is_verbose);
  return DONE;
}

int main(const int argc, char** const argv)
try
{
  const std::optional<Command_line> command_line = read_command_line(argc, argv);
  Exit_code exit_code = DONE;
  if(command_line)
    exit_code = command_line->batch ? run_batch(*command_line->batch) : run_one(command_line->options);
  check_standard_output();
  return exit_code;
}
catch(const Failure& failure)
{
  return fail(failure.exit_code, failure.what());
}
catch(const std::bad_alloc&)
{
  return fail(NOT_SOLVED, "the memory is exhausted; take a coarser mesh or a larger machine");
}
catch(const std::exception& error)
{
  return fail(NOT_SOLVED, error.what());
}
