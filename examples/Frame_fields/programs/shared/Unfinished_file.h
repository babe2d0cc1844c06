#ifndef FRAME_FIELDS_PROGRAMS_UNFINISHED_FILE_H
#define FRAME_FIELDS_PROGRAMS_UNFINISHED_FILE_H

#include "Failure.h"

#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <system_error>

// The name of the file that is being written, for a signal handler, which must neither lock nor allocate.
inline const char* volatile name_of_unfinished_file = nullptr;

// A file that is removed unless it gets its final name, even if a signal ends the program.
class Unfinished_file
{
public:
  explicit Unfinished_file(const std::filesystem::path& target)
    : m_target(target), m_path(target.string() + "." + std::to_string(getpid()) + ".part")
  {
    name_of_unfinished_file = m_path.c_str();
  }

  Unfinished_file(const Unfinished_file&) = delete;

  ~Unfinished_file()
  {
    std::error_code error;
    std::filesystem::remove(m_path, error);
    name_of_unfinished_file = nullptr;
  }

  const std::string& path() const { return m_path; }

  void finish(const std::string& name_for_user) const
  {
    std::error_code error;
    std::filesystem::rename(m_path, m_target, error);
    if(error)
      throw Failure(BAD_FILE, name_for_user + ": cannot be written: " + error.message());
  }

private:
  std::filesystem::path m_target;
  std::string m_path;
};

extern "C" inline void remove_unfinished_file(const int signal)
{
  if(name_of_unfinished_file != nullptr)
    unlink(name_of_unfinished_file);
  std::raise(signal); // its default action takes place when this handler returns
}

// Lets the signals that ask a program to end do so without leaving an unfinished file. Those that are ignored, as in a
// job that must outlive its terminal, stay so.
inline void remove_unfinished_file_at_signals()
{
  for(const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    struct sigaction action;
    sigaction(signal, nullptr, &action);
    if(action.sa_handler == SIG_IGN)
      continue;
    action = {};
    action.sa_handler = remove_unfinished_file;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(signal, &action, nullptr);
  }
}

#endif // FRAME_FIELDS_PROGRAMS_UNFINISHED_FILE_H
