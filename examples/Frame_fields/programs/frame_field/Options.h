#ifndef FRAME_FIELDS_PROGRAMS_OPTIONS_H
#define FRAME_FIELDS_PROGRAMS_OPTIONS_H

#include "field_formats.h"

#include "../shared/Failure.h"
#include "../shared/Shared_options.h"
#include "../shared/option_values.h"

#include <boost/program_options.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

struct Options : Shared_options
{
  std::optional<std::string> compared_field;
  bool computes_baseline;

  std::optional<std::string> ply, vtp;
  std::vector<std::string> fields;
  std::optional<double> streamline_spacing; // 0 for the default
  bool writes_ascii;
};

inline std::vector<std::string> inputs_of(const Options& options)
{
  return existing({ options.model, options.features, options.index_targets, options.compared_field });
}

inline std::vector<std::string> outputs_of(const Options& options)
{
  std::vector<std::string> result = options.fields;
  for(const std::string& path : existing({ options.ply, options.vtp, options.written_features, options.report }))
    result.push_back(path);
  return result;
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

inline Options options_from(const boost::program_options::variables_map& variables)
{
  Options options{ shared_options_from(variables), {}, {}, {}, {}, {}, {}, {} };
  options.compared_field = field_option(variables, "compare");
  options.computes_baseline = !variables.count("no-baseline");
  options.ply = file_option(variables, "output");
  options.vtp = file_option(variables, "vtp");
  options.streamline_spacing = streamline_option(variables);
  options.fields = fields_option(variables);
  options.writes_ascii = variables.count("ascii");
  return options;
}

#endif // FRAME_FIELDS_PROGRAMS_OPTIONS_H
