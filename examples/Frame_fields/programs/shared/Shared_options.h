#ifndef FRAME_FIELDS_PROGRAMS_SHARED_OPTIONS_H
#define FRAME_FIELDS_PROGRAMS_SHARED_OPTIONS_H

#include "Failure.h"
#include "feature_formats.h"
#include "option_values.h"

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/Support_strategy.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

// What all programs read from their command lines: the model, its features, the field on it and how the run goes.
struct Shared_options
{
  std::string model;
  bool merges_vertices;
  double crack_tolerance; // a length of the model; 0 if cracks stay open
  std::optional<std::string> features, index_targets;
  double feature_angle, weak_angle; // degrees
  bool closes_gaps;
  double minimum_chain_length;
  std::string support;
  double sharp_corner_bound, blunt_corner_bound; // degrees
  CGAL::Frame_fields::Edge_weighting edge_weighting;
  double curvature_weight;
  bool repairs_matching;
  bool relaxes_orthogonality;
  std::optional<int> number_of_threads; // nothing for all cores

  std::optional<std::string> report, written_features;
  bool is_quiet, is_verbose;
};

inline std::vector<std::string> existing(const std::vector<std::optional<std::string> >& paths)
{
  std::vector<std::string> result;
  for(const std::optional<std::string>& path : paths)
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
    return CGAL::Frame_fields::Edge_weighting::UNIFORM;
  if(text == "geometric")
    return CGAL::Frame_fields::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH;
  throw Failure(BAD_USAGE, "--edge-weights is '" + text + "' and must be uniform or geometric");
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

inline void check_that_files_replace_detection(const boost::program_options::variables_map& variables)
{
  for(const char* const name : { "feature-angle", "weak-angle", "close-gaps", "min-chain-length" })
    if(variables.count(name) && !variables[name].defaulted())
      throw Failure(BAD_USAGE, std::string("--features and --") + name + " exclude each other");
}

inline std::optional<std::string> written_features_option(const boost::program_options::variables_map& variables)
{
  const std::optional<std::string> path = file_option(variables, "write-features");
  if(path && feature_format_of(*path) == ABC_CURVES)
    throw Failure(BAD_USAGE, *path + ": features are not written as YAML; give another end of the name");
  return path;
}

inline Shared_options shared_options_from(const boost::program_options::variables_map& variables)
{
  if(variables.count("features"))
    check_that_files_replace_detection(variables);

  Shared_options options;
  options.model = variables.count("model") ? variables["model"].as<std::string>() : "";
  options.merges_vertices = !variables.count("no-merge");
  options.crack_tolerance = non_negative_option(variables, "close-cracks");
  options.features = file_option(variables, "features");
  options.index_targets = file_option(variables, "index-targets");
  options.feature_angle = angle_option(variables, "feature-angle", 180);
  options.weak_angle = weak_angle_option(variables, options.feature_angle);
  options.closes_gaps = variables.count("close-gaps");
  options.minimum_chain_length = non_negative_option(variables, "min-chain-length");
  options.support = variables["support"].as<std::string>();
  support_strategy_from(options.support); // a wrong one is reported before the model is read
  options.edge_weighting = edge_weighting_from(variables["edge-weights"].as<std::string>());
  options.curvature_weight = non_negative_option(variables, "curvature-weight");
  options.sharp_corner_bound = angle_option(variables, "sharp-corner-bound", 360);
  options.blunt_corner_bound = angle_option(variables, "blunt-corner-bound", 360);
  options.repairs_matching = !variables.count("no-repair");
  options.relaxes_orthogonality = !variables.count("no-relaxation");
  options.number_of_threads = threads_option(variables);
  options.report = file_option(variables, "report");
  options.written_features = written_features_option(variables);
  options.is_quiet = variables.count("quiet");
  options.is_verbose = variables.count("verbose");
  return options;
}

#endif // FRAME_FIELDS_PROGRAMS_SHARED_OPTIONS_H
