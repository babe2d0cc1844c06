// Copyright (c) 2026 The Frame_fields authors.
// All rights reserved.
//
// This file is part of Frame_fields, a package in the form of CGAL's (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Frame_fields authors

// Integers on bidirected networks against enumeration, and networks whose best integers are known.

#include <CGAL/Frame_fields/internal/quantization/Bidirected_network.h>
#include <CGAL/Frame_fields/internal/quantization/Integral_solution.h>
#include <CGAL/Frame_fields/internal/quantization/Node_multipliers.h>
#include <CGAL/Frame_fields/internal/quantization/Quantizer.h>
#include <CGAL/Frame_fields/internal/quantization/group_to_free.h>
#include <CGAL/Frame_fields/internal/quantization/quantize.h>
#include <CGAL/Frame_fields/internal/quantization/unattainable_edges.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

using CGAL::Frame_fields::internal::Bidirected_edge;
using CGAL::Frame_fields::internal::Bidirected_network;
using CGAL::Frame_fields::internal::Index_range;
using CGAL::Frame_fields::internal::Integral_solution;
using CGAL::Frame_fields::internal::Node_multipliers;
using CGAL::Frame_fields::internal::Quantization;
using CGAL::Frame_fields::internal::Quantization_options;
using CGAL::Frame_fields::internal::Quantizer;
using CGAL::Frame_fields::internal::group_to_free;
using CGAL::Frame_fields::internal::quantize;
using CGAL::Frame_fields::internal::unattainable_edges;

const int no_bound = (std::numeric_limits<int>::max)();

// The same numbers with every standard library, which distributions do not give.
int random_number(std::mt19937& generator, const int bound) { return static_cast<int>(generator() % bound); }

Bidirected_edge edge(const int node_0, const int sign_0, const int node_1, const int sign_1, const double target,
                     const int lower_bound = 1, const int upper_bound = no_bound, const double weight = 1)
{
  return { { node_0, node_1 }, { sign_0, sign_1 }, target, weight, lower_bound, upper_bound };
}

double cost(const Bidirected_network& network, const std::vector<int>& value)
{
  double sum = 0;
  for(std::size_t e = 0; e < value.size(); ++e)
    sum += network.edges[e].weight * std::pow(value[e] - network.edges[e].target, 2);
  return sum;
}

std::vector<long long> node_sums(const Bidirected_network& network, const std::vector<int>& value)
{
  std::vector<long long> sum(network.number_of_nodes, 0);
  for(std::size_t e = 0; e < value.size(); ++e)
    for(int end = 0; end < 2; ++end)
      if(network.edges[e].node[end] >= 0)
        sum[network.edges[e].node[end]] += network.edges[e].sign[end] * static_cast<long long>(value[e]);
  return sum;
}

bool solves(const Bidirected_network& network, const std::vector<int>& value)
{
  for(std::size_t e = 0; e < network.edges.size(); ++e)
    if(value[e] < network.edges[e].lower_bound || value[e] > network.edges[e].upper_bound)
      return false;
  for(const long long sum : node_sums(network, value))
    if(sum != 0)
      return false;
  return true;
}

// Expects what must hold of every result.
void check(const Bidirected_network& network, const Quantization& result)
{
  if(result.is_feasible)
  {
    ASSERT_EQ(result.value.size(), network.edges.size());
    EXPECT_TRUE(solves(network, result.value));
    EXPECT_NEAR(result.cost, cost(network, result.value), 1e-9 * (1 + result.cost));
    EXPECT_LE(result.cost_bound, result.cost * (1 + 1e-9));
    EXPECT_TRUE(result.unattainable.empty() && result.conflicting.empty());
  }
  else
    EXPECT_FALSE(result.unattainable.empty() && result.conflicting.empty()) << "says no, but does not say why";
}

// Tries all values, with the sums kept as it goes.
class Enumeration
{
public:
  explicit Enumeration(const Bidirected_network& network)
    : m_network(network), m_value(network.edges.size())
  {
    enumerate(0);
  }

