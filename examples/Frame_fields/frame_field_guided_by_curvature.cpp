#include "principal_directions.h"

#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/ellipsoid.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto direction = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:direction").first;
  auto weight = mesh.add_property_map<Mesh::Face_index, double>("f:weight").first;
  principal_directions(mesh, direction, weight);

  auto alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
  auto rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
  auto index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
  const FF::Result result = FF::cad_frame_field(
    mesh, alpha, rho, index, FF::parameters::guiding_direction_map(direction).guiding_weight_map(weight));
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<FF::Singularity<Mesh::Halfedge_index> > singularities;
  if(!FF::singularities(mesh, index, std::back_inserter(singularities)))
    return EXIT_FAILURE;
  for(const auto& singularity : singularities)
    std::cout << "index " << singularity.index << "/4 at " << mesh.point(mesh.target(singularity.halfedge))
              << std::endl;
  return EXIT_SUCCESS;
}
