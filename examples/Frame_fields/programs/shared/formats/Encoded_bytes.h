#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_ENCODED_BYTES_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_ENCODED_BYTES_H

#include "File_content.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

// Takes bytes from a part of a file, where they stand as they are or in base64. Encoded pieces that follow each other
// are one.
class Encoded_bytes
{
public:
  Encoded_bytes(const File_content& file, const char* const begin, const char* const end, const bool is_base64)
    : m_file(&file), m_at(begin), m_end(end), m_is_base64(is_base64)
  {}

  std::string take(const std::uint64_t size)
  {
    if(size > m_decoded.size() + static_cast<std::size_t>(m_end - m_at)) // even if nothing is encoded
      fail_at_end();
    if(!m_is_base64)
    {
      m_at += size;
      return std::string(m_at - size, m_at);
    }
    std::string result;
    result.swap(m_decoded);
    result.reserve(size + 3);
    while(result.size() < size)
      decode_four(result);
    m_decoded = result.substr(size);
    result.resize(size);
    return result;
  }

  const char* position() const { return m_at; }

private:
  [[noreturn]] void fail_at_end() const { m_file->fail_at_byte(m_at, "the data of an array end before their size"); }

  void decode_four(std::string& result)
  {
    std::uint32_t bits = 0;
    int number_of_fillers = 0;
    for(int k = 0; k < 4; ++k)
    {
      while(m_at != m_end && is_space(*m_at))
        ++m_at;
      if(m_at == m_end)
        fail_at_end();
      static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      const std::size_t digit = digits.find(*m_at);
      const bool is_filler = *m_at == '=' && k >= 2;
      if(digit == std::string_view::npos ? !is_filler : number_of_fillers > 0)
        m_file->fail_at_byte(m_at, "this is no base64");
      number_of_fillers += is_filler;
      bits = bits << 6 | static_cast<std::uint32_t>(is_filler ? 0 : digit);
      ++m_at;
    }
    for(int k = 0; k < 3 - number_of_fillers; ++k)
      result += static_cast<char>(bits >> (16 - 8 * k) & 0xFF);
  }

  const File_content* m_file;
  const char* m_at;
  const char* m_end;
  bool m_is_base64;
  std::string m_decoded; // but not taken yet
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_ENCODED_BYTES_H
