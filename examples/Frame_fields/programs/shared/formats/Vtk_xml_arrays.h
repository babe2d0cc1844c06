#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_VTK_XML_ARRAYS_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_VTK_XML_ARRAYS_H

#include "Byte_cursor.h"
#include "Encoded_bytes.h"
#include "File_content.h"
#include "Number_type.h"
#include "Text_cursor.h"
#include "Xml_tags.h"

#ifdef FRAME_FIELDS_WITH_ZLIB
#include <zlib.h>
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// What the attributes of the whole file say of its arrays, and where their data are.
struct Vtk_xml_encoding
{
  Byte_order byte_order = LITTLE_ENDIAN_BYTES;
  bool has_long_headers = false; // of eight bytes and not of four
  std::string compressor;
  bool are_appended_in_base64 = false;
  const char* begin_of_appended = nullptr;
};

struct Vtk_xml_array
{
  const char* tag = nullptr; // where it starts, or nothing
  std::string name, format;
  Number_type type = Number_type::INT32;
  long long offset = 0, number_of_components = 1;
  const char* begin = nullptr; // of the text in it
  const char* end = nullptr;
};

// Decodes arrays: text, bytes as such or in base64, and each compressed by zlib or not.
class Vtk_xml_decoder
{
public:
  Vtk_xml_decoder(const File_content& file, const Vtk_xml_encoding& encoding)
    : m_file(&file), m_encoding(encoding), m_rest(file.bytes.size())
  {}

  std::vector<double> reals(const Vtk_xml_array& array)
  {
    return values<double>(
      array,
      [&](Text_cursor& cursor) { return cursor.real(cursor.word()); },
      [&](Byte_cursor& cursor)
      {
        const double value = read_real(cursor, array.type);
        if(!std::isfinite(value))
          cursor.fail("the number before this byte is not finite");
        return value;
      });
  }

  std::vector<long long> integers(const Vtk_xml_array& array)
  {
    if(!is_integer_type(array.type))
      m_file->fail_at_line(array.tag, "this array has integers as numbers of another type");
    return values<long long>(
      array,
      [&](Text_cursor& cursor) { return cursor.integer(cursor.word(), "an integer"); },
      [&](Byte_cursor& cursor) { return read_integer(cursor, array.type); });
  }

private:
  template <typename Value, typename Parse, typename Read>
  std::vector<Value> values(const Vtk_xml_array& array, const Parse& parse, const Read& read)
  {
    std::vector<Value> result;
    if(array.format == "ascii")
    {
      Text_cursor cursor(*m_file, array.begin, array.end, Text_cursor::PLAIN);
      while(cursor.has_word())
        result.push_back(parse(cursor));
      return result;
    }
    const std::string bytes = bytes_of(array);
    const File_content decoded{ m_file->path + ": array '" + array.name + "'", bytes };
    if(bytes.size() % size_of(array.type) != 0)
      decoded.fail("its size, " + std::to_string(bytes.size()) + " bytes, is not that of whole numbers");
    result.reserve(bytes.size() / size_of(array.type));
    Byte_cursor cursor(decoded, decoded.begin(), m_encoding.byte_order);
    while(cursor.rest() > 0)
      result.push_back(read(cursor));
    return result;
  }

  Encoded_bytes source_of(const Vtk_xml_array& array) const
  {
    if(array.format == "binary")
      return { *m_file, array.begin, array.end, true };
    if(array.format != "appended")
      m_file->fail_at_line(array.tag, "this array is neither ascii nor binary nor appended");
    if(m_encoding.begin_of_appended == nullptr)
      m_file->fail_at_line(array.tag, "the file ends without the data that are appended");
    if(array.offset < 0 || array.offset > m_file->end() - m_encoding.begin_of_appended)
      m_file->fail_at_line(array.tag, "the offset of this array is not in the file");
    return { *m_file, m_encoding.begin_of_appended + array.offset, m_file->end(), m_encoding.are_appended_in_base64 };
  }

  // No byte of the file belongs to two arrays, so that many of them cannot mean more data than there are.
  std::string bytes_of(const Vtk_xml_array& array)
  {
    Encoded_bytes source = source_of(array);
    const char* const begin = source.position();
    const std::string result = m_encoding.compressor.empty() ? source.take(header_number(source))
                                                             : uncompressed_bytes(source, array);
    const std::size_t size = static_cast<std::size_t>(source.position() - begin);
    if(size > m_rest)
      m_file->fail_at_line(array.tag, "the data of this array are those of another one, too");
    m_rest -= size;
    return result;
  }

  std::uint64_t header_number(Encoded_bytes& source) const
  {
    const std::string bytes = source.take(m_encoding.has_long_headers ? 8 : 4);
    const File_content decoded{ m_file->path, bytes };
    Byte_cursor cursor(decoded, decoded.begin(), m_encoding.byte_order);
    return m_encoding.has_long_headers ? cursor.read<std::uint64_t>() : cursor.read<std::uint32_t>();
  }

  // The header has the number of blocks, their size, that of the last one if it is smaller, and the compressed sizes.
  std::string uncompressed_bytes(Encoded_bytes& source, const Vtk_xml_array& array) const
  {
#ifdef FRAME_FIELDS_WITH_ZLIB
    const bool is_readable = m_encoding.compressor == "vtkZLibDataCompressor";
#else
    const bool is_readable = false;
#endif
    if(!is_readable)
      m_file->fail_at_line(array.tag, "arrays are compressed by " + Text_cursor::name_of(m_encoding.compressor)
                                      + ", which this program does not read; write the file without compression");
    const std::uint64_t number = header_number(source), size = header_number(source), last = header_number(source);
    std::vector<std::uint64_t> compressed_sizes;
    for(std::uint64_t k = 0; k < number; ++k)
      compressed_sizes.push_back(header_number(source));
    std::string result;
    for(std::uint64_t k = 0; k < number; ++k)
      result += uncompressed_block(source, compressed_sizes[k], k + 1 == number && last > 0 ? last : size);
    return result;
  }

  std::string uncompressed_block(Encoded_bytes& source, const std::uint64_t compressed_size,
                                 const std::uint64_t size) const
  {
    const char* const place = source.position();
    const std::string compressed = source.take(compressed_size);
    if(size / 1032 > compressed_size + 1) // the most that zlib can do
      m_file->fail_at_byte(place, "the size of a compressed block is out of all proportion");
    std::string result(size, '\0');
#ifdef FRAME_FIELDS_WITH_ZLIB
    uLongf actual_size = size;
    const int status = uncompress(reinterpret_cast<Bytef*>(&result[0]), &actual_size,
                                  reinterpret_cast<const Bytef*>(compressed.data()), compressed.size());
    if(status != Z_OK || actual_size != size)
      m_file->fail_at_byte(place, "a compressed block is damaged");
#endif
    return result;
  }

  const File_content* m_file;
  Vtk_xml_encoding m_encoding;
  std::size_t m_rest; // bytes of the file that no array had yet
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_VTK_XML_ARRAYS_H
