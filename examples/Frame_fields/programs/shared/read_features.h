#ifndef FRAME_FIELDS_PROGRAMS_READ_FEATURES_H
#define FRAME_FIELDS_PROGRAMS_READ_FEATURES_H

#include "Failure.h"
#include "Soup.h"
#include "feature_formats.h"
#include "input_file.h"
#include "read_curves_of_abc.h"
#include "read_feature_lines.h"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

// The integers of a line, between blanks or commas. Signed, since a stream reads -1 as a large unsigned number without
// complaint.
inline std::vector<long long> integers_of_line(const std::string& path, const std::size_t line_number, std::string text,
                                               const std::size_t number, const char* const expected)
{
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  std::vector<long long> integers(number);
  for(long long& integer : integers)
    words >> integer;
  if(!words || !(words >> std::ws).eof())
    fail_in_line(path, line_number, std::string("a line must hold ") + expected);
  return integers;
}

inline std::vector<Vertex_pair> read_vertex_pairs(const std::string& path)
{
  std::vector<Vertex_pair> pairs;
  for_each_feature_line(path, [&](const std::size_t line_number, const std::string& content)
  {
    const auto vertices = integers_of_line(path, line_number, content, 2, "two vertex indices");
    pairs.push_back({ vertices[0], vertices[1], line_number });
  });
  return pairs;
}

// The vertices of the edge of a face that starts at its vertex of this number.
inline Vertex_pair edge_of_face(const std::string& path, const std::size_t line_number, const Soup& soup,
                                const long long face, const long long edge)
{
  if(face < 0 || face >= static_cast<long long>(soup.polygons.size()))
    fail_in_line(path, line_number, "the model has no face " + std::to_string(face) + ", its last one is "
                                    + std::to_string(soup.polygons.size() - 1));
  const std::vector<std::size_t>& polygon = soup.polygons[face];
  if(edge < 0 || edge >= static_cast<long long>(polygon.size()))
    fail_in_line(path, line_number, "face " + std::to_string(face) + " has no edge " + std::to_string(edge));
  return { static_cast<long long>(polygon[edge]), static_cast<long long>(polygon[(edge + 1) % polygon.size()]),
           line_number };
}

// Reads the formats of QuadWild.
inline std::vector<Vertex_pair> read_edges_of_faces(const std::string& path, const bool has_convexity, const Soup& soup)
{
  std::vector<Vertex_pair> pairs;
  long long number_of_edges = -1;
  std::size_t last_line_number = 0;
  for_each_feature_line(path, [&](const std::size_t line_number, const std::string& content)
  {
    last_line_number = line_number;
    if(number_of_edges < 0)
    {
      number_of_edges = integers_of_line(path, line_number, content, 1, "the number of edges").front();
      return;
    }
    const auto numbers = has_convexity
      ? integers_of_line(path, line_number, content, 3, "0 or 1 (concave or convex), a face and the number of its edge")
      : integers_of_line(path, line_number, content, 2, "a face and the number of its edge");
    pairs.push_back(edge_of_face(path, line_number, soup, numbers[numbers.size() - 2], numbers.back()));
  });
  if(static_cast<long long>(pairs.size()) != number_of_edges)
    fail_in_line(path, last_line_number, "the first line announces " + std::to_string((std::max)(number_of_edges, 0LL))
                                         + " edges and there are " + std::to_string(pairs.size()));
  return pairs;
}

inline std::vector<Vertex_pair> read_features(const std::string& path, const Soup& soup)
{
  const Feature_format format = feature_format_of(path);
  switch(format)
  {
    case VERTEX_PAIRS: return read_vertex_pairs(path);
    case ABC_CURVES:   return read_curves_of_abc(path);
    default:           return read_edges_of_faces(path, format == SHARP, soup);
  }
}

#endif // FRAME_FIELDS_PROGRAMS_READ_FEATURES_H
