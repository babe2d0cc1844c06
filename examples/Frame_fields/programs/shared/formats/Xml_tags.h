#ifndef FRAME_FIELDS_PROGRAMS_FORMATS_XML_TAGS_H
#define FRAME_FIELDS_PROGRAMS_FORMATS_XML_TAGS_H

#include "File_content.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct Xml_tag
{
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view> > attributes;
  bool is_end = false;   // </name>
  bool is_empty = false; // <name/>
  const char* begin = nullptr;
  const char* end = nullptr;

  // The value of an attribute, or nothing.
  std::string_view operator[](const std::string_view attribute) const
  {
    for(const auto& [key, value] : attributes)
      if(key == attribute)
        return value;
    return {};
  }
};

// Goes through the tags of an XML text, and knows no more of XML than files of numbers need.
class Xml_tags
{
public:
  explicit Xml_tags(const File_content& file) : m_file(&file), m_at(begin_of_text(file)) {}

  // Tells whether there is another tag.
  bool next(Xml_tag& tag)
  {
    for(;;)
    {
      m_at = std::find(m_at, m_file->end(), '<');
      if(m_at == m_file->end())
        return false;
      m_tag = m_at;
      if(starts_with(rest(), "<!--"))
        skip_to("-->");
      else if(starts_with(rest(), "<?"))
        skip_to("?>");
      else
        break;
    }
    tag = Xml_tag();
    tag.begin = m_at++;
    tag.is_end = take('/');
    tag.name = name();
    for(;;)
    {
      skip_spaces();
      tag.is_empty = take('/');
      if(take('>'))
        break;
      const std::string_view key = name();
      skip_spaces();
      if(!take('='))
        fail();
      skip_spaces();
      tag.attributes.emplace_back(key, value());
    }
    tag.end = m_at;
    return true;
  }

private:
  std::string_view rest() const
  {
    return m_file->bytes.substr(static_cast<std::size_t>(m_at - m_file->begin()));
  }

  [[noreturn]] void fail() const { m_file->fail_at_line(m_tag, "a tag of XML is not complete"); }

  bool take(const char c)
  {
    const bool is_there = m_at != m_file->end() && *m_at == c;
    m_at += is_there ? 1 : 0;
    return is_there;
  }

  void skip_spaces()
  {
    while(m_at != m_file->end() && is_space(*m_at))
      ++m_at;
  }

  void skip_to(const std::string_view end)
  {
    const std::size_t found = rest().find(end);
    if(found == std::string_view::npos)
      fail();
    m_at += found + end.size();
  }

  std::string_view name()
  {
    static constexpr std::string_view ends = "<>/='\"";
    const char* const begin = m_at;
    while(m_at != m_file->end() && !is_space(*m_at) && ends.find(*m_at) == std::string_view::npos)
      ++m_at;
    if(m_at == begin)
      fail();
    return { begin, static_cast<std::size_t>(m_at - begin) };
  }

  std::string_view value()
  {
    const char quote = take('"') ? '"' : take('\'') ? '\'' : '\0';
    const char* const begin = m_at;
    m_at = std::find(m_at, m_file->end(), quote);
    if(quote == '\0' || m_at == m_file->end())
      fail();
    return { begin, static_cast<std::size_t>(m_at++ - begin) };
  }

  const File_content* m_file;
  const char* m_at;
  const char* m_tag = nullptr; // where the last one starts
};

#endif // FRAME_FIELDS_PROGRAMS_FORMATS_XML_TAGS_H
