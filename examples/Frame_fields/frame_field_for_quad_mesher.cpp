#include "Combed_frame_field.h"

#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

void write_edge(std::ostream& out, const Mesh& mesh, const Combed_frame_field<Point>& field,
                const Mesh::Halfedge_index h)
{
  const std::string vertices = std::to_string(mesh.source(h)) + " " + std::to_string(mesh.target(h)) + " ";
  if(field.is_constrained(h))
    out << "c " << vertices << field.direction_along(h) << " " << field.direction_along(mesh.opposite(h)) << "\n";
  else if(field.jump(h) != 0)
    out << "s " << vertices << field.jump(h) << "\n";
}

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
  auto alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
  auto rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
  auto index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
  auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
  PMP::detect_sharp_edges(mesh, 40, is_feature);
  const auto features = FF::parameters::edge_is_constrained_map(is_feature);
  FF::split_overconstrained_faces(mesh, features);
  std::vector<FF::Singularity<Mesh::Halfedge_index> > singularities;
  if(!FF::cad_frame_field(mesh, alpha, rho, index, features.matching_map(matching)) ||
     !FF::singularities(mesh, index, std::back_inserter(singularities), features))
    return EXIT_FAILURE;

  const Combed_frame_field<Point> field(mesh, is_feature, alpha, rho, matching);
  std::cout.precision(17);
  for(const Mesh::Vertex_index v : mesh.vertices())
    std::cout << "v " << mesh.point(v) << "\n";
  for(const Mesh::Face_index f : mesh.faces())
  {
    std::cout << "f ";
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      std::cout << v.idx() << " ";
    std::cout << field.directions(f)[0] << " " << field.directions(f)[1] << "\n";
  }
  for(const Mesh::Edge_index e : mesh.edges())
    write_edge(std::cout, mesh, field, mesh.halfedge(e));
  for(const auto& singularity : singularities)
    std::cout << "p " << mesh.target(singularity.halfedge).idx() << " " << singularity.index << " "
              << singularity.is_constrained << "\n";
  return EXIT_SUCCESS;
}
