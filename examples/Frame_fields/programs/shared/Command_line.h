#ifndef FRAME_FIELDS_PROGRAMS_COMMAND_LINE_H
#define FRAME_FIELDS_PROGRAMS_COMMAND_LINE_H

#include "Batch_options.h"
#include "Failure.h"
#include "check_files_differ.h"
#include "program_name.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <optional>
#include <string>

// What a program is asked to do: for one model, or the same for each model of a batch.
template <typename Program>
struct Command_line
{
  typename Program::Options options;
  std::optional<Batch_options> batch;
};

template <typename Program>
boost::program_options::parsed_options parse_command_line(const int argc, const char* const* const argv)
{
  namespace po = boost::program_options;
  static po::options_description all_options; // the result refers to it
  all_options.add(Program::option_descriptions()).add_options()("model", po::value<std::string>());
  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  return po::command_line_parser(argc, argv).options(all_options)
    .positional(po::positional_options_description().add("model", 1)).style(style).run();
}

inline std::string hint_to_help()
{
  return std::string("; ") + program_name + " --help tells the usage";
}

inline void check_model(const boost::program_options::variables_map& variables)
{
  const bool has_model = variables.count("model") && !variables["model"].as<std::string>().empty();
  if(!has_model && !variables.count("batch"))
    throw Failure(BAD_USAGE, "MODEL is missing" + hint_to_help());
}

// The command line, or nothing if it asks for the help or the version, which are then printed.
template <typename Program>
std::optional<Command_line<Program> > read_command_line(const int argc, const char* const* const argv)
try
{
  const boost::program_options::parsed_options parsed = parse_command_line<Program>(argc, argv);
  boost::program_options::variables_map variables;
  boost::program_options::store(parsed, variables);
  if(variables.count("help"))
  {
    Program::print_help(std::cout);
    return std::nullopt;
  }
  if(variables.count("version"))
  {
    std::cout << program_name << " " FRAME_FIELDS_VERSION "\n";
    return std::nullopt;
  }
  check_model(variables);
  Command_line<Program> result{ Program::options_from(variables), batch_options_from(variables, parsed) };
  if(!result.batch)
    check_files_differ(inputs_of(result.options), outputs_of(result.options));
  return result;
}
catch(const boost::program_options::error& error)
{
  throw Failure(BAD_USAGE, error.what() + hint_to_help());
}

#endif // FRAME_FIELDS_PROGRAMS_COMMAND_LINE_H
