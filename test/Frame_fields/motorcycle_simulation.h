#ifndef TEST_MOTORCYCLE_SIMULATION_H
#define TEST_MOTORCYCLE_SIMULATION_H

#include "quad_grid.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace test {

// The motorcycle graph of a Quad_grid by plain simulation from vertex to vertex of the grid. It is the oracle for that
// in a triangulation of the grid in which vertices and charts have been changed.
class Motorcycle_simulation
{
public:
  Motorcycle_simulation(const Quad_grid& quads, const Grid_map& grid) : m_quads(quads), m_grid(grid)
  {
    const Cut_surface& surface = grid.surface;
    m_opposite.assign(4 * quads.vertices.size(), -1);
    m_sector.assign(4 * quads.vertices.size(), -1);
    for(int h = 0; h < surface.number_of_halfedges(); ++h)
      if(grid.side[h] >= 0)
      {
        m_sector[grid.side[h]] = surface.sector[h];
        if(surface.opposite[h] >= 0)
          m_opposite[grid.side[h]] = grid.side[surface.opposite[h]];
      }
    for(const Patch& patch : surface.patches)
      start_traces(patch);
  }

  // Sorted.
  std::vector<std::int64_t> areas_of_cells()
  {
    run();
    std::vector<std::int64_t> areas;
    std::vector<char> is_visited(m_quads.vertices.size(), 0);
    for(int seed = 0; seed < static_cast<int>(is_visited.size()); ++seed)
      if(!is_visited[seed])
        areas.push_back(area_of_cell(seed, is_visited));
    std::sort(areas.begin(), areas.end());
    return areas;
  }

private:
  struct Trace_state
  {
    int side;                     // on which it runs, the way of it
    std::int64_t entry, arrival;  // times
    bool has_ended;
  };

  struct Visit
  {
    int trace, side; // the side on which it would go on
    std::int64_t time;
  };

  static int next_side(const int side) { return side % 4 == 3 ? side - 3 : side + 1; }

  // Behind a regular vertex.
  int straight_on(const int side) const { return next_side(m_opposite[next_side(side)]); }

  bool is_critical(const int sector) const
  {
    const bool is_marked = m_grid.is_arc_node[sector] || m_virtual.count(sector) > 0;
    return m_grid.index[sector] != 0 || (is_marked && !m_grid.surface.is_constrained_sector(sector));
  }

  void start_traces(const Patch& patch)
  {
    bool is_closed_and_regular = true;
    for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
      is_closed_and_regular = is_closed_and_regular && !is_critical(s) && !m_grid.surface.is_constrained_sector(s);
    if(is_closed_and_regular)
      m_virtual.insert(patch.sectors.begin_index);
    for(int s = patch.sectors.begin_index; s < patch.sectors.end_index; ++s)
      if(is_critical(s))
        for_each_corner(m_grid.surface.opposite, m_grid.surface.first_corner[s], [&](const int corner)
        {
          const int outgoing = next_of(corner);
          if(m_grid.side[outgoing] >= 0 && m_opposite[m_grid.side[outgoing]] >= 0)
            m_traces.push_back({ m_grid.side[outgoing], 0, m_quads.length(m_grid.side[outgoing]), false });
        });
  }

  void run()
  {
    for(std::size_t t = 0; t < m_traces.size(); ++t)
      enter(static_cast<int>(t));
    for(;;)
    {
      std::int64_t time = -1;
      for(const Trace_state& trace : m_traces)
        if(!trace.has_ended && (time < 0 || trace.arrival < time))
          time = trace.arrival;
      if(time < 0)
        return;
      arrive(time);
    }
  }

  // All traces that come to a vertex at a time.
  void arrive(const std::int64_t time)
  {
    std::vector<int> arriving;
    for(int t = 0; t < static_cast<int>(m_traces.size()); ++t)
      if(!m_traces[t].has_ended && m_traces[t].arrival == time)
        arriving.push_back(t);
    std::vector<int> on_the_way;
    for(const int t : arriving)
    {
      const int sector = m_sector[m_traces[t].side];
      if(is_critical(sector) || m_grid.surface.is_constrained_sector(sector))
        m_traces[t].has_ended = true;
      else
      {
        m_visits[sector].push_back({ t, straight_on(m_traces[t].side), time });
        on_the_way.push_back(t);
      }
    }
    std::vector<int> ending;
    for(const int t : on_the_way)
      for(const Visit& visit : m_visits[m_sector[m_traces[t].side]])
      {
        const int ahead = straight_on(m_traces[t].side);
        const bool is_same = visit.side == ahead;
        const bool is_against = m_opposite[m_traces[t].side] == visit.side;
        const bool is_first = visit.time < time || (visit.time == time && visit.trace < t);
        if(!is_same && ((is_against && visit.time == time) || (!is_against && is_first)))
          ending.push_back(t);
      }
    for(const int t : ending)
      m_traces[t].has_ended = true;
    for(const int t : on_the_way)
      if(!m_traces[t].has_ended)
      {
        m_traces[t].side = straight_on(m_traces[t].side);
        m_traces[t].entry = time;
        m_traces[t].arrival = time + m_quads.length(m_traces[t].side);
        enter(t);
      }
  }

  // Two traces that meet on a side have both ended.
  void enter(const int t)
  {
    const int side = m_traces[t].side;
    m_is_wall[side] = m_is_wall[m_opposite[side]] = true;
    for(int other = 0; other < static_cast<int>(m_traces.size()); ++other)
      if(other != t && !m_traces[other].has_ended && m_traces[other].side == m_opposite[side]
         && m_traces[other].arrival > m_traces[t].entry && m_traces[other].entry <= m_traces[t].entry)
        m_traces[t].has_ended = m_traces[other].has_ended = true;
  }

  std::int64_t area_of_cell(const int seed, std::vector<char>& is_visited)
  {
    std::int64_t area = 0;
    std::vector<int> stack(1, seed);
    is_visited[seed] = 1;
    while(!stack.empty())
    {
      const int q = stack.back();
      stack.pop_back();
      area += m_quads.sizes[q][0] * m_quads.sizes[q][1];
      for(int side = 4 * q; side < 4 * q + 4; ++side)
        if(m_opposite[side] >= 0 && !m_is_wall[side] && !is_visited[m_opposite[side] / 4])
        {
          is_visited[m_opposite[side] / 4] = 1;
          stack.push_back(m_opposite[side] / 4);
        }
    }
    return area;
  }

  const Quad_grid& m_quads;
  const Grid_map& m_grid;
  std::vector<int> m_opposite, m_sector;        // per side; the sector at its end
  std::set<int> m_virtual;                      // sectors
  std::vector<Trace_state> m_traces;
  std::map<int, std::vector<Visit> > m_visits;  // per sector
  std::map<int, bool> m_is_wall;                // per side
};

} // namespace test

#endif // TEST_MOTORCYCLE_SIMULATION_H
