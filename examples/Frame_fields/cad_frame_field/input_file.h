#ifndef CAD_FRAME_FIELD_INPUT_FILE_H
#define CAD_FRAME_FIELD_INPUT_FILE_H

#include "Failure.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

inline std::ifstream open_input(const std::string& path)
{
  std::error_code error;
  if(!std::filesystem::exists(path, error))
    throw Failure(BAD_FILE, path + ": there is no such file");
  if(std::filesystem::is_directory(path, error))
    throw Failure(BAD_FILE, path + ": this is a folder and not a file");
  std::ifstream in(path, std::ios::binary);
  if(!in)
    throw Failure(BAD_FILE, path + ": cannot be opened; check its permissions");
  return in;
}

// A line of a text file, counted from 1.
struct Line
{
  std::size_t number = 0;
  std::string text;
};

// Calls `visit(line_number, content)` for the lines of a text file that hold more than a comment, which `#` starts.
template <typename Visit>
void for_each_line(const std::string& path, const Visit& visit)
{
  std::ifstream in = open_input(path);
  std::size_t line_number = 0;
  for(std::string line; std::getline(in, line);)
  {
    ++line_number;
    const std::string content = line.substr(0, line.find('#'));
    if(content.find_first_not_of(" \t\r") != std::string::npos)
      visit(line_number, content);
  }
  if(in.bad())
    throw Failure(BAD_FILE, path + ": cannot be read beyond line " + std::to_string(line_number));
}

// The line that a reader was in, or had just finished, at a position.
inline Line line_before(const std::string& path, const std::streamoff position)
{
  std::ifstream in(path, std::ios::binary);
  Line line;
  while(in.tellg() < position && std::getline(in, line.text))
    ++line.number;
  return line;
}

#endif // CAD_FRAME_FIELD_INPUT_FILE_H
