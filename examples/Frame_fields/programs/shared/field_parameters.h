#ifndef FRAME_FIELDS_PROGRAMS_FIELD_PARAMETERS_H
#define FRAME_FIELDS_PROGRAMS_FIELD_PARAMETERS_H

#include "Failure.h"
#include "Mesh.h"
#include "Model.h"
#include "Shared_options.h"
#include "index_targets.h"

#include "../../principal_directions.h"

#include <CGAL/Frame_fields/Error_code.h>
#include <CGAL/Frame_fields/parameters.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <string>

inline Exit_code exit_code_of(const CGAL::Frame_fields::Error_code error_code)
{
  switch(error_code)
  {
    case CGAL::Frame_fields::ERROR_WRONG_PARAMETER:            return BAD_USAGE;
    case CGAL::Frame_fields::ERROR_NO_RECEIVING_SECTOR:        return NOT_SOLVED;
    case CGAL::Frame_fields::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM: return NOT_SOLVED;
    default:                                                   return BAD_FILE;
  }
}

inline void check(const CGAL::Frame_fields::Result& result, const Shared_options& options)
{
  if(!result)
    throw Failure(exit_code_of(result.error_code), options.model + ": " + result.message);
}

inline double radians(const double degrees)
{
  return degrees * CGAL_PI / 180;
}

// Guides the field by the principal directions of curvature.
inline auto curvature_guide(const Mesh& mesh, const double weight_factor)
{
  const auto direction = get(CGAL::dynamic_face_property_t<Vector>(), mesh);
  const auto weight = get(CGAL::dynamic_face_property_t<double>(), mesh);
  principal_directions(mesh, direction, weight);
  for(const Face f : mesh.faces())
    put(weight, f, weight_factor * get(weight, f));
  return CGAL::Frame_fields::parameters::guiding_direction_map(direction).guiding_weight_map(weight);
}

// The named parameters that the options of the field stand for, but for guidance and index targets.
inline auto field_parameters(const Feature_map is_feature, const Shared_options& options)
{
  return CGAL::Frame_fields::parameters::edge_is_constrained_map(is_feature)
           .support_strategy(support_strategy_from(options.support))
           .sharp_corner_bound(radians(options.sharp_corner_bound))
           .blunt_corner_bound(radians(options.blunt_corner_bound))
           .edge_weighting(options.edge_weighting)
           .repair_matching(options.repairs_matching)
           .relax_orthogonality(options.relaxes_orthogonality)
           .concurrency_tag(CGAL::Parallel_if_available_tag());
}

// Those and guidance and index targets, of weight 0 and for no sector if there are none. So functions that take long to
// compile are compiled once.
inline auto all_field_parameters(const Model& model, const Feature_map is_feature, const Shared_options& options)
{
  namespace parameters = CGAL::Frame_fields::parameters;
  const auto direction = get(CGAL::dynamic_face_property_t<Vector>(), model.mesh);
  const auto weight = get(CGAL::dynamic_face_property_t<double>(), model.mesh);
  for(const Face f : model.mesh.faces())
    put(weight, f, 0);
  const auto guide = parameters::guiding_direction_map(direction).guiding_weight_map(weight);
  Index_target_map target = get(CGAL::dynamic_halfedge_property_t<int>(), model.mesh);
  if(options.index_targets)
    target = mark_index_targets(*options.index_targets, model, is_feature);
  else
    for(const Halfedge h : model.mesh.halfedges())
      put(target, h, CGAL::Frame_fields::NO_INDEX_TARGET);
  return parameters::join(
    parameters::join(field_parameters(is_feature, options), parameters::index_target_map(target)),
    options.curvature_weight > 0 ? curvature_guide(model.mesh, options.curvature_weight) : guide);
}

// Calls `function(np)` with the named parameters that the options of the field stand for.
template <typename Function>
void call_with_field_parameters(const Model& model, const Feature_map is_feature, const Shared_options& options,
                                const Function& function)
{
  namespace parameters = CGAL::Frame_fields::parameters;
  const auto np = field_parameters(is_feature, options);
  const auto call_with_targets = [&](const auto& other_parameters)
  {
    if(options.index_targets)
      function(parameters::join(other_parameters, parameters::index_target_map(
        mark_index_targets(*options.index_targets, model, is_feature))));
    else
      function(other_parameters);
  };
  if(options.curvature_weight > 0)
    call_with_targets(parameters::join(np, curvature_guide(model.mesh, options.curvature_weight)));
  else
    call_with_targets(np);
}

#endif // FRAME_FIELDS_PROGRAMS_FIELD_PARAMETERS_H
