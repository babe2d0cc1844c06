#ifndef FRAME_FIELDS_PROGRAMS_PLY_STREAM_H
#define FRAME_FIELDS_PROGRAMS_PLY_STREAM_H

#include "Failure.h"

#include <istream>
#include <set>
#include <sstream>
#include <string>

// CGAL's reader of PLY soups takes for granted that vertices have floating-point coordinates and halfedges unsigned
// ends; it crashes on others, even on the files that CGAL writes for a Surface_mesh with halfedge properties.

inline void check_coordinate_type(const std::string& path, const std::string& property_line)
{
  std::istringstream words(property_line);
  std::string keyword, type, name;
  words >> keyword >> type;
  while(words >> name) {}
  const bool is_coordinate = (name == "x" || name == "y" || name == "z");
  if(is_coordinate && !std::set<std::string>{ "float", "float32", "double", "float64" }.count(type))
    throw Failure(BAD_FILE, path + ": the coordinate " + name + " has type " + type + "; it must be float or double");
}

inline std::string as_comment_of_same_length(const std::string& line)
{
  std::string comment = "comment";
  comment.resize(line.size(), ' ');
  return comment;
}

// The content of a PLY file whose header hides what starts with the first halfedge element. No position changes.
inline std::stringstream ply_stream_without_halfedges(const std::string& path, std::istream& in)
{
  std::stringstream result;
  std::string line, keyword, element;
  bool is_hidden = false;
  while(keyword != "end_header" && std::getline(in, line))
  {
    std::istringstream words(line);
    words >> keyword;
    if(keyword == "element")
      words >> element;
    if(keyword == "property" && element == "vertex")
      check_coordinate_type(path, line);
    is_hidden = is_hidden || element == "halfedge";
    result << (is_hidden && keyword != "end_header" ? as_comment_of_same_length(line) : line) << "\n";
  }
  if(keyword != "end_header")
    throw Failure(BAD_FILE, path + ": this is no PLY file, its header has no end");
  if(in.peek() != std::istream::traits_type::eof()) // inserting nothing would be a failure
    result << in.rdbuf();
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_PLY_STREAM_H
