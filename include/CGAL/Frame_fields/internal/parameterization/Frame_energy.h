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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_FRAME_ENERGY_H
#define CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_FRAME_ENERGY_H

#include <CGAL/Frame_fields/Hermitian_matrix.h>
#include <CGAL/Frame_fields/internal/linear/assemble.h>
#include <CGAL/Frame_fields/internal/linear/elimination_order.h>
#include <CGAL/Frame_fields/internal/parameterization/Combed_field.h>
#include <CGAL/Frame_fields/internal/parameterization/Cut_graph.h>
#include <CGAL/Frame_fields/internal/parameterization/Map_basis.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/Plane_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// The faces and constrained edges of a patch, measured in the frames of the faces. The field asks for the map whose
// differential takes branch 0 to (1, 0) and branch 1 to (0, 1), divided by the target length.
class Map_elements
{
public:
  struct Face
  {
    std::array<int, 3> vertex;            // of the disk
    std::array<Plane_vector, 3> gradient; // of the hat functions of the vertices, in the frame
    double area;                          // in the frame, in square target lengths
    double stiffness = 1;
  };

  struct Side
  {
    int source, target;  // coordinates that grow along the edge, if it has the positive sign
    double length;       // with this sign, in target lengths
    int face;            // of the patch
  };

  Map_elements(const Cut_surface& surface, const Patch& patch, const Combed_field& field, const Cut_graph& graph,
               const std::vector<double>& target_length, const std::vector<Side_edge>& side_edges)
    : Map_elements(surface, patch, [&](const int halfedge) { return field.coordinates(halfedge); }, graph.vertex,
                   [&](const int face) { return target_length[face]; }, side_edges)
  {}

  // `edge_in_frame` gives the components of a halfedge in the frame of its face, `vertex` is per halfedge of the patch:
  // the vertex at its target, `target_length` gives the target length of a face.
  template <typename EdgeInFrame, typename TargetLength>
  Map_elements(const Cut_surface& surface, const Patch& patch, const EdgeInFrame& edge_in_frame,
               const std::vector<int>& vertex, const TargetLength& target_length,
               const std::vector<Side_edge>& side_edges)
  {
    m_faces.reserve(patch.faces.size());
    for(int f = patch.faces.begin_index; f < patch.faces.end_index; ++f)
    {
      const int first = 3 * (f - patch.faces.begin_index);
      const auto scaled = [&](const int halfedge)
      {
        const Plane_vector edge = edge_in_frame(halfedge);
        return Plane_vector{ edge.x / target_length(f), edge.y / target_length(f) };
      };
      m_faces.push_back(element({ scaled(3 * f), scaled(3 * f + 1), scaled(3 * f + 2) },
                                { vertex[first], vertex[first + 1], vertex[first + 2] }));
    }
    for(const Side_edge& e : side_edges)
    {
      const int f = face_of(e.halfedge);
      m_sides.push_back({ 2 * e.source + e.growing_coordinate, 2 * e.target + e.growing_coordinate,
                          e.sign * surface.length[e.halfedge] / target_length(f),
                          f - patch.faces.begin_index });
    }
  }

  const std::vector<Face>& faces() const { return m_faces; }
  const std::vector<Side>& sides() const { return m_sides; }

  double weight(const Face& face) const { return face.stiffness * face.area; }

  // A constrained edge counts as much as its face.
  double weight(const Side& side) const { return weight(m_faces[side.face]); }

  // Multiplies the stiffness of a face by `factor`.
  void stiffen(const int face_of_patch, const double factor) { m_faces[face_of_patch].stiffness *= factor; }

private:
  // A triangle whose height is less than this part of its longest edge counts as one with this height.
  static constexpr double least_height = 1e-4;

