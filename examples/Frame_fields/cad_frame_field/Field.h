#ifndef CAD_FRAME_FIELD_FIELD_H
#define CAD_FRAME_FIELD_FIELD_H

#include "Console.h"
#include "Failure.h"
#include "Mesh.h"
#include "Model.h"
#include "Options.h"
#include "index_targets.h"

#include "../principal_directions.h"

#include <CGAL/Frame_fields.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <functional>
#include <iterator>
#include <string>
#include <vector>

// A frame field on a mesh, in property maps that CGAL writes to PLY files under their names.
struct Field
{
  explicit Field(Mesh& mesh)
    : alpha(mesh.add_property_map<Face, double>("f:alpha").first)
    , rho(mesh.add_property_map<Face, double>("f:rho").first)
    , matching(mesh.add_property_map<Halfedge, int>("h:matching").first)
    , prescribed_rotation(mesh.add_property_map<Halfedge, double>("h:prescribed_rotation").first)
    , index(mesh.add_property_map<Halfedge, int>("h:index").first)
  {}

  Mesh::Property_map<Face, double> alpha, rho;
  Mesh::Property_map<Halfedge, int> matching;
  Mesh::Property_map<Halfedge, double> prescribed_rotation;
  Mesh::Property_map<Halfedge, int> index;
  std::vector<Halfedge> sharp_corners, repaired_sectors;
  CGAL::Frame_fields::Statistics statistics;
  CGAL::Frame_fields::Field_quality quality;
};

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

inline void check(const CGAL::Frame_fields::Result& result, const Options& options)
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

inline Field compute_field(Model& model, const Feature_map is_feature, const Options& options, Console& console)
{
  Mesh& mesh = model.mesh;
  namespace parameters = CGAL::Frame_fields::parameters;
  Field field(mesh);
  const auto np = parameters::edge_is_constrained_map(is_feature)
                    .support_strategy(support_strategy_from(options.support))
                    .sharp_corner_bound(radians(options.sharp_corner_bound))
                    .edge_weighting(options.edge_weighting)
                    .repair_matching(options.repairs_matching)
                    .relax_orthogonality(options.relaxes_orthogonality)
                    .matching_map(field.matching)
                    .prescribed_rotation_map(field.prescribed_rotation)
                    .sharp_corner_output_iterator(std::back_inserter(field.sharp_corners))
                    .repaired_sector_output_iterator(std::back_inserter(field.repaired_sectors))
                    .statistics(std::ref(field.statistics))
                    .concurrency_tag(CGAL::Parallel_if_available_tag())
                    .visitor(Stage_visitor(console));
  const auto compute = [&](const auto& all_parameters)
  {
    check(CGAL::Frame_fields::cad_frame_field(mesh, field.alpha, field.rho, field.index, all_parameters), options);
  };
  const auto compute_with_targets = [&](const auto& other_parameters)
  {
    if(options.index_targets)
      compute(parameters::join(other_parameters, parameters::index_target_map(
        mark_index_targets(*options.index_targets, model, is_feature))));
    else
      compute(other_parameters);
  };
  if(options.curvature_weight > 0)
    compute_with_targets(parameters::join(np, curvature_guide(mesh, options.curvature_weight)));
  else
    compute_with_targets(np);
  if(options.is_verbose)
    check(CGAL::Frame_fields::frame_field_quality(mesh, field.alpha, field.rho, field.matching, field.quality, np),
          options);
  return field;
}

typedef boost::property_map<Mesh, CGAL::dynamic_halfedge_property_t<int> >::const_type Baseline_index_map;

// The indices of the field without any correction.
inline Baseline_index_map compute_baseline_index(const Mesh& mesh, const Feature_map is_feature, const Options& options)
{
  namespace parameters = CGAL::Frame_fields::parameters;
  const auto unused = get(CGAL::dynamic_face_property_t<double>(), mesh);
  const Baseline_index_map index = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
  const auto np = parameters::edge_is_constrained_map(is_feature)
                    .support_strategy(CGAL::Frame_fields::Support_strategy::none())
                    .repair_matching(false)
                    .relax_orthogonality(false)
                    .concurrency_tag(CGAL::Parallel_if_available_tag());
  check(CGAL::Frame_fields::cad_frame_field(mesh, unused, unused, index, np), options);
  return index;
}

#endif // CAD_FRAME_FIELD_FIELD_H
