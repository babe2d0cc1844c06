#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Polyhedron_3<Kernel> Mesh;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto is_feature = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  auto alpha = get(CGAL::dynamic_face_property_t<double>(), mesh);
  auto rho = get(CGAL::dynamic_face_property_t<double>(), mesh);
  auto index = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);

  PMP::detect_sharp_edges(mesh, 40, is_feature);
  FF::Result result = FF::split_overconstrained_faces(mesh, FF::parameters::edge_is_constrained_map(is_feature));
  if(result)
    result = FF::cad_frame_field(mesh, alpha, rho, index, FF::parameters::edge_is_constrained_map(is_feature));
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }

  std::size_t number_of_singular_corners = 0;
  for(auto h : halfedges(mesh))
    number_of_singular_corners += (get(index, h) != 0);
  std::cout << number_of_singular_corners << " corners of faces are in singular sectors" << std::endl;
  return EXIT_SUCCESS;
}
