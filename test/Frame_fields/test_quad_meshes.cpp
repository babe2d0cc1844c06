// What holds of each quad mesh, whatever the model and the size of its quads.

#include "quad_contract.h"
#include "random_models.h"
#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/cad_quad_mesh.h>
#include <CGAL/Frame_fields/internal/integer_grid/Grid_quad_extraction.h>
#include <CGAL/Frame_fields/internal/integer_grid/integer_grid_of_patch.h>
#include <CGAL/Frame_fields/internal/layout/arc_sides.h>
#include <CGAL/Frame_fields/internal/layout/make_T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/make_feature_network.h>
#include <CGAL/Frame_fields/internal/maps/Stage_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/repair_field.h>
#include <CGAL/Frame_fields/internal/quads/Patch_assembly.h>
#include <CGAL/Frame_fields/internal/quads/Quad_maker.h>
#include <CGAL/Frame_fields/internal/quads/Quad_stage_clock.h>
#include <CGAL/Frame_fields/internal/quads/Quantized_layout.h>
#include <CGAL/Frame_fields/internal/quads/fill_patch.h>
#include <CGAL/Frame_fields/internal/quads/place_on_integer_grids.h>
#include <CGAL/Frame_fields/internal/quads/smooth_quads.h>
#include <CGAL/Frame_fields/internal/quads/split_triangles.h>
#include <CGAL/Frame_fields/internal/surface/embed.h>
#include <CGAL/Frame_fields/prepare_for_frame_field.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test;

template <typename Mesh, typename Is_marked>
Marked_surface marked_surface(const Mesh& mesh, const Is_marked& is_marked)
{
  Marked_surface result;
  const auto number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  for(const auto v : vertices(mesh))
  {
    put(number, v, result.points.size());
    result.points.push_back(get(CGAL::vertex_point, mesh, v));
  }
  for(const auto f : faces(mesh))
  {
    result.faces.emplace_back();
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      result.faces.back().push_back(get(number, source(h, mesh)));
  }
  for(const auto e : edges(mesh))
    if(is_marked(e))
      result.marked_edges.insert(vertex_pair(get(number, source(e, mesh)), get(number, target(e, mesh))));
  return result;
}

template <typename Mesh>
Marked_surface triangles_of(const Cad_mesh<Mesh>& cad_mesh)
{
  return marked_surface(cad_mesh.mesh, [&](const auto e)
                        { return get(cad_mesh.is_feature, e) || is_border(e, cad_mesh.mesh); });
}

struct Quads
{
  FF::Result result;
  FF::Quad_statistics statistics;
  Marked_surface surface;
};

template <typename Quad_mesh = Surface_mesh, typename Mesh, typename NamedParameters>
Quads quads_of(const Cad_mesh<Mesh>& cad_mesh, const NamedParameters& np)
{
  Quads quads;
  Quad_mesh mesh;
  const auto is_marked = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  const auto patch = get(CGAL::dynamic_face_property_t<int>(), mesh);
  quads.result = FF::cad_quad_mesh(cad_mesh.mesh, mesh,
                                   parameters::join(np, cad_mesh.features().output_edge_is_constrained_map(is_marked)
                                     .face_to_patch_map(patch).statistics(std::ref(quads.statistics))));
  EXPECT_TRUE(quads.result) << quads.result.message;
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  quads.surface = marked_surface(mesh, [&](const auto e) { return get(is_marked, e); });
  for(const auto f : faces(mesh))
    quads.surface.patch.push_back(get(patch, f));
  // Where a pair of indices was cancelled, its corners have other numbers of quads than their angles ask for.
  for(const FF::Patch_quad_statistics& statistics : quads.statistics.patches)
    quads.surface.is_certified.push_back(statistics.way == FF::Patch_way::CERTIFIED_MAP
                                         && statistics.number_of_cancelled_pairs == 0);
  return quads;
}

template <typename Mesh>
double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const auto e : edges(mesh))
    sum += std::sqrt(CGAL::squared_distance(get(CGAL::vertex_point, mesh, source(e, mesh)),
                                            get(CGAL::vertex_point, mesh, target(e, mesh))));
  return sum / static_cast<double>(num_edges(mesh));
}

template <typename Mesh>
bool has_edge_longer_than(const Mesh& mesh, const double length)
{
  for(const auto e : edges(mesh))
    if(CGAL::squared_distance(get(CGAL::vertex_point, mesh, source(e, mesh)),
                              get(CGAL::vertex_point, mesh, target(e, mesh))) > length * length)
      return true;
  return false;
}

// The quads that the field asks for at singular vertices off features, sorted.
std::vector<int> singular_valences(const Model& model)
{
  Cad_mesh<Surface_mesh> cad_mesh(model, false);
  EXPECT_TRUE(FF::prepare_for_frame_field(cad_mesh.mesh, cad_mesh.features()));
  const Maps<Surface_mesh> maps(cad_mesh.mesh);
  EXPECT_TRUE(FF::cad_frame_field(cad_mesh.mesh, maps.alpha, maps.rho, maps.index, cad_mesh.features()));
  std::vector<int> result;
  for(const auto v : vertices(cad_mesh.mesh))
  {
    const auto h = halfedge(v, cad_mesh.mesh);
    bool is_inside = !cad_mesh.mesh.is_isolated(v);
    if(is_inside)
      for(const auto other : CGAL::halfedges_around_target(h, cad_mesh.mesh))
        is_inside = is_inside && !get(cad_mesh.is_feature, edge(other, cad_mesh.mesh))
                 && !is_border(edge(other, cad_mesh.mesh), cad_mesh.mesh);
    if(is_inside && get(maps.index, h) != 0)
      result.push_back(4 - get(maps.index, h));
  }
  std::sort(result.begin(), result.end());
  return result;
}

