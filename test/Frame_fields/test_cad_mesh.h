#ifndef TEST_FRAME_FIELDS_TEST_CAD_MESH_H
#define TEST_FRAME_FIELDS_TEST_CAD_MESH_H

#include "compiled_stages.h"
#include "test_cut.h"
#include "test_models.h"

#include <CGAL/Frame_fields/cad_frame_field.h>
#include <CGAL/Frame_fields/frame_vectors.h>
#include <CGAL/Frame_fields/parameters.h>
#include <CGAL/Frame_fields/split_chords.h>
#include <CGAL/Frame_fields/split_overconstrained_faces.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>
#include <vector>

// From models to the meshes of CGAL, and from property maps to the arrays of the tests.
namespace test {

namespace FF = CGAL::Frame_fields;
namespace parameters = CGAL::Frame_fields::parameters;

typedef CGAL::Surface_mesh<Point> Surface_mesh;
typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
typedef testing::Types<Surface_mesh, Polyhedron> Mesh_classes;

struct Mesh_class_names
{
  template <typename Mesh>
  static std::string GetName(int) { return std::is_same<Mesh, Surface_mesh>::value ? "Surface_mesh" : "Polyhedron"; }
};

template <typename Mesh, typename Value>
using Face_map = typename boost::property_map<Mesh, CGAL::dynamic_face_property_t<Value> >::const_type;
template <typename Mesh, typename Value>
using Halfedge_map = typename boost::property_map<Mesh, CGAL::dynamic_halfedge_property_t<Value> >::const_type;

// Calls `visit(h)` in the order in which the tests number halfedges.
template <typename Mesh, typename Visit>
void for_each_halfedge(const Mesh& mesh, const Visit& visit)
{
  for(const auto f : faces(mesh))
  {
    auto h = halfedge(f, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh))
      visit(h);
  }
}

template <typename Mesh, typename Point_map>
void add_triangles(const Model& model, Mesh& mesh, const Point_map point_map)
{
  std::vector<typename boost::property_traits<Point_map>::value_type> points;
  for(const Point& p : model.points)
    points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(
    points, model.triangles, mesh, CGAL::parameters::default_values(),
    CGAL::parameters::vertex_point_map(point_map));
}

// A mesh and what a caller passes for its points.
template <typename Mesh_>
struct Mesh_with_points
{
  typedef Mesh_ Mesh;
  typedef bool Mark; // of feature edges
  static constexpr bool is_editable = true;

  template <typename... Arguments>
  explicit Mesh_with_points(Arguments&&... arguments) : mesh(std::forward<Arguments>(arguments)...) {}

  auto points() const { return get(CGAL::vertex_point, mesh); }
  template <typename NamedParameters>
  NamedParameters with_points(const NamedParameters& np) const { return np; }

  Mesh mesh;
};

// A mesh made of a model. Specialized for meshes that stand on another mesh or need named parameters.
template <typename Mesh>
struct Mesh_of_model : Mesh_with_points<Mesh>
{
  explicit Mesh_of_model(const Model& model)
  {
    add_triangles(model, this->mesh, get(CGAL::vertex_point, this->mesh));
  }
};

// A mesh with marked feature edges.
template <typename MeshType>
struct Cad_mesh : Mesh_of_model<MeshType>
{
  typedef Mesh_of_model<MeshType> Base;
  typedef typename Base::Mesh Mesh;
  typedef boost::graph_traits<Mesh> Graph_traits;
  typedef CGAL::dynamic_edge_property_t<typename Base::Mark> Edge_property;
  typedef typename boost::property_map<Mesh, Edge_property>::type Edge_map;

  using Base::mesh;
  Edge_map is_feature;

