#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_PLY_HEADER_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_PLY_HEADER_H

#include "File_content.h"
#include "Number_type.h"
#include "Text_cursor.h"
#include "lower_case.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

enum class Ply_format { TEXT, LITTLE_ENDIAN_BINARY, BIG_ENDIAN_BINARY };

struct Ply_property
{
  std::string name;
  Number_type type;
  bool is_list;
  Number_type count_type; // of a list
};

struct Ply_element
{
  std::string name;
  long long number;
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  Ply_format format = Ply_format::TEXT;
  std::vector<Ply_element> elements;
  const char* begin_of_body = nullptr;
};

// Reads the header and refuses what does not tell how the body is to be read.
class Ply_header_reader
{
public:
  explicit Ply_header_reader(const File_content& file)
    : m_file(&file), m_cursor(file, begin_of_text(file), Text_cursor::PLAIN)
  {}

  Ply_header read()
  {
    if(!m_cursor.has_word() || lower_case(m_cursor.word()) != "ply")
      m_cursor.fail("this is no PLY file, which starts with 'ply'");
    end_line();
    for(;;)
    {
      const std::string keyword = lower_case(m_cursor.next_word("a line of the header"));
      if(keyword == "comment" || keyword == "obj_info")
        m_cursor.skip_line();
      else if(keyword == "format")
        read_format();
      else if(keyword == "element")
        read_element();
      else if(keyword == "property")
        read_property();
      else if(keyword == "end_header")
        break;
      else
        m_cursor.fail(Text_cursor::name_of(keyword) + " is no keyword of a PLY header");
    }
    if(!m_has_format)
      m_cursor.fail("the header has no line 'format'");
    check_elements();
    skip_end_of_header();
    return std::move(m_header);
  }

private:
  void end_line()
  {
    if(m_cursor.has_word_in_line())
      m_cursor.fail_here("the line goes on after what it must hold");
  }

  void read_format()
  {
    static constexpr std::string_view names[] = { "ascii", "binary_little_endian", "binary_big_endian" };
    const std::string name = lower_case(m_cursor.next_word_in_line("a format"));
    const auto* const found = std::find(std::begin(names), std::end(names), name);
    if(found == std::end(names))
      m_cursor.fail(Text_cursor::name_of(name) + " is no format of PLY files");
    if(m_has_format)
      m_cursor.fail("there is a second format");
    m_has_format = true;
    m_header.format = static_cast<Ply_format>(found - names);
    if(m_cursor.has_word_in_line())
      m_cursor.word(); // the version, 1.0
    end_line();
  }

  void read_element()
  {
    Ply_element element;
    element.name = lower_case(m_cursor.next_word_in_line("the name of an element"));
    element.number = m_cursor.integer(m_cursor.next_word_in_line("a number of elements"), "a number of elements");
    if(element.number < 0)
      m_cursor.fail("a number of elements is negative");
    if(std::any_of(m_header.elements.begin(), m_header.elements.end(),
                   [&](const Ply_element& other) { return other.name == element.name; }))
      m_cursor.fail("there is a second element of this name");
    end_line();
    m_header.elements.push_back(std::move(element));
  }

  void read_property()
  {
    if(m_header.elements.empty())
      m_cursor.fail("a property stands before the first element");
    std::string type = lower_case(m_cursor.next_word_in_line("a type"));
    Ply_property property{ "", Number_type::INT32, type == "list", Number_type::UINT8 };
    if(property.is_list)
    {
      property.count_type = type_of_name(lower_case(m_cursor.next_word_in_line("a type")));
      if(!is_integer_type(property.count_type))
        m_cursor.fail("the length of a list is no integer");
      type = lower_case(m_cursor.next_word_in_line("a type"));
    }
    property.type = type_of_name(type);
    property.name = lower_case(m_cursor.next_word_in_line("the name of a property"));
    end_line();
    m_header.elements.back().properties.push_back(std::move(property));
  }

  Number_type type_of_name(const std::string& name) const
  {
    static constexpr std::string_view
      names[] = { "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64" },
      old_names[] = { "char", "uchar", "short", "ushort", "int", "uint", "", "", "float", "double" };
    for(std::size_t k = 0; k < std::size(names); ++k)
      if(name == names[k] || name == old_names[k])
        return static_cast<Number_type>(k);
    m_cursor.fail(Text_cursor::name_of(name) + " is no type of PLY files");
  }

  void check_elements() const
  {
    for(const Ply_element& element : m_header.elements)
      if(element.properties.empty() && element.number > 0)
        m_cursor.fail("the element " + Text_cursor::name_of(element.name) + " has no properties");
  }

  // A binary body starts after the end of the line, and its first byte may be that of another line end. So one of two
  // bytes is none where lines end with one \r.
  void skip_end_of_header()
  {
    end_line();
    const char* const end_of_first_line = std::find_if(begin_of_text(*m_file), m_file->end(), is_line_end);
    const bool has_pair = starts_with(bytes_from(m_cursor.position()), "\r\n")
                          && (*end_of_first_line == '\n' || starts_with(bytes_from(end_of_first_line), "\r\n"));
    const std::size_t size = has_pair ? 2 : 1;
    m_header.begin_of_body = m_cursor.position() + (std::min)(size, m_cursor.rest());
  }

  std::string_view bytes_from(const char* const at) const
  {
    return m_file->bytes.substr(static_cast<std::size_t>(at - m_file->begin()));
  }

  const File_content* m_file;
  Text_cursor m_cursor;
  Ply_header m_header;
  bool m_has_format = false;
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_PLY_HEADER_H
