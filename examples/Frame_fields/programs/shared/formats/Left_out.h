#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_LEFT_OUT_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_LEFT_OUT_H

#include "File_content.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Tells whether a line can be left out by its first word. One that starts with a number rather belongs to another.
inline bool may_be_keyword(const std::string_view word)
{
  static constexpr std::string_view starts_of_numbers = "+-.0123456789";
  return starts_of_numbers.find(word[0]) == std::string_view::npos && !in_quotes(word).empty();
}

// Counts what a reader leaves out, by kind, for one warning.
class Left_out
{
public:
  explicit Left_out(const char* const elements) : m_elements(elements) {}

  void add(const std::string_view kind, const std::size_t number = 1)
  {
    m_total += number;
    for(Kind& other : m_kinds)
      if(other.name == kind)
      {
        other.number += number;
        return;
      }
    if(m_kinds.size() < maximum_number_of_kinds)
      m_kinds.push_back({ std::string(kind), number });
  }

  // Appends a warning if anything is left out.
  void warn(std::vector<std::string>& warnings) const
  {
    if(m_total == 0)
      return;
    std::string warning = std::string(m_elements) + " left out: ";
    std::size_t rest = m_total;
    const char* separator = "";
    for(const Kind& kind : m_kinds)
    {
      warning += separator + std::to_string(kind.number) + " of kind " + in_quotes(kind.name);
      separator = ", ";
      rest -= kind.number;
    }
    if(rest > 0)
      warning += separator + std::to_string(rest) + " of other kinds";
    warnings.push_back(warning);
  }

private:
  static constexpr std::size_t maximum_number_of_kinds = 8;

  struct Kind
  {
    std::string name;
    std::size_t number;
  };

  const char* m_elements;
  std::vector<Kind> m_kinds; // the first ones
  std::size_t m_total = 0;
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_LEFT_OUT_H
