#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_POINT_NUMBERS_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_POINT_NUMBERS_H

#include "Raw_soup.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

// Numbers distinct points as they come, and collects them. A hash table with open addressing, at most half full.
class Point_numbers
{
public:
  explicit Point_numbers(std::vector<Coordinates>& points) : m_points(&points), m_table(1024, EMPTY) {}

  std::size_t operator()(const Coordinates& point)
  {
    const std::size_t slot = slot_of(point);
    if(m_table[slot] != EMPTY)
      return m_table[slot];
    const std::size_t number = m_points->size();
    m_table[slot] = number;
    m_points->push_back(point);
    if(2 * m_points->size() > m_table.size())
      grow();
    return number;
  }

private:
  static constexpr std::size_t EMPTY = (std::numeric_limits<std::size_t>::max)();

  // The slot that holds the number of an equal point, or the empty one where it belongs.
  std::size_t slot_of(const Coordinates& point) const
  {
    const std::size_t mask = m_table.size() - 1;
    std::size_t slot = static_cast<std::size_t>(hash(point)) & mask;
    while(m_table[slot] != EMPTY && (*m_points)[m_table[slot]] != point)
      slot = (slot + 1) & mask;
    return slot;
  }

  void grow()
  {
    m_table.assign(2 * m_table.size(), EMPTY);
    for(std::size_t k = 0; k < m_points->size(); ++k)
      m_table[slot_of((*m_points)[k])] = k;
  }

  static std::uint64_t hash(const Coordinates& point)
  {
    std::uint64_t result = 0;
    for(const double coordinate : point)
    {
      const double value = coordinate + 0.; // -0 equals 0
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      result = (result ^ bits) * 0x9E3779B97F4A7C15u;
      result ^= result >> 32;
    }
    result *= 0xD6E8FEB86659FD93u;
    return result ^ (result >> 32);
  }

  std::vector<Coordinates>* m_points;
  std::vector<std::size_t> m_table;
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_POINT_NUMBERS_H
