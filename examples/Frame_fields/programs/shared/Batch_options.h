#ifndef FRAME_FIELDS_PROGRAMS_BATCH_OPTIONS_H
#define FRAME_FIELDS_PROGRAMS_BATCH_OPTIONS_H

#include "Failure.h"
#include "option_values.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

// A batch of models, and the arguments that all of them have in common.
struct Batch_options
{
  std::string list, folder;
  int number_of_jobs;
  std::optional<double> timeout; // seconds
  std::vector<std::string> arguments;
  bool has_one_thread_a_model; // which makes no difference to the results
  bool is_quiet;
};

// What is not handed on to each model.
inline bool is_of_batch_alone(const std::string& option)
{
  return std::set<std::string>{ "batch", "out-dir", "jobs", "timeout", "quiet" }.count(option) > 0;
}

inline bool is_output(const std::string& option)
{
  return std::set<std::string>{ "output", "vtp", "field", "write-features" }.count(option) > 0;
}

inline void check_options_of_batch(const boost::program_options::variables_map& variables)
{
  for(const char* const name : { "model", "features", "index-targets", "compare", "report", "help", "version" })
    if(variables.count(name))
      throw Failure(BAD_USAGE, std::string(name[0] == 'm' ? "MODEL" : "--") + (name[0] == 'm' ? "" : name)
                               + " and --batch exclude each other");
  if(!variables.count("out-dir") || variables["out-dir"].as<std::string>().empty())
    throw Failure(BAD_USAGE, "--batch needs --out-dir");
  if(variables.count("timeout") && !(variables["timeout"].as<double>() > 0))
    throw Failure(BAD_USAGE, "--timeout must be a number of seconds above 0");
}

// The options of the command line that go to each model, with their values.
inline std::vector<std::string> common_arguments(const boost::program_options::parsed_options& parsed)
{
  std::vector<std::string> result;
  for(const auto& option : parsed.options)
  {
    if(is_of_batch_alone(option.string_key))
      continue;
    if(option.value.empty())
      result.push_back("--" + option.string_key);
    for(const std::string& value : option.value)
    {
      if(is_output(option.string_key) && value.find("{}") == std::string::npos)
        throw Failure(BAD_USAGE, value + ": the name of an output of a batch must contain {}, which stands for the "
                                 "model");
      result.push_back("--" + option.string_key + "=" + value);
    }
  }
  return result;
}

inline std::optional<Batch_options> batch_options_from(const boost::program_options::variables_map& variables,
                                                       const boost::program_options::parsed_options& parsed)
{
  if(!variables.count("batch"))
  {
    for(const char* const name : { "out-dir", "jobs", "timeout" })
      if(variables.count(name))
        throw Failure(BAD_USAGE, std::string("--") + name + " needs --batch");
    return std::nullopt;
  }
  check_options_of_batch(variables);
  const int number_of_cores = (std::max)(1, static_cast<int>(std::thread::hardware_concurrency()));
  Batch_options batch;
  batch.list = variables["batch"].as<std::string>();
  batch.folder = variables["out-dir"].as<std::string>();
  batch.number_of_jobs = count_option(variables, "jobs").value_or(number_of_cores);
  if(variables.count("timeout"))
    batch.timeout = variables["timeout"].as<double>();
  batch.arguments = common_arguments(parsed);
  batch.is_quiet = variables.count("quiet");
  batch.has_one_thread_a_model = !variables.count("threads") && batch.number_of_jobs > 1;
  return batch;
}

#endif // FRAME_FIELDS_PROGRAMS_BATCH_OPTIONS_H
