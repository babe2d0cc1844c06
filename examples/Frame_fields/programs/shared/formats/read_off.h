#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_READ_OFF_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_READ_OFF_H

#include "../Failure.h"
#include "File_content.h"
#include "Off_header.h"
#include "Raw_soup.h"
#include "Text_cursor.h"
#include "read_binary_off.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

// Reads the text form. It is free as to line ends up to the faces, whose colours end with the line. Yet colours of
// vertices are often of another length than the header says, and told by the line alone: so there are two ways to read
// vertices, and one of them fits.
class Text_off_reader
{
public:
  Text_off_reader(const Off_header& header, const Text_cursor& cursor) : m_header(header), m_cursor(cursor)
  {
    m_header.number_of_vertices = count("vertices", 3);
    m_header.number_of_faces = count("faces", 1);
    if(m_cursor.has_word_in_line() || has_number_alone_in_next_line())
      m_cursor.integer(m_cursor.next_word("the number of edges"), "the number of edges");
  }

  Raw_soup read() const
  {
    try
    {
      return Attempt(*this).read(&Attempt::read_vertices_by_lines);
    }
    catch(const Failure&)
    {
      try
      {
        return Attempt(*this).read(&Attempt::read_vertices_by_numbers);
      }
      catch(const Failure&) {} // less likely what is meant
      throw;
    }
  }

private:
  std::size_t count(const char* const elements, const std::size_t words_of_each)
  {
    const long long number = m_cursor.integer(m_cursor.next_word(elements), "a number of elements");
    return m_cursor.checked_count(number, words_of_each, elements);
  }

  bool has_number_alone_in_next_line() const
  {
    Text_cursor copy = m_cursor;
    if(!copy.has_word())
      return false;
    copy.word();
    return !copy.has_word_in_line();
  }

  class Attempt
  {
  public:
    explicit Attempt(const Text_off_reader& reader) : m_header(reader.m_header), m_cursor(reader.m_cursor) {}

    Raw_soup read(void (Attempt::* const read_vertices)())
    {
      m_soup.points.reserve(m_header.number_of_vertices);
      (this->*read_vertices)();
      m_soup.ends.reserve(m_header.number_of_faces);
      for(std::size_t f = 0; f < m_header.number_of_faces; ++f)
        read_face();
      if(m_cursor.has_word())
        m_cursor.fail_here("the file goes on after the last of its " + std::to_string(m_header.number_of_vertices)
                           + " vertices and " + std::to_string(m_header.number_of_faces) + " faces");
      return std::move(m_soup);
    }

    // Each vertex ends its line, and all have equally many numbers.
    void read_vertices_by_lines()
    {
      std::optional<std::size_t> common_number;
      for(std::size_t v = 0; v < m_header.number_of_vertices; ++v)
      {
        read_point();
        std::size_t number = 0;
        for(; m_cursor.has_word_in_line(); ++number)
          m_cursor.skip_number();
        if(number != common_number.value_or(number) || !m_header.can_follow_point(number))
          m_cursor.fail("this vertex has " + std::to_string(number) + " numbers after its coordinates; "
                        + (common_number ? "those before have " + std::to_string(*common_number)
                                         : "that is not what the first word of the file announces"));
        common_number = number;
      }
      if(common_number.value_or(0) > 0 && !m_header.announces_attributes())
        m_soup.warnings.push_back("numbers after the coordinates of vertices left out: "
                                  + std::to_string(*common_number) + " of each");
    }

    // Each vertex has as many numbers as the header says.
    void read_vertices_by_numbers()
    {
      for(std::size_t v = 0; v < m_header.number_of_vertices; ++v)
      {
        read_point();
        for(std::size_t k = 0; k < m_header.number_of_attributes(); ++k)
          m_cursor.skip_number();
      }
      if(m_cursor.has_word_in_line())
        m_cursor.fail_here("the last vertex does not end its line");
    }

  private:
    void read_point()
    {
      Coordinates point = m_cursor.next_point("a coordinate");
      if(m_header.is_homogeneous)
      {
        const double weight = m_cursor.real(m_cursor.next_word("a weight"));
        for(double& coordinate : point)
          coordinate = m_cursor.finite_or_fail(coordinate / weight);
      }
      m_soup.points.push_back(point);
    }

    void read_face()
    {
      const long long announced = m_cursor.integer(m_cursor.next_word("a face"), "the number of vertices of a face");
      const std::size_t number = m_cursor.checked_count(announced, 1, "vertices of a face");
      if(number == 0)
        m_cursor.fail("a face has no vertices");
      for(std::size_t k = 0; k < number; ++k)
        m_soup.corners.push_back(m_cursor.next_index(m_header.number_of_vertices));
      m_soup.end_polygon();
      for(int k = 0; m_cursor.has_word_in_line(); ++k)
      {
        m_cursor.skip_number();
        if(k == 4)
          m_cursor.fail("the line of a face goes on after its vertices and the four numbers of a colour");
      }
    }

    Off_header m_header;
    Text_cursor m_cursor;
    Raw_soup m_soup;
  };

  Off_header m_header;
  Text_cursor m_cursor;
};

inline Raw_soup read_off(const File_content& file)
{
  Text_cursor cursor(file, begin_of_text(file), Text_cursor::COMMENTS);
  const Off_header header = read_off_header(file, cursor);
  return header.is_binary ? read_binary_off(file, header) : Text_off_reader(header, cursor).read();
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_READ_OFF_H