  bool is_feasible() const { return !m_best.empty() || m_network.edges.empty(); }
  double least_cost() const { return cost(m_network, m_best); }

private:
  void enumerate(const std::size_t e)
  {
    if(e == m_value.size())
    {
      if(solves(m_network, m_value) && (m_best.empty() || cost(m_network, m_value) < cost(m_network, m_best)))
        m_best = m_value;
      return;
    }
    // The last edge of a node is not free, but this is an oracle: it takes all.
    for(int n = m_network.edges[e].lower_bound; n <= m_network.edges[e].upper_bound; ++n)
    {
      m_value[e] = n;
      enumerate(e + 1);
    }
  }

  const Bidirected_network& m_network;
  std::vector<int> m_value, m_best;
};

// Up to 6 edges with few values each; some are fixed, some have free ends or both ends at one node. Half of the
// networks have targets that leave many ties. With `is_bipartite` each edge has opposite signs, as in ordinary flows.
Bidirected_network small_network(const unsigned seed, const bool is_bipartite)
{
  std::mt19937 generator(seed);
  Bidirected_network network;
  network.number_of_nodes = 1 + random_number(generator, 4);
  const int number_of_edges = 1 + random_number(generator, 6);
  const bool has_ties = random_number(generator, 2) == 0;
  for(int e = 0; e < number_of_edges; ++e)
  {
    std::array<int, 2> node, sign;
    for(int end = 0; end < 2; ++end)
    {
      node[end] = random_number(generator, 7) == 0 ? -1 : random_number(generator, network.number_of_nodes);
      sign[end] = random_number(generator, 2) == 0 ? -1 : 1;
    }
    if(is_bipartite)
      sign[1] = -sign[0];
    const double target = has_ties ? random_number(generator, 9) / 2. : random_number(generator, 1000) / 250.;
    const double weight = has_ties ? 1 : .1 + random_number(generator, 100) / 50.;
    const int lower = random_number(generator, 3), kind = random_number(generator, 8);
    const int upper = lower + (kind < 2 ? 0 : kind == 2 ? 1 : 3);
    network.edges.push_back(edge(node[0], sign[0], node[1], sign[1], target, lower, upper, weight));
  }
  return network;
}

// What the given options reach on small networks, out of those that have a solution.
struct Tally
{
  int feasible = 0, infeasible = 0, best = 0, claimed = 0;
};

Tally compare_with_enumeration(const Quantization_options& options, const bool is_bipartite, const unsigned count)
{
  Tally tally;
  for(unsigned seed = 0; seed < count; ++seed)
  {
    SCOPED_TRACE(seed);
    const Bidirected_network network = small_network(seed, is_bipartite);
    const Enumeration enumeration(network);
    const Quantization result = quantize(network, options);
    EXPECT_EQ(result.is_feasible, enumeration.is_feasible());
    check(network, result);
    ++(enumeration.is_feasible() ? tally.feasible : tally.infeasible);
    if(!enumeration.is_feasible() || !result.is_feasible)
      continue;
    const double least = enumeration.least_cost();
    EXPECT_LE(result.cost_bound, least + 1e-9);
    EXPECT_GE(result.cost, least - 1e-9);
    tally.best += result.cost < least + 1e-9;
    tally.claimed += result.is_optimal;
    EXPECT_TRUE(!result.is_optimal || result.cost < least + 1e-9);
  }
  return tally;
}

TEST(Quantization, small_networks_get_the_best_integers)
{
  const Tally tally = compare_with_enumeration(Quantization_options(), false, 4000);
  EXPECT_GT(tally.feasible, 500);
  EXPECT_GT(tally.infeasible, 500);
  EXPECT_EQ(tally.best, tally.feasible);
  EXPECT_EQ(tally.claimed, tally.feasible);
}

// In an ordinary flow, the best halves are integers. So nothing need be searched.
TEST(Quantization, ordinary_flows_are_optimal_without_search)
{
  Quantization_options options;
  options.maximum_number_of_flows = 0;
  options.maximum_number_of_strip_rounds = 0;
  const Tally tally = compare_with_enumeration(options, true, 3000);
  EXPECT_GT(tally.feasible, 300);
  EXPECT_EQ(tally.claimed, tally.feasible);
}

// Without branch and bound, matchings still decide what is feasible, and strips still lead to good integers.
TEST(Quantization, verdicts_need_no_branch_and_bound)
{
  Quantization_options options;
  options.maximum_number_of_flows = 0;
  options.joins_by_paths = false;
  const Tally with_strips = compare_with_enumeration(options, false, 3000);
  options.maximum_number_of_strip_rounds = 0;
  const Tally without_strips = compare_with_enumeration(options, false, 3000);
  EXPECT_GT(with_strips.best, without_strips.best);
  EXPECT_GE(with_strips.best, .99 * with_strips.feasible);
}

