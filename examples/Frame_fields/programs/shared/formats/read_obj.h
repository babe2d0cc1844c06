#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_READ_OBJ_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_READ_OBJ_H

#include "File_content.h"
#include "Left_out.h"
#include "Raw_soup.h"
#include "Text_cursor.h"
#include "lower_case.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

// Reads Wavefront OBJ: the statements `v` and `f`. Those that name and colour things mean nothing to a surface; all
// others are left out and counted.
class Obj_reader
{
public:
  explicit Obj_reader(const File_content& file)
    : m_cursor(file, begin_of_text(file), Text_cursor::COMMENTS | Text_cursor::CONTINUED_LINES), m_file(&file)
  {}

  Raw_soup read()
  {
    while(m_cursor.has_word())
      read_statement(m_cursor.word());
    if(m_largest_index >= m_soup.points.size() && m_place_of_largest_index != nullptr)
      m_file->fail_at_line(m_place_of_largest_index, "there is no vertex " + std::to_string(m_largest_index + 1)
                           + " in the file, which has " + std::to_string(m_soup.points.size()));
    m_left_out.warn(m_soup.warnings);
    return std::move(m_soup);
  }

private:
  void read_statement(const std::string_view word)
  {
    if(word == "v")
      read_vertex();
    else if(word == "f")
      read_face();
    else
      read_other_statement(lower_case(word));
  }

  void read_other_statement(const std::string& keyword)
  {
    static constexpr std::string_view
      with_names[] = { "g", "maplib", "mtllib", "o", "shadow_obj", "trace_obj", "usemap", "usemtl" },
      with_numbers[] = { "bevel", "c_interp", "d_interp", "lod", "mg", "s", "vn", "vt" };
    const auto is_in = [&](const auto& keywords)
    {
      return std::find(std::begin(keywords), std::end(keywords), keyword) != std::end(keywords);
    };
    if(keyword == "v" || keyword == "f")
      return read_statement(keyword);
    if(is_in(with_names)) // such as a folder, at the end of which a backslash joins nothing
      return m_cursor.skip_line();
    if(!is_in(with_numbers))
      leave_out(keyword);
    skip_statement();
  }

  void leave_out(const std::string& keyword)
  {
    if(!may_be_keyword(keyword))
      m_cursor.fail("the line does not start with a keyword");
    m_left_out.add(keyword);
  }

  void skip_statement()
  {
    while(m_cursor.has_word_in_line())
      m_cursor.word();
    m_cursor.skip_line();
  }

  // Coordinates, and a weight, or the three or four components of a colour.
  void read_vertex()
  {
    double values[7];
    std::size_t number = 0;
    for(; m_cursor.has_word_in_line(); ++number)
    {
      const double value = m_cursor.real(m_cursor.word());
      if(number < std::size(values))
        values[number] = value;
    }
    if(number != 3 && number != 4 && number != 6 && number != 7)
      m_cursor.fail("a vertex has " + std::to_string(number) + " numbers and not 3, or 4 with a weight, or 6 or 7 with"
                    + " a colour");
    m_soup.points.push_back({ values[0], values[1], values[2] });
  }

  void read_face()
  {
    const std::size_t start = m_soup.corners.size();
    while(m_cursor.has_word_in_line())
      m_soup.corners.push_back(vertex_of_corner(m_cursor.word()));
    if(m_soup.corners.size() == start)
      m_cursor.fail("a face has no vertices");
    m_soup.end_polygon();
  }

  // The vertex of a corner of the form v, v/vt, v//vn or v/vt/vn.
  std::size_t vertex_of_corner(const std::string_view corner)
  {
    const std::size_t slash = (std::min)(corner.find('/'), corner.size());
    const long long index = m_cursor.integer(corner.substr(0, slash), "a vertex index");
    check_other_indices(corner.substr(slash));
    const long long number_of_points = static_cast<long long>(m_soup.points.size());
    if(index == 0 || index < -number_of_points)
      m_cursor.fail("there is no vertex " + std::to_string(index) + "; the first one is 1, the last one is -1");
    const std::size_t vertex = static_cast<std::size_t>(index < 0 ? number_of_points + index : index - 1);
    if(vertex >= m_soup.points.size() && vertex >= m_largest_index) // it may follow
    {
      m_largest_index = vertex;
      m_place_of_largest_index = corner.data();
    }
    return vertex;
  }

  // Those of texture coordinates and normals, of which only the form matters.
  void check_other_indices(std::string_view indices)
  {
    for(int k = 0; !indices.empty(); ++k)
    {
      const std::size_t slash = (std::min)(indices.find('/', 1), indices.size());
      if(slash > 1)
        m_cursor.integer(indices.substr(1, slash - 1), "an index");
      indices.remove_prefix(slash);
      if(k == 2)
        m_cursor.fail("a corner has more than three indices");
    }
  }

  Text_cursor m_cursor;
  const File_content* m_file;
  Raw_soup m_soup;
  Left_out m_left_out{ "lines" };
  std::size_t m_largest_index = 0; // of those that were not there yet
  const char* m_place_of_largest_index = nullptr;
};

inline Raw_soup read_obj(const File_content& file) { return Obj_reader(file).read(); }

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_READ_OBJ_H
