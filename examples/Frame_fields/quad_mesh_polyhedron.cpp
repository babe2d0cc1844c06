#include <CGAL/Frame_fields/cad_quad_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <cstdlib>
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
  PMP::detect_sharp_edges(mesh, 40, is_feature);

  Mesh quad_mesh;
  auto is_on_feature = get(CGAL::dynamic_edge_property_t<bool>(), quad_mesh);
  const FF::Result result =
    FF::cad_quad_mesh(mesh, quad_mesh,
                      FF::parameters::edge_is_constrained_map(is_feature)
                                     .output_edge_is_constrained_map(is_on_feature));
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }

  std::size_t number_of_feature_edges = 0;
  for(auto e : edges(quad_mesh))
    number_of_feature_edges += get(is_on_feature, e);
  std::cout << num_faces(quad_mesh) << " quads; " << number_of_feature_edges << " of their edges are on features"
            << std::endl;
  return EXIT_SUCCESS;
}
