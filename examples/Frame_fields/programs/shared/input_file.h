#ifndef FRAME_FIELDS_PROGRAMS_INPUT_FILE_H
#define FRAME_FIELDS_PROGRAMS_INPUT_FILE_H

#include "Failure.h"

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <ios>
#include <sstream>
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

// The words of a text file without its comments, and the lines that they are in.
class Word_reader
{
public:
  explicit Word_reader(const std::string& path) : m_path(path), m_in(open_input(path)) {}

  // The next word, or nothing at the end of the file.
  std::string next()
  {
    std::string word;
    while(!(m_words >> word))
    {
      if(!std::getline(m_in, m_line.text))
      {
        if(m_in.bad())
          fail("cannot be read beyond this line");
        return "";
      }
      ++m_line.number;
      m_words = std::istringstream(m_line.text.substr(0, m_line.text.find('#')));
    }
    return word;
  }

  void skip_line() { m_words.setstate(std::ios::failbit); }

  // The next word as a number of a type; the message of a failure tells what was expected.
  template <typename Number>
  Number next_number(const std::string& expected)
  {
    const std::string word = next();
    Number number;
    if(!boost::conversion::try_lexical_convert(word, number))
      fail((word.empty() ? "the file ends" : "'" + word + "'") + " where " + expected + " is expected");
    return number;
  }

  void expect_end()
  {
    if(!next().empty())
      fail("the file goes on after its last element");
  }

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Failure(BAD_FILE, m_path + ":" + std::to_string(m_line.number) + ": " + reason);
  }

private:
  std::string m_path;
  std::ifstream m_in;
  Line m_line;
  std::istringstream m_words;
};

#endif // FRAME_FIELDS_PROGRAMS_INPUT_FILE_H
