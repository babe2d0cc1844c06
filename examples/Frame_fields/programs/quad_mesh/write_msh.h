#ifndef FRAME_FIELDS_PROGRAMS_WRITE_MSH_H
#define FRAME_FIELDS_PROGRAMS_WRITE_MSH_H

#include "Feature_curves.h"
#include "Quads.h"

#include "../shared/Mesh.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <vector>

// A quadrangle mesh as Gmsh sees it: points are the nodes of the features, curves the feature curves, surfaces the
// patches. Everything has a tag, which is its number plus 1, and each node belongs to what it is inside of.
class Msh_writer
{
public:
  Msh_writer(std::ostream& out, const Quads& quads)
    : m_out(out)
    , m_quads(quads)
    , m_mesh(quads.mesh)
    , m_curves(feature_curves(quads.mesh, quads.is_feature))
    , m_vertices_of_curve(m_curves.curves.size())
  {
    for(const Face f : m_mesh.faces())
      m_number_of_patches = (std::max)(m_number_of_patches, static_cast<std::size_t>(quads.patch[f]) + 1);
    m_faces.resize(m_number_of_patches);
    m_curves_around.resize(m_number_of_patches);
    m_vertices_of_patch.resize(m_number_of_patches);
    for(const Face f : m_mesh.faces())
      m_faces[quads.patch[f]].push_back(f);
    classify_vertices();
    collect_curves_around_patches();
  }

  void write() const
  {
    m_out.precision(17);
    m_out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_physical_names();
    write_entities();
    write_nodes();
    write_elements();
  }

private:
  typedef CGAL::Bbox_3 Box;

