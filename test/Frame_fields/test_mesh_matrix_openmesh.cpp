// The headers of these meshes come first.
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "test_mesh_matrix.h"

namespace test {

struct Double_traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
};

typedef OpenMesh::PolyMesh_ArrayKernelT<Double_traits> Double_poly_mesh;
typedef OpenMesh::TriMesh_ArrayKernelT<> Float_tri_mesh;

// Dynamic properties of the adaptor are references, which a vector of `bool` does not have.
template <typename Mesh>
struct Open_mesh_of_model : Mesh_with_points<Mesh>
{
  typedef char Mark;

  explicit Open_mesh_of_model(const Model& model)
  {
    add_triangles(model, this->mesh, get(CGAL::vertex_point, this->mesh));
  }
};

template <>
struct Mesh_of_model<Double_poly_mesh> : Open_mesh_of_model<Double_poly_mesh>
{
  using Open_mesh_of_model::Open_mesh_of_model;
};

template <>
struct Mesh_of_model<Float_tri_mesh> : Open_mesh_of_model<Float_tri_mesh>
{
  using Open_mesh_of_model::Open_mesh_of_model;
};

} // namespace test

namespace {

using namespace test;

typedef testing::Types<Double_poly_mesh, Float_tri_mesh> Open_meshes;

struct Names
{
  template <typename>
  static std::string GetName(const int i)
  {
    return std::array<const char*, 2>{ "OpenMesh_PolyMesh_of_double", "OpenMesh_TriMesh_of_float" }[i];
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(OpenMesh, Every_mesh_type, Open_meshes, Names);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenMesh, Every_editable_mesh_type, Open_meshes, Names);

} // namespace
