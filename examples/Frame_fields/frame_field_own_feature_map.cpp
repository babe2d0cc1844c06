#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef std::set<std::pair<std::size_t, std::size_t> > Vertex_pairs;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

// A model of `ReadablePropertyMap` that stores nothing for each edge, but answers from a list of vertex pairs.
struct Listed_edges
{
  typedef Mesh::Edge_index key_type;
  typedef bool value_type;
  typedef bool reference;
  typedef boost::readable_property_map_tag category;

  const Mesh* mesh;
  const Vertex_pairs* pairs;

  friend bool get(const Listed_edges& map, const Mesh::Edge_index e)
  {
    const std::size_t a = map.mesh->vertex(e, 0), b = map.mesh->vertex(e, 1);
    return map.pairs->count(std::minmax(a, b)) != 0;
  }
};

// Two vertex numbers a line; a line that starts otherwise is a comment.
Vertex_pairs read_vertex_pairs(const std::string& filename)
{
  Vertex_pairs result;
  std::ifstream file(filename);
  std::size_t a, b;
  for(std::string line; std::getline(file, line);)
    if(std::istringstream(line) >> a >> b)
      result.insert(std::minmax(a, b));
  return result;
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 2) ? argv[1] : "data/flange.off";
  const std::string features_filename = (argc > 2) ? argv[2] : "data/flange.feat";
  Mesh mesh;
  const Vertex_pairs pairs = read_vertex_pairs(features_filename);
  if(pairs.empty() || !PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << " and " << features_filename << std::endl;
    return EXIT_FAILURE;
  }

  auto alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
  auto rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
  auto index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;

  const Listed_edges is_feature{ &mesh, &pairs }; // false for the edges that the split makes: their vertices are new
  const auto features = FF::parameters::edge_is_constrained_map(is_feature);
  FF::Refinement_statistics statistics;
  FF::Result result = FF::split_overconstrained_faces(mesh, features.statistics(std::ref(statistics)));
  if(result)
    result = FF::cad_frame_field(mesh, alpha, rho, index, features);
  std::cout << pairs.size() << " feature edges, " << statistics.number_of_split_faces << " faces split: "
            << FF::get_error_message(result.error_code) << std::endl;
  return result ? EXIT_SUCCESS : EXIT_FAILURE;
}
