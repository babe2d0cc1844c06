#ifndef CAD_FRAME_FIELD_OPTIONS_H
#define CAD_FRAME_FIELD_OPTIONS_H

#include "Failure.h"
#include "known_extensions.h"

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/Support_strategy.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

struct Options
{
  std::string model;
  std::optional<std::string> features, index_targets;
  double feature_angle; // degrees
  std::string support;
  double sharp_corner_bound; // degrees
  CGAL::Frame_fields::Edge_weighting edge_weighting;
  double curvature_weight;
  bool repairs_matching;
  bool relaxes_orthogonality;
  bool computes_baseline;

  std::optional<std::string> ply, vtp, report;
  bool writes_ascii;
  bool is_quiet, is_verbose;
};

inline CGAL::Frame_fields::Support_strategy support_strategy_from(const std::string& text)
{
  using CGAL::Frame_fields::Support_strategy;
  if(text == "none")
    return Support_strategy::none();
  if(text == "local")
    return Support_strategy::local();
  if(text == "component")
    return Support_strategy::component();

  if(text == "radius")
    return Support_strategy::radius();

  const std::string radius_prefix = "radius:";
  double radius;
  if(text.compare(0, radius_prefix.size(), radius_prefix) == 0
     && boost::conversion::try_lexical_convert(text.substr(radius_prefix.size()), radius) && radius > 0
     && std::isfinite(radius))
    return Support_strategy::radius(radius);

  const std::string prefix = "rings:", digits = text.substr((std::min)(prefix.size(), text.size()));
  unsigned int number_of_rings;
  if(text.compare(0, prefix.size(), prefix) != 0 || digits.empty()
     || !std::all_of(digits.begin(), digits.end(), [](const unsigned char c) { return std::isdigit(c); })
     || !boost::conversion::try_lexical_convert(digits, number_of_rings))
    throw Failure(BAD_USAGE,
                  "--support is '" + text + "' and must be none, local, rings:K, radius, radius:R or component");
  return Support_strategy::rings(number_of_rings);
}

inline CGAL::Frame_fields::Edge_weighting edge_weighting_from(const std::string& text)
{
  if(text == "uniform")
    return CGAL::Frame_fields::UNIFORM_WEIGHTS;
  if(text == "geometric")
    return CGAL::Frame_fields::PRIMAL_OVER_DUAL_LENGTH;
  throw Failure(BAD_USAGE, "--edge-weights is '" + text + "' and must be uniform or geometric");
}

inline boost::program_options::options_description option_descriptions()
{
  namespace po = boost::program_options;
  const auto file = [] { return po::value<std::string>()->value_name("FILE"); };
  po::options_description options("Options", 100);
  options.add_options()
    ("features", file(),
     "read the feature edges: two vertex indices of MODEL a line, counted from 0; # starts a comment")
    ("feature-angle", po::value<double>()->value_name("DEG")->default_value(40, "40"),
     "without --features: edges whose faces' normals differ by DEG degrees or more are features")
    ("support", po::value<std::string>()->value_name("S")->default_value("rings:4"),
     "where the rotation prescribed at sharp corners is compensated: none, local, rings:K, radius:R\n"
     "(a length of the model), radius (from the lengths of the feature curves) or component")
    ("edge-weights", po::value<std::string>()->value_name("W")->default_value("uniform"),
     "uniform, or geometric: by the shapes of the triangles, so that the field depends little on the mesh")
    ("curvature-weight", po::value<double>()->value_name("W")->default_value(0, "0"),
     "how strongly the principal directions of curvature guide the field; 0 for not at all")
    ("index-targets", file(),
     "read singularities that the field must have: a vertex index of MODEL that is on no feature edge and 4 times\n"
     "its index a line; the patches of these vertices then have no other singularities inside")
    ("sharp-corner-bound", po::value<double>()->value_name("DEG")->default_value(135, "135"),
     "sectors of less than DEG degrees are sharp corners")
    ("no-repair", "leave sectors on feature edges at an index of 1/2 or more")
    ("no-relaxation", "keep the crosses orthogonal")
    ("no-baseline", "do not compute the field without correction, for comparison")
    ("output,o", file(), "write the mesh and the field as PLY")
    ("ascii", "write the PLY file as text")
    ("vtp", file(), "write faces, features and singular sectors as VTK PolyData, for ParaView")
    ("report", file(), "write the numbers as JSON")
    ("quiet", "print nothing but warnings and errors")
    ("verbose", "print figures of the quality of the field, too")
    ("help", "print this text")
    ("version", "print the version");
  return options;
}