// The paths alone lead nearly everywhere, and what they do not join, the matchings do.
TEST(Quantization, paths_join_odd_components)
{
  Quantization_options options;
  options.maximum_number_of_flows = 0;
  const Tally with_strips = compare_with_enumeration(options, false, 3000);
  EXPECT_GE(with_strips.best, .99 * with_strips.feasible);
  options.maximum_number_of_strip_rounds = 0;
  const Tally with_paths = compare_with_enumeration(options, false, 3000);
  options.joins_by_paths = false;
  EXPECT_GT(with_paths.best, compare_with_enumeration(options, false, 3000).best);
}

// a rows of b cells: each row has one number in all of its pieces, each column too.
Bidirected_network grid(const int a, const int b, const std::vector<double>& row_target,
                        const std::vector<double>& column_target)
{
  Bidirected_network network;
  network.number_of_nodes = 2 * a * b;
  for(int i = 0; i < a; ++i)
    for(int j = 0; j <= b; ++j)
      network.edges.push_back(edge(j == 0 ? -1 : 2 * (i * b + j - 1), 1, j == b ? -1 : 2 * (i * b + j), -1,
                                   row_target[i] + (j % 2 == 0 ? .2 : -.2)));
  for(int j = 0; j < b; ++j)
    for(int i = 0; i <= a; ++i)
      network.edges.push_back(edge(i == 0 ? -1 : 2 * ((i - 1) * b + j) + 1, 1, i == a ? -1 : 2 * (i * b + j) + 1, -1,
                                   column_target[j] + (i % 2 == 0 ? .2 : -.2)));
  return network;
}

TEST(Quantization, rows_and_columns_of_a_grid_are_rounded)
{
  const std::vector<double> rows = { .1, 1.2, 3.7, 1000000.4 }, columns = { 1e-9, 2.9, 7.1, 5, 6, 1.3, 12.8 };
  const Bidirected_network network = grid(4, 7, rows, columns);
  const Quantization result = quantize(network);
  ASSERT_TRUE(result.is_feasible && result.is_optimal);
  std::vector<int> expected;
  for(const double row : rows)
    expected.insert(expected.end(), 8, (std::max)(1, static_cast<int>(std::lround(row))));
  for(const double column : columns)
    expected.insert(expected.end(), 5, (std::max)(1, static_cast<int>(std::lround(column))));
  EXPECT_EQ(result.value, expected);
}

// An edge with twice the same sign at a node: 2 x = y + z.
TEST(Quantization, doubled_edges_make_their_partners_even)
{
  Bidirected_network network;
  network.number_of_nodes = 1;
  network.edges = { edge(0, 1, 0, 1, 2.4), edge(0, -1, -1, 1, 2), edge(0, -1, -1, 1, 3, 1, no_bound, 2) };
  const Quantization result = quantize(network);
  ASSERT_TRUE(result.is_feasible && result.is_optimal);
  EXPECT_EQ(result.value, std::vector<int>({ 2, 1, 3 })); // 1.16; { 3, 3, 3 } would cost 1.36

  network.edges[1] = edge(0, -1, -1, 1, 2, 2, 2); // 2 x = 2 + z
  network.edges[2] = edge(0, -1, -1, 1, 3, 3, 3); // and z = 3
  const Quantization odd = quantize(network);
  EXPECT_FALSE(odd.is_feasible);
  EXPECT_EQ(odd.conflicting, std::vector<int>({ 1, 2 }));
}

