#ifndef FRAME_FIELDS_PROGRAMS_READ_FEATURE_LINES_H
#define FRAME_FIELDS_PROGRAMS_READ_FEATURE_LINES_H

#include "Failure.h"
#include "input_file.h"

#include <cstddef>
#include <string>

// An edge of a feature file: two vertices of the model, which need not exist, and the line that names it.
struct Vertex_pair
{
  long long first, second;
  std::size_t line_number;
};

[[noreturn]] inline void fail_in_line(const std::string& path, const std::size_t line_number, const std::string& reason)
{
  throw Failure(BAD_FILE, path + ":" + std::to_string(line_number) + ": " + reason);
}

// Calls `visit(line_number, content)` for the lines that hold more than a comment. Editors of Windows start files with
// a byte order mark.
template <typename Visit>
void for_each_feature_line(const std::string& path, const Visit& visit)
{
  const std::string byte_order_mark = "\xef\xbb\xbf";
  for_each_line(path, [&](const std::size_t line_number, std::string content)
  {
    if(content.find('\0') != std::string::npos)
      fail_in_line(path, line_number, "this is no text, or text in UTF-16; save it as UTF-8");
    if(line_number == 1 && content.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
      content.erase(0, byte_order_mark.size());
    if(content.find_first_not_of(" \t\r") != std::string::npos)
      visit(line_number, content);
  });
}

#endif // FRAME_FIELDS_PROGRAMS_READ_FEATURE_LINES_H
