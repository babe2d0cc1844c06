#ifndef FRAME_FIELDS_PROGRAMS_CONSOLE_H
#define FRAME_FIELDS_PROGRAMS_CONSOLE_H

#include "program_name.h"

#include <CGAL/Frame_fields/Statistics.h>

#include <unistd.h>

#include <iostream>
#include <string>
#include <vector>

// What the user reads on stderr: warnings, and on a terminal one line that tells what is being done.
class Console
{
public:
  explicit Console(const bool is_quiet) : m_shows_progress(!is_quiet && isatty(STDERR_FILENO)) {}
  Console(const Console&) = delete;
  ~Console() { erase_progress(); }

  void show_progress(const std::string& activity)
  {
    erase_progress();
    if(m_shows_progress)
      std::cerr << activity << " ..." << std::flush;
  }

  void warn(const std::string& warning)
  {
    erase_progress();
    std::cerr << program_name << ": warning: " << warning << std::endl;
    m_warnings.push_back(warning);
  }

  const std::vector<std::string>& warnings() const { return m_warnings; }

private:
  void erase_progress()
  {
    if(m_shows_progress)
      std::cerr << "\r\033[K" << std::flush;
  }

  bool m_shows_progress;
  std::vector<std::string> m_warnings;
};

// Shows the stages of the library on a console.
struct Stage_visitor : CGAL::Frame_fields::Default_frame_field_visitor
{
  explicit Stage_visitor(Console& console) : console(&console) {}

  void start_stage(const CGAL::Frame_fields::Stage stage) { console->show_progress(activity(stage)); }

  static const char* activity(const CGAL::Frame_fields::Stage stage)
  {
    switch(stage)
    {
      case CGAL::Frame_fields::Stage::CUT_SURFACE:          return "cutting the surface along its features";
      case CGAL::Frame_fields::Stage::PRESCRIBED_ROTATION:  return "prescribing rotation at sharp corners";
      case CGAL::Frame_fields::Stage::ORTHOGONAL_FIELD:     return "solving for the orthogonal field";
      case CGAL::Frame_fields::Stage::MATCHING_AND_INDICES: return "matching branches";
      case CGAL::Frame_fields::Stage::RELAXATION:           return "relaxing orthogonality";
    }
    return "";
  }

  Console* console;
};

#endif // FRAME_FIELDS_PROGRAMS_CONSOLE_H
