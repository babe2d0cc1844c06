#ifndef FRAME_FIELDS_PROGRAMS_WRITE_FILE_H
#define FRAME_FIELDS_PROGRAMS_WRITE_FILE_H

#include "Failure.h"
#include "Unfinished_file.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

inline bool is_device_or_pipe(const std::string& path)
{
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
}

// The file that a path stands for, through symbolic links, even if there is no such file yet.
inline std::filesystem::path final_target(std::filesystem::path path)
{
  namespace fs = std::filesystem;
  const int maximum_number_of_links = 40; // as Linux has it
  std::error_code error;
  for(int k = 0; k < maximum_number_of_links && fs::is_symlink(path, error); ++k)
    path = path.parent_path() / fs::read_symlink(path, error);
  return path;
}

// Finds before a long computation that its result could not be written.
inline void check_output_path(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::absolute(final_target(path), error).parent_path();
  if(fs::is_directory(path, error))
    throw Failure(BAD_FILE, path + ": this is a folder; give the name of a file");
  if(!fs::is_directory(folder, error))
    throw Failure(BAD_FILE, path + ": there is no folder " + folder.string());
  if(!is_device_or_pipe(path) && access(folder.c_str(), W_OK) != 0)
    throw Failure(BAD_FILE, path + ": no permission to write to the folder " + folder.string());
}

template <typename Write>
void write_directly(const std::string& path, const std::string& name, const Write& write)
{
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  write(out);
  out.close();
  if(!out)
    throw Failure(BAD_FILE, name + ": cannot be written"
                            + (errno == 0 ? "" : ": " + std::generic_category().message(errno)));
}

// Writes a file wholly or not at all: a new file beside it takes its name when it is complete. Nothing can take the
// name of a device or a pipe, these are written directly. `write` gets a binary output stream.
template <typename Write>
void write_file(const std::string& path, const Write& write)
{
  if(is_device_or_pipe(path))
    return write_directly(path, path, write);
  const Unfinished_file unfinished(final_target(path)); // a symbolic link keeps pointing to the file
  write_directly(unfinished.path(), path, write);
  unfinished.finish(path);
}

#endif // FRAME_FIELDS_PROGRAMS_WRITE_FILE_H
