#ifndef FRAME_FIELDS_PROGRAMS_WRITE_FIELD_H
#define FRAME_FIELDS_PROGRAMS_WRITE_FIELD_H

#include "Field.h"
#include "field_formats.h"

#include "../shared/Mesh.h"

#include <CGAL/Frame_fields/frame_vectors.h>

#include <array>
#include <cstddef>
#include <limits>
#include <ostream>

typedef std::array<Vector, 4> Frame_vectors;

// One branch of the cross that stands for a frame: the branch along its feature edge, or else one of the cross nearest
// to it.
inline Vector representative(const Mesh& mesh, const Feature_map is_feature, const Field& field, const Face f)
{
  const double alpha = field.alpha[f], rho = field.rho[f];
  for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
    if(is_feature[mesh.edge(h)])
    {
      const Frame_vectors branches = CGAL::Frame_fields::frame_vectors(mesh, f, alpha, rho);
      const Vector edge(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
      return CGAL::abs(branches[0] * edge) > CGAL::abs(branches[1] * edge) ? branches[0] : branches[1];
    }
  return CGAL::Frame_fields::frame_vectors(mesh, f, alpha + rho / 2, 0)[0];
}

inline void write_vectors(std::ostream& out, const Vector* const begin, const std::size_t number)
{
  for(std::size_t k = 0; k < number; ++k)
    out << (k == 0 ? "" : " ") << begin[k].x() << " " << begin[k].y() << " " << begin[k].z();
  out << "\n";
}

inline void write_field(std::ostream& out, const Field_format format, const Mesh& mesh, const Feature_map is_feature,
                        const Field& field)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  const std::size_t number_of_faces = mesh.number_of_faces();
  if(format == RAWFIELD)
    out << "4 " << number_of_faces << "\n";
  else if(format == ROSY)
    out << number_of_faces << "\n4\n";
  else
    out << "# frame field\ntarget_frame\n" << number_of_faces << "\nk1 k2 k1v_x k1v_y k1v_z k2v_x k2v_y k2v_z\n";

  for(const Face f : mesh.faces())
  {
    if(format == ROSY)
    {
      const Vector branch = representative(mesh, is_feature, field, f);
      write_vectors(out, &branch, 1);
      continue;
    }
    const Frame_vectors branches = CGAL::Frame_fields::frame_vectors(mesh, f, field.alpha[f], field.rho[f]);
    out << (format == FFIELD ? "1 1 " : "");
    write_vectors(out, branches.data(), format == FFIELD ? 2 : 4);
  }
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_FIELD_H
