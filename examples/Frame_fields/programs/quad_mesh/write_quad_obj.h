#ifndef FRAME_FIELDS_PROGRAMS_WRITE_QUAD_OBJ_H
#define FRAME_FIELDS_PROGRAMS_WRITE_QUAD_OBJ_H

#include "Quads.h"

#include "../shared/Mesh.h"

#include <ostream>

// Writes points and faces, and on demand the feature edges as lines.
inline void write_quad_obj(std::ostream& out, const Quads& quads, const bool writes_feature_lines)
{
  const Mesh& mesh = quads.mesh;
  out.precision(17);
  for(const Vertex v : mesh.vertices())
    out << "v " << mesh.point(v) << "\n";
  for(const Face f : mesh.faces())
  {
    out << "f";
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << " " << v.idx() + 1;
    out << "\n";
  }
  if(writes_feature_lines)
    for(const Edge e : mesh.edges())
      if(quads.is_feature[e])
        out << "l " << mesh.vertex(e, 0).idx() + 1 << " " << mesh.vertex(e, 1).idx() + 1 << "\n";
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_QUAD_OBJ_H
