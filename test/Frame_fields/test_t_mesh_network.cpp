// Copyright (c) 2026 The Frame_fields authors.
// All rights reserved.
//
// This file is part of Frame_fields, a package in the form of CGAL's (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later
//

// The numbers of quads along the pieces of T-meshes made by hand, and along the arcs between them.

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/quantization/quantize.h>
#include <CGAL/Frame_fields/internal/quantization/t_mesh_network.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace {

namespace FFi = CGAL::Frame_fields::internal;

// Rectangles of two faces each: patch i has the halfedges 6i + BOTTOM, 6i + RIGHT, 6i + TOP and 6i + LEFT on its sides.
enum Rectangle_side { BOTTOM = 0, RIGHT = 1, TOP = 4, LEFT = 5 };

struct Model
{
  FFi::Cut_surface surface;
  FFi::Feature_network features;
  std::vector<FFi::T_mesh> t_meshes;
  FFi::Edge_length_targets targets;

  void add_rectangle(const double width, const double height, const double edge_length)
  {
    const int face = 2 * static_cast<int>(surface.patches.size());
    surface.patches.push_back({ { face, face + 2 }, { 0, 0 }, { 0, 0 } });
    surface.length.resize(surface.length.size() + 6, 1);
    surface.length[3 * face + BOTTOM] = surface.length[3 * face + TOP] = width;
    surface.length[3 * face + LEFT] = surface.length[3 * face + RIGHT] = height;
    features.arc.resize(features.arc.size() + 6, -1);
    features.place.resize(features.place.size() + 6, -1);
    t_meshes.emplace_back();
    targets.edge_length.push_back(edge_length);
  }

  // An arc on one halfedge, and on its twin if there is one.
  void add_arc(const int halfedge, const int twin = -1, const bool is_loop = false)
  {
    for(const int h : { halfedge, twin })
      if(h >= 0)
      {
        features.arc[h] = static_cast<int>(features.arcs.size());
        features.place[h] = 0;
      }
    features.arcs.push_back({ { halfedge }, is_loop });
  }

  int add_piece(const int patch, const double length, const int halfedge)
  {
    t_meshes[patch].pieces.push_back({ 0, 0, 1, length, halfedge < 0 ? -1 : 6 * patch + halfedge });
    return static_cast<int>(t_meshes[patch].pieces.size()) - 1;
  }

  void add_cell(const int patch, const std::array<std::vector<int>, 4>& sides)
  {
    FFi::T_mesh_cell cell = {};
    for(int side = 0; side < 4; ++side)
      for(const int piece : sides[side])
        cell.sides[side].push_back({ piece, false });
    t_meshes[patch].cells.push_back(cell);
  }

  // The values of a solution; all that they must fulfil is looked up in the T-meshes again.
  std::vector<int> solve(FFi::T_mesh_network& result) const
  {
    result = t_mesh_network(surface, features, t_meshes, targets);
    const FFi::Quantization quantization = quantize(result.network);
    EXPECT_TRUE(quantization.is_feasible && quantization.is_optimal);
    const std::vector<int>& value = quantization.value;
    std::vector<std::array<int, 2> > sum(features.arcs.size(), { 0, 0 });
    for(std::size_t p = 0; p < t_meshes.size(); ++p)
    {
      const int patch = static_cast<int>(p);
      for(const FFi::T_mesh_cell& cell : t_meshes[patch].cells)
      {
        std::array<int, 4> side_sum = { 0, 0, 0, 0 };
        for(int side = 0; side < 4; ++side)
          for(const FFi::Directed_piece& directed : cell.sides[side])
            side_sum[side] += value[result.edge_of_piece(patch, directed.piece)];
        EXPECT_EQ(side_sum[0], side_sum[2]);
        EXPECT_EQ(side_sum[1], side_sum[3]);
      }
      for(std::size_t i = 0; i < t_meshes[patch].pieces.size(); ++i)
      {
        const int n = value[result.edge_of_piece(patch, static_cast<int>(i))];
        const int halfedge = t_meshes[patch].pieces[i].halfedge;
        EXPECT_GE(n, 1);
        if(halfedge >= 0)
          sum[features.arc[halfedge]][features.arcs[features.arc[halfedge]].halfedges[0] == halfedge ? 0 : 1] += n;
      }
    }
    for(std::size_t arc = 0; arc < features.arcs.size(); ++arc)
      for(const int side_sum : sum[arc])
        EXPECT_TRUE(side_sum == 0 || side_sum == value[result.edge_of_arc(static_cast<int>(arc))]);
    return value;
  }
};

