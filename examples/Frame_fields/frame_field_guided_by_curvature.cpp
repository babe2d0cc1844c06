#include <CGAL/Frame_fields.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Monge_via_jet_fitting<Kernel> Monge_via_jet_fitting;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

// The points of a face and of two rings of vertices around it, those of the face first.
std::vector<Kernel::Point_3> neighborhood(const Mesh::Face_index f, const Mesh& mesh)
{
  const auto on_face = vertices_around_face(mesh.halfedge(f), mesh);
  std::vector<Mesh::Vertex_index> neighbors(on_face.begin(), on_face.end());
  std::set<Mesh::Vertex_index> found(neighbors.begin(), neighbors.end());
  for(int ring = 0; ring < 2; ++ring)
    for(std::size_t k = 0, end = neighbors.size(); k < end; ++k)
      for(const Mesh::Vertex_index v : vertices_around_target(mesh.halfedge(neighbors[k]), mesh))
        if(found.insert(v).second)
          neighbors.push_back(v);
  std::vector<Kernel::Point_3> points;
  for(const Mesh::Vertex_index v : neighbors)
    points.push_back(mesh.point(v));
  return points;
}

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
  auto weight = mesh.add_property_map<Mesh::Face_index, double>("f:weight", 0).first;
  const std::size_t degree = 2, least_number_of_points = 6;
  for(const Mesh::Face_index f : mesh.faces())
  {
    std::vector<Kernel::Point_3> points = neighborhood(f, mesh);
    if(points.size() < least_number_of_points)
      continue;
    Monge_via_jet_fitting fitting;
    const auto form = fitting(points.begin(), points.end(), degree, degree);
    direction[f] = form.maximal_principal_direction();
    weight[f] = std::abs(form.principal_curvatures(0) - form.principal_curvatures(1));
  }

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
  FF::singularities(mesh, index, std::back_inserter(singularities));
  for(const auto& singularity : singularities)
    std::cout << "index " << singularity.index << "/4 at " << mesh.point(mesh.target(singularity.halfedge)) << std::endl;
  return EXIT_SUCCESS;
}