// They are counted apart from the library; whether there may be a few depends on the model.
void expect_few_inverted_quads(const Quads& quads, const bool may_be_inverted)
{
  const std::size_t number_of_inverted = number_of_inverted_quads(quads.surface);
  EXPECT_EQ(quads.statistics.quality.number_of_inverted_quads, number_of_inverted);
  EXPECT_LE(number_of_inverted, may_be_inverted ? 1 + quads.surface.faces.size() / 100 : 0u);
}

void expect_contract(const Model& model, const Marked_surface& triangles, const Quads& quads,
                     const bool may_be_inverted = false)
{
  EXPECT_EQ("", Quad_contract(triangles, quads.surface).broken_facts());
  const std::vector<int> irregular = irregular_valences(quads.surface), singular = singular_valences(model);
  if(quads.statistics.number_of_filled_patches == 0)
    EXPECT_EQ(singular, irregular);
  else
    EXPECT_TRUE(std::includes(singular.begin(), singular.end(), irregular.begin(), irregular.end()));
  expect_few_inverted_quads(quads, may_be_inverted);
}

void expect_contract(const Model& model, const double factor, const bool may_be_inverted = false)
{
  SCOPED_TRACE("edges of length " + std::to_string(factor) + " times the mean");
  const Cad_mesh<Surface_mesh> cad_mesh(model, false);
  const double length = factor * mean_edge_length(cad_mesh.mesh);
  const auto np = parameters::target_edge_length(length);
  // The field that the singularities are compared with is that of triangles that are not refined.
  const Quads quads = quads_of(cad_mesh, np.refine_long_triangles(false));
  expect_contract(model, triangles_of(cad_mesh), quads, may_be_inverted);
  if(has_edge_longer_than(cad_mesh.mesh, 2 * length))
  {
    const Quads refined = quads_of(cad_mesh, np);
    EXPECT_EQ("", Quad_contract(triangles_of(cad_mesh), refined.surface).broken_facts());
    expect_few_inverted_quads(refined, may_be_inverted);
  }
  if(std::getenv("FRAME_FIELDS_REPORT") != nullptr)
    std::cout << "  x" << factor << ": " << quads.statistics.number_of_quads << " quads, "
              << quads.statistics.number_of_filled_patches << " of " << quads.statistics.number_of_patches
              << " filled, SJ " << quads.statistics.quality.minimum_scaled_jacobian << ", "
              << quads.statistics.seconds.total << " s" << std::endl;
}

class Quad_meshes : public On_models {};

TEST_P(Quad_meshes, fulfil_the_contract)
{
  const Model model = GetParam().make();
  for(const double factor : { 1., 2., 4. })
    expect_contract(model, factor, !GetParam().file.empty());
}

std::vector<Named_model> chosen(const std::vector<Named_model>& models, const std::vector<std::string>& names)
{
  std::vector<Named_model> result;
  for(const Named_model& model : models)
    if(std::find(names.begin(), names.end(), model.name) != names.end())
      result.push_back(model);
  return result;
}

INSTANTIATE_TEST_SUITE_P(generated, Quad_meshes, testing::ValuesIn(generated_models()), Model_name());
INSTANTIATE_TEST_SUITE_P(cgal, Quad_meshes,
                         testing::ValuesIn(chosen(cgal_models(), { "joint", "pinion", "cross", "u", "couplingdown" })),
                         Model_name());
INSTANTIATE_TEST_SUITE_P(cad, Quad_meshes,
                         testing::ValuesIn(chosen(cad_models(), { "gu_bc_feat", "tm_fandisk_feat",
                                                                  "oc_crankarm_feat" })), Model_name());

// Each test of a few random models has seeds of its own.
class Quad_meshes_of_random_models : public testing::TestWithParam<Random_models> {};

TEST_P(Quad_meshes_of_random_models, fulfil_the_contract)
{
  const int number_of_models = number_from_environment("FRAME_FIELDS_RANDOM_QUAD_MESHES", 6);
  const int first_seed = number_from_environment("FRAME_FIELDS_SEED", 1);
  for(int seed = first_seed; seed < first_seed + number_of_models; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_contract(GetParam().draw(static_cast<unsigned int>(seed)), seed % 2 == 0 ? 1. : 3., true);
  }
}

std::vector<Random_models> random_models()
{
  std::vector<Random_models> result = kinds_of_random_models();
  result.push_back({ "spiked_domains", spiked_domain });
  return result;
}

INSTANTIATE_TEST_SUITE_P(, Quad_meshes_of_random_models, testing::ValuesIn(random_models()),
                         [](const auto& info) { return info.param.name; });

// Domains where quads between fixed vertices are valid only once they are divided more than once.
TEST(Quad_meshes_of_narrow_domains, have_no_inverted_quad)
{
  for(const unsigned seed : { 313u, 949u, 1002u, 1435u, 1899u })
  {
    SCOPED_TRACE(seed);
    const Cad_mesh<Surface_mesh> cad_mesh(random_planar_domain(seed), false);
    const double length = (seed % 2 == 0 ? 1 : 3) * mean_edge_length(cad_mesh.mesh);
    const Quads quads = quads_of(cad_mesh, parameters::target_edge_length(length));
    EXPECT_EQ("", Quad_contract(triangles_of(cad_mesh), quads.surface).broken_facts());
    for(std::size_t f = 0; f < quads.surface.faces.size(); ++f)
      EXPECT_GT(least_scaled_jacobian(quads.surface, f), 0) << f;
  }
}

// Domains with a patch whose map fails in a few places, until the triangles there are split.
TEST(Quad_meshes_of_domains_with_few_triangles, have_maps_after_splits)
{
  std::size_t number_of_filled_patches = 0;
  for(const unsigned seed : { 314u, 561u, 672u, 1229u, 1394u })
  {
    SCOPED_TRACE(seed);
    const Cad_mesh<Surface_mesh> cad_mesh(random_planar_domain(seed), false);
    const auto np = parameters::target_edge_length((seed % 2 == 0 ? 1 : 3) * mean_edge_length(cad_mesh.mesh));
    number_of_filled_patches += quads_of(cad_mesh, np.refine_long_triangles(false)).statistics.number_of_filled_patches;
    const Quads quads = quads_of(cad_mesh, np);
    EXPECT_EQ(0u, quads.statistics.number_of_filled_patches);
    EXPECT_EQ(0u, number_of_inverted_quads(quads.surface));
    EXPECT_EQ("", Quad_contract(triangles_of(cad_mesh), quads.surface).broken_facts());
  }
  EXPECT_GT(number_of_filled_patches, 0u);
}