// Patch 0 with two cells, one above the other.
void add_two_cells(Model& model)
{
  const int bottom = model.add_piece(0, 4, BOTTOM), top = model.add_piece(0, 4, TOP);
  const int lower_right = model.add_piece(0, .9, RIGHT), upper_right = model.add_piece(0, 1.1, RIGHT);
  const int upper_left = model.add_piece(0, 1.1, LEFT), lower_left = model.add_piece(0, .9, LEFT);
  const int middle = model.add_piece(0, 4, -1);
  model.add_cell(0, { { { bottom }, { lower_right }, { middle }, { lower_left } } });
  model.add_cell(0, { { { middle }, { upper_right }, { top }, { upper_left } } });
}

// Patch 1 with three cells at its left, and one at its right.
void add_four_cells(Model& model)
{
  const int left_2 = model.add_piece(1, .2, LEFT), left_1 = model.add_piece(1, 1.5, LEFT);
  const int left_0 = model.add_piece(1, .3, LEFT);
  const int inner_0 = model.add_piece(1, .3, -1), inner_1 = model.add_piece(1, 1.5, -1);
  const int inner_2 = model.add_piece(1, .2, -1);
  const int lower = model.add_piece(1, 1, -1), upper = model.add_piece(1, 1, -1);
  const int bottom_0 = model.add_piece(1, 1, BOTTOM), bottom_1 = model.add_piece(1, 2, BOTTOM);
  const int right = model.add_piece(1, 2, RIGHT);
  const int top_1 = model.add_piece(1, 2, TOP), top_0 = model.add_piece(1, 1, TOP);
  model.add_cell(1, { { { bottom_0 }, { inner_0 }, { lower }, { left_0 } } });
  model.add_cell(1, { { { lower }, { inner_1 }, { upper }, { left_1 } } });
  model.add_cell(1, { { { upper }, { inner_2 }, { top_0 }, { left_2 } } });
  model.add_cell(1, { { { bottom_1 }, { right }, { top_1 }, { inner_2, inner_1, inner_0 } } });
}

// A 4 x 2 rectangle and a 3 x 2 rectangle to its right. Arc 1 is between them.
Model two_rectangles()
{
  Model model;
  model.add_rectangle(4, 2, .5);
  model.add_rectangle(3, 2, .5);
  model.add_arc(BOTTOM);
  model.add_arc(RIGHT, 6 + LEFT);
  model.add_arc(TOP);
  model.add_arc(LEFT);
  model.add_arc(6 + BOTTOM);
  model.add_arc(6 + RIGHT);
  model.add_arc(6 + TOP);
  return model;
}

TEST(T_mesh_network, sides_of_an_arc_share_its_number)
{
  Model model = two_rectangles();
  add_two_cells(model);
  add_four_cells(model);
  FFi::T_mesh_network network;
  const std::vector<int> value = model.solve(network);
  EXPECT_EQ(network.network.edges.size(), 7u + 7 + 13);
  EXPECT_EQ(network.network.number_of_nodes, 8 + 2 * 6); // sides of arcs, cells
  EXPECT_EQ(network.cell_nodes[0].begin_index, 8);
  EXPECT_EQ(network.cell_nodes[0].end_index, 8 + 2 * 2);
  EXPECT_EQ(network.cell_nodes[1].begin_index, 8 + 2 * 2);
  EXPECT_EQ(network.cell_nodes[1].end_index, 8 + 2 * 6);
  const std::vector<int> arcs(value.begin(), value.begin() + 7);
  EXPECT_EQ(arcs, std::vector<int>({ 8, 4, 8, 4, 6, 4, 6 }));
  EXPECT_EQ(value[network.edge_of_piece(0, 2)], 2); // .9 / h and 1.1 / h
  EXPECT_EQ(value[network.edge_of_piece(1, 1)], 2); // 4 less 1 at either end
}

