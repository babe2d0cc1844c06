#ifndef FRAME_FIELDS_PROGRAMS_TRIANGLE_H
#define FRAME_FIELDS_PROGRAMS_TRIANGLE_H

#include <array>
#include <cstddef>

// Vertices of a file, counter-clockwise.
typedef std::array<std::size_t, 3> Triangle;

// Sides of triangles have numbers: side 3 t + k of triangle t joins its corner k, which has the same number, to the
// next one.
constexpr std::size_t NO_SIDE = static_cast<std::size_t>(-1);

inline std::size_t next_side(const std::size_t side)
{
  return side % 3 == 2 ? side - 2 : side + 1;
}

inline std::size_t previous_side(const std::size_t side)
{
  return side % 3 == 0 ? side + 2 : side - 1;
}

#endif // FRAME_FIELDS_PROGRAMS_TRIANGLE_H
