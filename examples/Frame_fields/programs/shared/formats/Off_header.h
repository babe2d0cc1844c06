#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_OFF_HEADER_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_OFF_HEADER_H

#include "File_content.h"
#include "Text_cursor.h"
#include "lower_case.h"

#include <cstddef>
#include <string>
#include <string_view>

// The first word of an OFF file, [ST][C][N][4][n]OFF, and the counts.
struct Off_header
{
  bool has_texture = false, has_colors = false, has_normals = false, is_homogeneous = false, has_dimension = false,
       is_binary = false;
  const char* begin_of_binary = nullptr;
  std::size_t number_of_vertices = 0, number_of_faces = 0;

  bool announces_attributes() const { return has_texture || has_colors || has_normals; }

  // The numbers after the coordinates, for a length of colours.
  std::size_t number_of_attributes(const std::size_t length_of_color = 4) const
  {
    return (has_normals ? 3 : 0) + (has_colors ? length_of_color : 0) + (has_texture ? 2 : 0);
  }

  bool can_follow_point(const std::size_t number) const
  {
    if(!announces_attributes())
      return true; // to be left out
    for(const std::size_t length_of_color : { 0, 1, 3, 4 })
      if(number == number_of_attributes(length_of_color))
        return true;
    return false;
  }
};

// Takes the letters from the front of a word. Whoever writes the keyword in small letters means no dimension by an n.
inline Off_header read_off_prefixes(std::string_view& word)
{
  Off_header header;
  const bool is_small = word.find("off") != std::string_view::npos;
  const auto take = [&](const char* const prefix)
  {
    const std::string small = lower_case(prefix);
    const bool is_there = starts_with(word, prefix) || (is_small && starts_with(word, small));
    if(is_there)
      word.remove_prefix(small.size());
    return is_there;
  };
  header.has_texture = take("ST");
  header.has_colors = take("C");
  header.has_normals = take("N");
  header.is_homogeneous = take("4");
  header.has_dimension = take("n");
  return header;
}

// Leaves the cursor at the number of vertices. The first word may be missing, or have the number without a blank.
inline Off_header read_off_header(const File_content& file, Text_cursor& cursor)
{
  Text_cursor at_word = cursor;
  if(!cursor.has_word())
    file.fail("byte 0: the file is empty");
  std::string_view rest = cursor.word();
  long long number;
  if(parse_integer(rest, number) == Number_fault::NONE)
  {
    cursor = at_word;
    return Off_header();
  }

  Off_header header = read_off_prefixes(rest);
  if(lower_case(rest.substr(0, 3)) != "off")
    cursor.fail("this is no OFF file, which starts with 'OFF'");
  rest.remove_prefix(3);
  if(!rest.empty())
  {
    if(parse_integer(rest, number) != Number_fault::NONE)
      cursor.fail("this is no OFF file, which starts with 'OFF'");
    cursor = Text_cursor(file, rest.data(), Text_cursor::COMMENTS);
  }
  Text_cursor copy = cursor;
  if(rest.empty() && copy.has_word_in_line() && lower_case(copy.word()) == "binary")
  {
    header.is_binary = true;
    copy.skip_line();
    header.begin_of_binary = copy.position();
  }
  else if(header.has_dimension && cursor.integer(cursor.next_word("a dimension"), "a dimension") != 3)
    cursor.fail("the dimension of the points is not 3");
  return header;
}

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_OFF_HEADER_H