// Gears where two irregular vertices of a side coincide in all integers, since a small patch beside it has the same
// number of edges on opposite sides.
TEST(Quad_meshes_without_integers, fill_a_small_patch_rather_than_a_large_one)
{
  for(const unsigned seed : { 4u, 36u, 76u })
  {
    SCOPED_TRACE(seed);
    const Cad_mesh<Surface_mesh> cad_mesh(random_gear(seed), false);
    const FF::Quad_statistics statistics =
      quads_of(cad_mesh, parameters::target_edge_length(mean_edge_length(cad_mesh.mesh))).statistics;
    std::size_t largest = 0, largest_filled = 0;
    for(const FF::Patch_quad_statistics& patch : statistics.patches)
    {
      largest = (std::max)(largest, patch.number_of_faces);
      if(patch.way == FF::Patch_way::FILLING)
        largest_filled = (std::max)(largest_filled, patch.number_of_faces);
    }
    EXPECT_GT(largest_filled, 0u);
    EXPECT_LT(largest_filled, largest / 4);
  }
}

Model tripod()
{
  return planar({ { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 } }, 0.5,
                { { { 1.5, 1.5 }, { 2.2, 1.6 } }, { { 1.5, 1.5 }, { 1.1, 2.1 } }, { { 1.5, 1.5 }, { 1, 1 } } });
}

// The rim of a disk of three faces is a closed feature with three vertices, none of which is a node by its edges.
Model loop_of_three_edges()
{
  Model model = grid(3, 6, true, false, [](const double u, const double v)
                     { return Point(std::cos(360 * degree * u), std::sin(360 * degree * u), 3 * v); });
  for(int k = 0; k < 3; ++k)
  {
    const auto at = [&](const int i)
    { return Point(std::cos(120 * degree * i), std::sin(120 * degree * i), 1.5); };
    for(const Point& p : model.points)
      for(const Point& q : model.points)
        if(CGAL::squared_distance(p, at(k)) < 1e-12 && CGAL::squared_distance(q, at(k + 1)) < 1e-12)
          model.features.push_back(segment(p, q));
  }
  return model;
}

// Around the hole, the outer border rises by a step that no map can have. With one pair of indices less it is a slope.
Model ring_with_step()
{
  Polyline border, hole;
  for(int i = 0; i <= 24; ++i)
  {
    const double angle = 15 * degree * i, radius = 2 + 0.6 * i / 24;
    border.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
    if(i < 24)
      hole.push_back({ std::cos(angle), std::sin(angle) });
  }
  return planar(border, 0.3, {}, { hole });
}

std::vector<Named_model> special_models()
{
  const Polyline frame = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 } };
  const Polyline l_shape = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
  return {
    { "L", [=] { return planar(l_shape, 0.3); }, "" },
    { "slit", [=] { return planar(frame, 0.4, { { { 1, 1.5 }, { 2, 1.5 } } }); }, "" },
    { "tripod", tripod, "" },
    { "loop_at_a_node", [=] { return planar(frame, 0.5, { { { 0, 0 }, { 1, 2 }, { 2, 1 }, { 0, 0 } } }); }, "" },
    { "holes", [=] { return planar(frame, 0.3, {}, { { { 1, 1 }, { 1.4, 1 }, { 1.2, 1.3 } },
                                                     { { 2, 2 }, { 2.5, 2 }, { 2.5, 2.5 }, { 2, 2.5 } } }); }, "" },
    { "loop_of_three_edges", loop_of_three_edges, "" },
    { "ring_with_step", ring_with_step, "" },
    { "components", [=] { return side_by_side(side_by_side(cube(), single_triangle()),
                                              side_by_side(torus(), annulus(8, 1))); }, "" },
    { "two_triangles", [] { return Model{ { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 } },
                                          { { { 0, 1, 2 } }, { { 0, 2, 3 } } }, {} }; }, "" },
    { "two_folded_triangles", [] { return Model{ { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 }, { 1, 0.3, 1 } },
                                                 { { { 0, 1, 2 } }, { { 1, 0, 3 } } },
                                                 { { { 0, 0, 0 }, { 2, 0, 0 } } } }; }, "" },
    { "tetrahedron_without_features", [] { Model model = tetrahedron(); model.features.clear(); return model; }, "" },
    { "cube_without_features", [] { Model model = cube(); model.features.clear(); return model; }, "" },
    { "tetrahedron_with_one_feature",
      [] { Model model = tetrahedron(); model.features.resize(1); return model; }, "" } };
}

INSTANTIATE_TEST_SUITE_P(special, Quad_meshes, testing::ValuesIn(special_models()), Model_name());

TEST(Quad_meshes_of_ring_with_step, need_one_pair_less)
{
  const Cad_mesh<Surface_mesh> cad_mesh(ring_with_step(), false);
  for(const bool is_allowed : { true, false })
  {
    const FF::Quad_statistics statistics = quads_of(cad_mesh, parameters::repair_matching(is_allowed)).statistics;
    EXPECT_EQ(is_allowed ? 0u : 1u, statistics.number_of_filled_patches);
    EXPECT_EQ(is_allowed ? 1u : 0u, statistics.number_of_repaired_patches);
    EXPECT_EQ(is_allowed ? 1u : 0u, statistics.patches[0].number_of_cancelled_pairs);
  }
}

// Edges far longer than the model, and far shorter than those of its triangles.
TEST(Quad_meshes_of_any_size, fulfil_the_contract)
{
  for(const Model& model : { cube(), quilt(), torus(), single_triangle(), tripod(), annulus(12, 1), spiked_domain(3) })
    for(const double factor : { 1e-1, 0.3, 50., 1e6 })
      if(factor > 0.2 || model.triangles.size() < 100)
        expect_contract(model, factor);
}

