#include <CGAL/Frame_fields.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

// All headers in two translation units of one program: nothing may be defined twice.
CGAL::Frame_fields::Error_code error_code_of_an_empty_polyhedron();

TEST(Two_units, link_into_one_program)
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
  Mesh mesh;
  const auto alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
  const auto index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
  EXPECT_EQ(CGAL::Frame_fields::ERROR_EMPTY_MESH,
            CGAL::Frame_fields::cad_frame_field(mesh, alpha, alpha, index).error_code);
  EXPECT_EQ(CGAL::Frame_fields::ERROR_EMPTY_MESH, error_code_of_an_empty_polyhedron());
}
