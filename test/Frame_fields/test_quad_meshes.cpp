// What holds of each quad mesh, whatever the model and the size of its quads.

#include "quad_contract.h"
#include "random_models.h"
#include "test_cad_mesh.h"

#include <CGAL/Frame_fields/cad_quad_mesh.h>
#include <CGAL/Frame_fields/prepare_for_frame_field.h>

#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
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
  for(const FF::Patch_quad_statistics& statistics : quads.statistics.patches)
    quads.surface.is_certified.push_back(statistics.way == FF::Patch_way::CERTIFIED_MAP);
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

void expect_contract(const Model& model, const Marked_surface& triangles, const Quads& quads)
{
  EXPECT_EQ("", Quad_contract(triangles, quads.surface).broken_facts());
  const std::vector<int> irregular = irregular_valences(quads.surface), singular = singular_valences(model);
  if(quads.statistics.number_of_filled_patches == 0)
    EXPECT_EQ(singular, irregular);
  else
    EXPECT_TRUE(std::includes(singular.begin(), singular.end(), irregular.begin(), irregular.end()));
  EXPECT_EQ(0u, number_of_inverted_quads(quads.surface));
}

void expect_contract(const Model& model, const double factor)
{
  SCOPED_TRACE("edges of length " + std::to_string(factor) + " times the mean");
  const Cad_mesh<Surface_mesh> cad_mesh(model, false);
  const double length = factor * mean_edge_length(cad_mesh.mesh);
  const Quads quads = quads_of(cad_mesh, parameters::target_edge_length(length));
  expect_contract(model, triangles_of(cad_mesh), quads);
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
    expect_contract(model, factor);
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

} // namespace
