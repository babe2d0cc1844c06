#ifndef FRAME_FIELDS_PROGRAMS_IRREGULAR_VERTICES_H
#define FRAME_FIELDS_PROGRAMS_IRREGULAR_VERTICES_H

#include "Feature_curves.h"

#include "../shared/Mesh.h"
#include "../shared/sectors.h"

#include <algorithm>
#include <cmath>
#include <vector>

// A vertex on no feature edge without four quadrangles, or a sector between feature edges that has another number than
// its angle asks for.
struct Irregular_vertex
{
  Vertex vertex;
  int valence; // the number of quadrangles, of the sector on a feature
  bool is_on_feature;
};

inline std::vector<Irregular_vertex> irregular_vertices(const Mesh& mesh, const Feature_map is_feature)
{
  std::vector<Irregular_vertex> result;
  for(const Sector& sector : sectors(mesh, is_feature))
  {
    const int valence = number_of_faces_of(mesh, is_feature, sector);
    const int natural = sector.is_constrained
      ? (std::max)(1, static_cast<int>(std::lround(angle_in_degrees(mesh, is_feature, sector.halfedge) / 90))) : 4;
    if(valence != natural)
      result.push_back({ mesh.target(sector.halfedge), valence, sector.is_constrained });
  }
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_IRREGULAR_VERTICES_H
