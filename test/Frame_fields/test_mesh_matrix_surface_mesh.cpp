#include "test_mesh_matrix.h"

namespace test {

// A point that is none of CGAL's, and how to make one of a kernel of it.
struct Own_point
{
  Own_point() = default;
  Own_point(const double x, const double y, const double z) : coordinates{ x, y, z } {}

  std::array<double, 3> coordinates;
};

struct Own_point_map
{
  typedef CGAL::Surface_mesh<Own_point> Mesh;
  typedef Mesh::Vertex_index key_type;
  typedef EPICK::Point_3 value_type;
  typedef value_type reference;
  typedef boost::read_write_property_map_tag category;

  friend value_type get(const Own_point_map& map, const key_type v)
  {
    const std::array<double, 3>& p = map.points[v].coordinates;
    return value_type(p[0], p[1], p[2]);
  }
  friend void put(const Own_point_map& map, const key_type v, const value_type& p)
  {
    map.points[v] = Own_point(p.x(), p.y(), p.z());
  }

  Mesh::Property_map<key_type, Own_point> points;
};

template <>
struct Mesh_of_model<CGAL::Surface_mesh<Own_point> > : Mesh_with_points<CGAL::Surface_mesh<Own_point> >
{
  explicit Mesh_of_model(const Model& model) { add_triangles(model, mesh, points()); }

  Own_point_map points() const { return { mesh.points() }; }
  template <typename NamedParameters>
  auto with_points(const NamedParameters& np) const { return np.vertex_point_map(points()); }
};

Frames frames_on_surface_mesh(const Model& model)
{
  const Cad_mesh<CGAL::Surface_mesh<EPICK::Point_3> > cad_mesh(model);
  return frames_of(cad_mesh.cut(), frame_field(cad_mesh));
}

} // namespace test

namespace {

using namespace test;

typedef testing::Types<CGAL::Surface_mesh<EPICK::Point_3>, CGAL::Surface_mesh<EPECK::Point_3>,
                       CGAL::Surface_mesh<Kernel::Point_3>, CGAL::Surface_mesh<Float_kernel::Point_3>,
                       CGAL::Surface_mesh<Own_point> > Surface_meshes;

struct Names
{
  template <typename>
  static std::string GetName(const int i)
  {
    return std::array<const char*, 5>{ "Surface_mesh_of_EPICK", "Surface_mesh_of_EPECK", "Surface_mesh_of_double",
                                       "Surface_mesh_of_float", "Surface_mesh_of_own_point" }[i];
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Surface_mesh, Every_mesh_type, Surface_meshes, Names);
INSTANTIATE_TYPED_TEST_SUITE_P(Surface_mesh, Every_editable_mesh_type, Surface_meshes, Names);

TEST(Surface_mesh, takes_property_maps_of_its_own)
{
  Cad_mesh<Surface_mesh> cad_mesh(quilt());
  const auto alpha = cad_mesh.mesh.add_property_map<Surface_mesh::Face_index, double>("f:alpha").first;
  const auto rho = cad_mesh.mesh.add_property_map<Surface_mesh::Face_index, double>("f:rho").first;
  const auto index = cad_mesh.mesh.add_property_map<Surface_mesh::Halfedge_index, int>("h:index").first;
  ASSERT_TRUE(FF::cad_frame_field(cad_mesh.mesh, alpha, rho, index, cad_mesh.features()));
  const Field expected = frame_field(cad_mesh);
  for(const Surface_mesh::Face_index f : cad_mesh.mesh.faces())
  {
    EXPECT_EQ(expected.alpha[f], alpha[f]);
    EXPECT_EQ(expected.rho[f], rho[f]);
  }
}

} // namespace
