#ifndef FRAME_FIELDS_PROGRAMS_QUAD_OPTIONS_H
#define FRAME_FIELDS_PROGRAMS_QUAD_OPTIONS_H

#include "quad_formats.h"

#include "../shared/Failure.h"
#include "../shared/Shared_options.h"
#include "../shared/option_values.h"

#include <boost/program_options.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

struct Quad_options : Shared_options
{
  std::optional<double> edge_length;
  std::optional<int> number_of_quads; // excludes the edge length
  bool refines;

  std::vector<std::string> meshes;
  bool writes_ascii;
  bool writes_feature_lines;
};

inline std::vector<std::string> inputs_of(const Quad_options& options)
{
  return existing({ options.model, options.features, options.index_targets });
}

inline std::vector<std::string> outputs_of(const Quad_options& options)
{
  std::vector<std::string> result = options.meshes;
  for(const std::string& path : existing({ options.written_features, options.report }))
    result.push_back(path);
  return result;
}

inline std::optional<double> edge_length_option(const boost::program_options::variables_map& variables)
{
  if(!variables.count("edge-length"))
    return std::nullopt;
  if(variables.count("quads"))
    throw Failure(BAD_USAGE, "--edge-length and --quads exclude each other");
  const double length = variables["edge-length"].as<double>();
  if(!(length > 0 && std::isfinite(length)))
    throw Failure(BAD_USAGE, "--edge-length must be a positive number");
  return length;
}

inline std::vector<std::string> meshes_option(const boost::program_options::variables_map& variables)
{
  if(!variables.count("output"))
    return {};
  const auto paths = variables["output"].as<std::vector<std::string> >();
  for(const std::string& path : paths)
    quad_format_of(path); // a wrong one is reported before the model is read
  return paths;
}

inline Quad_options quad_options_from(const boost::program_options::variables_map& variables)
{
  Quad_options options{ shared_options_from(variables), {}, {}, {}, {}, {}, {} };
  options.edge_length = edge_length_option(variables);
  options.number_of_quads = count_option(variables, "quads");
  options.refines = !variables.count("no-refinement");
  options.meshes = meshes_option(variables);
  options.writes_ascii = variables.count("ascii");
  options.writes_feature_lines = variables.count("feature-lines");
  return options;
}

#endif // FRAME_FIELDS_PROGRAMS_QUAD_OPTIONS_H
