#include <CGAL/Frame_fields/internal/matching/Convex_flow.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

// The flow on small graphs against all flows.
namespace {

using CGAL::Frame_fields::internal::Convex_flow;

// Arc k of the graph has the halves 2k and 2k + 1, and costs weight (flow - target)^2 with |target| <= 1/2.
struct Small_graph
{
  std::vector<int> from, to, flow;
  std::vector<double> weight, target;
  std::vector<int> index, lower, upper; // per node

  int number_of_nodes() const { return static_cast<int>(index.size()); }
  int reverse(const int arc) const { return arc ^ 1; }
  int source(const int arc) const { return arc % 2 == 0 ? from[arc / 2] : to[arc / 2]; }
  double cost(const int arc) const
  {
    const double now = flow[arc / 2] - target[arc / 2], sign = arc % 2 == 0 ? 1 : -1;
    return weight[arc / 2] * ((now + sign) * (now + sign) - now * now);
  }
  void push(const int arc) { flow[arc / 2] += arc % 2 == 0 ? 1 : -1; }
  bool has_room(const int node) const { return index[node] < upper[node]; }
  bool has_spare(const int node) const { return index[node] > lower[node]; }
  template <typename Visit>
  void for_each_arc(const int node, const Visit& visit) const
  {
    for(int arc = 0; arc < 2 * static_cast<int>(from.size()); ++arc)
      if(source(arc) == node)
        visit(arc, source(reverse(arc)));
  }