inline void print_help(std::ostream& out)
{
  out << "cad_frame_field MODEL [options]\n\n"
         "Computes a frame field that a quadrangle mesh can follow on a CAD model.\n"
         "MODEL is a file whose name ends with one of " << known_extensions << ".\n"
         "What is not an oriented manifold triangle mesh is repaired before; warnings tell how.\n\n"
      << option_descriptions()
      << "\nOUT.ply holds the mesh whose faces with several feature edges are split, and its properties:\n"
         "  face      alpha, rho in radians; unit vectors u, v (branches 0 and 1) as ux uy uz vx vy vz\n"
         "  edge      feature: 1 for features and borders\n"
         "  halfedge  matching; prescribed_rotation in radians; index: 4 times that of the sector at the target\n"
         "In the JSON report, the angles of unmeshable_sectors are in degrees and indices are multiplied by 4.\n\n"
         "Exit codes: 0 done, 1 bad usage, 2 a file cannot be read or written or is invalid, 3 no field was found.\n";
}

inline double angle_option(const boost::program_options::variables_map& variables, const std::string& name,
                           const double maximum)
{
  const double angle = variables[name].as<double>();
  if(!(angle >= 0 && angle <= maximum)) // false for NaN, too
    throw Failure(BAD_USAGE, "--" + name + " must be from 0 to " + std::to_string(static_cast<int>(maximum))
                             + " degrees");
  return angle;
}

inline std::optional<std::string> file_option(const boost::program_options::variables_map& variables,
                                              const std::string& name)
{
  if(!variables.count(name))
    return std::nullopt;
  if(variables[name].as<std::string>().empty())
    throw Failure(BAD_USAGE, "--" + name + " needs the name of a file");
  return variables[name].as<std::string>();
}

// The same for all ways to write a path.
inline std::string unique_name(const std::string& path)
{
  std::error_code error;
  const std::filesystem::path name = std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  return error ? path : name.string();
}

// No output may replace an input or another output.
inline void check_files_differ(const Options& options)
{
  std::set<std::string> names{ unique_name(options.model) };
  for(const auto& path : { options.features, options.index_targets })
    if(path)
      names.insert(unique_name(*path));
  for(const auto& path : { options.ply, options.vtp, options.report })
    if(path && !names.insert(unique_name(*path)).second)
      throw Failure(BAD_USAGE, *path + ": this is an input or another output already; give another name");
}

inline boost::program_options::variables_map parse_command_line(const int argc, const char* const* const argv)
{
  namespace po = boost::program_options;
  po::options_description all_options = option_descriptions();
  all_options.add_options()("model", po::value<std::string>());
  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;

  po::variables_map variables;
  po::store(po::command_line_parser(argc, argv).options(all_options)
              .positional(po::positional_options_description().add("model", 1)).style(style).run(),
            variables);
  return variables;
}

// The options, or nothing if the command line asks for the help or the version, which are then printed.
inline std::optional<Options> read_options(const int argc, const char* const* const argv)
try
{
  const boost::program_options::variables_map variables = parse_command_line(argc, argv);
  if(variables.count("help"))
  {
    print_help(std::cout);
    return std::nullopt;
  }
  if(variables.count("version"))
  {
    std::cout << "cad_frame_field " FRAME_FIELDS_VERSION "\n";
    return std::nullopt;
  }
  if(!variables.count("model") || variables["model"].as<std::string>().empty())
    throw Failure(BAD_USAGE, "MODEL is missing; cad_frame_field --help tells the usage");
  if(variables.count("features") && !variables["feature-angle"].defaulted())
    throw Failure(BAD_USAGE, "--features and --feature-angle exclude each other");

  Options options;
  options.model = variables["model"].as<std::string>();
  options.features = file_option(variables, "features");
  options.index_targets = file_option(variables, "index-targets");
  options.feature_angle = angle_option(variables, "feature-angle", 180);
  options.support = variables["support"].as<std::string>();
  support_strategy_from(options.support); // a wrong one is reported before the model is read
  options.edge_weighting = edge_weighting_from(variables["edge-weights"].as<std::string>());
  options.curvature_weight = variables["curvature-weight"].as<double>();
  if(!(options.curvature_weight >= 0 && std::isfinite(options.curvature_weight)))
    throw Failure(BAD_USAGE, "--curvature-weight must be a number that is not negative");
  options.sharp_corner_bound = angle_option(variables, "sharp-corner-bound", 360);
  options.repairs_matching = !variables.count("no-repair");
  options.relaxes_orthogonality = !variables.count("no-relaxation");
  options.computes_baseline = !variables.count("no-baseline");
  options.ply = file_option(variables, "output");
  options.vtp = file_option(variables, "vtp");
  options.report = file_option(variables, "report");
  options.writes_ascii = variables.count("ascii");
  options.is_quiet = variables.count("quiet");
  options.is_verbose = variables.count("verbose");
  check_files_differ(options);
  return options;
}
catch(const boost::program_options::error& error)
{
  throw Failure(BAD_USAGE, std::string(error.what()) + "; cad_frame_field --help tells the usage");
}

#endif // CAD_FRAME_FIELD_OPTIONS_H
