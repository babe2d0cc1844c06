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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MAKE_T_MESH_H
#define CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MAKE_T_MESH_H

#include <CGAL/Frame_fields/internal/layout/Motorcycle_graph.h>
#include <CGAL/Frame_fields/internal/layout/Seamless_charts.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh_cells.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh_graph.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh_nodes.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/quarter_turns_of_sector.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/patches.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

enum class T_mesh_status
{
  COMPLETE,
  NOT_CERTIFIED,      // the patch has no certified map
  TOO_LONG,           // `Motorcycle_graph::run()` failed: the traces exceed its bounds, or the map is wrong

  // These do not happen in a certified map.
  WRONG_SECTOR,       // a sector does not have as many ports as its index says
  OVERLAPPING_PIECES, // or a piece without length
  NO_RECTANGLES       // a cell is no rectangle, or not all cells are disks
};

struct T_mesh_result
{
  T_mesh_status status;
  T_mesh mesh; // empty unless the status is COMPLETE
};

// Makes the T-mesh of a patch from its certified map: the motorcycle graph of the ports of all singular sectors.
class T_mesh_maker
{
public:
  T_mesh_maker(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index, const Seamless_map& map)
    : m_surface(surface), m_patch(patch), m_index(index), m_charts(surface, map), m_is_node(patch.sectors.size(), 0)
    , m_motorcycles(m_charts, patch) {}

  T_mesh_result make(const std::vector<char>& is_arc_node)
  {
    for(int sector = m_patch.sectors.begin_index; sector < m_patch.sectors.end_index; ++sector)
      if((m_index[sector] != 0 || is_arc_node[sector]) && !add_node(sector))
        return { T_mesh_status::WRONG_SECTOR, {} };
    if(is_torus_or_annulus() && !add_virtual_ports())
      return { T_mesh_status::WRONG_SECTOR, {} };
    if(!m_motorcycles.run())
      return { T_mesh_status::TOO_LONG, {} };

    const T_mesh_nodes nodes(m_charts, m_patch, m_is_node, m_motorcycles);
    T_mesh_graph graph(m_charts, m_patch, m_index, nodes);
    if(!graph.build(m_motorcycles))
      return { T_mesh_status::OVERLAPPING_PIECES, {} };
    T_mesh_cells cells(m_charts, graph);
    if(!cells.build())
      return { T_mesh_status::NO_RECTANGLES, {} };
    const std::size_t characteristic = nodes.nodes().size() - graph.pieces().size() + cells.cells().size();
    if(static_cast<int>(characteristic) != euler_characteristic(m_patch))
      return { T_mesh_status::NO_RECTANGLES, {} };
    return { T_mesh_status::COMPLETE, { nodes.nodes(), graph.pieces(), std::move(cells.cells()) } };
  }

private:
  // Returns whether a sector has as many ports as its index says. A regular one on constrained edges needs none.
  bool add_node(const int sector)
  {
    m_is_node[sector - m_patch.sectors.begin_index] = 1;
    const bool is_constrained = m_surface.is_constrained_sector(sector);
    return (m_index[sector] == 0 && is_constrained) || add_ports(sector);
  }

  bool add_ports(const int sector)
  {
    const int quads = quarter_turns_of_sector(m_surface, m_index, sector);
    const std::vector<Port> ports = m_charts.ports(sector);
    for(const Port& port : ports)
      m_motorcycles.add_trace(sector, port);
    const int expected = m_surface.is_constrained_sector(sector) ? quads - 1 : quads;
    return quads >= 1 && static_cast<int>(ports.size()) == expected;
  }

  // Without ports all sectors are regular or convex corners, and the number of corners is four times the Euler
  // characteristic. So the patch is a torus, an annulus, or a rectangle. A rectangle needs no ports.
  bool is_torus_or_annulus() const
  {
    return m_motorcycles.traces().empty() && euler_characteristic(m_patch) == 0;
  }

  // One port from the border to the other border, or the four ports of a vertex of the torus, make all cells disks.
  bool add_virtual_ports()
  {
    int best = m_patch.sectors.begin_index;
    for(int sector = best; sector < m_patch.sectors.end_index; ++sector)
      if(rank(sector) > rank(best))
        best = sector;
    m_is_node[best - m_patch.sectors.begin_index] = 1;
    return add_ports(best);
  }

  int rank(const int sector) const
  {
    return m_surface.is_constrained_sector(sector) ? 1 + m_is_node[sector - m_patch.sectors.begin_index] : 0;
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<int>& m_index;
  Seamless_charts m_charts;
  std::vector<char> m_is_node; // per sector of the patch
  Motorcycle_graph m_motorcycles;
};

// The T-mesh of a patch. `patch` must be an element of `surface.patches`; different patches may run in parallel.
// `index` (4 I) and `is_arc_node` are per sector of the whole surface. A sector with `is_arc_node` becomes a node, and
// so does every sector with a nonzero index. A torus and an annulus without such sectors get one node on their own.
inline T_mesh_result make_T_mesh(const Cut_surface& surface, const Patch& patch, const std::vector<int>& index,
                                 const Seamless_map& map, const std::vector<char>& is_arc_node)
{
  const std::size_t number = static_cast<std::size_t>(&patch - surface.patches.data());
  if(map.status[number] != Map_status::CERTIFIED)
    return { T_mesh_status::NOT_CERTIFIED, {} };
  return T_mesh_maker(surface, patch, index, map).make(is_arc_node);
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_LAYOUT_MAKE_T_MESH_H
