#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_PLY_VALUES_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_PLY_VALUES_H

#include "Byte_cursor.h"
#include "File_content.h"
#include "Number_type.h"
#include "Ply_header.h"
#include "Raw_soup.h"
#include "Text_cursor.h"

#include <cstddef>
#include <string>

// The values of the body of a PLY file, one after the other. Two classes with the same members, one for each form.

// Elements are one to a line, may go on over several lines, or flow freely from the first one on. What does otherwise
// has a number too few or too many somewhere.
class Ply_text_values
{
public:
  Ply_text_values(const File_content& file, const Ply_header& header)
    : m_cursor(file, header.begin_of_body, Text_cursor::PLAIN)
  {}

  std::size_t start_group(const Ply_element& element)
  {
    m_number_of_ended = 0;
    m_flows = false;
    return m_cursor.checked_count(element.number, element.properties.empty() ? 1 : element.properties.size(),
                                  "elements");
  }

  void end_element()
  {
    if(!m_cursor.has_word_in_line())
      m_flows = m_flows && m_number_of_ended > 0;
    else if(m_number_of_ended == 0)
      m_flows = true;
    else if(!m_flows)
      m_cursor.fail_here("this line has numbers too many, or it or the one before too few");
    ++m_number_of_ended;
  }

  void end_group()
  {
    if(m_cursor.has_word_in_line())
      m_cursor.fail_here("the last element does not end its line");
  }

  void end_file()
  {
    if(m_cursor.has_word())
      m_cursor.fail_here("the file goes on after the last element that its header announces");
  }

  double real(const Number_type) { return m_cursor.real(m_cursor.next_word("a number")); }
  long long integer(const Number_type) { return m_cursor.integer(m_cursor.next_word("an integer"), "an integer"); }
  void skip(const Number_type) { m_cursor.skip_number(); }
  std::size_t index(const Number_type, const std::size_t number) { return m_cursor.next_index(number); }
  void check_point(const Coordinates&, std::size_t) const {} // real() does

  std::size_t list_size(const Number_type type, const Number_type)
  {
    return m_cursor.checked_count(integer(type), 1, "numbers of a list");
  }

  [[noreturn]] void fail(const std::string& reason) const { m_cursor.fail(reason); }

private:
  Text_cursor m_cursor;
  std::size_t m_number_of_ended = 0; // elements of the group
  bool m_flows = false;
};

class Ply_binary_values
{
public:
  Ply_binary_values(const File_content& file, const Ply_header& header)
    : m_file(&file), m_cursor(file, header.begin_of_body, header.format == Ply_format::BIG_ENDIAN_BINARY
                                                          ? BIG_ENDIAN_BYTES : LITTLE_ENDIAN_BYTES)
  {}

  std::size_t start_group(const Ply_element& element)
  {
    std::size_t size = 0;
    for(const Ply_property& property : element.properties)
      size += size_of(property.is_list ? property.count_type : property.type);
    m_start_of_element = m_cursor.position();
    return m_cursor.checked_count(element.number, size > 0 ? size : 1, "elements");
  }

  void end_element() { m_start_of_element = m_cursor.position(); }
  void end_group() {}

  void end_file()
  {
    if(!is_padding(m_cursor.position(), m_file->end()))
      m_cursor.fail("the file goes on after the last element that its header announces");
  }

  double real(const Number_type type) { return read_real(m_cursor, type); }
  long long integer(const Number_type type) { return read_integer(m_cursor, type); }
  void skip(const Number_type type) { m_cursor.skip(size_of(type)); }

  std::size_t index(const Number_type type, const std::size_t number)
  {
    return m_cursor.checked_index(integer(type), number);
  }

  void check_point(const Coordinates& point, const std::size_t vertex) const
  {
    m_cursor.check_point(point, m_start_of_element, "vertex", vertex);
  }

  std::size_t list_size(const Number_type type, const Number_type type_of_numbers)
  {
    return m_cursor.checked_count(integer(type), size_of(type_of_numbers), "numbers of a list");
  }

  [[noreturn]] void fail(const std::string& reason) const { m_cursor.fail(reason); }

private:
  const File_content* m_file;
  Byte_cursor m_cursor;
  const char* m_start_of_element = nullptr;
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_PLY_VALUES_H
