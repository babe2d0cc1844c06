#ifndef FRAME_FIELDS_PROGRAMS_FEATURE_FORMATS_H
#define FRAME_FIELDS_PROGRAMS_FEATURE_FORMATS_H

#include "file_extension.h"

#include <string>

// Formats of feature edges.
enum Feature_format
{
  VERTEX_PAIRS,    // two vertices a line
  SHARP,           // QuadWild: how many; then whether it is convex, a face and the number of an edge of it a line
  FACE_EDGE_PAIRS, // QuadWild's .feature: the same without the convexity
  ABC_CURVES       // the data set ABC: YAML with lists of vertices, which is not written
};

inline Feature_format feature_format_of(const std::string& path)
{
  const std::string extension = lower_case_extension(path);
  if(extension == ".yml" || extension == ".yaml")
    return ABC_CURVES;
  return extension == ".sharp" ? SHARP : extension == ".feature" ? FACE_EDGE_PAIRS : VERTEX_PAIRS;
}

#endif // FRAME_FIELDS_PROGRAMS_FEATURE_FORMATS_H