std::vector<Model> few_models()
{
  return { cube(), quilt(), torus(), tripod(), random_gear(1), random_star_shaped_polyhedron(2) };
}

void expect_same(const Marked_surface& quads, const Marked_surface& expected, const double scale = 1)
{
  EXPECT_EQ(expected.faces, quads.faces);
  EXPECT_EQ(expected.marked_edges, quads.marked_edges);
  EXPECT_EQ(expected.patch, quads.patch);
  ASSERT_EQ(expected.points.size(), quads.points.size());
  for(std::size_t v = 0; v < quads.points.size(); ++v)
    for(int k = 0; k < 3; ++k)
      ASSERT_EQ(scale * expected.points[v][k], quads.points[v][k]);
}

TEST(Quad_meshes_of_few_models, are_the_same_bit_for_bit_from_run_to_run_and_in_parallel)
{
  for(const Model& model : few_models())
  {
    const Cad_mesh<Surface_mesh> cad_mesh(model, false);
    const Quads quads = quads_of(cad_mesh, cad_mesh.features());
    expect_same(quads_of(cad_mesh, cad_mesh.features()).surface, quads.surface);
    expect_same(quads_of(cad_mesh, parameters::concurrency_tag(CGAL::Parallel_if_available_tag())).surface,
                quads.surface);
  }
}

TEST(Quad_meshes_of_few_models, scale_with_the_mesh)
{
  for(const Model& model : few_models())
  {
    const Cad_mesh<Surface_mesh> cad_mesh(model, false);
    const Quads quads = quads_of(cad_mesh, parameters::target_edge_length(0.25));
    for(const int exponent : { -300, -7, 1, 300 })
    {
      const double scale = std::ldexp(1., exponent);
      const Cad_mesh<Surface_mesh> scaled(
        transformed(model, [&](const Point& p) { return Point(scale * p.x(), scale * p.y(), scale * p.z()); }), false);
      expect_same(quads_of(scaled, parameters::target_edge_length(0.25 * scale)).surface, quads.surface, scale);
    }
  }
}

// The elements in another order, from another first vertex each.
Model renumbered(Model model)
{
  const std::size_t n = model.points.size();
  std::reverse(model.points.begin(), model.points.end());
  std::reverse(model.triangles.begin(), model.triangles.end());
  for(Triangle& triangle : model.triangles)
    triangle = { n - 1 - triangle[1], n - 1 - triangle[2], n - 1 - triangle[0] };
  return model;
}

TEST(Quad_meshes_of_few_models, hold_for_any_order_of_the_elements)
{
  for(const Model& model : few_models())
  {
    const Model other_model = renumbered(model);
    const Cad_mesh<Surface_mesh> cad_mesh(model, false), other_mesh(other_model, false);
    const Quads quads = quads_of(cad_mesh, cad_mesh.features()), other = quads_of(other_mesh, other_mesh.features());
    expect_contract(other_model, triangles_of(other_mesh), other);
    EXPECT_EQ(quads.statistics.number_of_patches, other.statistics.number_of_patches);
    EXPECT_EQ(quads.statistics.number_of_nodes, other.statistics.number_of_nodes);
    EXPECT_EQ(quads.statistics.number_of_arcs, other.statistics.number_of_arcs);
    EXPECT_EQ(quads.statistics.number_of_certified_patches, other.statistics.number_of_certified_patches);
  }
}

// They have as many irregular vertices of each valence. How many quads there are may differ, where a curve is a half
// number of edges long.
TEST(Quad_meshes_of_few_models, are_alike_on_mirror_images)
{
  for(const Model& model : few_models())
  {
    Model image = transformed(model, [](const Point& p) { return Point(-p.x(), p.y(), p.z()); });
    for(Triangle& triangle : image.triangles)
      std::swap(triangle[0], triangle[1]);
    const Cad_mesh<Surface_mesh> cad_mesh(model, false), image_mesh(image, false);
    const Quads quads = quads_of(cad_mesh, cad_mesh.features()), of_image = quads_of(image_mesh, image_mesh.features());
    EXPECT_EQ(irregular_valences(quads.surface), irregular_valences(of_image.surface));
  }
}

TEST(Quad_meshes_of_few_models, are_the_same_for_a_polyhedron)
{
  for(const Model& model : { cube(), quilt() })
  {
    const Cad_mesh<Surface_mesh> cad_mesh(model, false);
    const Cad_mesh<Polyhedron> polyhedron(model, false);
    const Quads quads = quads_of(cad_mesh, cad_mesh.features());
    const Quads from_polyhedron = quads_of<Polyhedron>(polyhedron, polyhedron.features());
    EXPECT_EQ("", Quad_contract(triangles_of(polyhedron), from_polyhedron.surface).broken_facts());
    EXPECT_EQ(quads.statistics.number_of_quads, from_polyhedron.statistics.number_of_quads);
    expect_same(quads_of<Polyhedron>(cad_mesh, cad_mesh.features()).surface, quads.surface);
  }
}

// Two faces that share a vertex of the border.
TEST(Quad_meshes_of_few_models, hold_at_a_pinched_border)
{
  Cad_mesh<Surface_mesh> cad_mesh(single_triangle(), false);
  const auto v = *vertices(cad_mesh.mesh).begin();
  cad_mesh.mesh.add_face(v, cad_mesh.mesh.add_vertex(Point(-4, 0, 0)), cad_mesh.mesh.add_vertex(Point(-1, -3, 0)));
  ASSERT_EQ(2u, num_faces(cad_mesh.mesh));
  const Quads quads = quads_of(cad_mesh, cad_mesh.features());
  EXPECT_EQ("", Quad_contract(triangles_of(cad_mesh), quads.surface).broken_facts());
  EXPECT_EQ(0u, number_of_inverted_quads(quads.surface));
}