  explicit Cad_mesh(const Model& model, const bool splits_overconstrained_faces = true)
    : Base(model), is_feature(get(Edge_property(), mesh))
  {
    const std::set<std::pair<Point, Point> > segments(model.features.begin(), model.features.end());
    for(const auto e : edges(mesh))
      put(is_feature, e, segments.count(segment(point(source(e, mesh)), point(target(e, mesh)))) > 0);
    if constexpr(Base::is_editable)
    {
      if(splits_overconstrained_faces)
      {
        EXPECT_TRUE(FF::split_overconstrained_faces(mesh, features()));
      }
    }
  }

  Cad_mesh(const Cad_mesh&) = delete;
  Cad_mesh& operator=(const Cad_mesh&) = delete;

  Point point(const typename Graph_traits::vertex_descriptor v) const
  {
    const auto p = get(Base::points(), v);
    return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  // The points in `double` as a property map.
  auto double_points() const
  {
    return boost::make_function_property_map<typename Graph_traits::vertex_descriptor, Point>(
      [this](const typename Graph_traits::vertex_descriptor v) { return point(v); });
  }

  auto features() const { return Base::with_points(parameters::edge_is_constrained_map(is_feature)); }

  Cut cut() const
  {
    const auto number = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
    int count = 0;
    for_each_halfedge(mesh, [&](const auto h) { put(number, h, count++); });
    std::vector<Point> points;
    std::vector<int> opposites;
    for_each_halfedge(mesh, [&](const auto h)
    {
      const bool is_constrained = CGAL::is_border(opposite(h, mesh), mesh) || get(is_feature, edge(h, mesh));
      points.push_back(point(target(h, mesh)));
      opposites.push_back(is_constrained ? -1 : get(number, opposite(h, mesh)));
    });
    return Cut(std::move(points), std::move(opposites));
  }

  // The mesh as it is, its faces and their halfedges in the same order.
  Model model() const
  {
    Model result;
    const auto number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
    for(const auto v : vertices(mesh))
    {
      put(number, v, result.points.size());
      result.points.push_back(point(v));
    }
    for(const auto f : faces(mesh))
    {
      const auto h = halfedge(f, mesh);
      result.triangles.push_back({ get(number, source(h, mesh)), get(number, target(h, mesh)),
                                   get(number, target(next(h, mesh), mesh)) });
    }
    for(const auto e : edges(mesh))
      if(get(is_feature, e))
        result.features.push_back(segment(point(source(e, mesh)), point(target(e, mesh))));
    return result;
  }
};

// The number of faces that are split.
template <typename CadMesh>
std::size_t split_overconstrained_faces(CadMesh& cad_mesh)
{
  FF::Refinement_statistics statistics;
  EXPECT_TRUE(FF::split_overconstrained_faces(cad_mesh.mesh, cad_mesh.features().statistics(std::ref(statistics))));
  return statistics.number_of_split_faces;
}

// The number of edges that are split.
template <typename CadMesh>
std::size_t split_chords(CadMesh& cad_mesh)
{
  FF::Refinement_statistics statistics;
  EXPECT_TRUE(FF::split_chords(cad_mesh.mesh, cad_mesh.features().statistics(std::ref(statistics))));
  return statistics.number_of_splits;
}

// The output maps of all functions.
template <typename Mesh>
struct Maps
{
  explicit Maps(const Mesh& mesh)
    : alpha(get(CGAL::dynamic_face_property_t<double>(), mesh))
    , rho(get(CGAL::dynamic_face_property_t<double>(), mesh))
    , index(get(CGAL::dynamic_halfedge_property_t<int>(), mesh))
    , matching(get(CGAL::dynamic_halfedge_property_t<int>(), mesh))
    , omega(get(CGAL::dynamic_halfedge_property_t<double>(), mesh))
  {}

