#ifndef FRAME_FIELDS_PROGRAMS_WRITE_QUAD_PLY_H
#define FRAME_FIELDS_PROGRAMS_WRITE_QUAD_PLY_H

#include "Quads.h"

#include "../shared/Mesh.h"

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <ostream>

// Writes the mesh with the patches of faces and whether vertices are on features, which is added to the mesh.
inline void write_quad_ply(std::ostream& out, Quads& quads, const bool writes_ascii)
{
  Mesh& mesh = quads.mesh;
  const auto feature = mesh.add_property_map<Vertex, int>("v:feature", 0).first;
  for(const Edge e : mesh.edges())
    if(quads.is_feature[e])
      for(const int end : { 0, 1 })
        feature[mesh.vertex(e, end)] = 1;
  CGAL::IO::set_mode(out, writes_ascii ? CGAL::IO::ASCII : CGAL::IO::BINARY);
  CGAL::IO::write_PLY(out, mesh, "feature is 1 at vertices on feature edges", CGAL::parameters::stream_precision(17));
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_QUAD_PLY_H
