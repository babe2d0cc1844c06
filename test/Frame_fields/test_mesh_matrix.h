#ifndef TEST_FRAME_FIELDS_TEST_MESH_MATRIX_H
#define TEST_FRAME_FIELDS_TEST_MESH_MATRIX_H

#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/split_chords.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

// What holds on every type of mesh and for every kernel. A source file for each kind of mesh instantiates the tests;
// the types are named mesh_of_kernel, from which the table of the manual is made.
namespace test {

typedef CGAL::Exact_predicates_inexact_constructions_kernel EPICK;
typedef CGAL::Exact_predicates_exact_constructions_kernel EPECK;
typedef CGAL::Simple_cartesian<float> Float_kernel;

// Points that each of the kernels holds exactly.
inline Model rounded(const Model& model)
{
  const auto round = [](const double x) { return std::round(4096 * x) / 4096; };
  return transformed(model, [&](const Point& p) { return Point(round(p.x()), round(p.y()), round(p.z())); });
}

// No face of it has several constrained edges.
inline Model rounded_split_model(const Model& model)
{
  return rounded(Cad_mesh<Surface_mesh>(rounded(model)).model());
}

// Models whose field is unique.
inline std::vector<Model> models_without_ties()
{
  std::vector<Model> result;
  for(const Model& model : { quilt(), star({ 5, 21, 43, 10 }), wedge(33) })
    result.push_back(rounded_split_model(model));
  return result;
}

inline std::vector<Model> models_of_every_topology()
{
  std::vector<Model> result = models_without_ties();
  for(const Model& model : { annulus(12, 1), torus(), sphere(), tetrahedron(), cube(), single_triangle() })
    result.push_back(rounded_split_model(model));
  return result;
}

// The frames of the faces, which are told by their corners: point and index.
typedef std::map<std::array<std::pair<Point, int>, 3>, std::array<Vector, 4> > Frames;

inline Frames frames_of(const Cut& cut, const Field& field)
{
  Frames result;
  for(int f = 0; f < cut.number_of_faces(); ++f)
  {
    Frames::key_type corners;
    for(int k = 0; k < 3; ++k)
      corners[k] = { cut.points[3 * f + k], field.index[3 * f + k] };
    std::sort(corners.begin(), corners.end());
    result.emplace(corners, field.branches[f]);
  }
  return result;
}

inline void expect_same(const Frames& expected, const Frames& frames)
{
  std::vector<std::array<Vector, 4> > expected_branches, branches;
  ASSERT_EQ(expected.size(), frames.size());
  for(auto e = expected.begin(), f = frames.begin(); e != expected.end(); ++e, ++f)
  {
    ASSERT_EQ(e->first, f->first);
    expected_branches.push_back(e->second);
    branches.push_back(f->second);
  }
  EXPECT_LT(largest_branch_distance(expected_branches, branches), 1e-9);
}

// Those of the field on a surface mesh, in test_mesh_matrix_surface_mesh.cpp.
Frames frames_on_surface_mesh(const Model& model);

// All that a mesh tells of itself.
template <typename MeshType>
auto description_of(const Cad_mesh<MeshType>& cad_mesh)
{
  typedef typename Cad_mesh<MeshType>::Graph_traits Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  const auto& mesh = cad_mesh.mesh;
  std::vector<std::tuple<Halfedge, Halfedge, Halfedge, typename Graph_traits::face_descriptor, Point, bool> > result;
  for(const Halfedge h : halfedges(mesh))
    result.emplace_back(h, next(h, mesh), opposite(h, mesh), face(h, mesh), cad_mesh.point(target(h, mesh)),
                        get(cad_mesh.is_feature, edge(h, mesh)));
  return result;
}

template <typename MeshType>
class Every_mesh_type : public testing::Test
{
public:
  typedef typename Cad_mesh<MeshType>::Mesh Mesh;
  typedef typename Cad_mesh<MeshType>::Graph_traits Graph_traits;

protected:
  typedef typename Graph_traits::face_descriptor Face;
  typedef typename Graph_traits::halfedge_descriptor Halfedge;
  typedef typename Graph_traits::edge_descriptor Edge;

