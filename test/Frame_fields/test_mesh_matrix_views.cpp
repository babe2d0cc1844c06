#include "test_mesh_matrix.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/Seam_mesh.h>

// Meshes that are a part of another mesh, or another mesh seen differently.
namespace test {

// What Cad_mesh is told to make.
struct Surface_mesh_with_garbage {};
struct Filtered_mesh {};
struct Seam_mesh {};

typedef CGAL::Surface_mesh<EPICK::Point_3> Whole_mesh;

// A mesh with more faces after those of the model.
inline Whole_mesh with_more_faces(Model model)
{
  const Model other = square(5);
  const std::size_t offset = model.points.size();
  for(const Point& p : other.points)
    model.points.push_back(p + Vector(100, 0, 0));
  for(const auto& [p, q, r] : other.triangles)
    model.triangles.push_back({ p + offset, q + offset, r + offset });
  Whole_mesh mesh;
  add_triangles(model, mesh, mesh.points());
  return mesh;
}

template <>
struct Mesh_of_model<Surface_mesh_with_garbage> : Mesh_with_points<Whole_mesh>
{
  explicit Mesh_of_model(const Model& model) : Mesh_with_points(with_more_faces(model))
  {
    for(std::size_t f = mesh.number_of_faces(); f > model.triangles.size(); --f)
      CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(f - 1))), mesh);
  }
};

// What a view is a view of, made before it.
struct Viewed_mesh
{
  Whole_mesh whole;
};

typedef CGAL::Face_filtered_graph<Whole_mesh> Filtered_graph;

template <>
struct Mesh_of_model<Filtered_mesh> : Viewed_mesh, Mesh_with_points<Filtered_graph>
{
  static constexpr bool is_editable = false;

  explicit Mesh_of_model(const Model& model)
    : Viewed_mesh{ with_more_faces(model) }
    , Mesh_with_points(whole, std::vector<Whole_mesh::Face_index>(
                                whole.faces().begin(), std::next(whole.faces().begin(), model.triangles.size())))
  {}
};

typedef Whole_mesh::Property_map<Whole_mesh::Edge_index, bool> Seam_edge_map;
typedef Whole_mesh::Property_map<Whole_mesh::Vertex_index, bool> Seam_vertex_map;
typedef CGAL::Seam_mesh<Whole_mesh, Seam_edge_map, Seam_vertex_map> Seam_graph;

// The feature edges are seams.
template <>
struct Mesh_of_model<Seam_mesh> : Viewed_mesh, Mesh_with_points<Seam_graph>
{
  static constexpr bool is_editable = false;

  explicit Mesh_of_model(const Model& model)
    : Mesh_with_points(whole, whole.add_property_map<Whole_mesh::Edge_index, bool>("e:seam", false).first,
                       whole.add_property_map<Whole_mesh::Vertex_index, bool>("v:seam", false).first)
  {
    add_triangles(model, whole, whole.points());
    std::map<Point, Whole_mesh::Vertex_index> vertex_at;
    for(const Whole_mesh::Vertex_index v : whole.vertices())
      vertex_at[Point(whole.point(v).x(), whole.point(v).y(), whole.point(v).z())] = v;
    for(const auto& [p, q] : model.features)
      mesh.add_seam(vertex_at.at(p), vertex_at.at(q));
  }
};

} // namespace test

namespace {

using namespace test;

typedef testing::Types<Surface_mesh_with_garbage, Filtered_mesh, test::Seam_mesh> Views;

struct Names
{
  template <typename>
  static std::string GetName(const int i)
  {
    return std::array<const char*, 3>{ "Surface_mesh_with_garbage_of_EPICK", "Face_filtered_graph_of_EPICK",
                                       "Seam_mesh_of_EPICK" }[i];
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Views, Every_mesh_type, Views, Names);
INSTANTIATE_TYPED_TEST_SUITE_P(Views, Every_editable_mesh_type, testing::Types<Surface_mesh_with_garbage>, Names);

TEST(Surface_mesh_with_garbage, has_removed_elements)
{
  EXPECT_TRUE(Cad_mesh<Surface_mesh_with_garbage>(quilt()).mesh.has_garbage());
}

} // namespace
