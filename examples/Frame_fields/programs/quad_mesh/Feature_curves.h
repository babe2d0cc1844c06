#ifndef FRAME_FIELDS_PROGRAMS_FEATURE_CURVES_H
#define FRAME_FIELDS_PROGRAMS_FEATURE_CURVES_H

#include "../shared/Mesh.h"
#include "../shared/sectors.h"

#include <vector>

// The feature edges of a quadrangle mesh as curves. A curve ends at nodes: at vertices without exactly two feature
// edges, and at those where another number than two quadrangles is on a side of them. A closed curve may have no node.
struct Feature_curves
{
  std::vector<std::vector<Halfedge> > curves; // one after the other
  std::vector<int> curve;                     // by edge: its curve, -1 if it is no feature
  std::vector<int> node;                      // by vertex: the number of the node, -1 if it is none
  std::vector<Vertex> nodes;
};

inline int number_of_faces_of(const Mesh& mesh, const Feature_map is_feature, const Sector& sector)
{
  int number = 0;
  Halfedge h = sector.halfedge;
  do
  {
    ++number;
    if(is_feature[mesh.edge(h)])
      break;
    h = mesh.prev(mesh.opposite(h));
  } while(h != sector.halfedge);
  return number;
}

inline void collect_nodes(const Mesh& mesh, const Feature_map is_feature, Feature_curves& result)
{
  std::vector<int> number_of_features(mesh.num_vertices(), 0);
  std::vector<bool> is_node(mesh.num_vertices(), false);
  for(const Edge e : mesh.edges())
    if(is_feature[e])
      for(const int end : { 0, 1 })
        ++number_of_features[mesh.vertex(e, end)];
  for(const Sector& sector : sectors(mesh, is_feature))
    if(sector.is_constrained && number_of_faces_of(mesh, is_feature, sector) != 2)
      is_node[mesh.target(sector.halfedge)] = true;
  result.node.assign(mesh.num_vertices(), -1);
  for(const Vertex v : mesh.vertices())
    if(number_of_features[v] > 0 && (is_node[v] || number_of_features[v] != 2))
    {
      result.node[v] = static_cast<int>(result.nodes.size());
      result.nodes.push_back(v);
    }
}

// The feature edge that goes on from the target of another one, which is no node.
inline Halfedge next_feature(const Mesh& mesh, const Feature_map is_feature, const Halfedge h)
{
  Halfedge next = mesh.next(h);
  while(!is_feature[mesh.edge(next)])
    next = mesh.next(mesh.opposite(next));
  return next;
}

inline void collect_curve(const Mesh& mesh, const Feature_map is_feature, const Halfedge start, Feature_curves& result)
{
  const int number = static_cast<int>(result.curves.size());
  result.curves.emplace_back();
  Halfedge h = start;
  while(result.curve[mesh.edge(h)] < 0)
  {
    result.curves.back().push_back(h);
    result.curve[mesh.edge(h)] = number;
    if(result.node[mesh.target(h)] >= 0)
      break;
    h = next_feature(mesh, is_feature, h);
  }
}

inline Feature_curves feature_curves(const Mesh& mesh, const Feature_map is_feature)
{
  Feature_curves result;
  collect_nodes(mesh, is_feature, result);
  result.curve.assign(mesh.num_edges(), -1);
  for(const bool has_node : { true, false }) // what the first round leaves is closed
    for(const Edge e : mesh.edges())
      for(const Halfedge h : { mesh.halfedge(e), mesh.opposite(mesh.halfedge(e)) })
        if(is_feature[e] && result.curve[e] < 0 && (!has_node || result.node[mesh.source(h)] >= 0))
          collect_curve(mesh, is_feature, h, result);
  return result;
}

#endif // FRAME_FIELDS_PROGRAMS_FEATURE_CURVES_H
