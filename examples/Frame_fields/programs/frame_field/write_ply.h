#ifndef FRAME_FIELDS_PROGRAMS_WRITE_PLY_H
#define FRAME_FIELDS_PROGRAMS_WRITE_PLY_H

#include "Field.h"

#include "../shared/Mesh.h"

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <array>
#include <ostream>
#include <string>

inline void add_branch_coordinates(Mesh& mesh, const Field& field)
{
  std::array<std::array<Mesh::Property_map<Face, double>, 3>, 2> branches;
  for(const int branch : { 0, 1 })
    for(const int coordinate : { 0, 1, 2 })
      branches[branch][coordinate] =
        mesh.add_property_map<Face, double>(std::string("f:") + "uv"[branch] + "xyz"[coordinate]).first;
  for(const Face f : mesh.faces())
  {
    const auto vectors = CGAL::Frame_fields::frame_vectors(mesh, f, field.alpha[f], field.rho[f]);
    for(const int branch : { 0, 1 })
      for(const int coordinate : { 0, 1, 2 })
        branches[branch][coordinate][f] = vectors[branch][coordinate];
  }
}

// CGAL writes no Boolean properties.
inline void add_feature_numbers(Mesh& mesh, const Feature_map is_feature)
{
  const auto feature = mesh.add_property_map<Edge, int>("e:feature").first;
  for(const Edge e : mesh.edges())
    feature[e] = is_feature[e];
}

// Writes the mesh with all its properties; what the file needs beside those of the field is added to the mesh.
inline void write_ply(std::ostream& out, Mesh& mesh, const Feature_map is_feature, const Field& field,
                      const bool writes_ascii)
{
  add_branch_coordinates(mesh, field);
  add_feature_numbers(mesh, is_feature);
  CGAL::IO::set_mode(out, writes_ascii ? CGAL::IO::ASCII : CGAL::IO::BINARY);
  CGAL::IO::write_PLY(out, mesh, "index is 4 times the index of the sector at the target of the halfedge",
                      CGAL::parameters::stream_precision(17));
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_PLY_H
