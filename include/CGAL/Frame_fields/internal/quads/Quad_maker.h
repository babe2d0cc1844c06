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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_MAKER_H
#define CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_MAKER_H

#include <CGAL/Frame_fields/internal/layout/Feature_network.h>
#include <CGAL/Frame_fields/internal/layout/T_mesh.h>
#include <CGAL/Frame_fields/internal/parameterization/Seamless_map.h>
#include <CGAL/Frame_fields/internal/quads/Expected_valence.h>
#include <CGAL/Frame_fields/internal/quads/Patch_assembly.h>
#include <CGAL/Frame_fields/internal/quads/Quad_complex.h>
#include <CGAL/Frame_fields/internal/quads/Quad_layout.h>
#include <CGAL/Frame_fields/internal/quads/Quad_request.h>
#include <CGAL/Frame_fields/internal/quads/Quantized_layout.h>
#include <CGAL/Frame_fields/internal/quads/Vertex_classes.h>
#include <CGAL/Frame_fields/internal/quads/fill_patch.h>
#include <CGAL/Frame_fields/internal/quads/make_arc_vertices.h>
#include <CGAL/Frame_fields/internal/quads/quad_connectivity.h>
#include <CGAL/Frame_fields/internal/quads/remove_unused_vertices.h>
#include <CGAL/Frame_fields/internal/quads/split_triangles.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Surface_embedding.h>
#include <CGAL/Frame_fields/internal/surface/Surface_walker.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// A vertex of the quads at the vertex of a sector.
struct Vertex_at_sector
{
  int sector, vertex;
};

// Makes quads from the T-meshes of the patches.
//
// Pieces inside patches and on their sides may get no edges, so that tiny ones cost no quads. Then vertices coincide,
// and the quads may not be a manifold any more, or have other irregular vertices than the field. So each round checks
// its quads, and raises the bounds of the pieces at fault, or gives up a patch. The rounds end at the latest when the
// triangles of all patches have been split, as these quads always fit together.
class Quad_maker
{
public:
  // Empties the T-meshes of the patches that are filled.
  Quad_maker(const Cut_surface& surface, const Surface_embedding& embedding, const std::vector<int>& index,
             const Feature_network& features, const Seamless_map& map, std::vector<T_mesh>& t_meshes,
             const double target_edge_length, const Quad_targets& targets = Quad_targets())
    : m_surface(surface), m_embedding(embedding), m_index(index), m_features(features), m_map(map)
    , m_t_meshes(t_meshes), m_layout(surface, embedding, index, features, t_meshes, target_edge_length, targets)
    , m_valence(surface, embedding, index), m_walker(surface, embedding)
  {}

  // The numbers of edges with which the next quads are made.
  Quantized_layout& layout() { return m_layout; }
  const Quantized_layout& layout() const { return m_layout; }

  // The vertices of the complex made last that are at vertices of the T-mesh of a patch and of the triangle mesh.
  const std::vector<Vertex_at_sector>& vertices_at_sectors(const int patch) const
  {
    return m_vertices_at_sectors[patch];
  }

  // The mean length of the sides of the quads, in the unit of `Cut_surface::length`; 0 if there are no quads.
  double mean_length_of_sides(const Quad_complex& complex) const
  {
    std::vector<Coordinates> points;
    for(const Quad_vertex& v : complex.vertices)
      points.push_back(m_walker.point(v.location));
    double sum = 0;
    for(const std::array<int, 4>& quad : complex.quads)
      for(int k = 0; k < 4; ++k)
        sum += distance(points[quad[k]], points[quad[(k + 1) % 4]]);
    return complex.quads.empty() ? 0 : sum / (4 * static_cast<double>(complex.quads.size()));
  }

  // Quantizes and assembles in at most 62 rounds. The quads have no conflicts (see `connect_quads()`).
  Quad_complex make()
  {
    for(m_round = 0; ; ++m_round)
    {
      m_layout.quantize();
      Quad_complex complex;
      if(make_valid(complex))
      {
        finish(complex);
        return complex;
      }
      for(const int patch : m_patches_to_give_up)
        m_layout.give_up(patch);
      m_patches_to_give_up.clear();
      if(m_round == number_of_rounds_with_empty_pieces)
        m_layout.forbid_empty_pieces();
      if(m_round >= maximum_number_of_rounds)
        m_layout.split_all_triangles();
    }
  }

