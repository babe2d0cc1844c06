#ifndef FRAME_FIELDS_PROGRAMS_FIELD_H
#define FRAME_FIELDS_PROGRAMS_FIELD_H

#include "Options.h"

#include "../shared/Console.h"
#include "../shared/Mesh.h"
#include "../shared/Model.h"
#include "../shared/field_parameters.h"

#include <CGAL/Frame_fields.h>

#include <CGAL/tags.h>

#include <functional>
#include <iterator>
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

inline Field compute_field(Model& model, const Feature_map is_feature, const Options& options, Console& console)
{
  Mesh& mesh = model.mesh;
  namespace parameters = CGAL::Frame_fields::parameters;
  Field field(mesh);
  const auto np = parameters::matching_map(field.matching)
                    .prescribed_rotation_map(field.prescribed_rotation)
                    .sharp_corner_output_iterator(std::back_inserter(field.sharp_corners))
                    .repaired_sector_output_iterator(std::back_inserter(field.repaired_sectors))
                    .statistics(std::ref(field.statistics))
                    .visitor(Stage_visitor(console));
  call_with_field_parameters(model, is_feature, options, [&](const auto& field_parameters)
  {
    check(CGAL::Frame_fields::cad_frame_field(mesh, field.alpha, field.rho, field.index,
                                              parameters::join(np, field_parameters)), options);
  });
  if(options.is_verbose)
    check(CGAL::Frame_fields::frame_field_quality(mesh, field.alpha, field.rho, field.matching,
                                                  parameters::edge_is_constrained_map(is_feature)
                                                    .edge_weighting(options.edge_weighting)
                                                    .quality(std::ref(field.quality))),
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

#endif // FRAME_FIELDS_PROGRAMS_FIELD_H