// A triangle all of whose edges are added at both ends, and one fixed edge taken away at one corner.
TEST(Quantization, parity_without_free_end)
{
  for(const int fixed : { 1, 2, 3, 4 })
  {
    Bidirected_network network;
    network.number_of_nodes = 4;
    for(int i = 0; i < 3; ++i)
      network.edges.push_back(edge(i, 1, (i + 1) % 3, -1, 2.5));
    network.edges.push_back(edge(0, 1, 3, 1, 2.5));            // 0 - 1 + 3 and 2 - 3 stand for strips with a turn
    network.edges.push_back(edge(3, -1, 3, -1, 1, 0));         // so the fixed number must be even
    network.edges.push_back(edge(0, -1, -1, 1, fixed, fixed, fixed));
    const Quantization result = quantize(network);
    EXPECT_EQ(result.is_feasible, fixed % 2 == 0) << fixed;
    check(network, result);
    network.edges.push_back(edge(3, -1, -1, 1, 1, 0));         // a free end takes what is left
    EXPECT_TRUE(quantize(network).is_feasible) << fixed;
  }
}

TEST(Quantization, fixed_numbers_are_kept)
{
  Bidirected_network network = grid(3, 3, { 2, 2, 2 }, { 4, 4, 4 });
  network.edges[5].lower_bound = network.edges[5].upper_bound = 9;
  const Quantization result = quantize(network);
  ASSERT_TRUE(result.is_feasible);
  for(int e = 0; e < 12; ++e)
    EXPECT_EQ(result.value[e], e / 4 == 1 ? 9 : 2);

  network.edges[6].lower_bound = network.edges[6].upper_bound = 8; // in the same row
  const Quantization contradiction = quantize(network);
  EXPECT_FALSE(contradiction.is_feasible);
  EXPECT_TRUE(std::count(contradiction.conflicting.begin(), contradiction.conflicting.end(), 5));
  EXPECT_TRUE(std::count(contradiction.conflicting.begin(), contradiction.conflicting.end(), 6));
}

TEST(Integral_solution, is_found_unless_its_graph_would_be_too_large)
{
  Bidirected_network network = grid(6, 6, { 3, 3, 3, 3, 3, 3 }, { 3, 3, 3, 3, 3, 3 });
  for(std::size_t e = 0; e < network.edges.size(); ++e)
    network.edges[e].lower_bound = static_cast<int>(e % 5);
  std::vector<int> value;
  for(const Bidirected_edge& edge : network.edges)
    value.push_back(edge.lower_bound);
  const std::vector<int> old_value = value;
  EXPECT_FALSE(Integral_solution(network, value).find(100));
  EXPECT_EQ(value, old_value);
  EXPECT_TRUE(Integral_solution(network, value).find());
  for(std::size_t e = 0; e < value.size(); ++e)
    EXPECT_GE(value[e], network.edges[e].lower_bound);
  std::vector<int> sum(network.number_of_nodes, 0);
  for(std::size_t e = 0; e < value.size(); ++e)
    for(int end = 0; end < 2; ++end)
      if(network.edges[e].node[end] >= 0)
        sum[network.edges[e].node[end]] += network.edges[e].sign[end] * value[e];
  EXPECT_EQ(sum, std::vector<int>(network.number_of_nodes, 0));
}

TEST(Quantization, edges_on_no_strip_are_named)
{
  Bidirected_network network = grid(2, 2, { 2, 2 }, { 3, 3 });
  const int a = network.number_of_nodes++;
  network.edges.push_back(edge(a, 1, a, 1, 1)); // 2 n = 0
  network.edges.push_back(edge(0, 1, 0, -1, 1.4)); // no matter
  const int last = static_cast<int>(network.edges.size()) - 1;
  const Quantization result = quantize(network);
  EXPECT_FALSE(result.is_feasible);
  EXPECT_EQ(result.unattainable, std::vector<int>({ last - 1 }));
  EXPECT_EQ(result.value[last], 1);
  EXPECT_EQ(result.value[0], 2); // the other components are solved all the same
  network.edges[last - 1].lower_bound = 0;
  EXPECT_TRUE(quantize(network).is_feasible);
}