  // Raises bounds so that there is more room around some quads of the complex made last: the empty pieces at their
  // vertices get edges, and if there are none, the quads are divided. Returns whether any bound was raised.
  bool refine(const Quad_complex& complex, const std::vector<int>& quads)
  {
    bool is_any_raised = false;
    for(const int q : quads)
    {
      if(m_origin[q].cell < 0)
        continue;
      bool is_raised = false;
      for(const int v : complex.quads[q])
        for(const int e : m_classes.unknowns_of_class(m_number_in_classes[v]))
          is_raised |= m_layout.raise(e, 1);
      for(int side = 0; side < 2 && !is_raised; ++side)
        for(const Directed_piece& piece : m_t_meshes[m_origin[q].patch].cells[m_origin[q].cell].sides[side])
        {
          const int e = m_layout.unknown_of_piece(m_origin[q].patch, piece.piece);
          is_any_raised |= m_layout.raise(e, m_layout.value(e) + 1);
        }
      is_any_raised |= is_raised;
    }
    return is_any_raised;
  }

private:
  static constexpr int number_of_sparing_rounds = 4;
  static constexpr int number_of_rounds_with_empty_pieces = 40;
  static constexpr int maximum_number_of_rounds = 60;

  // The cell that each quad of a patch with a T-mesh comes from.
  struct Quad_origin
  {
    int patch, cell;
  };

  // Makes quads with the present numbers of edges. Returns whether they are without faults; if not, the bounds have
  // changed or patches are to be given up. Fillings take long, so they are left out while critical vertices coincide.
  bool make_valid(Quad_complex& complex)
  {
    if(m_layout.has_fillings())
    {
      const bool fills = false;
      complex = assemble(fills);
      if(separate_critical_vertices(complex, m_classes.representatives(static_cast<int>(complex.vertices.size()))))
        return false;
    }
    complex = assemble(true);
    return !find_faults(complex);
  }

  // Takes the vertices that were replaced by others out of the complex.
  void finish(Quad_complex& complex)
  {
    const std::vector<int> representative = m_classes.representatives(static_cast<int>(complex.vertices.size()));
    m_number_in_classes = remove_unused_vertices(complex);
    for(std::vector<Vertex_at_sector>& vertices : m_vertices_at_sectors)
      for(Vertex_at_sector& v : vertices)
        v.vertex = static_cast<int>(std::lower_bound(m_number_in_classes.begin(), m_number_in_classes.end(),
                                                     representative[v.vertex]) - m_number_in_classes.begin());
  }

  Quad_complex assemble(const bool fills)
  {
    const std::vector<std::vector<int> > edges_of_piece = m_layout.edges_of_piece();
    const std::vector<int> edges_of_arc = m_layout.edges_of_arc();
    const std::vector<std::vector<int> > breakpoints = m_layout.attainable_breakpoints();
    const std::vector<Patch_source>& sources = m_layout.sources();
    const Quad_layout layout{ m_surface, m_embedding, m_features, m_map, m_t_meshes, sources, m_layout.sides(),
                              edges_of_piece, edges_of_arc, breakpoints, m_layout.tolerance_of_arc() };
    Quad_complex complex;
    m_classes = Vertex_classes();
    m_origin.clear();
    m_singular_sector.clear();
    m_vertices_at_sectors.assign(m_t_meshes.size(), {});
    const Placed_arcs placed_arcs = make_arc_vertices(layout, complex);
    const std::vector<std::vector<int> > arcs = arcs_of_patches(m_layout.sides(), m_t_meshes.size());
    for(std::size_t p = 0; p < m_t_meshes.size(); ++p)
    {
      const int patch = static_cast<int>(p);
      if(sources[p] != Patch_source::T_MESH)
      {
        if(sources[p] == Patch_source::SPLIT_TRIANGLES)
          split_triangles_of_patch(layout, patch, complex);
        else if(fills && !fill_patch(m_walker, m_surface, m_embedding, m_features, patch, complex.arcs,
                                     m_layout.edge_length_of(patch), complex))
          m_patches_to_give_up.push_back(patch);
        m_origin.resize(complex.quads.size(), { patch, -1 });
        continue;
      }
      Patch_assembly assembly(layout, placed_arcs, patch, arcs[p], m_layout.unknown_of_piece(patch, 0), complex,
                              m_classes);
      for(std::size_t cell = 0; cell < m_t_meshes[p].cells.size(); ++cell)
      {
        assembly.fill_cell(m_t_meshes[p].cells[cell]);
        m_origin.resize(complex.quads.size(), { patch, static_cast<int>(cell) });
      }
      note_vertices_at_sectors(patch, assembly, complex);
    }
    m_singular_sector.resize(complex.vertices.size(), -1);
    return complex;
  }

