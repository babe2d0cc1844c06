#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_READ_BINARY_OFF_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_READ_BINARY_OFF_H

#include "../Failure.h"
#include "Byte_cursor.h"
#include "File_content.h"
#include "Off_header.h"
#include "Raw_soup.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// What writers of the binary form do not agree about: Geomview has colours of four numbers, CGAL of three; Geomview
// ends a face with the number of the numbers of its colour and these, others end it with its last vertex.
struct Binary_off_layout
{
  std::size_t length_of_color;
  bool has_colors_of_faces;
};

// Reads Geomview's binary form, all in numbers of four bytes, the largest byte first.
class Binary_off_reader
{
public:
  Binary_off_reader(const File_content& file, const Off_header& header, const Binary_off_layout& layout)
    : m_file(&file), m_header(header), m_layout(layout), m_cursor(file, header.begin_of_binary, BIG_ENDIAN_BYTES)
  {}

  Raw_soup read()
  {
    if(m_header.has_dimension && m_cursor.read<std::int32_t>() != 3)
      m_cursor.fail("the dimension of the points is not 3");
    m_header.number_of_vertices = count(3, "vertices");
    m_header.number_of_faces = count(1, "faces");
    m_cursor.skip(sizeof(std::int32_t)); // the number of edges
    for(std::size_t v = 0; v < m_header.number_of_vertices; ++v)
      read_vertex(v);
    for(std::size_t f = 0; f < m_header.number_of_faces; ++f)
      read_face();
    if(!is_padding(m_cursor.position(), m_file->end()))
      m_cursor.fail("the file goes on after the last of its " + std::to_string(m_header.number_of_faces) + " faces");
    return std::move(m_soup);
  }

private:
  std::size_t count(const std::size_t numbers_of_each, const char* const elements)
  {
    return m_cursor.checked_count(m_cursor.read<std::int32_t>(), numbers_of_each * sizeof(float), elements);
  }

  void read_vertex(const std::size_t v)
  {
    const char* const start = m_cursor.position();
    Coordinates point = m_cursor.read_point<float>("vertex", v);
    if(m_header.is_homogeneous)
    {
      const double weight = m_cursor.read<float>();
      for(double& coordinate : point)
        coordinate /= weight;
      m_cursor.check_point(point, start, "vertex", v);
    }
    m_soup.points.push_back(point);
    m_cursor.skip(sizeof(float) * m_header.number_of_attributes(m_layout.length_of_color));
  }

  void read_face()
  {
    const std::size_t number = count(1, "vertices of a face");
    if(number == 0)
      m_cursor.fail("the face before has no vertices");
    for(std::size_t k = 0; k < number; ++k)
      m_soup.corners.push_back(m_cursor.checked_index(m_cursor.read<std::int32_t>(), m_header.number_of_vertices));
    m_soup.end_polygon();
    if(!m_layout.has_colors_of_faces)
      return;
    const std::size_t length_of_color = count(1, "numbers of a colour");
    if(length_of_color > 4)
      m_cursor.fail("the colour before this byte has more than four numbers");
    m_cursor.skip(sizeof(float) * length_of_color);
  }

  const File_content* m_file;
  Off_header m_header;
  Binary_off_layout m_layout;
  Byte_cursor m_cursor;
  Raw_soup m_soup;
};

// Takes the one layout with which the file has all that it announces and ends there.
inline Raw_soup read_binary_off(const File_content& file, const Off_header& header)
{
  std::vector<Binary_off_layout> layouts = { { 4, true }, { 4, false } };
  if(header.has_colors)
    layouts.push_back({ 3, true });
  std::vector<Raw_soup> soups;
  std::string first_fault; // with the layout of Geomview
  for(const Binary_off_layout& layout : layouts)
    try
    {
      soups.push_back(Binary_off_reader(file, header, layout).read());
    }
    catch(const Failure& failure)
    {
      if(first_fault.empty())
        first_fault = failure.what();
    }
  if(soups.empty())
    throw Failure(BAD_FILE, first_fault);
  for(const Raw_soup& soup : soups)
    if(soup.points != soups[0].points || soup.corners != soups[0].corners || soup.ends != soups[0].ends)
      file.fail("byte " + std::to_string(header.begin_of_binary - file.begin())
                + ": it does not become clear from here on how long colours are");
  return std::move(soups[0]);
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_READ_BINARY_OFF_H
