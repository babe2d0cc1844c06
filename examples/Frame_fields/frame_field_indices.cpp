#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Feature_map;
namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

// Cut along its constrained edges, a patch has as many sectors on them as sides of them. These cancel in
// vertices - edges + faces; what remains is off the constrained edges.
template <typename PatchMap>
std::vector<int> euler_characteristics(const Mesh& mesh, const Feature_map is_feature, const PatchMap patch,
                                       const std::size_t number_of_patches)
{
  std::vector<int> result(number_of_patches, 0);
  const auto is_constrained = [&](const Mesh::Halfedge_index h)
  { return is_feature[mesh.edge(h)] || mesh.is_border(mesh.edge(h)); };
  for(const Mesh::Face_index f : mesh.faces())
    ++result[patch[f]];
  for(const Mesh::Edge_index e : mesh.edges())
    if(!is_constrained(mesh.halfedge(e)))
      --result[patch[mesh.face(mesh.halfedge(e))]];
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v))
    {
      const auto around = mesh.halfedges_around_target(mesh.halfedge(v));
      if(std::none_of(around.begin(), around.end(), is_constrained))
        ++result[patch[mesh.face(mesh.halfedge(v))]];
    }
  return result;
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
  auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  PMP::detect_sharp_edges(mesh, 40, is_feature);
  const auto features = FF::parameters::edge_is_constrained_map(is_feature);
  std::vector<FF::Singularity<Mesh::Halfedge_index> > singularities;
  if(!FF::split_overconstrained_faces(mesh, features) ||
     !FF::cad_frame_field(mesh, alpha, rho, index, features) ||
     !FF::singularities(mesh, index, std::back_inserter(singularities), features))
    return EXIT_FAILURE;

  const std::size_t number_of_patches =
    PMP::connected_components(mesh, patch, CGAL::parameters::edge_is_constrained_map(is_feature));
  std::vector<int> sum(number_of_patches, 0);
  for(const auto& s : singularities)
  {
    sum[patch[mesh.face(s.halfedge)]] += s.index;
    std::cout << "index " << s.index << "/4 at " << mesh.point(mesh.target(s.halfedge))
              << (s.is_constrained ? " on an edge" : " inside") << std::endl;
  }
  const std::vector<int> chi = euler_characteristics(mesh, is_feature, patch, number_of_patches);
  for(std::size_t i = 0; i < number_of_patches; ++i)
    std::cout << "patch " << i << ": sum " << sum[i] << "/4, Euler characteristic " << chi[i] << std::endl;
  return EXIT_SUCCESS;
}
