#include <boost/graph/compressed_sparse_row_graph.hpp> // has functions whose names hide others of Boost

#define OK (0) // as in curses
#include <CGAL/Frame_fields.h>

#include "compiled_stages.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

// All headers once more in the program of test_mesh_matrix, whose other units have them precompiled: nothing may be
// defined twice.
namespace {

TEST(Two_units, link_into_one_program)
{
  typedef CGAL::Polyhedron_3<CGAL::Simple_cartesian<double> > Mesh;
  const Mesh mesh;
  EXPECT_EQ(CGAL::Frame_fields::ERROR_EMPTY_MESH,
            CGAL::Frame_fields::cad_frame_field(mesh, get(CGAL::dynamic_face_property_t<double>(), mesh),
                                                get(CGAL::dynamic_face_property_t<double>(), mesh),
                                                get(CGAL::dynamic_halfedge_property_t<int>(), mesh)).error_code);
}

// The macro is still there, and an error code can be compared with it.
TEST(Two_units, keep_macros)
{
  static_assert(OK == 0, "");
  EXPECT_TRUE(CGAL::Frame_fields::Result().error_code == OK);
}

} // namespace
