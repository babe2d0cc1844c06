#ifndef FRAME_FIELDS_PROGRAMS_INPUT_H
#define FRAME_FIELDS_PROGRAMS_INPUT_H

#include "Console.h"
#include "Failure.h"
#include "Mesh.h"
#include "Model.h"
#include "Shared_options.h"
#include "Soup.h"
#include "feature_edges.h"
#include "read_feature_lines.h"
#include "read_features.h"

#include <new>
#include <vector>

// What the model and its feature file hold.
struct Input
{
  std::vector<Vertex_pair> features; // if they are listed
  Model model;
};

// Calls `read_more(model)` when the model is read, for what else there is to read.
template <typename ReadMore>
Input read_input(const Shared_options& options, Console& console, const ReadMore& read_more)
{
  console.show_progress("reading " + options.model);
  try
  {
    const Soup soup = read_soup(options.model, console);
    Input input;
    if(options.features)
      input.features = read_features(*options.features, soup);
    input.model = make_model(options, soup, console);
    read_more(input.model);
    return input;
  }
  catch(const std::bad_alloc&)
  {
    throw Failure(BAD_FILE, options.model + ": more memory is needed than there is; a damaged header can be the cause");
  }
}

inline Feature_map mark_features(const Shared_options& options, Input& input, Console& console)
{
  return options.features ? mark_listed_features(*options.features, input.features, input.model, console)
                          : detect_features(options, input.model);
}

#endif // FRAME_FIELDS_PROGRAMS_INPUT_H
