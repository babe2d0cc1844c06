#ifndef FRAME_FIELDS_PROGRAMS_READ_CURVES_OF_ABC_H
#define FRAME_FIELDS_PROGRAMS_READ_CURVES_OF_ABC_H

#include "read_feature_lines.h"

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <cstddef>
#include <string>
#include <vector>

// Reads the sharp curves of the feature files of the ABC data set. These are YAML as PyYAML writes it: the list
// `curves` of mappings with the keys `sharp` and `vert_indices`, whose vertices are in brackets or on a line each. The
// other keys and lists are passed over.
class Abc_curve_reader
{
public:
  explicit Abc_curve_reader(const std::string& path) : m_path(path) {}

  std::vector<Vertex_pair> read()
  {
    for_each_feature_line(m_path, [&](const std::size_t line_number, const std::string& content)
                          { read_line(line_number, content); });
    if(m_is_in_brackets)
      fail_in_line(m_path, m_curve_line, "the list has no end");
    end_curve();
    if(!m_has_curves)
      fail_in_line(m_path, 1, "there is no list 'curves' in it");
    return m_pairs;
  }

private:
  static std::string trimmed(const std::string& text)
  {
    const char* const blanks = " \t\r";
    const std::size_t begin = text.find_first_not_of(blanks);
    return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
  }

  void read_line(const std::size_t line_number, const std::string& content)
  {
    const std::size_t indentation = content.find_first_not_of(' ');
    std::string text = trimmed(content);
    if(m_is_in_brackets)
      return read_list(line_number, text);
    const bool is_item = text == "-" || text.compare(0, 2, "- ") == 0;
    if(indentation == 0 && !is_item)
    {
      end_curve();
      m_is_in_curves = text.compare(0, 7, "curves:") == 0;
      m_has_curves = m_has_curves || m_is_in_curves;
      m_item_indentation = std::string::npos;
      return;
    }
    if(!m_is_in_curves)
      return;
    if(is_item && m_item_indentation == std::string::npos)
      m_item_indentation = indentation;
    if(!is_item)
      return read_key(line_number, text);
    text = trimmed(text.substr(1));
    if(indentation != m_item_indentation)
    {
      if(m_is_listing_vertices)
        add_vertex(line_number, text);
      return;
    }
    end_curve();
    if(!text.empty())
      read_key(line_number, text);
  }

  void read_key(const std::size_t line_number, const std::string& text)
  {
    const std::size_t colon = text.find(':');
    const std::string key = text.substr(0, colon);
    const std::string value = colon == std::string::npos ? "" : trimmed(text.substr(colon + 1));
    m_is_listing_vertices = key == "vert_indices";
    if(key == "sharp")
      m_is_sharp = value == "true" || value == "True" || value == "yes";
    if(m_is_listing_vertices)
      m_curve_line = line_number;
    if(!value.empty() && value[0] == '[')
      read_list(line_number, value);
  }

  // A part of a list in brackets, which may run over several lines.
  void read_list(const std::size_t line_number, const std::string& text)
  {
    std::string word;
    for(const char c : text)
    {
      if(c != '[' && c != ']' && c != ',' && c != ' ' && c != '\t')
      {
        word += c;
        continue;
      }
      end_word(line_number, word);
      m_is_in_brackets = c == '[' || (m_is_in_brackets && c != ']');
    }
    end_word(line_number, word);
  }

  void end_word(const std::size_t line_number, std::string& word)
  {
    if(!word.empty() && m_is_listing_vertices)
      add_vertex(line_number, word);
    word.clear();
  }

  void add_vertex(const std::size_t line_number, const std::string& word)
  {
    long long vertex;
    if(!boost::conversion::try_lexical_convert(word, vertex))
      fail_in_line(m_path, line_number, "'" + word + "' is no vertex index");
    m_vertices.push_back(vertex);
  }

  void end_curve()
  {
    for(std::size_t k = 1; m_is_sharp && k < m_vertices.size(); ++k)
      m_pairs.push_back({ m_vertices[k - 1], m_vertices[k], m_curve_line });
    m_vertices.clear();
    m_is_sharp = false;
    m_is_listing_vertices = false;
  }

  std::string m_path;
  std::vector<Vertex_pair> m_pairs;
  std::vector<long long> m_vertices; // of the curve
  std::size_t m_curve_line = 0, m_item_indentation = std::string::npos;
  bool m_has_curves = false, m_is_in_curves = false, m_is_sharp = false;
  bool m_is_listing_vertices = false, m_is_in_brackets = false;
};

inline std::vector<Vertex_pair> read_curves_of_abc(const std::string& path)
{
  return Abc_curve_reader(path).read();
}

#endif // FRAME_FIELDS_PROGRAMS_READ_CURVES_OF_ABC_H