  const Cad_mesh<MeshType> cad_mesh{ rounded_split_model(quilt()) };

  template <typename FaceMap, typename HalfedgeMap>
  void expect_field(const FaceMap& alpha, const FaceMap& rho, const HalfedgeMap& index) const
  {
    const Field expected = frame_field(cad_mesh);
    std::size_t f = 0, h = 0;
    for(const Face face : faces(cad_mesh.mesh))
    {
      EXPECT_EQ(expected.alpha[f], get(alpha, face));
      EXPECT_EQ(expected.rho[f++], get(rho, face));
    }
    for_each_halfedge(cad_mesh.mesh, [&](const Halfedge halfedge)
    {
      EXPECT_EQ(expected.index[h++], get(index, halfedge));
    });
  }
};

TYPED_TEST_SUITE_P(Every_mesh_type);

TYPED_TEST_P(Every_mesh_type, has_an_aligned_field_with_exact_indices)
{
  for(const Model& model : models_of_every_topology())
  {
    const Cad_mesh<TypeParam> cad_mesh(model);
    const Cut cut = cad_mesh.cut();
    const Field field = frame_field(cad_mesh);
    expect_valid_field(cut, field);
    EXPECT_EQ(0, number_of_unmeshable_sectors(cut, field.index));
    EXPECT_LT(largest_difference(cut.sums_around_sectors(field.omega),
                                 rotation_demand_of_rings(cut, 4, corner_bounds)), 1e-10);
  }
}

TYPED_TEST_P(Every_mesh_type, gets_the_field_of_a_surface_mesh)
{
  for(const Model& model : models_without_ties())
  {
    const Cad_mesh<TypeParam> cad_mesh(model);
    expect_same(frames_on_surface_mesh(model), frames_of(cad_mesh.cut(), frame_field(cad_mesh)));
  }
}

TYPED_TEST_P(Every_mesh_type, gets_branches_as_vectors_of_its_kernel)
{
  const auto& mesh = this->cad_mesh.mesh;
  const Field field = frame_field(this->cad_mesh);
  std::size_t number = 0;
  for(const auto f : faces(mesh))
  {
    const auto branches = FF::frame_vectors(mesh, f, field.alpha[number], field.rho[number],
                                            this->cad_mesh.with_points(CGAL::parameters::default_values()));
    for(int k = 0; k < 4; ++k)
      for(int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(field.branches[number][k][axis], CGAL::to_double(branches[k][axis]), 1e-6); // floats
    ++number;
  }
}

TYPED_TEST_P(Every_mesh_type, is_not_changed)
{
  const auto before = description_of(this->cad_mesh);
  frame_field(this->cad_mesh);
  EXPECT_TRUE(before == description_of(this->cad_mesh));
}

TYPED_TEST_P(Every_mesh_type, takes_maps_of_associative_containers)
{
  typedef typename TestFixture::Edge Edge;
  const auto& mesh = this->cad_mesh.mesh;
  std::unordered_map<typename TestFixture::Face, double> alpha, rho;
  std::unordered_map<typename TestFixture::Halfedge, int> index, matching;
  std::unordered_map<Edge, bool> is_feature;
  for(const Edge e : edges(mesh))
    is_feature[e] = get(this->cad_mesh.is_feature, e);
  ASSERT_TRUE(FF::cad_frame_field(
    mesh, boost::make_assoc_property_map(alpha), boost::make_assoc_property_map(rho),
    boost::make_assoc_property_map(index),
    this->cad_mesh.with_points(parameters::edge_is_constrained_map(boost::make_assoc_property_map(is_feature))
                                          .matching_map(boost::make_assoc_property_map(matching)))));
  const std::size_t number_of_faces = std::distance(faces(mesh).begin(), faces(mesh).end());
  const std::size_t number_of_halfedges = std::distance(halfedges(mesh).begin(), halfedges(mesh).end());
  EXPECT_EQ(number_of_faces, alpha.size());
  EXPECT_EQ(number_of_faces, rho.size());
  EXPECT_EQ(number_of_halfedges, index.size()); // border halfedges too
  EXPECT_EQ(number_of_halfedges, matching.size());
  this->expect_field(boost::make_assoc_property_map(alpha), boost::make_assoc_property_map(rho),
                     boost::make_assoc_property_map(index));
}

TYPED_TEST_P(Every_mesh_type, takes_maps_of_vectors)
{
  const auto& mesh = this->cad_mesh.mesh;
  const auto face_number = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const auto halfedge_number = get(CGAL::dynamic_halfedge_property_t<std::size_t>(), mesh);
  std::size_t number_of_faces = 0, number_of_halfedges = 0;
  for(const auto f : faces(mesh))
    put(face_number, f, number_of_faces++);
  for(const auto h : halfedges(mesh))
    put(halfedge_number, h, number_of_halfedges++);
  std::vector<double> alpha(number_of_faces), rho(number_of_faces);
  std::vector<int> index(number_of_halfedges);
  const auto alpha_map = boost::make_iterator_property_map(alpha.begin(), face_number);
  const auto skewness_map = boost::make_iterator_property_map(rho.begin(), face_number);
  const auto index_map = boost::make_iterator_property_map(index.begin(), halfedge_number);
  ASSERT_TRUE(FF::cad_frame_field(mesh, alpha_map, skewness_map, index_map, this->cad_mesh.features()));
  this->expect_field(alpha_map, skewness_map, index_map);
}

TYPED_TEST_P(Every_mesh_type, takes_functions_for_constrained_edges)
{
  typedef typename TestFixture::Edge Edge;
  const Maps<typename TestFixture::Mesh> maps(this->cad_mesh.mesh);
  const auto is_feature = boost::make_function_property_map<Edge, bool>(
    [this](const Edge e) -> bool { return get(this->cad_mesh.is_feature, e); });
  ASSERT_TRUE(FF::cad_frame_field(this->cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
                                  this->cad_mesh.with_points(parameters::edge_is_constrained_map(is_feature))));
  this->expect_field(maps.alpha, maps.rho, maps.index);
}

REGISTER_TYPED_TEST_SUITE_P(Every_mesh_type, has_an_aligned_field_with_exact_indices, gets_the_field_of_a_surface_mesh,
                            gets_branches_as_vectors_of_its_kernel, is_not_changed,
                            takes_maps_of_associative_containers, takes_maps_of_vectors,
                            takes_functions_for_constrained_edges);

// Those with Euler operations.
template <typename MeshType>
class Every_editable_mesh_type : public testing::Test
{
protected:
  typedef Cad_mesh<MeshType> Type;

  static std::vector<Point> sorted_points(const Type& cad_mesh)
  {
    std::vector<Point> result;
    for(const auto v : vertices(cad_mesh.mesh))
      result.push_back(cad_mesh.point(v));
    std::sort(result.begin(), result.end());
    return result;
  }

  static void expect_triangle_mesh(const Type& cad_mesh, const std::size_t number_of_faces)
  {
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cad_mesh.mesh));
    EXPECT_TRUE(CGAL::is_triangle_mesh(cad_mesh.mesh));
    EXPECT_EQ(number_of_faces, static_cast<std::size_t>(cad_mesh.cut().number_of_faces()));
  }
};

