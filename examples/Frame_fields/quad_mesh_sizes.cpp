#include <CGAL/Frame_fields/cad_quad_mesh.h>
#include <CGAL/Frame_fields/compute_quad_sizes.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
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

  // Short edges where the surface or a feature bends, and three of them across narrow strips.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  FF::Result result =
    FF::compute_quad_sizes(mesh, length,
                           FF::parameters::edge_is_constrained_map(is_feature).target_edge_length(diagonal / 20)
                                          .minimum_edge_length(diagonal / 200).chord_height(diagonal / 2000)
                                          .edges_across_gap(3).gradation(1.3));
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }
  // Twice as long at one end; only the ratios count beside a number of quads.
  for(const Mesh::Vertex_index v : mesh.vertices())
    length[v] *= 1 + (mesh.point(v).x() - box.xmin()) / box.x_span();
  // One feature curve, which one of its edges stands for, gets eight edges.
  for(const Mesh::Edge_index e : mesh.edges())
    if(is_feature[e])
    {
      number[e] = 8;
      break;
    }

  Mesh quad_mesh;
  FF::Quad_statistics statistics;
  result =
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
