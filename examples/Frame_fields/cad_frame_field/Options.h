#ifndef CAD_FRAME_FIELD_OPTIONS_H
#define CAD_FRAME_FIELD_OPTIONS_H

#include "Failure.h"
#include "field_formats.h"
#include "option_descriptions.h"

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/Support_strategy.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

struct Options
{
  std::string model;
  std::optional<std::string> features, index_targets, compared_field;
  double feature_angle, weak_angle; // degrees
  bool closes_gaps;
  double minimum_chain_length;
  std::string support;
  double sharp_corner_bound; // degrees
  CGAL::Frame_fields::Edge_weighting edge_weighting;
  double curvature_weight;
  bool repairs_matching;
  bool relaxes_orthogonality;
  bool computes_baseline;
  std::optional<int> number_of_threads; // nothing for all cores

  std::optional<std::string> ply, vtp, report, written_features;
  std::vector<std::string> fields;
  std::optional<double> streamline_spacing; // 0 for the default
  bool writes_ascii;
  bool is_quiet, is_verbose;
};

inline std::vector<std::string> inputs_of(const Options& options)
{
  std::vector<std::string> result{ options.model };
  for(const auto& path : { options.features, options.index_targets, options.compared_field })
    if(path)
      result.push_back(*path);
  return result;
}

inline std::vector<std::string> outputs_of(const Options& options)
{
  std::vector<std::string> result = options.fields;
  for(const auto& path : { options.ply, options.vtp, options.written_features, options.report })
    if(path)
      result.push_back(*path);
  return result;
}

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

inline double angle_option(const boost::program_options::variables_map& variables, const std::string& name,
                           const double maximum)
{
  const double angle = variables[name].as<double>();
  if(!(angle >= 0 && angle <= maximum)) // false for NaN, too
    throw Failure(BAD_USAGE, "--" + name + " must be from 0 to " + std::to_string(static_cast<int>(maximum))
                             + " degrees");
  return angle;
}

inline double weak_angle_option(const boost::program_options::variables_map& variables, const double feature_angle)
{
  if(!variables.count("weak-angle"))
    return feature_angle;
  const double angle = variables["weak-angle"].as<double>();
  if(!(angle >= 0 && angle <= feature_angle))
    throw Failure(BAD_USAGE, "--weak-angle must be from 0 to the --feature-angle");
  return angle;
}

inline double non_negative_option(const boost::program_options::variables_map& variables, const std::string& name)
{
  const double number = variables[name].as<double>();
  if(!(number >= 0 && std::isfinite(number)))
    throw Failure(BAD_USAGE, "--" + name + " must be a number that is not negative");
  return number;
}

inline std::optional<int> count_option(const boost::program_options::variables_map& variables, const std::string& name)
{
  if(!variables.count(name))
    return std::nullopt;
  if(variables[name].as<int>() < 1)
    throw Failure(BAD_USAGE, "--" + name + " must be 1 or more");
  return variables[name].as<int>();
}

inline std::optional<int> threads_option(const boost::program_options::variables_map& variables)
{
  const std::optional<int> number = count_option(variables, "threads");
#ifndef CGAL_LINKED_WITH_TBB
  if(number && *number > 1)
    throw Failure(BAD_USAGE, "--threads must be 1, as this program was built without TBB");
#endif
  return number;
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

inline std::optional<double> streamline_option(const boost::program_options::variables_map& variables)
{
  if(!variables.count("streamlines"))
    return std::nullopt;
  const double spacing = variables["streamlines"].as<double>();
  if(!variables.count("vtp") || !(spacing >= 0 && std::isfinite(spacing)))
    throw Failure(BAD_USAGE, "--streamlines goes with --vtp, and SPACING must be a positive number");
  return spacing;
}

inline std::optional<std::string> field_option(const boost::program_options::variables_map& variables,
                                               const std::string& name)
{
  const std::optional<std::string> path = file_option(variables, name);
  if(path)
    field_format_of(*path);
  return path;
}

inline std::vector<std::string> fields_option(const boost::program_options::variables_map& variables)
{
  if(!variables.count("field"))
    return {};
  const auto paths = variables["field"].as<std::vector<std::string> >();
  for(const std::string& path : paths)
    field_format_of(path); // a wrong one is reported before the model is read
  return paths;
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
  std::set<std::string> names;
  for(const std::string& path : inputs_of(options))
    names.insert(unique_name(path));
  for(const std::string& path : outputs_of(options))
    if(!names.insert(unique_name(path)).second)
      throw Failure(BAD_USAGE, path + ": this is an input or another output already; give another name");
}

inline void check_that_files_replace_detection(const boost::program_options::variables_map& variables)
{
  for(const char* const name : { "feature-angle", "weak-angle", "close-gaps", "min-chain-length" })
    if(variables.count(name) && !variables[name].defaulted())
      throw Failure(BAD_USAGE, std::string("--features and --") + name + " exclude each other");
}

inline Options options_from(const boost::program_options::variables_map& variables)
{
  if(variables.count("features"))
    check_that_files_replace_detection(variables);

  Options options;
  options.model = variables.count("model") ? variables["model"].as<std::string>() : "";
  options.features = file_option(variables, "features");
  options.index_targets = file_option(variables, "index-targets");
  options.compared_field = field_option(variables, "compare");
  options.feature_angle = angle_option(variables, "feature-angle", 180);
  options.weak_angle = weak_angle_option(variables, options.feature_angle);
  options.closes_gaps = variables.count("close-gaps");
  options.minimum_chain_length = non_negative_option(variables, "min-chain-length");
  options.support = variables["support"].as<std::string>();
  support_strategy_from(options.support); // a wrong one is reported before the model is read
  options.edge_weighting = edge_weighting_from(variables["edge-weights"].as<std::string>());
  options.curvature_weight = non_negative_option(variables, "curvature-weight");
  options.sharp_corner_bound = angle_option(variables, "sharp-corner-bound", 360);
  options.repairs_matching = !variables.count("no-repair");
  options.relaxes_orthogonality = !variables.count("no-relaxation");
  options.computes_baseline = !variables.count("no-baseline");
  options.number_of_threads = threads_option(variables);
  options.ply = file_option(variables, "output");
  options.vtp = file_option(variables, "vtp");
  options.report = file_option(variables, "report");
  options.streamline_spacing = streamline_option(variables);
  options.written_features = file_option(variables, "write-features");
  options.fields = fields_option(variables);
  options.writes_ascii = variables.count("ascii");
  options.is_quiet = variables.count("quiet");
  options.is_verbose = variables.count("verbose");
  return options;
}

#endif // CAD_FRAME_FIELD_OPTIONS_H
