#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_FILE_CONTENT_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_FILE_CONTENT_H

#include "../Failure.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

inline bool is_blank(const char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
inline bool is_line_end(const char c) { return c == '\n' || c == '\r'; }
inline bool is_space(const char c) { return is_blank(c) || is_line_end(c); }

// A piece of a file for a message, or nothing if it is long or not printable.
inline std::string in_quotes(const std::string_view text)
{
  const bool is_printable = std::all_of(text.begin(), text.end(), [](const char c) { return (c >= 32 && c < 127)
                                                                                          || c == '\t'; });
  return text.empty() || text.size() > 80 || !is_printable ? "" : "'" + std::string(text) + "'";
}

// A file in memory, and the messages that tell a place in it.
struct File_content
{
  std::string path;
  std::string_view bytes;

  const char* begin() const { return bytes.data(); }
  const char* end() const { return bytes.data() + bytes.size(); }

  [[noreturn]] void fail(const std::string& reason) const { throw Failure(BAD_FILE, path + ": " + reason); }

  [[noreturn]] void fail_at_byte(const char* const at, const std::string& reason) const
  {
    fail("byte " + std::to_string(at - begin()) + ": " + reason);
  }

  // Lines end with \n, \r\n or \r and count from 1.
  [[noreturn]] void fail_at_line(const char* const at, const std::string& reason) const
  {
    std::size_t number = 1;
    const char* start = begin();
    for(const char* c = begin(); c < at; ++c)
      if(*c == '\n' || (*c == '\r' && (c + 1 == end() || c[1] != '\n')))
      {
        ++number;
        start = c + 1;
      }
    const char* const end_of_line = std::find_if(start, end(), is_line_end);
    const std::string line = in_quotes({ start, static_cast<std::size_t>(end_of_line - start) });
    fail("line " + std::to_string(number) + (line.empty() ? "" : ", " + line) + ": " + reason);
  }
};

inline bool starts_with(const std::string_view text, const std::string_view start)
{
  return text.substr(0, start.size()) == start;
}

// Where the text of a file starts: behind the mark that editors of Windows put in front.
inline const char* begin_of_text(const File_content& file)
{
  if(starts_with(file.bytes, "\xFF\xFE") || starts_with(file.bytes, "\xFE\xFF"))
    file.fail("byte 0: this is text in UTF-16; save it as UTF-8");
  return file.begin() + (starts_with(file.bytes, "\xEF\xBB\xBF") ? 3 : 0);
}

// What follows the last element may be blanks, or the zeros that fill a block.
inline bool is_padding(const char* const begin, const char* const end)
{
  return std::all_of(begin, end, [](const char c) { return c == '\0' || is_space(c); });
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_FILE_CONTENT_H
