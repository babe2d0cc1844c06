#include "quad_mesh/Quad_options.h"
#include "quad_mesh/Quad_summary.h"
#include "quad_mesh/Quads.h"
#include "quad_mesh/print_quad_table.h"
#include "quad_mesh/quad_option_descriptions.h"
#include "quad_mesh/write_quad_report.h"
#include "quad_mesh/write_quads.h"

#include "shared/Console.h"
#include "shared/Input.h"
#include "shared/Mesh.h"
#include "shared/Mesh_counts.h"
#include "shared/program_name.h"
#include "shared/run_program.h"
#include "shared/seconds_of.h"
#include "shared/write_features.h"
#include "shared/write_file.h"

#include <CGAL/Frame_fields.h>

#include <boost/program_options.hpp>

#include <iterator>
#include <ostream>
#include <string>

const char* const program_name = "cad_quad_mesh";

void write_outputs(const Quad_options& options, Quads& quads, Console& console)
{
  console.show_progress("writing");
  for(const std::string& path : options.meshes)
    write_quads(path, options, quads);
  if(options.written_features)
    write_file(*options.written_features, [&](std::ostream& out)
               { write_features(out, feature_format_of(*options.written_features), quads.mesh, quads.is_feature); });
}

Quad_summary run(const Quad_options& options)
{
  Console console(options.is_quiet);
  Quad_summary summary;

  Input input;
  summary.seconds_reading = seconds_of([&] { input = read_input(options, console, [](const Model&) {}); });
  const Mesh& mesh = input.model.mesh;
  const Feature_map is_feature = mark_features(options, input, console);
  summary.counts = counts_of(mesh);
  summary.feature_edges = count_features(mesh, is_feature);
  CGAL::Frame_fields::dangling_feature_ends(mesh, is_feature, std::back_inserter(summary.dangling_ends));

  Quads quads;
  compute_quads(input.model, is_feature, options, console, quads);
  divide_into_blocks(options, quads);
  summary.number_of_blocks = quads.number_of_blocks;
  summary.quad_vertices = quads.mesh.number_of_vertices();
  summary.quad_feature_edges = count_features(quads.mesh, quads.is_feature);
  summary.statistics = quads.statistics;

  summary.seconds_writing = seconds_of([&] { write_outputs(options, quads, console); });
  summary.warnings = console.warnings();
  if(options.report)
    write_file(*options.report, [&](std::ostream& out) { write_quad_report(out, options, summary); });
  return summary;
}

struct Quad_mesh_program
{
  typedef Quad_options Options;

  static auto option_descriptions() { return quad_option_descriptions(); }
  static void print_help(std::ostream& out) { print_quad_help(out); }
  static Quad_options options_from(const boost::program_options::variables_map& variables)
  {
    return quad_options_from(variables);
  }
  static Quad_summary run(const Quad_options& options) { return ::run(options); }
  static void print_table(const Quad_summary& summary, const Quad_options& options)
  {
    print_quad_table(summary, options.is_verbose);
  }
};

int main(const int argc, char** const argv)
{
  return run_program<Quad_mesh_program>(argc, argv);
}
