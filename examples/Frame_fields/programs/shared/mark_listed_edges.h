#ifndef FRAME_FIELDS_PROGRAMS_MARK_LISTED_EDGES_H
#define FRAME_FIELDS_PROGRAMS_MARK_LISTED_EDGES_H

#include "Console.h"
#include "Failure.h"
#include "Mesh.h"
#include "Model.h"
#include "feature_formats.h"
#include "read_feature_lines.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// The edges of a mesh by the parts that they join; a repair may have made several of one of the file.
class Edges_of_parts
{
public:
  explicit Edges_of_parts(const Model& model) : m_model(&model)
  {
    for(const Edge e : model.mesh.edges())
      m_edges.push_back({ std::minmax(model.part_in_mesh[model.mesh.vertex(e, 0)],
                                      model.part_in_mesh[model.mesh.vertex(e, 1)]), e });
    std::sort(m_edges.begin(), m_edges.end());
  }

  long long number_of_file_vertices() const { return static_cast<long long>(m_model->part_in_file.size()); }

  // Whether there is a vertex in the file whose number is this one and a small shift.
  bool is_vertex(const long long vertex, const long long shift) const
  {
    return vertex >= -shift && vertex < number_of_file_vertices() - shift;
  }

  // Calls `visit(edge)` for each edge that a pair names if the shift is added; tells whether there is one.
  template <typename Visit>
  bool for_each_edge(const Vertex_pair& pair, const long long shift, const Visit& visit) const
  {
    if(!is_vertex(pair.first, shift) || !is_vertex(pair.second, shift))
      return false;
    const Parts parts = std::minmax(m_model->part_in_file[pair.first + shift],
                                    m_model->part_in_file[pair.second + shift]);
    auto found = std::lower_bound(m_edges.begin(), m_edges.end(), Parts_and_edge(parts, Edge(0)));
    const bool is_edge = found != m_edges.end() && found->first == parts;
    for(; found != m_edges.end() && found->first == parts; ++found)
      visit(found->second);
    return is_edge;
  }

private:
  typedef std::pair<std::size_t, std::size_t> Parts;
  typedef std::pair<Parts, Edge> Parts_and_edge;

  const Model* m_model;
  std::vector<Parts_and_edge> m_edges;
};

// Marks the edges that a feature file lists. It may count vertices from 1 instead of 0, which its edges tell; the files
// of ABC do either, or count from -1.
class Listed_edge_marker
{
public:
  Listed_edge_marker(const std::string& path, const std::vector<Vertex_pair>& pairs, const Model& model)
    : m_path(path), m_is_of_abc(feature_format_of(path) == ABC_CURVES), m_pairs(pairs), m_edges(model)
  {}

  void mark(Feature_map is_feature, Console& console) const
  {
    const long long shift = m_is_of_abc ? best_shift() : 0;
    if(shift != 0)
      console.warn(m_path + ": it counts vertices from " + std::to_string(-shift) + " and not from 0");
    const std::size_t number_of_found = number_with(shift);
    if(number_of_found < m_pairs.size())
      tell_missing(shift, number_of_found, console);
    for(const Vertex_pair& pair : m_pairs)
      m_edges.for_each_edge(pair, shift, [&](const Edge e) { is_feature[e] = true; });
  }

private:
  bool is_edge(const Vertex_pair& pair, const long long shift) const
  {
    return m_edges.for_each_edge(pair, shift, [](Edge) {});
  }

  std::size_t number_with(const long long shift) const
  {
    return std::count_if(m_pairs.begin(), m_pairs.end(), [&](const Vertex_pair& pair) { return is_edge(pair, shift); });
  }

  long long best_shift() const
  {
    long long best = 0;
    std::size_t largest_number = number_with(0);
    for(const long long shift : { -1, 1 })
      if(largest_number < m_pairs.size() && number_with(shift) > largest_number)
      {
        best = shift;
        largest_number = number_with(shift);
      }
    return best;
  }

  void tell_missing(const long long shift, const std::size_t number_of_found, Console& console) const
  {
    const std::size_t number = m_pairs.size(), number_of_missing = number - number_of_found;
    const char* const lines = m_is_of_abc ? " edges of sharp curves are " : " lines name ";
    const std::string count = std::to_string(number_of_found) + " of " + std::to_string(number) + lines;
    if(!m_is_of_abc)
    {
      if(number_with(-1) == number)
        throw Failure(BAD_FILE, m_path + ": " + count + "edges of the model; counted from 1, all of them do; subtract "
                                + "1 from each vertex, as vertices count from 0");
      check_range();
    }
    const std::size_t maximum_share = 10; // one of so many
    if(maximum_share * number_of_missing > number)
      throw Failure(BAD_FILE, m_path + ": " + count + "edges of the model; the file seems to belong to another one");
    const auto first_missing = std::find_if(m_pairs.begin(), m_pairs.end(),
                                            [&](const Vertex_pair& pair) { return !is_edge(pair, shift); });
    console.warn(m_path + ": " + (m_is_of_abc ? "edges of sharp curves that are" : "lines that name")
                 + " no edge of the model: " + std::to_string(number_of_missing) + ", the first is "
                 + (m_is_of_abc ? "in line " : "line ") + std::to_string(first_missing->line_number) + ", '"
                 + std::to_string(first_missing->first) + " " + std::to_string(first_missing->second) + "'");
  }

  void check_range() const
  {
    for(const Vertex_pair& pair : m_pairs)
      for(const long long vertex : { pair.first, pair.second })
        if(!m_edges.is_vertex(vertex, 0))
          fail_in_line(m_path, pair.line_number,
                       "the model has no vertex " + std::to_string(vertex) + ", its last one is "
                         + std::to_string(m_edges.number_of_file_vertices() - 1));
  }

  const std::string& m_path;
  bool m_is_of_abc;
  const std::vector<Vertex_pair>& m_pairs;
  Edges_of_parts m_edges;
};

#endif // FRAME_FIELDS_PROGRAMS_MARK_LISTED_EDGES_H
