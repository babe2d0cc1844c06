#ifndef FRAME_FIELDS_PROGRAMS_MESH_H
#define FRAME_FIELDS_PROGRAMS_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Point> Mesh;

typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;

// Tells the feature edges; border edges always are.
typedef Mesh::Property_map<Edge, bool> Feature_map;

#endif // FRAME_FIELDS_PROGRAMS_MESH_H
