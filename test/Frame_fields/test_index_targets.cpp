#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/orthogonal_frame_field.h>
#include <CGAL/Frame_fields/prescribe_rotation.h>
#include <CGAL/Frame_fields/relax_frame_field.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>

// Singularities at given places.
namespace {

using namespace test;

template <typename Mesh>
class Index_targets : public testing::Test
{
protected:
  // A target for all halfedges of each sector, as they are numbered in the tests.
  static Halfedge_map<Mesh, int> target_map(const Cad_mesh<Mesh>& cad_mesh, const Cut& cut,
                                            const std::map<int, int>& target_of_sector)
  {
    const Halfedge_map<Mesh, int> map = get(CGAL::dynamic_halfedge_property_t<int>(), cad_mesh.mesh);
    for(const auto h : halfedges(cad_mesh.mesh))
      put(map, h, FF::NO_INDEX_TARGET);
    int number = 0;
    for_each_halfedge(cad_mesh.mesh, [&](const auto h)
    {
      const auto found = target_of_sector.find(cut.sector[number++]);
      if(found != target_of_sector.end())
        put(map, h, found->second);
    });
    return map;
  }

  static FF::Result error(const Cad_mesh<Mesh>& cad_mesh, const Halfedge_map<Mesh, int>& map)
  {
    const Maps<Mesh> maps(cad_mesh.mesh);
    return FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index,
                               parameters::join(cad_mesh.features(), parameters::index_target_map(map)));
  }

  static std::vector<int> sectors(const Cut& cut, const bool are_constrained)
  {
    std::vector<int> result;
    for(int s = 0; s < cut.number_of_sectors(); ++s)
      if(bool(cut.is_constrained_sector[s]) == are_constrained)
        result.push_back(s);
    return result;
  }
};

TYPED_TEST_SUITE(Index_targets, Mesh_classes, Mesh_class_names);

TYPED_TEST(Index_targets, sphere_gets_its_singularities_where_they_are_wanted)
{
  const Cad_mesh<TypeParam> cad_mesh(sphere());
  const Cut cut = cad_mesh.cut();
  std::vector<int> order = this->sectors(cut, false);
  std::mt19937 random(7);
  for(const std::vector<int>& indices : { std::vector<int>(8, 1), std::vector<int>{ 4, 4 },
                                          std::vector<int>{ 2, 2, 2, 2 }, std::vector<int>{ 8 },
                                          std::vector<int>{ 5, 5, -1, -1 } })
  {
    std::shuffle(order.begin(), order.end(), random);
    std::map<int, int> targets;
    std::vector<int> expected(order.size(), 0);
    for(std::size_t k = 0; k < indices.size(); ++k)
      targets[order[k]] = expected[order[k]] = indices[k];
    const Field field =
      frame_field(cad_mesh, parameters::index_target_map(this->target_map(cad_mesh, cut, targets)));
    EXPECT_EQ(expected, index_of_sectors(cut, field.index));
    if(*std::max_element(indices.begin(), indices.end()) <= 4) // the test counts branches modulo 4
    {
      EXPECT_LT(largest_index_error(cut, field.alpha, field.matching, field.index), 1e-6);
    }
  }
}

// Any sectors of a patch may take any indices that sum to zero beside the natural ones of a field without targets.
TYPED_TEST(Index_targets, random_targets_are_met_exactly)
{
  const Cad_mesh<TypeParam> cad_mesh(square(12));
  const Cut cut = cad_mesh.cut();
  const std::vector<int> natural = index_of_sectors(cut, frame_field(cad_mesh).index);
  std::mt19937 random(3);
  for(int round = 0; round < 20; ++round)
  {
    std::vector<int> expected = natural;
    for(int k = 0; k < 5; ++k)
    {
      ++expected[random() % expected.size()];
      --expected[random() % expected.size()];
    }
    std::map<int, int> targets;
    for(int s = 0; s < cut.number_of_sectors(); ++s)
      targets[s] = expected[s];
    const Field field =
      frame_field(cad_mesh, parameters::index_target_map(this->target_map(cad_mesh, cut, targets)));
    EXPECT_EQ(expected, index_of_sectors(cut, field.index));
    EXPECT_LT(largest_misalignment(cut, field), 1e-9);
  }
}

TYPED_TEST(Index_targets, patches_without_target_keep_their_field)
{
  const Cad_mesh<TypeParam> cad_mesh(cube());
  const Cut cut = cad_mesh.cut();
  const Field before = frame_field(cad_mesh);
  std::map<int, int> targets;
  for(int h = 0; h < cut.number_of_halfedges(); ++h)
    if(cut.patch[face_of(h)] == 0)
      targets[cut.sector[h]] = before.index[h];
  const Field after =
    frame_field(cad_mesh, parameters::index_target_map(this->target_map(cad_mesh, cut, targets)));
  EXPECT_EQ(before.index, after.index);
  for(int f = 0; f < cut.number_of_faces(); ++f)
    if(cut.patch[f] != 0)
    {
      EXPECT_EQ(before.alpha[f], after.alpha[f]);
    }
}

