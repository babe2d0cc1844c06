#ifndef FRAME_FIELDS_PROGRAMS_QUADS_H
#define FRAME_FIELDS_PROGRAMS_QUADS_H

#include "Quad_options.h"

#include "../shared/Console.h"
#include "../shared/Mesh.h"
#include "../shared/Model.h"
#include "../shared/field_parameters.h"

#include <CGAL/Frame_fields/Quad_statistics.h>
#include <CGAL/Frame_fields/cad_quad_mesh.h>
#include <CGAL/Frame_fields/parameters.h>
#include <CGAL/Frame_fields/quad_mesh_blocks.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

// A quadrangle mesh with its feature edges, borders among them, the patch of each face, and its block if asked for.
// CGAL writes the integers to PLY files under their names.
struct Quads
{
  Mesh mesh;
  Feature_map is_feature = mesh.add_property_map<Edge, bool>("e:is_feature", false).first;
  Mesh::Property_map<Face, int> patch = mesh.add_property_map<Face, int>("f:patch", 0).first;
  std::optional<Mesh::Property_map<Face, int> > block;
  std::optional<std::size_t> number_of_blocks;
  CGAL::Frame_fields::Quad_statistics statistics;
};

// Shows the stages of the library on a console.
struct Quad_stage_visitor : Stage_visitor
{
  using Stage_visitor::Stage_visitor;
  using Stage_visitor::start_stage;

  void start_stage(const CGAL::Frame_fields::Quad_stage stage) { console->show_progress(activity(stage)); }

  static const char* activity(const CGAL::Frame_fields::Quad_stage stage)
  {
    switch(stage)
    {
      case CGAL::Frame_fields::Quad_stage::PREPARATION:  return "preparing the triangles";
      case CGAL::Frame_fields::Quad_stage::FIELD:        return "computing the frame field";
      case CGAL::Frame_fields::Quad_stage::SEAMLESS_MAP: return "mapping the patches to the plane";
      case CGAL::Frame_fields::Quad_stage::T_MESH:       return "dividing the patches into cells";
      case CGAL::Frame_fields::Quad_stage::QUANTIZATION: return "choosing the numbers of edges";
      case CGAL::Frame_fields::Quad_stage::ASSEMBLY:     return "assembling the quadrangles";
      case CGAL::Frame_fields::Quad_stage::SMOOTHING:    return "smoothing the quadrangles";
    }
    return "";
  }
};

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for(const Edge e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / static_cast<double>(mesh.number_of_edges());
}

// The length that the edges of quadrangles have if they are as many as asked for, or of the triangles.
inline double edge_length_of(const Mesh& mesh, const Quad_options& options)
{
  if(!options.number_of_quads)
    return options.edge_length.value_or(mean_edge_length(mesh));
  double area = 0;
  for(const Face f : mesh.faces())
  {
    const Halfedge h = mesh.halfedge(f);
    area += std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                         mesh.point(mesh.target(mesh.next(h)))));
  }
  return std::sqrt(area / *options.number_of_quads);
}

inline void compute_quads(const Model& model, const Feature_map is_feature, const Quad_options& options,
                          Console& console, Quads& quads)
{
  namespace parameters = CGAL::Frame_fields::parameters;
  const double infinity = (std::numeric_limits<double>::infinity)();
  const bool has_bounds = options.chord_height || options.edges_across_gap;
  const auto np = parameters::output_edge_is_constrained_map(quads.is_feature)
                    .face_to_patch_map(quads.patch)
                    .statistics(std::ref(quads.statistics))
                    .visitor(Quad_stage_visitor(console))
                    .target_edge_length(edge_length_of(model.mesh, options))
                    .refine_long_triangles(options.refines)
                    .chord_height(options.chord_height.value_or(infinity))
                    .edges_across_gap(options.edges_across_gap.value_or(0))
                    .gradation(has_bounds ? options.gradation.value_or(1.5) : infinity)
                    .minimum_edge_length(options.minimum_edge_length.value_or(0))
                    .field_follows_sizes(options.field_follows_sizes);
  check(CGAL::Frame_fields::cad_quad_mesh(
          model.mesh, quads.mesh, parameters::join(np, all_field_parameters(model, is_feature, options))), options);
}

inline void divide_into_blocks(const Quad_options& options, Quads& quads)
{
  if(!options.blocks)
    return;
  quads.block = quads.mesh.add_property_map<Face, int>("f:block", 0).first;
  quads.number_of_blocks = 0;
  check(CGAL::Frame_fields::quad_mesh_blocks(
          quads.mesh, *quads.block, CGAL::Frame_fields::parameters::edge_is_constrained_map(quads.is_feature)
                                      .t_junctions(t_junctions_from(*options.blocks))
                                      .number_of_blocks(std::ref(*quads.number_of_blocks))), options);
}

#endif // FRAME_FIELDS_PROGRAMS_QUADS_H
