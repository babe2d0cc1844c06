#ifndef CAD_FRAME_FIELD_COMMAND_LINE_H
#define CAD_FRAME_FIELD_COMMAND_LINE_H

#include "Batch_options.h"
#include "Failure.h"
#include "Options.h"
#include "option_descriptions.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <optional>
#include <string>

// What the program is asked to do: for one model, or the same for each model of a batch.
struct Command_line
{
  Options options;
  std::optional<Batch_options> batch;
};

inline boost::program_options::parsed_options parse_command_line(const int argc, const char* const* const argv)
{
  namespace po = boost::program_options;
  static po::options_description all_options; // the result refers to it
  all_options.add(option_descriptions()).add_options()("model", po::value<std::string>());
  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  return po::command_line_parser(argc, argv).options(all_options)
    .positional(po::positional_options_description().add("model", 1)).style(style).run();
}

inline void check_model(const boost::program_options::variables_map& variables)
{
  const bool has_model = variables.count("model") && !variables["model"].as<std::string>().empty();
  if(!has_model && !variables.count("batch"))
    throw Failure(BAD_USAGE, "MODEL is missing; cad_frame_field --help tells the usage");
}

// The command line, or nothing if it asks for the help or the version, which are then printed.
inline std::optional<Command_line> read_command_line(const int argc, const char* const* const argv)
try
{
  const boost::program_options::parsed_options parsed = parse_command_line(argc, argv);
  boost::program_options::variables_map variables;
  boost::program_options::store(parsed, variables);
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
  check_model(variables);
  Command_line result{ options_from(variables), batch_options_from(variables, parsed) };
  if(!result.batch)
    check_files_differ(result.options);
  return result;
}
catch(const boost::program_options::error& error)
{
  throw Failure(BAD_USAGE, std::string(error.what()) + "; cad_frame_field --help tells the usage");
}

#endif // CAD_FRAME_FIELD_COMMAND_LINE_H
