#ifndef FRAME_FIELDS_PROGRAMS_DISJOINT_SETS_H
#define FRAME_FIELDS_PROGRAMS_DISJOINT_SETS_H

#include <cstddef>
#include <numeric>
#include <vector>

// Sets of numbers that can be united; each is named by its least element.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(const std::size_t size) : m_parents(size)
  {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  std::size_t find(std::size_t i)
  {
    while(m_parents[i] != i)
    {
      m_parents[i] = m_parents[m_parents[i]];
      i = m_parents[i];
    }
    return i;
  }

  void unite(std::size_t i, std::size_t j)
  {
    i = find(i);
    j = find(j);
    if(i < j)
      m_parents[j] = i;
    else
      m_parents[i] = j;
  }

private:
  std::vector<std::size_t> m_parents;
};

#endif // FRAME_FIELDS_PROGRAMS_DISJOINT_SETS_H