// What is in the mesh already stays; vertices of no face do not count.
TEST(Quad_meshes_of_few_models, are_added_to_a_mesh)
{
  Surface_mesh quad_mesh;
  CGAL::make_quad(Point(9, 0, 0), Point(9, 1, 0), Point(8, 1, 0), Point(8, 0, 0), quad_mesh);
  Cad_mesh<Surface_mesh> cad_mesh(cube(), false);
  cad_mesh.mesh.add_vertex(Point(5, 5, 5));
  const std::size_t number_of_quads = quads_of(cad_mesh, cad_mesh.features()).surface.faces.size();
  ASSERT_TRUE(FF::cad_quad_mesh(cad_mesh.mesh, quad_mesh, cad_mesh.features()));
  EXPECT_EQ(number_of_quads + 1, num_faces(quad_mesh));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(quad_mesh));
  EXPECT_EQ(Point(9, 0, 0), quad_mesh.point(*vertices(quad_mesh).begin()));
}

// The arrays that cad_quad_mesh() works on, where a test chooses the way of each patch.
class Prepared_model
{
public:
  typedef FF::internal::Patch_source Patch_source;

  explicit Prepared_model(const Model& model) : m_cad_mesh(model, false)
  {
    EXPECT_TRUE(FF::prepare_for_frame_field(m_cad_mesh.mesh, m_cad_mesh.features()));
    const auto np = m_cad_mesh.features();
    typedef typename decltype(m_cad_mesh.features())::Pack Pack;
    FF::internal::Options options = FF::internal::options_from(np);
    options.measures_lengths = true;
    FF::internal::Stage_mesh<Surface_mesh, Pack> stage_mesh(m_cad_mesh.mesh, np);
    EXPECT_TRUE(stage_mesh.cut(options));
    const auto& cut_mesh = stage_mesh.cut_mesh();
    m_surface = cut_mesh.surface();
    m_embedding = FF::internal::embed(cut_mesh);
    m_length = mean_edge_length(m_cad_mesh.mesh) / m_surface.length_unit;

    FF::internal::Quad_stage_clock<Pack> clock(np);
    FF::internal::Frame_field field;
    EXPECT_EQ(FF::OK, FF::internal::compute_frame_field<CGAL::Sequential_tag>(
                        m_surface, options, FF::Eigen_frame_field_solver_traits(), clock, field).error_code);
    FF::internal::compute_seamless_map_and_repair_field<CGAL::Sequential_tag>(
      m_surface, options, std::vector<double>(m_surface.number_of_faces(), m_length),
      FF::Eigen_frame_field_solver_traits(), field, m_map);
    m_index = field.index;
    const std::vector<char> is_node = FF::internal::feature_nodes(m_surface, m_embedding, m_index, {});
    m_features = FF::internal::make_feature_network(m_surface, m_embedding, is_node);
    for(int s = 0; s < m_surface.number_of_sectors(); ++s)
      m_is_arc_node.push_back(m_surface.is_constrained_sector(s)
                              && is_node[m_embedding.vertex[m_surface.first_corner[s]]]);
  }

  std::size_t number_of_patches() const { return m_surface.patches.size(); }
  Marked_surface triangles() const { return triangles_of(m_cad_mesh); }

  // Patches that have no T-mesh are filled.
  Marked_surface quads_without_T_mesh(const std::vector<char>& is_without) const
  {
    std::vector<FF::internal::T_mesh> t_meshes(number_of_patches());
    for(std::size_t p = 0; p < number_of_patches(); ++p)
      if(!is_without[p])
        t_meshes[p] = make_T_mesh(m_surface, m_surface.patches[p], m_index, m_map, m_is_arc_node).mesh;
    FF::internal::Quad_complex complex =
      FF::internal::Quad_maker(m_surface, m_embedding, m_index, m_features, m_map, t_meshes, m_length).make();
    std::vector<char> is_certified;
    for(const FF::internal::T_mesh& t_mesh : t_meshes)
      is_certified.push_back(!t_mesh.cells.empty());
    return smoothed(complex, is_certified);
  }

  // Makes quads with edges as long as given, over the mean edge length, and the integer-grid maps of all patches with a
  // T-mesh. Returns how many of these are not certified.
  int check_integer_grids(const double relative_length) const
  {
    std::vector<FF::internal::T_mesh> t_meshes(number_of_patches());
    for(std::size_t p = 0; p < number_of_patches(); ++p)
      t_meshes[p] = make_T_mesh(m_surface, m_surface.patches[p], m_index, m_map, m_is_arc_node).mesh;
    FF::internal::Quad_maker maker(m_surface, m_embedding, m_index, m_features, m_map, t_meshes,
                                   relative_length * m_length);
    FF::internal::Quad_complex complex = maker.make();
    const std::vector<std::vector<int> > edges_of_piece = maker.layout().edges_of_piece();
    FF::internal::Seamless_map grid_map = m_map;
    int number_of_maps = 0, number_of_certified = 0;
    for(std::size_t p = 0; p < number_of_patches(); ++p)
    {
      if(t_meshes[p].cells.empty())
        continue;
      SCOPED_TRACE("patch " + std::to_string(p));
      ++number_of_maps;
      const FF::internal::Patch& patch = m_surface.patches[p];
      if(FF::internal::integer_grid_map_of_patch(
           m_surface, static_cast<int>(p), m_index, m_map, t_meshes[p], edges_of_piece[p],
           FF::internal::fixed_sectors(m_surface, patch, m_index, t_meshes[p]), FF::Eigen_frame_field_solver_traits(),
           grid_map) != FF::internal::Map_status::CERTIFIED)
        continue;
      ++number_of_certified;
      const std::ptrdiff_t number_of_quads =
        std::count(complex.patch.begin(), complex.patch.end(), static_cast<int>(p));
      expect_integer_grid(patch, grid_map, grid_map.fraction_bits[p], number_of_quads);
    }
    EXPECT_EQ(number_of_certified, FF::internal::place_on_integer_grids<CGAL::Sequential_tag>(
                                     m_surface, m_index, m_map, t_meshes, maker,
                                     std::vector<char>(number_of_patches(), 1), FF::Eigen_frame_field_solver_traits(),
                                     complex));
    EXPECT_EQ("", Quad_contract(triangles(), smoothed(complex, std::vector<char>(number_of_patches(), 0)))
                    .broken_facts());
    return number_of_maps - number_of_certified;
  }

