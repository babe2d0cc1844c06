#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_LOWER_CASE_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_LOWER_CASE_H

#include <string>
#include <string_view>

// In the letters of keywords, whatever the locale is.
inline std::string lower_case(const std::string_view word)
{
  std::string result(word);
  for(char& c : result)
    if(c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_LOWER_CASE_H
