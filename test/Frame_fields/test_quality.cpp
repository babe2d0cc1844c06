#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/frame_field_quality.h>
#include <CGAL/Frame_fields/singularities.h>
#include <CGAL/Frame_fields/split_chords.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <iterator>

// Figures of fields, the mesh-independent support and weights, and the split of chords.
namespace {

using namespace test;

template <typename Mesh>
class Quality : public testing::Test
{
protected:
  struct Measured_field
  {
    Field field;
    FF::Field_quality quality;
    std::vector<FF::Singularity<typename boost::graph_traits<Mesh>::halfedge_descriptor> > singularities;
  };

  template <typename NamedParameters>
  static Measured_field measured_field(const Cad_mesh<Mesh>& cad_mesh, const NamedParameters& np)
  {
    const Maps<Mesh> maps(cad_mesh.mesh);
    Measured_field result;
    const auto all = parameters::join(np, cad_mesh.features().matching_map(maps.matching)
                                                   .statistics(std::ref(result.field.statistics)));
    FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index, all);
    EXPECT_TRUE(FF::frame_field_quality(cad_mesh.mesh, maps.alpha, maps.rho, maps.matching, result.quality, all));
    EXPECT_TRUE(FF::singularities(cad_mesh.mesh, maps.index, std::back_inserter(result.singularities),
                                  cad_mesh.features()));
    const FF::Statistics statistics = result.field.statistics;
    result.field = to_field(cad_mesh, maps);
    result.field.statistics = statistics;
    return result;
  }
};

TYPED_TEST_SUITE(Quality, Mesh_classes, Mesh_class_names);

TYPED_TEST(Quality, figures_are_those_of_the_field)
{
  for(const FF::Edge_weighting weighting : { FF::UNIFORM_WEIGHTS, FF::PRIMAL_OVER_DUAL_LENGTH })
  {
    const Cad_mesh<TypeParam> cad_mesh(quilt());
    const auto measured = this->measured_field(cad_mesh, parameters::edge_weighting(weighting));
    EXPECT_NEAR(measured.field.statistics.energy_relaxed, measured.quality.energy, 1e-9 * measured.quality.energy);
    EXPECT_EQ(largest(measured.field.rho), measured.quality.maximum_skewness);
    EXPECT_LT(measured.quality.maximum_misalignment, 1e-9);
    EXPECT_LE(measured.quality.mean_rotation, measured.quality.maximum_rotation);
    EXPECT_LE(measured.quality.mean_skewness, measured.quality.maximum_skewness);
    EXPECT_GT(measured.quality.curl, 0);
  }
}

TYPED_TEST(Quality, parallel_field_has_neither_rotation_nor_curl)
{
  const Cad_mesh<TypeParam> cad_mesh(square(6));
  const FF::Field_quality quality = this->measured_field(cad_mesh, cad_mesh.features()).quality;
  EXPECT_LT(quality.energy, 1e-20);
  EXPECT_LT(quality.maximum_rotation, 1e-9);
  EXPECT_LT(quality.curl, 1e-9);
  EXPECT_LT(quality.maximum_skewness, 1e-9);
}

TYPED_TEST(Quality, singularities_are_the_sectors_with_an_index)
{
  const Cad_mesh<TypeParam> cad_mesh(star({ 10, 20, 30, 15 }));
  const auto measured = this->measured_field(cad_mesh, cad_mesh.features());
  const Cut cut = cad_mesh.cut();
  const std::vector<int> index = index_of_sectors(cut, measured.field.index);
  EXPECT_EQ(index.size() - std::count(index.begin(), index.end(), 0), measured.singularities.size());
  for(const auto& singularity : measured.singularities)
  {
    EXPECT_NE(0, singularity.index);
    EXPECT_EQ(singularity.is_constrained, singularity.distance_to_features == 0);
    // In the plane, no path to the border is shorter than the distance to the nearest of its vertices.
    const Point p = cad_mesh.point(target(singularity.halfedge, cad_mesh.mesh));
    double least = std::numeric_limits<double>::infinity();
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      if(cut.is_constrained_sector[cut.sector[h]])
        least = (std::min)(least, std::sqrt(CGAL::squared_distance(p, cut.points[h])));
    EXPECT_GE(singularity.distance_to_features, least * (1 - 1e-12));
    EXPECT_LE(singularity.distance_to_features, 1.1 * least);
  }
}

// K is taken from sectors within the radius, and only from there.
TYPED_TEST(Quality, radius_bounds_the_support)
{
  const Cad_mesh<TypeParam> cad_mesh(wedge(20, 0.04));
  const Cut cut = cad_mesh.cut();
  const double radius = 0.45;
  for(const FF::Edge_weighting weighting : { FF::UNIFORM_WEIGHTS, FF::PRIMAL_OVER_DUAL_LENGTH })
  {
    const Field field = frame_field(cad_mesh, parameters::support_strategy(FF::Support_strategy::radius(radius))
                                                .edge_weighting(weighting).sharp_corner_bound(45 * degree));
    const std::vector<double> rotation = cut.sums_around_sectors(field.omega);
    const int tip = constrained_sectors_below(cut, 45 * degree).front();
    EXPECT_NEAR(cut.theta[tip] - 90 * degree, rotation[tip], 1e-10);
    Point tip_point(0, 0, 0);
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      if(cut.sector[h] == tip)
        tip_point = cut.points[h];
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
    {
      const double distance = std::sqrt(CGAL::squared_distance(tip_point, cut.points[h]));
      if(distance > radius * (1 + 1e-9))
      {
        EXPECT_NEAR(0, rotation[cut.sector[h]], 1e-10);
      }
      else if(cut.sector[h] != tip && distance < 0.9 * radius)
      {
        EXPECT_GT(rotation[cut.sector[h]], 0);
      }
    }
  }
}

TYPED_TEST(Quality, weights_do_not_depend_on_the_unit_of_length)
{
  const Model model = quilt();
  const auto np = parameters::edge_weighting(FF::PRIMAL_OVER_DUAL_LENGTH)
                    .support_strategy(FF::Support_strategy::radius());
  const Field field = frame_field(Cad_mesh<TypeParam>(model), np);
  for(const double scale : { 1e-6, 1e6 })
  {
    const Model scaled = transformed(model, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); });
    const Field scaled_field = frame_field(Cad_mesh<TypeParam>(scaled), np);
    EXPECT_EQ(field.index, scaled_field.index);
    EXPECT_LT(largest_branch_distance(field.branches, scaled_field.branches), 1e-6);
  }
}

TYPED_TEST(Quality, no_chord_is_left)
{
  Cad_mesh<TypeParam> cad_mesh(wedge(3, 0.5), false);
  const double area = CGAL::Polygon_mesh_processing::area(cad_mesh.mesh);
  const std::size_t number_of_faces = cad_mesh.cut().number_of_faces();
  const std::size_t number_of_chords = FF::split_chords(cad_mesh.mesh, cad_mesh.features());
  EXPECT_GT(number_of_chords, 0u);
  EXPECT_EQ(number_of_faces + 2 * number_of_chords, static_cast<std::size_t>(cad_mesh.cut().number_of_faces()));
  EXPECT_EQ(0u, FF::split_chords(cad_mesh.mesh, cad_mesh.features()));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cad_mesh.mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(cad_mesh.mesh));
  EXPECT_NEAR(area, CGAL::Polygon_mesh_processing::area(cad_mesh.mesh), 1e-12);
  FF::split_overconstrained_faces(cad_mesh.mesh, cad_mesh.features());
  EXPECT_EQ(FF::OK, frame_field(cad_mesh).result.error_code);
}

} // namespace
