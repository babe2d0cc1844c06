#include <CGAL/Frame_fields/cad_quad_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
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
  auto length = mesh.add_property_map<Mesh::Vertex_index, double>("v:length").first;
  auto number = mesh.add_property_map<Mesh::Edge_index, int>("e:number", 0).first;
  PMP::detect_sharp_edges(mesh, 40, is_feature);

  // Quads that are three times as long at one end as at the other; only the ratios count beside a number of quads.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  for(const Mesh::Vertex_index v : mesh.vertices())
    length[v] = 1 + 2 * (mesh.point(v).x() - box.xmin()) / (box.xmax() - box.xmin());
  // One feature curve, which one of its edges stands for, gets eight edges.
  for(const Mesh::Edge_index e : mesh.edges())
    if(is_feature[e])
    {
      number[e] = 8;
      break;
    }

  Mesh quad_mesh;
  FF::Quad_statistics statistics;
  const FF::Result result =
    FF::cad_quad_mesh(mesh, quad_mesh,
                      FF::parameters::edge_is_constrained_map(is_feature).number_of_quads(2000)
                                     .sizing_map(length).number_of_edges_map(number)
                                     .statistics(std::ref(statistics)));
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << statistics.number_of_quads << " quads; " << statistics.number_of_unmet_edge_numbers
            << " numbers of edges could not be met" << std::endl;
  return CGAL::IO::write_polygon_mesh("quad_mesh.off", quad_mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
