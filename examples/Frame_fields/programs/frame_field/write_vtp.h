#ifndef FRAME_FIELDS_PROGRAMS_WRITE_VTP_H
#define FRAME_FIELDS_PROGRAMS_WRITE_VTP_H

#include "Field.h"
#include "streamlines.h"

#include "../shared/Appended_arrays.h"
#include "../shared/Mesh.h"
#include "../shared/sectors.h"
#include "../shared/vtp_file.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <set>
#include <string>
#include <vector>

// What the file shows. VTK numbers cells with the vertices first, then the lines, then the polygons, and every cell has
// all attributes, so each kind adds its values, or zeros, in this order.
struct Vtp_content
{
  std::vector<double> points;
  Vtp_cells verts, lines, polys;
  std::vector<double> u, v, alpha, rho;
  std::vector<std::int32_t> index, sharp_corner, interior;
  std::vector<std::int32_t> streamline; // 1 or 2 on streamlines: the branch pair

  void add_attributes(const std::size_t number_of_cells)
  {
    const std::size_t number = index.size() + number_of_cells;
    u.resize(3 * number, 0);
    v.resize(3 * number, 0);
    for(std::vector<double>* const attribute : { &alpha, &rho })
      attribute->resize(number, 0);
    for(std::vector<std::int32_t>* const attribute : { &index, &sharp_corner, &interior, &streamline })
      attribute->resize(number, 0);
  }
};

inline void add_singular_sectors(const std::vector<Sector>& sectors, const Mesh& mesh, const Field& field,
                                 Vtp_content& content)
{
  const std::set<Halfedge> sharp_corners(field.sharp_corners.begin(), field.sharp_corners.end());
  for(const Sector& sector : sectors)
  {
    const bool is_sharp = sharp_corners.count(sector.halfedge);
    if(field.index[sector.halfedge] == 0 && !is_sharp)
      continue;
    content.verts.vertices.push_back(mesh.target(sector.halfedge).idx());
    content.verts.end_cell();
    content.add_attributes(1);
    content.index.back() = field.index[sector.halfedge];
    content.sharp_corner.back() = is_sharp;
    content.interior.back() = !sector.is_constrained;
  }
}

inline void add_features(const Mesh& mesh, const Feature_map is_feature, Vtp_content& content)
{
  for(const Edge e : mesh.edges())
    if(is_feature[e])
    {
      for(const int end : { 0, 1 })
        content.lines.vertices.push_back(mesh.vertex(e, end).idx());
      content.lines.end_cell();
    }
  content.add_attributes(content.lines.number());
}

inline void add_faces(const Mesh& mesh, const Field& field, Vtp_content& content)
{
  std::size_t cell = content.index.size();
  content.add_attributes(mesh.number_of_faces());
  for(const Face f : mesh.faces())
  {
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      content.polys.vertices.push_back(v.idx());
    content.polys.end_cell();
    const auto vectors = CGAL::Frame_fields::frame_vectors(mesh, f, field.alpha[f], field.rho[f]);
    for(const int coordinate : { 0, 1, 2 })
    {
      content.u[3 * cell + coordinate] = vectors[0][coordinate];
      content.v[3 * cell + coordinate] = vectors[1][coordinate];
    }
    content.alpha[cell] = field.alpha[f];
    content.rho[cell] = field.rho[f];
    ++cell;
  }
}

inline void add_streamlines(const std::vector<Streamline>& streamlines, Vtp_content& content)
{
  for(const Streamline& streamline : streamlines)
  {
    for(const Point& p : streamline.points)
    {
      content.lines.vertices.push_back(static_cast<std::int64_t>(content.points.size() / 3));
      for(const int coordinate : { 0, 1, 2 })
        content.points.push_back(p[coordinate]);
    }
    content.lines.end_cell();
    content.add_attributes(1);
    content.streamline.back() = 1 + streamline.branch_pair;
  }
}

inline Vtp_content vtp_content(const Mesh& mesh, const Feature_map is_feature, const std::vector<Sector>& sectors,
                               const Field& field, const std::vector<Streamline>& streamlines)
{
  Vtp_content content;
  for(const Vertex v : mesh.vertices())
    for(const int coordinate : { 0, 1, 2 })
      content.points.push_back(mesh.point(v)[coordinate]);
  add_singular_sectors(sectors, mesh, field, content);
  add_features(mesh, is_feature, content);
  add_streamlines(streamlines, content);
  add_faces(mesh, field, content);
  return content;
}

inline void write_vtp(std::ostream& out, const Vtp_content& content)
{
  write_vtp_file(out, content.points, content.verts, content.lines, content.polys,
                 [&](std::ostream& cell_data, Appended_arrays& arrays)
  {
    cell_data << "<CellData>\n"
              << arrays.add("u", content.u, 3) << arrays.add("v", content.v, 3)
              << arrays.add("alpha", content.alpha) << arrays.add("rho", content.rho)
              << arrays.add("index", content.index)
              << arrays.add("sharp_corner", content.sharp_corner)
              << arrays.add("interior", content.interior)
              << arrays.add("streamline", content.streamline)
              << "</CellData>\n";
  });
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_VTP_H
