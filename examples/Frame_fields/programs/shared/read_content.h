#ifndef FRAME_FIELDS_PROGRAMS_READ_CONTENT_H
#define FRAME_FIELDS_PROGRAMS_READ_CONTENT_H

#include "Failure.h"
#include "input_file.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <ios>
#include <string>

// The bytes of a file, which may be a pipe.
inline std::string read_content(const std::string& path)
{
  std::ifstream in = open_input(path);
  std::string content;
  std::size_t size = 0;
  while(in)
  {
    content.resize((std::max)(2 * size, std::size_t(1) << 16));
    in.read(&content[size], static_cast<std::streamsize>(content.size() - size));
    size += static_cast<std::size_t>(in.gcount());
  }
  if(in.bad() || !in.eof())
    throw Failure(BAD_FILE, path + ": cannot be read beyond byte " + std::to_string(size));
  content.resize(size);
  return content;
}

#endif // FRAME_FIELDS_PROGRAMS_READ_CONTENT_H
