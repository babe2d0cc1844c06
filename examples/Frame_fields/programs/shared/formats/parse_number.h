#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_PARSE_NUMBER_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_PARSE_NUMBER_H

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

// The words of a file as numbers. A word that is more or less than one number is none.
enum class Number_fault { NONE, NO_NUMBER, NOT_FINITE };

// std::from_chars() takes no plus sign.
inline std::string_view without_plus(const std::string_view word)
{
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
  return word.substr(has_plus ? 1 : 0);
}

// Slower, but it tells numbers that are too small, which count as 0, from those that are too large.
inline Number_fault parse_real_by_strtod(const std::string_view word, double& value)
{
  const std::string copy(word);
  char* end;
  value = std::strtod(copy.c_str(), &end);
  const bool is_hexadecimal = copy.find_first_of("xX") != std::string::npos;
  if(copy.empty() || end != copy.c_str() + copy.size() || is_hexadecimal)
    return Number_fault::NO_NUMBER;
  return std::isfinite(value) ? Number_fault::NONE : Number_fault::NOT_FINITE;
}

inline Number_fault parse_real(const std::string_view signed_word, double& value)
{
  const std::string_view word = without_plus(signed_word);
#if defined(__cpp_lib_to_chars)
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if(error == std::errc::invalid_argument || end != word.data() + word.size())
    return Number_fault::NO_NUMBER;
  if(error == std::errc())
    return std::isfinite(value) ? Number_fault::NONE : Number_fault::NOT_FINITE;
#endif
  return parse_real_by_strtod(word, value);
}

inline Number_fault parse_integer(const std::string_view signed_word, long long& value)
{
  const std::string_view word = without_plus(signed_word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_integer = error == std::errc() && end == word.data() + word.size();
  return is_integer ? Number_fault::NONE : Number_fault::NO_NUMBER;
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_PARSE_NUMBER_H
