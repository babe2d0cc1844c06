#include "random_models.h"
#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/prepare_for_frame_field.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <vector>

// Every sector on constrained edges gets the number of quadrangles that its angle asks for.
namespace {

using namespace test;
using CGAL::Frame_fields::Support_strategy;

const auto as_in_the_paper =
  parameters::repair_matching(false).blunt_corner_bound(std::numeric_limits<double>::infinity());

// 2 - 4I of a sector on constrained edges; an angle of 1e-3 less counts as halfway between two numbers, too.
int natural_number_of_quads(const double theta)
{
  int number = 1;
  while(theta > (number + 0.5) * CGAL_PI / 2 - 1e-3)
    ++number;
  return number;
}

std::set<int> unnatural_sectors(const Cut& cut, const std::vector<int>& sector_index)
{
  std::set<int> result;
  for(int s = 0; s < cut.number_of_sectors(); ++s)
    if(cut.is_constrained_sector[s] ? sector_index[s] != 2 - natural_number_of_quads(cut.theta[s])
                                    : sector_index[s] > 1)
      result.insert(s);
  return result;
}

std::vector<Model> models_with_many_corners()
{
  std::vector<Model> result{ quilt(), cube(), tetrahedron(), sphere(), torus(), annulus(12, 3), wedge(3),
                             star({ 5, 20, 44, 10, 30 }), regular_polygon(8), regular_polygon(17) };
  for(unsigned int seed = 1; seed <= 12; ++seed)
  {
    result.push_back(spiked_domain(seed));
    result.push_back(random_planar_domain(seed));
  }
  return result;
}

// A regular polygon as a fan around one vertex, which would have to take all 4 quarters.
Model fan(const int n)
{
  Model model;
  model.points.emplace_back(0, 0, 0);
  for(int k = 0; k < n; ++k)
  {
    model.points.emplace_back(std::cos(2 * CGAL_PI * k / n), std::sin(2 * CGAL_PI * k / n), 0);
    model.triangles.push_back({ 0, static_cast<std::size_t>(k + 1), static_cast<std::size_t>((k + 1) % n + 1) });
  }
  return model;
}

template <typename Mesh>
class Natural_sectors : public testing::Test {};

TYPED_TEST_SUITE(Natural_sectors, Mesh_classes, Mesh_class_names);

TYPED_TEST(Natural_sectors, are_all_sectors_of_a_prepared_mesh)
{
  for(const Model& model : models_with_many_corners())
    for(const Support_strategy& strategy : { Support_strategy::none(), Support_strategy::rings(4) })
    {
      const Cad_mesh<TypeParam> cad_mesh(model, false);
      ASSERT_TRUE(FF::prepare_for_frame_field(const_cast<TypeParam&>(cad_mesh.mesh), cad_mesh.features()));
      const Cut cut = cad_mesh.cut();
      std::vector<typename boost::graph_traits<TypeParam>::halfedge_descriptor> unnatural;
      const Field field = frame_field(cad_mesh, parameters::support_strategy(strategy)
                                                  .unnatural_sector_output_iterator(std::back_inserter(unnatural)));
      EXPECT_EQ(std::set<int>(), unnatural_sectors(cut, index_of_sectors(cut, field.index)));
      EXPECT_TRUE(unnatural.empty());
      EXPECT_EQ(0u, field.statistics.number_of_unnatural_sectors);
      EXPECT_EQ(0u, field.statistics.number_of_unmeshable_inner_sectors);
      EXPECT_EQ(std::vector<int>(cut.number_of_patches, 0), poincare_hopf_defects(cut, field.index));
      EXPECT_LT(largest_misalignment(cut, field), 1e-9);
    }
}

TYPED_TEST(Natural_sectors, are_listed_and_counted_where_they_are_missing)
{
  for(const int n : { 8, 12, 31 })
  {
    const Cad_mesh<TypeParam> cad_mesh(fan(n), false);
    const Cut cut = cad_mesh.cut();
    for(const bool repairs : { false, true })
    {
      std::vector<typename boost::graph_traits<TypeParam>::halfedge_descriptor> listed;
      const Field field = frame_field(cad_mesh, parameters::repair_matching(repairs)
                                                  .unnatural_sector_output_iterator(std::back_inserter(listed)));
      const std::set<int> expected = unnatural_sectors(cut, index_of_sectors(cut, field.index));
      EXPECT_FALSE(expected.empty());
      EXPECT_EQ(expected.size(), listed.size());
      EXPECT_EQ(expected.size(), field.statistics.number_of_unnatural_sectors
                                 + field.statistics.number_of_unmeshable_inner_sectors);
      std::set<int> sectors;
      int number = 0;
      for_each_halfedge(cad_mesh.mesh, [&](const auto h)
      {
        if(std::count(listed.begin(), listed.end(), h) > 0)
          sectors.insert(cut.sector[number]);
        ++number;
      });
      EXPECT_EQ(expected, sectors);
    }
  }
}

// Angles that are equal but for rounding errors: a field must not tell them apart.
TYPED_TEST(Natural_sectors, are_the_same_for_congruent_corners)
{
  for(const int n : { 8, 16 }) // 135 degrees inside, and 225 outside
    for(const double noise : { 0., 1e-15, 1e-9, 1e-5 })
    {
      Model model = regular_polygon(n, 0.4);
      int sign = 1;
      for(Point& p : model.points)
        p = Point(p.x() * (1 + (sign = -sign) * noise), p.y(), 0);
      const Cad_mesh<TypeParam> cad_mesh(model, false);
      ASSERT_TRUE(FF::prepare_for_frame_field(const_cast<TypeParam&>(cad_mesh.mesh), cad_mesh.features()));
      const Cut cut = cad_mesh.cut();
      const std::vector<int> index = index_of_sectors(cut, frame_field(cad_mesh).index);
      for(int s = 0; s < cut.number_of_sectors(); ++s)
        if(cut.is_constrained_sector[s])
        {
          EXPECT_EQ(0, index[s]) << "two quadrangles at an angle of " << cut.theta[s];
        }
    }
}

// A prism of height 1 over an octagon whose angles are all of 135 degrees: `cut` is taken off the corners of a square.
Model octagonal_prism(const double cut)
{
  std::vector<Point> points;
  for(const double x : { -1., 1. })
    for(const double y : { -1., 1. })
      for(const double z : { 0., 1. })
      {
        points.emplace_back(x * (1 - cut), y, z);
        points.emplace_back(x, y * (1 - cut), z);
      }
  return with_sharp_edges(convex_hull(points));
}

// Turns the model by a random rotation.
Model turned(const Model& model, std::mt19937& generator)
{
  std::array<double, 4> q;
  double norm = 0;
  for(double& x : q)
  {
    x = generator() / 2147483648. - 1;
    norm += x * x;
  }
  const double w = q[0], s = 2 / norm;
  const Vector axis(q[1], q[2], q[3]);
  return transformed(model, [=](const Point& p)
  {
    const Vector v = p - CGAL::ORIGIN, c = CGAL::cross_product(axis, v);
    return p + s * (w * c + CGAL::cross_product(axis, c));
  });
}

TYPED_TEST(Natural_sectors, are_the_same_for_congruent_corners_of_prisms_turned_in_space)
{
  std::mt19937 generator(21);
  for(const double cut : { 2 - std::sqrt(2.), 0.1, 0.5 }) // regular, or a box with chamfers
    for(int i = 0; i < 4; ++i)
    {
      const Cad_mesh<TypeParam> cad_mesh(turned(octagonal_prism(cut), generator), false);
      ASSERT_TRUE(FF::prepare_for_frame_field(const_cast<TypeParam&>(cad_mesh.mesh), cad_mesh.features()));
      const Cut cut_mesh = cad_mesh.cut();
      const std::vector<int> index = index_of_sectors(cut_mesh, frame_field(cad_mesh).index);
      int number_of_ties = 0;
      for(int s = 0; s < cut_mesh.number_of_sectors(); ++s)
        if(cut_mesh.is_constrained_sector[s] && std::abs(cut_mesh.theta[s] - 135 * degree) < 1e-6)
        {
          ++number_of_ties;
          EXPECT_EQ(0, index[s]) << cut << " " << i;
        }
      EXPECT_EQ(16, number_of_ties);
    }
}

// The sum of the natural indices decides, and the preparation makes room for it.
TYPED_TEST(Natural_sectors, have_room_in_every_patch_of_a_prepared_mesh)
{
  std::vector<Model> models = models_with_many_corners();
  for(const int n : { 5, 12, 31, 100 })
    models.push_back(fan(n));
  models.push_back(single_triangle());
  for(const Model& model : models)
  {
    const Cad_mesh<TypeParam> cad_mesh(model, false);
    TypeParam& mesh = const_cast<TypeParam&>(cad_mesh.mesh);
    ASSERT_TRUE(FF::prepare_for_frame_field(mesh, cad_mesh.features()));
    const Cut cut = cad_mesh.cut();
    std::vector<int> remaining(cut.number_of_patches, 0), number_inside(cut.number_of_patches, 0);
    std::vector<int> patch_of_sector(cut.number_of_sectors());
    for(int h = 0; h < cut.number_of_halfedges(); ++h)
      patch_of_sector[cut.sector[h]] = cut.patch[face_of(h)];
    for(int s = 0; s < cut.number_of_sectors(); ++s)
      if(cut.is_constrained_sector[s])
        remaining[patch_of_sector[s]] -= 2 - natural_number_of_quads(cut.theta[s]);
      else
        ++number_inside[patch_of_sector[s]];
    // An index of 0 everywhere lacks four times the Euler characteristic.
    const std::vector<int> defects = poincare_hopf_defects(cut, std::vector<int>(cut.number_of_halfedges(), 0));
    for(int patch = 0; patch < cut.number_of_patches; ++patch)
    {
      EXPECT_LE(std::abs(remaining[patch] - defects[patch]), number_inside[patch]);
    }
    for(int f = 0; f < cut.number_of_faces(); ++f)
    {
      int constrained_edges = 0, inner_vertices = 0;
      for(int h = 3 * f; h < 3 * f + 3; ++h)
      {
        constrained_edges += cut.is_constrained(h);
        inner_vertices += !cut.is_constrained_sector[cut.sector[h]];
      }
      EXPECT_LE(constrained_edges, 1);
      EXPECT_GE(inner_vertices, 1);
    }
    const std::size_t number_of_faces = num_faces(mesh);
    ASSERT_TRUE(FF::prepare_for_frame_field(mesh, cad_mesh.features()));
    EXPECT_EQ(number_of_faces, num_faces(mesh)) << "a prepared mesh needs nothing";
  }
}

// Whether quarters can be moved around a cycle of sectors, or of sectors and the hub that joins those inside which may
// change, such that the energy falls (Bellman-Ford).
bool can_be_improved(const Cut& cut, const Field& field, const std::vector<int>& rounded_index)
{
  struct Arc { int from, to; double cost; };
  std::vector<Arc> arcs;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(!cut.is_constrained(h))
    {
      const double difference = cut.rotation(field.alpha, field.matching, h) - field.omega[h];
      const double changed = difference - CGAL_PI / 2;
      arcs.push_back({ cut.sector[h], cut.sector[cut.opposite[h]], changed * changed - difference * difference });
    }
  const int hub = cut.number_of_sectors();
  const std::vector<int> index = index_of_sectors(cut, field.index);
  for(int s = 0; s < hub; ++s)
    if(!cut.is_constrained_sector[s])
    {
      if(index[s] < 1)
        arcs.push_back({ s, hub, 0 });
      if(index[s] > (std::min)(-1, rounded_index[s]))
        arcs.push_back({ hub, s, 0 });
    }
  std::vector<double> distance(hub + 1, 0);
  for(int pass = 0; pass <= hub + 1; ++pass)
  {
    bool is_changed = false;
    for(const Arc& arc : arcs)
      if(distance[arc.from] + arc.cost < distance[arc.to] - 1e-9)
      {
        distance[arc.to] = distance[arc.from] + arc.cost;
        is_changed = true;
      }
    if(!is_changed)
      return false;
  }
  return true;
}

TEST(Natural_matching, has_the_least_energy)
{
  int number_of_changed_sectors = 0;
  for(unsigned int seed = 20; seed < 60; ++seed)
    for(const Support_strategy& strategy : { Support_strategy::none(), Support_strategy::rings(4) })
    {
      SCOPED_TRACE(seed);
      const Cad_mesh<Surface_mesh> cad_mesh(seed % 2 == 0 ? spiked_domain(seed) : random_planar_domain(seed), false);
      ASSERT_TRUE(FF::prepare_for_frame_field(const_cast<Surface_mesh&>(cad_mesh.mesh), cad_mesh.features()));
      const Cut cut = cad_mesh.cut();
      const auto np = parameters::support_strategy(strategy).relax_orthogonality(false);
      const std::vector<int> rounded = index_of_sectors(cut, frame_field(cad_mesh, np.repair_matching(false)).index);
      const Field field = frame_field(cad_mesh, np);
      const std::vector<int> index = index_of_sectors(cut, field.index);
      for(int s = 0; s < cut.number_of_sectors(); ++s)
        number_of_changed_sectors += index[s] != rounded[s];
      EXPECT_FALSE(can_be_improved(cut, field, rounded));
    }
  EXPECT_GT(number_of_changed_sectors, 200);
}

// Figures of the package before it made sectors natural.
TEST(Field_of_the_paper, is_what_it_was)
{
  struct Figures { Model model; int negative, positive, squares; double energy_orthogonal, energy_relaxed; };
  for(const Figures& expected : { Figures{ wedge(30), 0, 4, 4, 1.580528522, 1.692549377 },
                                  Figures{ wedge(150), 0, 4, 4, 2.357411086, 3.454341999 },
                                  Figures{ star({ 5, 20, 44, 10, 30 }), 5, 9, 14, 9.057204473, 4.485470560 },
                                  Figures{ quilt(), 8, 15, 32, 8.132776583, 7.681735329 } })
  {
    const Cad_mesh<Surface_mesh> cad_mesh(expected.model);
    const Field field = frame_field(cad_mesh, as_in_the_paper);
    int negative = 0, positive = 0, squares = 0;
    for(const int k : index_of_sectors(cad_mesh.cut(), field.index))
    {
      negative += k < 0;
      positive += k > 0;
      squares += k * k;
    }
    EXPECT_EQ(expected.negative, negative);
    EXPECT_EQ(expected.positive, positive);
    EXPECT_EQ(expected.squares, squares);
    EXPECT_NEAR(expected.energy_orthogonal, field.statistics.energy_orthogonal, 1e-8);
    EXPECT_NEAR(expected.energy_relaxed, field.statistics.energy_relaxed, 1e-8);
  }
}

TYPED_TEST(Natural_sectors, are_not_prepared_on_a_mesh_that_has_no_field)
{
  Model model = square(2);
  model.points[1] = model.points[0];
  const Cad_mesh<TypeParam> cad_mesh(model, false);
  TypeParam& mesh = const_cast<TypeParam&>(cad_mesh.mesh);
  const std::size_t number_of_faces = num_faces(mesh);
  EXPECT_EQ(FF::ERROR_ZERO_LENGTH_EDGE, FF::prepare_for_frame_field(mesh, cad_mesh.features()).error_code);
  EXPECT_EQ(number_of_faces, num_faces(mesh));
}

} // namespace
