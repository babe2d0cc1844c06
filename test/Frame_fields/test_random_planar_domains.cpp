// Random planar domains with many very sharp corners a few edges apart: whatever the mesh, each corner gets its natural
// index. The environment variable FRAME_FIELDS_RANDOM_DOMAINS sets their number, FRAME_FIELDS_SEED the first seed.

#include "random_models.h"
#include "test_cad_mesh.h"

#include <CGAL/Frame_fields.h>

#include <gtest/gtest.h>

#include <iostream>
#include <utility>

namespace Frame_fields = CGAL::Frame_fields;
namespace params = CGAL::Frame_fields::parameters;

using test::Surface_mesh;

namespace {

struct Count
{
  int unmeshable = 0;
  std::size_t repaired = 0, unnatural = 0, unmeshable_inside = 0, corners = 0;
};

// Computes the field of a domain and counts its unmeshable sectors.
Count count(const Surface_mesh& mesh, const Frame_fields::Support_strategy& strategy, const bool repairs)
{
  typedef boost::property_map<Surface_mesh, CGAL::dynamic_face_property_t<double> >::const_type Face_map;
  const Face_map alpha = get(CGAL::dynamic_face_property_t<double>(), mesh);
  const Face_map rho = get(CGAL::dynamic_face_property_t<double>(), mesh);
  const auto index = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
  Frame_fields::Statistics statistics;
  const Frame_fields::Result result = Frame_fields::cad_frame_field(
    mesh, alpha, rho, index,
    params::statistics(std::ref(statistics)).support_strategy(strategy).repair_matching(repairs));
  EXPECT_TRUE(result) << result.message;

  Count total;
  total.repaired = statistics.number_of_repaired_sectors;
  total.unnatural = statistics.number_of_unnatural_sectors;
  total.unmeshable_inside = statistics.number_of_unmeshable_inner_sectors;
  total.corners = statistics.number_of_sharp_corners;
  for(const auto h : halfedges(mesh)) // the first corner of each sector on the border
    if(!is_border(h, mesh) && is_border(opposite(next(h, mesh), mesh), mesh) && get(index, h) > 1)
      ++total.unmeshable;
  return total;
}

} // namespace

class Random_planar_domains : public testing::TestWithParam<std::pair<const char*, Frame_fields::Support_strategy> >
{};

TEST_P(Random_planar_domains, have_natural_sectors)
{
  const int number_of_domains = test::number_from_environment("FRAME_FIELDS_RANDOM_DOMAINS", 500);
  const int first_seed = test::number_from_environment("FRAME_FIELDS_SEED", 1);
  const Frame_fields::Support_strategy strategy = GetParam().second;
  Count without_repair, with_repair;
  for(int seed = first_seed; seed < first_seed + number_of_domains; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Cad_mesh<Surface_mesh> cad_mesh(test::spiked_domain(seed), false);
    ASSERT_TRUE(Frame_fields::prepare_for_frame_field(cad_mesh.mesh, cad_mesh.features()));
    const Surface_mesh& mesh = cad_mesh.mesh;
    const Count before = count(mesh, strategy, false), after = count(mesh, strategy, true);
    EXPECT_EQ(after.unmeshable, 0);
    EXPECT_EQ(after.unnatural, 0u);
    EXPECT_EQ(after.unmeshable_inside, 0u);
    EXPECT_EQ(after.repaired, before.unnatural);
    without_repair.unmeshable += before.unmeshable;
    without_repair.unnatural += before.unnatural;
    with_repair.unmeshable += after.unmeshable;
    with_repair.unnatural += after.unnatural;
    with_repair.corners += after.corners;
  }
  std::cout << number_of_domains << " domains with " << with_repair.corners << " sharp corners; unmeshable: "
            << without_repair.unmeshable << " without and " << with_repair.unmeshable << " with the repair; without "
            << "their natural index: " << without_repair.unnatural << " and " << with_repair.unnatural << std::endl;
}

INSTANTIATE_TEST_SUITE_P(, Random_planar_domains,
                         testing::Values(std::make_pair("none", Frame_fields::Support_strategy::none()),
                                         std::make_pair("local", Frame_fields::Support_strategy::local()),
                                         std::make_pair("rings", Frame_fields::Support_strategy::rings(4)),
                                         std::make_pair("component", Frame_fields::Support_strategy::component())),
                         [](const auto& info) { return info.param.first; });
