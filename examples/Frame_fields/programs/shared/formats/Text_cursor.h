#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_TEXT_CURSOR_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_TEXT_CURSOR_H

#include "File_content.h"
#include "Raw_soup.h"
#include "parse_number.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

// Goes through the words of a text. They are between blanks; a line ends with \n, \r\n or \r.
class Text_cursor
{
public:
  enum Rules { PLAIN = 0, COMMENTS = 1, CONTINUED_LINES = 2 }; // `#` starts a comment, a backslash joins two lines

  Text_cursor(const File_content& file, const char* const begin, const char* const end, const int rules)
    : m_file(&file), m_at(begin), m_end(end), m_word(begin), m_rules(rules)
  {}

  Text_cursor(const File_content& file, const char* const begin, const int rules)
    : Text_cursor(file, begin, file.end(), rules)
  {}

  const char* position() const { return m_at; }
  std::size_t rest() const { return static_cast<std::size_t>(m_end - m_at); }

  // Goes to the next word of the line, if there is one.
  bool has_word_in_line()
  {
    skip_blanks();
    while(is_at_continuation())
    {
      m_at = end_of_line(m_at);
      skip_line_end();
      skip_blanks();
    }
    return m_at != m_end && !is_line_end(*m_at) && !starts_comment();
  }

  // Goes to the next word of the text, if there is one.
  bool has_word()
  {
    while(!has_word_in_line())
    {
      if(m_at == m_end)
        return false;
      skip_line();
    }
    return true;
  }

  // The word at the cursor, after it was found that there is one.
  std::string_view word()
  {
    m_word = m_at;
    while(m_at != m_end && !is_space(*m_at) && !starts_comment() && !is_at_continuation())
      ++m_at;
    return { m_word, static_cast<std::size_t>(m_at - m_word) };
  }

  std::string_view next_word(const char* const expected)
  {
    if(!has_word())
      fail_at_end(expected);
    return word();
  }

  std::string_view next_word_in_line(const char* const expected)
  {
    if(!has_word_in_line())
      m_file->fail_at_line(m_word, std::string("the line ends where ") + expected + " is expected");
    return word();
  }

  // Goes to the next line, whatever this one holds.
  void skip_line()
  {
    m_at = end_of_line(m_at);
    skip_line_end();
  }

  double real(const std::string_view word) const
  {
    double value;
    const Number_fault fault = parse_real(word, value);
    if(fault == Number_fault::NO_NUMBER)
      fail(name_of(word) + " is no number");
    if(fault == Number_fault::NOT_FINITE)
      fail(name_of(word) + " is not finite, or too large for a number");
    return value;
  }

  double finite_or_fail(const double value) const
  {
    if(!std::isfinite(value))
      fail("a coordinate is not finite");
    return value;
  }

  long long integer(const std::string_view word, const char* const expected) const
  {
    long long value;
    if(parse_integer(word, value) != Number_fault::NONE)
      fail(name_of(word) + " is not " + expected);
    return value;
  }

  Coordinates next_point(const char* const expected)
  {
    Coordinates point;
    for(double& coordinate : point)
      coordinate = real(next_word(expected));
    return point;
  }

  // Of a number that is not used only the form matters; it need not be finite.
  void skip_number()
  {
    double value;
    const std::string_view word = next_word("a number");
    if(parse_real(word, value) == Number_fault::NO_NUMBER)
      fail(name_of(word) + " is no number");
  }

  // An index that is less than a number of vertices.
  std::size_t next_index(const std::size_t number_of_vertices)
  {
    const long long index = integer(next_word("a vertex index"), "a vertex index");
    if(index < 0 || static_cast<unsigned long long>(index) >= number_of_vertices)
      fail("there is no vertex " + std::to_string(index) + ", the vertices are numbered from 0 to "
           + std::to_string(number_of_vertices) + " - 1");
    return static_cast<std::size_t>(index);
  }

  // The number of elements of which each takes so many words. Words are of two bytes with the blank between them.
  std::size_t checked_count(const long long count, const std::size_t words_of_each, const char* const elements) const
  {
    if(count < 0 || static_cast<unsigned long long>(count) > (rest() + 1) / (2 * words_of_each))
      fail(std::to_string(count) + " " + elements + " are announced, for which the rest of the file, "
           + std::to_string(rest()) + " bytes, is too short");
    return static_cast<std::size_t>(count);
  }

  // Tells the line of the last word.
  [[noreturn]] void fail(const std::string& reason) const { m_file->fail_at_line(m_word, reason); }

  // Tells the line that the cursor is in.
  [[noreturn]] void fail_here(const std::string& reason) const { m_file->fail_at_line(m_at, reason); }

  static std::string name_of(const std::string_view word)
  {
    const std::string name = in_quotes(word);
    return name.empty() ? "a word that is long or not printable" : name;
  }

private:
  bool starts_comment() const { return (m_rules & COMMENTS) && *m_at == '#'; }

  bool is_at_continuation() const
  {
    return (m_rules & CONTINUED_LINES) && m_at != m_end && *m_at == '\\' && ends_line(m_at + 1);
  }

  bool ends_line(const char* at) const
  {
    while(at != m_end && is_blank(*at))
      ++at;
    return at == m_end || is_line_end(*at);
  }

  const char* end_of_line(const char* at) const
  {
    while(at != m_end && !is_line_end(*at))
      ++at;
    return at;
  }

  void skip_blanks()
  {
    while(m_at != m_end && is_blank(*m_at))
      ++m_at;
  }

  void skip_line_end()
  {
    if(m_at == m_end)
      return;
    const bool is_pair = *m_at == '\r' && m_at + 1 != m_end && m_at[1] == '\n';
    m_at += is_pair ? 2 : 1;
  }

  [[noreturn]] void fail_at_end(const char* const expected) const
  {
    m_file->fail_at_line(m_word, std::string("the file ends after this line where ") + expected + " is expected");
  }

  const File_content* m_file;
  const char* m_at;
  const char* m_end;
  const char* m_word; // the last one
  int m_rules;
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_TEXT_CURSOR_H
