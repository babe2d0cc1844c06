#include <boost/graph/compressed_sparse_row_graph.hpp> // has functions whose names hide others of Boost

#define OK (0) // as in curses
#include <CGAL/Frame_fields.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

CGAL::Frame_fields::Error_code error_code_of_an_empty_polyhedron()
{
  typedef CGAL::Polyhedron_3<CGAL::Simple_cartesian<double> > Mesh;
  const Mesh mesh;
  return CGAL::Frame_fields::cad_frame_field(mesh, get(CGAL::dynamic_face_property_t<double>(), mesh),
                                             get(CGAL::dynamic_face_property_t<double>(), mesh),
                                             get(CGAL::dynamic_halfedge_property_t<int>(), mesh)).error_code;
}

// The macro is still there, and an error code can be compared with it.
static_assert(OK == 0, "");
bool is_success(const CGAL::Frame_fields::Result& result) { return result.error_code == OK; }
