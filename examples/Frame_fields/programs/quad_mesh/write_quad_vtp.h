#ifndef FRAME_FIELDS_PROGRAMS_WRITE_QUAD_VTP_H
#define FRAME_FIELDS_PROGRAMS_WRITE_QUAD_VTP_H

#include "Feature_curves.h"
#include "Quads.h"
#include "irregular_vertices.h"
#include "scaled_jacobian.h"

#include "../shared/Appended_arrays.h"
#include "../shared/Mesh.h"
#include "../shared/vtp_file.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <vector>

// What VTK shows of quadrangles. Every cell has all attributes, in the order vertices, lines, polygons; what a cell has
// not is -1, or not a number.
struct Quad_vtp_content
{
  std::vector<double> points;
  Vtp_cells verts, lines, polys;
  std::vector<std::int32_t> valence, on_feature, curve, patch, block;
  std::vector<double> scaled_jacobian;

  void add_cell()
  {
    for(std::vector<std::int32_t>* const attribute : { &valence, &on_feature, &curve, &patch, &block })
      attribute->push_back(-1);
    scaled_jacobian.push_back((std::numeric_limits<double>::quiet_NaN)());
  }
};

inline void add_irregular_vertices(const Quads& quads, Quad_vtp_content& content)
{
  for(const Irregular_vertex& irregular : irregular_vertices(quads.mesh, quads.is_feature))
  {
    content.verts.vertices.push_back(irregular.vertex.idx());
    content.verts.end_cell();
    content.add_cell();
    content.valence.back() = irregular.valence;
    content.on_feature.back() = irregular.is_on_feature;
  }
}

inline void add_feature_edges(const Mesh& mesh, const Feature_curves& curves, Quad_vtp_content& content)
{
  for(std::size_t k = 0; k < curves.curves.size(); ++k)
    for(const Halfedge h : curves.curves[k])
    {
      content.lines.vertices.push_back(mesh.source(h).idx());
      content.lines.vertices.push_back(mesh.target(h).idx());
      content.lines.end_cell();
      content.add_cell();
      content.curve.back() = static_cast<std::int32_t>(k);
    }
}

inline void add_quads(const Quads& quads, Quad_vtp_content& content)
{
  for(const Face f : quads.mesh.faces())
  {
    for(const Vertex v : quads.mesh.vertices_around_face(quads.mesh.halfedge(f)))
      content.polys.vertices.push_back(v.idx());
    content.polys.end_cell();
    content.add_cell();
    content.patch.back() = quads.patch[f];
    if(quads.block)
      content.block.back() = (*quads.block)[f];
    content.scaled_jacobian.back() = scaled_jacobian(quads.mesh, f);
  }
}

inline void write_quad_vtp(std::ostream& out, const Quads& quads)
{
  Quad_vtp_content content;
  for(const Vertex v : quads.mesh.vertices())
    for(const int coordinate : { 0, 1, 2 })
      content.points.push_back(quads.mesh.point(v)[coordinate]);
  add_irregular_vertices(quads, content);
  add_feature_edges(quads.mesh, feature_curves(quads.mesh, quads.is_feature), content);
  add_quads(quads, content);
  write_vtp_file(out, content.points, content.verts, content.lines, content.polys,
                 [&](std::ostream& cell_data, Appended_arrays& arrays)
  {
    cell_data << "<CellData>\n"
              << arrays.add("valence", content.valence) << arrays.add("on_feature", content.on_feature)
              << arrays.add("curve", content.curve) << arrays.add("patch", content.patch)
              << arrays.add("scaled_jacobian", content.scaled_jacobian);
    if(quads.block)
      cell_data << arrays.add("block", content.block);
    cell_data << "</CellData>\n";
  });
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_QUAD_VTP_H
