#ifndef FRAME_FIELDS_PROGRAMS_INDEX_TARGETS_H
#define FRAME_FIELDS_PROGRAMS_INDEX_TARGETS_H

#include "Failure.h"
#include "Mesh.h"
#include "Model.h"
#include "input_file.h"

#include <CGAL/Frame_fields/No_index_target.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <map>
#include <sstream>
#include <string>

typedef boost::property_map<Mesh, CGAL::dynamic_halfedge_property_t<int> >::const_type Index_target_map;

// 4 I for parts, from a file with a vertex index of the model and 4 I on each line.
inline std::map<std::size_t, int> read_index_targets(const std::string& path, const Model& model)
{
  std::map<std::size_t, int> targets;
  for_each_line(path, [&](const std::size_t line_number, const std::string& content)
  {
    std::istringstream words(content);
    long long vertex;
    int target;
    if(!(words >> vertex >> target) || !(words >> std::ws).eof())
      throw Failure(BAD_FILE, path + ":" + std::to_string(line_number) + ": a line must hold a vertex index and 4 I");
    if(vertex < 0 || vertex >= static_cast<long long>(model.part_in_file.size()))
      throw Failure(BAD_FILE, path + ":" + std::to_string(line_number) + ": the model has no vertex "
                              + std::to_string(vertex));
    targets[model.part_in_file[vertex]] = target;
  });
  return targets;
}

inline bool is_on_feature(const Mesh& mesh, const Feature_map is_feature, const Vertex v)
{
  for(const Halfedge h : CGAL::halfedges_around_target(v, mesh))
    if(is_feature[mesh.edge(h)])
      return true;
  return false;
}

// The targets on the halfedges of the mesh. A vertex on a feature edge has several sectors, so that it cannot be meant.
inline Index_target_map mark_index_targets(const std::string& path, const Model& model, const Feature_map is_feature)
{
  const std::map<std::size_t, int> targets = read_index_targets(path, model);
  const Index_target_map result = get(CGAL::dynamic_halfedge_property_t<int>(), model.mesh);
  for(const Halfedge h : model.mesh.halfedges())
    put(result, h, CGAL::Frame_fields::NO_INDEX_TARGET);
  for(std::size_t k = 0; k < model.part_in_mesh.size(); ++k)
  {
    const Vertex v(static_cast<Mesh::size_type>(k));
    const auto found = targets.find(model.part_in_mesh[k]);
    if(found == targets.end() || model.mesh.is_isolated(v))
      continue;
    if(is_on_feature(model.mesh, is_feature, v))
      throw Failure(BAD_FILE, path + ": vertex " + std::to_string(k) + " is on a feature edge; only vertices on none "
                              "can be given an index");
    for(const Halfedge h : CGAL::halfedges_around_target(v, model.mesh))
      put(result, h, found->second);
  }
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_INDEX_TARGETS_H