TYPED_TEST(Index_targets, what_is_missing_to_poincare_hopf_is_named)
{
  const Cad_mesh<TypeParam> cad_mesh(sphere());
  const FF::Result result = this->error(cad_mesh, this->target_map(cad_mesh, cad_mesh.cut(), { { 0, 5 } }));
  EXPECT_EQ(FF::ERROR_POINCARE_HOPF, result.error_code);
  EXPECT_NE(std::string::npos, result.message.find("3/4 is missing")) << result.message;
}

TYPED_TEST(Index_targets, that_do_not_sum_are_refused_by_each_stage)
{
  const Cad_mesh<TypeParam> cad_mesh(square(8));
  const Cut cut = cad_mesh.cut();
  const Maps<TypeParam> maps(cad_mesh.mesh);
  const auto features = cad_mesh.features();
  ASSERT_TRUE(FF::orthogonal_frame_field(cad_mesh.mesh, maps.alpha, features.matching_map(maps.matching)));
  int inner = 0;
  while(cut.is_constrained_sector[inner])
    ++inner;
  const auto np = features.index_target_map(this->target_map(cad_mesh, cut, { { inner, 1 } }));
  for(const FF::Result& result :
      { FF::prescribe_rotation(cad_mesh.mesh, maps.omega, np),
        FF::orthogonal_frame_field(cad_mesh.mesh, maps.alpha, np),
        FF::orthogonal_frame_field(cad_mesh.mesh, maps.alpha, np.matching_map(maps.matching)),
        FF::relax_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, np),
        FF::relax_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, np.matching_map(maps.matching)) })
  {
    EXPECT_EQ(FF::ERROR_POINCARE_HOPF, result.error_code);
    EXPECT_NE(std::string::npos, result.message.find("-1/4 is missing")) << result.message;
  }
}

// Each quarter between the field and its targets takes a search, so a rotation of a million radians must not be undone.
TYPED_TEST(Index_targets, far_from_the_prescribed_rotation_are_refused)
{
  const Cad_mesh<TypeParam> cad_mesh(sphere());
  std::map<int, int> targets;
  for(int sector = 0; sector < 8; ++sector)
    targets[sector] = 1;
  const Maps<TypeParam> maps(cad_mesh.mesh);
  const auto np = cad_mesh.features().index_target_map(this->target_map(cad_mesh, cad_mesh.cut(), targets));
  ASSERT_TRUE(FF::prescribe_rotation(cad_mesh.mesh, maps.omega, np));
  const auto prescribed = np.prescribed_rotation_map(maps.omega).matching_map(maps.matching);
  EXPECT_TRUE(FF::orthogonal_frame_field(cad_mesh.mesh, maps.alpha, prescribed));
  EXPECT_TRUE(FF::orthogonal_frame_field(cad_mesh.mesh, maps.alpha, np.matching_map(maps.matching))); // all are 0

  const auto h = halfedge(*faces(cad_mesh.mesh).begin(), cad_mesh.mesh);
  put(maps.omega, h, 1e6);
  put(maps.omega, opposite(h, cad_mesh.mesh), -1e6);
  const FF::Result result = FF::orthogonal_frame_field(cad_mesh.mesh, maps.alpha, prescribed);
  EXPECT_EQ(FF::ERROR_WRONG_FIELD, result.error_code);
  EXPECT_NE(std::string::npos, result.message.find("vertex at (")) << result.message;
}

TYPED_TEST(Index_targets, two_targets_for_one_sector_are_refused)
{
  const Cad_mesh<TypeParam> cad_mesh(sphere());
  const auto map = this->target_map(cad_mesh, cad_mesh.cut(), {});
  int target = 1;
  const auto corner = halfedge(*faces(cad_mesh.mesh).begin(), cad_mesh.mesh);
  for(const auto h : CGAL::halfedges_around_target(corner, cad_mesh.mesh))
    put(map, h, target++);
  EXPECT_EQ(FF::ERROR_WRONG_FIELD, this->error(cad_mesh, map).error_code);
}

TYPED_TEST(Index_targets, beyond_250_turns_are_refused)
{
  const Cad_mesh<TypeParam> cad_mesh(sphere());
  const int largest = std::numeric_limits<int>::max();
  for(const int target : { 1001, -1001, largest, -largest })
  {
    const FF::Result result = this->error(cad_mesh, this->target_map(cad_mesh, cad_mesh.cut(), { { 0, target } }));
    EXPECT_EQ(FF::ERROR_WRONG_FIELD, result.error_code);
    EXPECT_NE(std::string::npos, result.message.find("vertex at (")) << result.message;
  }
}

} // namespace
