#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

// Each corner of a face has a texture coordinate of its own; features are lines.
template <typename Feature_map, typename Uv_map>
void write_obj(std::ostream& out, const Mesh& mesh, const Feature_map is_feature, const Uv_map uv)
{
  out.precision(17);
  for(const Mesh::Vertex_index v : mesh.vertices())
    out << "v " << mesh.point(v) << "\n";
  std::size_t number_of_corners = 0;
  for(const Mesh::Face_index f : mesh.faces())
  {
    std::string corners;
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
    {
      out << "vt " << uv[h] << "\n";
      corners += " " + std::to_string(mesh.target(h) + 1) + "/" + std::to_string(++number_of_corners);
    }
    out << "f" << corners << "\n";
  }
  for(const Mesh::Edge_index e : mesh.edges())
    if(is_feature[e] || mesh.is_border(e))
      out << "l " << mesh.vertex(e, 0) + 1 << " " << mesh.vertex(e, 1) + 1 << "\n";
}

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
  auto alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
  auto rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
  auto index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
  auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  PMP::detect_sharp_edges(mesh, 40, is_feature);
  const auto features = FF::parameters::edge_is_constrained_map(is_feature);
  std::vector<FF::Uncertified_patch<Mesh::Face_index>> uncertified;
  FF::Result result = FF::prepare_for_frame_field(mesh, features);
  if(result)
    result = FF::cad_frame_field(mesh, alpha, rho, index, features.matching_map(matching));
  if(result)
    result = FF::seamless_parameterization(
      mesh, alpha, rho, matching, index, uv,
      features.uncertified_patch_output_iterator(std::back_inserter(uncertified)));
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }

  if(!uncertified.empty())
    std::cerr << uncertified.size() << " patches have no map" << std::endl;
  write_obj(std::cout, mesh, is_feature, uv);
  return EXIT_SUCCESS;
}
