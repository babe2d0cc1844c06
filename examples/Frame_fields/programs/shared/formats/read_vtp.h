#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_READ_VTP_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_READ_VTP_H

#include "File_content.h"
#include "Number_type.h"
#include "Raw_soup.h"
#include "Text_cursor.h"
#include "Vtk_xml_arrays.h"
#include "Xml_tags.h"
#include "parse_number.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reads the polygons and triangle strips of VTK XML PolyData; vertices and lines are no faces.
class Vtp_reader
{
public:
  explicit Vtp_reader(const File_content& file) : m_file(&file) { read_tags(); }

  Raw_soup read()
  {
    Vtk_xml_decoder decoder(*m_file, m_encoding);
    for(const Piece& piece : m_pieces)
      read_piece(decoder, piece);
    return std::move(m_soup);
  }

private:
  struct Cells
  {
    Vtk_xml_array vertices, ends;
  };

  struct Piece
  {
    const char* tag;
    long long number_of_points, number_of_polygons, number_of_strips;
    Vtk_xml_array points;
    Cells polygons, strips;
  };

  void read_tags()
  {
    Xml_tags tags(*m_file);
    std::vector<std::string_view> open; // the elements around the place
    Xml_tag tag;
    const bool has_tag = tags.next(tag);
    if(!has_tag || tag.name != "VTKFile" || tag["type"] != "PolyData")
      m_file->fail_at_line(has_tag ? tag.begin : m_file->begin(),
                           "this is no VTP file, which starts with <VTKFile type=\"PolyData\" ...>");
    read_root(tag);
    do
    {
      if(m_end_of_array != nullptr)
        *std::exchange(m_end_of_array, nullptr) = tag.begin;
      if(tag.is_end)
      {
        if(open.empty() || open.back() != tag.name)
          m_file->fail_at_line(tag.begin, "this tag ends nothing");
        open.pop_back();
        continue;
      }
      read_start(tag, open.empty() ? "" : open.back());
      if(m_encoding.begin_of_appended != nullptr) // bytes as such are no tags
        return;
      if(!tag.is_empty)
        open.push_back(tag.name);
    }
    while(!open.empty() && tags.next(tag));
    if(!open.empty())
      m_file->fail_at_line(m_file->end(), "the file ends without </" + std::string(open.back()) + ">");
    if(!is_padding(tag.end, m_file->end()))
      m_file->fail_at_line(tag.end, "the file goes on after its end");
  }

  void read_start(const Xml_tag& tag, const std::string_view parent)
  {
    if(tag.name == "Piece")
      m_pieces.push_back({ tag.begin, integer(tag, "NumberOfPoints"), integer(tag, "NumberOfPolys"),
                           integer(tag, "NumberOfStrips"), {}, {}, {} });
    else if(tag.name == "DataArray" && !m_pieces.empty())
      read_array(tag, parent);
    else if(tag.name == "AppendedData")
      read_appended_data(tag);
  }

  void read_root(const Xml_tag& tag)
  {
    m_encoding.byte_order = tag["byte_order"] == "BigEndian" ? BIG_ENDIAN_BYTES : LITTLE_ENDIAN_BYTES;
    m_encoding.has_long_headers = tag["header_type"] == "UInt64";
    m_encoding.compressor = tag["compressor"];
  }

  void read_appended_data(const Xml_tag& tag)
  {
    m_encoding.are_appended_in_base64 = tag["encoding"] == "base64";
    const char* const mark = std::find(tag.end, m_file->end(), '_');
    if(mark == m_file->end() || (!m_encoding.are_appended_in_base64 && tag["encoding"] != "raw"))
      m_file->fail_at_line(tag.begin, "the data that are appended are neither raw nor base64, or have no '_' in front");
    m_encoding.begin_of_appended = mark + 1;
  }

  long long integer(const Xml_tag& tag, const std::string_view attribute, const long long default_value = 0) const
  {
    long long value = default_value;
    const std::string_view text = tag[attribute];
    if(!text.empty() && parse_integer(text, value) != Number_fault::NONE)
      m_file->fail_at_line(text.data(), Text_cursor::name_of(text) + " is not an integer");
    return value;
  }

  void read_array(const Xml_tag& tag, const std::string_view parent)
  {
    Piece& piece = m_pieces.back();
    Vtk_xml_array* array = nullptr;
    if(parent == "Points")
      array = &piece.points;
    else if(parent == "Polys" || parent == "Strips")
    {
      Cells& cells = parent == "Polys" ? piece.polygons : piece.strips;
      array = tag["Name"] == "connectivity" ? &cells.vertices : tag["Name"] == "offsets" ? &cells.ends : nullptr;
    }
    if(array == nullptr)
      return;
    if(array->tag != nullptr)
      m_file->fail_at_line(tag.begin, "there is such an array already");
    array->tag = tag.begin;
    array->name = tag["Name"].empty() ? parent : tag["Name"];
    array->format = tag["format"].empty() ? "ascii" : tag["format"];
    array->type = type_of(tag);
    array->offset = integer(tag, "offset");
    array->number_of_components = integer(tag, "NumberOfComponents", 1);
    array->begin = array->end = tag.end;
    m_end_of_array = tag.is_empty ? nullptr : &array->end;
  }