TYPED_TEST_SUITE_P(Every_editable_mesh_type);

TYPED_TEST_P(Every_editable_mesh_type, splits_overconstrained_faces_at_their_centroids)
{
  Model triangle = single_triangle();
  triangle.points = { Point(0, 0, 0), Point(3, 0, 0), Point(0, 3, 0) };
  Cad_mesh<TypeParam> cad_mesh(triangle, false);
  EXPECT_EQ(1u, split_overconstrained_faces(cad_mesh));
  const std::vector<Point> expected = { Point(0, 0, 0), Point(0, 3, 0), Point(1, 1, 0), Point(3, 0, 0) };
  EXPECT_EQ(expected, this->sorted_points(cad_mesh));
  this->expect_triangle_mesh(cad_mesh, 3);
  EXPECT_EQ(0u, split_overconstrained_faces(cad_mesh));
}

TYPED_TEST_P(Every_editable_mesh_type, splits_overconstrained_faces_of_closed_surfaces)
{
  Cad_mesh<TypeParam> cad_mesh(cube(), false);
  EXPECT_EQ(12u, split_overconstrained_faces(cad_mesh));
  this->expect_triangle_mesh(cad_mesh, 36);
  expect_valid_field(cad_mesh.cut(), frame_field(cad_mesh));
}