  // `edge[k]` runs to vertex k.
  static Face element(std::array<Plane_vector, 3> edge, const std::array<int, 3>& vertex)
  {
    const auto squared_length = [&](const int k) { return dot(edge[k], edge[k]); };
    int longest = 0;
    for(int k = 1; k < 3; ++k)
      if(squared_length(k) > squared_length(longest))
        longest = k;
    const int next = (longest + 1) % 3, last = (longest + 2) % 3;
    const double height = cross(edge[longest], edge[next]) / squared_length(longest);
    if(height < least_height)
    {
      const double missing = least_height - height;
      const Plane_vector rise = missing * quarter_turn(edge[longest]);
      edge[next] = edge[next] + rise;
      edge[last] = edge[last] - rise;
    }
    const double twice_area = cross(edge[longest], edge[next]);
    Face face;
    face.vertex = vertex;
    face.area = twice_area / 2;
    for(int k = 0; k < 3; ++k)
    {
      const Plane_vector& against = edge[(k + 2) % 3]; // from vertex k + 1 to vertex k + 2
      face.gradient[k] = { -against.y / twice_area, against.x / twice_area };
    }
    return face;
  }

  std::vector<Face> m_faces; // per face of the patch
  std::vector<Side> m_sides; // per side edge
};

// The quadratic energy of z: the sum of weight |J - I|^2 over the faces, where J is the differential of x = B z, and of
// `part_of_sides` weight (growth / length - 1)^2 over the constrained edges. Its minimum solves `matrix()` z =
// `right_hand_side()`.
template <typename Basis>
class Frame_energy
{
public:
  Frame_energy(const Map_elements& elements, const Basis& basis) : m_elements(elements), m_basis(basis) {}

  Hermitian_matrix<double> matrix() const
  {
    return assemble<double>(m_basis.size(), [this](const auto& add) { this->for_each_entry(add); });
  }

  template <typename SolverTraits>
  std::vector<int> unknowns_in_elimination_order(const SolverTraits& solver_traits) const
  {
    return elimination_order(m_basis.size(), [this](const auto& add)
    {
      this->for_each_entry([&](const int i, const int j, double)
      {
        if(i != j)
          add(i, j, 1.f);
      });
    }, solver_traits);
  }

  std::vector<double> right_hand_side() const
  {
    std::vector<double> on_coordinates(m_basis.number_of_coordinates(), 0), result;
    for(const Map_elements::Face& face : m_elements.faces())
      for(int k = 0; k < 3; ++k)
      {
        const int u = 2 * face.vertex[k];
        on_coordinates[u] += m_elements.weight(face) * face.gradient[k].x;
        on_coordinates[u + 1] += m_elements.weight(face) * face.gradient[k].y;
      }
    for(const Map_elements::Side& side : m_elements.sides())
    {
      const double value = part_of_sides * m_elements.weight(side) / side.length;
      on_coordinates[side.target] += value;
      on_coordinates[side.source] -= value;
    }
    m_basis.multiply_transposed(on_coordinates, result);
    return result;
  }

private:
  template <typename Add>
  void for_each_entry(const Add& add) const
  {
    for(const Map_elements::Face& face : m_elements.faces())
      for(int a = 0; a < 3; ++a)
        for(int b = 0; b < 3; ++b)
        {
          const double value = m_elements.weight(face) * dot(face.gradient[a], face.gradient[b]);
          for(int c = 0; c < 2; ++c)
            add_product(2 * face.vertex[a] + c, 2 * face.vertex[b] + c, value, add);
        }
    for(const Map_elements::Side& side : m_elements.sides())
    {
      const double value = part_of_sides * m_elements.weight(side) / (side.length * side.length);
      add_product(side.source, side.source, value, add);
      add_product(side.target, side.target, value, add);
      add_product(side.source, side.target, -value, add);
      add_product(side.target, side.source, -value, add);
    }
  }

  // Adds the lower triangle of B^T V B, where V has the one entry `value` between two coordinates.
  template <typename Add>
  void add_product(const int coordinate_i, const int coordinate_j, const double value, const Add& add) const
  {
    m_basis.for_each_term(coordinate_i, [&](const int i, const int factor_i)
    {
      m_basis.for_each_term(coordinate_j, [&](const int j, const int factor_j)
      {
        if(i >= j)
          add(i, j, value * factor_i * factor_j);
      });
    });
  }

  // A smaller value leaves more constrained edges that run backward, a larger one more inverted faces.
  static constexpr double part_of_sides = 0.3;

  const Map_elements& m_elements;
  const Basis& m_basis;
};

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_PARAMETERIZATION_FRAME_ENERGY_H