  Number_type type_of(const Xml_tag& tag) const
  {
    static constexpr std::string_view names[] = { "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64",
                                                  "UInt64", "Float32", "Float64" };
    const auto* const found = std::find(std::begin(names), std::end(names), tag["type"]);
    if(found == std::end(names))
      m_file->fail_at_line(tag.begin, "the type of this array is not known");
    return static_cast<Number_type>(found - names);
  }

  void read_piece(Vtk_xml_decoder& decoder, const Piece& piece)
  {
    const std::size_t first = m_soup.points.size();
    if(piece.points.tag != nullptr)
      read_points(decoder, piece);
    check_number(piece, piece.number_of_points, m_soup.points.size() - first, "points");
    const std::size_t first_polygon = m_soup.ends.size();
    read_cells(decoder, piece, piece.polygons, first, [&](const auto begin, const auto end)
    {
      m_soup.corners.insert(m_soup.corners.end(), begin, end);
      m_soup.end_polygon();
    });
    check_number(piece, piece.number_of_polygons, m_soup.ends.size() - first_polygon, "polygons");
    std::size_t number_of_strips = 0;
    read_cells(decoder, piece, piece.strips, first, [&](const auto begin, const auto end)
    {
      add_strip(begin, end);
      ++number_of_strips;
    });
    check_number(piece, piece.number_of_strips, number_of_strips, "triangle strips");
  }

  void check_number(const Piece& piece, const long long announced, const std::size_t number, const char* const elements)
  {
    if(announced < 0 || static_cast<unsigned long long>(announced) != number)
      m_file->fail_at_line(piece.tag, std::to_string(announced) + " " + elements + " are announced, and there are "
                                      + std::to_string(number));
  }

  void read_points(Vtk_xml_decoder& decoder, const Piece& piece)
  {
    const std::vector<double> coordinates = decoder.reals(piece.points);
    if(piece.points.number_of_components != 3 || coordinates.size() % 3 != 0)
      m_file->fail_at_line(piece.points.tag, "the points do not have three coordinates each");
    for(std::size_t k = 0; k < coordinates.size(); k += 3)
      m_soup.points.push_back({ coordinates[k], coordinates[k + 1], coordinates[k + 2] });
  }

  // Calls `add(begin, end)` for the vertices of each cell, which is not empty.
  template <typename Add>
  void read_cells(Vtk_xml_decoder& decoder, const Piece& piece, const Cells& cells, const std::size_t first,
                  const Add& add)
  {
    if(cells.vertices.tag == nullptr && cells.ends.tag == nullptr)
      return;
    if(cells.vertices.tag == nullptr || cells.ends.tag == nullptr)
      m_file->fail_at_line(piece.tag, "cells do not have both arrays 'connectivity' and 'offsets'");
    const std::vector<long long> ends = decoder.integers(cells.ends);
    std::vector<std::size_t> vertices;
    for(const long long vertex : decoder.integers(cells.vertices))
    {
      if(vertex < 0 || static_cast<unsigned long long>(vertex) >= m_soup.points.size() - first)
        m_file->fail_at_line(cells.vertices.tag, "there is no vertex " + std::to_string(vertex) + " in this piece");
      vertices.push_back(first + static_cast<std::size_t>(vertex));
    }
    long long start = 0;
    for(const long long end : ends)
    {
      if(end <= start || end > static_cast<long long>(vertices.size()))
        m_file->fail_at_line(cells.ends.tag, "a cell that ends at " + std::to_string(end) + " is empty or too long");
      add(vertices.begin() + start, vertices.begin() + end);
      start = end;
    }
    if(start != static_cast<long long>(vertices.size()))
      m_file->fail_at_line(cells.vertices.tag, "there are vertices after the last cell");
  }

  template <typename Iterator>
  void add_strip(const Iterator begin, const Iterator end)
  {
    for(Iterator it = begin; end - it >= 3; ++it)
    {
      const bool is_reversed = (it - begin) % 2 != 0;
      m_soup.corners.insert(m_soup.corners.end(), { it[is_reversed ? 1 : 0], it[is_reversed ? 0 : 1], it[2] });
      m_soup.end_polygon();
    }
  }

  const File_content* m_file;
  Vtk_xml_encoding m_encoding;
  std::vector<Piece> m_pieces;
  const char** m_end_of_array = nullptr; // of the array that the last tag started
  Raw_soup m_soup;
};

inline Raw_soup read_vtp(const File_content& file) { return Vtp_reader(file).read(); }

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_READ_VTP_H
