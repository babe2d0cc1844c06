#ifndef FRAME_FIELDS_PROGRAMS_COMPARED_FIELD_H
#define FRAME_FIELDS_PROGRAMS_COMPARED_FIELD_H

#include "Options.h"
#include "Summary.h"
#include "field_formats.h"
#include "read_field.h"

#include "../shared/Failure.h"
#include "../shared/Mesh.h"
#include "../shared/Model.h"
#include "../shared/sectors.h"

#include <CGAL/Frame_fields/frame_field_from_vectors.h>
#include <CGAL/Frame_fields/frame_field_quality.h>
#include <CGAL/Frame_fields/singularity_indices.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <cstddef>
#include <string>
#include <vector>

typedef Mesh::Property_map<Face, Vector> Direction_map;

// The field of another program, before faces of the model are split.
inline std::vector<Directions> read_compared_field(const std::string& path, const Model& model)
{
  if(!model.has_faces_of_file)
    throw Failure(BAD_FILE, path + ": a field can only be compared on a triangle mesh that needs no repair");
  std::vector<Directions> field = read_field(path, model.mesh.number_of_faces());
  if(field_format_of(path) == ROSY)
    for(const Face f : model.mesh.faces())
      field[f][1] = CGAL::cross_product(CGAL::Polygon_mesh_processing::compute_face_normal(f, model.mesh), field[f][0]);
  return field;
}

// The face of the model that each face of a mesh with split faces is a part of: the one of the first faces that has the
// same new vertex.
inline std::vector<Face> faces_before_split(const Mesh& mesh, const std::size_t number_of_faces,
                                            const std::size_t number_of_vertices)
{
  std::vector<Face> face_of_center(mesh.number_of_vertices());
  std::vector<Face> result;
  for(const Face f : mesh.faces())
  {
    result.push_back(f);
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      if(v.idx() >= number_of_vertices)
      {
        if(f.idx() < number_of_faces)
          face_of_center[v] = f;
        result.back() = face_of_center[v];
      }
  }
  return result;
}

inline Compared_figures compare_field(const Options& options, const std::vector<Directions>& field, const Mesh& mesh,
                                      const std::size_t number_of_vertices, const Feature_map is_feature,
                                      const std::vector<Sector>& all_sectors)
{
  const auto check = [&](const CGAL::Frame_fields::Result& result)
  {
    if(!result)
      throw Failure(BAD_FILE, *options.compared_field + ": " + result.message);
  };
  const auto u = get(CGAL::dynamic_face_property_t<Vector>(), mesh);
  const auto v = get(CGAL::dynamic_face_property_t<Vector>(), mesh);
  const std::vector<Face> before = faces_before_split(mesh, field.size(), number_of_vertices);
  for(const Face f : mesh.faces())
  {
    put(u, f, field[before[f]][0]);
    put(v, f, field[before[f]][1]);
  }

  const auto alpha = get(CGAL::dynamic_face_property_t<double>(), mesh);
  const auto rho = get(CGAL::dynamic_face_property_t<double>(), mesh);
  const auto matching = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
  const auto index = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
  const auto np = CGAL::Frame_fields::parameters::edge_is_constrained_map(is_feature);
  Compared_figures result;
  check(CGAL::Frame_fields::frame_field_from_vectors(
    mesh, u, v, alpha, rho, matching, np.maximum_misalignment(std::ref(result.maximum_misalignment))));
  check(CGAL::Frame_fields::singularity_indices(mesh, alpha, matching, index, np.skewness_map(rho)));
  check(CGAL::Frame_fields::frame_field_quality(mesh, alpha, rho, matching,
                                                np.edge_weighting(options.edge_weighting)
                                                  .quality(std::ref(result.quality))));
  count_indices(all_sectors, index, result.interior_indices, result.constrained_indices);
  result.number_of_unmeshable_sectors = find_unmeshable_sectors(mesh, is_feature, all_sectors, index).size();
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_COMPARED_FIELD_H
