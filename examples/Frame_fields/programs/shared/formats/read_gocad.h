#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_READ_GOCAD_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_READ_GOCAD_H

#include "File_content.h"
#include "Left_out.h"
#include "Raw_soup.h"
#include "Text_cursor.h"
#include "lower_case.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reads the triangles of GOCAD TSurf objects, each from a line `GOCAD` to `END`. Vertices have any numbers, which are
// those of their object.
class Gocad_reader
{
public:
  explicit Gocad_reader(const File_content& file) : m_file(&file), m_cursor(file, begin_of_text(file),
                                                                            Text_cursor::COMMENTS)
  {}

  Raw_soup read()
  {
    while(m_cursor.has_word())
    {
      const std::string_view word = m_cursor.word();
      read_line(lower_case(word), word);
    }
    if(m_state != OUTSIDE)
      m_cursor.fail_here("the file ends without 'END', so that triangles may be missing");
    m_left_out.warn(m_soup.warnings);
    return std::move(m_soup);
  }

private:
  enum State { OUTSIDE, IN_HEADER, IN_BODY }; // the body starts with the first TFACE

  struct Vertex_name
  {
    long long name;
    std::size_t vertex;
  };

  struct Corner
  {
    long long name;
    const char* place; // in the file
  };

  struct Atom
  {
    long long name;
    Corner original;
  };

  void read_line(const std::string& keyword, const std::string_view word)
  {
    if(keyword == "gocad" && m_state == OUTSIDE)
      start_object();
    else if(m_state == OUTSIDE)
      m_cursor.fail(Text_cursor::name_of(word) + " stands where 'GOCAD' is expected");
    else if(keyword == "tface")
      end_line_with_state(IN_BODY);
    else if(keyword == "end")
      end_object();
    else if(keyword == "vrtx" || keyword == "pvrtx" || keyword == "atom" || keyword == "patom" || keyword == "trgl")
      read_element(keyword);
    else
      leave_out_line(keyword, word);
  }

  void start_object()
  {
    const std::string kind = lower_case(m_cursor.next_word_in_line("a kind of object"));
    if(kind != "tsurf")
      m_cursor.fail("this object is no TSurf");
    end_line_with_state(IN_HEADER);
  }

  void end_line_with_state(const State state)
  {
    m_state = state;
    m_cursor.skip_line();
  }

  void leave_out_line(const std::string& keyword, const std::string_view word)
  {
    static constexpr std::string_view of_borders[] = { "bstone", "border" };
    if(keyword == "gocad")
      m_cursor.fail("a second object starts before the 'END' of the first one");
    const bool is_of_border = std::find(std::begin(of_borders), std::end(of_borders), keyword) != std::end(of_borders);
    if(m_state == IN_BODY && !is_of_border)
    {
      if(!may_be_keyword(word))
        m_cursor.fail("the line does not start with a keyword");
      m_left_out.add(word);
    }
    m_cursor.skip_line();
  }

  void read_element(const std::string& keyword)
  {
    if(m_state != IN_BODY)
      m_cursor.fail("this line stands before the first 'TFACE'");
    if(keyword == "trgl")
    {
      for(int k = 0; k < 3; ++k)
        m_corners.push_back(next_name());
      if(m_cursor.has_word_in_line())
        m_cursor.fail_here("a triangle has more than three vertices");
      return;
    }
    const long long name = next_name().name;
    if(keyword == "atom" || keyword == "patom") // another name of a vertex
      m_atoms.push_back({ name, next_name() });
    else
    {
      m_names.push_back({ name, m_soup.points.size() });
      Coordinates point;
      for(double& coordinate : point)
        coordinate = m_cursor.real(m_cursor.next_word_in_line("a coordinate"));
      m_soup.points.push_back(point);
    }
    m_cursor.skip_line(); // properties
  }

  Corner next_name()
  {
    const std::string_view word = m_cursor.next_word_in_line("the number of a vertex");
    return { m_cursor.integer(word, "the number of a vertex"), word.data() };
  }

  void sort_names()
  {
    const auto is_less = [](const Vertex_name& a, const Vertex_name& b) { return a.name < b.name; };
    if(!std::is_sorted(m_names.begin(), m_names.end(), is_less)) // it mostly is
      std::sort(m_names.begin(), m_names.end(), is_less);
    const auto twice = std::adjacent_find(m_names.begin(), m_names.end(),
                                          [](const Vertex_name& a, const Vertex_name& b) { return a.name == b.name; });
    if(twice != m_names.end())
      m_cursor.fail("the object that ends here has two vertices " + std::to_string(twice->name));
  }

  std::size_t vertex_of(const Corner& corner) const
  {
    const auto found = std::lower_bound(m_names.begin(), m_names.end(), corner.name,
                                        [](const Vertex_name& a, const long long name) { return a.name < name; });
    if(found == m_names.end() || found->name != corner.name)
      m_file->fail_at_line(corner.place, "there is no vertex " + std::to_string(corner.name) + " in this object");
    return found->vertex;
  }

  void end_object()
  {
    sort_names();
    std::vector<Vertex_name> names_of_atoms;
    for(const Atom& atom : m_atoms)
      names_of_atoms.push_back({ atom.name, vertex_of(atom.original) });
    m_names.insert(m_names.end(), names_of_atoms.begin(), names_of_atoms.end());
    sort_names();
    for(std::size_t k = 0; k < m_corners.size(); ++k)
    {
      m_soup.corners.push_back(vertex_of(m_corners[k]));
      if(k % 3 == 2)
        m_soup.end_polygon();
    }
    m_names.clear();
    m_atoms.clear();
    m_corners.clear();
    end_line_with_state(OUTSIDE);
  }

  const File_content* m_file;
  Text_cursor m_cursor;
  Raw_soup m_soup;
  Left_out m_left_out{ "lines" };
  State m_state = OUTSIDE;
  std::vector<Vertex_name> m_names; // of the object
  std::vector<Atom> m_atoms;
  std::vector<Corner> m_corners; // of the triangles of the object
};

inline Raw_soup read_gocad(const File_content& file) { return Gocad_reader(file).read(); }

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_READ_GOCAD_H
