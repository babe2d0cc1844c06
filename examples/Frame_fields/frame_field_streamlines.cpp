#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Frame_fields::Streamline<Kernel::Point_3, Mesh::Face_index> Streamline;
namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

// Writes an OBJ file with one object for each branch pair; a streamline is a polyline.
void write_obj(std::ostream& out, const std::vector<Streamline>& streamlines)
{
  std::size_t number_of_points = 0;
  for(const int branch_pair : { 0, 1 })
  {
    out << "o branch_pair_" << branch_pair << '\n';
    for(const Streamline& streamline : streamlines)
      if(streamline.branch_pair == branch_pair)
      {
        for(const Kernel::Point_3& p : streamline.points)
          out << "v " << p << '\n';
        out << 'l';
        for(std::size_t k = 0; k < streamline.points.size(); ++k)
          out << ' ' << ++number_of_points;
        out << '\n';
      }
  }
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

  std::vector<Streamline> streamlines;
  FF::Result result = FF::split_overconstrained_faces(mesh, features);
  if(result)
    result = FF::cad_frame_field(mesh, alpha, rho, index, features.matching_map(matching));
  if(result)
    result = FF::trace_streamlines(mesh, alpha, rho, matching, std::back_inserter(streamlines), features);
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }

  std::cout.precision(17);
  write_obj(std::cout, streamlines);
  return EXIT_SUCCESS;
}
