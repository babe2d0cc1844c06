#ifndef FRAME_FIELDS_PROGRAMS_WRITE_FEATURES_H
#define FRAME_FIELDS_PROGRAMS_WRITE_FEATURES_H

#include "Mesh.h"
#include "feature_formats.h"

#include <CGAL/enum.h>

#include <algorithm>
#include <ostream>

inline bool is_concave(const Mesh& mesh, const Halfedge h)
{
  if(mesh.is_border(mesh.edge(h)))
    return false;
  return CGAL::orientation(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                           mesh.point(mesh.target(mesh.next(h))),
                           mesh.point(mesh.target(mesh.next(mesh.opposite(h))))) == CGAL::POSITIVE;
}

// The place of the source of a halfedge among the vertices of its face as files list them.
inline int number_in_face(const Mesh& mesh, const Halfedge h)
{
  int number = 0;
  for(Halfedge g = mesh.next(mesh.halfedge(mesh.face(h))); g != h; g = mesh.next(g))
    ++number;
  return number;
}

inline void write_features(std::ostream& out, const Feature_format format, const Mesh& mesh,
                           const Feature_map is_feature)
{
  if(format != VERTEX_PAIRS)
    out << std::count_if(mesh.edges().begin(), mesh.edges().end(), [&](const Edge e) { return is_feature[e]; }) << "\n";
  for(const Edge e : mesh.edges())
  {
    if(!is_feature[e])
      continue;
    const Halfedge h = mesh.is_border(mesh.halfedge(e)) ? mesh.opposite(mesh.halfedge(e)) : mesh.halfedge(e);
    if(format == VERTEX_PAIRS)
      out << mesh.source(h).idx() << " " << mesh.target(h).idx() << "\n";
    else
      out << (format == FACE_EDGE_PAIRS ? "" : is_concave(mesh, h) ? "0," : "1,") << mesh.face(h).idx() << ","
          << number_in_face(mesh, h) << "\n";
  }
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_FEATURES_H
