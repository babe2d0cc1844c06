#include "test_cad_mesh.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <unordered_map>

namespace {

using namespace test;

// The angles of a field in the order of faces(tm), computed on any mesh whose feature edges `is_feature(p, q)` tells.
struct Angles
{
  std::vector<double> alpha, rho;

  bool operator==(const Angles& other) const { return alpha == other.alpha && rho == other.rho; }
};

template <typename Mesh, typename NamedParameters>
Angles angles_of(const Mesh& mesh, const NamedParameters& np)
{
  const Maps<Mesh> maps(mesh);
  const FF::Result result = FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index, np);
  EXPECT_TRUE(result) << result.message;
  Angles angles;
  for(const auto f : faces(mesh))
  {
    angles.alpha.push_back(get(maps.alpha, f));
    angles.rho.push_back(get(maps.rho, f));
  }
  return angles;
}

// Faces with several constrained edges already split.
Model split_model(const Model& model) { return Cad_mesh<Surface_mesh>(model).model(); }

template <typename Mesh>
Mesh without_faces_beyond(const std::size_t number_of_faces, Mesh mesh)
{
  const std::vector<typename boost::graph_traits<Mesh>::face_descriptor> all(faces(mesh).begin(), faces(mesh).end());
  for(std::size_t f = number_of_faces; f < all.size(); ++f)
    CGAL::Euler::remove_face(halfedge(all[f], mesh), mesh);
  return mesh;
}

const auto defaults = parameters::relax_orthogonality(true);

TEST(Mesh_class, does_not_matter)
{
  for(const Model& model : { split_model(quilt()), split_model(star({ 5, 21, 43, 10 })), split_model(wedge(33)) })
  {
    const Cad_mesh<Surface_mesh> surface_mesh(model);
    const Cad_mesh<Polyhedron> polyhedron(model);
    const Cad_mesh<CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> > polyhedron_with_ids(model);
    const auto branches = frame_field(surface_mesh).branches;
    EXPECT_LT(largest_branch_distance(branches, frame_field(polyhedron).branches), 1e-9);
    EXPECT_LT(largest_branch_distance(branches, frame_field(polyhedron_with_ids).branches), 1e-9);
  }
}

TEST(Surface_mesh, may_have_removed_elements)
{
  const Model model = split_model(wedge(33));
  const Surface_mesh mesh = Cad_mesh<Surface_mesh>(model).mesh;
  const Surface_mesh before = Cad_mesh<Surface_mesh>(side_by_side(model, square(5))).mesh;
  const Surface_mesh with_garbage = without_faces_beyond(model.triangles.size(), before);
  ASSERT_TRUE(with_garbage.has_garbage());
  EXPECT_TRUE(angles_of(mesh, defaults) == angles_of(with_garbage, defaults));
}

TEST(Face_filtered_graph, is_a_mesh_of_its_own)
{
  const Model model = split_model(wedge(33));
  const Surface_mesh mesh = Cad_mesh<Surface_mesh>(model).mesh;
  Surface_mesh two_meshes = Cad_mesh<Surface_mesh>(side_by_side(model, square(5))).mesh;
  const auto first_faces = faces(two_meshes);
  const std::vector<Surface_mesh::Face_index> selection(first_faces.begin(),
                                                        std::next(first_faces.begin(), model.triangles.size()));
  const CGAL::Face_filtered_graph<Surface_mesh> filtered(two_meshes, selection);

  std::unordered_map<Surface_mesh::Face_index, double> alpha, rho;
  std::unordered_map<Surface_mesh::Halfedge_index, int> index;
  ASSERT_TRUE(FF::cad_frame_field(filtered, boost::make_assoc_property_map(alpha), boost::make_assoc_property_map(rho),
                                  boost::make_assoc_property_map(index)));
  const Angles expected = angles_of(mesh, defaults);
  ASSERT_EQ(expected.alpha.size(), alpha.size());
  for(std::size_t f = 0; f < selection.size(); ++f)
  {
    EXPECT_EQ(expected.alpha[f], alpha[selection[f]]);
    EXPECT_EQ(expected.rho[f], rho[selection[f]]);
  }
}

template <typename Kernel>
class Other_kernel : public testing::Test {};
typedef testing::Types<CGAL::Exact_predicates_inexact_constructions_kernel,
                       CGAL::Exact_predicates_exact_constructions_kernel, CGAL::Simple_cartesian<float> > Kernels;
TYPED_TEST_SUITE(Other_kernel, Kernels);

// The same coordinates give the same field, whatever type they have; floats hold multiples of 2^-12 exactly.
TYPED_TEST(Other_kernel, gives_the_same_field)
{
  typedef typename TypeParam::Point_3 Other_point;
  typedef CGAL::Surface_mesh<Other_point> Other_mesh;
  const Model model = transformed(split_model(wedge(33)), [](const Point& p)
  {
    return Point(std::round(4096 * p.x()) / 4096, std::round(4096 * p.y()) / 4096, 0);
  });
  const Surface_mesh mesh = Cad_mesh<Surface_mesh>(model).mesh;
  std::vector<Other_point> points;
  for(const Point& p : model.points)
    points.emplace_back(p.x(), p.y(), 0);
  Other_mesh other_mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, model.triangles, other_mesh);

  const Angles angles = angles_of(mesh, defaults);
  EXPECT_TRUE(angles == angles_of(other_mesh, defaults));
  EXPECT_EQ(0u, FF::split_overconstrained_faces(other_mesh));
  const auto branches = FF::frame_vectors(other_mesh, *faces(other_mesh).begin(), angles.alpha[0], angles.rho[0]);
  const auto expected = FF::frame_vectors(mesh, *faces(mesh).begin(), angles.alpha[0], angles.rho[0]);
  for(int k = 0; k < 4; ++k)
    for(int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(expected[k][axis], CGAL::to_double(branches[k][axis]), 1e-6);
}

