#ifndef FRAME_FIELDS_PROGRAMS_FAILURE_H
#define FRAME_FIELDS_PROGRAMS_FAILURE_H

#include <stdexcept>
#include <string>

enum Exit_code
{
  DONE = 0,
  BAD_USAGE = 1,
  BAD_FILE = 2,
  NOT_SOLVED = 3
};

// Ends the program with a message that says which file, which element and what to do.
struct Failure : std::runtime_error
{
  Failure(const Exit_code exit_code, const std::string& message)
    : std::runtime_error(message), exit_code(exit_code)
  {}

  Exit_code exit_code;
};

#endif // FRAME_FIELDS_PROGRAMS_FAILURE_H
