#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_BYTE_CURSOR_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_BYTE_CURSOR_H

#include "File_content.h"
#include "Raw_soup.h"

#include <boost/predef/other/endian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>

enum Byte_order { LITTLE_ENDIAN_BYTES, BIG_ENDIAN_BYTES };

// Goes through the binary part of a file.
class Byte_cursor
{
public:
  Byte_cursor(const File_content& file, const char* const begin, const Byte_order order)
    : m_file(&file), m_at(begin), m_end(file.end()),
      m_is_swapped((order == BIG_ENDIAN_BYTES) != static_cast<bool>(BOOST_ENDIAN_BIG_BYTE))
  {}

  const char* position() const { return m_at; }
  std::size_t rest() const { return static_cast<std::size_t>(m_end - m_at); }

  void skip(const std::size_t size)
  {
    check_rest(size);
    m_at += size;
  }

  template <typename Number>
  Number read()
  {
    check_rest(sizeof(Number));
    char bytes[sizeof(Number)];
    std::memcpy(bytes, m_at, sizeof(Number));
    if(m_is_swapped)
      std::reverse(bytes, bytes + sizeof(Number));
    m_at += sizeof(Number);
    Number number;
    std::memcpy(&number, bytes, sizeof(Number));
    return number;
  }

  // A point of the element with a number.
  template <typename Number>
  Coordinates read_point(const char* const element, const std::size_t number)
  {
    const char* const start = m_at;
    Coordinates point;
    for(double& coordinate : point)
      coordinate = static_cast<double>(read<Number>());
    check_point(point, start, element, number);
    return point;
  }

  void check_point(const Coordinates& point, const char* const start, const char* const element,
                   const std::size_t number) const
  {
    for(const double coordinate : point)
      if(!std::isfinite(coordinate))
        m_file->fail_at_byte(start, std::string(element) + " " + std::to_string(number)
                                    + " (counted from 0) has a coordinate that is not finite");
  }

  std::size_t checked_index(const long long index, const std::size_t number_of_vertices) const
  {
    if(index < 0 || static_cast<unsigned long long>(index) >= number_of_vertices)
      fail("there is no vertex " + std::to_string(index) + " before this byte, the vertices are numbered from 0 to "
           + std::to_string(number_of_vertices) + " - 1");
    return static_cast<std::size_t>(index);
  }

  // The number of elements of which each takes so many bytes or more.
  std::size_t checked_count(const long long count, const std::size_t size, const char* const elements) const
  {
    if(count < 0 || static_cast<unsigned long long>(count) > rest() / size)
      fail(std::to_string(count) + " " + elements + " are announced, for which the rest of the file, "
           + std::to_string(rest()) + " bytes, is too short");
    return static_cast<std::size_t>(count);
  }

  [[noreturn]] void fail(const std::string& reason) const { m_file->fail_at_byte(m_at, reason); }

private:
  void check_rest(const std::size_t size) const
  {
    if(rest() < size)
      fail("the file ends in an element");
  }

  const File_content* m_file;
  const char* m_at;
  const char* m_end;
  bool m_is_swapped;
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_BYTE_CURSOR_H
