#ifndef FRAME_FIELDS_PROGRAMS_READ_BATCH_LIST_H
#define FRAME_FIELDS_PROGRAMS_READ_BATCH_LIST_H

#include "Batch_options.h"
#include "Failure.h"
#include "input_file.h"

#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

struct Batch_model
{
  std::string model;
  std::optional<std::string> features;
};

inline Batch_model parse_batch_model(const std::string& path, const std::size_t line_number, const std::string& line)
{
  std::istringstream words(line);
  Batch_model result;
  std::string features;
  words >> std::quoted(result.model);
  if(words >> std::quoted(features))
    result.features = features;
  words.clear();
  if(result.model.empty() || (result.features && result.features->empty()) || !(words >> std::ws).eof())
    throw Failure(BAD_FILE, path + ":" + std::to_string(line_number)
                            + ": a line must hold the name of a model and, if it has one, that of its feature file");
  return result;
}

inline std::string stem_of(const Batch_model& model)
{
  return std::filesystem::path(model.model).stem().string();
}

// Outputs are named after the models; two of the same name would replace one another's.
inline void check_stems_differ(const std::string& path, const std::vector<Batch_model>& models)
{
  std::map<std::string, std::string> model_of_stem;
  for(const Batch_model& model : models)
  {
    const auto [found, is_new] = model_of_stem.try_emplace(stem_of(model), model.model);
    if(!is_new)
      throw Failure(BAD_FILE, path + ": " + found->second + " and " + model.model
                              + " would have outputs of the same names");
  }
}

inline std::vector<Batch_model> read_batch_list(const std::string& path, const bool has_outputs)
{
  std::vector<Batch_model> models;
  for_each_line(path, [&](const std::size_t line_number, const std::string& line)
  {
    models.push_back(parse_batch_model(path, line_number, line));
  });
  if(models.empty())
    throw Failure(BAD_FILE, path + ": there are no models in it");
  if(has_outputs)
    check_stems_differ(path, models);
  return models;
}

#endif // FRAME_FIELDS_PROGRAMS_READ_BATCH_LIST_H