  // The numbers of edges of all arcs when edges of quads are asked to be as long as given, over the mean edge length.
  std::vector<int> edges_of_arcs(const double relative_length) const
  {
    std::vector<FF::internal::T_mesh> t_meshes(number_of_patches());
    for(std::size_t p = 0; p < number_of_patches(); ++p)
      t_meshes[p] = make_T_mesh(m_surface, m_surface.patches[p], m_index, m_map, m_is_arc_node).mesh;
    FF::internal::Quantized_layout layout(m_surface, m_embedding, m_index, m_features, t_meshes,
                                          relative_length * m_length, {});
    layout.quantize();
    return layout.edges_of_arc();
  }

  // The same when all patches are filled; nothing if one of them is split into its triangles instead.
  std::vector<int> edges_of_arcs_of_fillings(const double relative_length) const
  {
    std::vector<FF::internal::T_mesh> t_meshes(number_of_patches());
    FF::internal::Quad_maker maker(m_surface, m_embedding, m_index, m_features, m_map, t_meshes,
                                   relative_length * m_length);
    maker.make();
    for(const Patch_source source : maker.layout().sources())
      if(source != Patch_source::FILLING)
        return {};
    return maker.layout().edges_of_arc();
  }

  // The last resort, beside patches that are filled: three quads for each triangle.
  Marked_surface quads_of_triangles(const std::vector<char>& is_split) const
  {
    const std::vector<FF::internal::T_mesh> t_meshes(number_of_patches());
    std::vector<Patch_source> sources;
    for(const char split : is_split)
      sources.push_back(split ? Patch_source::SPLIT_TRIANGLES : Patch_source::FILLING);
    const FF::internal::Arc_sides sides = collect_arc_sides(m_surface, m_embedding, m_features, t_meshes);
    std::vector<int> edges_of_arc;
    for(std::size_t a = 0; a < m_features.arcs.size(); ++a)
      edges_of_arc.push_back(is_beside_split_patch(sides, sources, static_cast<int>(a))
                             ? 2 * static_cast<int>(m_features.arcs[a].halfedges.size())
                             : smallest_even_count(m_embedding, m_features.arcs[a]));
    const std::vector<std::vector<int> > edges_of_piece(number_of_patches()), breakpoints(m_features.arcs.size());
    const std::vector<double> arc_tolerance(m_features.arcs.size(), 0);
    const FF::internal::Quad_layout layout{ m_surface, m_embedding, m_features, m_map, t_meshes, sources, sides,
                                            edges_of_piece, edges_of_arc, breakpoints, arc_tolerance };
    FF::internal::Quad_complex complex;
    make_arc_vertices(layout, complex);
    const FF::internal::Surface_walker walker(m_surface, m_embedding);
    for(int p = 0; p < static_cast<int>(number_of_patches()); ++p)
      if(is_split[p])
        split_triangles_of_patch(layout, p, complex);
      else
        EXPECT_TRUE(fill_patch(walker, m_surface, m_embedding, m_features, p, complex.arcs, m_length, complex));
    return smoothed(complex, std::vector<char>(number_of_patches(), false));
  }

private:
  Marked_surface smoothed(FF::internal::Quad_complex& complex, const std::vector<char>& is_certified) const
  {
    smooth(complex, m_surface, m_embedding, m_features);
    Marked_surface result;
    for(const FF::internal::Quad_vertex& vertex : complex.vertices)
    {
      const FF::internal::Coordinates p = point_of(m_surface, m_embedding, vertex);
      result.points.emplace_back(p[0], p[1], p[2]);
    }
    for(const std::array<int, 4>& quad : complex.quads)
      result.faces.emplace_back(quad.begin(), quad.end());
    for(std::size_t a = 0; a < complex.arcs.size(); ++a)
    {
      const std::vector<int>& arc = complex.arcs[a];
      for(std::size_t i = complex.is_loop[a] ? 0 : 1; i < arc.size(); ++i)
        result.marked_edges.insert(vertex_pair(arc[(i + arc.size() - 1) % arc.size()], arc[i]));
    }
    result.patch = complex.patch;
    result.is_certified = is_certified;
    return result;
  }

  // What holds of an integer-grid map of so many quads, and of the quads that are extracted from it.
  void expect_integer_grid(const FF::internal::Patch& patch, const FF::internal::Seamless_map& map,
                           const int fraction_bits, const std::ptrdiff_t number_of_quads) const
  {
    typedef CGAL::Exact_integer Integer;
    const std::int64_t unit = std::int64_t(1) << fraction_bits;
    Integer twice_area = 0;
    for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
    {
      const auto edge = [&](const std::vector<std::int64_t>& coordinate, const int k) -> Integer
      {
        return Integer(static_cast<double>(coordinate[3 * f + k])) - Integer(static_cast<double>(coordinate[3 * f]));
      };
      const Integer determinant = edge(map.u, 1) * edge(map.v, 2) - edge(map.v, 1) * edge(map.u, 2);
      EXPECT_GT(determinant, 0);
      twice_area += determinant;
    }
    EXPECT_EQ(Integer(2) * Integer(static_cast<double>(number_of_quads)) * Integer(static_cast<double>(unit))
                * Integer(static_cast<double>(unit)), twice_area);

    for(int e = patch.dual_edges.begin_index; e < patch.dual_edges.end_index; ++e)
    {
      std::int64_t u = map.u[m_surface.dual_edges[e].halfedge], v = map.v[m_surface.dual_edges[e].halfedge];
      for(int k = 0; k < map.quarter_turns[m_surface.dual_edges[e].halfedge]; ++k)
        u = std::exchange(v, u) * -1;
      const int behind = FF::internal::previous_of(m_surface.dual_edges[e].opposite);
      EXPECT_EQ(0, (map.u[behind] - u) % unit);
      EXPECT_EQ(0, (map.v[behind] - v) % unit);
    }
    for(int h = 3 * patch.faces.begin_index; h < 3 * patch.faces.end_index; ++h)
    {
      const int s = m_surface.sector[h], before = FF::internal::previous_of(h);
      const bool is_u_kept = map.u[h] == map.u[before], is_v_kept = map.v[h] == map.v[before];
      if(m_index[s] != 0 || m_is_arc_node[s])
      {
        EXPECT_TRUE(map.u[h] % unit == 0 && map.v[h] % unit == 0);
      }
      if(m_surface.is_constrained(h))
      {
        EXPECT_TRUE((is_u_kept && map.u[h] % unit == 0) || (is_v_kept && map.v[h] % unit == 0));
      }
    }
    expect_quads_of_grid(patch, map, fraction_bits, number_of_quads);
  }