  Face_map<Mesh, double> alpha, rho;
  Halfedge_map<Mesh, int> index, matching;
  Halfedge_map<Mesh, double> omega;
};

template <typename MeshType>
Field to_field(const Cad_mesh<MeshType>& cad_mesh, const Maps<typename Cad_mesh<MeshType>::Mesh>& maps)
{
  Field result;
  for(const auto f : faces(cad_mesh.mesh))
  {
    result.alpha.push_back(get(maps.alpha, f));
    result.rho.push_back(get(maps.rho, f));
    result.branches.push_back(FF::frame_vectors(cad_mesh.mesh, f, result.alpha.back(), result.rho.back(),
                                                parameters::vertex_point_map(cad_mesh.double_points())));
  }
  for_each_halfedge(cad_mesh.mesh, [&](const auto h)
  {
    result.index.push_back(get(maps.index, h));
    result.matching.push_back(get(maps.matching, h));
    result.omega.push_back(get(maps.omega, h));
  });
  return result;
}

// Calls `cad_frame_field()` for all its outputs.
template <typename MeshType, typename NamedParameters>
Field frame_field(const Cad_mesh<MeshType>& cad_mesh, const NamedParameters& np)
{
  const Maps<typename Cad_mesh<MeshType>::Mesh> maps(cad_mesh.mesh);
  FF::Statistics statistics;
  const FF::Result result = FF::cad_frame_field(
    cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
    parameters::join(np, cad_mesh.features().matching_map(maps.matching).prescribed_rotation_map(maps.omega)
                                            .statistics(std::ref(statistics))));
  EXPECT_EQ(FF::OK, result.error_code) << result.message;
  Field field = to_field(cad_mesh, maps);
  field.result = result;
  field.statistics = statistics;
  return field;
}

template <typename Mesh>
Field frame_field(const Cad_mesh<Mesh>& cad_mesh)
{
  return frame_field(cad_mesh, cad_mesh.features());
}

template <typename Mesh>
Field frame_field(const Cad_mesh<Mesh>& cad_mesh, const FF::Support_strategy& strategy)
{
  return frame_field(cad_mesh, parameters::support_strategy(strategy));
}

// The field before relaxation.
template <typename Mesh>
Field orthogonal_field(const Cad_mesh<Mesh>& cad_mesh)
{
  return frame_field(cad_mesh, parameters::relax_orthogonality(false));
}

// What most tests call is compiled once, in test_cad_mesh.cpp. The macro declares or defines it.
#define TEST_FRAME_FIELDS_CAD_MESH(EXTERN_OR_NOTHING, Mesh)                                                            \
  EXTERN_OR_NOTHING template struct Cad_mesh<Mesh>;                                                                    \
  EXTERN_OR_NOTHING template Field to_field(const Cad_mesh<Mesh>&, const Maps<Mesh>&);                                 \
  EXTERN_OR_NOTHING template Field frame_field(const Cad_mesh<Mesh>&);                                                 \
  EXTERN_OR_NOTHING template Field frame_field(const Cad_mesh<Mesh>&, const FF::Support_strategy&);                    \
  EXTERN_OR_NOTHING template Field orthogonal_field(const Cad_mesh<Mesh>&);
TEST_FRAME_FIELDS_CAD_MESH(extern, Surface_mesh)
TEST_FRAME_FIELDS_CAD_MESH(extern, Polyhedron)

// Calls `check` on the model as a mesh of each class.
template <typename Check>
void on_each_mesh_class(const Model& model, const Check& check)
{
  {
    SCOPED_TRACE("Surface_mesh");
    check(Cad_mesh<Surface_mesh>(model));
  }
  {
    SCOPED_TRACE("Polyhedron_3");
    check(Cad_mesh<Polyhedron>(model));
  }
}

// Tests with a model as parameter; models on file may be missing.
class On_models : public testing::TestWithParam<Named_model>
{
protected:
  void SetUp() override
  {
    if(!GetParam().is_available())
      GTEST_SKIP() << GetParam().file << " is missing";
  }
};

struct Model_name
{
  std::string operator()(const testing::TestParamInfo<Named_model>& info) const { return info.param.name; }
};

} // namespace test

#endif // TEST_FRAME_FIELDS_TEST_CAD_MESH_H
