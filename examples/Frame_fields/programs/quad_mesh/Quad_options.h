#ifndef FRAME_FIELDS_PROGRAMS_QUAD_OPTIONS_H
#define FRAME_FIELDS_PROGRAMS_QUAD_OPTIONS_H

#include "quad_formats.h"

#include "../shared/Failure.h"
#include "../shared/Shared_options.h"
#include "../shared/option_values.h"

#include <CGAL/Frame_fields/T_junctions.h>

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
  // They bound the lengths of edges.
  std::optional<double> chord_height;
  std::optional<int> edges_across_gap;
  std::optional<double> gradation, minimum_edge_length;
  bool field_follows_sizes;

  std::vector<std::string> meshes;
  bool writes_ascii;
  bool writes_feature_lines;
  std::optional<std::string> blocks; // what `t_junctions_from()` takes
};

inline CGAL::Frame_fields::T_junctions t_junctions_from(const std::string& text)
{
  if(text == "whole-sides")
    return CGAL::Frame_fields::T_junctions::NONE;
  if(text == "by-patch")
    return CGAL::Frame_fields::T_junctions::ON_CONSTRAINED_EDGES;
  if(text == "t-junctions")
    return CGAL::Frame_fields::T_junctions::EVERYWHERE;
  throw Failure(BAD_USAGE, "--blocks is '" + text + "' and must be whole-sides, by-patch or t-junctions");
}

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

inline std::optional<double> positive_option(const boost::program_options::variables_map& variables,
                                             const std::string& name, const double lower_bound = 0)
{
  if(!variables.count(name))
    return std::nullopt;
  const double number = variables[name].as<double>();
  if(!(number > lower_bound && std::isfinite(number)))
    throw Failure(BAD_USAGE, "--" + name + " must be greater than " + std::to_string(static_cast<int>(lower_bound)));
  return number;
}

inline void read_size_bounds(const boost::program_options::variables_map& variables, Quad_options& options)
{
  options.chord_height = positive_option(variables, "chord-height");
  options.edges_across_gap = count_option(variables, "edges-across-gap");
  options.gradation = positive_option(variables, "gradation", 1);
  options.minimum_edge_length = positive_option(variables, "min-edge-length");
  options.field_follows_sizes = variables.count("field-follows-sizes");
  for(const char* const name : { "gradation", "min-edge-length", "field-follows-sizes" })
    if(variables.count(name) && !options.chord_height && !options.edges_across_gap)
      throw Failure(BAD_USAGE, "--" + std::string(name) + " needs --chord-height or --edges-across-gap");
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

inline std::optional<std::string> blocks_option(const boost::program_options::variables_map& variables)
{
  if(!variables.count("blocks"))
    return std::nullopt;
  const std::string text = variables["blocks"].as<std::string>();
  t_junctions_from(text); // a wrong one is reported before the model is read
  return text;
}

inline Quad_options quad_options_from(const boost::program_options::variables_map& variables)
{
  Quad_options options{ shared_options_from(variables), {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {} };
  options.edge_length = edge_length_option(variables);
  options.number_of_quads = count_option(variables, "quads");
  read_size_bounds(variables, options);
  options.refines = !variables.count("no-refinement");
  options.meshes = meshes_option(variables);
  options.writes_ascii = variables.count("ascii");
  options.writes_feature_lines = variables.count("feature-lines");
  options.blocks = blocks_option(variables);
  return options;
}

#endif // FRAME_FIELDS_PROGRAMS_QUAD_OPTIONS_H
