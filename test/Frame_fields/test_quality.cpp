#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/Edge_weighting.h>
#include <CGAL/Frame_fields/frame_field_quality.h>
#include <CGAL/Frame_fields/singularities.h>
#include <CGAL/Frame_fields/split_chords.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

// Figures of fields, the mesh-independent support and weights, and the split of chords.
namespace {

using namespace test;

constexpr double turn = 360 * degree;

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
    EXPECT_TRUE(FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index, all));
    EXPECT_TRUE(FF::frame_field_quality(cad_mesh.mesh, maps.alpha, maps.rho, maps.matching,
                                        all.quality(std::ref(result.quality))));
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
  for(const FF::Edge_weighting weighting : { FF::Edge_weighting::UNIFORM, FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH })
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

// The rotation of a branch is what is between its angle to the edge and that of the branch it is matched to.
TYPED_TEST(Quality, rotations_turn_branches_into_the_matched_ones)
{
  typedef typename boost::graph_traits<TypeParam>::halfedge_descriptor Halfedge;
  for(const bool is_relaxed : { false, true })
  {
    const Cad_mesh<TypeParam> cad_mesh(quilt());
    const TypeParam& mesh = cad_mesh.mesh;
    const Maps<TypeParam> maps(mesh);
    const auto np = cad_mesh.features().relax_orthogonality(is_relaxed).matching_map(maps.matching);
    ASSERT_TRUE(FF::cad_frame_field(mesh, maps.alpha, maps.rho, maps.index, np));
    const auto rotations = get(CGAL::dynamic_halfedge_property_t<std::array<double, 2> >(), mesh);
    FF::Field_quality quality;
    ASSERT_TRUE(FF::frame_field_quality(mesh, maps.alpha, maps.rho, maps.matching,
                                        np.rotation_map(rotations).quality(std::ref(quality))));

    const auto angle_to_edge = [&](const Halfedge h, const Halfedge edge, const int branch)
    {
      const auto f = face(h, mesh);
      const auto branches = FF::frame_vectors(mesh, f, get(maps.alpha, f), get(maps.rho, f));
      const Vector along = cad_mesh.point(target(edge, mesh)) - cad_mesh.point(source(edge, mesh));
      const Vector normal = CGAL::normal(cad_mesh.point(source(h, mesh)), cad_mesh.point(target(h, mesh)),
                                         cad_mesh.point(target(next(h, mesh), mesh)));
      const Vector b = branches[(branch % 4 + 4) % 4];
      return std::atan2(CGAL::cross_product(along, b) * normal / std::sqrt(normal.squared_length()), along * b);
    };
    double energy = 0;
    for_each_halfedge(mesh, [&](const Halfedge h)
    {
      const std::array<double, 2> r = get(rotations, h);
      if(is_border(opposite(h, mesh), mesh) || get(cad_mesh.is_feature, edge(h, mesh)))
      {
        EXPECT_EQ((std::array<double, 2>{ 0, 0 }), r);
        return;
      }
      const int p = get(maps.matching, h);
      const std::array<double, 2> from_opposite = get(rotations, opposite(h, mesh));
      for(int k = 0; k < 2; ++k)
      {
        const double turned = angle_to_edge(opposite(h, mesh), h, k + p) - angle_to_edge(h, h, k);
        EXPECT_NEAR(0, std::remainder(turned - r[k], turn), 1e-9);
        EXPECT_EQ(-r[k], from_opposite[(k + p) & 1]);
        energy += r[k] * r[k] / 2;
        if(!is_relaxed)
        {
          EXPECT_EQ(r[0], r[1]);
        }
      }
    });
    EXPECT_NEAR(quality.energy, energy, 1e-9 * energy);
  }
}