  void note_vertices_at_sectors(const int patch, const Patch_assembly& assembly, const Quad_complex& complex)
  {
    const std::vector<T_mesh_node>& nodes = m_t_meshes[patch].nodes;
    m_singular_sector.resize(complex.vertices.size(), -1);
    for(std::size_t n = 0; n < nodes.size(); ++n)
    {
      const int s = nodes[n].sector;
      if(s < 0)
        continue;
      const int vertex = assembly.vertex_of_node(static_cast<int>(n));
      m_vertices_at_sectors[patch].push_back({ s, vertex });
      if(!m_surface.is_constrained_sector(s) && m_index[s] != 0)
        m_singular_sector[vertex] = s;
    }
  }

  // Whether a vertex must not coincide with another one of its kind.
  bool is_critical(const Quad_complex& complex, const int v) const
  {
    return complex.vertices[v].vertex >= 0 || complex.vertices[v].arc >= 0 || m_singular_sector[v] >= 0;
  }

  // Joins the vertices that coincide and looks for faults. Returns whether there are any, after changing the bounds.
  bool find_faults(Quad_complex& complex)
  {
    const std::vector<int> representative =
      m_classes.representatives(static_cast<int>(complex.vertices.size()));
    if(separate_critical_vertices(complex, representative))
      return true;
    join_vertices(complex, representative);
    if(m_layout.has_only_split_triangles())
      return false;
    if(!m_patches_to_give_up.empty())
      return true;
    const std::vector<int> conflicts = connect_quads(complex).conflicts;
    if(!conflicts.empty())
    {
      for(const int side : conflicts)
        raise_cell_of(side);
      return true;
    }
    if(raise_patches_without_quads())
      return true;
    return raise_at_wrong_valences(complex, representative);
  }

  // Raises bounds of pieces between critical vertices that coincide. Returns whether there are any.
  bool separate_critical_vertices(const Quad_complex& complex, const std::vector<int>& representative)
  {
    std::vector<int> critical(complex.vertices.size(), -1); // per class
    std::vector<std::pair<int, int> > pairs;
    for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    {
      if(!is_critical(complex, static_cast<int>(v)))
        continue;
      int& first = critical[representative[v]];
      if(first < 0)
        first = static_cast<int>(v);
      else
        pairs.emplace_back( first, static_cast<int>(v) );
    }
    for(const std::pair<int, int>& pair : pairs)
      raise_longest_of(m_classes.unknowns_between(pair.first, pair.second));
    return !pairs.empty();
  }

  // Gives at least one edge to the longest of the pieces that can have one, and after some rounds to all of them, so
  // that the rounds come to an end. If none can, gives up the patch that keeps them empty.
  void raise_longest_of(const std::vector<int>& unknowns)
  {
    if(!m_layout.raise_longest(unknowns, m_round >= number_of_sparing_rounds) && !unknowns.empty()
       && m_patches_to_give_up.empty())
      m_patches_to_give_up.push_back(m_layout.patch_that_empties(unknowns));
  }

