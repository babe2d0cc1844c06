#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <CGAL/Frame_fields.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <array>
#include <iostream>
#include <string>

typedef OpenMesh::TriMesh Mesh;
typedef std::array<double, 3> Vector;

namespace FF = CGAL::Frame_fields;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if(!OpenMesh::IO::read_mesh(mesh, filename))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto is_feature = get(CGAL::dynamic_edge_property_t<char>(), mesh); // CGAL 5.5 cannot have bool here
  auto alpha = get(CGAL::dynamic_face_property_t<double>(), mesh);
  auto rho = get(CGAL::dynamic_face_property_t<double>(), mesh);
  auto index = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);

  PMP::detect_sharp_edges(mesh, 40, is_feature);
  FF::Result result = FF::split_overconstrained_faces(mesh, FF::parameters::edge_is_constrained_map(is_feature));
  if(result)
    result = FF::cad_frame_field(mesh, alpha, rho, index, FF::parameters::edge_is_constrained_map(is_feature));
  if(!result)
  {
    std::cerr << filename << ": " << result.message << std::endl;
    return EXIT_FAILURE;
  }

  // From here on with OpenMesh's own means: the two directions as properties of its faces.
  auto u = OpenMesh::getOrMakeProperty<OpenMesh::FaceHandle, Vector>(mesh, "u");
  auto v = OpenMesh::getOrMakeProperty<OpenMesh::FaceHandle, Vector>(mesh, "v");
  for(const OpenMesh::FaceHandle f : mesh.faces())
  {
    const auto branch = FF::frame_vectors(mesh, f, get(alpha, f), get(rho, f));
    u[f] = { branch[0].x(), branch[0].y(), branch[0].z() };
    v[f] = { branch[1].x(), branch[1].y(), branch[1].z() };
  }
  const OpenMesh::FaceHandle first = *mesh.faces_begin();
  for(const Vector& direction : { u[first], v[first] })
    std::cout << direction[0] << " " << direction[1] << " " << direction[2] << std::endl;
  return EXIT_SUCCESS;
}