// 2 pi I = sum r - theta + 2 pi, or + pi on a constrained edge.
TYPED_TEST(Quality, rotations_of_an_orthogonal_field_sum_to_the_indices)
{
  const Cad_mesh<TypeParam> cad_mesh(star({ 10, 20, 30, 15 }));
  const Maps<TypeParam> maps(cad_mesh.mesh);
  const auto np = cad_mesh.features().relax_orthogonality(false).matching_map(maps.matching);
  ASSERT_TRUE(FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index, np));
  const auto rotations = get(CGAL::dynamic_halfedge_property_t<std::array<double, 2> >(), cad_mesh.mesh);
  FF::Field_quality quality;
  ASSERT_TRUE(FF::frame_field_quality(cad_mesh.mesh, maps.alpha, maps.rho, maps.matching,
                                      np.rotation_map(rotations).quality(std::ref(quality))));
  std::vector<double> r;
  std::vector<int> index;
  for_each_halfedge(cad_mesh.mesh, [&](const auto h)
  {
    r.push_back(get(rotations, h)[0]);
    index.push_back(get(maps.index, h));
  });
  const Cut cut = cad_mesh.cut();
  const std::vector<double> sums = cut.sums_around_sectors(r);
  const std::vector<int> index_of_sector = index_of_sectors(cut, index);
  for(int s = 0; s < cut.number_of_sectors(); ++s)
    EXPECT_NEAR(turn * index_of_sector[s] / 4,
                sums[s] - cut.theta[s] + (cut.is_constrained_sector[s] ? turn / 2 : turn), 1e-9);
}

// K is taken from the triangles that the ball of the radius meets, and only from there.
TYPED_TEST(Quality, radius_bounds_the_support)
{
  const Cad_mesh<TypeParam> cad_mesh(wedge(20, 0.04));
  const Cut cut = cad_mesh.cut();
  const double radius = 0.45;
  for(const FF::Edge_weighting weighting : { FF::Edge_weighting::UNIFORM, FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH })
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
    const auto distance = [&](const int h) { return std::sqrt(CGAL::squared_distance(tip_point, cut.points[h])); };
    std::vector<double> nearest(cut.number_of_sectors(), std::numeric_limits<double>::infinity());
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      for(const int corner : { h, next_of(h), previous_of(h) })
        nearest[cut.sector[h]] = (std::min)(nearest[cut.sector[h]], distance(corner));
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
    {
      if(nearest[cut.sector[h]] > radius * (1 + 1e-9))
      {
        EXPECT_NEAR(0, rotation[cut.sector[h]], 1e-10);
      }
      else if(cut.sector[h] != tip && distance(h) < radius)
      {
        EXPECT_GT(rotation[cut.sector[h]], 0);
      }
    }
  }
}

// The receivers' parts are integrals over the ball, so that their center is that of the circular sector, up to the
// square of the edge length, wherever the rim cuts the triangles.
TYPED_TEST(Quality, radius_takes_evenly_from_the_ball)
{
  const double angle = 20, edge_length = 0.04;
  const Cad_mesh<TypeParam> cad_mesh(wedge(angle, edge_length));
  const Cut cut = cad_mesh.cut();
  const int tip = constrained_sectors_below(cut, 45 * degree).front();
  std::vector<Point> place(cut.number_of_sectors());
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    place[cut.sector[h]] = cut.points[h];
  for(double radius = 0.3; radius < 0.6; radius += 0.01)
  {
    const Field field = frame_field(cad_mesh, parameters::support_strategy(FF::Support_strategy::radius(radius))
                                                .sharp_corner_bound(45 * degree));
    const std::vector<double> rotation = cut.sums_around_sectors(field.omega);
    double sum = 0, moment = 0;
    for(int s = 0; s < cut.number_of_sectors(); ++s)
      if(s != tip)
      {
        sum += rotation[s];
        moment += rotation[s] * std::sqrt(CGAL::squared_distance(place[tip], place[s]));
      }
    EXPECT_NEAR(2. / 3 * radius, moment / sum, edge_length * edge_length / radius) << "radius " << radius;
  }
}

TYPED_TEST(Quality, weights_do_not_depend_on_the_unit_of_length)
{
  const Model model = quilt();
  const auto np = parameters::edge_weighting(FF::Edge_weighting::PRIMAL_OVER_DUAL_LENGTH)
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
  const std::size_t number_of_chords = split_chords(cad_mesh);
  EXPECT_GT(number_of_chords, 0u);
  EXPECT_EQ(number_of_faces + 2 * number_of_chords, static_cast<std::size_t>(cad_mesh.cut().number_of_faces()));
  EXPECT_EQ(0u, split_chords(cad_mesh));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cad_mesh.mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(cad_mesh.mesh));
  EXPECT_NEAR(area, CGAL::Polygon_mesh_processing::area(cad_mesh.mesh), 1e-12);
  split_overconstrained_faces(cad_mesh);
  EXPECT_EQ(FF::OK, frame_field(cad_mesh).result.error_code);
}

} // namespace
