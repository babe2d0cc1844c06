#ifndef FRAME_FIELDS_PROGRAMS_SECTORS_H
#define FRAME_FIELDS_PROGRAMS_SECTORS_H

#include "Mesh.h"

#include <CGAL/Kernel/global_functions_3.h>

#include <vector>

// A fan of corners around a vertex between two feature edges, or all corners of a vertex on no feature edge. It is
// named by the halfedge whose face has the clockwise-most corner of the fan at its target.
struct Sector
{
  Halfedge halfedge;
  bool is_constrained;
};

inline std::vector<Sector> sectors(const Mesh& mesh, const Feature_map is_feature)
{
  std::vector<Sector> result;
  std::vector<bool> is_on_feature(mesh.num_vertices(), false);
  for(const Halfedge h : mesh.halfedges())
  {
    if(!is_feature[mesh.edge(h)])
      continue;
    is_on_feature[mesh.target(h)] = true;
    if(!mesh.is_border(h))
      result.push_back({ mesh.prev(h), true });
  }
  for(const Vertex v : mesh.vertices())
    if(!is_on_feature[v] && !mesh.is_isolated(v))
      result.push_back({ mesh.halfedge(v), false });
  return result;
}

// The angle of the sector of a halfedge, in degrees.
inline double angle_in_degrees(const Mesh& mesh, const Feature_map is_feature, const Halfedge sector)
{
  double angle = 0;
  Halfedge h = sector;
  do
  {
    angle += CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                     mesh.point(mesh.target(mesh.next(h))));
    if(is_feature[mesh.edge(h)])
      return angle;
    h = mesh.prev(mesh.opposite(h));
  } while(h != sector);
  return angle;
}

#endif // FRAME_FIELDS_PROGRAMS_SECTORS_H
