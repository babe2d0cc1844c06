#ifndef FRAME_FIELDS_PROGRAMS_FILE_EXTENSION_H
#define FRAME_FIELDS_PROGRAMS_FILE_EXTENSION_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

inline std::string lower_case_extension(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

#endif // FRAME_FIELDS_PROGRAMS_FILE_EXTENSION_H
