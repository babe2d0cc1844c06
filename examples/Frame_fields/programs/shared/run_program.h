#ifndef FRAME_FIELDS_PROGRAMS_RUN_PROGRAM_H
#define FRAME_FIELDS_PROGRAMS_RUN_PROGRAM_H

#include "Command_line.h"
#include "Failure.h"
#include "Thread_limit.h"
#include "Unfinished_file.h"
#include "program_name.h"
#include "write_file.h"

#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <string>

inline void check_standard_output()
{
  std::cout.flush();
  if(!std::cout)
    throw Failure(BAD_FILE, "the standard output cannot be written");
}

inline int fail(const Exit_code exit_code, const char* const message)
{
  std::cerr << program_name << ": error: " << message << std::endl;
  return exit_code;
}

template <typename Program>
void compute(const typename Program::Options& options)
{
  remove_unfinished_file_at_signals();
  const Thread_limit thread_limit(options.number_of_threads);
  for(const std::string& path : outputs_of(options))
    check_output_path(path);
  const auto summary = Program::run(options);
  if(!options.is_quiet)
    Program::print_table(summary, options);
}

// The main function of a program: a class with the type `Options` and the static functions `option_descriptions()`,
// `print_help(out)`, `options_from(variables)`, `run(options)`, which returns a summary, and
// `print_table(summary, options)`.
template <typename Program>
int run_program(const int argc, char** const argv)
try
{
  const std::optional<typename Program::Options> options = read_command_line<Program>(argc, argv);
  if(options)
    compute<Program>(*options);
  check_standard_output();
  return DONE;
}
catch(const Failure& failure)
{
  return fail(failure.exit_code, failure.what());
}
catch(const std::bad_alloc&)
{
  return fail(NOT_SOLVED, "the memory is exhausted; take a coarser mesh or a larger machine");
}
catch(const std::exception& error)
{
  return fail(NOT_SOLVED, error.what());
}

#endif // FRAME_FIELDS_PROGRAMS_RUN_PROGRAM_H