  double total_cost() const
  {
    double sum = 0;
    for(std::size_t k = 0; k < from.size(); ++k)
      sum += weight[k] * (flow[k] - target[k]) * (flow[k] - target[k]);
    return sum;
  }
};

Small_graph random_graph(std::mt19937& random, const int nodes, const int arcs, const int largest_index)
{
  const auto integer = [&](const int begin, const int end) // both included; std:: distributions differ by platform
  {
    return begin + static_cast<int>(random() % static_cast<unsigned int>(end - begin + 1));
  };
  Small_graph graph;
  for(int k = 0; k < arcs; ++k)
  {
    graph.from.push_back(k < nodes - 1 ? k : integer(0, nodes - 1)); // the first ones are a path through all nodes
    graph.to.push_back(k < nodes - 1 ? k + 1 : integer(0, nodes - 1));
    graph.flow.push_back(0);
    graph.weight.push_back(integer(1, 100) / 10.);
    graph.target.push_back(integer(-50, 50) / 100.);
  }
  for(int node = 0; node < nodes; ++node)
  {
    graph.index.push_back(integer(-largest_index, largest_index));
    graph.lower.push_back(integer(-1, 1));
    graph.upper.push_back(graph.lower.back() + integer(0, 1));
  }
  return graph;
}

// The least cost of all flows of at most `largest` on each arc that bring the indices between their bounds.
double least_cost(const Small_graph& given, const int largest)
{
  Small_graph graph = given;
  std::fill(graph.flow.begin(), graph.flow.end(), -largest);
  double best = std::numeric_limits<double>::infinity();
  while(true)
  {
    std::vector<int> index = given.index;
    for(std::size_t k = 0; k < graph.flow.size(); ++k)
    {
      index[graph.from[k]] -= graph.flow[k];
      index[graph.to[k]] += graph.flow[k];
    }
    bool is_feasible = true;
    for(std::size_t node = 0; node < index.size(); ++node)
      is_feasible = is_feasible && index[node] >= graph.lower[node] && index[node] <= graph.upper[node];
    if(is_feasible)
      best = (std::min)(best, graph.total_cost());
    std::size_t k = 0;
    while(k < graph.flow.size() && graph.flow[k] == largest)
      graph.flow[k++] = -largest;
    if(k == graph.flow.size())
      return best;
    ++graph.flow[k];
  }
}

// Moves units until all indices are between their bounds; false if one cannot come there.
bool solve(Small_graph& graph)
{
  typedef Convex_flow<Small_graph> Flow;
  Flow flow(graph);
  for(const Flow::Direction direction : { Flow::OUT, Flow::IN })
    for(int node = 0; node < graph.number_of_nodes(); ++node)
      while(direction == Flow::OUT ? graph.index[node] > graph.upper[node] : graph.index[node] < graph.lower[node])
      {
        const int end = flow.move_unit(node, direction);
        if(end < 0)
          return false;
        graph.index[node] += direction == Flow::OUT ? -1 : 1;
        graph.index[end] += direction == Flow::OUT ? 1 : -1;
      }
  return true;
}

bool exceeds(const Small_graph& graph, const int largest)
{
  return *std::max_element(graph.flow.begin(), graph.flow.end()) > largest
      || *std::min_element(graph.flow.begin(), graph.flow.end()) < -largest;
}

TEST(Convex_flow, costs_least_among_all_flows)
{
  std::mt19937 random(11);
  int number_of_feasible_ones = 0, number_of_moved_ones = 0;
  for(int round = 0; round < 600; ++round)
  {
    SCOPED_TRACE(round);
    const int nodes = 2 + round % 3;
    const Small_graph given = random_graph(random, nodes, nodes - 1 + static_cast<int>(random() % 3), 1);
    const double expected = least_cost(given, 3);
    Small_graph graph = given;
    if(!solve(graph))
    {
      EXPECT_EQ(std::numeric_limits<double>::infinity(), expected);
      continue;
    }
    ASSERT_FALSE(exceeds(graph, 3)) << "the oracle does not try so much";
    ++number_of_feasible_ones;
    number_of_moved_ones += graph.flow != given.flow;
    EXPECT_NEAR(expected, graph.total_cost(), 1e-9);
    std::vector<int> index = given.index;
    for(std::size_t k = 0; k < graph.flow.size(); ++k)
    {
      index[graph.from[k]] -= graph.flow[k];
      index[graph.to[k]] += graph.flow[k];
    }
    EXPECT_EQ(index, graph.index);
  }
  EXPECT_GT(number_of_feasible_ones, 150);
  EXPECT_GT(number_of_moved_ones, 100);
}

// The more units move, the more often a later path takes back a part of an earlier one.
TEST(Convex_flow, costs_least_where_many_units_move)
{
  std::mt19937 random(12);
  int number_of_moved_ones = 0;
  for(int round = 0; round < 1500; ++round)
  {
    SCOPED_TRACE(round);
    const int nodes = 3 + round % 2;
    const Small_graph given = random_graph(random, nodes, nodes + 1, 4);
    Small_graph graph = given;
    if(!solve(graph) || exceeds(graph, 3))
      continue;
    number_of_moved_ones += graph.flow != given.flow;
    EXPECT_NEAR(least_cost(given, 3), graph.total_cost(), 1e-9);
  }
  EXPECT_GT(number_of_moved_ones, 150);
}

// At first only some nodes take units, then only others do; what the first ones have stays there.
TEST(Convex_flow, costs_least_when_other_nodes_join_the_hub)
{
  typedef Convex_flow<Small_graph> Flow;
  std::mt19937 random(13);
  int number_of_joined_ones = 0;
  for(int round = 0; round < 300; ++round)
  {
    SCOPED_TRACE(round);
    Small_graph graph = random_graph(random, 4, 5, 0);
    // Node 0 has too much, or too little. Node 1 is the first that has room, or can give.
    const Flow::Direction direction = round % 2 == 0 ? Flow::OUT : Flow::IN;
    const int sign = direction == Flow::OUT ? 1 : -1;
    const int number_for_first = 1 + static_cast<int>(random() % 2), number_for_others = number_for_first;
    graph.index[0] = sign * (number_for_first + number_for_others);
    graph.lower.assign(4, 0);
    graph.upper.assign(4, 0);
    (direction == Flow::OUT ? graph.upper : graph.lower)[1] = sign * number_for_first;
    Small_graph given = graph;
    Flow flow(graph);
    const auto move_all = [&]
    {
      for(int end = 0; graph.index[0] != 0 && (end = flow.move_unit(0, direction)) >= 0;)
      {
        graph.index[0] -= sign;
        graph.index[end] += sign;
      }
    };
    move_all();
    ASSERT_EQ(sign * number_for_others, graph.index[0]);
    graph.lower[1] = graph.upper[1] = graph.index[1];
    for(const int node : { 2, 3 })
      (direction == Flow::OUT ? graph.upper : graph.lower)[node] = sign * number_for_others;
    flow.join_to_hub(direction, [&](const int node)
                     { return direction == Flow::OUT ? graph.has_room(node) : graph.has_spare(node); });
    move_all();
    ASSERT_EQ(0, graph.index[0]);
    if(exceeds(graph, 3))
      continue;
    ++number_of_joined_ones;
    given.lower = graph.lower;
    given.upper = graph.upper;
    EXPECT_NEAR(least_cost(given, 3), graph.total_cost(), 1e-9);
  }
  EXPECT_GT(number_of_joined_ones, 100);
}

} // namespace