// The nodes say a = b + c, a = b, d = e + f, d = e, and that g is free: c and f are 0 in every solution.
TEST(Quantization, group_without_which_most_edges_are_attainable_is_found)
{
  Bidirected_network network;
  network.number_of_nodes = 5;
  for(const int node : { 0, 2 })
  {
    network.edges.push_back(edge(node, 1, node + 1, -1, 2));
    network.edges.push_back(edge(node, -1, node + 1, 1, 2));
    network.edges.push_back(edge(node, -1, -1, 1, 2));
  }
  network.edges.push_back(edge(4, 1, -1, 1, 2));
  network.edges.push_back(edge(4, -1, -1, 1, 2));
  ASSERT_EQ(unattainable_edges(network), std::vector<int>({ 2, 5 }));
  const Index_range others{ 4, 5 }, first{ 0, 1 }, second{ 2, 3 }, both{ 1, 4 };
  const int no_limit = 1000;
  EXPECT_EQ(group_to_free(network, { others }, no_limit), -1);
  EXPECT_EQ(group_to_free(network, { others, second, first }, no_limit), 1);
  EXPECT_EQ(group_to_free(network, { first, others, both }, no_limit), 2);
  EXPECT_EQ(group_to_free(network, { first, others, both }, 1), 0);
  for(Bidirected_edge& e : network.edges)
    e.lower_bound = 0;
  EXPECT_EQ(group_to_free(network, { first, both }, no_limit), -1);
}

TEST(Quantization, bounds_that_exclude_one_another)
{
  Bidirected_network network = grid(1, 1, { 2 }, { 3 });
  network.edges[1].lower_bound = 5;
  network.edges[1].upper_bound = 4;
  const Quantization result = quantize(network);
  EXPECT_FALSE(result.is_feasible);
  EXPECT_EQ(result.conflicting, std::vector<int>({ 1 }));
}

TEST(Quantization, any_numbers_are_taken)
{
  for(const double target : { 0., -5., 1e-300, 1e300, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN() })
    for(const double weight : { 0., 1e-300, 1e300, std::numeric_limits<double>::quiet_NaN() })
    {
      Bidirected_network network = grid(2, 3, { 2, 2 }, { 3, 3, 3 });
      network.edges[1].target = target;
      network.edges[6].weight = weight;
      const Quantization result = quantize(network);
      EXPECT_TRUE(result.is_feasible);
      EXPECT_TRUE(solves(network, result.value));
    }
}

TEST(Quantization, empty_networks)
{
  EXPECT_TRUE(quantize(Bidirected_network()).is_feasible);
  Bidirected_network network;
  network.number_of_nodes = 3;
  EXPECT_TRUE(quantize(network).is_feasible);
}

// Strips in random directions between neighbours in a row of nodes, with free ends.
Bidirected_network large_network(const unsigned seed, const int number_of_edges)
{
  std::mt19937 generator(seed);
  Bidirected_network network;
  network.number_of_nodes = number_of_edges / 2;
  for(int e = 0; e < number_of_edges; ++e)
  {
    const int node_0 = random_number(generator, network.number_of_nodes);
    const int node_1 = (node_0 + random_number(generator, 40)) % network.number_of_nodes;
    const int sign_0 = random_number(generator, 2) == 0 ? -1 : 1, sign_1 = random_number(generator, 2) == 0 ? -1 : 1;
    const double target = random_number(generator, 100) == 0 ? random_number(generator, 1000000)
                                                             : std::exp(random_number(generator, 2000) / 600. - 1);
    network.edges.push_back(edge(random_number(generator, 10) == 0 ? -1 : node_0, sign_0, node_1, sign_1, target, 1,
                                 no_bound, 1 / (std::max)(1., target)));
  }
  for(const int e : unattainable_edges(network))
    network.edges[e].lower_bound = 0;
  return network;
}

TEST(Quantization, large_networks_are_solved_near_the_optimum)
{
  for(unsigned seed = 0; seed < 5; ++seed)
  {
    const Bidirected_network network = large_network(seed, 1500);
    const Quantization result = quantize(network);
    ASSERT_TRUE(result.is_feasible);
    check(network, result);
    EXPECT_LE(result.cost, 1.01 * result.cost_bound);
  }
}

TEST(Quantization, repetition_gives_the_same)
{
  const Bidirected_network network = large_network(7, 600);
  const Quantization first = quantize(network), second = quantize(network);
  EXPECT_EQ(first.value, second.value);
  EXPECT_EQ(first.cost, second.cost);
}

// Lazily raised bounds keep what is solvable solvable, as long as nothing is bounded from above.
TEST(Quantization, raised_lower_bounds_stay_feasible)
{
  Bidirected_network network = large_network(3, 400);
  ASSERT_TRUE(quantize(network).is_feasible);
  double last_cost = 0;
  for(int round = 0; round < 5; ++round)
  {
    for(std::size_t e = round; e < network.edges.size(); e += 7)
      if(network.edges[e].lower_bound > 0)
        ++network.edges[e].lower_bound;
    const Quantization result = quantize(network);
    ASSERT_TRUE(result.is_feasible);
    check(network, result);
    EXPECT_GE(result.cost, last_cost - 1e-9);
    last_cost = result.cost_bound;
  }
}

