#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

void check(const FF::Result& result)
{
  if(!result)
    throw std::runtime_error(result.message);
}

int main(int argc, char* argv[])
try
{
  const std::string filename = (argc > 1) ? argv[1] : "data/flange.off";
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
    throw std::runtime_error("Cannot read " + filename);

  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  auto omega = mesh.add_property_map<Mesh::Halfedge_index, double>("h:omega").first;
  auto alpha = mesh.add_property_map<Mesh::Face_index, double>("f:alpha").first;
  auto matching = mesh.add_property_map<Mesh::Halfedge_index, int>("h:matching").first;
  auto index = mesh.add_property_map<Mesh::Halfedge_index, int>("h:index").first;
  auto rho = mesh.add_property_map<Mesh::Face_index, double>("f:rho").first;
  PMP::detect_sharp_edges(mesh, 40, is_feature);
  const auto features = FF::parameters::edge_is_constrained_map(is_feature);

  check(FF::split_overconstrained_faces(mesh, features));
  // Cut once: each function also takes the mesh, and cuts it then.
  const FF::Cut_triangle_mesh cut(mesh, features);

  std::vector<Mesh::Halfedge_index> sharp_corners;
  check(FF::sharp_corners(cut, std::back_inserter(sharp_corners)));
  std::cout << sharp_corners.size() << " sharp corners" << std::endl;

  // omega: what the field shall turn by across each edge. Other rotations may be written here.
  check(FF::prescribe_rotation(cut, omega));
  const auto edges_that_turn = std::count_if(mesh.edges().begin(), mesh.edges().end(), [&](const Mesh::Edge_index e)
                                             { return omega[mesh.halfedge(e)] != 0; });
  std::cout << edges_that_turn << " edges with a prescribed rotation" << std::endl;

  // alpha: one angle per face. The matching has to be kept: omega took part in it, alpha alone does not tell it.
  check(FF::orthogonal_frame_field(cut, alpha,
                                   FF::parameters::prescribed_rotation_map(omega).matching_map(matching)));

  // index: the place to look at the singularities, and to change omega and go back if they do not suit.
  check(FF::singularity_indices(cut, alpha, matching, index));
  std::vector<FF::Singularity<Mesh::Halfedge_index> > singularities;
  check(FF::singularities(cut, index, std::back_inserter(singularities)));
  std::cout << singularities.size() << " singular sectors" << std::endl;

  // alpha and rho: the frames lean, the matching and the indices stay.
  check(FF::relax_frame_field(cut, alpha, rho, FF::parameters::matching_map(matching)));
  double largest_skewness = 0;
  for(const Mesh::Face_index f : mesh.faces())
    largest_skewness = (std::max)(largest_skewness, std::abs(rho[f]));
  std::cout << "skewness of at most " << largest_skewness << std::endl;
  return EXIT_SUCCESS;
}
catch(const std::exception& error)
{
  std::cerr << error.what() << std::endl;
  return EXIT_FAILURE;
}
