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

#ifndef CGAL_FRAME_FIELDS_INTERNAL_MAPS_READ_GUIDANCE_H
#define CGAL_FRAME_FIELDS_INTERNAL_MAPS_READ_GUIDANCE_H

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/No_index_target.h>
#include <CGAL/Frame_fields/internal/surface/Coordinates.h>
#include <CGAL/Frame_fields/internal/surface/Cut_mesh.h>
#include <CGAL/Frame_fields/internal/surface/Cut_surface.h>
#include <CGAL/Frame_fields/internal/surface/index_target.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <string>

namespace CGAL {
namespace Frame_fields {
namespace internal {

// Reads what a caller asks of a field, guiding directions and index targets, into the cut surface.

// The weight of guiding directions for which none is given.
template <typename Face>
struct Unit_weight_map
{
  typedef Face key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;

  friend double get(const Unit_weight_map&, const Face&) { return 1; }
};

template <typename NamedParameters, typename Tag>
constexpr bool is_given = !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value;

// Reads guiding directions and their weights, which must not be negative. A face with a constrained edge is not guided.
// An infinite weight aligns any other face.
template <typename TriangleMesh, typename DirectionMap, typename WeightMap, typename GeomTraits>
Result read_guidance(Cut_mesh<TriangleMesh>& cut_mesh, const DirectionMap guiding_direction,
                     const WeightMap guiding_weight, const GeomTraits& traits)
{
  Cut_surface& surface = cut_mesh.surface();
  surface.guide_angle.assign(surface.number_of_faces(), 0);
  surface.guide_weight.assign(surface.number_of_faces(), 0);
  for(int f = 0; f < surface.number_of_faces(); ++f)
  {
    const auto face = cut_mesh.face_descriptors()[f];
    const double weight = get(guiding_weight, face);
    if(!(weight >= 0))
      return failure(ERROR_WRONG_FIELD, "the guiding weight is negative or not a number in "
                                        + cut_mesh.description_of_face(f));
    if(weight == 0 || surface.is_aligned(f))
      continue;
    const double angle = cut_mesh.angle_in_face(f, coordinates_of(get(guiding_direction, face), traits));
    if(!std::isfinite(angle))
      return failure(ERROR_WRONG_FIELD, "the guiding direction is not finite or perpendicular to "
                                        + cut_mesh.description_of_face(f));
    if(std::isinf(weight))
      surface.alignment[f] = angle;
    else
    {
      surface.guide_angle[f] = angle;
      surface.guide_weight[f] = weight;
    }
  }
  return {};
}

// Reads 4 I per sector. The halfedges of a sector must not contradict one another, and the targets of a patch, with the
// natural indices of its other sectors, must sum to 4 times its Euler characteristic.
template <typename TriangleMesh, typename TargetMap>
Result read_index_targets(Cut_mesh<TriangleMesh>& cut_mesh, const TargetMap index_target)
{
  Cut_surface& surface = cut_mesh.surface();
  surface.index_target.assign(surface.number_of_sectors(), NO_INDEX_TARGET);
  for(int h = 0; h < surface.number_of_halfedges(); ++h)
  {
    const int given = get(index_target, cut_mesh.halfedge_of(h));
    int& target = surface.index_target[surface.sector[h]];
    if(given == NO_INDEX_TARGET || given == target)
      continue;
    if(given < -largest_index_target || given > largest_index_target)
      return failure(ERROR_WRONG_FIELD, "the index target is beyond +-" + std::to_string(largest_index_target)
                                        + "/4 at " + cut_mesh.description_of_sector(surface.sector[h]));
    if(target != NO_INDEX_TARGET)
      return failure(ERROR_WRONG_FIELD, "two index targets for the sector of "
                                        + cut_mesh.description_of_sector(surface.sector[h]));
    target = given;
  }
  for(const Patch& patch : surface.patches)
    if(has_index_targets(surface, patch))
      if(const long long missing = missing_index(surface, patch); missing != 0)
        return failure(ERROR_POINCARE_HOPF, std::to_string(missing) + "/4 is missing in the patch of "
                                            + cut_mesh.description_of_sector(patch.sectors.begin_index));
  return {};
}

// Reads both from the named parameters, if they are given.
template <typename TriangleMesh, typename NamedParameters, typename GeomTraits>
Result read_guidance_and_targets(Cut_mesh<TriangleMesh>& cut_mesh, const NamedParameters& np, const GeomTraits& traits)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  if constexpr(is_given<NamedParameters, internal::guiding_direction_t>)
  {
    typedef typename CGAL::internal_np::Lookup_named_param_def<
      internal::guiding_weight_t, NamedParameters,
      Unit_weight_map<typename Cut_mesh<TriangleMesh>::face_descriptor> >::type Weight_map;
    const Result result = read_guidance(
      cut_mesh, get_parameter(np, internal::guiding_direction),
      choose_parameter<Weight_map>(get_parameter(np, internal::guiding_weight)), traits);
    if(!result)
      return result;
  }
  if constexpr(is_given<NamedParameters, internal::index_target_t>)
    return read_index_targets(cut_mesh, get_parameter(np, internal::index_target));
  return {};
}

} // namespace internal
} // namespace Frame_fields
} // namespace CGAL

#endif // CGAL_FRAME_FIELDS_INTERNAL_MAPS_READ_GUIDANCE_H
