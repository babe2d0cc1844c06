#include <CGAL/Frame_fields/quad_mesh_quality.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// The figures of quad meshes that are a mesh class.
namespace {

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
namespace FF = CGAL::Frame_fields;

struct Cube
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> features;

  // The faces of a cube of the given side, each of n x n quads.
  Cube(const int n, const double side)
  {
    features = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
    std::vector<Mesh::Vertex_index> vertex_at((n + 1) * (n + 1) * (n + 1));
    const auto vertex = [&](const int x, const int y, const int z)
    {
      Mesh::Vertex_index& v = vertex_at[(x * (n + 1) + y) * (n + 1) + z];
      if(v == Mesh::null_vertex())
        v = mesh.add_vertex(Point(side * x / n, side * y / n, side * z / n));
      return v;
    };
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
      {
        mesh.add_face(vertex(i, j, 0), vertex(i, j + 1, 0), vertex(i + 1, j + 1, 0), vertex(i + 1, j, 0));
        mesh.add_face(vertex(i, j, n), vertex(i + 1, j, n), vertex(i + 1, j + 1, n), vertex(i, j + 1, n));
        mesh.add_face(vertex(i, 0, j), vertex(i + 1, 0, j), vertex(i + 1, 0, j + 1), vertex(i, 0, j + 1));
        mesh.add_face(vertex(i, n, j), vertex(i, n, j + 1), vertex(i + 1, n, j + 1), vertex(i + 1, n, j));
        mesh.add_face(vertex(0, i, j), vertex(0, i, j + 1), vertex(0, i + 1, j + 1), vertex(0, i + 1, j));
        mesh.add_face(vertex(n, i, j), vertex(n, i + 1, j), vertex(n, i + 1, j + 1), vertex(n, i, j + 1));
      }
    for(const Mesh::Edge_index e : mesh.edges())
    {
      const Point p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
      int number_of_sides = 0; // of the cube that both ends are on
      for(int k = 0; k < 3; ++k)
        number_of_sides += p[k] == q[k] && (p[k] == 0 || p[k] == side);
      features[e] = number_of_sides == 2;
    }
  }
};

TEST(Quad_mesh_quality, cube_with_and_without_its_features)
{
  for(const double side : { 1., 1e-200, 1e200 })
  {
    const Cube cube(4, side);
    FF::Quad_quality quality;
    ASSERT_TRUE(FF::quad_mesh_quality(cube.mesh, FF::parameters::quality(std::ref(quality))));
    EXPECT_EQ(quality.number_of_quads, 96u);
    EXPECT_EQ(quality.number_of_other_faces, 0u);
    EXPECT_NEAR(quality.minimum_scaled_jacobian, 1, 1e-15);
    EXPECT_NEAR(quality.mean_scaled_jacobian, 1, 1e-15);
    EXPECT_EQ(quality.number_of_irregular_vertices, 8u); // the corners
    EXPECT_EQ(quality.number_of_irregular_sectors, 0u);
    EXPECT_NEAR(quality.minimum_edge_length, side / 4, 1e-15 * side);
    EXPECT_NEAR(quality.mean_edge_length, side / 4, 1e-15 * side);
    EXPECT_NEAR(quality.maximum_edge_length, side / 4, 1e-15 * side);
    ASSERT_TRUE(FF::quad_mesh_quality(
      cube.mesh, FF::parameters::edge_is_constrained_map(cube.features).quality(std::ref(quality))));
    EXPECT_EQ(quality.number_of_irregular_vertices, 0u);
    EXPECT_EQ(quality.number_of_irregular_sectors, 0u);
  }
}

// A pyramid over a square that is cut off at the border: four triangles and one quad that is not convex.
TEST(Quad_mesh_quality, bad_quads_and_other_faces)
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(2, 0, 0));
  const auto c = mesh.add_vertex(Point(0.5, 0.5, 0)), d = mesh.add_vertex(Point(0, 2, 0));
  const auto e = mesh.add_vertex(Point(2, 2, 0));
  mesh.add_face(a, b, c, d);
  mesh.add_face(b, e, c);
  mesh.add_face(c, e, d);
  FF::Quad_quality quality;
  ASSERT_TRUE(FF::quad_mesh_quality(mesh, FF::parameters::quality(std::ref(quality))));
  EXPECT_EQ(quality.number_of_quads, 1u);
  EXPECT_EQ(quality.number_of_other_faces, 2u);
  EXPECT_EQ(quality.number_of_inverted_quads, 1u);
  EXPECT_EQ(quality.number_of_bad_quads, 1u);
  EXPECT_NEAR(quality.minimum_scaled_jacobian, (0.25 - 2.25) / 2.5, 1e-15);
  EXPECT_EQ(quality.number_of_irregular_vertices, 1u); // c
  EXPECT_NEAR(quality.minimum_edge_length, std::sqrt(2.5), 1e-15);
}

TEST(Quad_mesh_quality, what_is_not_finite_is_refused)
{
  Cube cube(2, 1);
  cube.mesh.point(*cube.mesh.vertices().begin()) = Point(0, std::numeric_limits<double>::infinity(), 0);
  FF::Quad_quality quality;
  quality.number_of_quads = 7;
  EXPECT_EQ(FF::quad_mesh_quality(cube.mesh, FF::parameters::quality(std::ref(quality))).error_code,
            FF::ERROR_NON_FINITE_COORDINATE);
  EXPECT_EQ(quality.number_of_quads, 7u);
  ASSERT_TRUE(FF::quad_mesh_quality(Mesh(), FF::parameters::quality(std::ref(quality))));
  EXPECT_EQ(quality.number_of_quads, 0u);
  EXPECT_EQ(quality.maximum_edge_length, 0);
}

} // namespace