TEST(T_mesh_network, number_of_edges_of_an_arc_is_kept)
{
  Model model = two_rectangles();
  add_two_cells(model);
  add_four_cells(model);
  model.targets.number_of_edges.assign(7, 0);
  model.targets.number_of_edges[1] = 7;
  model.targets.number_of_edges[4] = 2;
  FFi::T_mesh_network network;
  const std::vector<int> value = model.solve(network);
  EXPECT_EQ(value[1], 7);
  EXPECT_EQ(value[3], 7);
  EXPECT_EQ(value[5], 7);
  EXPECT_EQ(value[6], 2);

  model.targets.number_of_edges[5] = 6; // opposite to arc 1
  EXPECT_FALSE(quantize(t_mesh_network(model.surface, model.features, model.t_meshes, model.targets).network)
                 .is_feasible);
}

TEST(T_mesh_network, patches_without_t_mesh_get_even_numbers)
{
  Model model = two_rectangles();
  add_two_cells(model);
  model.surface.length[RIGHT] = 1.5; // target 3
  for(const double edge_length : { .21, .3, .5, .7, 1.1, 3., 100. })
  {
    model.targets.edge_length = { edge_length, edge_length };
    FFi::T_mesh_network network;
    const std::vector<int> value = model.solve(network);
    for(const int arc : { 1, 4, 5, 6 })
      EXPECT_EQ(value[arc] % 2, 0) << arc;
  }
  model.targets.number_of_edges = { 0, 5, 0, 0, 0, 0, 0 };
  EXPECT_FALSE(quantize(t_mesh_network(model.surface, model.features, model.t_meshes, model.targets).network)
                 .is_feasible);
}

TEST(T_mesh_network, both_sides_of_an_arc_in_one_patch)
{
  Model model;
  model.add_rectangle(4, 2, .5); // a tube
  model.add_arc(BOTTOM, -1, true);
  model.add_arc(LEFT, RIGHT);
  model.add_arc(TOP, -1, true);
  add_two_cells(model);
  model.t_meshes[0].pieces[4].length = .2; // the T-nodes of the two sides are at other places
  model.t_meshes[0].pieces[5].length = 1.8;
  FFi::T_mesh_network network;
  std::vector<int> value = model.solve(network);
  EXPECT_EQ(network.network.number_of_nodes, 4 + 2 * 2);
  EXPECT_EQ(value[0], 8);
  EXPECT_EQ(value[1], 4);

  model.targets.edge_length = { 100 };
  value = model.solve(network);
  EXPECT_EQ(value[0], 3); // a loop has room for a quad mesh then
  EXPECT_EQ(value[1], 2);
}

TEST(T_mesh_network, lengths_of_both_patches_count)
{
  Model model = two_rectangles();
  add_two_cells(model);
  add_four_cells(model);
  model.targets.edge_length = { 1, .25 };
  const FFi::T_mesh_network network = t_mesh_network(model.surface, model.features, model.t_meshes, model.targets);
  EXPECT_DOUBLE_EQ(network.network.edges[0].target, 4);
  EXPECT_DOUBLE_EQ(network.network.edges[1].target, 4); // 2 / sqrt(1 * .25)
  EXPECT_DOUBLE_EQ(network.network.edges[1].weight, 2 / 4.);
  EXPECT_DOUBLE_EQ(network.network.edges[5].target, 8);
  EXPECT_DOUBLE_EQ(network.network.edges[network.edge_of_piece(1, 1)].target, 6);
  EXPECT_DOUBLE_EQ(network.network.edges[network.edge_of_piece(1, 1)].weight, 1 / 6.);
}

} // namespace
