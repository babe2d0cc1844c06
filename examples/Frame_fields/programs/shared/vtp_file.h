#ifndef FRAME_FIELDS_PROGRAMS_VTP_FILE_H
#define FRAME_FIELDS_PROGRAMS_VTP_FILE_H

#include "Appended_arrays.h"

#include <boost/predef/other/endian.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

// Cells of one kind: the vertices of each, one cell after the other, and where they end.
struct Vtp_cells
{
  std::vector<std::int64_t> vertices, ends;

  std::size_t number() const { return ends.size(); }
  void end_cell() { ends.push_back(static_cast<std::int64_t>(vertices.size())); }
};

inline std::string cells_element(const std::string& kind, const Vtp_cells& cells, Appended_arrays& arrays)
{
  return "<" + kind + ">\n" + arrays.add("connectivity", cells.vertices) + arrays.add("offsets", cells.ends)
         + "</" + kind + ">\n";
}

// Writes VTK XML PolyData with appended raw data. `write_attributes(out, arrays)` writes the elements of the attributes
// of cells and points, whose arrays it adds.
template <typename WriteAttributes>
void write_vtp_file(std::ostream& out, const std::vector<double>& points, const Vtp_cells& verts,
                    const Vtp_cells& lines, const Vtp_cells& polys, const WriteAttributes& write_attributes)
{
  Appended_arrays arrays;
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\""
      << (BOOST_ENDIAN_BIG_BYTE ? "BigEndian" : "LittleEndian") << "\" header_type=\"UInt64\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << points.size() / 3 << "\" NumberOfVerts=\"" << verts.number()
      << "\" NumberOfLines=\"" << lines.number() << "\" NumberOfStrips=\"0\" NumberOfPolys=\""
      << polys.number() << "\">\n"
      << "<Points>\n" << arrays.add("points", points, 3) << "</Points>\n"
      << cells_element("Verts", verts, arrays)
      << cells_element("Lines", lines, arrays)
      << cells_element("Polys", polys, arrays);
  write_attributes(out, arrays);
  out << "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  out.write(arrays.data().data(), static_cast<std::streamsize>(arrays.data().size()));
  out << "\n</AppendedData>\n</VTKFile>\n";
}

#endif // FRAME_FIELDS_PROGRAMS_VTP_FILE_H
