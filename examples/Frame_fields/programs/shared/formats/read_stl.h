#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_READ_STL_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_READ_STL_H

#include "Byte_cursor.h"
#include "File_content.h"
#include "Left_out.h"
#include "Point_numbers.h"
#include "Raw_soup.h"
#include "Text_cursor.h"
#include "lower_case.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

// STL has no vertices but the corners of its facets: those in the same place are one, numbered as they come.

constexpr std::size_t stl_header_size = 84, stl_facet_size = 50;

// The number of facets that the header of a binary file announces.
inline std::size_t number_of_binary_facets(const File_content& file)
{
  return Byte_cursor(file, file.begin() + stl_header_size - 4, LITTLE_ENDIAN_BYTES).read<std::uint32_t>();
}

inline Raw_soup read_binary_stl(const File_content& file, const std::size_t number_of_facets)
{
  Raw_soup soup;
  Point_numbers point_numbers(soup.points);
  soup.corners.reserve(3 * number_of_facets);
  soup.ends.reserve(number_of_facets);
  Byte_cursor cursor(file, file.begin() + stl_header_size, LITTLE_ENDIAN_BYTES);
  for(std::size_t f = 0; f < number_of_facets; ++f)
  {
    cursor.skip(3 * sizeof(float)); // the normal
    for(int k = 0; k < 3; ++k)
      soup.corners.push_back(point_numbers(cursor.read_point<float>("facet", f)));
    cursor.skip(sizeof(std::uint16_t));
    soup.end_polygon();
  }
  return soup;
}

// Reads the text form: any number of solids, each from `solid` and its name to `endsolid`.
class Text_stl_reader
{
public:
  explicit Text_stl_reader(const File_content& file)
    : m_cursor(file, begin_of_text(file), Text_cursor::COMMENTS), m_point_numbers(m_soup.points)
  {}

  Raw_soup read()
  {
    bool is_in_solid = false;
    while(m_cursor.has_word())
    {
      const std::string_view word = m_cursor.word();
      const std::string keyword = lower_case(word);
      if(keyword == "facet" && is_in_solid)
        read_facet();
      else if(keyword == (is_in_solid ? "endsolid" : "solid"))
      {
        is_in_solid = !is_in_solid;
        m_cursor.skip_line(); // its name, which can be anything
      }
      else
        leave_out_line(word, keyword);
    }
    if(is_in_solid)
      m_cursor.fail_here("the file ends without 'endsolid', so that facets may be missing");
    m_left_out.warn(m_soup.warnings);
    return std::move(m_soup);
  }

private:
  // A line between facets or solids, but no part of one.
  void leave_out_line(const std::string_view word, const std::string& keyword)
  {
    static constexpr std::string_view parts[] = { "solid", "facet", "normal", "outer", "loop", "vertex", "endloop",
                                                  "endfacet", "endsolid" };
    if(std::find(std::begin(parts), std::end(parts), keyword) != std::end(parts) || !may_be_keyword(word))
      m_cursor.fail(Text_cursor::name_of(word) + " does not belong here");
    m_left_out.add(word);
    m_cursor.skip_line();
  }

  void expect(const char* const keyword)
  {
    const std::string_view word = m_cursor.next_word(keyword);
    if(lower_case(word) != keyword)
      m_cursor.fail(Text_cursor::name_of(word) + " stands where '" + keyword + "' is expected");
  }

  void read_facet()
  {
    expect("normal");
    for(int k = 0; k < 3; ++k) // facets without area have any normal
      if(lower_case(m_cursor.next_word("a normal")) == "outer")
        m_cursor.fail("a normal has fewer than three numbers");
    expect("outer");
    expect("loop");
    const std::size_t start = m_soup.corners.size();
    for(;;)
    {
      const std::string_view word = m_cursor.next_word("a vertex");
      const std::string keyword = lower_case(word);
      if(keyword == "endloop")
        break;
      if(keyword != "vertex")
        m_cursor.fail(Text_cursor::name_of(word) + " stands where 'vertex' or 'endloop' is expected");
      m_soup.corners.push_back(m_point_numbers(m_cursor.next_point("a coordinate")));
    }
    if(m_soup.corners.size() < start + 3)
      m_cursor.fail("a facet has fewer than three vertices");
    expect("endfacet");
    m_soup.end_polygon();
  }

  Text_cursor m_cursor;
  Raw_soup m_soup;
  Point_numbers m_point_numbers;
  Left_out m_left_out{ "lines" };
};

// The first bytes decide nothing, since binary files start with "solid", too, and texts with other things. A text
// as a binary file would announce more facets than a disk holds.
inline Raw_soup read_stl(const File_content& file)
{
  const std::size_t size = file.bytes.size();
  const bool has_header = size >= stl_header_size;
  const std::size_t number_of_facets = has_header ? number_of_binary_facets(file) : 0;
  const std::size_t binary_size = stl_header_size + stl_facet_size * number_of_facets;
  if(has_header && size >= binary_size && is_padding(file.begin() + binary_size, file.end()))
    return read_binary_stl(file, number_of_facets);
  const std::string_view header = file.bytes.substr(0, stl_header_size);
  if(header.find('\0') == std::string_view::npos || starts_with(header, "\xFF\xFE") || starts_with(header, "\xFE\xFF"))
    return Text_stl_reader(file).read();
  if(!has_header)
    file.fail("byte " + std::to_string(size) + ": the file ends in its header");
  file.fail("byte 80: " + std::to_string(number_of_facets) + " facets are announced, which take "
            + std::to_string(binary_size) + " bytes; the file has " + std::to_string(size));
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_READ_STL_H
