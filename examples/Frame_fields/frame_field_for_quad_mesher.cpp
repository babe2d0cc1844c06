#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Point> Mesh;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

// The directions of a frame field after combing: u, v, -u and -v of each face.
struct Combed_field
{
  const Mesh& mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;
  Mesh::Property_map<Mesh::Face_index, double> alpha, rho;
  Mesh::Property_map<Mesh::Face_index, int> first_branch;
  Mesh::Property_map<Mesh::Halfedge_index, int> quarter_turns;

  std::array<Vector, 4> directions(const Mesh::Face_index f) const
  {
    std::array<Vector, 4> result = FF::frame_vectors(mesh, f, alpha[f], rho[f]);
    std::rotate(result.begin(), result.begin() + first_branch[f], result.end());
    return result;
  }

  // The number of the direction that runs along the constrained halfedge `h` in its face, or -1 if it has none.
  int direction_along(const Mesh::Halfedge_index h) const
  {
    if(mesh.is_border(h))
      return -1;
    const Vector along(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    const auto all = directions(mesh.face(h));
    const auto is_less = [&](const Vector& a, const Vector& b) { return a * along < b * along; };
    return static_cast<int>(std::max_element(all.begin(), all.end(), is_less) - all.begin());
  }
};

void write_edge(std::ostream& out, const Combed_field& field, const Mesh::Halfedge_index h)
{
  const Mesh& mesh = field.mesh;
  const std::string vertices = std::to_string(mesh.source(h)) + " " + std::to_string(mesh.target(h)) + " ";
  if(field.is_feature[mesh.edge(h)] || mesh.is_border(mesh.edge(h)))
    out << "c " << vertices << field.direction_along(h) << " " << field.direction_along(mesh.opposite(h)) << "\n";
  else if(field.quarter_turns[h] != 0)
    out << "s " << vertices << (field.quarter_turns[h] + 4) % 4 << "\n";
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
  auto first_branch = mesh.add_property_map<Mesh::Face_index, int>("f:first_branch").first;
  auto quarter_turns = mesh.add_property_map<Mesh::Halfedge_index, int>("h:quarter_turns").first;
  PMP::detect_sharp_edges(mesh, 40, is_feature);
  const auto features = FF::parameters::edge_is_constrained_map(is_feature);
  std::vector<FF::Singularity<Mesh::Halfedge_index> > singularities;
  if(!FF::split_overconstrained_faces(mesh, features) ||
     !FF::cad_frame_field(mesh, alpha, rho, index, features.matching_map(matching)) ||
     !FF::comb_frame_field(mesh, matching, first_branch, quarter_turns, features) ||
     !FF::singularities(mesh, index, std::back_inserter(singularities), features))
    return EXIT_FAILURE;

  const Combed_field field{ mesh, is_feature, alpha, rho, first_branch, quarter_turns };
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
    write_edge(std::cout, field, mesh.halfedge(e));
  for(const auto& singularity : singularities)
    std::cout << "p " << mesh.target(singularity.halfedge).idx() << " " << singularity.index << " "
              << singularity.is_constrained << "\n";
  return EXIT_SUCCESS;
}
