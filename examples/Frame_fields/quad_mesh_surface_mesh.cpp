#include <CGAL/Frame_fields/cad_quad_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

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

  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  PMP::detect_sharp_edges(mesh, 40, is_feature);

  Mesh quad_mesh;
  FF::Quad_statistics statistics;
  const FF::Result result =
    FF::cad_quad_mesh(mesh, quad_mesh,
                      FF::parameters::edge_is_constrained_map(is_feature).number_of_quads(2000)
                                     .statistics(std::ref(statistics)));
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << statistics.number_of_quads << " quads in " << statistics.number_of_patches << " patches, the least "
            << "scaled Jacobian is " << statistics.quality.minimum_scaled_jacobian << std::endl;
  return CGAL::IO::write_polygon_mesh("quad_mesh.off", quad_mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