  void expect_quads_of_grid(const FF::internal::Patch& patch, const FF::internal::Seamless_map& map,
                            const int fraction_bits, const std::ptrdiff_t number_of_quads) const
  {
    FF::internal::Grid_quads grid;
    ASSERT_TRUE(FF::internal::Grid_quad_extraction(m_surface, patch, map, fraction_bits).extract(grid));
    EXPECT_EQ(number_of_quads, static_cast<std::ptrdiff_t>(grid.quads.size()));
    std::vector<int> number_of_corners(grid.location.size(), 0);
    std::vector<char> is_on_border(grid.location.size(), 0);
    std::ptrdiff_t twice_edges = 0;
    for(std::size_t side = 0; side < grid.opposite.size(); ++side)
    {
      const int v = grid.quads[side / 4][side % 4], w = grid.quads[side / 4][(side + 1) % 4];
      const int opposite = grid.opposite[side];
      ++number_of_corners[v];
      twice_edges += opposite < 0 ? 2 : 1;
      if(opposite < 0)
      {
        is_on_border[v] = is_on_border[w] = 1;
        continue;
      }
      EXPECT_TRUE(grid.quads[opposite / 4][opposite % 4] == w && grid.quads[opposite / 4][(opposite + 1) % 4] == v);
    }
    for(std::size_t v = 0; v < grid.location.size(); ++v)
    {
      const int index = grid.sector[v] >= 0 ? m_index[grid.sector[v]] : 0;
      EXPECT_EQ((is_on_border[v] ? 2 : 4) - index, number_of_corners[v]);
    }
    std::ptrdiff_t characteristic = 2 * patch.faces.size() + 2 * patch.sectors.size();
    for(int h = 3 * patch.faces.begin_index; h < 3 * patch.faces.end_index; ++h)
      characteristic -= m_surface.is_constrained(h) ? 2 : 1;
    EXPECT_EQ(characteristic, 2 * static_cast<std::ptrdiff_t>(grid.location.size() + grid.quads.size()) - twice_edges);
  }

  Cad_mesh<Surface_mesh> m_cad_mesh;
  FF::internal::Cut_surface m_surface;
  FF::internal::Surface_embedding m_embedding;
  FF::internal::Feature_network m_features;
  FF::internal::Seamless_map m_map;
  std::vector<int> m_index;
  std::vector<char> m_is_arc_node;
  double m_length = 0;
};

// All patches, and every second one.
std::vector<std::vector<char> > choices_of_patches(const std::size_t number_of_patches)
{
  std::vector<std::vector<char> > result{ std::vector<char>(number_of_patches, true) };
  for(std::size_t first = 0; first < 2 && number_of_patches > 1; ++first)
  {
    result.emplace_back(number_of_patches, false);
    for(std::size_t p = first; p < number_of_patches; p += 2)
      result.back()[p] = true;
  }
  return result;
}

// The last three have corners or loops so narrow that not all quads of fillings are convex.
std::vector<Model> models_of_several_patches()
{
  return { cube(), quilt(), torus(), tripod(), loop_of_three_edges(), random_gear(1), random_planar_domain(4) };
}

TEST(Quad_meshes_with_filled_patches, fulfil_the_contract)
{
  const std::vector<Model> models = models_of_several_patches();
  for(std::size_t m = 0; m < models.size(); ++m)
  {
    SCOPED_TRACE("model " + std::to_string(m));
    const Prepared_model prepared(models[m]);
    for(const std::vector<char>& is_without : choices_of_patches(prepared.number_of_patches()))
    {
      const Marked_surface quads = prepared.quads_without_T_mesh(is_without);
      EXPECT_EQ("", Quad_contract(prepared.triangles(), quads).broken_facts());
      EXPECT_LE(number_of_inverted_quads(quads), m + 3 < models.size() ? 0u : 1u);
      for(std::size_t p = 0; p < is_without.size(); ++p)
        EXPECT_FALSE(is_without[p] && quads.is_certified[p]);
    }
  }
}

// Where an integer-grid map is certified, its quads are those assembled from the T-mesh. Edges four times as long leave
// many pieces of T-meshes empty. Random domains have faces with three vertices on one grid line, which allow no map.
TEST(Integer_grids, have_the_quads_of_the_T_meshes)
{
  std::vector<Model> models = models_of_several_patches();
  const std::size_t number_of_random_models = 4, number_of_others = models.size() - 1; // the last one is random, too
  for(int seed = 1; seed < static_cast<int>(number_of_random_models); ++seed)
    models.push_back(random_planar_domain(10 + seed));
  for(std::size_t m = 0; m < models.size(); ++m)
  {
    const Prepared_model prepared(models[m]);
    for(const double relative_length : { .6, 1., 4. })
    {
      SCOPED_TRACE("model " + std::to_string(m) + ", length " + std::to_string(relative_length));
      const int number_of_uncertified = prepared.check_integer_grids(relative_length);
      EXPECT_LE(number_of_uncertified, m < number_of_others ? 0 : 2);
    }
  }
}