TYPED_TEST(Other_kernel, splits_overconstrained_faces)
{
  typedef typename TypeParam::Point_3 Other_point;
  CGAL::Surface_mesh<Other_point> mesh;
  CGAL::make_triangle(Other_point(0, 0, 0), Other_point(3, 0, 0), Other_point(0, 3, 0), mesh);
  EXPECT_EQ(1u, FF::split_overconstrained_faces(mesh));
  EXPECT_EQ(Other_point(1, 1, 0), mesh.point(*std::prev(mesh.vertices().end())));
}

// Property maps of any kind hold input and output.
template <typename Mesh>
class Property_maps : public testing::Test
{
protected:
  typedef boost::graph_traits<Mesh> Graph_traits;

  Cad_mesh<Mesh> cad_mesh{ quilt() };
  Angles expected = angles_of(cad_mesh.mesh, cad_mesh.features());
};

TYPED_TEST_SUITE(Property_maps, Mesh_classes, Mesh_class_names);

TYPED_TEST(Property_maps, of_associative_containers)
{
  typedef typename TestFixture::Graph_traits Graph_traits;
  std::unordered_map<typename Graph_traits::face_descriptor, double> alpha, rho;
  std::unordered_map<typename Graph_traits::halfedge_descriptor, int> index, matching;
  std::unordered_map<typename Graph_traits::edge_descriptor, bool> is_feature;
  const TypeParam& mesh = this->cad_mesh.mesh;
  for(const auto e : edges(mesh))
    is_feature[e] = get(this->cad_mesh.is_feature, e);
  ASSERT_TRUE(FF::cad_frame_field(mesh, boost::make_assoc_property_map(alpha), boost::make_assoc_property_map(rho),
                                  boost::make_assoc_property_map(index),
                                  parameters::edge_is_constrained_map(boost::make_assoc_property_map(is_feature))
                                             .matching_map(boost::make_assoc_property_map(matching))));
  EXPECT_EQ(faces(mesh).size(), alpha.size());
  EXPECT_EQ(faces(mesh).size(), rho.size());
  EXPECT_EQ(halfedges(mesh).size(), index.size()); // border halfedges too
  EXPECT_EQ(halfedges(mesh).size(), matching.size());
  std::size_t f = 0;
  for(const auto face : faces(mesh))
  {
    EXPECT_EQ(this->expected.alpha[f], alpha[face]);
    EXPECT_EQ(this->expected.rho[f++], rho[face]);
  }
}

TYPED_TEST(Property_maps, that_are_functions)
{
  typedef typename TestFixture::Graph_traits::edge_descriptor edge_descriptor;
  const auto is_feature = [this](const edge_descriptor e) -> bool { return get(this->cad_mesh.is_feature, e); };
  const auto np =
    parameters::edge_is_constrained_map(boost::make_function_property_map<edge_descriptor, bool>(is_feature));
  EXPECT_TRUE(this->expected == angles_of(this->cad_mesh.mesh, np));
  EXPECT_EQ(0u, FF::split_overconstrained_faces(this->cad_mesh.mesh, np));
}

TYPED_TEST(Property_maps, of_vertex_points)
{
  typedef typename TestFixture::Graph_traits::vertex_descriptor vertex_descriptor;
  TypeParam& mesh = this->cad_mesh.mesh;
  std::unordered_map<vertex_descriptor, Point> points;
  for(const vertex_descriptor v : vertices(mesh))
  {
    points[v] = get(CGAL::vertex_point, mesh, v);
    put(CGAL::vertex_point, mesh, v, Point(0, 0, 0));
  }
  EXPECT_TRUE(this->expected == angles_of(mesh, this->cad_mesh.features()
    .vertex_point_map(boost::const_associative_property_map<std::unordered_map<vertex_descriptor, Point> >(points))));
}

TEST(Surface_mesh, has_property_maps_of_its_own)
{
  Cad_mesh<Surface_mesh> cad_mesh(quilt());
  const auto alpha = cad_mesh.mesh.add_property_map<Surface_mesh::Face_index, double>("f:alpha").first;
  const auto rho = cad_mesh.mesh.add_property_map<Surface_mesh::Face_index, double>("f:rho").first;
  const auto index = cad_mesh.mesh.add_property_map<Surface_mesh::Halfedge_index, int>("h:index").first;
  ASSERT_TRUE(FF::cad_frame_field(cad_mesh.mesh, alpha, rho, index, cad_mesh.features()));
  const Angles expected = angles_of(cad_mesh.mesh, cad_mesh.features());
  for(const Surface_mesh::Face_index f : cad_mesh.mesh.faces())
  {
    EXPECT_EQ(expected.alpha[f], alpha[f]);
    EXPECT_EQ(expected.rho[f], rho[f]);
  }
}

} // namespace
