#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

// The arguments are a mesh and a field of another program: six numbers for each face, two directions in space.
int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/flange.off";
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  PMP::detect_sharp_edges(mesh, 40, is_feature);
  const auto features = FF::parameters::edge_is_constrained_map(is_feature);
  if(argc <= 2 && !FF::prepare_for_frame_field(mesh, features))
    return EXIT_FAILURE;

  auto u = mesh.add_property_map<Mesh::Face_index, Vector>("f:u").first;
  auto v = mesh.add_property_map<Mesh::Face_index, Vector>("f:v").first;
  auto alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
  auto rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
  auto index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
  auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
  if(argc > 2)
  {
    std::ifstream in(argv[2]);
    for(const Mesh::Face_index f : mesh.faces())
      in >> u[f] >> v[f];
    if(!in)
      return EXIT_FAILURE;
  }
  else if(FF::cad_frame_field(mesh, alpha, rho, index, features))
    for(const Mesh::Face_index f : mesh.faces())
    {
      u[f] = FF::frame_vectors(mesh, f, alpha[f], rho[f])[0];
      v[f] = FF::frame_vectors(mesh, f, alpha[f], rho[f])[1];
    }

  Mesh quads;
  FF::Result result = FF::frame_field_from_vectors(mesh, u, v, alpha, rho, matching, features);
  if(result)
    result = FF::singularity_indices(mesh, alpha, matching, index, features.skewness_map(rho));
  if(result)
    result = FF::quad_mesh(mesh, alpha, rho, matching, index, quads, features.number_of_quads(2000));
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << num_faces(quads) << " quads" << std::endl;
  return CGAL::IO::write_polygon_mesh("quad_mesh.off", quads) ? EXIT_SUCCESS : EXIT_FAILURE;
}
