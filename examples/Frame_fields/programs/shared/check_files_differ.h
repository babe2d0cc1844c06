#ifndef FRAME_FIELDS_PROGRAMS_CHECK_FILES_DIFFER_H
#define FRAME_FIELDS_PROGRAMS_CHECK_FILES_DIFFER_H

#include "Failure.h"

#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <vector>

// The same for all ways to write a path.
inline std::string unique_name(const std::string& path)
{
  std::error_code error;
  const std::filesystem::path name = std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  return error ? path : name.string();
}

// No output may replace an input or another output.
inline void check_files_differ(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs)
{
  std::set<std::string> names;
  for(const std::string& path : inputs)
    names.insert(unique_name(path));
  for(const std::string& path : outputs)
    if(!names.insert(unique_name(path)).second)
      throw Failure(BAD_USAGE, path + ": this is an input or another output already; give another name");
}

#endif // FRAME_FIELDS_PROGRAMS_CHECK_FILES_DIFFER_H