// Every run knows the bounds as they are then, also after runs without solution.
TEST(Quantizer, small_networks_get_the_best_integers_after_each_change_of_bounds)
{
  int number_of_solutions = 0, number_of_failures = 0;
  for(unsigned seed = 0; seed < 500; ++seed)
  {
    SCOPED_TRACE(seed);
    Bidirected_network network = small_network(seed, false);
    std::mt19937 generator(seed);
    Quantizer quantizer(network);
    for(int run = 0; run < 6; ++run)
    {
      const Quantization result = quantizer.run();
      const Enumeration enumeration(network);
      EXPECT_EQ(result.is_feasible, enumeration.is_feasible());
      check(network, result);
      ++(result.is_feasible ? number_of_solutions : number_of_failures);
      if(result.is_feasible && enumeration.is_feasible())
      {
        EXPECT_TRUE(result.is_optimal);
        EXPECT_NEAR(result.cost, enumeration.least_cost(), 1e-9);
      }
      Bidirected_edge& edge =
        network.edges[random_number(generator, static_cast<int>(network.edges.size()))];
      edge.lower_bound = random_number(generator, 3);
      edge.upper_bound = edge.lower_bound + random_number(generator, 3);
    }
  }
  EXPECT_GT(number_of_solutions, 300);
  EXPECT_GT(number_of_failures, 300);
}

// Rows of cells with one piece on each side: most edges are in chains. The flow is as good as one from scratch.
TEST(Quantizer, raised_bounds_in_chains)
{
  std::mt19937 generator(5);
  Bidirected_network network = large_network(11, 600);
  const int number_of_strips = static_cast<int>(network.edges.size());
  for(int e = 0; e < number_of_strips; ++e)
    for(int piece = 0; piece < 3; ++piece)
    {
      const int node = network.number_of_nodes++;
      Bidirected_edge rest = network.edges[e];
      network.edges[e].node[1] = rest.node[0] = node;
      network.edges[e].sign[1] = piece == 1 ? -1 : 1;
      rest.sign[0] = -network.edges[e].sign[1];
      rest.target += random_number(generator, 10) / 10.;
      network.edges.push_back(rest);
      std::swap(network.edges[e], network.edges.back()); // the next one is cut off from what is left
    }
  Quantizer quantizer(network);
  for(int round = 0; round < 4; ++round)
  {
    const Quantization result = quantizer.run(), from_scratch = quantize(network);
    ASSERT_TRUE(result.is_feasible && from_scratch.is_feasible);
    check(network, result);
    EXPECT_LE(result.cost_bound, from_scratch.cost * (1 + 1e-9));
    EXPECT_LE(from_scratch.cost_bound, result.cost * (1 + 1e-9));
    EXPECT_LE(result.cost, 1.02 * from_scratch.cost);
    if(!result.is_optimal && !from_scratch.is_optimal)
    {
      EXPECT_NEAR(result.cost_bound, from_scratch.cost_bound, 1e-9 * result.cost_bound);
    }
    for(std::size_t e = round; e < network.edges.size(); e += 40)
      if(network.edges[e].lower_bound > 0)
        network.edges[e].lower_bound = result.value[e] + 1;
  }
}

TEST(Multipliers, of_one_node_make_its_sum_zero_in_one_sweep)
{
  for(const int sign : { 1, -1 })
  {
    Bidirected_network network;
    network.number_of_nodes = 1;
    network.edges = { { { { 0, 0 } }, { { 1, sign } }, 3, 1, -100, 100 },
                      { { { 0, -1 } }, { { 1, 1 } }, 4, 0.5, -100, 100 } };
    const double multiplier = Node_multipliers(network).run(1)[0];
    const double at_both_ends = 3 - (1 + sign) * multiplier / 2, at_one_end = 4 - multiplier;
    EXPECT_NEAR(0, (1 + sign) * at_both_ends + at_one_end, 1e-12) << sign;
  }
}

} // namespace