  // Asks for one more edge on the side of the cell that a side of a quad runs along, or gives up the filling that the
  // quad is of. Sides 0 and 2 of a quad run along sides 0 and 2 of its cell.
  void raise_cell_of(const int side)
  {
    const Quad_origin origin = m_origin[side / 4];
    if(origin.cell < 0)
    {
      const bool is_listed = std::find(m_patches_to_give_up.begin(), m_patches_to_give_up.end(), origin.patch)
                          != m_patches_to_give_up.end();
      if(m_layout.sources()[origin.patch] == Patch_source::FILLING && !is_listed)
        m_patches_to_give_up.push_back(origin.patch);
      return;
    }
    const std::vector<Directed_piece>& pieces = m_t_meshes[origin.patch].cells[origin.cell].sides[side % 2];
    const int unknown = m_layout.unknown_of_piece(origin.patch, pieces.front().piece);
    m_layout.require(unknown, m_layout.value(unknown) + 1);
  }

  // No vertex of a torus without irregular vertices is critical, so all its pieces may have come out empty. If none of
  // them can get an edge, gives up the patch. Returns whether there are such patches.
  bool raise_patches_without_quads()
  {
    std::vector<char> has_quad(m_t_meshes.size(), 0);
    for(const Quad_origin& origin : m_origin)
      has_quad[origin.patch] = 1;
    bool is_any_without = false;
    for(std::size_t patch = 0; patch < m_t_meshes.size(); ++patch)
      if(m_layout.sources()[patch] == Patch_source::T_MESH && !has_quad[patch])
      {
        is_any_without = true;
        bool is_any_raised = false;
        const int number_of_pieces = static_cast<int>(m_t_meshes[patch].pieces.size());
        for(int piece = 0; piece < number_of_pieces; ++piece)
          is_any_raised |= m_layout.raise(m_layout.unknown_of_piece(static_cast<int>(patch), piece), 1);
        if(!is_any_raised)
          m_patches_to_give_up.push_back(static_cast<int>(patch));
      }
    return is_any_without;
  }

  // Replaces each vertex by the representative of its class, which gets the location and the freedom of the critical
  // vertex of the class.
  void join_vertices(Quad_complex& complex, const std::vector<int>& representative)
  {
    if(m_classes.is_empty())
      return;
    for(std::size_t v = 0; v < complex.vertices.size(); ++v)
      if(is_critical(complex, static_cast<int>(v)) && representative[v] != static_cast<int>(v))
      {
        complex.vertices[representative[v]] = complex.vertices[v];
        m_singular_sector[representative[v]] = m_singular_sector[v];
      }
    renumber_vertices(representative, complex);
  }

  // Raises bounds at joined vertices that do not have as many quads as the field asks for. Vertices of fillings and of
  // split triangles are exempt. Returns whether there are any.
  bool raise_at_wrong_valences(const Quad_complex& complex, const std::vector<int>& representative)
  {
    std::vector<int> valence(complex.vertices.size(), 0);
    std::vector<char> is_filled(complex.vertices.size(), 0);
    for(std::size_t q = 0; q < complex.quads.size(); ++q)
      for(const int v : complex.quads[q])
      {
        ++valence[v];
        is_filled[v] = is_filled[v] || m_origin[q].cell < 0;
      }
    bool is_any_wrong = false;
    for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    {
      const int expected = m_valence.of(complex.vertices[v], m_singular_sector[v], m_features);
      if(valence[v] == 0 || is_filled[v] || valence[v] == expected)
        continue;
      const std::vector<int> unknowns = m_classes.unknowns_of_class(representative[v]);
      if(unknowns.empty())
        continue; // the fault is that of a class beside it
      raise_longest_of(unknowns);
      is_any_wrong = true;
    }
    return is_any_wrong;
  }

  const Cut_surface& m_surface;
  const Surface_embedding& m_embedding;
  const std::vector<int>& m_index;
  const Feature_network& m_features;
  const Seamless_map& m_map;
  std::vector<T_mesh>& m_t_meshes;
  Quantized_layout m_layout;
  Expected_valence m_valence;
  Surface_walker m_walker;
  int m_round = 0;
  Vertex_classes m_classes;
  std::vector<int> m_number_in_classes; // per vertex of the complex made last
  std::vector<Quad_origin> m_origin;    // per quad
  std::vector<std::vector<Vertex_at_sector> > m_vertices_at_sectors; // per patch
  std::vector<int> m_singular_sector;   // per vertex: the closed singular sector it is at, -1 if there is none
  std::vector<int> m_patches_to_give_up;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_QUADS_QUAD_MAKER_H