// The rims of an open cylinder are polygons with 16 corners. A side across three of their edges would be 1 - cos(33.75
// degrees) = 0.17 away from the rim, which is 2.7 % of its length.
TEST(Numbers_of_edges, follow_the_bends_of_arcs)
{
  const std::vector<int> edges = Prepared_model(open_cylinder()).edges_of_arcs(100);
  ASSERT_EQ(2u, edges.size());
  for(const int n : edges)
    EXPECT_LE(8, n);
}

// However few edges are asked for: no edge of a filling may join a vertex with itself, or be there twice.
TEST(Numbers_of_edges, suffice_for_fillings)
{
  for(const Model& model : models_of_several_patches())
    for(const int n : Prepared_model(model).edges_of_arcs_of_fillings(1000))
      EXPECT_TRUE(n >= 2 && n % 2 == 0) << n;
  EXPECT_FALSE(Prepared_model(loop_of_three_edges()).edges_of_arcs_of_fillings(1000).empty());
}

// Where triangles are obtuse, quads may be inverted.
TEST(Quad_meshes_of_split_triangles, fulfil_the_contract)
{
  for(const Model& model : models_of_several_patches())
  {
    const Prepared_model prepared(model);
    for(const std::vector<char>& is_split : choices_of_patches(prepared.number_of_patches()))
    {
      const Marked_surface quads = prepared.quads_of_triangles(is_split);
      EXPECT_EQ("", Quad_contract(prepared.triangles(), quads).broken_facts());
      if(is_split == std::vector<char>(is_split.size(), true))
      {
        EXPECT_EQ(3 * prepared.triangles().faces.size(), quads.faces.size());
      }
    }
  }
}

TEST(Quad_meshes_of_few_quads, have_about_the_number_asked_for)
{
  const Cad_mesh<Surface_mesh> cad_mesh(torus(), false);
  for(const double number : { 300., 1000., 4000. })
    EXPECT_NEAR(number, static_cast<double>(quads_of(cad_mesh, parameters::number_of_quads(number))
                                              .statistics.number_of_quads), 0.15 * number);
}

// Without irregular vertices, nothing of a torus has to have an edge.
TEST(Quad_meshes_of_few_quads, are_never_none)
{
  const Cad_mesh<Surface_mesh> cad_mesh(torus(), false);
  const Quads quads = quads_of(cad_mesh, parameters::target_edge_length(1e6));
  EXPECT_EQ("", Quad_contract(triangles_of(cad_mesh), quads.surface).broken_facts());
}

template <typename NamedParameters>
void expect_failure(const FF::Error_code expected, const Surface_mesh& mesh, const NamedParameters& np)
{
  Surface_mesh quad_mesh;
  CGAL::make_quad(Point(9, 0, 0), Point(9, 1, 0), Point(8, 1, 0), Point(8, 0, 0), quad_mesh);
  FF::Quad_statistics statistics;
  statistics.number_of_quads = 77;
  const FF::Result result =
    FF::cad_quad_mesh(mesh, quad_mesh, parameters::join(np, parameters::statistics(std::ref(statistics))));
  EXPECT_EQ(expected, result.error_code) << result.message;
  EXPECT_EQ(0u, result.message.find(FF::get_error_message(expected))) << result.message;
  EXPECT_EQ(4u, num_vertices(quad_mesh));
  EXPECT_EQ(8u, num_halfedges(quad_mesh));
  EXPECT_EQ(1u, num_faces(quad_mesh));
  EXPECT_EQ(77u, statistics.number_of_quads);
}

TEST(Quad_mesh_errors, of_parameters)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Cad_mesh<Surface_mesh> cad_mesh(square(2), false);
  for(const double wrong : { 0., -1., 1e-9, 1e-300, infinity, nan })
    expect_failure(FF::ERROR_WRONG_PARAMETER, cad_mesh.mesh, parameters::target_edge_length(wrong));
  for(const double wrong : { 0., 0.5, -1., 1e12, infinity, nan })
    expect_failure(FF::ERROR_WRONG_PARAMETER, cad_mesh.mesh, parameters::number_of_quads(wrong));
}

TEST(Quad_mesh_errors, of_meshes)
{
  const auto np = parameters::relax_orthogonality(true);
  expect_failure(FF::ERROR_EMPTY_MESH, Surface_mesh(), np);
  for(const double wrong : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    Model model = square(3);
    model.points[5] = Point(0, wrong, 0);
    expect_failure(FF::ERROR_NON_FINITE_COORDINATE, Cad_mesh<Surface_mesh>(model, false).mesh, np);
  }
  Surface_mesh quad;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), quad);
  expect_failure(FF::ERROR_NON_TRIANGULAR_MESH, quad, np);
  Cad_mesh<Surface_mesh> collapsed(square(3), false);
  collapsed.mesh.point(Surface_mesh::Vertex_index(0)) = collapsed.mesh.point(Surface_mesh::Vertex_index(1));
  if(collapsed.mesh.halfedge(Surface_mesh::Vertex_index(0), Surface_mesh::Vertex_index(1)).is_valid())
    expect_failure(FF::ERROR_ZERO_LENGTH_EDGE, collapsed.mesh, np);
  else
    FAIL() << "no edge between the first two vertices";
  Surface_mesh mesh;
  const auto a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0)),
             c = mesh.add_vertex(Point(0, 1, 0)), d = mesh.add_vertex(Point(1, 1, 0));
  const auto f = mesh.add_face(a, b, c);
  mesh.add_face(c, b, d);
  mesh.set_halfedge(f, mesh.halfedge(b, c));
  mesh.set_face(mesh.halfedge(c, b), f); // in the cycle of the other face
  expect_failure(FF::ERROR_INCONSISTENT_HALFEDGES, mesh, np);
}

} // namespace
