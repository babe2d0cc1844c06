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
#include <CGAL/Frame_fields/internal/layout/Trace.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/parameterization/quarter_turns_of_sector.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

enum class T_mesh_status
{
  COMPLETE,
  NOT_CERTIFIED,     // the patch has no certified map
  WRONG_SECTOR,      // a sector does not have the ports of its index
  TOO_LONG,          // the traces exceed their bounds
  OVERLAPPING_PIECES,
  NO_RECTANGLES      // a cell is no rectangle, or not all cells are disks
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
    : m_surface(surface), m_patch(patch), m_index(index), m_charts(surface, map)
    , m_is_node(patch.sectors.size(), 0), m_has_ports(patch.sectors.size(), 0)
    , m_motorcycles(m_charts, patch, m_has_ports) {}

  T_mesh_result make(const std::vector<char>& is_arc_node)
  {
    for(int sector = m_patch.sectors.begin_index; sector < m_patch.sectors.end_index; ++sector)
      if(!add_node(sector, is_arc_node[sector] != 0))
        return { T_mesh_status::WRONG_SECTOR, {} };
    const bool has_border = 3 * m_patch.faces.size() > 2 * m_patch.dual_edges.size();
    if(!has_border && m_motorcycles.traces().empty() && m_patch.sectors.size() > 0
       && !add_node(m_patch.sectors.begin_index, true))
      return { T_mesh_status::WRONG_SECTOR, {} };

    // Each virtual port but the first one cuts an annulus, of which there are not more than pieces.
    for(int round = 0; round <= 3 * m_patch.faces.size(); ++round)
    {
      if(!m_motorcycles.run())
        return { T_mesh_status::TOO_LONG, {} };
      T_mesh_graph graph(m_charts, m_patch, m_index, m_motorcycles);
      if(!graph.build(m_is_node))
        return { T_mesh_status::OVERLAPPING_PIECES, {} };
      T_mesh_cells cells(m_charts, graph);
      if(!cells.build())
        break;
      if(cells.loop_without_corner() < 0)
        return finish(graph);
      if(!add_virtual_port(graph, cells.loop_without_corner()))
        break;
    }
    return { T_mesh_status::NO_RECTANGLES, {} };
  }

private:
  // Adds the ports of a sector if it needs them. Returns whether it has as many as its index says.
  bool add_node(const int sector, const bool is_marked)
  {
    const int quads = quarter_turns_of_sector(m_surface, m_index, sector);
    const bool is_constrained = m_surface.is_constrained_sector(sector), is_regular = m_index[sector] == 0;
    const int place = sector - m_patch.sectors.begin_index;
    if(is_regular && !is_marked)
      return true;
    m_is_node[place] = 1;
    if(is_regular && is_constrained)
      return true;
    m_has_ports[place] = 1;
    const std::vector<Port> ports = m_charts.ports(sector);
    if(quads < 1 || static_cast<int>(ports.size()) != quads - (is_constrained ? 1 : 0))
      return false;
    for(const Port& port : ports)
      m_motorcycles.add_trace(sector, port);
    return true;
  }

  // Starts a trace from the first node of a loop without corner, into the annulus to the left of it.
  bool add_virtual_port(const T_mesh_graph& graph, const int directed_piece)
  {
    const int node = graph.source(directed_piece);
    const T_mesh_location& location = graph.location(node);
    const int slot = (graph.slot(directed_piece) + 1) % graph.number_of_slots(node);
    if(location.sector < 0)
    {
      m_motorcycles.add_trace(location, slot);
      return location.halfedge < 0;
    }
    m_is_node[location.sector - m_patch.sectors.begin_index] = 1;
    for(const Port& port : m_charts.ports(location.sector))
      if(port.slot == slot)
      {
        m_motorcycles.add_trace(location.sector, port);
        return true;
      }
    return false;
  }

  T_mesh_result finish(T_mesh_graph& graph) const
  {
    const T_mesh& mesh = graph.mesh();
    const std::size_t number = mesh.nodes.size() + mesh.cells.size() - mesh.pieces.size();
    if(static_cast<int>(number) != euler_characteristic(m_patch))
      return { T_mesh_status::NO_RECTANGLES, {} };
    return { T_mesh_status::COMPLETE, std::move(graph.mesh()) };
  }

  const Cut_surface& m_surface;
  const Patch& m_patch;
  const std::vector<int>& m_index;
  Seamless_charts m_charts;
  std::vector<char> m_is_node, m_has_ports; // per sector of the patch
  Motorcycle_graph m_motorcycles;
};

// The T-mesh of one patch; patches may run in parallel. `index` is 4 I per sector. A sector with `is_arc_node` becomes
// a node, and so does every one that is not regular. With a certified map the status is COMPLETE or TOO_LONG.
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