TYPED_TEST_P(Every_editable_mesh_type, splits_chords_at_their_midpoints)
{
  Cad_mesh<TypeParam> cad_mesh(rounded_split_model(annulus(12, 1)), false);
  const Cut before = cad_mesh.cut();
  std::vector<Point> expected = this->sorted_points(cad_mesh);
  std::size_t number_of_chords = 0;
  for(int h = 0; h < before.number_of_halfedges(); ++h)
    if(!before.is_constrained(h) && h < before.opposite[h]
       && before.is_constrained_sector[before.sector[h]]
       && before.is_constrained_sector[before.sector[before.opposite[h]]])
    {
      expected.push_back(CGAL::midpoint(before.points[h], before.points[before.opposite[h]]));
      ++number_of_chords;
    }
  std::sort(expected.begin(), expected.end());

  EXPECT_EQ(number_of_chords, split_chords(cad_mesh));
  EXPECT_GT(number_of_chords, 0u);
  EXPECT_EQ(expected, this->sorted_points(cad_mesh));
  this->expect_triangle_mesh(cad_mesh, before.number_of_faces() + 2 * number_of_chords);
  EXPECT_EQ(0u, split_chords(cad_mesh));
  split_overconstrained_faces(cad_mesh);
  expect_valid_field(cad_mesh.cut(), frame_field(cad_mesh));
}

TYPED_TEST_P(Every_editable_mesh_type, reads_points_from_the_given_map)
{
  Cad_mesh<TypeParam> cad_mesh(rounded_split_model(quilt()));
  const Frames expected = frames_of(cad_mesh.cut(), frame_field(cad_mesh));
  typedef typename boost::graph_traits<typename Cad_mesh<TypeParam>::Mesh>::vertex_descriptor Vertex;
  typedef std::unordered_map<Vertex, Point> Points;
  const Cut cut = cad_mesh.cut();
  Points points;
  for(const Vertex v : vertices(cad_mesh.mesh))
    points[v] = cad_mesh.point(v);
  const auto own_points = get(CGAL::vertex_point, cad_mesh.mesh);
  for(const Vertex v : vertices(cad_mesh.mesh))
    put(own_points, v, typename boost::property_traits<decltype(own_points)>::value_type(0, 0, 0));

  const Maps<typename Cad_mesh<TypeParam>::Mesh> maps(cad_mesh.mesh);
  const boost::const_associative_property_map<Points> point_map(points);
  ASSERT_TRUE(FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
                                  cad_mesh.features().vertex_point_map(point_map)));
  Field field;
  for(const auto f : faces(cad_mesh.mesh))
    field.branches.push_back(FF::frame_vectors(cad_mesh.mesh, f, get(maps.alpha, f), get(maps.rho, f),
                                               parameters::vertex_point_map(point_map)));
  for_each_halfedge(cad_mesh.mesh, [&](const auto h) { field.index.push_back(get(maps.index, h)); });
  expect_same(expected, frames_of(cut, field));
}

REGISTER_TYPED_TEST_SUITE_P(Every_editable_mesh_type, splits_overconstrained_faces_at_their_centroids,
                            splits_overconstrained_faces_of_closed_surfaces, splits_chords_at_their_midpoints,
                            reads_points_from_the_given_map);

} // namespace test

#endif // TEST_FRAME_FIELDS_TEST_MESH_MATRIX_H
