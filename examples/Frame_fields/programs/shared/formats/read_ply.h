#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_READ_PLY_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_READ_PLY_H

#include "File_content.h"
#include "Left_out.h"
#include "Ply_header.h"
#include "Ply_values.h"
#include "Raw_soup.h"
#include "Text_cursor.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reads the elements `vertex` and `face` of PLY files, with their properties in any order and of any type.
template <typename Values>
class Ply_body_reader
{
public:
  Ply_body_reader(const File_content& file, const Ply_header& header)
    : m_file(&file), m_header(&header), m_values(file, header)
  {}

  Raw_soup read()
  {
    for(const Ply_element& element : m_header->elements)
      if(element.name == "vertex")
        m_number_of_vertices = static_cast<std::size_t>(element.number);
    for(const Ply_element& element : m_header->elements)
    {
      if(element.name == "vertex")
        read_vertices(element);
      else if(element.name == "face")
        read_faces(element);
      else
        skip_elements(element);
      m_values.end_group();
    }
    m_values.end_file();
    m_left_out.warn(m_soup.warnings);
    return std::move(m_soup);
  }

private:
  void skip_property(const Ply_property& property)
  {
    const std::size_t number = property.is_list ? m_values.list_size(property.count_type, property.type) : 1;
    for(std::size_t k = 0; k < number; ++k)
      m_values.skip(property.type);
  }

  void read_vertices(const Ply_element& element)
  {
    std::vector<std::size_t> axes; // of the properties: 0, 1, 2 or 3 for none
    for(const Ply_property& property : element.properties)
      axes.push_back(property.is_list ? 3 : (std::min)(std::string_view("xyz").find(property.name), std::size_t(3)));
    for(const std::size_t axis : { 0, 1, 2 })
      if(std::count(axes.begin(), axes.end(), axis) != 1)
        m_file->fail(std::string("the header does not give vertices one property '") + "xyz"[axis] + "'");

    const std::size_t number = m_values.start_group(element);
    m_soup.points.reserve(number);
    for(std::size_t v = 0; v < number; ++v)
    {
      Coordinates point;
      for(std::size_t k = 0; k < axes.size(); ++k)
        if(axes[k] < 3)
          point[axes[k]] = m_values.real(element.properties[k].type);
        else
          skip_property(element.properties[k]);
      m_values.check_point(point, v);
      m_soup.points.push_back(point);
      m_values.end_element();
    }
  }

  void read_faces(const Ply_element& element)
  {
    const auto is_list_of_vertices = [](const Ply_property& property)
    {
      return property.name == "vertex_indices" || property.name == "vertex_index";
    };
    const auto list = std::find_if(element.properties.begin(), element.properties.end(), is_list_of_vertices);
    if(std::count_if(element.properties.begin(), element.properties.end(), is_list_of_vertices) != 1)
      m_file->fail("the header does not give faces one list 'vertex_indices' or 'vertex_index'");
    if(!list->is_list || !is_integer_type(list->type))
      m_file->fail("the property " + in_quotes(list->name) + " of faces is no list of integers");

    const std::size_t number = m_values.start_group(element);
    m_soup.ends.reserve(number);
    for(std::size_t f = 0; f < number; ++f)
    {
      for(const Ply_property& property : element.properties)
        if(&property == &*list)
          read_face(property);
        else
          skip_property(property);
      m_values.end_element();
    }
  }

  void read_face(const Ply_property& list)
  {
    const std::size_t number = m_values.list_size(list.count_type, list.type);
    if(number == 0)
      m_values.fail("a face has no vertices");
    for(std::size_t k = 0; k < number; ++k)
      m_soup.corners.push_back(m_values.index(list.type, m_number_of_vertices));
    m_soup.end_polygon();
  }

  void skip_elements(const Ply_element& element)
  {
    const std::size_t number = m_values.start_group(element);
    for(std::size_t k = 0; k < number; ++k)
    {
      for(const Ply_property& property : element.properties)
        skip_property(property);
      m_values.end_element();
    }
    if(element.name != "edge" && element.name != "halfedge") // which faces have anyway
      m_left_out.add(element.name, number);
  }

  const File_content* m_file;
  const Ply_header* m_header;
  Values m_values;
  Raw_soup m_soup;
  Left_out m_left_out{ "elements" };
  std::size_t m_number_of_vertices = 0;
};

inline Raw_soup read_ply(const File_content& file)
{
  const Ply_header header = Ply_header_reader(file).read();
  return header.format == Ply_format::TEXT ? Ply_body_reader<Ply_text_values>(file, header).read()
                                           : Ply_body_reader<Ply_binary_values>(file, header).read();
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_READ_PLY_H