  void classify_vertices()
  {
    std::vector<bool> is_on_feature(m_mesh.num_vertices(), false), is_seen(m_mesh.num_vertices(), false);
    for(std::size_t k = 0; k < m_curves.curves.size(); ++k)
      for(const Halfedge h : m_curves.curves[k])
        for(const Vertex v : { m_mesh.source(h), m_mesh.target(h) })
        {
          if(!is_on_feature[v] && m_curves.node[v] < 0)
            m_vertices_of_curve[k].push_back(v);
          is_on_feature[v] = true;
        }
    for(const Face f : m_mesh.faces())
      for(const Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
        if(!is_on_feature[v] && !is_seen[v])
        {
          m_vertices_of_patch[m_quads.patch[f]].push_back(v);
          is_seen[v] = true;
        }
  }

  // With a sign: positive if the patch is on the left of the curve.
  void collect_curves_around_patches()
  {
    for(std::size_t k = 0; k < m_curves.curves.size(); ++k)
    {
      const Halfedge h = m_curves.curves[k].front();
      const int tag = static_cast<int>(k) + 1;
      if(!m_mesh.is_border(h))
        m_curves_around[m_quads.patch[m_mesh.face(h)]].push_back(tag);
      const Halfedge twin = m_mesh.opposite(h);
      const bool is_inside = !m_mesh.is_border(h) && !m_mesh.is_border(twin)
                             && m_quads.patch[m_mesh.face(h)] == m_quads.patch[m_mesh.face(twin)];
      if(!m_mesh.is_border(twin) && !is_inside)
        m_curves_around[m_quads.patch[m_mesh.face(twin)]].push_back(-tag);
    }
  }

  void write_physical_names() const
  {
    m_out << "$PhysicalNames\n" << m_curves.curves.size() + m_number_of_patches << "\n";
    for(std::size_t k = 0; k < m_curves.curves.size(); ++k)
      m_out << "1 " << k + 1 << " \"curve_" << k << "\"\n";
    for(std::size_t k = 0; k < m_number_of_patches; ++k)
      m_out << "2 " << k + 1 << " \"patch_" << k << "\"\n";
    m_out << "$EndPhysicalNames\n";
  }

  void write_box(const Box& box) const
  {
    m_out << box.xmin() << " " << box.ymin() << " " << box.zmin() << " " << box.xmax() << " " << box.ymax() << " "
          << box.zmax();
  }

  void write_curve_entity(const std::size_t k) const
  {
    Box box;
    for(const Halfedge h : m_curves.curves[k])
      box += m_mesh.point(m_mesh.source(h)).bbox() + m_mesh.point(m_mesh.target(h)).bbox();
    const int first = m_curves.node[m_mesh.source(m_curves.curves[k].front())];
    const int last = m_curves.node[m_mesh.target(m_curves.curves[k].back())];
    m_out << k + 1 << " ";
    write_box(box);
    m_out << " 1 " << k + 1;
    if(first < 0)
      m_out << " 0\n";
    else
      m_out << " 2 " << first + 1 << " " << -(last + 1) << "\n";
  }

  void write_surface_entity(const std::size_t k) const
  {
    Box box;
    for(const Face f : m_faces[k])
      for(const Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
        box += m_mesh.point(v).bbox();
    m_out << k + 1 << " ";
    write_box(m_faces[k].empty() ? Box(0, 0, 0, 0, 0, 0) : box);
    m_out << " 1 " << k + 1 << " " << m_curves_around[k].size();
    for(const int tag : m_curves_around[k])
      m_out << " " << tag;
    m_out << "\n";
  }

  void write_entities() const
  {
    m_out << "$Entities\n" << m_curves.nodes.size() << " " << m_curves.curves.size() << " " << m_number_of_patches
          << " 0\n";
    for(std::size_t k = 0; k < m_curves.nodes.size(); ++k)
      m_out << k + 1 << " " << m_mesh.point(m_curves.nodes[k]) << " 0\n";
    for(std::size_t k = 0; k < m_curves.curves.size(); ++k)
      write_curve_entity(k);
    for(std::size_t k = 0; k < m_number_of_patches; ++k)
      write_surface_entity(k);
    m_out << "$EndEntities\n";
  }

  void write_node_block(const int dimension, const std::size_t k, const std::vector<Vertex>& vertices) const
  {
    m_out << dimension << " " << k + 1 << " 0 " << vertices.size() << "\n";
    for(const Vertex v : vertices)
      m_out << v.idx() + 1 << "\n";
    for(const Vertex v : vertices)
      m_out << m_mesh.point(v) << "\n";
  }

  void write_nodes() const
  {
    std::size_t number = m_curves.nodes.size();
    for(const auto* const lists : { &m_vertices_of_curve, &m_vertices_of_patch })
      for(const std::vector<Vertex>& vertices : *lists)
        number += vertices.size();
    m_out << "$Nodes\n" << m_curves.nodes.size() + m_curves.curves.size() + m_number_of_patches << " " << number
          << " 1 " << m_mesh.num_vertices() << "\n";
    for(std::size_t k = 0; k < m_curves.nodes.size(); ++k)
      write_node_block(0, k, { m_curves.nodes[k] });
    for(std::size_t k = 0; k < m_vertices_of_curve.size(); ++k)
      write_node_block(1, k, m_vertices_of_curve[k]);
    for(std::size_t k = 0; k < m_vertices_of_patch.size(); ++k)
      write_node_block(2, k, m_vertices_of_patch[k]);
    m_out << "$EndNodes\n";
  }

  void write_elements() const
  {
    const int line_type = 1, quad_type = 3;
    std::size_t number_of_lines = 0, tag = 0;
    for(const std::vector<Halfedge>& curve : m_curves.curves)
      number_of_lines += curve.size();
    const std::size_t number = number_of_lines + m_mesh.number_of_faces();
    m_out << "$Elements\n" << m_curves.curves.size() + m_number_of_patches << " " << number << " 1 " << number << "\n";
    for(std::size_t k = 0; k < m_curves.curves.size(); ++k)
    {
      m_out << "1 " << k + 1 << " " << line_type << " " << m_curves.curves[k].size() << "\n";
      for(const Halfedge h : m_curves.curves[k])
        m_out << ++tag << " " << m_mesh.source(h).idx() + 1 << " " << m_mesh.target(h).idx() + 1 << "\n";
    }
    for(std::size_t k = 0; k < m_number_of_patches; ++k)
    {
      m_out << "2 " << k + 1 << " " << quad_type << " " << m_faces[k].size() << "\n";
      for(const Face f : m_faces[k])
      {
        m_out << ++tag;
        for(const Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
          m_out << " " << v.idx() + 1;
        m_out << "\n";
      }
    }
    m_out << "$EndElements\n";
  }

  std::ostream& m_out;
  const Quads& m_quads;
  const Mesh& m_mesh;
  const Feature_curves m_curves;
  std::size_t m_number_of_patches = 0;
  std::vector<std::vector<Face> > m_faces;          // by patch
  std::vector<std::vector<int> > m_curves_around;   // by patch: signed tags
  std::vector<std::vector<Vertex> > m_vertices_of_curve, m_vertices_of_patch; // inside
};

// Writes Gmsh 4.1 as text.
inline void write_msh(std::ostream& out, const Quads& quads)
{
  Msh_writer(out, quads).write();
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_MSH_H
