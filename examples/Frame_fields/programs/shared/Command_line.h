#ifndef FRAME_FIELDS_PROGRAMS_COMMAND_LINE_H
#define FRAME_FIELDS_PROGRAMS_COMMAND_LINE_H

#include "Failure.h"
#include "check_files_differ.h"
#include "program_name.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <optional>
#include <string>

template <typename Program>
boost::program_options::variables_map parse_command_line(const int argc, const char* const* const argv)
{
  namespace po = boost::program_options;
  po::options_description all_options;
  all_options.add(Program::option_descriptions()).add_options()("model", po::value<std::string>());
  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  po::variables_map variables;
  po::store(po::command_line_parser(argc, argv).options(all_options)
              .positional(po::positional_options_description().add("model", 1)).style(style).run(), variables);
  return variables;
}

inline std::string hint_to_help()
{
  return std::string("; ") + program_name + " --help tells the usage";
}

// The options of the command line, or nothing if it asks for the help or the version, which are then printed.
template <typename Program>
std::optional<typename Program::Options> read_command_line(const int argc, const char* const* const argv)
try
{
  const boost::program_options::variables_map variables = parse_command_line<Program>(argc, argv);
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
  if(!variables.count("model") || variables["model"].as<std::string>().empty())
    throw Failure(BAD_USAGE, "MODEL is missing" + hint_to_help());
  const typename Program::Options options = Program::options_from(variables);
  check_files_differ(inputs_of(options), outputs_of(options));
  return options;
}
catch(const boost::program_options::error& error)
{
  throw Failure(BAD_USAGE, error.what() + hint_to_help());
}

#endif // FRAME_FIELDS_PROGRAMS_COMMAND_LINE_H
