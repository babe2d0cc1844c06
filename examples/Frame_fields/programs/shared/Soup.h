#ifndef FRAME_FIELDS_PROGRAMS_SOUP_H
#define FRAME_FIELDS_PROGRAMS_SOUP_H

#include "Failure.h"
#include "Mesh.h"
#include "file_extension.h"
#include "input_file.h"
#include "known_extensions.h"
#include "ply_stream.h"

#include <CGAL/IO/GOCAD.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#ifdef CGAL_USE_VTK
#include <CGAL/IO/VTK.h>
#endif

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// What a file holds: points and polygons of point indices.
struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
};

// Tells whether CGAL read it all; otherwise `in` stands where it stopped, but for VTP files.
inline bool read_by_extension(const std::string& path, std::istream& in, Soup& soup)
{
  const auto np = CGAL::parameters::verbose(false);
  const std::string extension = lower_case_extension(path);
  if(extension == ".off")
    return CGAL::IO::read_OFF(in, soup.points, soup.polygons, np);
  if(extension == ".obj")
    return CGAL::IO::read_OBJ(in, soup.points, soup.polygons, np);
  if(extension == ".ply")
    return CGAL::IO::read_PLY(in, soup.points, soup.polygons, np);
  if(extension == ".stl")
    return CGAL::IO::read_STL(in, soup.points, soup.polygons, np);
  if(extension == ".ts")
    return CGAL::IO::read_GOCAD(in, soup.points, soup.polygons, np);
#ifdef CGAL_USE_VTK
  if(extension == ".vtp")
    return CGAL::IO::read_VTP(path, soup.points, soup.polygons);
#endif
  throw Failure(BAD_FILE, path + ": the kind of file is unknown; its name must end with one of " + known_extensions);
}

// Tells the place where reading stopped as far as it has a meaning to the user: a line of printable text.
inline std::string description_of_stop(const std::string& path, std::istream& in)
{
  in.clear();
  const bool is_read_by_words = lower_case_extension(path) == ".ply"; // and not by lines, which end before the position
  Line line = line_before(path, in.tellg() + std::streamoff(is_read_by_words ? 1 : 0));
  line.text.erase(std::find(line.text.begin(), line.text.end(), '\r'), line.text.end());
  const bool is_text = std::all_of(line.text.begin(), line.text.end(),
                                   [](const unsigned char c) { return std::isprint(c) || c == '\t'; });
  if(line.number == 0 || line.text.empty() || line.text.size() > 80 || !is_text)
    return ": CGAL cannot read it; it may be damaged or of another kind than its name says";
  return ": CGAL stops reading in line " + std::to_string(line.number) + ", '" + line.text
         + "'; check that line and whether anything is missing after it";
}

inline void check_indices(const std::string& path, const Soup& soup)
{
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
    for(const std::size_t vertex : soup.polygons[i])
      if(vertex >= soup.points.size())
        throw Failure(BAD_FILE, path + ": face " + std::to_string(i) + " (counted from 0) has a vertex that is not"
                                + " among the " + std::to_string(soup.points.size()) + " of the file");
}

inline void read_or_fail(const std::string& path, std::istream& in, Soup& soup)
{
  bool is_read = false;
  try
  {
    is_read = read_by_extension(path, in, soup);
  }
  catch(const std::length_error&) {} // a count in the file is out of all proportion
  catch(const std::logic_error&) {}  // an assertion of CGAL
  if(is_read)
    return;
  if(in.eof())
    check_indices(path, soup); // the reader of OBJ files tells a wrong index at the end of the file
  throw Failure(BAD_FILE, path + description_of_stop(path, in));
}

inline void check_coordinates(const std::string& path, const std::vector<Point>& points)
{
  for(std::size_t i = 0; i < points.size(); ++i)
    if(!std::isfinite(points[i].x()) || !std::isfinite(points[i].y()) || !std::isfinite(points[i].z()))
      throw Failure(BAD_FILE, path + ": vertex " + std::to_string(i)
                              + " (counted from 0) has a coordinate that is not finite");
}

inline Soup read_soup(const std::string& path)
{
  std::ifstream file = open_input(path);
  if(file.peek() == std::ifstream::traits_type::eof())
    throw Failure(BAD_FILE, path + ": the file is empty");

  Soup soup;
  if(lower_case_extension(path) == ".ply")
  {
    std::stringstream ply = ply_stream_without_halfedges(path, file);
    read_or_fail(path, ply, soup);
  }
  else
    read_or_fail(path, file, soup);
  check_coordinates(path, soup.points);
  check_indices(path, soup);
  if(soup.polygons.empty())
    throw Failure(BAD_FILE, path + ": there are no faces in it");
  return soup;
}

#endif // FRAME_FIELDS_PROGRAMS_SOUP_H
