#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_NUMBER_TYPE_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_NUMBER_TYPE_H

#include "Byte_cursor.h"

#include <cstddef>
#include <cstdint>
#include <limits>

// The types that numbers of binary files have.
enum class Number_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, INT64, UINT64, FLOAT32, FLOAT64 };

inline std::size_t size_of(const Number_type type)
{
  switch(type)
  {
    case Number_type::INT8: case Number_type::UINT8: return 1;
    case Number_type::INT16: case Number_type::UINT16: return 2;
    case Number_type::INT32: case Number_type::UINT32: case Number_type::FLOAT32: return 4;
    default: return 8;
  }
}

inline bool is_integer_type(const Number_type type)
{
  return type != Number_type::FLOAT32 && type != Number_type::FLOAT64;
}

inline long long read_unsigned(Byte_cursor& cursor)
{
  const std::uint64_t value = cursor.read<std::uint64_t>();
  if(value > static_cast<std::uint64_t>((std::numeric_limits<long long>::max)()))
    cursor.fail("the number before this byte is out of all proportion");
  return static_cast<long long>(value);
}

inline long long read_integer(Byte_cursor& cursor, const Number_type type)
{
  switch(type)
  {
    case Number_type::INT8: return cursor.read<std::int8_t>();
    case Number_type::UINT8: return cursor.read<std::uint8_t>();
    case Number_type::INT16: return cursor.read<std::int16_t>();
    case Number_type::UINT16: return cursor.read<std::uint16_t>();
    case Number_type::INT32: return cursor.read<std::int32_t>();
    case Number_type::UINT32: return cursor.read<std::uint32_t>();
    case Number_type::INT64: return cursor.read<std::int64_t>();
    default: return read_unsigned(cursor);
  }
}

inline double read_real(Byte_cursor& cursor, const Number_type type)
{
  switch(type)
  {
    case Number_type::FLOAT32: return cursor.read<float>();
    case Number_type::FLOAT64: return cursor.read<double>();
    default: return static_cast<double>(read_integer(cursor, type));
  }
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_NUMBER_TYPE_H
