#ifndef FRAME_FIELDS_PROGRAMS_OPTION_VALUES_H
#define FRAME_FIELDS_PROGRAMS_OPTION_VALUES_H

#include "Failure.h"

#include <boost/program_options.hpp>

#include <cmath>
#include <optional>
#include <string>

inline double angle_option(const boost::program_options::variables_map& variables, const std::string& name,
                           const double maximum)
{
  const double angle = variables[name].as<double>();
  if(!(angle >= 0 && angle <= maximum)) // false for NaN, too
    throw Failure(BAD_USAGE, "--" + name + " must be from 0 to " + std::to_string(static_cast<int>(maximum))
                             + " degrees");
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

#endif // FRAME_FIELDS_PROGRAMS_OPTION_VALUES_H
